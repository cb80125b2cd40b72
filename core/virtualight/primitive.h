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

struct SphereShape {
    glm::dvec3 center{0};
    double radius = 1;
};

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

struct PolygonShape {
    std::vector<glm::dvec3> points;
};

struct TrianglePatch {
    std::array<glm::dvec3, 3> corners{};
    std::array<glm::dvec3, 3> normals{};
    std::array<glm::dvec2, 3> uv{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
};

/// A part of a blobby: its field falls from `strength` to 0 at `radius`.
struct BlobbyPart {
    enum class Kind { sphere, cylinder, plane };
    Kind kind = Kind::sphere;
    glm::dvec3 from{0};   ///< centre, bottom, or the plane's normal
    glm::dvec3 to{0};     ///< top of a cylinder
    double distance = 0;  ///< of a plane: normal . p = distance
    double radius = 1;
    double strength = 1;
};

struct BlobbyShape {
    double threshold = 0.5;
    std::vector<BlobbyPart> parts;
};

/// How the points of a profile make a curve.
enum class ProfileMethod { straight = 1, polynomial = 2, conditional = 3 };

struct ProfilePoint {
    glm::dvec2 place{0};
    bool on = true;  ///< the curve goes through it; only `conditional` asks
};

struct Profile {
    ProfileMethod method = ProfileMethod::straight;
    std::vector<ProfilePoint> points;

    bool closed() const { return points.front().place == points.back().place; }
};

struct ExtrudedShape {
    Profile profile;
    glm::dvec3 direction{0, 0, 1};
};

struct RevolvedShape {
    Profile profile;
    glm::dvec3 axis{0, 1, 0};
};

struct BicubicShape {
    int basis = 1;  ///< 1 Bezier, 2 B-spline, 3 Catmull-Rom, 4 Hermite
    int uSteps = 1, vSteps = 1;
    std::array<glm::dvec3, 16> points{};
};

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

struct ParametricShape {
    std::array<Function, 3> functions;  ///< of u and v
};

struct ImplicitPlanarField {
    glm::dvec2 low{0}, high{1};  ///< of x and z
    Function height;             ///< arguments x, y = 0, z
    int xSteps = 1, zSteps = 1;
    bool smooth = false;
};

struct ImplicitSphericalField {
    double radius = 1, scale = 1;
    Function offset;  ///< of u (theta, about the axis) and v (phi, from the pole)
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
