// SPDX-License-Identifier: GPL-3.0-or-later
// Primitives that lists of points describe: polygons, patches, NURBS, profiles, blobbies.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/language/directives/statement_scope.h"
#include "core/virtualight/primitive_parser.h"

namespace isoscope::virtualight {

namespace {

constexpr int polygonSideLimit = 32;
constexpr int patchStepLimit = 1024;
constexpr int profilePointLimit = 10'000;
constexpr int controlPointLimit = 10'000;

/// "point 3"
std::string numbered(const char* what, int k) { return std::string(what) + " " + std::to_string(k + 1); }

/// Takes the opening bracket of a list that may have one; what closes it is expected by closeList.
bool openList(ArgumentReader& arguments, const char* bracket, bool comma) {
    TokenReader& tokens = arguments.tokens();
    if (arguments.failed() || !tokens.peek(comma ? 1 : 0).is(bracket)) return false;
    if (comma) tokens.next();
    tokens.next();
    arguments.begin();
    return true;
}

bool planar(const std::vector<glm::dvec3>& points) {
    // Newell's normal, and the distances from the plane through the middle.
    glm::dvec3 normal(0), middle(0);
    double size = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 &a = points[i], &b = points[(i + 1) % points.size()];
        normal += glm::cross(a - points[0], b - points[0]);
        middle += a / static_cast<double>(points.size());
    }
    for (const glm::dvec3& point : points) size = std::max(size, glm::distance(point, middle));
    const double length = glm::length(normal);
    if (!(length > 1e-12 * size * size)) return true;
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
        return std::abs(glm::dot(point - middle, normal)) <= 1e-6 * size * length;
    });
}

double areaOf(const std::vector<glm::dvec3>& points) {
    glm::dvec3 normal(0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        normal += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
    return glm::length(normal);
}

}  // namespace

Primitive parsePolygon(ArgumentReader& arguments) {
    const int sides = arguments.count("number of vertices", 3, polygonSideLimit);
    const SourceRange countRange = arguments.range();
    PolygonShape polygon;
    while (!arguments.failed() && arguments.tokens().peek().is(","))
        polygon.points.push_back(
            arguments.point(numbered("vertex", static_cast<int>(polygon.points.size()))));
    if (arguments.failed()) return polygon;
    if (polygon.points.size() != static_cast<std::size_t>(sides))
        arguments.fail(countRange, "The polygon says " + std::to_string(sides) + " vertices, but has " +
                                       std::to_string(polygon.points.size()) + ".");
    else if (!planar(polygon.points))
        arguments.fail(arguments.range(), "The vertices of a polygon must lie in one plane.",
                       "cut it into triangles, or use TriangularPatch");
    else if (!(areaOf(polygon.points) > 0))
        arguments.fail(arguments.range(), "The vertices of this polygon enclose no area.");
    return polygon;
}

Primitive parseTriangularPatch(ArgumentReader& arguments) {
    TrianglePatch patch;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        patch.corners[i] = arguments.point(numbered("vertex", k));
        patch.normals[i] = arguments.direction(numbered("normal", k));
        // `UV=` follows the normal without a comma.
        if (!arguments.accept("UV")) continue;
        arguments.expect("=", "behind `UV`");
        arguments.begin();
        patch.uv[i].x = arguments.number("u of vertex " + std::to_string(k + 1));
        patch.uv[i].y = arguments.number("v of vertex " + std::to_string(k + 1));
    }
    const glm::dvec3 area =
        glm::cross(patch.corners[1] - patch.corners[0], patch.corners[2] - patch.corners[0]);
    if (!arguments.failed() && !(glm::length(area) > 0))
        arguments.fail(arguments.range(), "The vertices of this patch lie on one line.");
    return patch;
}

