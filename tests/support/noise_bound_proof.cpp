// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/noise_bound_proof.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isoscope::test {

namespace {

/// Coefficients of 1, t, t^2, t^3, t^4.
using Polynomial = std::array<double, 5>;

Polynomial derivative(const Polynomial& p) {
    Polynomial d{};
    for (std::size_t i = 1; i < p.size(); ++i) d[i - 1] = static_cast<double>(i) * p[i];
    return d;
}

double evaluate(const Polynomial& p, double t) {
    double value = 0;
    for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
    return value;
}

/// Along one axis, for side a of the cell: the weight w_a(t) (kind 0) or w_a(t)*(t - a) (kind 1), and its
/// derivatives.
Polynomial factor(int side, int kind, int order) {
    Polynomial p = side == 0 ? Polynomial{1, 0, -3, 2, 0} : Polynomial{0, 0, 3, -2, 0};
    if (kind == 1) {
        Polynomial times{};
        for (std::size_t i = 0; i < 4; ++i) times[i + 1] = p[i];
        for (std::size_t i = 0; i < 5; ++i) times[i] -= side * p[i];
        p = times;
    }
    for (int k = 0; k < order; ++k) p = derivative(p);
    return p;
}

constexpr double deepest = 1.0 / 4096;

}  // namespace

/// All numbers within `radius` of `middle`.
struct NoiseBoundProof::Centered {
    double middle = 0, radius = 0;

    /// The values of a polynomial on [t - h, t + h], from its expansion about t.
    static Centered range(Polynomial p, double t, double h) {
        Centered result{evaluate(p, t), 0};
        double power = 1;
        for (int k = 1; k < 5; ++k) {
            p = derivative(p);
            power *= h / k;
            result.radius += std::abs(evaluate(p, t)) * power;
        }
        return result;
    }

    friend Centered operator*(const Centered& a, const Centered& b) {
        return {a.middle * b.middle,
                std::abs(a.middle) * b.radius + std::abs(b.middle) * a.radius + a.radius * b.radius};
    }
};

struct NoiseBoundProof::Box {
    Vector middle{0.5, 0.5, 0.5};
    Vector half{0.5, 0.5, 0.5};
};

struct NoiseBoundProof::Corner {
    std::array<Centered, 4> p;
};

NoiseBoundProof::NoiseBoundProof(std::vector<std::array<double, 4>> choices) : choices_(std::move(choices)) {}

NoiseBoundProof NoiseBoundProof::ofUnitSlopes() {
    NoiseBoundProof proof({});
    proof.unitSlopes_ = true;
    return proof;
}

bool NoiseBoundProof::holds(int order, const Vector& direction, int sign, double bound) {
    constexpr std::array<int, mostOrder + 1> factorial{1, 1, 2, 6};
    std::vector<Term> terms;
    for (int i = 0; i <= order; ++i)
        for (int j = 0; i + j <= order; ++j) {
            const int k = order - i - j;
            const int count = factorial[order] / (factorial[i] * factorial[j] * factorial[k]);
            const double share =
                std::pow(direction[0], i) * std::pow(direction[1], j) * std::pow(direction[2], k);
            terms.push_back({sign * count * share, {i, j, k}});
        }
    return holds(std::move(terms), bound);
}

bool NoiseBoundProof::holdsForAxes(int i, int j, int sign, double bound) {
    Term term{static_cast<double>(sign), {}};
    ++term.orders[i];
    ++term.orders[j];
    return holds({term}, bound);
}

bool NoiseBoundProof::holds(std::vector<Term> derivative, double bound) {
    derivative_ = std::move(derivative);
    bound_ = bound;
    Candidates all;
    for (auto& candidates : all) {
        candidates.resize(choices_.size());
        std::iota(candidates.begin(), candidates.end(), static_cast<unsigned short>(0));
    }
    Box cell;
    if (inPlane_) cell.middle[1] = cell.half[1] = 0;
    return holdsInside(cell, all);
}

bool NoiseBoundProof::holdsInPlane(double bound) {
    constexpr int directions = 90;
    // Every direction is within pi / 180 of one of them, and shows at least the cosine of twice that.
    const double loss = std::cos(M_PI / directions);
    inPlane_ = true;
    bool all = true;
    for (int k = 0; k < directions && all; ++k)
        for (const int sign : {-1, 1}) {
            const double angle = M_PI * k / directions;
            all = all && holds(2, {std::cos(angle), 0, std::sin(angle)}, sign, bound * loss);
        }
    inPlane_ = false;
    return all;
}

/// The coefficients p_c with the derivatives applied that are asked for. factors[axis][2*side + kind][order].
NoiseBoundProof::Corner NoiseBoundProof::cornerVector(
    int corner, const std::array<std::array<Derivatives, 4>, 3>& factors) const {
    Corner result;
    for (int component = 0; component < 4; ++component) {
        Centered& sum = result.p[component];
        for (const Term& term : derivative_) {
            if (term.share == 0) continue;
            Centered value{1, 0};
            for (int axis = 0; axis < 3; ++axis) {
                const int side = corner >> axis & 1, kind = component == axis + 1;
                value = value * factors[axis][2 * side + kind][term.orders[axis]];
            }
            sum.middle += term.share * value.middle;
            sum.radius += std::abs(term.share) * value.radius;
        }
    }
    return result;
}

