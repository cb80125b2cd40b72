// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// What is wrong with a function somewhere, or worth knowing.
enum class Ailment : std::uint8_t {
    undefined,     ///< it has no value: the root of a negative number, 0/0
    infinite,      ///< it, or its slope, is infinite: a pole, ln at 0, the edge of a root
    jump,          ///< its value jumps
    cancellation,  ///< it loses so many digits that the surface is not where accuracy wants it
    kink,          ///< its gradient jumps: abs, min, max, noise of low quality
};
constexpr int ailmentCount = 5;

/// For output: "undefined", "infinite", "jump", "cancellation", "kink".
std::string_view name(Ailment ailment);
/// What it does to POV-Ray's picture and to the exact one, and what helps: a sentence or two.
std::string_view consequence(Ailment ailment);

/// A place with an ailment, in the coordinates of the function.
struct HealthFinding {
    Ailment ailment = Ailment::kink;
    glm::dvec3 place{0};  ///< of a larger region, a place near the surface
    GradientBox region;   ///< around all of it
    /// Met by evaluating the function there; else formulas alone do not exclude it.
    bool confirmed = false;
    /// Of a jump, how far; of cancellation, how far the surface may be off; else 0.
    double size = 0;
    /// From the surface, to within FunctionHealth::resolution; infinite without a surface.
    double distance = 0;
};

/// What is known of a function in its container.
struct FunctionHealth {
    std::vector<HealthFinding> findings;  ///< the worst kinds first, of one kind the nearest to the surface
    double resolution = 0;                ///< of distances, and of what is told apart
    bool finished = false;  ///< else there may be more: budget or time were spent, or findings left out
    bool known = false;     ///< false after a stop, and for containers that are not finite
};

/// When a search ends, at the latest.
struct HealthSettings {
    double fineness = 1.0 / 64;        ///< of the container: boxes are not halved any further
    std::uint64_t boxLimit = 150'000;  ///< evaluations over boxes
    std::size_t findingsOfKind = 50;   ///< the nearest to the surface are kept
};

/// Looks for such places: boxes of the container whose enclosures exclude them all are dismissed, the others
/// halved; those that touch are one finding, which evaluations at points try to confirm. What is not found is
/// not there, for the function as IntervalGradientEvaluator understands it, except that cancellation is only
/// looked for at points of the surface. `enough` ends the search for further ones, and what is found by then
/// is told; after `stop` nothing is.
FunctionHealth functionHealth(const Isosurface& surface, std::span<const double> parameters,
                              const HealthSettings& settings = {},
                              const std::function<void(double)>& progress = {}, std::stop_token stop = {},
                              std::stop_token enough = {});

}  // namespace isoscope
