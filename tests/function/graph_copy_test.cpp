// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/graph_copy.h"

#include <QTest>

#include "core/evaluate/point_evaluator.h"

using namespace isoscope;

namespace {

double valueOf(const Function& function, const std::vector<double>& arguments,
               const std::vector<double>& parameters) {
    PointEvaluator evaluator(Tape::compile(function), parameters);
    std::vector<const double*> columns;
    for (const double& argument : arguments) columns.push_back(&argument);
    double value = 0;
    evaluator.evaluate(columns, 1, std::span(&value, 1));
    return value;
}

/// x * p3 + the sum of (i + p5) for i = 1 ... 100, which is a loop.
Function loopWithParameters() {
    FunctionGraph body;
    const NodeId term = body.binary(Operation::add, body.variable(0), body.parameter(5));
    const Function inner = finish(std::move(body), {term}, 1);
    FunctionGraph graph;
    const NodeId sum = graph.loop(Operation::sum, graph.constant(1), graph.constant(100), inner, {});
    const NodeId product = graph.binary(Operation::multiply, graph.variable(0), graph.parameter(3));
    const NodeId result = graph.binary(Operation::add, product, sum);
    return finish(std::move(graph), {result}, 3);
}

}  // namespace

class GraphCopyTest : public QObject {
    Q_OBJECT

  private slots:
    void slotsOfLoopsCountToo() {
        QCOMPARE(parameterSlots(loopWithParameters()), (std::vector<int>{3, 5}));
        QVERIFY(parameterSlots({}).empty());
    }

    void aFreeParameterIsTheLastArgument() {
        const std::vector<double> table{0, 0, 0, 2, 0, 7};
        const Function function = loopWithParameters();
        QCOMPARE(valueOf(function, {3, 0, 0}, table), 6.0 + 5050 + 700);
        const Function free3 = withFreeParameter(function, 3), free5 = withFreeParameter(function, 5);
        QCOMPARE(free3.argumentCount, 4);
        QCOMPARE(valueOf(free3, {3, 0, 0, 10}, table), 30.0 + 5050 + 700);
        QCOMPARE(valueOf(free5, {3, 0, 0, -1}, table), 6.0 + 5050 - 100);
        QCOMPARE(parameterSlots(free3), std::vector<int>{5});
        QCOMPARE(parameterSlots(free5), std::vector<int>{3});
        QVERIFY(!withFreeParameter({}, 3).valid());
    }

    void onlyWhatAResultNeedsIsCopied() {
        FunctionGraph graph;
        const NodeId unused = graph.parameter(9);
        const NodeId result = graph.unary(Operation::square, graph.variable(1));
        graph.binary(Operation::add, unused, result);
        const Function function = finish(std::move(graph), {result}, 3);
        QVERIFY(parameterSlots(function).empty());
        QCOMPARE(withFreeParameter(function, 9).graph->size(), std::size_t(2));
    }
};

QTEST_APPLESS_MAIN(GraphCopyTest)
#include "graph_copy_test.moc"
