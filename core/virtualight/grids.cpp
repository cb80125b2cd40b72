// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/grids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/evaluate/point_evaluator.h"

namespace isoscope::virtualight {

namespace {

using std::numbers::pi;

SurfaceGrid emptyGrid(int columns, int rows) {
    SurfaceGrid grid;
    grid.columns = columns;
    grid.rows = rows;
    grid.points.reserve(grid.number(0, rows + 1));
    return grid;
}

double share(int k, int of) { return static_cast<double>(k) / of; }

using Weights = std::array<double, 4>;

/// Row-wise as in the text: the weights of the four values for t are those of (t^3, t^2, t, 1) times this.
constexpr std::array<std::array<double, 16>, 4> bases{{
    {-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0},
    {-1. / 6, 3. / 6, -3. / 6, 1. / 6, 3. / 6, -1, 3. / 6, 0, -3. / 6, 0, 3. / 6, 0, 1. / 6, 4. / 6, 1. / 6,
     0},
    {-1. / 2, 3. / 2, -3. / 2, 1. / 2, 1, -5. / 2, 2, -1. / 2, -1. / 2, 0, 1. / 2, 0, 0, 1, 0, 0},
    {2, -2, 1, 1, -3, 3, -2, -1, 0, 0, 1, 0, 1, 0, 0, 0},
}};

Weights weighted(int basis, const Weights& powers) {
    const auto& matrix = bases[static_cast<std::size_t>(basis) - 1];
    Weights weights{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row) weights[column] += powers[row] * matrix[4 * row + column];
    return weights;
}
Weights weightsAt(int basis, double t) { return weighted(basis, {t * t * t, t * t, t, 1}); }
Weights slopesAt(int basis, double t) { return weighted(basis, {3 * t * t, 2 * t, 1, 0}); }

/// Rows of the points along u, columns along v.
glm::dvec3 blend(const std::array<glm::dvec3, 16>& points, const Weights& u, const Weights& v) {
    glm::dvec3 sum(0);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            sum += u[row] * v[column] * points[4 * row + column];
    return sum;
}

SurfaceGrid gridOfPatch(const BicubicShape& patch) {
    SurfaceGrid grid = emptyGrid(patch.vSteps, patch.uSteps);
    const auto normalAt = [&](double u, double v) {
        return glm::cross(blend(patch.points, weightsAt(patch.basis, u), slopesAt(patch.basis, v)),
                          blend(patch.points, slopesAt(patch.basis, u), weightsAt(patch.basis, v)));
    };
    for (int row = 0; row <= grid.rows; ++row)
        for (int column = 0; column <= grid.columns; ++column) {
            const double u = share(row, grid.rows), v = share(column, grid.columns);
            grid.points.push_back(blend(patch.points, weightsAt(patch.basis, u), weightsAt(patch.basis, v)));
            glm::dvec3 normal = normalAt(u, v);
            // Where an edge is drawn together to one point, the normal just beside it.
            if (!(glm::length(normal) > 1e-12))
                normal = normalAt(std::clamp(u, 1e-4, 1 - 1e-4), std::clamp(v, 1e-4, 1 - 1e-4));
            grid.normals.push_back(normal);
        }
    return grid;
}

SurfaceGrid gridOfNurbs(const NurbsSurface& surface, const std::array<int, 2>& steps,
                        const std::stop_token& stop) {
    SurfaceGrid grid = emptyGrid(steps[1], steps[0]);
    const auto within = [](const KnotVector& knots, double t) {
        return knots.low() + t * (knots.high() - knots.low());
    };
    for (int row = 0; row <= grid.rows && !stop.stop_requested(); ++row)
        for (int column = 0; column <= grid.columns; ++column) {
            const double u = share(row, grid.rows), v = share(column, grid.columns);
            NurbsSurface::Place place = surface.at(within(surface.u, u), within(surface.v, v));
            grid.points.push_back(place.point);
            glm::dvec3 normal = glm::cross(place.across, place.along);
            if (!(glm::length(normal) > 1e-12)) {
                place = surface.at(within(surface.u, std::clamp(u, 1e-4, 1 - 1e-4)),
                                   within(surface.v, std::clamp(v, 1e-4, 1 - 1e-4)));
                normal = glm::cross(place.across, place.along);
            }
            grid.normals.push_back(normal);
        }
    return grid;
}

/// Values of a function at many places; `arguments[k]` are those of its argument k. Not all of them after a
/// stop.
std::vector<double> valuesOf(const Function& function, const std::vector<std::vector<double>>& arguments,
                             const std::stop_token& stop) {
    constexpr std::size_t atOnce = 4096;
    std::vector<const double*> pointers(arguments.size());
    std::vector<double> results(arguments.front().size());
    PointEvaluator evaluator(Tape::compile(function), {});
    for (std::size_t first = 0; first < results.size() && !stop.stop_requested(); first += atOnce) {
        for (std::size_t k = 0; k < arguments.size(); ++k) pointers[k] = arguments[k].data() + first;
        const std::size_t count = std::min(atOnce, results.size() - first);
        evaluator.evaluate(pointers, count, std::span(results).subspan(first, count));
    }
    return results;
}

SurfaceGrid gridOfParametric(const ParametricShape& surface, const std::array<int, 2>& steps,
                             const std::array<double, 4>& domain, const std::stop_token& stop) {
    SurfaceGrid grid = emptyGrid(steps[0], steps[1]);
    // Each place, and four close to it for the derivatives; inwards at the ends, where they may stop to
    // exist.
    const double du = 1e-5 * (domain[1] - domain[0]), dv = 1e-5 * (domain[3] - domain[2]);
    std::vector<std::vector<double>> places(2);
    const auto clamped = [](double t, double low, double high) { return std::clamp(t, low, high); };
    for (int row = 0; row <= grid.rows && !stop.stop_requested(); ++row)
        for (int column = 0; column <= grid.columns; ++column) {
            const double u = domain[0] + share(column, grid.columns) * (domain[1] - domain[0]);
            const double v = domain[2] + share(row, grid.rows) * (domain[3] - domain[2]);
            for (const auto& [a, b] :
                 std::array<std::array<double, 2>, 5>{{{0, 0}, {-du, 0}, {du, 0}, {0, -dv}, {0, dv}}}) {
                places[0].push_back(clamped(u + a, domain[0], domain[1]));
                places[1].push_back(clamped(v + b, domain[2], domain[3]));
            }
        }
    std::array<std::vector<double>, 3> values;
    for (std::size_t k = 0; k < 3; ++k) values[k] = valuesOf(surface.functions[k], places, stop);
    if (stop.stop_requested()) return grid;
    const auto at = [&](std::size_t i) { return glm::dvec3(values[0][i], values[1][i], values[2][i]); };
    for (std::size_t i = 0; i < values[0].size(); i += 5) {
        grid.points.push_back(at(i));
        const glm::dvec3 normal = glm::cross(at(i + 4) - at(i + 3), at(i + 2) - at(i + 1));
        grid.normals.push_back(glm::dot(normal, normal) < INFINITY ? normal : glm::dvec3(0));
    }
    return grid;
}

SurfaceGrid gridOfPlanarField(const ImplicitPlanarField& field, const std::stop_token& stop) {
    SurfaceGrid grid = emptyGrid(field.xSteps, field.zSteps);
    std::vector<std::vector<double>> places(2);
    for (int row = 0; row <= grid.rows; ++row)
        for (int column = 0; column <= grid.columns; ++column) {
            places[0].push_back(field.low.x + share(column, grid.columns) * (field.high.x - field.low.x));
            places[1].push_back(field.low.y + share(row, grid.rows) * (field.high.y - field.low.y));
        }
    const std::vector<double> heights = valuesOf(field.height, places, stop);
    for (std::size_t i = 0; i < heights.size(); ++i)
        grid.points.emplace_back(places[0][i], heights[i], places[1][i]);
    if (field.smooth && !stop.stop_requested()) grid.smoothen();
    return grid;
}

/// u is the angle about the y axis, v that from the upper pole.
glm::dvec3 onSphere(double u, double v) {
    return {std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)};
}

SurfaceGrid gridOfSphericalField(const ImplicitSphericalField& field, const std::stop_token& stop) {
    SurfaceGrid grid = emptyGrid(field.uSteps, field.vSteps);
    std::vector<std::vector<double>> places(5);
    std::vector<glm::dvec3> directions;
    for (int row = 0; row <= grid.rows; ++row)
        for (int column = 0; column <= grid.columns; ++column) {
            // The last column is the first one, to the last digit.
            const double u = 2 * pi * share(column % grid.columns, grid.columns);
            const double v = pi * share(row, grid.rows);
            const glm::dvec3 d = row == 0           ? glm::dvec3(0, 1, 0)
                                 : row == grid.rows ? glm::dvec3(0, -1, 0)
                                                    : onSphere(u, v);
            directions.push_back(d);
            places[0].push_back(u);
            places[1].push_back(v);
            for (int axis = 0; axis < 3; ++axis)
                places[static_cast<std::size_t>(axis) + 2].push_back(field.radius * d[axis]);
        }
    const std::vector<double> offsets = valuesOf(field.offset, places, stop);
    for (std::size_t i = 0; i < offsets.size(); ++i)
        grid.points.push_back(directions[i] * (field.radius + field.scale * offsets[i]));
    if (field.smooth && !stop.stop_requested()) grid.smoothen();
    return grid;
}

/// The raw value of a pixel; of a coloured one, the mean of its channels.
double pixel(const Raster& raster, int x, int y) {
    double sum = 0;
    for (int channel = 0; channel < raster.channels; ++channel) sum += raster.at(x, y, channel);
    return sum / raster.channels;
}

SurfaceGrid gridOfImage(const ImageField& field, const std::stop_token& stop) {
    const Raster& raster = field.raster;
    // Around a sphere the last column of pixels is followed by the first.
    SurfaceGrid grid = emptyGrid(raster.width, raster.height - 1);
    for (int row = 0; row <= grid.rows; ++row)
        for (int column = 0; column <= grid.columns; ++column) {
            // The first row of the image lies at the upper pole.
            const double u = 2 * pi * share(column % grid.columns, grid.columns);
            const double value = pixel(raster, column % raster.width, row);
            const glm::dvec3 d = row == 0           ? glm::dvec3(0, 1, 0)
                                 : row == grid.rows ? glm::dvec3(0, -1, 0)
                                                    : onSphere(u, pi * share(row, grid.rows));
            grid.points.push_back(d * (field.radius + field.scale * value));
        }
    if (field.smooth && !stop.stop_requested()) grid.smoothen();
    return grid;
}

}  // namespace

