// SPDX-License-Identifier: GPL-3.0-or-later
// The knee, and POV-Ray's time: by counts, so that they are the same on every run.
#include "core/study/accuracy/cost_survey.h"

#include <QTest>

#include "tests/support/study_case.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr auto povray = static_cast<std::size_t>(RootFinder::lipschitz);
constexpr auto certified = static_cast<std::size_t>(RootFinder::certified);

CostSurvey surveyOf(const std::string& text, StudiedSetting setting, double low, double high,
                    std::size_t isosurface = 0) {
    CostSurvey survey({studyScene(text, 800, 600), isosurface, setting, surveyValues(low, high)});
    while (survey.next()) {
    }
    return survey;
}

const std::string sphere =
    "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } max_gradient 2.4 "
    "pigment { rgb 1 } }";

const CostPoint& pointAt(const CostSurvey& survey, double setting) {
    for (const CostPoint& point : survey.points())
        if (point.setting == setting) return point;
    qFatal("no such value");
}

FunctionWork workIn(const std::string& function) {
    const RenderRequest written =
        studyScene("isosurface { function { " + function + " } contained_by { box { -2, 2 } } }");
    return workOf(written.scene->isosurfaces[0], *written.scene->parameterTable);
}

}  // namespace

class CostSurveyTest : public QObject {
    Q_OBJECT

  private slots:
    void valuesAreTheDecadesCoarseFirst() {
        const std::vector<double> values = surveyValues(1e-6, 1);
        QCOMPARE(values.size(), std::size_t(7));
        QCOMPARE(values[0], 1e-6);
        QCOMPARE(values[1], 1.0);
        QCOMPARE(values[2], 1e-3);
        // A short range is divided more finely, and its ends are always there.
        const std::vector<double> few = surveyValues(0.3, 30);
        QVERIFY(few.size() > 4);
        QVERIFY(std::count(few.begin(), few.end(), 0.3) == 1 && std::count(few.begin(), few.end(), 30) == 1);
        QVERIFY(std::count(few.begin(), few.end(), 5) == 1);
        QVERIFY(surveyValues(0, 1).empty());
        QVERIFY(surveyValues(2, 1).empty());
        QVERIFY(surveyValues(1, INFINITY).empty());
    }

    void theKneeOfMaxGradientIsWhereTheHolesEnd() {
        const CostSurvey survey = surveyOf(sphere, StudiedSetting::maxGradient, 0.1, 1000);
        QVERIFY(survey.complete());
        QVERIFY(survey.knee());
        // 2.4 is right, so 10 changes nothing, and 1 has holes.
        QCOMPARE(*survey.knee(), 10.0);
        QVERIFY(pointAt(survey, 0.1).lost[povray] > 0);
        QVERIFY(pointAt(survey, 1).lost[povray] > 0);
        QCOMPARE(pointAt(survey, 10).lost[povray], std::uint64_t(0));
        // Behind the knee it only costs.
        QVERIFY(pointAt(survey, 1000).evaluationsPerPixel[povray] >
                10 * pointAt(survey, 10).evaluationsPerPixel[povray]);
        for (const CostPoint& point : survey.points()) QCOMPARE(point.lost[certified], std::uint64_t(0));
    }

    void theKneeOfAccuracyIsAboutThePixel() {
        const CostSurvey survey = surveyOf(sphere, StudiedSetting::accuracy, 1e-6, 1);
        QVERIFY(survey.knee());
        // A pixel is 0.004 wide there.
        QVERIFY2(*survey.knee() <= 1e-2 && *survey.knee() >= 1e-4,
                 qPrintable(QString::number(*survey.knee())));
    }

    /// A thin sheet is missed until accuracy is finer than it.
    void detailsMoveTheKnee() {
        const std::string plates =
            "isosurface { function { abs(mod(abs(x*10 + 0.5), 1) - 0.5) - 0.02 } contained_by { box { -1, 1 "
            "} } "
            "max_gradient 10.1 pigment { rgb 1 } }";
        const auto coarse = surveyOf(sphere, StudiedSetting::accuracy, 1e-6, 1).knee();
        const CostSurvey fine = surveyOf(plates, StudiedSetting::accuracy, 1e-6, 1);
        QVERIFY(coarse && fine.knee());
        QVERIFY(*fine.knee() <= *coarse);
    }

