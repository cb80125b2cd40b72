// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/primitive_parser.h"

#include <algorithm>
#include <array>

#include "core/language/directives/statement_scope.h"
#include "core/language/tokens/symbol_table.h"

namespace isoscope::virtualight {

namespace {

struct Entry {
    std::string_view name;
    Primitive (*parse)(ArgumentReader&);
};

constexpr std::array<Entry, 23> primitives{{
    {"BicubicPatch", parseBicubicPatch},
    {"Blobby", parseBlobby},
    {"Box", parseBox},
    {"Cone", parseCone},
    {"Cylinder", parseCylinder},
    {"Disk", parseDisk},
    {"ExtrudedSurface", parseExtrudedSurface},
    {"ImplicitPlanarHeightField", parseImplicitPlanarHeightField},
    {"ImplicitSphericalHeightField", parseImplicitSphericalHeightField},
    {"ImplicitSurface", parseImplicitSurface},
    {"NURBS", parseNurbs},
    {"Paraboloid", parseParaboloid},
    {"ParametricSurface", parseParametricSurface},
    {"PlanarHeightField", parsePlanarHeightField},
    {"Polygon", parsePolygon},
    {"PolynomialSurface", parsePolynomialSurface},
    {"Ring", parseRing},
    {"Sphere", parseSphere},
    {"SphericalHeightField", parseSphericalHeightField},
    {"Superquadric", parseSuperquadric},
    {"SurfaceOfRevolution", parseSurfaceOfRevolution},
    {"Torus", parseTorus},
    {"TriangularPatch", parseTriangularPatch},
}};

const Entry* find(std::string_view name) {
    const auto* found =
        std::find_if(primitives.begin(), primitives.end(), [&](const Entry& e) { return e.name == name; });
    return found == primitives.end() ? nullptr : found;
}

}  // namespace

bool PrimitiveParser::isPrimitive(std::string_view name) { return find(name) != nullptr; }

std::string PrimitiveParser::closestName(std::string_view name) {
    std::vector<std::string> names;
    for (const Entry& entry : primitives) names.emplace_back(entry.name);
    return isoscope::closestName(name, names);
}

std::optional<ParsedPrimitive> PrimitiveParser::parse(TokenReader& tokens, const Names& names) {
    const Token name = tokens.next();
    const StatementScope scope(tokens.context());
    ArgumentReader arguments(tokens, names, name);
    ParsedPrimitive parsed;
    if (!arguments.failed()) parsed.primitive = find(name.text)->parse(arguments);
    parsed.functionRange = arguments.range();
    arguments.close();
    if (arguments.failed()) return std::nullopt;
    return parsed;
}

// The primitives that a few numbers describe.

Primitive parseSphere(ArgumentReader& arguments) {
    const glm::dvec3 center = arguments.point("center");
    return SphereShape{center, arguments.positive("radius")};
}

Primitive parseBox(ArgumentReader& arguments) {
    const glm::dvec3 first = arguments.point("first corner");
    const glm::dvec3 second = arguments.point("second corner");
    const bool flat = first.x == second.x || first.y == second.y || first.z == second.z;
    if (flat && !arguments.failed()) arguments.warn("This box is flat; its corners lie in one plane.");
    return BoxShape{first, second};
}

namespace {

/// An axis of length 0 makes no shape.
glm::dvec3 axisEnd(ArgumentReader& arguments, const std::string& what, const glm::dvec3& begin) {
    const glm::dvec3 end = arguments.point(what);
    if (!arguments.failed() && end == begin)
        arguments.fail(arguments.range(), "The ends of the axis must differ.");
    return end;
}

double notNegative(ArgumentReader& arguments, const std::string& what) {
    const double value = arguments.number(what);
    if (value < 0) arguments.fail(arguments.range(), "The " + what + " must not be negative.");
    return value;
}

}  // namespace

Primitive parseCone(ArgumentReader& arguments) {
    ConeShape cone;
    cone.base = arguments.point("base");
    cone.baseRadius = notNegative(arguments, "base radius");
    cone.apex = axisEnd(arguments, "apex", cone.base);
    cone.apexRadius = notNegative(arguments, "apex radius");
    if (cone.baseRadius == 0 && cone.apexRadius == 0)
        arguments.fail(arguments.range(), "One of the radii must be greater than 0.");
    return cone;
}

Primitive parseCylinder(ArgumentReader& arguments) {
    ConeShape cylinder;
    cylinder.cylinder = true;
    cylinder.base = arguments.point("bottom");
    cylinder.apex = axisEnd(arguments, "top", cylinder.base);
    cylinder.baseRadius = cylinder.apexRadius = arguments.positive("radius");
    return cylinder;
}

Primitive parseDisk(ArgumentReader& arguments) {
    DiskShape disk;
    disk.center = arguments.point("center");
    disk.normal = arguments.direction("normal");
    disk.radius = arguments.positive("radius");
    return disk;
}

Primitive parseRing(ArgumentReader& arguments) {
    DiskShape ring;
    ring.center = arguments.point("center");
    ring.normal = arguments.direction("normal");
    ring.radius = arguments.positive("outer radius");
    ring.hole = notNegative(arguments, "hole radius");
    if (ring.hole >= ring.radius)
        arguments.fail(arguments.range(), "The hole of the ring leaves nothing of it.",
                       "the outer radius comes first, then that of the hole");
    return ring;
}

Primitive parseTorus(ArgumentReader& arguments) {
    TorusShape torus;
    torus.center = arguments.point("center");
    torus.axis = arguments.direction("direction");
    torus.major = arguments.positive("major radius");
    torus.minor = arguments.positive("minor radius");
    if (torus.minor > torus.major)
        arguments.warn("The axis of this torus crosses its tube: the minor radius is the greater one.");
    return torus;
}

Primitive parseParaboloid(ArgumentReader& arguments) {
    ParaboloidShape paraboloid;
    paraboloid.vertex = arguments.point("base");
    paraboloid.end = axisEnd(arguments, "top", paraboloid.vertex);
    paraboloid.radius = arguments.positive("radius");
    return paraboloid;
}

Primitive parseSuperquadric(ArgumentReader& arguments) {
    const double h = arguments.positive("vertical coefficient");
    return SuperquadricShape{h, arguments.positive("horizontal coefficient")};
}

}  // namespace isoscope::virtualight