std::array<glm::dvec3, 16> bezierPoints(const BicubicShape& patch) {
    // A cubic and its slopes at both ends are its Bezier points.
    const auto ends = [&](int k) -> Weights {
        const double t = k < 2 ? 0 : 1;
        Weights weights = weightsAt(patch.basis, t);
        const Weights slopes = slopesAt(patch.basis, t);
        const double third = k == 1 ? 1.0 / 3 : k == 2 ? -1.0 / 3 : 0;
        for (std::size_t i = 0; i < 4; ++i) weights[i] += third * slopes[i];
        return weights;
    };
    std::array<glm::dvec3, 16> points{};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            points[static_cast<std::size_t>(4 * row + column)] = blend(patch.points, ends(row), ends(column));
    return points;
}

HeightGrid heightsOf(const ImageField& field) {
    HeightGrid grid;
    grid.columns = field.raster.width;
    grid.rows = field.raster.height;
    for (int y = grid.rows - 1; y >= 0; --y)
        for (int x = 0; x < grid.columns; ++x)
            grid.heights.push_back(pixel(field.raster, x, y) / field.raster.largest);
    return grid;
}

namespace {

std::optional<SurfaceGrid> madeGrid(const Primitive& primitive, const ShapeModifiers& modifiers,
                                    const std::stop_token& stop) {
    const std::array<int, 2> steps = modifiers.subdivision.value_or(std::array{defaultSteps, defaultSteps});
    const std::array<double, 4> domain = modifiers.renderBound.value_or(std::array<double, 4>{0, 1, 0, 1});
    if (const auto* patch = std::get_if<BicubicShape>(&primitive)) return gridOfPatch(*patch);
    if (const auto* nurbs = std::get_if<NurbsShape>(&primitive))
        return gridOfNurbs(nurbs->surface, steps, stop);
    if (const auto* surface = std::get_if<ParametricShape>(&primitive))
        return gridOfParametric(*surface, steps, domain, stop);
    if (const auto* field = std::get_if<ImplicitPlanarField>(&primitive))
        return gridOfPlanarField(*field, stop);
    if (const auto* field = std::get_if<ImplicitSphericalField>(&primitive))
        return gridOfSphericalField(*field, stop);
    if (const auto* field = std::get_if<ImageField>(&primitive); field && field->spherical)
        return gridOfImage(*field, stop);
    return std::nullopt;
}

}  // namespace

