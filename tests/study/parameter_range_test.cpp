// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/range/parameter_range.h"

#include <cmath>
#include <QTest>

#include "core/study/range/scene_ranges.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr double step = 1.0 / 256;

std::shared_ptr<const Scene> sceneOf(const std::string& settings, const std::string& before = {}) {
    return studyScene(before + "isosurface { " + settings + " }\n").scene;
}

/// What is known of the number of this name, over a range.
ParameterRange rangeIn(const Scene& scene, const std::string& name, double low, double high) {
    for (const RangeSubject& subject : rangeSubjects(scene))
        if (scene.parameters[subject.parameter].name == name) return rangeOf(scene, subject, low, high);
    qCritical("there is no number of this name");
    return {};
}

}  // namespace

class ParameterRangeTest : public QObject {
    Q_OBJECT

  private slots:
    void aBallIsThereUntilItFillsTheBox() {
        const auto scene = sceneOf("function { f_sphere(x,y,z,0.5) } contained_by { box { -1, 1 } }");
        const ParameterRange range = rangeIn(*scene, scene->parameters[0].name, -1, 3);
        QCOMPARE(range.at(-0.5), SurfacePresence::outside);
        QCOMPARE(range.at(1), SurfacePresence::surface);
        QCOMPARE(range.at(2), SurfacePresence::inside);
        QCOMPARE(range.at(4), SurfacePresence::unknown);
        const auto shown = range.shown();
        QVERIFY(shown);
        QVERIFY(shown->first <= 0 && shown->first > -8 * step);
        QVERIFY(shown->second >= std::sqrt(3.0) && shown->second < std::sqrt(3.0) + 8 * step);
        QVERIFY(range.provenShare() > 0.97 && range.provenShare() < 1);
        // Without gaps, from end to end.
        QCOMPARE(range.pieces.front().low, -1.0);
        QCOMPARE(range.pieces.back().high, 3.0);
        for (std::size_t i = 1; i < range.pieces.size(); ++i)
            QCOMPARE(range.pieces[i].low, range.pieces[i - 1].high);
    }

    void theContainersCornersDoNotCountForABall() {
        const auto scene = sceneOf("function { f_sphere(x,y,z,0.5) } contained_by { sphere { 0, 1 } }");
        const auto shown = rangeIn(*scene, scene->parameters[0].name, -1, 3).shown();
        QVERIFY(shown && shown->second >= 1 && shown->second < 1.1);
    }

    void polarityTurnsInsideAndOutside() {
        const auto scene =
            sceneOf("function { f_sphere(x,y,z,0.5) } contained_by { box { -1, 1 } } polarity 1");
        const ParameterRange range = rangeIn(*scene, scene->parameters[0].name, -1, 3);
        QCOMPARE(range.at(-0.5), SurfacePresence::inside);
        QCOMPARE(range.at(2), SurfacePresence::outside);
    }

    void aTorusIsThereWhileItsTubeReachesNoCorner() {
        const auto scene = sceneOf("function { f_torus(x,y,z,0.8,0.2) } contained_by { box { -1, 1 } }");
        const auto shown = rangeIn(*scene, "Minor Radius", 0.1, 3).shown();
        // As far from the ring as the middles of top and bottom.
        const double farthest = std::hypot(0.8, 1.0);
        QVERIFY(shown && shown->first == 0.1);
        QVERIFY(shown->second >= farthest && shown->second < farthest + 8 * step * 3);
    }

    void theThresholdGoesFromTheLeastToTheLargestValue() {
        const auto scene = sceneOf(
            "function { cos(pi*x) + cos(pi*y) + cos(pi*z) } contained_by { box { -1.4, 2.4 } } threshold 1");
        const ParameterRange range = rangeIn(*scene, "threshold", -8, 8);
        const auto shown = range.shown();
        QVERIFY(shown && std::abs(shown->first + 3) < 0.13 && std::abs(shown->second - 3) < 0.13);
        QVERIFY(shown->first <= -3 && shown->second >= 3);
        QCOMPARE(range.at(-4), SurfacePresence::outside);
        QCOMPARE(range.at(4), SurfacePresence::inside);
    }

