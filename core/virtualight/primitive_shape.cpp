// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/primitive_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/point_evaluator.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/patches/height_field.h"
#include "core/shapes/patches/polygon.h"
#include "core/shapes/patches/triangle.h"
#include "core/shapes/solids/blob.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/disc.h"
#include "core/shapes/solids/lathe.h"
#include "core/shapes/solids/poly.h"
#include "core/shapes/solids/prism.h"
#include "core/shapes/solids/quadric.h"
#include "core/shapes/solids/sphere.h"
#include "core/shapes/solids/superellipsoid.h"
#include "core/shapes/solids/torus.h"
#include "core/virtualight/grids.h"
#include "core/virtualight/profile_curve.h"

namespace isoscope::virtualight {

namespace {

/// Draws one primitive, by its kind.
class Drawer {
  public:
    Drawer(const ShapeModifiers& modifiers, std::span<const double> parameterTable,
           const std::stop_token& stop)
        : modifiers_(modifiers), parameterTable_(parameterTable), stop_(stop) {}

    DrawnPrimitive operator()(const SphereShape& s) const {
        return just(std::make_shared<Sphere>(s.center, s.radius));
    }
    DrawnPrimitive operator()(const BoxShape& b) const {
        return just(std::make_shared<Box>(b.first, b.second));
    }
    DrawnPrimitive operator()(const ConeShape& c) const {
        return just(std::make_shared<Cone>(c.base, c.baseRadius, c.apex, c.apexRadius, true));
    }
    DrawnPrimitive operator()(const DiskShape& d) const {
        return just(std::make_shared<Disc>(d.center, d.normal, d.radius, d.hole));
    }
    DrawnPrimitive operator()(const TorusShape& t) const {
        return {std::make_shared<Torus>(t.major, t.minor, choice()),
                turning({0, 1, 0}, t.axis).then(Transform::translation(t.center)),
                {},
                {}};
    }
    DrawnPrimitive operator()(const ParaboloidShape& p) const {
        // x^2 + z^2 = radius^2 y / height, cut off at the open end.
        const double height = glm::distance(p.vertex, p.end), r = p.radius;
        ShapePointer quadric = std::make_shared<Quadric>(glm::dvec3(1, 0, 1), glm::dvec3(0),
                                                         glm::dvec3(0, -r * r / height, 0), 0);
        const double wide = 1.001 * r;
        ShapePointer room =
            std::make_shared<Box>(glm::dvec3(-wide, -0.001 * height, -wide), glm::dvec3(wide, height, wide));
        return {std::make_shared<ClippedShape>(quadric, std::vector{room}),
                turning({0, 1, 0}, p.end - p.vertex).then(Transform::translation(p.vertex)),
                {},
                {}};
    }
    DrawnPrimitive operator()(const SuperquadricShape& s) const {
        return just(std::make_shared<Superellipsoid>(s.w, s.h));
    }
    DrawnPrimitive operator()(const PolygonShape& p) const {
        return just(std::make_shared<Polygon>(p.points));
    }
    DrawnPrimitive operator()(const TrianglePatch& p) const {
        return just(std::make_shared<Triangle>(p.corners, p.normals));
    }
    DrawnPrimitive operator()(const BlobbyShape& b) const {
        std::vector<BlobComponent> components;
        for (const BlobbyPart& part : b.parts) components.push_back(componentOf(part));
        return just(std::make_shared<Blob>(std::move(components), b.threshold, choice()));
    }
    DrawnPrimitive operator()(const ExtrudedShape& e) const {
        PrismStyle style;
        style.outwardCaps = true;
        // A closed profile makes a solid, any other one a ribbon.
        style.open = !e.profile.closed();
        return {std::make_shared<Prism>(piecesOf(e.profile), 0, glm::length(e.direction), style),
                extrusionPlace(e.direction),
                {},
                {}};
    }
    DrawnPrimitive operator()(const RevolvedShape& r) const {
        return {std::make_shared<Lathe>(piecesOf(r.profile), choice()), turning({0, 1, 0}, r.axis), {}, {}};
    }
    DrawnPrimitive operator()(const ImplicitShape& i) const {
        if (!modifiers_.bound)
            return {nullptr,
                    {},
                    "An ImplicitSurface needs a Bound that limits its region.",
                    "write `Bound((x1, y1, z1), (x2, y2, z2))` behind it"};
        IsosurfaceSettings settings;
        settings.maxTrace = 10;  // VirtuaLight knows no such limit; more there are not
        settings.function = i.function;
        const auto& [low, high] = *modifiers_.bound;
        settings.container = ContainerBox{low, high};
        settings.open = true;
        settings.certifiedOnly = true;
        settings.maxGradient = estimatedGradient(i.function, *modifiers_.bound, parameterTable_);
        return just(std::make_shared<Isosurface>(settings));
    }
    DrawnPrimitive operator()(const PolynomialShape& p) const {
        return just(std::make_shared<Poly>(p.order, p.coefficients, choice()));
    }
    DrawnPrimitive operator()(const ImageField& field) const {
        if (field.spherical) return meshOf(field, glm::dvec3(0.31, 0.83, 0.46));
        // The raw values of the pixels are the heights.
        return {std::make_shared<HeightField>(heightsOf(field), 0.0, field.smooth),
                Transform::scaling({1, field.raster.largest, 1}),
                {},
                {}};
    }
    DrawnPrimitive operator()(const ImplicitSphericalField& field) const {
        return meshOf(field, glm::dvec3(0.31, 0.83, 0.46));
    }
    DrawnPrimitive operator()(const ImplicitPlanarField& field) const { return meshOf(field, {}); }
    DrawnPrimitive operator()(const BicubicShape& patch) const { return meshOf(patch, {}); }
    DrawnPrimitive operator()(const NurbsShape& nurbs) const { return meshOf(nurbs, {}); }
    DrawnPrimitive operator()(const ParametricShape& surface) const { return meshOf(surface, {}); }