    void everyRunCountsTheSame_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("sphere") << QString::fromStdString(sphere);
        QTest::newRow("noise") << QStringLiteral(
            "isosurface { function { f_noise3d(x*4,y*4,z*4)-0.6+x*x+y*y+z*z } contained_by { box { -1, 1 } } "
            "max_gradient 6 pigment { rgb 1 } }");
    }
    void everyRunCountsTheSame() {
        QFETCH(const QString, text);
        const CostSurvey a = surveyOf(text.toStdString(), StudiedSetting::accuracy, 1e-5, 1);
        const CostSurvey b = surveyOf(text.toStdString(), StudiedSetting::accuracy, 1e-5, 1);
        QCOMPARE(a.width(), b.width());
        QCOMPARE(a.knee(), b.knee());
        QCOMPARE(a.povray().evaluations, b.povray().evaluations);
        for (std::size_t i = 0; i < a.points().size(); ++i) {
            QCOMPARE(a.points()[i].evaluationsPerPixel, b.points()[i].evaluationsPerPixel);
            QCOMPARE(a.points()[i].lost, b.points()[i].lost);
        }
    }

    void onlyTheIsosurfaceAskedForIsVaried() {
        const std::string both =
            sphere +
            "isosurface { function { y + 1 } contained_by { box { -2, 2 } } max_gradient 1 "
            "pigment { rgb 1 } }";
        const CostSurvey first = surveyOf(both, StudiedSetting::maxGradient, 0.1, 1000, 0);
        const CostSurvey second = surveyOf(both, StudiedSetting::maxGradient, 0.1, 1000, 1);
        QVERIFY(first.complete() && second.complete());
        QVERIFY(pointAt(first, 0.1).lost[povray] > pointAt(second, 1000).lost[povray]);
        CostSurvey none({studyScene(both, 800, 600), 2, StudiedSetting::accuracy, {1e-3}});
        QVERIFY(!none.next());
    }

    void aStopEndsIt() {
        std::stop_source stop;
        stop.request_stop();
        CostSurvey survey({studyScene(sphere, 800, 600), 0, StudiedSetting::accuracy, {1e-3, 1e-4}});
        QVERIFY(!survey.next(stop.get_token()));
        QVERIFY(!survey.complete());
        QVERIFY(!survey.knee());
        // It goes on where it was.
        QVERIFY(survey.next());
    }

    void workCountsWhatIsEvaluated() {
        const StudiedFunction f("sin(x)/y + f_noise3d(x,y,z) + sum(i, 1, 5, pow(x, i))");
        const FunctionWork work = workOf(*f.tape, f.parameters);
        QCOMPARE(work.waves, 1.0);
        QCOMPARE(work.quotients, 1.0);
        QCOMPARE(work.noises, 1.0);
        // Short sums are written out; whether a power of a whole number is one is the graph's business.
        QVERIFY(work.sums >= 5);
        const StudiedFunction loop("sum(i, 1, 100, sin(x*i))");
        const FunctionWork repeated = workOf(*loop.tape, loop.parameters);
        QCOMPARE(repeated.waves, 100.0);
    }

    void stepsOfBuiltinsAreCompiled() {
        const RenderRequest written = studyScene(sphere);
        const FunctionWork own = workOf(written.scene->isosurfaces[0], *written.scene->parameterTable);
        QCOMPARE(own.calls, 0.0);
        QCOMPARE(own.nativeSteps, 0.0);
        // How long octaves take depends on their number.
        const FunctionWork octaves = workIn("f_ridge(x,y,z,1,3,0.5,0.7,0.7,2) - x");
        QCOMPARE(octaves.calls, 1.0);
        QVERIFY(octaves.nativeSteps > 0);
        QCOMPARE(octaves.timedCalls, 0.0);
        // Of other built-ins the time is known by itself.
        const FunctionWork torus = workIn("f_torus(x,y,z,1,0.2) - x");
        QVERIFY(torus.timedCalls > 0);
        QCOMPARE(torus.sums, 1.0);
        QCOMPARE(torus.calls + torus.nativeSteps + torus.products, 0.0);
        QVERIFY(workIn("f_helix1(x,y,z,2,3,0.1,0.5,1,2,45)").timedCalls > 3 * torus.timedCalls);
        // A pigment is told from a function by the component that is taken.
        const RenderRequest pigment = studyScene(
            "#declare P = function { pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } } }\n"
            "#declare F = function(x, y, z) { x*y }\n"
            "isosurface { function { P(2*x, (y), z) .gray - F(x, y, z) } contained_by { box { -2, 2 } } }");
        const FunctionWork mixed = workOf(pigment.scene->isosurfaces[0], *pigment.scene->parameterTable);
        QCOMPARE(mixed.pigmentCalls, 1.0);
        QCOMPARE(mixed.declaredCalls, 1.0);
        // One in the call, one in the function that is called.
        QCOMPARE(mixed.products, 2.0);
        QVERIFY(mixed.nativeSteps > 0);
    }

    /// POV-Ray's interpreter takes what stands there twice twice; 23_Isosurface_sine_sphere_y.txt, whose
    /// squares do, was told a third too little.
    void whatIsWrittenTwiceIsDoneTwice() {
        const FunctionWork twice = workIn("sqrt(x*x + z*z) /* - */ + x*x // + + \n - z*z/3");
        // By a constant POV-Ray does not divide: it multiplies.
        QCOMPARE(twice.products, 5.0);
        QCOMPARE(twice.sums, 3.0);
        QCOMPARE(twice.quotients, 0.0);
        QCOMPARE(workIn("x/y").quotients, 1.0);
        QVERIFY(twice.timedCalls > 0);
        QCOMPARE(workIn("sin(x) + sin(x)").timedCalls, 2 * workIn("sin(x)").timedCalls);
        // What is constant is done once.
        QCOMPARE(workIn("x*(2*3 - 1) - pi*pi/2").products, 1.0);
        QCOMPARE(workIn("(x - 1)*(x - 1)").sums, 2.0);
        // Where nothing is written, the tape tells.
        SceneIsosurface untold = studyScene(sphere).scene->isosurfaces[0];
        untold.written.reset();
        QVERIFY(workOf(untold, {}).products > 0);
    }

    /// Calls in loops of the text, and what is done in the functions that are called; csg.pov, whose union of
    /// 400 balls a loop writes, was told a third of its time.
    void whatIsCalledIsDoneEachTime() {
        const FunctionWork loop = workIn("min(x #for (I, 1, 9) , x*x + y*I #end)");
        QCOMPARE(loop.products, 18.0);
        QCOMPARE(loop.sums, 9.0);
        QCOMPARE(loop.timedCalls, 9 * workIn("min(x, y)").timedCalls);
        const RenderRequest calls = studyScene(
            "#declare A = function(x, y) { sin(x)*y - 2 }\n"
            "#declare B = function(x, y, z) { A(x, y) + A(y, z)*x }\n"
            "isosurface { function { B(x, y, z) - B(y, z, x) } contained_by { box { -2, 2 } } }");
        const FunctionWork work = workOf(calls.scene->isosurfaces[0], *calls.scene->parameterTable);
        QCOMPARE(work.declaredCalls, 6.0);
        QCOMPARE(work.products, 6.0);
        QCOMPARE(work.sums, 7.0);
        QCOMPARE(work.timedCalls, 4 * workIn("sin(x)").timedCalls);
        // A sum's body as often as it runs; ten times where no one knows.
        QCOMPARE(workIn("sum(i, 1, 100, x*i*i)").products, 200.0);
        QCOMPARE(workIn("sum(i, 1, x, x*i*i)").products, 20.0);
    }

    /// POV-Ray's own counts: two tests for each ray that reaches the light, once one has not.
    void withoutAShadowNoRayIsRepeated() {
        const std::string floor =
            "isosurface { function { y+1 } contained_by { box { -1.5, <1.5,-0.9,1.5> } } pigment { rgb 1 } }";
        const std::string ball = "sphere { <0,-0.2,0>, 0.3 pigment { rgb 1 } }";
        const PovrayCounts lit = countForPovray(studyScene(floor, 800, 600), 64);
        QVERIFY(lit.shadowEvaluations > 0);
        QCOMPARE(lit.repeatedEvaluations, 0.0);
        const PovrayCounts shaded = countForPovray(studyScene(floor + ball, 800, 600), 64);
        QVERIFY(shaded.repeatedEvaluations > 0);
        QVERIFY(shaded.repeatedEvaluations < static_cast<double>(shaded.shadowEvaluations));
    }

    /// Nothing was told of a surface without a shadow ray: 0 of 0 were in the light.
    void aSurfaceTurnedFromTheLightHasATime() {
        RenderRequest dark = studyScene(sphere, 800, 600);
        auto scene = std::make_shared<Scene>(*dark.scene);
        for (LightSource& light : scene->lights) light.location = {0, 0, 1e4};
        dark.scene = scene;
        const PovrayCounts unlit = countForPovray(dark, 64);
        QCOMPARE(unlit.shadowEvaluations, std::uint64_t(0));
        QVERIFY(povraySeconds(unlit, 1000) > 0);
    }

    void timeGrowsWithPixelsAndEvaluations() {
        const PovrayCounts counts = countForPovray(studyScene(sphere, 800, 600), 64);
        QVERIFY(counts.complete);
        QCOMPARE(counts.pixels, std::uint64_t(64 * 48));
        // A light that casts shadows: some of the rays are not the camera's.
        QVERIFY(counts.rays > counts.pixels && counts.evaluations > counts.primaryEvaluations);
        QVERIFY(counts.lightFactor() > 1 && counts.lightFactor() < 3);
        // There are no others.
        QCOMPARE(counts.shadowEvaluations, counts.evaluations - counts.primaryEvaluations);
        PovrayCounts mirrored = counts;
        mirrored.repeatedEvaluations = 0;
        QVERIFY(povraySeconds(mirrored, 1000) < povraySeconds(counts, 1000));
        const double once = povraySeconds(counts, 1000);
        QVERIFY(once > 0);
        QCOMPARE(povraySeconds(counts, 4000), 4 * once);
        const double present =
            static_cast<double>(counts.primaryEvaluations) / static_cast<double>(counts.pixels);
        QCOMPARE(povraySeconds(counts, 1000, present), once);
        QVERIFY(povraySeconds(counts, 1000, 10 * present) > 2 * once);
        QCOMPARE(povraySeconds({}, 1000), 0.0);
        QVERIFY(machineSlowness() > 0);
    }
};

QTEST_GUILESS_MAIN(CostSurveyTest)
#include "cost_survey_test.moc"
