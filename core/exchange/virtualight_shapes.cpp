// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/virtualight_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/exchange/function_text.h"
#include "core/text/number_format.h"
#include "core/virtualight/grids.h"
#include "core/virtualight/primitive_shape.h"
#include "core/virtualight/profile_curve.h"

namespace isoscope {

namespace {

using namespace virtualight;

std::string number(double value) { return shortestNumber(value); }
std::string pair(const glm::dvec2& v) { return "<" + number(v.x) + ", " + number(v.y) + ">"; }

std::string boxText(const std::array<glm::dvec3, 2>& box) {
    return "box { " + povrayVector(box[0]) + ", " + povrayVector(box[1]) + " }";
}

/// POV-Ray divides the 65535 of white by 65536.
constexpr double whiteOfHeights = 65536.0 / 65535;

const char* splineKind(const Profile& profile) {
    return profile.method == ProfileMethod::straight ? "linear_spline" : "bezier_spline";
}

/// The number of points and the points of a curve for its splineKind(): for bezier_spline four a piece.
std::string splinePoints(const Profile& profile, bool thereAndBack) {
    std::vector<glm::dvec2> points;
    const bool linear = profile.method == ProfileMethod::straight;
    if (linear) {
        for (const ProfilePoint& point : profile.points) points.push_back(point.place);
        if (thereAndBack)
            for (std::size_t i = profile.points.size() - 1; i-- > 0;)
                points.push_back(profile.points[i].place);
    } else {
        for (const ProfileArc& arc : arcsOf(profile)) {
            const auto& [a, b, c] = arc.points;
            points.insert(points.end(), {a, a + 2.0 / 3 * (b - a), c + 2.0 / 3 * (b - c), c});
        }
        if (thereAndBack)
            for (std::size_t i = points.size(); i-- > 0;) points.push_back(points[i]);
    }
    std::string text = std::to_string(points.size());
    for (const glm::dvec2& point : points) text += ", " + pair(point);
    return text;
}

std::string meshText(const SurfaceGrid& grid, bool solid) {
    const auto triangles = grid.triangles();
    if (triangles.empty()) return {};
    const auto vectors = [](const char* word, const std::vector<glm::dvec3>& list) {
        std::string text = std::string("  ") + word + " { " + std::to_string(list.size());
        for (const glm::dvec3& v : list) {
            // Points without a place belong to no triangle.
            const bool finite = glm::dot(v, v) < INFINITY;
            text += ",\n    " + povrayVector(finite ? v : glm::dvec3(0));
        }
        return text + " }\n";
    };
    std::string text = "mesh2 {\n" + vectors("vertex_vectors", grid.points);
    if (!grid.normals.empty()) {
        std::vector<glm::dvec3> normals = grid.normals;
        for (glm::dvec3& normal : normals) {
            const double length = glm::length(normal);
            normal = length > 0 && std::isfinite(length) ? normal / length : glm::dvec3(0, 1, 0);
        }
        text += vectors("normal_vectors", normals);
    }
    text += "  face_indices { " + std::to_string(triangles.size());
    for (const auto& corners : triangles)
        text += ",\n    <" + std::to_string(corners[0]) + ", " + std::to_string(corners[1]) + ", " +
                std::to_string(corners[2]) + ">";
    text += " }\n";
    if (solid) text += "  inside_vector <0.31, 0.83, 0.46>\n";
    return text;
}

/// Writes one primitive, by its kind.
class Writer {
  public:
    Writer(const ShapeModifiers& modifiers, std::span<const double> parameterTable, HeightImages& images)
        : modifiers_(modifiers), parameterTable_(parameterTable), images_(images) {}

