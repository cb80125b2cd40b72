// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/loop_stop.h"

#include <array>
#include <QTest>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/language/parse.h"

using namespace isoscope;

namespace {

std::stop_token requestedStop() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

}  // namespace

class LoopStopTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingIsRequestedByDefault() { QVERIFY(!LoopStop::requested()); }

    void theInnermostScopeCounts() {
        const LoopStop outer(requestedStop());
        QVERIFY(LoopStop::requested());
        {
            const LoopStop inner(std::stop_token{});
            QVERIFY(!LoopStop::requested());
        }
        QVERIFY(LoopStop::requested());
    }

    /// A bug once: a stop waited for 64 points to go through all steps of their loops.
    void loopsEndBeforeTheirNextStep() {
        const ParsedFunction parsed = parseFunction("sum(i, 1, 1000, x) + prod(i, 1, 1000, x - 1)");
        QVERIFY(parsed.ok());
        const auto tape = Tape::compile(parsed.value.function);
        PointEvaluator point(tape, parsed.parameterTable);
        AffineEvaluator affine(tape, parsed.parameterTable);
        std::array<AffineForm, 1> form;
        QCOMPARE(point.evaluate(1, 0, 0), 1000.0);
        {
            const LoopStop loops(requestedStop());
            // An empty sum and an empty product: no step was taken.
            QCOMPARE(point.evaluate(1, 0, 0), 1.0);
            affine.evaluate(RayPieces(), form);
            QCOMPARE(form[0].a, 1.0);
        }
        QCOMPARE(point.evaluate(1, 0, 0), 1000.0);
    }

    /// A bug once: evaluators that are being made went through all steps, to find out where operands lie.
    void loopsOfIntervalsEndToo() {
        const ParsedFunction parsed = parseFunction("sum(i, 1, 1000, x * i)");
        QVERIFY(parsed.ok());
        IntervalEvaluator evaluator(Tape::compile(parsed.value.function), parsed.parameterTable);
        const std::array one{Interval::point(1)};
        QCOMPARE(evaluator.evaluate(one).low, 500500.0);
        {
            const LoopStop loops(requestedStop());
            // Nothing is known, but nothing wrong is said.
            const Interval range = evaluator.evaluate(one);
            QCOMPARE(range.low, -Interval::infinite);
            QCOMPARE(range.high, Interval::infinite);
        }
        QCOMPARE(evaluator.evaluate(one).low, 500500.0);
    }

    /// A bug once: a box of a sum of 40 000 noises was seen through for seconds after a stop.
    void boxesOfLongFormulasEndToo() {
        std::string body = "x";
        for (int k = 0; k < 200; ++k) body += "+sin(x+" + std::to_string(k) + ")";
        for (const std::string& text : {body, std::string("sum(i, 1, 1000, x * i)")}) {
            const ParsedFunction parsed = parseFunction(text);
            QVERIFY(parsed.ok());
            IntervalGradientEvaluator evaluator(Tape::compile(parsed.value.function), parsed.parameterTable);
            const std::array box{Interval{0, 1}, Interval{0, 1}, Interval{0, 1}};
            const double bound = evaluator.evaluate(box).steepness;
            QVERIFY(std::isfinite(bound));
            {
                const LoopStop loops(requestedStop());
                const IntervalGradient stopped = evaluator.evaluate(box);
                QVERIFY(!stopped.bounded());
                QCOMPARE(stopped.hazard, GradientHazard::unknown);
                QCOMPARE(stopped.value.high, Interval::infinite);
            }
            QCOMPARE(evaluator.evaluate(box).steepness, bound);
        }
    }
};

QTEST_APPLESS_MAIN(LoopStopTest)
#include "loop_stop_test.moc"
