// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/shapes/shape.h"

namespace isoscope {

class ShapeReader;

/// A kind of shape as a statement of the scene language: all that the language knows of it. CSG, `object` and
/// `isosurface` are no shapes in this sense: ObjectParser reads them itself.
///
/// Each file of core/language/shapes has one function of its own name, in solid_parsers.cpp
/// `std::span<const ShapeParser> solidParsers()`, which gives the rows of its shapes. CMake finds the files
/// and puts the rows together (isoscope_gather in cmake/Isoscope.cmake).
struct ShapeParser {
    std::string_view keyword;
    /// Reads what the shape has of its own, up to its object modifiers (docs/povray/primitives.md). Null when
    /// it cannot be drawn; the reason has been reported, but for numbers that are infinite or NaN
    /// (ShapeReader::finite).
    ShapePointer (*parse)(ShapeReader&) = nullptr;
    /// The words that may begin an item of its block, beside those of all objects; blanks between.
    std::string_view words = {};
    /// POV-Ray draws the shape without a `bounded_by` of its own, even where that would cut it (measured on
    /// its pictures with all of its shapes); its trace() obeys it. So do both where it is a part of another
    /// solid.
    bool ignoresOwnBounds = false;
};

/// The rows of all files, sorted by their keywords.
const std::vector<ShapeParser>& shapeParsers();

/// The parser of a shape that begins with `keyword`; null for other words.
const ShapeParser* findShapeParser(std::string_view keyword);

/// Whether the word begins a shape of POV-Ray for which there is no parser.
bool isUnreadShape(std::string_view word);

}  // namespace isoscope