namespace {

BlobbyPart parseComponent(ArgumentReader& component) {
    BlobbyPart part;
    if (component.name().is("Plane")) {
        part.kind = BlobbyPart::Kind::plane;
        part.from = component.direction("normal");
        part.distance = component.number("distance");
    } else if (component.name().is("Cylinder")) {
        part.kind = BlobbyPart::Kind::cylinder;
        part.from = component.point("bottom");
        part.to = component.point("top");
    } else {
        part.from = part.to = component.point("center");
    }
    part.radius = component.positive("radius");
    part.strength = component.number("strength");
    return part;
}

}  // namespace

Primitive parseBlobby(ArgumentReader& arguments) {
    BlobbyShape blobby;
    blobby.threshold = arguments.number("threshold");
    if (!arguments.failed() && !(blobby.threshold > 0))
        arguments.fail(arguments.range(), "The threshold of a blobby must be greater than 0.");
    while (arguments.more()) {
        TokenReader& tokens = arguments.tokens();
        const Token name = tokens.next();
        if (!name.is("Sphere") && !name.is("Cylinder") && !name.is("Plane")) {
            arguments.fail(name.range,
                           "Expected a component of the blobby, but found " + described(name) + ".",
                           "components are Sphere, Cylinder and Plane");
            break;
        }
        const StatementScope scope(tokens.context());
        ArgumentReader component(tokens, arguments.names(), name);
        blobby.parts.push_back(parseComponent(component));
        component.close();
        // It has said what is wrong.
        if (component.failed()) arguments.giveUp();
    }
    if (!arguments.failed() && blobby.parts.size() < 2)
        arguments.fail(arguments.range(), "A blobby needs at least two components.");
    return blobby;
}

namespace {

/// {x, y}, {1 : x, y}, {ON : x, y}, {0 : x, y} or {OFF : x, y}
ProfilePoint parseProfilePoint(ArgumentReader& arguments, ProfileMethod method, int number) {
    ProfilePoint point;
    arguments.expect("{", "to begin a point of the profile");
    arguments.begin();
    const std::string what = numbered("point", number);
    point.place.x = arguments.number(what + " x");
    if (arguments.accept(":")) {
        const double flag = point.place.x;
        if (flag != 0 && flag != 1)
            arguments.fail(arguments.range(),
                           "In front of the `:` stands 1 or ON for a point on the curve, 0 or "
                           "OFF for one beside it.");
        else if (method != ProfileMethod::conditional)
            arguments.warn(
                "Only the points of a CONDITIONAL profile can be on or off the curve; this one "
                "counts like the others.");
        point.on = flag != 0;
        arguments.begin();
        point.place.x = arguments.number(what + " x");
    }
    point.place.y = arguments.number(what + " y");
    arguments.expect("}", "to close the point of the profile");
    return point;
}

/// method, numpoints, dir, points
Profile parseProfile(ArgumentReader& arguments, glm::dvec3& direction) {
    Profile profile;
    profile.method = static_cast<ProfileMethod>(arguments.count("method", 1, 3));
    const int count = arguments.count("number of points", 2, profilePointLimit);
    const SourceRange countRange = arguments.range();
    direction = arguments.direction("direction");
    TokenReader& tokens = arguments.tokens();
    // The list may stand in brackets of its own: a brace behind the comma, and another one behind that.
    const bool braced = tokens.peek(1).is("{") && tokens.peek(2).is("{") && openList(arguments, "{", true);
    const bool listed = braced || openList(arguments, "[", true);
    bool first = listed;
    while (!arguments.failed() && (first || tokens.peek().is(","))) {
        if (!first) tokens.next();
        first = false;
        profile.points.push_back(
            parseProfilePoint(arguments, profile.method, static_cast<int>(profile.points.size())));
    }
    if (listed) arguments.expect(braced ? "}" : "]", "to close the list of points");
    if (arguments.failed()) return profile;
    if (profile.points.size() != static_cast<std::size_t>(count))
        arguments.fail(countRange, "The profile says " + std::to_string(count) + " points, but has " +
                                       std::to_string(profile.points.size()) + ".");
    else if (std::all_of(profile.points.begin(), profile.points.end(), [&](const ProfilePoint& point) {
                 return point.place == profile.points.front().place;
             }))
        arguments.fail(arguments.range(), "All points of this profile are the same.");
    return profile;
}

}  // namespace

