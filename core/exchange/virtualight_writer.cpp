// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/virtualight_writer.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "core/exchange/function_text.h"
#include "core/shapes/composition.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/solids/blob.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/disc.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/poly.h"
#include "core/shapes/solids/quadric.h"
#include "core/shapes/solids/sphere.h"
#include "core/shapes/solids/superellipsoid.h"
#include "core/shapes/solids/torus.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// A term of a Solid's expression, or nothing where there is no equivalent.
using Term = std::optional<std::string>;

constexpr int orderLimit = 21;

std::string number(double value) { return shortestNumber(value); }
std::string point(const glm::dvec3& p) {
    return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
}

/// The map as Scale, Rotate and Translate; nothing for a sheared one.
std::optional<std::string> transformText(const Transform& transform) {
    if (transform.identity()) return "";
    const glm::dmat4& m = transform.forward();
    glm::dvec3 scale(glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])),
                     glm::length(glm::dvec3(m[2])));
    if (glm::dot(glm::cross(glm::dvec3(m[0]), glm::dvec3(m[1])), glm::dvec3(m[2])) < 0) scale.x = -scale.x;
    const auto r = [&](int row, int column) { return m[column][row] / scale[column]; };
    // The rotation turns about x, then y, then z.
    glm::dvec3 angles(0);
    if (std::abs(r(2, 0)) < 1 - 1e-12)
        angles = {std::atan2(r(2, 1), r(2, 2)), std::asin(-r(2, 0)), std::atan2(r(1, 0), r(0, 0))};
    else if (r(2, 0) < 0)
        angles = {std::atan2(r(0, 1), r(1, 1)), std::numbers::pi / 2, 0};
    else
        angles = {std::atan2(-r(0, 1), r(1, 1)), -std::numbers::pi / 2, 0};
    angles *= 180 / std::numbers::pi;
    const Transform again = Transform::scaling(scale)
                                .then(Transform::rotation(angles))
                                .then(Transform::translation(glm::dvec3(m[3])));
    for (int column = 0; column < 4; ++column)
        if (!(glm::distance(again.forward()[column], m[column]) <= 1e-9 * (1 + glm::length(m[column]))))
            return {};
    std::string text;
    const auto add = [&](const char* word, const glm::dvec3& numbers, const glm::dvec3& none) {
        if (glm::distance(numbers, none) > 1e-12) text += std::string(" ") + word + point(numbers);
    };
    add("Scale", scale, glm::dvec3(1));
    add("Rotate", angles, glm::dvec3(0));
    add("Translate", glm::dvec3(m[3]), glm::dvec3(0));
    return text;
}

/// Writes one object.
class Writer {
  public:
    explicit Writer(std::span<const double> parameterTable) : parameterTable_(parameterTable) {}

    Term term(const Shape& shape, const Transform& place) const {
        using enum Composition::Kind;
        const Composition made = shape.composition();
        switch (made.kind) {
            case primitive: return primitiveTerm(shape.primitive(), place);
            case wrapped: return wrappedTerm(made, place);
            case complement: {
                const Term inner = term(*made.parts.front(), place);
                return inner ? Term("~" + *inner) : Term();
            }
            case union_: return joined(made.parts, " + ", place);
            case merge: return joined(made.parts, " ^ ", place);
            case intersection: return joined(made.parts, " * ", place);
        }
        return {};
    }

  private:
    static Term both(const Term& a, const char* between, const Term& b) {
        return a && b ? Term(*a + between + *b) : Term();
    }

    static Term shapeTerm(const std::string& primitive, const std::string& modifiers,
                          const Transform& place) {
        const std::optional<std::string> moved = transformText(place);
        return moved ? Term("Shape [ " + primitive + modifiers + *moved + " ]") : Term();
    }

    Term wrappedTerm(const Composition& made, const Transform& outer) const {
        const Transform place = made.transform ? made.transform->then(outer) : outer;
        Term text = term(*made.parts.front(), place);
        if (!made.limitsCut) return text;
        for (const ShapePointer& limit : made.limits) text = both(text, " & ", term(*limit, place));
        return text ? Term("(" + *text + ")") : Term();
    }

    Term joined(std::span<const ShapePointer> parts, const char* between, const Transform& place) const {
        if (parts.empty()) return {};
        Term text = term(*parts.front(), place);
        for (const ShapePointer& part : parts.subspan(1)) text = both(text, between, term(*part, place));
        return text ? Term("(" + *text + ")") : Term();
    }

    /// Nothing for primitives that are not named here; each has a function of its own below.
    Term primitiveTerm(const PrimitivePointer& primitive, const Transform& place) const {
        Term term;
        primitive
            .visit<Blob, Box, Cone, Disc, Isosurface, Plane, Poly, Quadric, Sphere, Superellipsoid, Torus>(
                [&](const auto& known) { term = knownTerm(known, place); });
        return term;
    }

    template <class Known>
    static Term knownTerm(const Known& shape, const Transform& place) {
        const Term text = primitiveText(shape);
        return text ? shapeTerm(*text, "", place) : Term();
    }

    Term knownTerm(const Isosurface& surface, const Transform& place) const {
        const IsosurfaceSettings& settings = surface.settings();
        const auto function =
            functionText(settings.function, {"x", "y", "z"}, parameterTable_, FunctionNotation::virtualight);
        if (!function || settings.positivePolarity) return {};
        const Bounds room = surface.bounds();
        const glm::dvec3 more = 0.01 * (room.high - room.low);
        const auto* sphere = std::get_if<ContainerSphere>(&settings.container);
        const bool plain = settings.open && !sphere;
        const std::string expression =
            *function + (settings.threshold == 0 ? "" : " - (" + number(settings.threshold) + ")");
        const Term level = shapeTerm("ImplicitSurface(" + expression + ")",
                                     " Bound(" + point(plain ? room.low : room.low - more) + ", " +
                                         point(plain ? room.high : room.high + more) + ")",
                                     place);
        if (plain) return level;
        const Term container =
            sphere
                ? shapeTerm("Sphere(" + point(sphere->center) + ", " + number(std::abs(sphere->radius)) + ")",
                            "", place)
                : shapeTerm("Box(" + point(room.low) + ", " + point(room.high) + ")", "", place);
        // Walls belong to a surface that is not open.
        const Term text = both(level, settings.open ? " & " : " * ", container);
        return text ? Term("(" + *text + ")") : Term();
    }

