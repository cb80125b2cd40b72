// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/real_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/roots/polynomial/bernstein_isolation.h"
#include "core/roots/polynomial/polynomial_roots.h"

namespace isoscope {

namespace {

using Coefficients = BernsteinIsolation::Coefficients;

constexpr double roundOff = std::numeric_limits<double>::epsilon() / 2;
/// Roots that rounding blurs by more than this share of their size are left to the wide arithmetic.
constexpr double blurLimit = 1e-11;

thread_local std::size_t fallbacks = 0;

/// a b - c d with one rounding (Kahan).
double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    const double rest = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + rest;
}

/// Constant first, with a last coefficient that is not 0.
struct Polynomial {
    Coefficients c{};
    int degree = 0;

    double operator[](int k) const { return c[static_cast<std::size_t>(k)]; }
    double& operator[](int k) { return c[static_cast<std::size_t>(k)]; }
};

/// Of a t^2 + b t + c.
void addQuadraticRoots(double a, double b, double c, double low, double high, RootSequence& roots) {
    const auto offer = [&](double t) {
        if (t >= low && t <= high) roots.add(t);
    };
    const double half = b / 2;
    // The exact way is dearer; most lines miss by far.
    const double square = half * half, product = a * c;
    if (square - product < -4 * roundOff * (square + std::abs(product))) return;
    const double discriminant = differenceOfProducts(half, half, a, c);
    if (!(discriminant >= 0)) return;
    const double q = -(half + std::copysign(std::sqrt(discriminant), half));
    offer(q / a);
    if (q != 0) offer(c / q);
    roots.sort();
}

/// Tracing has no other coefficients; the wide arithmetic scales them.
bool ordinary(double largest) { return largest > 1e-60 && largest < 1e60; }

/// One root in a bracket: Newton's steps while they stay inside, halving otherwise.
class Refinement {
  public:
    explicit Refinement(const Polynomial& polynomial) : p_(polynomial) {}

    /// False when rounding blurs the root too much.
    bool refine(double low, double high, bool rises, double& root) {
        double t = low + (high - low) / 2;
        constexpr int stepLimit = 80;
        for (int step = 0; step < stepLimit; ++step) {
            evaluate(t);
            // Nothing can be learned below the rounding of the value itself.
            if (std::abs(value_) <= noise_) break;
            ((value_ < 0) == rises ? low : high) = t;
            double next = t - value_ / slope_;
            if (!(next > low && next < high)) next = low + (high - low) / 2;
            // The first steps of Newton's method may be slow: every third halves.
            if (step % 3 == 2 && std::abs(next - t) > (high - low) / 4) next = low + (high - low) / 2;
            if (std::abs(next - t) <= roundOff * std::abs(next) || next == t || !(low < high)) {
                t = next;
                break;
            }
            t = next;
        }
        root = t;
        evaluate(t);
        return noise_ <= blurLimit * std::abs(slope_) * std::max(std::abs(t), high - low);
    }

  private:
    void evaluate(double t) {
        double value = p_[p_.degree], slope = 0, magnitude = std::abs(value);
        const double size = std::abs(t);
        for (int k = p_.degree - 1; k >= 0; --k) {
            slope = slope * t + value;
            value = value * t + p_[k];
            magnitude = magnitude * size + std::abs(p_[k]);
        }
        value_ = value;
        slope_ = slope;
        noise_ = 2 * (p_.degree + 1) * roundOff * magnitude;
    }

