// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/poly.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

/// Points where the polynomial is smaller than this count as inside, as in POV-Ray: where surfaces coincide
/// in CSG it decides what shows.
constexpr double skin = 1e-4;

/// A polynomial of the distance along a ray, constant first.
class LinePolynomial {
  public:
    /// Times (a + b s), plus `other`.
    void fold(double a, double b, const LinePolynomial& other) {
        if (degree_ >= 0) {
            c_[index(degree_ + 1)] = b * c_[index(degree_)];
            for (int k = degree_; k > 0; --k) c_[index(k)] = a * c_[index(k)] + b * c_[index(k - 1)];
            c_[0] *= a;
            ++degree_;
        }
        for (; degree_ < other.degree_; ++degree_) c_[index(degree_ + 1)] = 0;
        for (int k = 0; k <= other.degree_; ++k) c_[index(k)] += other.c_[index(k)];
    }
    void fold(double a, double b, double constant) {
        LinePolynomial other;
        if (constant != 0) {
            other.degree_ = 0;
            other.c_[0] = constant;
        }
        fold(a, b, other);
    }
    /// Highest power first.
    std::span<const double> highestFirst() {
        std::reverse(c_.begin(), c_.begin() + degree_ + 1);
        return {c_.data(), index(degree_ + 1)};
    }

  private:
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }

    std::array<double, Poly::orderLimit + 2> c_;
    int degree_ = -1;
};

std::array<double, Poly::orderLimit + 1> powersOf(double a, int order) {
    std::array<double, Poly::orderLimit + 1> powers;
    powers[0] = 1;
    for (int k = 1; k <= order; ++k)
        powers[static_cast<std::size_t>(k)] = powers[static_cast<std::size_t>(k - 1)] * a;
    return powers;
}

}  // namespace

std::size_t Poly::termCount(int order) {
    const auto n = static_cast<std::size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
}

Poly::Poly(int order, std::vector<double> coefficients, RootChoice choice)
    : order_(order), choice_(choice), coefficients_(std::move(coefficients)) {
    std::size_t next = 0;
    for (int x = order; x >= 0; --x)
        for (int y = order - x; y >= 0; --y)
            for (int z = order - x - y; z >= 0; --z, ++next)
                if (coefficients_[next] != 0) terms_.push_back({coefficients_[next], x, y, z});
}

void Poly::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const CenteredRay line(ray, glm::dvec3(0));
    if (!line.usable) return;
    // Horner's scheme in three variables, each a line along the ray.
    const glm::dvec3& o = line.origin;
    const glm::dvec3& d = line.direction;
    LinePolynomial value;
    std::size_t next = 0;
    for (int x = order_; x >= 0; --x) {
        LinePolynomial plane;
        for (int y = order_ - x; y >= 0; --y) {
            LinePolynomial row;
            for (int z = order_ - x - y; z >= 0; --z) row.fold(o.z, d.z, coefficients_[next++]);
            plane.fold(o.y, d.y, row);
        }
        value.fold(o.x, d.x, plane);
    }
    // A ray that leaves the surface has a root at its beginning. Where that lay at the very end of what is
    // searched it would be hard to isolate: so from a little before it, or from half way to what counts.
    const double start = line.fromRay(interval.near);
    const double low =
        interval.near > 0 ? line.fromRay(interval.near / 2) : start - 1e-3 * std::max(1.0, std::abs(start));
    const double high = std::min(start + farthestDistance, line.fromRay(interval.far));
    RootSequence roots;
    chosenRoots(choice_, value.highestFirst(), low, high, roots);
    for (const double s : roots) {
        const double t = line.toRay(s);
        if (interval.near <= t && t <= interval.far)
            hits.push_back({t, ray.at(t), unitNormal(gradientAt(line.at(s)))});
    }
}

bool Poly::contains(const glm::dvec3& point, TraceContext&) const { return valueAt(point) < skin; }

double Poly::valueAt(const glm::dvec3& p) const {
    const auto x = powersOf(p.x, order_), y = powersOf(p.y, order_), z = powersOf(p.z, order_);
    double value = 0;
    for (const Term& term : terms_)
        value += term.coefficient * x[static_cast<std::size_t>(term.x)] *
                 y[static_cast<std::size_t>(term.y)] * z[static_cast<std::size_t>(term.z)];
    return value;
}

glm::dvec3 Poly::gradientAt(const glm::dvec3& p) const {
    const auto x = powersOf(p.x, order_), y = powersOf(p.y, order_), z = powersOf(p.z, order_);
    const auto slope = [](const auto& powers, int k) {
        return k == 0 ? 0 : k * powers[static_cast<std::size_t>(k - 1)];
    };
    glm::dvec3 gradient(0);
    for (const Term& term : terms_) {
        const double px = x[static_cast<std::size_t>(term.x)], py = y[static_cast<std::size_t>(term.y)],
                     pz = z[static_cast<std::size_t>(term.z)];
        gradient += term.coefficient * glm::dvec3(slope(x, term.x) * py * pz, px * slope(y, term.y) * pz,
                                                  px * py * slope(z, term.z));
    }
    return gradient;
}

}  // namespace isoscope
