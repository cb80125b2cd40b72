// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "core/roots/root_settings.h"

namespace isoscope {

/// The normals that POV-Ray shows (docs/povray/solver.md, "The normal"): forward differences of the signed
/// function over `accuracy`, of any length, possibly zero or not finite. `evaluate` takes three columns of
/// coordinates and one for the values of f, at most `lanes` entries each, a multiple of 4.
template <std::size_t lanes, class Evaluate>
void povrayNormals(std::span<const glm::dvec3> points, const RootSettings& settings, Evaluate evaluate,
                   std::span<glm::dvec3> out) {
    constexpr std::size_t pointsPerRun = lanes / 4;
    std::array<std::array<double, lanes>, 3> place;
    std::array<double, lanes> values;
    for (std::size_t first = 0; first < points.size(); first += pointsPerRun) {
        const std::size_t count = std::min(pointsPerRun, points.size() - first);
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double here = points[first + k][static_cast<int>(axis)];
                for (std::size_t moved = 0; moved < 4; ++moved)
                    place[axis][4 * k + moved] = moved == axis + 1 ? here + settings.accuracy : here;
            }
        const auto column = [count](std::array<double, lanes>& lane) {
            return std::span(lane).first(4 * count);
        };
        evaluate(column(place[0]), column(place[1]), column(place[2]), column(values));
        for (std::size_t k = 0; k < count; ++k) {
            const double here = settings.signedValue(values[4 * k]);
            for (int axis = 0; axis < 3; ++axis)
                out[first + k][axis] =
                    settings.signedValue(values[4 * k + 1 + static_cast<std::size_t>(axis)]) - here;
        }
    }
}

}  // namespace isoscope
