// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/shape_parser.h"

#include <algorithm>

#include "core/language/tokens/words.h"

namespace isoscope {

/// The rows of all files of core/language/shapes; CMake writes it.
std::vector<ShapeParser> gatherShapeParsers();

const std::vector<ShapeParser>& shapeParsers() {
    static const auto sorted = [] {
        std::vector<ShapeParser> parsers = gatherShapeParsers();
        std::ranges::sort(parsers, {}, &ShapeParser::keyword);
        return parsers;
    }();
    return sorted;
}

const ShapeParser* findShapeParser(std::string_view keyword) {
    const std::vector<ShapeParser>& parsers = shapeParsers();
    const auto found = std::ranges::lower_bound(parsers, keyword, {}, &ShapeParser::keyword);
    return found == parsers.end() || found->keyword != keyword ? nullptr : &*found;
}

bool isUnreadShape(std::string_view word) {
    return isWordFor(WordUse::shape, word) && findShapeParser(word) == nullptr;
}

}  // namespace isoscope
