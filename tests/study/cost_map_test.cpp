// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/cost_map.h"

#include <numeric>
#include <QTest>

#include "core/render/render_image.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string ball(double maxGradient, const std::string& container) {
    return "isosurface { function { x*x + y*y + z*z - 1 } contained_by { " + container + " } max_gradient " +
           std::to_string(maxGradient) + " pigment { rgb 1 } }\n";
}
const std::string tight = "sphere { 0, 1.1 }";

std::uint64_t sumOf(const CauseCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}
double share(const CostMap& map, CostCause cause) {
    return static_cast<double>(map.totals[static_cast<std::size_t>(cause)]) /
           static_cast<double>(map.evaluations());
}
CostCause mainCause(const CauseCounts& counts) {
    return static_cast<CostCause>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

}  // namespace

/// What pixels cost, and why.
class CostMapTest : public QObject {
    Q_OBJECT

  private slots:
    void theSumsAreThoseOfThePicture() {
        for (const std::string& text : {ball(4, tight), ball(40, "box { -1.5, 1.5 }"),
                                        ball(4, tight) + "sphere { <0.5, 0.5, -1>, 0.3 }\n"}) {
            const RenderRequest request = studyScene(text, 70, 50);
            const CostMap map = costMap(request, 2);
            QVERIFY(map.complete);
            RenderStatistics statistics;
            renderImage(request, 1, &statistics);
            std::uint64_t primary = 0, pixels = 0;
            for (const StageReport& stage : statistics.stages)
                if (stage.kind == StageKind::primaryRays) primary += stage.evaluations;
            for (const CauseCounts& pixel : map.pixels) pixels += sumOf(pixel);
            QVERIFY(primary > 0);
            QCOMPARE(map.evaluations(), primary);
            QCOMPARE(pixels, primary);
            QCOMPARE(map.dearest, sumOf(*std::max_element(
                                      map.pixels.begin(), map.pixels.end(),
                                      [](const auto& a, const auto& b) { return sumOf(a) < sumOf(b); })));
        }
    }

    void aRayAlongTheSurfaceIsToldGrazing() {
        for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
            // Along x past the pole of the ball: one row of pixels grazes it, the middle one runs into it.
            RenderRequest request = studyScene(ball(2.4, "sphere { 0, 1.2 }"), 1, 2);
            request.rootFinder = finder;
            request.camera = {};
            request.camera.kind = CameraKind::orthographic;
            request.camera.location = {-5, 0.5, 0};
            request.camera.direction = {1, 0, 0};
            request.camera.right = {0, 0, 0.01};
            // Pixel centres at y = 1.001 and y = -0.001.
            request.camera.up = {0, 2.004, 0};
            const CostMap map = costMap(request, 1);
            QVERIFY(map.complete && map.pixels.size() == 2);
            QVERIFY(sumOf(map.pixels[0]) > 0 && sumOf(map.pixels[1]) > 0);
            QCOMPARE(mainCause(map.pixels[0]), CostCause::grazingRay);
            QCOMPARE(map.pixels[1][static_cast<std::size_t>(CostCause::grazingRay)], std::uint64_t(0));
        }
    }

    void aMaxGradientFarTooLargeIsToldSteep() {
        const CostMap fit = costMap(studyScene(ball(2.2, tight), 60, 45));
        const CostMap large = costMap(studyScene(ball(100, tight), 60, 45));
        QVERIFY(share(fit, CostCause::steepField) < 0.1);
        QVERIFY(share(large, CostCause::steepField) > 0.5);
        QVERIFY(large.evaluations() > 4 * fit.evaluations());
    }

    void aContainerFarTooLargeIsToldEmpty() {
        // The function has no larger slopes and values there, so that the container alone makes the
        // difference.
        const std::string body =
            "isosurface { function { min(sqrt(x*x + y*y + z*z) - 1, 0.3) } max_gradient "
            "1.1 pigment { rgb 1 } contained_by { ";
        const CostMap fit = costMap(studyScene(body + "sphere { 0, 1.01 } } }\n", 60, 45));
        const CostMap large = costMap(studyScene(body + "box { -3, 3 } } }\n", 60, 45));
        QVERIFY(share(fit, CostCause::emptySpace) < 0.1);
        QVERIFY(share(large, CostCause::emptySpace) > 0.4);
    }

    void jumpsAreTold() {
        const CostMap jump = costMap(studyScene(
            "isosurface { function { floor(3*x) + 0.5 } contained_by { box { -1, 1 } } max_gradient "
            "10 rotate y*50 }\n",
            60, 45));
        // The half of the container that shows nothing is empty space.
        QVERIFY(share(jump, CostCause::singularity) > 0.9 * (1 - share(jump, CostCause::emptySpace)));
        QVERIFY(share(jump, CostCause::singularity) > 0.1);
        const CostMap smooth = costMap(
            studyScene("isosurface { function { 3*x + 0.5 } contained_by { box { -1, 1 } } max_gradient "
                       "10 rotate y*50 }\n",
                       60, 45));
        QVERIFY(share(smooth, CostCause::singularity) < 0.01);
    }

    void whatHasNoFunctionCostsNothing() {
        const CostMap map = costMap(studyScene("sphere { 0, 1 }\n", 24, 18));
        QVERIFY(map.complete);
        QCOMPARE(map.evaluations(), std::uint64_t(0));
        const Image image = picture(map);
        QVERIFY(std::all_of(image.pixels.begin(), image.pixels.end(),
                            [](const auto& pixel) { return pixel == std::array<float, 3>{}; }));
    }

    void theSameForAnyNumberOfThreads() {
        const RenderRequest request = studyScene(ball(2, "box { -1.2, 1.2 }"), 70, 50);
        QVERIFY(costMap(request, 1).pixels == costMap(request, 3).pixels);
    }

    void aStopEndsIt() {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!costMap(studyScene(ball(2, tight), 24, 18), 0, stop.get_token()).complete);
        QVERIFY(!costMap({}).complete);
    }
};

QTEST_APPLESS_MAIN(CostMapTest)
#include "cost_map_test.moc"
