// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/nurbs_surface.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

std::string KnotVector::problem() const {
    if (order < 1 || order > orderLimit)
        return "The order is a whole number from 1 to " + std::to_string(orderLimit) + ".";
    if (points < order)
        return "There must be at least as many control points (" + std::to_string(points) +
               ") as the order (" + std::to_string(order) + ").";
    const auto wanted = static_cast<std::size_t>(points) + static_cast<std::size_t>(order);
    if (knots.size() != wanted)
        return std::to_string(points) + " control points of order " + std::to_string(order) + " need " +
               std::to_string(wanted) + " knots, but here are " + std::to_string(knots.size()) + ".";
    if (!std::all_of(knots.begin(), knots.end(), [](double knot) { return std::isfinite(knot); }))
        return "The knots are not all finite.";
    if (!std::is_sorted(knots.begin(), knots.end())) return "The knots must not decrease.";
    if (!(low() < high())) return "The knots leave no room between knot order and knot points + 1.";
    return {};
}

int KnotVector::spanAt(double t) const {
    const auto begin = knots.begin() + (order - 1), end = knots.begin() + points;
    // The last span that is not empty takes the upper end.
    auto span = std::upper_bound(begin, end, t) - 1;
    while (span > begin && *span == *(span + 1)) --span;
    return static_cast<int>(std::max(span, begin) - knots.begin());
}

std::vector<double> KnotVector::basisOfOrder(double t, int span, int wanted) const {
    std::vector<double> values{1};
    const auto knot = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
    for (int k = 2; k <= wanted; ++k) {
        // values[i] belongs to the basis function number span - k + 2 + i of order k - 1.
        std::vector<double> next(static_cast<std::size_t>(k), 0.0);
        for (int i = 0; i + 1 < k; ++i) {
            const int number = span - k + 2 + i;
            const double width = knot(number + k - 1) - knot(number);
            const double share = width > 0 ? (t - knot(number)) / width : 0;
            next[static_cast<std::size_t>(i)] += (1 - share) * values[static_cast<std::size_t>(i)];
            next[static_cast<std::size_t>(i) + 1] += share * values[static_cast<std::size_t>(i)];
        }
        values = std::move(next);
    }
    return values;
}

std::vector<double> KnotVector::basis(double t, int& first) const {
    const int span = spanAt(t);
    first = span - order + 1;
    return basisOfOrder(t, span, order);
}

std::vector<double> KnotVector::slopes(double t, int& first) const {
    const int span = spanAt(t);
    first = span - order + 1;
    std::vector<double> slopes(static_cast<std::size_t>(order), 0.0);
    if (order == 1) return slopes;
    const std::vector<double> lower = basisOfOrder(t, span, order - 1);
    for (int i = 0; i + 1 < order; ++i) {
        const int number = span - order + 2 + i;
        const double width =
            knots[static_cast<std::size_t>(number + order - 1)] - knots[static_cast<std::size_t>(number)];
        if (!(width > 0)) continue;
        const double slope = (order - 1) / width * lower[static_cast<std::size_t>(i)];
        slopes[static_cast<std::size_t>(i)] -= slope;
        slopes[static_cast<std::size_t>(i) + 1] += slope;
    }
    return slopes;
}

NurbsSurface::Place NurbsSurface::at(double uAt, double vAt) const {
    int firstU = 0, firstV = 0;
    const std::vector<double> a = u.basis(uAt, firstU), da = u.slopes(uAt, firstU);
    const std::vector<double> b = v.basis(vAt, firstV), db = v.slopes(vAt, firstV);
    glm::dvec4 sum(0), sumU(0), sumV(0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const glm::dvec4& p =
                points[(static_cast<std::size_t>(firstU) + i) * static_cast<std::size_t>(v.points) +
                       static_cast<std::size_t>(firstV) + j];
            const glm::dvec4 weighted(glm::dvec3(p) * p.w, p.w);
            sum += a[i] * b[j] * weighted;
            sumU += da[i] * b[j] * weighted;
            sumV += a[i] * db[j] * weighted;
        }
    Place place;
    place.point = glm::dvec3(sum) / sum.w;
    place.along = (glm::dvec3(sumU) - sumU.w * place.point) / sum.w;
    place.across = (glm::dvec3(sumV) - sumV.w * place.point) / sum.w;
    return place;
}

}  // namespace isoscope