/// The largest p . w in the box; `certain` is reached in its middle. Choices that are the largest nowhere in
/// the box are not kept.
double NoiseBoundProof::largest(const Corner& corner, const std::vector<unsigned short>& candidates,
                                std::vector<unsigned short>& kept, double& certain) const {
    const auto& p = corner.p;
    if (unitSlopes_) {
        certain = std::hypot(p[1].middle, p[2].middle, p[3].middle);
        return certain + std::hypot(p[1].radius, p[2].radius, p[3].radius);
    }
    std::array<double, 256> highs;
    double high = -1e300, low = -1e300;
    certain = -1e300;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const auto& w = choices_[candidates[i]];
        double value = 0, radius = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            value += p[k].middle * w[k];
            radius += p[k].radius * std::abs(w[k]);
        }
        highs[i] = value + radius;
        high = std::max(high, highs[i]);
        low = std::max(low, value - radius);
        certain = std::max(certain, value);
    }
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (highs[i] >= low) kept.push_back(candidates[i]);
    return high;
}

bool NoiseBoundProof::holdsInside(const Box& box, const Candidates& candidates) {
    ++boxCount_;
    std::array<std::array<Derivatives, 4>, 3> factors;
    for (int axis = 0; axis < 3; ++axis)
        for (int which = 0; which < 4; ++which)
            for (int order = 0; order <= mostOrder; ++order) {
                static const auto table = [] {
                    std::array<std::array<Polynomial, mostOrder + 1>, 4> all;
                    for (int i = 0; i < 4; ++i)
                        for (int k = 0; k <= mostOrder; ++k) all[i][k] = factor(i / 2, i % 2, k);
                    return all;
                }();
                factors[axis][which][order] =
                    Centered::range(table[which][order], box.middle[axis], box.half[axis]);
            }
    Candidates kept;
    double high = 0, reached = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double certain = 0;
        high += largest(cornerVector(corner, factors), candidates[corner], kept[corner], certain);
        reached += certain;
    }
    if (high <= bound_) return true;
    if (reached > bound_) return false;
    const auto longest = std::max_element(box.half.begin(), box.half.end()) - box.half.begin();
    if (box.half[longest] < deepest) return false;
    for (const int side : {-1, 1}) {
        Box part = box;
        part.half[longest] /= 2;
        part.middle[longest] += side * part.half[longest];
        if (!holdsInside(part, kept)) return false;
    }
    return true;
}

/// The directions through a square of the cube's face, half the sphere in three faces. A derivative of order
/// n is a form of degree n in the direction, along a great circle a trigonometric polynomial of that degree:
/// at an angle from where it is largest it has at least cos(n angle) of that left (M. Riesz), for n angle up
/// to pi.
bool NoiseBoundProof::holdsInPatch(int order, int face, double a, double b, double halfSize, double bound) {
    const auto toward = [&](double s, double t) {
        Vector v{};
        v[face] = 1, v[(face + 1) % 3] = s, v[(face + 2) % 3] = t;
        const double size = std::sqrt(1 + s * s + t * t);
        for (double& component : v) component /= size;
        return v;
    };
    const Vector middle = toward(a, b);
    double cosine = 1;
    for (const int i : {-1, 1})
        for (const int j : {-1, 1}) {
            const Vector corner = toward(a + i * halfSize, b + j * halfSize);
            cosine = std::min(cosine, std::inner_product(corner.begin(), corner.end(), middle.begin(), 0.0));
        }
    const double share = std::cos(order * std::acos(cosine));
    if (share > 0.8 && holds(order, middle, 1, bound * share) && holds(order, middle, -1, bound * share))
        return true;
    if (halfSize < 0.03) return false;
    for (const int i : {-1, 1})
        for (const int j : {-1, 1})
            if (!holdsInPatch(order, face, a + i * halfSize / 2, b + j * halfSize / 2, halfSize / 2, bound))
                return false;
    return true;
}

bool NoiseBoundProof::holdsForAllDirections(int order, double bound, int stride) {
    // Patches so small that little is lost to the angle: narrow passes cost far more than many directions.
    const int patches = 4 * order;
    const double halfSize = 1.0 / patches;
    for (int patch = 0; patch < 3 * patches * patches; patch += stride) {
        const int face = patch % 3, i = patch / 3 % patches, j = patch / 3 / patches;
        const double a = (2 * i + 1) * halfSize - 1, b = (2 * j + 1) * halfSize - 1;
        if (!holdsInPatch(order, face, a, b, halfSize, bound)) return false;
    }
    return true;
}

}  // namespace isoscope::test
