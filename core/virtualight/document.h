// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/shapes/transform.h"
#include "core/text/source_text.h"
#include "core/virtualight/primitive.h"

namespace isoscope::virtualight {

/// Which root finder a shape's polynomials are handed to.
enum class Solver { ferrari, vieta, sturm };

/// The modifiers of a shape that say how it is drawn; those left out are taken from the Solid around it.
struct ShapeModifiers {
    std::optional<Solver> solver;
    std::optional<std::array<glm::dvec3, 2>> bound;    ///< lower and upper corner, in own coordinates
    std::optional<std::array<double, 4>> renderBound;  ///< umin, umax, vmin, vmax
    std::optional<std::array<int, 2>> subdivision;     ///< steps in u and v

    /// These, with those of `outer` where they are left out.
    ShapeModifiers within(const ShapeModifiers& outer) const;
    /// Whether all are left out.
    bool empty() const { return *this == ShapeModifiers(); }
    friend bool operator==(const ShapeModifiers&, const ShapeModifiers&) = default;
};

/// One transform of a shape: degrees about x, then y, then z; an offset; or factors along the axes.
struct TransformStep {
    /// `Rotate`, `Translate` and `Scale`.
    enum class Kind { rotate, translate, scale };
    Kind kind = Kind::translate;
    glm::dvec3 numbers{0};
};

/// All steps, applied in the order of the text (docs/povray/virtualight.md, section 1).
Transform transformOf(const std::vector<TransformStep>& steps);

/// `+`, `^`, `*`, `-`, `&` and `~` (docs/povray/virtualight.md, section 6).
enum class SetOperation { union_, merge, intersection, difference, clipping, inverse };

struct Node;
using NodePointer = std::shared_ptr<const Node>;

/// A Shape or Solid: a primitive, or parts joined by a set operation; a name for one that was declared; a
/// union of one part where something declared got modifiers.
struct Node {
    std::optional<Primitive> primitive;
    SetOperation operation = SetOperation::union_;
    std::vector<NodePointer> parts;
    ShapeModifiers modifiers;
    std::vector<TransformStep> transforms;
    std::string keyword;  ///< "Sphere", "Solid"
    std::string name;     ///< of a declared one
    SourceRange range;
    SourceRange functionRange;  ///< of an ImplicitSurface: its expression
    std::size_t shapeCount = 1;
    int depth = 1;
};

/// What a VirtuaLight text shows.
struct Document {
    std::vector<NodePointer> declared;  ///< in the order of the text
    std::vector<NodePointer> shown;
};

}  // namespace isoscope::virtualight
