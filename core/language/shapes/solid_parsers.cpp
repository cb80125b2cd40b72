// SPDX-License-Identifier: GPL-3.0-or-later
// The solids that a few numbers describe.
#include <array>

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/disc.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"
#include "core/shapes/solids/superellipsoid.h"
#include "core/shapes/solids/torus.h"

namespace isoscope {

namespace {

ShapePointer parseSphere(ShapeReader& reader) {
    const glm::dvec3 center = reader.vector("center");
    const double radius = reader.number("radius");
    return std::make_shared<Sphere>(center, radius);
}

ShapePointer parseBox(ShapeReader& reader) {
    const glm::dvec3 first = reader.vector("first corner");
    const glm::dvec3 second = reader.vector("second corner");
    return std::make_shared<Box>(first, second);
}

ShapePointer parsePlane(ShapeReader& reader) {
    const glm::dvec3 normal = reader.vector("normal");
    const SourceRange range = reader.range();
    const double distance = reader.number("distance");
    if (normal == glm::dvec3(0)) reader.fail(range, "The normal of a plane must have a length.");
    return std::make_shared<Plane>(normal, distance);
}

ShapePointer finishCone(ShapeReader& reader, const glm::dvec3& base, double baseRadius, const glm::dvec3& cap,
                        double capRadius, const SourceRange& capRange) {
    const bool open = reader.tokens().accept("open");
    if (base == cap)
        reader.fail(capRange, "Both ends of this `" + reader.keyword() + "` are the same point.",
                    "move one of them along the axis");
    return std::make_shared<Cone>(base, baseRadius, cap, capRadius, open);
}

ShapePointer parseCylinder(ShapeReader& reader) {
    const glm::dvec3 base = reader.vector("base");
    const glm::dvec3 cap = reader.vector("cap");
    const SourceRange capRange = reader.range();
    const double radius = reader.number("radius");
    return finishCone(reader, base, radius, cap, radius, capRange);
}

ShapePointer parseCone(ShapeReader& reader) {
    const glm::dvec3 base = reader.vector("base");
    const double baseRadius = reader.number("base radius");
    const glm::dvec3 cap = reader.vector("cap");
    const SourceRange capRange = reader.range();
    const double capRadius = reader.number("cap radius");
    return finishCone(reader, base, baseRadius, cap, capRadius, capRange);
}

ShapePointer parseTorus(ShapeReader& reader) {
    const double major = reader.number("major radius");
    const double minor = reader.number("minor radius");
    return std::make_shared<Torus>(major, minor);
}

ShapePointer parseDisc(ShapeReader& reader) {
    const glm::dvec3 center = reader.vector("center");
    const glm::dvec3 normal = reader.vector("normal");
    if (normal == glm::dvec3(0)) reader.fail(reader.range(), "The normal of a disc must have a length.");
    const double radius = reader.number("radius");
    double hole = 0;
    if (ExpressionParser(reader.tokens()).atExpression()) hole = reader.number("hole radius");
    return std::make_shared<Disc>(center, normal, radius, hole);
}

ShapePointer parseSuperellipsoid(ShapeReader& reader) {
    const glm::dvec2 exponents = reader.pair("exponents");
    if (!(exponents.x > 0 && exponents.y > 0))
        reader.fail(reader.range(), "Both exponents of a superellipsoid must be greater than 0.");
    return std::make_shared<Superellipsoid>(exponents.x, exponents.y);
}

}  // namespace

std::span<const ShapeParser> solidParsers() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "sphere", .parse = parseSphere, .ignoresOwnBounds = true},
        ShapeParser{.keyword = "box", .parse = parseBox, .ignoresOwnBounds = true},
        ShapeParser{.keyword = "plane", .parse = parsePlane, .ignoresOwnBounds = true},
        ShapeParser{.keyword = "cylinder", .parse = parseCylinder, .words = "open"},
        ShapeParser{.keyword = "cone", .parse = parseCone, .words = "open"},
        ShapeParser{.keyword = "torus", .parse = parseTorus},
        ShapeParser{.keyword = "disc", .parse = parseDisc, .ignoresOwnBounds = true},
        ShapeParser{.keyword = "superellipsoid", .parse = parseSuperellipsoid},
    };
    return parsers;
}

}  // namespace isoscope