    const Polynomial& p_;
    double value_ = 0, slope_ = 0, noise_ = 0;
};

/// The roots of p in [low, high], 0 <= low; false when in doubt.
bool addPositive(const Polynomial& p, double low, double high, RootSequence& roots) {
    if (!(low < high)) return true;
    // q(u) = p(low + w u) by repeated synthetic division.
    Coefficients q = p.c;
    const double width = high - low;
    for (int round = 0; round < p.degree; ++round)
        for (int k = p.degree - 1; k >= round; --k)
            q[static_cast<std::size_t>(k)] += low * q[static_cast<std::size_t>(k + 1)];
    double power = 1, magnitude = 0, reach = 1;
    for (int k = 0; k <= p.degree; ++k) {
        q[static_cast<std::size_t>(k)] *= power;
        power *= width;
        magnitude += std::abs(p[k]) * reach;
        reach *= high;
    }
    static thread_local std::vector<UnitBracket> brackets;
    if (!BernsteinIsolation(q, p.degree, magnitude).isolate(brackets)) return false;
    Refinement refinement(p);
    for (const UnitBracket& bracket : brackets) {
        double root = 0;
        if (!refinement.refine(low + bracket.low * width, low + bracket.high * width, bracket.risesThrough,
                               root))
            return false;
        roots.add(root);
    }
    return true;
}

/// A power of two about which the roots scatter: where the lowest and the highest term have the same size.
double balance(const Polynomial& p) {
    int lowest = 0;
    while (p[lowest] == 0) ++lowest;
    if (lowest == p.degree) return 1;
    const double ratio = std::log2(std::abs(p[lowest])) - std::log2(std::abs(p[p.degree]));
    return std::exp2(std::round(ratio / (p.degree - lowest)));
}

/// The same for any 0 <= low; far roots are found as near ones of the reversed polynomial.
bool addScaled(const Polynomial& p, double low, double high, RootSequence& roots) {
    if (!(low < high)) return true;
    const double scale = balance(p);
    if (!(scale > 1e-100 && scale < 1e100)) return false;
    if (!addPositive(p, low, std::min(high, scale), roots)) return false;
    const double from = std::max(low, scale);
    if (!(from < high)) return true;
    Polynomial reversed;
    reversed.degree = p.degree;
    double power = 1;
    for (int k = 0; k <= p.degree; ++k) {
        reversed[p.degree - k] = p[k] * power;
        power *= scale;
    }
    while (reversed.degree > 0 && reversed[reversed.degree] == 0) --reversed.degree;
    RootSequence far;
    if (!addPositive(reversed, scale / high, scale / from, far)) return false;
    for (const double root : far) roots.add(scale / root);
    return true;
}

bool addAll(Polynomial p, double low, double high, RootSequence& roots) {
    if (p[0] == 0 && low <= 0 && high >= 0) return false;
    if (!addScaled(p, std::max(low, 0.0), high, roots)) return false;
    if (!(low < 0)) return true;
    for (int k = 1; k <= p.degree; k += 2) p[k] = -p[k];
    RootSequence mirrored;
    if (!addScaled(p, std::max(-high, 0.0), -low, mirrored)) return false;
    for (const double root : mirrored) roots.add(-root);
    return true;
}

}  // namespace

void RootSequence::sort() {
    if (count_ < 2) return;
    if (count_ == 2) {
        if (roots_[1] < roots_[0]) std::swap(roots_[0], roots_[1]);
        if (roots_[0] == roots_[1]) count_ = 1;
        return;
    }
    std::sort(roots_.begin(), roots_.begin() + static_cast<std::ptrdiff_t>(count_));
    const auto last = std::unique(roots_.begin(), roots_.begin() + static_cast<std::ptrdiff_t>(count_));
    count_ = static_cast<std::size_t>(last - roots_.begin());
}

void realRoots(std::span<const double> coefficients, double low, double high, RootSequence& roots) {
    roots.clear();
    if (!(low <= high) || !std::isfinite(low) || !std::isfinite(high)) return;
    while (!coefficients.empty() && coefficients.front() == 0) coefficients = coefficients.subspan(1);
    if (coefficients.size() < 2 || coefficients.size() > realRootsDegreeLimit + 1) return;
    double largest = 0;
    for (const double c : coefficients) {
        if (!std::isfinite(c)) return;
        largest = std::max(largest, std::abs(c));
    }
    if (ordinary(largest)) {
        if (coefficients.size() == 2) {
            const double root = -coefficients[1] / coefficients[0];
            if (root >= low && root <= high) roots.add(root);
            return;
        }
        if (coefficients.size() == 3)
            return addQuadraticRoots(coefficients[0], coefficients[1], coefficients[2], low, high, roots);
        Polynomial p;
        p.degree = static_cast<int>(coefficients.size()) - 1;
        std::reverse_copy(coefficients.begin(), coefficients.end(), p.c.begin());
        if (addAll(p, low, high, roots)) return roots.sort();
    }
    ++fallbacks;
    roots.clear();
    for (const double root :
         polynomialRoots(coefficients, low, high, PolynomialMethod::sturm, TouchingRoots::leftOut))
        roots.add(root);
}

std::size_t realRootsFallbacks() { return fallbacks; }

}  // namespace isoscope
