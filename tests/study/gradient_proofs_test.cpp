// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_proofs.h"

#include <QTest>
#include <thread>

#include "core/study/gradient/gradient_verdict.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Scene> sceneOf(const std::string& text) { return studyScene(text).scene; }

const std::string torus =
    "isosurface { function { f_torus(x,y,z,0.8,0.3) - 0.01*x } contained_by { box { -1.2, 1.2 } } threshold "
    "0 }";

void finish(GradientProof& proof) {
    while (proof.advance(300)) {
    }
}

}  // namespace

class GradientProofsTest : public QObject {
    Q_OBJECT

  private slots:
    void aProofIsMadeOnceForAFunctionAndItsNumbers() {
        GradientProofs proofs;
        const auto proof = proofs.proofOf(*sceneOf(torus), 0);
        // Other settings, another place in the text and the scene, other objects.
        for (const std::string& same :
             std::vector<std::string>{torus, "sphere { 3, 1 }\n" + torus,
                                      "isosurface { function { f_torus(x,y,z,0.8,0.3) - 0.01*x } threshold "
                                      "0.1 max_gradient 7 accuracy "
                                      "0.01 contained_by { box { -1.2, 1.2 } } translate y }"})
            QCOMPARE(proofs.proofOf(*sceneOf(same), 0), proof);
        QCOMPARE(proofs.begun(), 1u);
        std::string other = torus, larger = torus;
        other.replace(other.find("0.3"), 3, "0.4");
        larger.replace(larger.find("-1.2"), 4, "-1.3");
        QVERIFY(proofs.proofOf(*sceneOf(other), 0) != proof);
        QVERIFY(proofs.proofOf(*sceneOf(larger), 0) != proof);
        QCOMPARE(proofs.begun(), 3u);
        // Back to the older numbers.
        QCOMPARE(proofs.proofOf(*sceneOf(torus), 0), proof);
        QCOMPARE(proofs.begun(), 3u);
    }

    void slicesEndWhereOneRunEnds() {
        const auto scene = sceneOf(torus);
        const Isosurface& surface = *scene->isosurfaces[0].shape;
        GradientStudy whole(surface.tape(), *scene->parameterTable, surface.settings().container);
        GradientProofs proofs;
        const auto proof = proofs.proofOf(*scene, 0);
        finish(*proof);
        QCOMPARE(proof->bracket().state, whole.run().state);
        QCOMPARE(proof->bracket().state, GradientState::tight);
        QCOMPARE(suggestedGradient(proof->bracket()), suggestedGradient(whole.bracket()));
        QVERIFY(!proof->advance(1000));
    }

    void aPauseEndsWithTheBoxAtHandAndTheProofGoesOnThere() {
        const auto scene =
            sceneOf("isosurface { function { sin(9*x*y) + cos(7*z*x) } contained_by { box { -1, 1 } } }");
        GradientProofs proofs, others;
        const auto proof = proofs.proofOf(*scene, 0), whole = others.proofOf(*scene, 0);
        std::stop_source pause;
        pause.request_stop();
        QVERIFY(proof->advance(1));
        const std::uint64_t before = proof->bracket().boxes;
        QVERIFY(proof->advance(100'000, {}, pause.get_token()));
        QCOMPARE(proof->bracket().boxes, before);
        QCOMPARE(proof->bracket().state, GradientState::running);
        finish(*proof);
        while (whole->advance(100'000)) {
        }
        QCOMPARE(proof->bracket().state, GradientState::tight);
        QCOMPARE(proof->bracket().lower, whole->bracket().lower);
        QCOMPARE(proof->bracket().upper, whole->bracket().upper);
    }

    void aStopOrASuspensionLosesNothingThatIsKnown() {
        GradientProofs proofs;
        const auto scene =
            sceneOf("isosurface { function { sin(9*x*y) + cos(7*z*x) } contained_by { box { -1, 1 } } }");
        const auto proof = proofs.proofOf(*scene, 0);
        QVERIFY(proof->advance(200));
        const GradientBracket before = proof->bracket();
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(proof->advance(200, stop.get_token()));
        QCOMPARE(proof->bracket().state, GradientState::running);
        proof->suspend();
        for (int i = 0; i < 5; ++i) {
            proof->advance(20);
            QVERIFY(proof->bracket().lower >= before.lower && proof->bracket().upper <= before.upper);
        }
        finish(*proof);
        QCOMPARE(proof->bracket().state, GradientState::tight);
    }

    void severalThreadsProveTheSame() {
        GradientProofs proofs;
        const auto scene = sceneOf(torus);
        {
            std::vector<std::jthread> threads;
            for (int i = 0; i < 4; ++i) threads.emplace_back([&] { finish(*proofs.proofOf(*scene, 0)); });
        }
        QCOMPARE(proofs.begun(), 1u);
        QCOMPARE(proofs.proofOf(*scene, 0)->bracket().state, GradientState::tight);
    }

    void withoutIsosurfaceThereIsNothingToProve() {
        GradientProofs proofs;
        QVERIFY(!proofs.proofOf(*sceneOf("sphere { 0, 1 }"), 0));
        QCOMPARE(proofs.begun(), 0u);
    }
};

QTEST_APPLESS_MAIN(GradientProofsTest)
#include "gradient_proofs_test.moc"