  private:
    /// Where the text names no solver, the roots that Vieta's, the default, is meant to find, without its
    /// gaps.
    RootChoice choice() const {
        if (modifiers_.solver == Solver::ferrari) return RootChoice::ferrari;
        return modifiers_.solver == Solver::vieta ? RootChoice::vieta : RootChoice::isolation;
    }

    static DrawnPrimitive just(ShapePointer shape) { return {std::move(shape), {}, {}, {}}; }

    DrawnPrimitive meshOf(const Primitive& primitive, std::optional<glm::dvec3> insideDirection) const {
        const SurfaceGrid grid = *gridOf(primitive, modifiers_, stop_);
        if (stop_.stop_requested()) return {};
        ShapePointer mesh = grid.mesh(insideDirection);
        if (!mesh) return {nullptr, {}, "No point of this surface has a finite place.", {}};
        return just(std::move(mesh));
    }

    static BlobComponent componentOf(const BlobbyPart& part) {
        BlobComponent component;
        component.from = part.from;
        component.to = part.to;
        component.radius = part.radius;
        component.strength = part.strength;
        if (part.kind == BlobbyPart::Kind::plane) {
            // The distance is that of the equation normal . p = distance, whatever the length of the normal.
            const double length = glm::length(part.from);
            component.plane = true;
            component.from = component.to = part.from / length;
            component.distance = part.distance / length;
        }
        return component;
    }

    const ShapeModifiers& modifiers_;
    std::span<const double> parameterTable_;
    const std::stop_token& stop_;
};

}  // namespace

DrawnPrimitive drawPrimitive(const Primitive& primitive, const ShapeModifiers& modifiers,
                             std::span<const double> parameterTable, const std::stop_token& stop) {
    DrawnPrimitive drawn = std::visit(Drawer(modifiers, parameterTable, stop), primitive);
    const bool bounded = modifiers.bound && !std::holds_alternative<ImplicitShape>(primitive);
    if (!drawn.shape || !bounded) return drawn;
    if (!drawn.place.identity()) drawn.shape = std::make_shared<PlacedShape>(drawn.shape, drawn.place);
    drawn.place = {};
    const ShapePointer room = std::make_shared<Box>((*modifiers.bound)[0], (*modifiers.bound)[1]);
    drawn.shape = std::make_shared<ClippedShape>(drawn.shape, std::vector{room});
    return drawn;
}

double estimatedGradient(const Function& function, const std::array<glm::dvec3, 2>& box,
                         std::span<const double> parameterTable) {
    constexpr int steps = 24;
    constexpr std::size_t side = steps + 1;
    static_assert(side * side * side == gradientPoints);
    std::array<std::vector<double>, 3> places;
    for (std::size_t i = 0; i < side * side * side; ++i) {
        const std::array<std::size_t, 3> index{i % side, i / side % side, i / (side * side)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<int>(axis);
            places[axis].push_back(box[0][a] +
                                   static_cast<double>(index[axis]) / steps * (box[1][a] - box[0][a]));
        }
    }
    std::vector<double> values(places[0].size());
    PointEvaluator(Tape::compile(function), parameterTable).evaluate(places[0], places[1], places[2], values);
    double steepest = 0;
    const glm::dvec3 step = (box[1] - box[0]) / static_cast<double>(steps);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::array<std::size_t, 3> index{i % side, i / side % side, i / (side * side)};
        const std::array<std::size_t, 3> stride{1, side, side * side};
        glm::dvec3 slope(0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (index[axis] + 1 < side)
                slope[static_cast<int>(axis)] =
                    (values[i + stride[axis]] - values[i]) / step[static_cast<int>(axis)];
        const double length = glm::length(slope);
        if (std::isfinite(length)) steepest = std::max(steepest, length);
    }
    return std::clamp(1.5 * steepest, 0.1, 1e6);
}

Transform extrusionPlace(const glm::dvec3& direction) {
    // The prism's x, height and z become x, z and y.
    glm::dmat4 swapped(0);
    swapped[0].x = swapped[1].z = swapped[2].y = swapped[3].w = 1;
    return Transform::matrix(swapped).then(turning({0, 0, 1}, direction));
}

}  // namespace isoscope::virtualight
