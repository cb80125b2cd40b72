// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "core/evaluate/prepared_function.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// A function of fewer coordinates than it is written in: one that is the same along whole lines or planes,
/// such as g(x + 2 y - z) or g(x + y, z), as a function of the distances across these (a ridge function,
/// Pinkus, "Ridge Functions", 2015). It is steepest all along such a line or plane, which boxes in x, y and z
/// would have to cover.
struct RidgeFunction {
    /// Of the first one or two arguments, which are lengths: its gradients are as long as the function's, up
    /// to `slack`.
    std::shared_ptr<const PreparedFunction> function;
    /// Holds what becomes of the container; of no extent along arguments that do not count.
    GradientDomain domain;
    /// No gradient of the function is longer than that of `function` times 1 + slack; at most 1e-10.
    double slack = 0;
    /// Rows: the unit vectors of the arguments, 0 for one that does not count, and the arguments at the
    /// origin.
    std::array<glm::dvec3, 2> axes{};
    glm::dvec3 origin{0};

    /// None where the function has no such form, or one that is not well conditioned, and for tapes with
    /// loops or of very many instructions.
    static std::optional<RidgeFunction> of(const PreparedFunction& function, const Container& container);

    /// A place of the container with these arguments, or nearly.
    glm::dvec3 placeOf(const glm::dvec3& arguments, const GradientDomain& container) const;
};

}  // namespace isoscope
