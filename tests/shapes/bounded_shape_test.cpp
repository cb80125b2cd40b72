// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/bounded_shape.h"

#include <QTest>

#include "core/language/parse.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"

using namespace isoscope;

namespace {

/// Whether trace() finds the object on a ray along z; a small sphere is set where it does, and else at 0.
bool traceFinds(const QString& object, double x) {
    const ParseResult parsed = parseScene(QString("#declare O = %1 sphere { trace(O, <%2, 0, -5>, z), 0.25 }")
                                              .arg(object)
                                              .arg(x)
                                              .toStdString());
    return parsed.ok() && parsed.scene->objects.size() == 1 &&
           std::abs(parsed.scene->objects[0].shape->bounds().low.x - (x - 0.25)) < 1e-9;
}

/// z of the first hit of a ray along z from z = -5 with the only object of the text; NaN for none.
double alongZ(const Scene& scene, double x, double y) {
    if (scene.objects.size() != 1) return 1e9;
    TraceContext context;
    const Ray ray{{x, y, -5}, {0, 0, 1}};
    NearestHit hit;
    scene.objects[0].shape->nearest({&ray, 1}, context, {&hit, 1});
    return hit.found ? hit.hit.point.z : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

class BoundedShapeTest : public QObject {
    Q_OBJECT

  private slots:
    /// What trace() of POV-Ray 3.7.0.10 answers about these objects.
    void raysThatMissTheBoundsMissTheObject_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<double>("missX");
        QTest::addColumn<double>("meetX");
        const auto row = [](const char* object, double missX, double meetX) {
            QTest::newRow(object) << object << missX << meetX;
        };
        row("sphere { 0, 1 bounded_by { box { -0.5, 0.5 } } }", 0.7, 0.3);
        row("merge { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -0.5, 0.5 } } }", 0.7, 0.3);
        row("intersection { sphere { 0, 1 } plane { x, 1 } bounded_by { box { -0.5, 0.5 } } }", 0.7, 0.3);
        row("plane { z, 0 bounded_by { box { -0.5, 0.5 } } }", 0.7, 0.3);
        row("quadric { 1, 0, 0, -1 bounded_by { box { -0.5, 0.5 } } }", 0.7, 0.3);
        row("difference { sphere { 0, 1 } plane { x, -2 } bounded_by { sphere { 0, 0.5 } } }", 0.7, 0.3);
        row("blob { threshold 0.5 sphere { 0, 1.5, 1 } bounded_by { sphere { 0, 0.2 } } }", 0.4, 0.1);
        row("sphere { 0, 1 clipped_by { plane { x, 0.5 } } bounded_by { clipped_by } }", 0.7, 0.3);
        row("sphere { 0, 1 bounded_by { box { -1, <0.5, 1, 1> } } clipped_by { bounded_by } }", 0.7, 0.3);
        row("object { cylinder { -y, y, 1 bounded_by { sphere { 0, 0.5 } } } scale 2 }", 1.4, 0.7);
        row("sphere { 0, 1 bounded_by { sphere { 0, 1 } } translate 0.5*x bounded_by { box { -0.5, 0.5 } } }",
            0.7, 0.3);
    }
    void raysThatMissTheBoundsMissTheObject() {
        QFETCH(QString, object);
        QFETCH(double, missX);
        QFETCH(double, meetX);
        QVERIFY(!traceFinds(object, missX));
        QVERIFY(traceFinds(object, meetX));
    }

    /// Measured on POV-Ray 3.7's pictures of each of its shapes: some are drawn without their bounds.
    void boundsOfSomeShapesAreNotSeen_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<bool>("seen");
        const auto row = [](const char* object, bool seen) { QTest::newRow(object) << object << seen; };
        row("sphere { 0, 1 %1 }", false);
        row("box { -1, 1 %1 }", false);
        row("plane { z, 0 %1 }", false);
        row("blob { threshold 0.5 sphere { 0, 1.5, 1 } %1 }", false);
        row("mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 2, 0> } %1 }", false);
        row("mesh2 { vertex_vectors { 3, <-1, -1, 0>, <1, -1, 0>, <0, 2, 0> } face_indices { 1, <0, 1, 2> } "
            "%1 }",
            false);
        row("triangle { <-1, -1, 0>, <1, -1, 0>, <0, 2, 0> %1 }", false);
        row("smooth_triangle { <-1, -1, 0>, -z, <1, -1, 0>, -z, <0, 2, 0>, -z %1 }", false);
        row("disc { 0, z, 1 %1 }", false);
        row("polygon { 4, <-1, -1>, <1, -1>, <1, 1>, <-1, 1> %1 }", false);
        row("height_field { function 20, 20 { 0.5 } rotate -90*x translate <-0.5, -0.5, 0> scale 2 %1 }",
            false);
        row("julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 6 precision 30 %1 }",
            false);
        row("object { sphere { 0, 1 %1 } }", false);
        row("sphere { 0, 1 clipped_by { box { -2, 2 } } %1 }", false);
        row("cylinder { -y, y, 1 %1 }", true);
        row("cone { -y, 1, y, 0.9 %1 }", true);
        row("torus { 0.5, 0.3 rotate 90*x %1 }", true);
        row("quadric { 1, 0, 0, -1 %1 }", true);
        row("poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> %1 }", true);
        row("superellipsoid { <0.5, 0.5> %1 }", true);
        row("lathe { linear_spline 3, <0, -1>, <1, 0>, <0, 1> %1 }", true);
        row("sor { 4, <0.5, -1.5>, <1, -1>, <1, 1>, <0.5, 1.5> %1 }", true);
        row("prism { -1, 1, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> %1 }", true);
        row("sphere_sweep { linear_spline 2, <-1, 0, 0>, 0.5, <1, 0, 0>, 0.5 %1 }", true);
        row("isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -1.1, 1.1 } } max_gradient 4 "
            "%1 }",
            true);
        row("merge { sphere { 0, 1 } sphere { 0.2*x, 1 } %1 }", true);
        row("intersection { sphere { 0, 1 } sphere { 0.2*x, 1 } %1 }", true);
        row("difference { sphere { 0, 1 } sphere { 5*x, 1 } %1 }", true);
        row("intersection { sphere { 0, 1 %1 } sphere { 0, 5 } }", true);
        row("difference { sphere { 0, 1 %1 } sphere { 5*x, 1 } }", true);
        row("merge { sphere { 0, 1 %1 } sphere { 0, 0.1 } }", true);
    }
    void boundsOfSomeShapesAreNotSeen() {
        QFETCH(QString, object);
        QFETCH(bool, seen);
        const auto hit = [&](const char* bounds) {
            const ParseResult parsed = parseScene(object.arg(bounds).toStdString());
            return parsed.ok() && !std::isnan(alongZ(*parsed.scene, -0.7, -0.2));
        };
        QVERIFY(hit(""));
        QCOMPARE(hit("bounded_by { box { -0.5, 0.5 } }"), !seen);
    }