    std::string operator()(const SphereShape& s) const {
        return "sphere { " + povrayVector(s.center) + ", " + number(s.radius);
    }
    std::string operator()(const BoxShape& b) const {
        return "box { " + povrayVector(glm::min(b.first, b.second)) + ", " +
               povrayVector(glm::max(b.first, b.second));
    }
    std::string operator()(const ConeShape& c) const {
        if (c.cylinder || c.baseRadius == c.apexRadius)
            return "cylinder { " + povrayVector(c.base) + ", " + povrayVector(c.apex) + ", " +
                   number(c.baseRadius) + " open";
        return "cone { " + povrayVector(c.base) + ", " + number(c.baseRadius) + ", " + povrayVector(c.apex) +
               ", " + number(c.apexRadius) + " open";
    }
    std::string operator()(const DiskShape& d) const {
        return "disc { " + povrayVector(d.center) + ", " + povrayVector(d.normal) + ", " + number(d.radius) +
               (d.hole > 0 ? ", " + number(d.hole) : "");
    }
    std::string operator()(const TorusShape& t) const {
        return "torus { " + number(t.major) + ", " + number(t.minor) + sturm() +
               povrayMatrix(turning({0, 1, 0}, t.axis)) + " translate " + povrayVector(t.center);
    }
    std::string operator()(const ParaboloidShape& p) const {
        const double height = glm::distance(p.vertex, p.end), r = p.radius;
        const std::string room = boxText(
            {glm::dvec3(-1.001 * r, -0.001 * height, -1.001 * r), glm::dvec3(1.001 * r, height, 1.001 * r)});
        return "quadric { <1, 0, 1>, <0, 0, 0>, <0, " + number(-r * r / height) + ", 0>, 0\n  clipped_by { " +
               room + " } bounded_by { clipped_by }" + povrayMatrix(turning({0, 1, 0}, p.end - p.vertex)) +
               " translate " + povrayVector(p.vertex);
    }
    std::string operator()(const SuperquadricShape& s) const {
        return "superellipsoid { " + pair({s.w, s.h});
    }
    std::string operator()(const PolygonShape& p) const {
        std::vector<glm::dvec3> points = p.points;
        if (points.front() != points.back()) points.push_back(points.front());
        std::string text = "polygon { " + std::to_string(points.size());
        for (const glm::dvec3& point : points) text += ", " + povrayVector(point);
        return text;
    }
    std::string operator()(const TrianglePatch& p) const {
        std::string text = "smooth_triangle { ";
        for (std::size_t k = 0; k < 3; ++k)
            text += (k > 0 ? ", " : "") + povrayVector(p.corners[k]) + ", " + povrayVector(p.normals[k]);
        return text;
    }
    std::string operator()(const BlobbyShape& b) const {
        const auto isPlane = [](const BlobbyPart& part) { return part.kind == BlobbyPart::Kind::plane; };
        if (std::any_of(b.parts.begin(), b.parts.end(), isPlane)) return blobbyField(b);
        std::string text = "blob { threshold " + number(b.threshold);
        for (const BlobbyPart& part : b.parts) {
            const bool sphere = part.kind == BlobbyPart::Kind::sphere;
            text += sphere ? "\n  sphere { " : "\n  cylinder { ";
            text += povrayVector(part.from) + (sphere ? "" : ", " + povrayVector(part.to)) + ", " +
                    number(part.radius) + ", " + number(part.strength) + " }";
        }
        return text + sturm();
    }
    std::string operator()(const ExtrudedShape& e) const {
        const bool ribbon = !e.profile.closed();
        return "prism { linear_sweep " + std::string(splineKind(e.profile)) + " 0, " +
               number(glm::length(e.direction)) + ", " + splinePoints(e.profile, ribbon) +
               (ribbon ? " open" : "") + sturm() + povrayMatrix(extrusionPlace(e.direction));
    }
    std::string operator()(const RevolvedShape& r) const {
        return "lathe { " + std::string(splineKind(r.profile)) + " " + splinePoints(r.profile, false) +
               sturm() + povrayMatrix(turning({0, 1, 0}, r.axis));
    }
    std::string operator()(const ImplicitShape& i) const {
        if (!modifiers_.bound) return {};
        const auto text = functionText(i.function, {"x", "y", "z"}, parameterTable_);
        if (!text) return {};
        return isosurface(*text, *modifiers_.bound,
                          estimatedGradient(i.function, *modifiers_.bound, parameterTable_));
    }
    std::string operator()(const PolynomialShape& p) const {
        std::string text = "poly { " + std::to_string(p.order) + ", <";
        for (std::size_t k = 0; k < p.coefficients.size(); ++k)
            text += (k == 0 ? "" : k % 10 == 0 ? ",\n    " : ", ") + number(p.coefficients[k]);
        return text + ">" + sturm();
    }
    std::string operator()(const ImageField& f) const {
        if (f.spherical) return mesh(f, true);
        const std::string name = images_.stem + "-" + std::to_string(images_.images.size() + 1) + ".png";
        images_.images[name] = heightsOf(f);
        return "height_field { png \"" + name + "\"" + (f.smooth ? " smooth" : "") + " scale <1, " +
               number(f.raster.largest * whiteOfHeights) + ", 1>";
    }
    std::string operator()(const ImplicitSphericalField& f) const { return mesh(f, true); }
    std::string operator()(const ImplicitPlanarField& f) const { return mesh(f, false); }
    std::string operator()(const BicubicShape& p) const { return mesh(p, false); }
    std::string operator()(const NurbsShape& n) const { return mesh(n, false); }
    std::string operator()(const ParametricShape& p) const { return mesh(p, false); }

