// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/surface_verdict.h"

#include <limits>
#include <QTest>
#include <glm/geometric.hpp>

#include "core/study/gradient/gradient_proofs.h"
#include "core/study/gradient/statement_verdict.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::string leaky =
    "isosurface { function { x*x+y*y+z*z-0.5 } contained_by { sphere { 0, 1 } } translate -1.1*x }\n";
const std::string sound =
    "isosurface { function { x*x+y*y+z*z-0.5 } contained_by { sphere { 0, 1 } } max_gradient 2 "
    "translate 1.1*x }\n";

SurfaceVerdict verdictOf(const RenderRequest& view, std::size_t i) {
    GradientProofs proofs;
    const auto proof = proofs.proofOf(*view.scene, i);
    while (proof->advance(200)) {
    }
    SurfaceVerdict verdict;
    verdict.isosurface = i;
    verdict.setting = view.scene->isosurfaces[i].shape->rootSettings().maxGradient;
    verdict.bracket = proof->bracket();
    return verdict;
}

}  // namespace

class SurfaceVerdictTest : public QObject {
    Q_OBJECT

  private slots:
    void pixelsCountForTheSurfaceThatTheyAreOn() {
        const RenderRequest view = studyScene(leaky + sound + "plane { y, -1 pigment { rgb 1 } }");
        const SettingEffects effects = settingEffects(view);
        QVERIFY(effects.complete);
        QCOMPARE(effects.pixels, 80u * 60u);
        QVERIFY(effects.surfaces[0].mistakes > 20);
        QCOMPARE(effects.surfaces[1].mistakes, 0u);
        // Lost at the left, where the first one stands.
        QVERIFY(glm::distance(effects.surfaces[0].place, glm::dvec3(-1.1, 0, 0)) < 0.8);
        QVERIFY(effects.surfaces[0].alongRays > 1.1 && effects.surfaces[0].alongRays <= 2);
        QVERIFY(effects.surfaces[1].alongRays <= 2);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!settingEffects(view, 0, stop.get_token()).complete);
    }

    void aSlopeBelongsToItsOwnSurface() {
        const std::string steep =
            "isosurface { function { 30*z } contained_by { box { <1,-0.2,0>, <1.5,0.2,0.5> } } max_gradient "
            "30 }";
        const SettingEffects effects = settingEffects(studyScene(leaky + steep));
        QVERIFY(effects.surfaces[0].alongRays < 2.01);
        QVERIFY(effects.surfaces[1].alongRays > 20);
    }

    void theVerdictWaitsForTheProofButNotForHoles() {
        SurfaceVerdict early;
        early.bracket.lower = 9.95, early.bracket.upper = 9.99;
        const auto at = [&](double setting) {
            early.setting = setting;
            return early.verdict();
        };
        QCOMPARE(early.bracket.state, GradientState::running);
        QVERIFY(at(9) == GradientVerdict::holes && at(10) == GradientVerdict::right);
        QVERIFY(at(13) == GradientVerdict::wasteful && !at(9.97));
        // A tighter bound would be rounded to the same.
        QCOMPARE(early.suggested().value(), 10.0);
        early.bracket.lower = 3;
        QVERIFY(!at(9) && !at(10) && !early.suggested());
        QVERIFY(at(13) == GradientVerdict::wasteful && at(2) == GradientVerdict::holes);
        early.bracket.seams = true;
        QVERIFY(!at(13) && at(2) == GradientVerdict::holes);
        const RenderRequest view = studyScene(leaky + sound);
        QCOMPARE(verdictOf(view, 1).verdict().value(), GradientVerdict::right);
        QCOMPARE(verdictOf(view, 0).suggested().value(), 2.0);
    }

    void wasteIsCountedInEvaluations() {
        std::string text = sound;
        text.replace(text.find("max_gradient 2"), 14, "max_gradient 20");
        const RenderRequest view = studyScene(text);
        const SurfaceVerdict verdict = verdictOf(view, 0);
        QCOMPARE(verdict.verdict().value(), GradientVerdict::wasteful);
        const auto cost = costBeside(view, 0, *verdict.suggested(), settingEffects(view).evaluations);
        QVERIFY(cost && *cost > 1.5 && *cost < 10);
    }

    void betweenTheEndsOfALooseBracketNothingIsProven() {
        GradientBracket bracket;
        bracket.lower = 5, bracket.upper = 8, bracket.state = GradientState::unproven;
        QCOMPARE(judgeGradient(4, bracket, 0), GradientVerdict::holes);
        QCOMPARE(judgeGradient(6, bracket, 0), GradientVerdict::unproven);
        QCOMPARE(judgeGradient(8, bracket, 0), GradientVerdict::right);
        QCOMPARE(judgeGradient(11, bracket, 0), GradientVerdict::wasteful);
    }

    void ofAStatementTheWorstAndTheLargestCount() {
        Scene scene;
        scene.isosurfaces.resize(3);
        scene.isosurfaces[0].range = scene.isosurfaces[1].range = {0, 10, 50};
        // A bug once: statements that begin at the same offset of two files were taken for one.
        scene.isosurfaces[2].range = {1, 10, 60};
        const auto verdictOf = [](std::size_t number, double setting, double gradient) {
            SurfaceVerdict verdict;
            verdict.isosurface = number;
            verdict.setting = setting;
            verdict.bracket.lower = verdict.bracket.upper = gradient;
            verdict.bracket.state = GradientState::tight;
            return verdict;
        };
        const auto all =
            statementVerdicts({verdictOf(0, 2, 2), verdictOf(1, 2, 4), verdictOf(2, 8, 8)}, scene);
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].isosurfaces, (std::vector<std::size_t>{0, 1}));
        QVERIFY(all[0].verdict == GradientVerdict::holes && all[0].mendable());
        QCOMPARE(all[0].needed.value_or(0), 4.0);
        QCOMPARE(all[1].range.file, 1u);
        QVERIFY(all[1].verdict == GradientVerdict::right && !all[1].mendable());
        QCOMPARE(all[1].needed.value_or(0), 8.0);
        // Without a bound for one of them there is none for the statement.
        SurfaceVerdict open = verdictOf(1, 2, 4);
        open.bracket.upper = std::numeric_limits<double>::infinity();
        open.bracket.state = GradientState::unproven;
        const auto unknown = statementVerdicts({verdictOf(0, 2, 2), open}, scene);
        QVERIFY(!unknown.front().needed && !unknown.front().mendable());
    }

    void theWorstIsTheOneThatLoses() {
        using V = GradientVerdict;
        const std::vector<std::optional<V>> fromGoodToBad{V::right,    {},           V::wasteful,
                                                          V::unproven, V::unbounded, V::holes};
        for (std::size_t i = 1; i < fromGoodToBad.size(); ++i)
            QVERIFY(badness(fromGoodToBad[i - 1]) < badness(fromGoodToBad[i]));
    }
};

QTEST_APPLESS_MAIN(SurfaceVerdictTest)
#include "surface_verdict_test.moc"
