// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/bernstein_isolation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

constexpr double roundOff = std::numeric_limits<double>::epsilon() / 2;
constexpr int depthLimit = 48;

}  // namespace

BernsteinIsolation::BernsteinIsolation(const Coefficients& power, int degree, double magnitude)
    : degree_(degree), error_(6 * (degree + 2) * roundOff * magnitude) {
    // b[i] = sum over j <= i of C(i, j) / C(n, j) a[j], by repeated sums of a[j] / C(n, j).
    double binomial = 1;
    for (int j = 0; j <= degree; ++j) {
        start_[static_cast<std::size_t>(j)] = power[static_cast<std::size_t>(j)] / binomial;
        binomial = binomial * (degree - j) / (j + 1);
    }
    for (int round = 1; round <= degree; ++round)
        for (int i = degree; i >= round; --i)
            start_[static_cast<std::size_t>(i)] += start_[static_cast<std::size_t>(i - 1)];
}

bool BernsteinIsolation::isolate(std::vector<UnitBracket>& brackets) {
    brackets.clear();
    if (!std::isfinite(error_)) return false;
    return search(start_, 0, 1, error_, 0, brackets);
}

BernsteinIsolation::Verdict BernsteinIsolation::judge(const Coefficients& b, double error) const {
    const auto sign = [&](int i) {
        const double value = b[static_cast<std::size_t>(i)];
        return value > error ? 1 : value < -error ? -1 : 0;
    };
    double largest = 0;
    for (int i = 0; i <= degree_; ++i) largest = std::max(largest, std::abs(b[static_cast<std::size_t>(i)]));
    if (!(largest > 16 * error)) return Verdict::doubtful;
    const int first = sign(0), last = sign(degree_);
    // The ends of the whole interval may be roots; inner ends are chosen clear of them.
    if (first == 0 || last == 0) return Verdict::doubtful;
    int changes = 0, unclear = 0, before = first;
    for (int i = 1; i <= degree_; ++i) {
        const int here = sign(i);
        if (here == 0) {
            ++unclear;
            continue;
        }
        // One unclear coefficient between opposite signs makes one change whatever it is.
        if (here != before) ++changes;
        if (unclear > (here != before ? 1 : 0)) return Verdict::split;
        unclear = 0;
        before = here;
    }
    return changes == 0 ? Verdict::none : changes == 1 ? Verdict::one : Verdict::split;
}

bool BernsteinIsolation::search(const Coefficients& b, double low, double width, double error, int depth,
                                std::vector<UnitBracket>& brackets) const {
    switch (judge(b, error)) {
        case Verdict::none: return true;
        case Verdict::one: brackets.push_back({low, low + width, b[0] < 0}); return true;
        case Verdict::doubtful: return false;
        case Verdict::split: break;
    }
    if (depth == depthLimit) return false;
    double largest = 0;
    for (int i = 0; i <= degree_; ++i) largest = std::max(largest, std::abs(b[static_cast<std::size_t>(i)]));
    const double grown = error + 2 * degree_ * roundOff * largest;
    Coefficients left, right;
    for (const double at : {0.5, 0.453125, 0.578125, 0.359375}) {
        split(b, at, left, right);
        if (!(std::abs(right[0]) > grown)) continue;
        return search(left, low, at * width, grown, depth + 1, brackets) &&
               search(right, low + at * width, (1 - at) * width, grown, depth + 1, brackets);
    }
    return false;
}

void BernsteinIsolation::split(const Coefficients& b, double at, Coefficients& left,
                               Coefficients& right) const {
    const auto size = static_cast<std::size_t>(degree_) + 1;
    std::copy_n(b.begin(), size, right.begin());
    for (std::size_t round = 0; round < size; ++round) {
        left[round] = right[0];
        for (std::size_t i = 0; i + 1 < size - round; ++i) right[i] = (1 - at) * right[i] + at * right[i + 1];
    }
    // `right` now holds the right half in place: entry i is b[i..n] at the last round.
}

}  // namespace isoscope
