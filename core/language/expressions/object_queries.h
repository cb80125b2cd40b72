// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/object_description.h"

namespace isoscope {

/// `trace(OBJECT, from, direction [, Normal])`, `inside(OBJECT, point)`, `min_extent(OBJECT)` and
/// `max_extent(OBJECT)`: what a text may ask of an object that it has declared. Shapes are made once for each
/// object and kept in ParseContext::queriedObjects.
class ObjectQueries {
  public:
    explicit ObjectQueries(TokenStream& tokens) : tokens_(tokens) {}

    /// Whether `name` is one of these four functions.
    static bool knows(std::string_view name);

    /// Reads the arguments of the function `name`, which has been taken, and answers.
    Operand call(const Token& name);

  private:
    Operand answer(const Token& name, const ObjectPointer& object);
    Operand trace(const Token& name, const ObjectPointer& object);
    Operand inside(const Token& name, const ObjectPointer& object);
    Operand extent(const Token& name, const ObjectPointer& object);
    /// The third argument of `trace`, a name that may be new.
    void assignNormal(const Token& word, const glm::dvec3& normal);
    ObjectPointer parseObject(const Token& name);
    ShapePointer shapeOf(const ObjectPointer& object);
    /// The step budget pays for what a query costs.
    void pay(const Token& name, const TraceContext& context);

    TokenStream& tokens_;
};

/// What is asked of an object depends on the numbers in its functions: their sliders ask for a new parse.
void markStructural(ParseContext& context, const ObjectDescription& object);

}  // namespace isoscope
