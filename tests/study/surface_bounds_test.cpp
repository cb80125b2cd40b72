// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/surface_bounds.h"

#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/render/render_image.h"
#include "core/study/view/fitted_view.h"
#include "tests/support/study_scene.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(161803);

std::shared_ptr<const Scene> sceneOf(const std::string& text) { return studyScene(text).scene; }

}  // namespace

class SurfaceBoundsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void isTheSurfaceNotItsContainer_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        const auto row = [](const char* name, const char* text, double least, double most) {
            QTest::newRow(name) << QString(text) << least << most;
        };
        // How far along x.
        row("small in a large box",
            "isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -3, 3 } } }", 1, 1.03);
        row("cut by the container",
            "isosurface { function { x*x + y*y + z*z - 4 } contained_by { box { -1, 1 } } }", 1, 1);
        row("cut and open",
            "isosurface { function { x*x + y*y + z*z - 4 } contained_by { box { -1.5, 1.5 } } open }", 1.5,
            1.5);
        row("open, and out of the container",
            "isosurface { function { x*x + y*y + z*z - 4 } contained_by { box { -1, 1 } } open }", -INFINITY,
            -INFINITY);
        row("nothing", "isosurface { function { x*x + y*y + z*z + 1 } contained_by { box { -3, 3 } } }",
            -INFINITY, -INFINITY);
        row("turned and moved",
            "isosurface { function { x*x + y*y/4 + z*z - 1 } contained_by { box { -3, 3 } } rotate z*90 "
            "translate x*5 }",
            7, 7.04);
        row("plane ignored", "plane { y, -1 } sphere { 0, 1 }", 1, 1);
        row("plane alone", "plane { y, -1 }", INFINITY, INFINITY);
        row("sky ignored", "sphere { 0, 1000 } sphere { 0, 1 }", 1, 1);
        row("intersection", "intersection { sphere { 0, 2 } plane { x, 1 } box { -3, 3 } }", 1, 1);
        row("difference", "difference { torus { 2, 0.5 } sphere { 5, 1 } }", 2.5, 2.5);
        row("cone", "cone { 0, 1, <2, 0, 0>, 0.5 translate y }", 2, 2);
        row("clipped", "sphere { 0, 2 clipped_by { box { -1, 1 } } }", 1, 1);
        row("difference with a clipped part",
            "difference { box { -1, 1 } sphere { 0, 0.5 clipped_by { plane { y, 0 } } } }", 1, 1);
        row("clipped by the outside of a clipped ball",
            "sphere { 0, 1 clipped_by { sphere { 0, 0.5 inverse clipped_by { plane { y, 0 } } } } }", 1, 1);
    }
    void isTheSurfaceNotItsContainer() {
        QFETCH(QString, text);
        QFETCH(double, least);
        QFETCH(double, most);
        SurfaceBounds surfaces(sceneOf(text.toStdString()));
        const double reach = surfaces.reach({1, 0, 0});
        QVERIFY2(reach >= least && reach <= most + 1e-9, qPrintable(QString::number(reach)));
    }

    /// No point that a ray meets lies farther than what is said of its direction.
    void holdsEveryPointOfTheSurface() {
        const auto scene = sceneOf(
            "isosurface { function { f_heart(x, y, z, -1) + 0.2*f_noise3d(4*x, 4*y, 4*z) - 0.1 } "
            "contained_by { sphere { 0, 1.5 } } max_gradient 90 rotate <20, 30, 40> scale <1, 2, 1> }");
        SurfaceBounds surfaces(scene);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        const auto direction = [&] {
            return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        };
        TraceContext context(scene->parameterTable, RootFinder::certified);
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 from = 6.0 * direction();
            std::vector<NearestHit> nearest(1);
            const Ray ray{from, glm::normalize(0.8 * direction() - from)};
            scene->objects.front().shape->nearest({&ray, 1}, context, nearest);
            if (nearest[0].found) points.push_back(nearest[0].hit.point);
        }
        QVERIFY(points.size() > 300);
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 n = direction();
            double farthest = -INFINITY;
            for (const glm::dvec3& p : points) farthest = std::max(farthest, glm::dot(n, p));
            const double reach = surfaces.reach(n);
            QVERIFY2(reach >= farthest, qPrintable(QString("%1 < %2").arg(reach).arg(farthest)));
            QVERIFY2(reach <= farthest + 0.25, qPrintable(QString("%1 > %2").arg(reach).arg(farthest)));
        }
        qInfo("%llu boxes for 20 directions", static_cast<unsigned long long>(surfaces.boxes()));
    }

    void fitsTheScarcerSide_data() {
        QTest::addColumn<QString>("camera");
        for (const char* kind : {"", "orthographic", "right <-2, 0.3, 0> up <0.2, 1, 0>"})
            QTest::newRow(kind) << QString(kind);
    }
    void fitsTheScarcerSide() {
        QFETCH(QString, camera);
        const ParseResult parsed = parseScene("#version 3.7; camera { " + camera.toStdString() +
                                              " location <3, 2, -5> look_at <9, 9, 9> }\n"
                                              "isosurface { function { x*x/9 + y*y + z*z - 1 } contained_by "
                                              "{ box { -5, 5 } } translate <7, 8, -9> }");
        SurfaceBounds surfaces(parsed.scene);
        const Camera& own = parsed.scene->camera;
        const auto fitted = fittedView(own, own, surfaces);
        QVERIFY(fitted);
        // How far from the middle of the picture its outermost points lie, in parts of it.
        double across = 0, upwards = 0;
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        for (int i = 0; i < 100'000; ++i) {
            const glm::dvec3 p = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
            const glm::dvec3 way = glm::dvec3(7, 8, -9) + glm::dvec3(3, 1, 1) * p - fitted->location;
            const glm::dmat3 axes(fitted->right, fitted->up, fitted->direction);
            glm::dvec3 place = glm::inverse(axes) * way;
            QVERIFY(place.z > 0);
            if (fitted->kind == CameraKind::perspective) place /= place.z;
            across = std::max(across, std::abs(place.x));
            upwards = std::max(upwards, std::abs(place.y));
        }
        const double share = 2 * std::max(across, upwards);
        QVERIFY2(share <= fittedShare && share > fittedShare - 0.03, qPrintable(QString::number(share)));
        if (camera.isEmpty()) QCOMPARE(fitted->direction, own.direction);
    }

    void standardViewsLookAlongAxes() {
        Camera camera;
        camera.location = {3, 4, -5};
        camera = camera.lookingAt({0, 0, 0});
        const auto looks = [&](StandardView view, const glm::dvec3& ahead, const glm::dvec3& up) {
            const Camera turned = turnedTo(camera, view);
            QVERIFY(glm::length(glm::normalize(turned.direction) - ahead) < 1e-9);
            QVERIFY(glm::length(glm::normalize(turned.up) - up) < 1e-9);
            QCOMPARE(turned.location, camera.location);
        };
        looks(StandardView::front, {0, 0, 1}, {0, 1, 0});
        looks(StandardView::top, {0, -1, 0}, {0, 0, 1});
        looks(StandardView::side, {-1, 0, 0}, {0, 1, 0});
        camera.sky = {0, 0, 1};
        looks(StandardView::front, {0, 1, 0}, {0, 0, 1});
        looks(StandardView::top, {0, 0, -1}, {0, 1, 0});
    }

    void nothingIsNotFitted() {
        for (const char* text : {"", "plane { y, 0 }", "isosurface { function { 1 } }"}) {
            const auto scene = sceneOf(text);
            SurfaceBounds surfaces(scene);
            QVERIFY(!fittedView(scene->camera, scene->camera, surfaces));
        }
    }
};

QTEST_APPLESS_MAIN(SurfaceBoundsTest)
#include "surface_bounds_test.moc"