    void declaredNumbersAreAskedAboutToo() {
        const auto scene = sceneOf("function { x*x + y*y + z*z - R*R } contained_by { box { -1, 1 } }",
                                   "#declare R = 0.5;\n");
        const auto shown = rangeIn(*scene, "R", -4, 4).shown();
        QVERIFY(shown && std::abs(shown->first + std::sqrt(3)) < 0.1 &&
                std::abs(shown->second - std::sqrt(3)) < 0.1);
    }

    void aSurfaceThatIsNeverThereHasNoRange() {
        const auto scene = sceneOf("function { f_sphere(x-9,y,z,0.5) } contained_by { box { -1, 1 } }");
        const ParameterRange range = rangeIn(*scene, scene->parameters[0].name, 0, 2);
        QVERIFY(!range.shown());
        QCOMPARE(range.provenShare(), 0.0);
        QCOMPARE(range.pieces.size(), std::size_t(1));
    }

    /// What is undefined everywhere has no surface; what is not known is not excluded.
    void undefinedFunctionsAndBadRanges() {
        const auto scene =
            sceneOf("function { sqrt(f_sphere(x,y,z,0.5) - 9) } contained_by { box { -1, 1 } }");
        QCOMPARE(rangeIn(*scene, scene->parameters[0].name, 0, 1).at(0.5), SurfacePresence::outside);
        QVERIFY(rangeIn(*scene, scene->parameters[0].name, 2, 1).pieces.empty());
        QVERIFY(rangeIn(*scene, scene->parameters[0].name, 0, std::nan("")).pieces.empty());
        std::stop_source stop;
        stop.request_stop();
        const ParameterRange range = rangeOf(*scene, rangeSubjects(*scene)[0], 0, 1, {}, stop.get_token());
        QCOMPARE(range.pieces.size(), std::size_t(1));
        QCOMPARE(range.pieces[0].presence, SurfacePresence::unknown);
    }

    /// A hundred points at random keep what is said of a function with many terms.
    void whatIsSaidHoldsAtSamples() {
        const auto scene = sceneOf(
            "function { f_torus(x,y,z,0.8,0.2) * f_sphere(x,y-0.5,z,0.3) - 0.02 } "
            "contained_by { box { -1.2, 1.2 } }");
        for (const RangeSubject& subject : rangeSubjects(*scene)) {
            const SceneParameter& parameter = scene->parameters[subject.parameter];
            const ParameterRange range = rangeOf(*scene, subject);
            for (int i = 0; i < 25; ++i) {
                const double value =
                    parameter.minimum + (parameter.maximum - parameter.minimum) * (i + 0.5) / 25;
                std::vector<double> table = *scene->parameterTable;
                const Isosurface& surface = *scene->isosurfaces[0].shape;
                double level = surface.settings().threshold;
                (subject.slot < 0 ? level : table[static_cast<std::size_t>(subject.slot)]) = value;
                PointEvaluator values(surface.prepared(table));
                bool below = false, above = false;
                for (double x = -1.2; x <= 1.2; x += 0.2)
                    for (double y = -1.2; y <= 1.2; y += 0.2)
                        for (double z = -1.2; z <= 1.2; z += 0.2)
                            (values.evaluate(x, y, z) < level ? below : above) = true;
                if (below && above)
                    QVERIFY(range.at(value) == SurfacePresence::surface ||
                            range.at(value) == SurfacePresence::unknown);
                if (range.at(value) == SurfacePresence::outside) QVERIFY(!below);
            }
        }
    }
};

QTEST_MAIN(ParameterRangeTest)
#include "parameter_range_test.moc"
