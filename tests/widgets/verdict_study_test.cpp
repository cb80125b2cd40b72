// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_study.h"

#include <future>
#include <QTest>
#include <thread>

#include "core/language/parse.h"
#include "widgets/latest_worker.h"

using namespace isoscope;

namespace {

std::shared_ptr<const Scene> sceneOf(const std::string& text) {
    const ParseResult parsed = parseScene(
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0.4, 0.6, -4> "
        "look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\n" +
        text);
    if (!parsed.ok()) qFatal("%s", parsed.diagnostics.front().message.c_str());
    return parsed.scene;
}

std::string sphere(const std::string& settings, double radius = 1) {
    return "isosurface { function { x*x + y*y + z*z - " + std::to_string(radius) +
           " } contained_by { sphere { 0, 1.2 } } " + settings + " }\n";
}

bool judged(const VerdictStudy& study) {
    return QTest::qWaitFor([&] { return !study.busy(); }, 60000);
}

Camera cameraAt(double x) {
    Camera camera;
    camera.location = {x, 0, -5};
    return camera;
}

}  // namespace

class VerdictStudyTest : public QObject {
    Q_OBJECT

  private slots:
    void everyIsosurfaceHasItsVerdict() {
        VerdictStudy study;
        study.setScene(sceneOf(sphere("") + sphere("max_gradient 2.4") + sphere("max_gradient 24") +
                               "isosurface { function { y - 0.1/(x - 0.25) } max_gradient 1e9 }"));
        QVERIFY(judged(study));
        QCOMPARE(study.verdicts().size(), 4u);
        QCOMPARE(study.verdictOf(0)->verdict().value(), GradientVerdict::holes);
        QCOMPARE(study.verdictOf(0)->suggested().value(), 2.4);
        QVERIFY(study.verdictOf(0)->effects->mistakes > 100 && study.verdictOf(0)->pixels > 10000);
        QCOMPARE(study.verdictOf(1)->verdict().value(), GradientVerdict::right);
        QCOMPARE(study.verdictOf(2)->verdict().value(), GradientVerdict::wasteful);
        QVERIFY(study.verdictOf(2)->waste.value() > 1);
        QCOMPARE(study.verdictOf(3)->verdict().value(), GradientVerdict::unbounded);
        QVERIFY(!study.verdictOf(4));
    }

    void aProofSurvivesOtherViewsEditsElsewhereAndUndo() {
        VerdictStudy study;
        study.setScene(sceneOf(sphere("")));
        QVERIFY(judged(study));
        const std::uint64_t slices = study.slices();
        QCOMPARE(study.proofs()->begun(), 1u);
        for (int i = 1; i <= 5; ++i) {
            study.setView(cameraAt(i), {400, 300});
            QVERIFY(judged(study));
            QCOMPARE(study.views(), static_cast<std::uint64_t>(i + 1));
        }
        study.setScene(sceneOf("sphere { 3, 1 }" + sphere("max_gradient 3")));
        QVERIFY(judged(study));
        QCOMPARE(study.proofs()->begun(), 1u);
        QCOMPARE(study.slices(), slices);
        study.setScene(sceneOf(sphere("", 0.75)));
        QVERIFY(judged(study));
        QCOMPARE(study.proofs()->begun(), 2u);
        const std::uint64_t both = study.slices();
        study.setScene(sceneOf(sphere("")));
        QVERIFY(judged(study));
        QCOMPARE(study.slices(), both);
        QCOMPARE(study.verdictOf(0)->verdict().value(), GradientVerdict::holes);
    }

    void whileHeldNothingIsWorkedOn() {
        VerdictStudy study;
        study.setHeld(true);
        study.setScene(sceneOf(sphere("")));
        QTest::qWait(100);
        QCOMPARE(study.slices(), 0u);
        QCOMPARE(study.views(), 0u);
        QVERIFY(study.busy());
        study.setHeld(false);
        QVERIFY(judged(study));
        QVERIFY(study.slices() > 0);
    }

    void aHoldInterruptsWhatRunsAndLosesNothing() {
        // Noise: its proof takes its time.
        const std::string noise =
            "isosurface { function { y - f_noise3d(9*x,9*y,9*z) } max_gradient 60 contained_by { box { -2, 2 "
            "} } }";
        VerdictStudy study;
        study.setScene(sceneOf("#include \"functions.inc\"\n" + noise));
        QVERIFY(QTest::qWaitFor([&] { return study.slices() > 3; }, 30000));
        study.setHeld(true);
        QTest::qWait(200);  // the slice at hand
        const std::uint64_t slices = study.slices();
        QTest::qWait(200);
        QCOMPARE(study.slices(), slices);
        const double upper = study.verdictOf(0)->bracket.upper;
        study.setHeld(false);
        QVERIFY(QTest::qWaitFor([&] { return study.slices() > slices; }, 30000));
        QVERIFY(study.verdictOf(0)->bracket.upper <= upper);
    }

    void allIsosurfacesOfALongTextAreJudged() {
        std::string text = "#include \"functions.inc\"\n";
        for (int i = 0; i < 20; ++i)
            text += i % 2 ? sphere("max_gradient 2.4", 0.5 + 0.02 * i)
                          : "isosurface { function { f_torus(x,y,z,0.8," + std::to_string(0.1 + 0.01 * i) +
                                ") + 0.1*sin(" + std::to_string(i + 3) + "*x)*sin(5*z) } }\n";
        VerdictStudy study;
        study.setScene(sceneOf(text));
        QVERIFY(judged(study));
        QCOMPARE(study.verdicts().size(), 20u);
        QCOMPARE(study.proofs()->begun(), 20u);
        for (const SurfaceVerdict& one : study.verdicts()) QVERIFY(one.verdict().has_value());
    }

    void withoutIsosurfaceNothingIsJudged() {
        VerdictStudy study;
        study.setScene(sceneOf(sphere("")));
        QVERIFY(judged(study));
        study.setScene(nullptr);
        QVERIFY(!study.busy() && study.verdicts().empty());
        study.setScene(sceneOf("sphere { 0, 1 }"));
        QVERIFY(!study.busy() && study.verdicts().empty());
    }

    /// Of the worker that other studies run on: scenes that its tasks hold may be large.
    void whatATaskHoldsKeepsNoCallerWaitingWhileItGoes() {
        // Threads that ask meanwhile; a worker that keeps them waiting would never answer.
        std::vector<std::jthread> asking;
        std::atomic<int> gone = 0, answered = 0;
        std::promise<void> begun, gate;
        LatestWorker worker;
        const auto dearThing = [&] {
            return std::shared_ptr<void>(nullptr, [&](void*) {
                const auto asked = std::make_shared<std::promise<void>>();
                asking.emplace_back([&worker, asked] {
                    (void)worker.idle();
                    asked->set_value();
                });
                const auto answer = asked->get_future().wait_for(std::chrono::seconds(20));
                answered += answer == std::future_status::ready;
                ++gone;
            });
        };
        worker.submit([&, thing = dearThing()](std::stop_token) {
            begun.set_value();
            gate.get_future().wait();
        });
        begun.get_future().wait();
        worker.submit([thing = dearThing()](std::stop_token) {});
        worker.submit([](std::stop_token) {});
        QCOMPARE(gone.load(), 1);
        gate.set_value();
        QTRY_VERIFY(worker.idle());
        QCOMPARE(gone.load(), 2);
        QCOMPARE(answered.load(), 2);
    }
};

QTEST_GUILESS_MAIN(VerdictStudyTest)
#include "verdict_study_test.moc"
