// SPDX-License-Identifier: GPL-3.0-or-later
// A shape around a shape that only this test knows: whoever walks through shapes sees what it is made of.
#include <QTest>

#include "core/exchange/virtualight_writer.h"
#include "core/shapes/combined/bounded_shape.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/convex_intersection.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/composition.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/sphere.h"
#include "core/study/accuracy/scene_variant.h"
#include "core/study/view/isosurfaces_of.h"
#include "core/study/view/surface_bounds.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// The shape with a material for hits that have none, cut off by others.
class WrappingShape : public Shape {
  public:
    WrappingShape(ShapePointer shape, MaterialId material, std::vector<ShapePointer> limits = {})
        : shape_(std::move(shape)), material_(material), limits_(std::move(limits)) {}

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                   HitList& hits) const override {
        shape_->intersect(ray, interval, context, hits);
    }
    bool contains(const glm::dvec3& point, TraceContext& context) const override {
        return shape_->contains(point, context);
    }
    Bounds bounds() const override { return shape_->bounds(); }
    Composition composition() const override {
        return {.kind = Composition::Kind::wrapped,
                .parts = {&shape_, 1},
                .limits = limits_,
                .limitsCut = true,
                .material = material_};
    }
    ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const override {
        return std::make_shared<WrappingShape>(std::move(parts.front()), material_, std::move(limits));
    }

  private:
    ShapePointer shape_;
    MaterialId material_;
    std::vector<ShapePointer> limits_;
};

const std::string ball = "isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -3, 3 } } } ";

/// A scene whose only object is that of the text within a WrappingShape.
std::shared_ptr<const Scene> wrappedScene(const std::string& text) {
    auto scene = std::make_shared<Scene>(*studyScene(text).scene);
    ShapePointer& shape = scene->objects.at(0).shape;
    shape = std::make_shared<WrappingShape>(shape, 0);
    return scene;
}

ShapePointer sphere(double radius) { return std::make_shared<Sphere>(glm::dvec3(0), radius); }

std::vector<ShapePointer> list(std::span<const ShapePointer> shapes) {
    return {shapes.begin(), shapes.end()};
}

}  // namespace

class WrappingShapeTest : public QObject {
    Q_OBJECT

  private slots:
    void isosurfacesInsideAreFound() {
        const auto scene = wrappedScene(ball);
        const auto found = isosurfacesOf(scene->objects[0].shape);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0], scene->isosurfaces.at(0).shape);
    }

    void isosurfacesInsideAndInLimitsGetOtherSettings() {
        auto scene = std::make_shared<Scene>(*wrappedScene(ball + ball));
        ShapePointer& shape = scene->objects[0].shape;
        shape = std::make_shared<WrappingShape>(shape, 0, std::vector{scene->objects.at(1).shape});
        const auto variant = sceneVariant(
            *scene, [](const Isosurface&, IsosurfaceSettings& settings) { settings.accuracy = 0.5; });
        QVERIFY(dynamic_cast<const WrappingShape*>(variant->objects[0].shape.get()));
        const auto found = isosurfacesOf(variant->objects[0].shape);
        QCOMPARE(found.size(), std::size_t{2});
        for (const auto& surface : found) QCOMPARE(surface->settings().accuracy, 0.5);
    }

    void aVariantWithoutChangesIsTheSameShape() {
        const auto scene = wrappedScene("sphere { 0, 1 }");
        const auto variant = sceneVariant(*scene, [](const Isosurface&, IsosurfaceSettings&) {});
        QCOMPARE(variant->objects[0].shape, scene->objects[0].shape);
    }

    void theSurfaceInsideBoundsTheView() {
        const double reach = SurfaceBounds(wrappedScene(ball)).reach({1, 0, 0});
        QVERIFY2(reach >= 1 && reach <= 1.03, qPrintable(QString::number(reach)));
    }

    void virtualightGetsTheShapeAndItsLimits() {
        auto scene = std::make_shared<Scene>(*studyScene("sphere { 0, 1 }").scene);
        scene->objects[0].shape =
            std::make_shared<WrappingShape>(sphere(2), 0, std::vector<ShapePointer>{sphere(1)});
        const std::string text = virtualightText(*scene);
        QVERIFY2(text.find("(Shape [ Sphere((0, 0, 0), 2) ] & Shape [ Sphere((0, 0, 0), 1) ])") !=
                     std::string::npos,
                 text.c_str());
    }

    void theInverseIsThatOfTheShapeInside() {
        const ShapePointer inside = sphere(1);
        const ShapePointer inverse = inverseOf(std::make_shared<WrappingShape>(inside, 0));
        QVERIFY(dynamic_cast<const WrappingShape*>(inverse.get()));
        QCOMPARE(inverseOf(inverse)->composition().parts[0], inside);
        TraceContext context;
        QVERIFY(!inverse->contains(glm::dvec3(0), context));
        QVERIFY(inverse->contains(glm::dvec3(2), context));
    }

    void convexSolidsInsideAreIntersectedAtOnce() {
        const std::vector<ShapePointer> parts{std::make_shared<WrappingShape>(sphere(1), 7),
                                              std::make_shared<Box>(glm::dvec3(-0.5, -2, -2), glm::dvec3(2))};
        const auto convex = ConvexIntersection::of(parts);
        QVERIFY(convex.has_value());
        const std::vector<ShapePointer> limited{
            std::make_shared<WrappingShape>(sphere(1), 7, std::vector<ShapePointer>{sphere(2)}), parts[1]};
        QVERIFY(!ConvexIntersection::of(limited));
    }

    void shapesAroundShapesRebuildThemselves_data() {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 8; ++number) QTest::addRow("%d", number) << number;
    }
    void shapesAroundShapesRebuildThemselves() {
        QFETCH(int, number);
        const std::vector<ShapePointer> parts{sphere(2), sphere(1)};
        const std::vector<ShapePointer> limits{sphere(3)};
        const auto csg = [&](CsgOperation operation) { return std::make_shared<Csg>(operation, parts); };
        const std::array<ShapePointer, 8> shapes{
            std::make_shared<PlacedShape>(parts[0], Transform::translation({1, 2, 3}), 5),
            std::make_shared<InverseShape>(parts[0]),
            std::make_shared<ClippedShape>(parts[0], limits),
            std::make_shared<BoundedShape>(parts[0], limits),
            csg(CsgOperation::union_),
            csg(CsgOperation::merge),
            csg(CsgOperation::intersection),
            csg(CsgOperation::difference)};
        const Composition before = shapes.at(static_cast<std::size_t>(number))->composition();
        QVERIFY(before.kind != Composition::Kind::primitive);
        const ShapePointer again =
            shapes.at(static_cast<std::size_t>(number))->withParts(list(before.parts), list(before.limits));
        const Composition after = again->composition();
        QCOMPARE(after.kind, before.kind);
        QCOMPARE(list(after.parts), list(before.parts));
        QCOMPARE(list(after.limits), list(before.limits));
        QCOMPARE(after.limitsCut, before.limitsCut);
        QCOMPARE(after.transform != nullptr, before.transform != nullptr);
        if (before.transform) QVERIFY(after.transform->forward() == before.transform->forward());
        QCOMPARE(after.material, before.material);
    }
};

QTEST_GUILESS_MAIN(WrappingShapeTest)
#include "wrapping_shape_test.moc"
