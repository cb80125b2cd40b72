// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/evaluate_advice.h"

#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

EvaluateAdvice adviceFor(const std::string& function) {
    return adviseEvaluate(studyScene("isosurface { function { " + function +
                                     " } contained_by { sphere { 0, 1.2 } } pigment { rgb 1 } }\n"),
                          0, 1);
}

}  // namespace

class EvaluateAdviceTest : public QObject {
    Q_OBJECT

  private slots:
    /// 2 |p| is at most 2.4, and the fixed bound loses nothing.
    void theFixedBoundIsTheProvenOne() {
        const EvaluateAdvice advice = adviceFor("x*x + y*y + z*z - 1");
        QVERIFY(advice.complete);
        QVERIFY(advice.fixed.maxGradient >= 2.4 && advice.fixed.maxGradient < 2.6);
        QCOMPARE(advice.fixed.mistakes, std::uint64_t(0));
        QVERIFY(advice.fixed.evaluationsPerPixel > 0);
        // Six for each P0, and no P0 twice.
        QVERIFY(advice.trials.size() >= 18 && advice.trials.size() % 6 == 0);
        // Half of the ball's volume is within 0.794 of its radius.
        QVERIFY(std::abs((*advice.trials[0].evaluate)[0] - 2.4 * 0.794) < 0.15);
        for (const BoundTrial& trial : advice.trials)
            QVERIFY((*trial.evaluate)[1] >= 1 && (*trial.evaluate)[2] <= 1 && (*trial.evaluate)[2] > 0);
    }

    void theBestIsRightAndCheaper() {
        const EvaluateAdvice advice = adviceFor("pow(x*x + y*y + z*z, 4) - 0.5");
        QVERIFY(advice.complete);
        const BoundTrial* best = advice.best();
        if (!best) QSKIP("evaluate does not pay here");
        QVERIFY(best->mistakes <= advice.fixed.mistakes);
        QVERIFY(best->evaluationsPerPixel < advice.fixed.evaluationsPerPixel);
        for (const BoundTrial& trial : advice.trials)
            QVERIFY(trial.mistakes > advice.fixed.mistakes ||
                    trial.evaluationsPerPixel >= best->evaluationsPerPixel);
    }

    void whatCannotBeMeasuredIsNotComplete() {
        QVERIFY(!adviseEvaluate({}, 0).complete);
        RenderRequest view = studyScene("isosurface { function { x } }\n");
        QVERIFY(!adviseEvaluate(view, 7).complete);
        std::stop_source stop;
        stop.request_stop();
        const EvaluateAdvice stopped = adviseEvaluate(view, 0, 1, stop.get_token());
        QVERIFY(!stopped.complete && stopped.trials.empty());
    }
};

QTEST_MAIN(EvaluateAdviceTest)
#include "evaluate_advice_test.moc"