    static Term primitiveText(const Sphere& s) {
        return "Sphere(" + point(s.center()) + ", " + number(s.radius()) + ")";
    }

    static Term primitiveText(const Box& b) { return "Box(" + point(b.low()) + ", " + point(b.high()) + ")"; }

    static Term primitiveText(const Torus& t) {
        return "Torus((0, 0, 0), (0, 1, 0), " + number(t.major()) + ", " + number(t.minor()) + ")";
    }

    static Term primitiveText(const Superellipsoid& s) {
        return "Superquadric(" + number(s.n()) + ", " + number(s.e()) + ")";
    }

    static Term primitiveText(const Plane& p) {
        return "PolynomialSurface(" +
               sumText({p.normal().x, p.normal().y, p.normal().z, -p.distance()}, {"x", "y", "z", ""}) + ")";
    }

    static Term primitiveText(const Disc& d) {
        const std::string start = point(d.center()) + ", " + point(d.normal()) + ", " + number(d.radius());
        return d.holeRadius() > 0 ? "Ring(" + start + ", " + number(d.holeRadius()) + ")"
                                  : "Disk(" + start + ")";
    }

    static Term knownTerm(const Cone& c, const Transform& place) {
        const glm::dvec3 axis = c.cap() - c.base();
        const double height = glm::length(axis);
        if (!(height > 0)) return {};
        if (c.open())
            return shapeTerm("Cone(" + point(c.base()) + ", " + number(c.baseRadius()) + ", " +
                                 point(c.cap()) + ", " + number(c.capRadius()) + ")",
                             "", place);
        // With its caps it is a profile that begins and ends at the axis.
        return shapeTerm("SurfaceOfRevolution(STRAIGHT, 4, " + point(axis) + ", {0, 0}, {" +
                             number(c.baseRadius()) + ", 0}, {" + number(c.capRadius()) + ", " +
                             number(height) + "}, {0, " + number(height) + "})",
                         "", Transform::translation(c.base()).then(place));
    }

    static std::string sumText(const std::vector<double>& factors, const std::vector<std::string>& products) {
        std::string text;
        for (std::size_t i = 0; i < factors.size(); ++i) {
            if (factors[i] == 0) continue;
            if (!text.empty()) text += " + ";
            text += "(" + number(factors[i]) + ")" + (products[i].empty() ? "" : "*" + products[i]);
        }
        return text.empty() ? "0" : text;
    }

    static Term primitiveText(const Quadric& q) {
        const glm::dvec3 &s = q.squares(), &p = q.products(), &l = q.linear();
        return "PolynomialSurface(" +
               sumText({s.x, s.y, s.z, p.x, p.y, p.z, l.x, l.y, l.z, q.constant()},
                       {"x^2", "y^2", "z^2", "x*y", "x*z", "y*z", "x", "y", "z", ""}) +
               ")";
    }

    static Term primitiveText(const Poly& poly) {
        if (poly.order() > orderLimit) return {};
        std::vector<std::string> products;
        for (int x = poly.order(); x >= 0; --x)
            for (int y = poly.order() - x; y >= 0; --y)
                for (int z = poly.order() - x - y; z >= 0; --z) {
                    std::string product;
                    const auto power = [&](const char* letter, int exponent) {
                        if (exponent > 0)
                            product += (product.empty() ? "" : "*") + std::string(letter) + "^" +
                                       std::to_string(exponent);
                    };
                    power("x", x);
                    power("y", y);
                    power("z", z);
                    products.push_back(product);
                }
        return "PolynomialSurface(" + sumText(poly.coefficients(), products) + ")";
    }

    static Term primitiveText(const Blob& blob) {
        if (!(blob.threshold() > 0)) return {};
        std::string text = "Blobby(" + number(blob.threshold());
        for (const BlobComponent& c : blob.components()) {
            if (!c.transform.identity() || !(c.radius > 0)) return {};
            const std::string end = number(c.radius) + ", " + number(c.strength) + ")";
            if (c.plane)
                text += ", Plane(" + point(c.from) + ", " + number(c.distance) + ", " + end;
            else if (c.from == c.to)
                text += ", Sphere(" + point(c.from) + ", " + end;
            else
                text += ", Cylinder(" + point(c.from) + ", " + point(c.to) + ", " + end;
        }
        // There must be two components; one without strength does nothing.
        if (blob.components().size() < 2) text += ", Sphere((0, 0, 0), 1, 0)";
        return text + ")";
    }

    std::span<const double> parameterTable_;
};

}  // namespace

std::string virtualightText(const Scene& scene) {
    std::string text = "// Made from a scene for POV-Ray. Camera, lights and textures are left out.\n";
    const Writer writer(*scene.parameterTable);
    for (const SceneObject& object : scene.objects) {
        const Term term = writer.term(*object.shape, {});
        if (!term)
            text += "// " + object.name + ": left out, it has no equivalent.\n";
        else if (term->starts_with("Shape"))
            text += *term + "\n";
        else
            text += "Solid [ " + *term + " ]\n";
    }
    return text;
}

}  // namespace isoscope