Primitive parseExtrudedSurface(ArgumentReader& arguments) {
    ExtrudedShape extruded;
    extruded.profile = parseProfile(arguments, extruded.direction);
    return extruded;
}

Primitive parseSurfaceOfRevolution(ArgumentReader& arguments) {
    RevolvedShape revolved;
    revolved.profile = parseProfile(arguments, revolved.axis);
    return revolved;
}

Primitive parseBicubicPatch(ArgumentReader& arguments) {
    BicubicShape patch;
    patch.basis = arguments.count("basis", 1, 4);
    patch.uSteps = arguments.count("subdivision in u", 1, patchStepLimit);
    patch.vSteps = arguments.count("subdivision in v", 1, patchStepLimit);
    const bool listed = openList(arguments, "[", true);
    for (int k = 0; k < 16; ++k)
        patch.points[static_cast<std::size_t>(k)] = arguments.point(numbered("point", k));
    if (listed) arguments.expect("]", "to close the list of points");
    return patch;
}

namespace {

KnotVector parseKnots(ArgumentReader& arguments, const char* letter) {
    KnotVector knots;
    knots.points = arguments.count(std::string("number of points in ") + letter, 1, controlPointLimit);
    knots.order = arguments.count(std::string("order in ") + letter, 1, KnotVector::orderLimit);
    const std::string what = std::string("knots in ") + letter;
    arguments.expect(",", "in front of the " + what);
    const SourceRange start = arguments.tokens().peek().range;
    arguments.expect("[", "to begin the " + what);
    arguments.begin();
    while (!arguments.failed() && !arguments.tokens().peek().is("]") &&
           knots.knots.size() < 2 * controlPointLimit)
        knots.knots.push_back(arguments.number(std::string("knot ") + std::to_string(knots.knots.size() + 1) +
                                               " in " + letter));
    arguments.expect("]", "to close the " + what);
    if (const std::string problem = knots.problem(); !arguments.failed() && !problem.empty())
        arguments.fail(arguments.tokens().rangeFrom(start), problem);
    return knots;
}

}  // namespace

Primitive parseNurbs(ArgumentReader& arguments) {
    NurbsShape nurbs;
    NurbsSurface& surface = nurbs.surface;
    surface.u = parseKnots(arguments, "u");
    surface.v = parseKnots(arguments, "v");
    if (arguments.failed()) return nurbs;
    arguments.expect(",", "in front of the control points");
    arguments.expect("[", "to begin the control points");
    if (static_cast<long>(surface.u.points) * surface.v.points > controlPointLimit)
        arguments.fail(arguments.range(),
                       "There may be " + std::to_string(controlPointLimit) + " control points at most.");
    for (int i = 0; i < surface.u.points && !arguments.failed(); ++i) {
        if (i > 0) arguments.expect(",", "between the rows of control points");
        arguments.expect("[", "to begin row " + std::to_string(i + 1) + " of " +
                                  std::to_string(surface.u.points) + " of the control points");
        arguments.begin();
        for (int j = 0; j < surface.v.points && !arguments.failed(); ++j) {
            surface.points.push_back(
                arguments.weighted("point " + std::to_string(i + 1) + " " + std::to_string(j + 1)));
            if (!arguments.failed() && !(surface.points.back().w > 0))
                arguments.fail(arguments.range(), "The weight of a control point must be greater than 0.");
        }
        arguments.expect("]", "to close row " + std::to_string(i + 1) + " of the control points, which has " +
                                  std::to_string(surface.v.points));
    }
    arguments.expect("]", "to close the control points");
    return nurbs;
}

}  // namespace isoscope::virtualight
