// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of points in functions: what every evaluator makes of numbers that no formula gives.
#include "core/function/point_table.h"

#include <QTest>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/function/builtins/fractal_table.h"
#include "core/function/graph_builder.h"

using namespace isoscope;

namespace {

/// Steps of one quarter in x, 0 to 0.75.
class Steps : public PointTable {
  public:
    double value(const std::array<double, 3>& point) const override {
        const double fraction = point[0] - std::floor(point[0]);
        return std::isnan(fraction) ? 0 : std::floor(4 * fraction) / 4;
    }
    double high() const override { return 0.75; }
};

/// 2 table(x, y, z) + y
std::shared_ptr<const Tape> tape() {
    FunctionGraph graph;
    CrackleSettings settings;
    settings.table = std::make_shared<const Steps>();
    const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
    const Expression table(graph, graph.crackle(settings, x, y, z));
    const NodeId result = (2 * table + Expression(graph, y)).node();
    return Tape::compile(finish(std::move(graph), {result}, 3));
}

}  // namespace

class PointTableTest : public QObject {
    Q_OBJECT

  private slots:
    void valuesAreLookedUp() {
        PointEvaluator evaluator(tape(), {});
        QCOMPARE(evaluator.evaluate(0.3, 1, 0), 1.5);
        QCOMPARE(evaluator.evaluate(-0.1, 1, 0), 2.5);
    }

    void constantPointsAreLookedUpOnce() {
        FunctionGraph graph;
        CrackleSettings settings;
        settings.table = std::make_shared<const Steps>();
        const NodeId half = graph.constant(0.5);
        const NodeId node = graph.crackle(settings, half, half, half);
        QVERIFY(graph.isConstant(node));
        QCOMPARE(graph.value(node), 0.5);
    }

    void boundsHoldEverywhere() {
        IntervalEvaluator intervals(tape(), {});
        const std::array<Interval, 3> box{Interval{0, 1, false}, Interval{-1, 2, false}, Interval::point(0)};
        const Interval range = intervals.evaluate(box);
        QVERIFY(range.low <= -1 && range.low > -1.001);
        QVERIFY(range.high >= 3.5 && range.high < 3.501);
        QVERIFY(!range.maybeUndefined);
    }

    /// Nothing may be concluded from the slopes beside its steps.
    void slopesAreNotKnown() {
        IntervalGradientEvaluator gradients(tape(), {});
        const std::array<Interval, 3> box{Interval{0, 1, false}, Interval{-1, 2, false}, Interval::point(0)};
        QCOMPARE(gradients.evaluate(box).hazard, GradientHazard::unknown);
    }

    void differentTablesAreDifferentOperations() {
        FunctionGraph graph;
        CrackleSettings one, other;
        one.table = std::make_shared<const Steps>();
        other.table = std::make_shared<const Steps>();
        const NodeId x = graph.variable(0);
        QCOMPARE(graph.crackle(one, x, x, x), graph.crackle(one, x, x, x));
        QVERIFY(graph.crackle(one, x, x, x) != graph.crackle(other, x, x, x));
    }

    /// Fractals of many iterations are looked up; with few the table says the same as the operations.
    void fractalsAreTheSameInATable_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("exponent");
        for (const auto kind :
             {PatternKind::mandel, PatternKind::julia, PatternKind::magnetMandel, PatternKind::magnetJulia})
            for (const int number : {1, 2, 3})
                QTest::addRow("%d %d", static_cast<int>(kind), number) << static_cast<int>(kind) << number;
    }

    void fractalsAreTheSameInATable() {
        QFETCH(int, kind);
        QFETCH(int, exponent);
        Pattern pattern;
        pattern.kind = static_cast<PatternKind>(kind);
        pattern.exponent = exponent + 1;
        pattern.magnetType = exponent == 2 ? 2 : 1;
        pattern.iterations = 20;
        pattern.juliaPoint = {0.35, -0.2};
        pattern.exterior = {exponent == 3 ? 6 : 1, 0.4};
        pattern.interior = {exponent, 0.7};
        FunctionGraph graph;
        const PatternPoint at{Expression(graph, graph.variable(0)), Expression(graph, graph.variable(1)),
                              Expression(graph, graph.variable(2))};
        pattern.frequency = 0;
        const NodeId node = patternValue(pattern, at, 2).node();
        PointEvaluator operations(Tape::compile(finish(std::move(graph), {node}, 3)), {});
        const FractalTable table(pattern);
        int alike = 0, compared = 0;
        for (double x = -1.6; x < 1.6; x += 0.11)
            for (double y = -1.3; y < 1.3; y += 0.13) {
                const double wanted = operations.evaluate(x, y, 0);
                const double raw = table.value({x, y, 0});
                const double got = raw < 0 ? raw - std::floor(raw) : raw;
                ++compared;
                alike += std::abs(got - wanted) <= 1e-9 * std::max(1.0, std::abs(wanted));
            }
        // Both round alike; where the orbit overflows the table has its bound instead.
        QVERIFY2(alike > 0.99 * compared, qPrintable(QString("%1 of %2").arg(alike).arg(compared)));
    }
};

QTEST_APPLESS_MAIN(PointTableTest)
#include "point_table_test.moc"