    /// As in POV-Ray's pictures: of parts that coincide the last shows where the union has bounds.
    void theLastPartOfABoundedUnionShows() {
        const auto firstObject = [](const char* bounds) {
            const ParseResult parsed =
                parseScene(std::string("union { box { -1, 1 } sphere { 0, 1 } ") + bounds + " }");
            return parsed.scene->objects.at(0).name;
        };
        QCOMPARE(firstObject(""), std::string("box"));
        QCOMPARE(firstObject("bounded_by { box { -3, 3 } }"), std::string("sphere"));
    }

    /// Seen by POV-Ray too: the ray meets the box, so it meets the sphere where that sticks out.
    void whatSticksOutIsMet() {
        const ParseResult parsed = parseScene("cylinder { -y, y, 1 bounded_by { box { -0.5, 0.5 } } }");
        QVERIFY(std::abs(alongZ(*parsed.scene, 0.3, 0) + 0.9539392014169457) < 1e-12);
    }

    void aRayThatStartsInTheBoundsPasses() {
        const BoundedShape shape(std::make_shared<Plane>(glm::dvec3(0, 0, 1), 3),
                                 {std::make_shared<Sphere>(glm::dvec3(0), 1)});
        TraceContext context;
        const std::vector<Ray> rays{{{0, 0, 0}, {0, 0, 1}}, {{2, 0, 0}, {0, 0, 1}}};
        std::vector<NearestHit> found(2);
        shape.nearest(rays, context, found);
        QVERIFY(found[0].found && found[0].hit.t == 3);
        QVERIFY(!found[1].found);
        std::vector<HitList> all(2);
        shape.allHits(rays, context, all);
        QCOMPARE(all[0].size(), 1U);
        QCOMPARE(all[1].size(), 0U);
    }

    void insideDoesNotDependOnBounds() {
        const ParseResult parsed = parseScene("sphere { 0, 1 bounded_by { box { -0.5, 0.5 } } }");
        TraceContext context;
        QVERIFY(parsed.scene->objects[0].shape->contains({0.9, 0, 0}, context));
    }

    /// Right bounds around finite shapes cost nothing.
    void boundsWithoutEffectAreLeftOut() {
        const ShapePointer ball = std::make_shared<Sphere>(glm::dvec3(0), 1);
        QCOMPARE(boundedBy(ball, {std::make_shared<Box>(glm::dvec3(-1), glm::dvec3(1))}), ball);
        QCOMPARE(boundedBy(ball, {std::make_shared<Sphere>(glm::dvec3(0), 2)}), ball);
        QVERIFY(boundedBy(ball, {std::make_shared<Sphere>(glm::dvec3(0), 1.5)}) != ball);
        const auto cone = [](double height, bool open) {
            return std::make_shared<Cone>(glm::dvec3(0, -height, 0), 2, glm::dvec3(0, height, 0), 2, open);
        };
        QCOMPARE(boundedBy(ball, {cone(1.1, false)}), ball);
        QVERIFY(boundedBy(ball, {cone(0.9, false)}) != ball);
        QVERIFY(boundedBy(ball, {cone(1.1, true)}) != ball);
    }

    void boundsMakeInfiniteShapesFinite() {
        const ParseResult parsed = parseScene("quadric { <1, 1, 0>, 0, 0, -1 bounded_by { box { -2, 2 } } }");
        const Bounds bounds = parsed.scene->objects[0].shape->bounds();
        QCOMPARE(bounds.low, glm::dvec3(-2));
        QCOMPARE(bounds.high, glm::dvec3(2));
    }

    /// The parts stay objects of their own, each within the bounds.
    void boundsOfAUnionHoldForItsParts() {
        const ParseResult parsed = parseScene(
            "union { plane { y, -1 no_shadow } sphere { 0, 1 } bounded_by { box { -1, 1 } } "
            "translate 3*x }");
        QVERIFY(parsed.ok());
        const Scene& scene = *parsed.scene;
        QCOMPARE(scene.objects.size(), 2U);
        QVERIFY(scene.objects[0].castsShadow && !scene.objects[1].castsShadow);
        QVERIFY(!dynamic_cast<const BoundedShape*>(scene.objects[0].shape.get()));
        QCOMPARE(scene.objects[1].shape->bounds().low, glm::dvec3(2, -1, -1));
    }
};

QTEST_APPLESS_MAIN(BoundedShapeTest)
#include "bounded_shape_test.moc"
