// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/hole_map.h"

#include <QTest>

#include "core/study/accuracy/scene_variant.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string sphere(const std::string& settings) {
    return "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } " + settings + " }\n";
}

std::uint64_t total(const HoleMap& map) {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : map.counts) sum += count;
    return sum;
}

}  // namespace

class HoleMapTest : public QObject {
    Q_OBJECT

  private slots:
    void theRightSettingHasNoHoles() {
        const HoleMap map = holeMap(studyScene(sphere("max_gradient 2.4")));
        QVERIFY(map.complete);
        QCOMPARE(map.mistakes(), std::uint64_t(0));
        QVERIFY(map.count(HolePixel::right) > 1000 && map.count(HolePixel::background) > 1000);
        QCOMPARE(total(map), std::uint64_t(80 * 60));
    }

    void theDefaultSettingLosesTheNearSheet() {
        const HoleMap map = holeMap(studyScene(sphere("")));
        QVERIFY(map.mistakes() > 100 && map.count(HolePixel::wrongPlace) > 100);
        QCOMPARE(map.count(HolePixel::gained), std::uint64_t(0));
    }

    void aFarTooLowSettingLosesTheSurface() {
        const HoleMap map = holeMap(studyScene(sphere("max_gradient 0.3")));
        QVERIFY(map.count(HolePixel::lost) > 1000);
    }

    void theMapIsTheSameForAnyNumberOfThreads() {
        const RenderRequest request = studyScene(sphere("max_gradient 0.8"));
        QVERIFY(holeMap(request, 1).pixels == holeMap(request, 2).pixels);
    }

    void everyMistakeHasItsColour() {
        TracedView tested, truth;
        tested.width = truth.width = 5;
        tested.height = truth.height = 1;
        const HitKind kind = HitKind::crossing;
        tested.pixels = {{}, {true, kind, 2}, {}, {true, kind, 2}, {true, kind, 3}};
        truth.pixels = {{}, {true, kind, 2.001}, {true, kind, 2}, {}, {true, kind, 2}};
        const HoleMap map = compareViews(tested, truth, 0.01);
        const std::vector<HolePixel> wanted{HolePixel::background, HolePixel::right, HolePixel::lost,
                                            HolePixel::gained, HolePixel::wrongPlace};
        QVERIFY(map.pixels == wanted);
        const Image image = picture(map);
        for (std::size_t i = 0; i < 5; ++i)
            for (std::size_t j = i + 1; j < 5; ++j) QVERIFY(image.pixels[i] != image.pixels[j]);
        truth.width = 4;
        QCOMPARE(compareViews(tested, truth, 0.01).width, 0);
    }

    void aStopRequestEndsItIncomplete() {
        std::stop_source source;
        source.request_stop();
        QVERIFY(!holeMap(studyScene(sphere("")), 1, source.get_token()).complete);
        QVERIFY(!holeMap(RenderRequest{}).complete);
    }

    void variantsReachIsosurfacesInsideOthers() {
        const std::string part = sphere("max_gradient 3 rotate 20*x");
        const RenderRequest request =
            studyScene("difference { " + part + " box { 0, 2 } } union { " + part + " sphere { 3, 1 } } " +
                       sphere("clipped_by { plane { y, 0 } }"));
        int changed = 0;
        const auto variant =
            sceneVariant(*request.scene, [&](const Isosurface&, IsosurfaceSettings& settings) {
                settings.accuracy = 0.05;
                ++changed;
            });
        QCOMPARE(changed, 3);
        QCOMPARE(variant->isosurfaces.size(), std::size_t(3));
        for (const SceneIsosurface& isosurface : variant->isosurfaces)
            QCOMPARE(isosurface.shape->settings().accuracy, 0.05);
        // Nothing but the settings differs: the certified picture is the same.
        RenderRequest other = request;
        other.scene = variant;
        other.rootFinder = RootFinder::certified;
        RenderRequest same = request;
        same.rootFinder = RootFinder::certified;
        QCOMPARE(compareViews(traceView(other), traceView(same), 0.2).mistakes(), std::uint64_t(0));
    }
};

QTEST_APPLESS_MAIN(HoleMapTest)
#include "hole_map_test.moc"
