// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces without an inside.
#include <array>

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/shapes/patches/polygon.h"
#include "core/shapes/patches/triangle.h"

namespace isoscope {

namespace {

ShapePointer finishTriangle(ShapeReader& reader, const Triangle::Corners& corners,
                            const std::optional<Triangle::Corners>& normals) {
    if (!Triangle::degenerate(corners)) return std::make_shared<Triangle>(corners, normals);
    if (reader.finite() && !reader.failed())
        reader.warn(rangeSince(reader.keywordRange(), reader.tokens()),
                    "The corners of this triangle lie on one line; it is left out.");
    return nullptr;
}

ShapePointer parseTriangle(ShapeReader& reader) {
    Triangle::Corners corners;
    int number = 0;
    for (glm::dvec3& corner : corners) corner = reader.vector("corner " + std::to_string(++number));
    return finishTriangle(reader, corners, std::nullopt);
}

ShapePointer parseSmoothTriangle(ShapeReader& reader) {
    Triangle::Corners corners, normals;
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = reader.vector("corner " + std::to_string(k + 1));
        normals[k] = reader.vector("normal " + std::to_string(k + 1));
    }
    return finishTriangle(reader, corners, normals);
}

ShapePointer parsePolygon(ShapeReader& reader) {
    constexpr int pointLimit = 100'000;
    const int count = reader.count("number of points", 3, pointLimit);
    std::vector<glm::dvec3> points;
    while (static_cast<int>(points.size()) < count && ExpressionParser(reader.tokens()).atExpression())
        points.push_back(reader.vector("point " + std::to_string(points.size() + 1)));
    const SourceRange range = rangeSince(reader.keywordRange(), reader.tokens());
    if (!reader.failed() && static_cast<int>(points.size()) < count)
        reader.fail(range, "This polygon announces " + std::to_string(count) + " points, but has " +
                               std::to_string(points.size()) + ".");
    if (reader.failed() || !reader.finite()) return nullptr;
    auto polygon = std::make_shared<Polygon>(points);
    if (polygon->usable()) return polygon;
    reader.warn(range, "The points of this polygon lie on one line; it is left out.");
    return nullptr;
}

}  // namespace

std::span<const ShapeParser> patchParsers() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "triangle", .parse = parseTriangle, .ignoresOwnBounds = true},
        ShapeParser{.keyword = "smooth_triangle", .parse = parseSmoothTriangle, .ignoresOwnBounds = true},
        ShapeParser{.keyword = "polygon", .parse = parsePolygon, .ignoresOwnBounds = true},
    };
    return parsers;
}

}  // namespace isoscope