std::optional<SurfaceGrid> gridOf(const Primitive& primitive, const ShapeModifiers& modifiers,
                                  const std::stop_token& stop) {
    std::optional<SurfaceGrid> grid = madeGrid(primitive, modifiers, stop);
    // What has been computed until then is no surface.
    if (grid && stop.stop_requested()) grid = SurfaceGrid();
    return grid;
}

Transform turning(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 a = glm::normalize(from), b = glm::normalize(to);
    const double cosine = glm::dot(a, b);
    if (cosine > 1 - 1e-15) return {};
    if (cosine < -1 + 1e-15) {
        // Half a turn about any axis across.
        const glm::dvec3 across = std::abs(a.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        return Transform::axisRotation(glm::normalize(across - glm::dot(across, a) * a), 180);
    }
    // Rodrigues' formula: 1 + [w] + [w]^2 / (1 + cosine), w = a x b.
    const glm::dvec3 w = glm::cross(a, b);
    glm::dmat4 matrix(1);
    for (int column = 0; column < 3; ++column) {
        glm::dvec3 unit(0);
        unit[column] = 1;
        const glm::dvec3 once = glm::cross(w, unit), twice = glm::cross(w, once);
        matrix[column] = glm::dvec4(unit + once + twice / (1 + cosine), 0);
    }
    return Transform::matrix(matrix);
}

}  // namespace isoscope::virtualight
