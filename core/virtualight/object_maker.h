// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "core/language/objects/object_description.h"
#include "core/language/parse_context.h"
#include "core/virtualight/document.h"

namespace isoscope::virtualight {

/// Makes objects of the nodes of a document. Modifiers go down to the parts that have none of their own.
class ObjectMaker {
  public:
    explicit ObjectMaker(ParseContext& context) : context_(context) {}

    /// Null when nothing can be drawn; the reason has been reported.
    ObjectPointer make(const Node& node, const ShapeModifiers& outer = {});

    /// Points of all nets of triangles in one text, and evaluations of functions (about fifty operations
    /// each).
    static constexpr std::size_t pointLimit = 1'200'000;
    static constexpr std::size_t workLimit = std::size_t{1} << 24;

  private:
    ObjectPointer makePrimitive(const Node& node, const ShapeModifiers& modifiers);
    ObjectPointer makeParts(const Node& node, const ShapeModifiers& modifiers);
    /// A copy of the object with the node's transforms behind its own.
    static ObjectPointer placed(const Node& node, const ObjectPointer& object);
    bool withinBudget(const Node& node, const ShapeModifiers& modifiers);

    ParseContext& context_;
    std::size_t points_ = 0;
    std::size_t work_ = 0;
    /// Copies of a declared shape share it.
    struct Drawn {
        ShapeModifiers modifiers;
        ObjectPointer object;
    };
    std::map<const Node*, std::vector<Drawn>> drawn_;
};

}  // namespace isoscope::virtualight