  private:
    std::string mesh(const Primitive& primitive, bool solid) const {
        return meshText(*gridOf(primitive, modifiers_), solid);
    }
    std::string sturm() const { return modifiers_.solver == Solver::sturm ? " sturm" : ""; }

    static std::string isosurface(const std::string& function, const std::array<glm::dvec3, 2>& box,
                                  double maxGradient) {
        return "isosurface {\n  function { " + function + " }\n  contained_by { " + boxText(box) +
               " }\n  open max_gradient " + number(maxGradient) + " accuracy 0.0001 max_trace 10";
    }

    /// The field of a blobby as a function: strength (1 - min(1, d^2 / radius^2))^2 for each part.
    std::string blobbyField(const BlobbyShape& b) const {
        std::string sum = number(b.threshold);
        double gradient = 0;
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (const BlobbyPart& part : b.parts) {
            sum += "\n    - " + number(part.strength) + "*pow(1 - min(1, (" + squaredDistance(part) + ")/" +
                   number(part.radius * part.radius) + "), 2)";
            // The steepest slope of (1 - t^2)^2 is 8 / (3 sqrt 3).
            gradient += std::abs(part.strength) / part.radius * 1.5397;
            if (part.kind == BlobbyPart::Kind::plane) continue;
            low = glm::min(low, glm::min(part.from, part.to) - part.radius);
            high = glm::max(high, glm::max(part.from, part.to) + part.radius);
        }
        // Planes have no end; without a Bound the room around the other parts is all that is written.
        if (!(low.x <= high.x)) low = glm::dvec3(-10), high = glm::dvec3(10);
        const glm::dvec3 wide = 2.0 * (high - low);
        return isosurface(sum, modifiers_.bound.value_or(std::array{low - wide, high + wide}), gradient);
    }

    static std::string squaredDistance(const BlobbyPart& part) {
        const auto offset = [](const glm::dvec3& p) {
            return "pow(x - (" + number(p.x) + "), 2) + pow(y - (" + number(p.y) + "), 2) + pow(z - (" +
                   number(p.z) + "), 2)";
        };
        const auto along = [](const glm::dvec3& d, double shift) {
            return "(" + number(d.x) + ")*x + (" + number(d.y) + ")*y + (" + number(d.z) + ")*z - (" +
                   number(shift) + ")";
        };
        if (part.kind == BlobbyPart::Kind::sphere || part.from == part.to) return offset(part.from);
        if (part.kind == BlobbyPart::Kind::plane) {
            const double length = glm::length(part.from);
            return "pow(" + along(part.from / length, part.distance / length) + ", 2)";
        }
        // The squared distance from one end, less that along the axis up to the other.
        const double length = glm::distance(part.from, part.to);
        const glm::dvec3 unit = (part.to - part.from) / length;
        const std::string height = along(unit, glm::dot(unit, part.from));
        const std::string onAxis = "max(0, min(" + number(length) + ", " + height + "))";
        return offset(part.from) + " - 2*" + onAxis + "*(" + height + ") + pow(" + onAxis + ", 2)";
    }

    const ShapeModifiers& modifiers_;
    std::span<const double> parameterTable_;
    HeightImages& images_;
};

}  // namespace

std::string povrayVector(const glm::dvec3& v) {
    return "<" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ">";
}

std::string povrayMatrix(const Transform& transform) {
    if (transform.identity()) return {};
    std::string text = " matrix <";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            text += (column + row > 0 ? ", " : "") + number(transform.forward()[column][row]);
    return text + ">";
}

std::string povrayPrimitive(const Primitive& primitive, const ShapeModifiers& modifiers,
                            std::span<const double> parameterTable, HeightImages& images) {
    std::string text = std::visit(Writer(modifiers, parameterTable, images), primitive);
    const bool bounded = modifiers.bound && !std::holds_alternative<ImplicitShape>(primitive);
    if (!text.empty() && bounded)
        text += "\n  clipped_by { " + boxText(*modifiers.bound) + " } bounded_by { clipped_by }";
    return text;
}

}  // namespace isoscope
