// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/function/function_graph.h"
#include "core/image/raster_file.h"
#include "core/shapes/patches/nurbs_surface.h"

/// The shapes of VirtuaLight as a text states them (docs/povray/virtualight.md, section 2): plain numbers
/// that have been checked, to be drawn (makeShape) and to be written (exchange).
namespace isoscope::virtualight {

/// `radius` is greater than 0.
struct SphereShape {
    glm::dvec3 center{0};
    double radius = 1;
};

/// Two opposite corners, in any order; they may make it flat.
struct BoxShape {
    glm::dvec3 first{0}, second{1};
};

/// Without caps.
struct ConeShape {
    glm::dvec3 base{0};
    double baseRadius = 1;
    glm::dvec3 apex{0};
    double apexRadius = 0;
    bool cylinder = false;  ///< written as `Cylinder`, with one radius
};

/// A disk; a ring where the hole has a radius.
struct DiskShape {
    glm::dvec3 center{0};
    glm::dvec3 normal{0, 1, 0};
    double radius = 1;
    double hole = 0;
};

/// Radius `major` goes to the middle of the tube, `minor` is the tube's own.
struct TorusShape {
    glm::dvec3 center{0};
    glm::dvec3 axis{0, 1, 0};
    double major = 1;
    double minor = 0.25;
};

/// From its vertex to the centre of its open end, where it has the radius.
struct ParaboloidShape {
    glm::dvec3 vertex{0}, end{0, 1, 0};
    double radius = 1;
};

/// (|x|^(2/w) + |y|^(2/w))^(w/h) + |z|^(2/h) = 1
struct SuperquadricShape {
    double h = 1, w = 1;
};

/// 3 to 32 corners in one plane, in order around it; they enclose some area.
struct PolygonShape {
    std::vector<glm::dvec3> points;
};

/// A triangle with a normal and texture coordinates at each corner; the normals need no unit length.
struct TrianglePatch {
    std::array<glm::dvec3, 3> corners{};
    std::array<glm::dvec3, 3> normals{};
    std::array<glm::dvec2, 3> uv{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
};

/// A part of a blobby: its field falls from `strength` to 0 at `radius`.
struct BlobbyPart {
    /// What the distance to the field's middle is measured from: a point, a line, or a plane.
    enum class Kind { sphere, cylinder, plane };
    Kind kind = Kind::sphere;
    glm::dvec3 from{0};   ///< centre, bottom, or the plane's normal
    glm::dvec3 to{0};     ///< top of a cylinder
    double distance = 0;  ///< of a plane: normal . p = distance
    double radius = 1;
    double strength = 1;
};

/// Inside where the sum of the parts' fields is above the threshold (docs/povray/virtualight.md, section 4).
struct BlobbyShape {
    double threshold = 0.5;
    std::vector<BlobbyPart> parts;
};

/// How the points of a profile make a curve.
enum class ProfileMethod { straight = 1, polynomial = 2, conditional = 3 };

/// A point of a profile, in the plane of the profile.
struct ProfilePoint {
    glm::dvec2 place{0};
    bool on = true;  ///< the curve goes through it; only `conditional` asks
};

/// A plane curve (docs/povray/virtualight.md, section 5; profile_curve.h makes its pieces).
struct Profile {
    ProfileMethod method = ProfileMethod::straight;
    std::vector<ProfilePoint> points;

    /// Whether it ends where it begins, to the last digit; there must be points.
    bool closed() const { return points.front().place == points.back().place; }
};

/// The profile moved along the direction, by its length; a solid when the profile is closed, else a ribbon.
struct ExtrudedShape {
    Profile profile;
    glm::dvec3 direction{0, 0, 1};
};

/// The profile turned about the axis through the origin: x is the distance from it, y goes along it.
struct RevolvedShape {
    Profile profile;
    glm::dvec3 axis{0, 1, 0};
};

/// A bicubic patch of 4 by 4 points (docs/povray/virtualight.md, section 3), drawn in uSteps by vSteps cells.
struct BicubicShape {
    int basis = 1;  ///< 1 Bezier, 2 B-spline, 3 Catmull-Rom, 4 Hermite
    int uSteps = 1, vSteps = 1;
    std::array<glm::dvec3, 16> points{};
};

/// A NURBS surface; the modifier ShapeSubdivision says how finely it is drawn.
struct NurbsShape {
    NurbsSurface surface;
};

/// f(x, y, z) = 0, inside where f < 0.
struct ImplicitShape {
    Function function;
};

/// A polynomial of x, y and z, its terms in the order of Poly.
struct PolynomialShape {
    int order = 1;
    std::vector<double> coefficients;
};

/// The surface (x, y, z) of two parameters; RenderBound is their domain, 0 to 1 without one.
struct ParametricShape {
    std::array<Function, 3> functions;  ///< of u and v
};

/// A height field y(x, z) over a rectangle.
struct ImplicitPlanarField {
    glm::dvec2 low{0}, high{1};  ///< of x and z
    Function height;             ///< arguments x and z
    int xSteps = 1, zSteps = 1;
    bool smooth = false;
};

/// A height field around a sphere at the origin: the distance from it is radius + scale * offset.
struct ImplicitSphericalField {
    double radius = 1, scale = 1;
    /// Arguments u (theta, about the y axis, 0 to 2 pi), v (phi, from the upper pole, 0 to pi), and x, y, z
    /// of the place on the sphere.
    Function offset;
    int uSteps = 1, vSteps = 1;
    bool smooth = false;
};

/// A height field of an image: flat over the unit square, or around a sphere.
struct ImageField {
    bool spherical = false;
    double radius = 1, scale = 1;  ///< of a spherical one
    bool smooth = false;
    std::string name;  ///< as the text states it
    Raster raster;
};

using Primitive = std::variant<SphereShape, BoxShape, ConeShape, DiskShape, TorusShape, ParaboloidShape,
                               SuperquadricShape, PolygonShape, TrianglePatch, BlobbyShape, ExtrudedShape,
                               RevolvedShape, BicubicShape, NurbsShape, ImplicitShape, PolynomialShape,
                               ParametricShape, ImplicitPlanarField, ImplicitSphericalField, ImageField>;

}  // namespace isoscope::virtualight
