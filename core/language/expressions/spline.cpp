// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/spline.h"

#include <algorithm>
#include <limits>

namespace isoscope {

namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

}  // namespace

Spline::Spline(SplineType type, std::vector<Point> points, int components)
    : type_(type), components_(components) {
    std::stable_sort(points.begin(), points.end(),
                     [](const Point& a, const Point& b) { return a.place < b.place; });
    for (const Point& point : points) {
        if (!points_.empty() && points_.back().place == point.place) points_.pop_back();
        points_.push_back(point);
    }
    if (points_.size() == 1)
        addConstant(everywhere, points_[0].value);
    else if (type == SplineType::quadratic && points_.size() > 2)
        makeQuadratic();
    else if (type == SplineType::cubic)
        makeCubic();
    else if (type == SplineType::natural)
        makeNatural();
    else
        makeLinear();
}

double Spline::slope(std::size_t i, std::size_t component) const {
    return (points_[i + 1].value[component] - points_[i].value[component]) / gap(i);
}

void Spline::addConstant(double end, const Vector& value) {
    Piece piece;
    piece.end = end;
    piece.coefficients[0] = value;
    pieces_.push_back(piece);
}

void Spline::makeLinear() {
    addConstant(points_.front().place, points_.front().value);
    for (std::size_t j = 0; j + 1 < points_.size(); ++j) {
        Piece piece{points_[j + 1].place, points_[j].place, {}};
        piece.coefficients[0] = points_[j].value;
        for (std::size_t c = 0; c < 5; ++c) piece.coefficients[1][c] = slope(j, c);
        pieces_.push_back(piece);
    }
    addConstant(everywhere, points_.back().value);
}

void Spline::makeQuadratic() {
    addConstant(points_.front().place, points_.front().value);
    for (std::size_t j = 0; j + 1 < points_.size(); ++j) {
        // The parabola through three points, from the second to the third; the first one serves twice.
        const std::size_t a = j == 0 ? 0 : j - 1;
        Piece piece{points_[j + 1].place, points_[a].place, {}};
        piece.coefficients[0] = points_[a].value;
        for (std::size_t c = 0; c < 5; ++c) {
            const double bend = (slope(a + 1, c) - slope(a, c)) / (points_[a + 2].place - points_[a].place);
            piece.coefficients[1][c] = slope(a, c) - gap(a) * bend;
            piece.coefficients[2][c] = bend;
        }
        pieces_.push_back(piece);
    }
    addConstant(everywhere, points_.back().value);
}

void Spline::makeCubic() {
    const std::size_t count = points_.size();
    if (count == 2) {
        Vector average{};
        for (std::size_t c = 0; c < 5; ++c) average[c] = (points_[0].value[c] + points_[1].value[c]) / 2;
        return addConstant(everywhere, average);
    }
    addConstant(points_[1].place, points_[1].value);
    for (std::size_t j = 1; j + 2 < count; ++j) {
        Piece piece{points_[j + 1].place, points_[j].place, {}};
        piece.coefficients[0] = points_[j].value;
        const double h = gap(j);
        for (std::size_t c = 0; c < 5; ++c) {
            const double from = (slope(j - 1, c) + slope(j, c)) / 2, to = (slope(j, c) + slope(j + 1, c)) / 2;
            piece.coefficients[1][c] = from;
            piece.coefficients[2][c] = (3 * slope(j, c) - 2 * from - to) / h;
            piece.coefficients[3][c] = (from + to - 2 * slope(j, c)) / (h * h);
        }
        pieces_.push_back(piece);
    }
    addConstant(everywhere, points_[count - 2].value);
}

std::vector<double> Spline::bends(std::size_t component) const {
    const std::size_t count = points_.size();
    std::vector<double> bend(count, 0), diagonal(count, 1), right(count, 0);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double before = i == 1 ? 0 : gap(i - 1) / diagonal[i - 1];
        diagonal[i] = 2 * (gap(i - 1) + gap(i)) - before * gap(i - 1);
        right[i] = 6 * (slope(i, component) - slope(i - 1, component)) - before * right[i - 1];
    }
    for (std::size_t i = count - 1; i-- > 1;) bend[i] = (right[i] - gap(i) * bend[i + 1]) / diagonal[i];
    return bend;
}

void Spline::makeNatural() {
    addConstant(points_.front().place, points_.front().value);
    for (std::size_t j = 0; j + 1 < points_.size(); ++j) {
        Piece piece{points_[j + 1].place, points_[j].place, {}};
        piece.coefficients[0] = points_[j].value;
        pieces_.push_back(piece);
    }
    for (std::size_t c = 0; c < 5; ++c) {
        const std::vector<double> bend = bends(c);
        for (std::size_t j = 0; j + 1 < points_.size(); ++j) {
            Piece& piece = pieces_[j + 1];
            piece.coefficients[1][c] = slope(j, c) - gap(j) / 6 * (bend[j + 1] + 2 * bend[j]);
            piece.coefficients[2][c] = bend[j] / 2;
            piece.coefficients[3][c] = (bend[j + 1] - bend[j]) / (6 * gap(j));
        }
    }
    addConstant(everywhere, points_.back().value);
}

Spline::Vector Spline::at(double place) const {
    const auto found = std::lower_bound(pieces_.begin(), pieces_.end(), place,
                                        [](const Piece& piece, double at) { return piece.end < at; });
    const Piece& piece = found == pieces_.end() ? pieces_.back() : *found;
    const double d = place - piece.origin;
    Vector result{};
    for (std::size_t c = 0; c < 5; ++c)
        for (std::size_t k = 4; k-- > 0;) result[c] = result[c] * d + piece.coefficients[k][c];
    return result;
}

std::vector<NodeId> Spline::build(FunctionGraph& graph, NodeId place) const {
    std::vector<NodeId> results;
    for (int c = 0; c < components_; ++c)
        results.push_back(build(graph, place, static_cast<std::size_t>(c), 0, pieces_.size() - 1));
    return results;
}

NodeId Spline::build(FunctionGraph& graph, NodeId place, std::size_t component, std::size_t first,
                     std::size_t last) const {
    if (first == last) {
        const Piece& piece = pieces_[first];
        std::size_t k = 3;
        while (k > 0 && piece.coefficients[k][component] == 0) --k;
        NodeId result = graph.constant(piece.coefficients[k][component]);
        if (k == 0) return result;
        const NodeId d = graph.binary(Operation::subtract, place, graph.constant(piece.origin));
        while (k-- > 0)
            result = graph.binary(Operation::add, graph.binary(Operation::multiply, result, d),
                                  graph.constant(piece.coefficients[k][component]));
        return result;
    }
    const std::size_t middle = first + (last - first) / 2;
    const NodeId low = build(graph, place, component, first, middle);
    const NodeId high = build(graph, place, component, middle + 1, last);
    const NodeId beyond = graph.binary(Operation::subtract, place, graph.constant(pieces_[middle].end));
    return graph.quaternary(Operation::select4, beyond, low, low, high);
}

}  // namespace isoscope
