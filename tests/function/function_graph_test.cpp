// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/function_graph.h"

#include <bit>
#include <cmath>
#include <limits>
#include <QTest>
#include <random>

#include "core/evaluate/reference_evaluator.h"
#include "core/function/graph_builder.h"

using namespace isoscope;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool sameNumber(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

NodeId build(FunctionGraph& graph, Operation operation, std::span<const NodeId> operands) {
    switch (arity(operation)) {
        case 1: return graph.unary(operation, operands[0]);
        case 2: return graph.binary(operation, operands[0], operands[1]);
        case 3: return graph.ternary(operation, operands[0], operands[1], operands[2]);
        default: return graph.quaternary(operation, operands[0], operands[1], operands[2], operands[3]);
    }
}

bool isPlain(Operation operation) { return arity(operation) > 0 && operation != Operation::crackle; }

/// sum or prod of i*i + c for i = first, ..., last, with the bounds as variables 0 and 1 or as constants.
Function loopFunction(Operation operation, double first, double last, bool constantBounds) {
    FunctionGraph bodyGraph;
    const Expression i(bodyGraph, bodyGraph.variable(0)), c(bodyGraph, bodyGraph.variable(1));
    const Expression term = i * i + c;
    const Function body = finish(std::move(bodyGraph), {term.node()}, 2);
    FunctionGraph graph;
    const NodeId from = constantBounds ? graph.constant(first) : graph.variable(0);
    const NodeId to = constantBounds ? graph.constant(last) : graph.variable(1);
    const NodeId captured[] = {graph.variable(2)};
    const NodeId loop = graph.loop(operation, from, to, body, captured);
    return finish(std::move(graph), {loop}, 3);
}

bool containsLoop(const Function& function) {
    for (NodeId id = 0; id < function.graph->size(); ++id)
        if (arity((*function.graph)[id].operation) < 0) return true;
    return false;
}

}  // namespace

class FunctionGraphTest : public QObject {
    Q_OBJECT

  private slots:
    void equalNodesExistOnce() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId first = (sin(x) * y + 2).node();
        const std::size_t size = graph.size();
        QCOMPARE((sin(x) * y + 2).node(), first);
        QCOMPARE(graph.size(), size);
        QVERIFY((sin(x) * y + 3).node() != first);
        QCOMPARE(graph.constant(std::nan("1")), graph.constant(-std::nan("2")));
        QVERIFY(graph.constant(0.0) != graph.constant(-0.0));
    }

    void productOfEqualFactorsIsASquare() {
        FunctionGraph graph;
        const NodeId x = graph.variable(0);
        QCOMPARE(graph.binary(Operation::multiply, x, x), graph.unary(Operation::square, x));
    }

    void noInexactIdentityIsApplied() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0));
        QVERIFY((x + 0).node() != x.node());         // -0 + 0 is 0
        QVERIFY(!graph.isConstant((x - x).node()));  // NaN for infinite x
        QVERIFY(!graph.isConstant((x * 0).node()));
    }

    void foldingEqualsEvaluation() {
        constexpr unsigned seed = 20240611;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const double special[] = {0.0,    -0.0,  1,        -1,        0.5,          -2.5,         3,     7,
                                  1e-300, 1e300, infinite, -infinite, std::nan(""), 2147483648.0, -1e10, 0.1};
        for (int op = 0; op < operationCount; ++op) {
            const auto operation = static_cast<Operation>(op);
            if (!isPlain(operation)) continue;
            const int count = arity(operation);
            FunctionGraph open;
            std::vector<NodeId> variables;
            for (int k = 0; k < count; ++k) variables.push_back(open.variable(k));
            const NodeId openRoot = build(open, operation, variables);
            ReferenceEvaluator evaluator(finish(std::move(open), {openRoot}, count));
            for (int trial = 0; trial < 500; ++trial) {
                FunctionGraph closed;
                std::vector<double> values;
                std::vector<NodeId> constants;
                for (int k = 0; k < count; ++k) {
                    values.push_back(special[random() % std::size(special)]);
                    constants.push_back(closed.constant(values.back()));
                }
                const NodeId folded = build(closed, operation, constants);
                QVERIFY(closed.isConstant(folded));
                QVERIFY2(sameNumber(closed.value(folded), evaluator.evaluate(values)),
                         name(operation).data());
            }
        }
    }

    void selectOfAConstantTakesOneBranch() {
        FunctionGraph graph;
        const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
        QCOMPARE(graph.ternary(Operation::select3, graph.constant(-1), x, y), x);
        QCOMPARE(graph.ternary(Operation::select3, graph.constant(-0.0), x, y), y);
        QCOMPARE(graph.ternary(Operation::select3, graph.constant(std::nan("")), x, y), y);
        QCOMPARE(graph.quaternary(Operation::select4, graph.constant(0), x, y, z), y);
        QCOMPARE(graph.quaternary(Operation::select4, graph.constant(std::nan("")), x, y, z), z);
    }

    void unrolledLoopsEqualRunLoops_data() {
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("last");
        QTest::newRow("whole") << 1.0 << 10.0;
        QTest::newRow("fractional") << 0.5 << 3.0;
        QTest::newRow("empty") << 3.0 << 2.0;
        QTest::newRow("single") << 2.0 << 2.0;
        QTest::newRow("negative") << -3.0 << 1.5;
        QTest::newRow("NaN first") << std::nan("") << 2.0;
        QTest::newRow("NaN last") << 1.0 << std::nan("");
        QTest::newRow("long") << 0.0 << 63.0;
        QTest::newRow("too long to unroll") << 0.0 << 64.0;
    }
    void unrolledLoopsEqualRunLoops() {
        QFETCH(double, first);
        QFETCH(double, last);
        const std::vector<double> arguments{first, last, 0.75};
        for (const Operation operation : {Operation::sum, Operation::product}) {
            const Function unrolled = loopFunction(operation, first, last, true);
            const Function run = loopFunction(operation, first, last, false);
            QVERIFY(containsLoop(run));
            QCOMPARE(containsLoop(unrolled), last - first >= FunctionGraph::unrollLimit);
            QVERIFY(sameNumber(ReferenceEvaluator(unrolled).evaluate(arguments),
                               ReferenceEvaluator(run).evaluate(arguments)));
        }
    }

    void doublingNestEndsOverflowed() {
        // f0(x) = sin(x) + cos(x); f(n+1)(x) = f(n)(f(n)(x)): 2^60 calls.
        FunctionGraph first;
        const Expression x(first, first.variable(0));
        const NodeId value = (sin(x) + cos(x)).node();
        Function function = finish(std::move(first), {value}, 1);
        bool overflowed = false;
        for (int level = 0; level < 60 && !overflowed; ++level) {
            FunctionGraph graph;
            const NodeId inner[] = {graph.variable(0)};
            const NodeId middle[] = {graph.inlineCall(function, inner)};
            const NodeId outer = graph.inlineCall(function, middle);
            overflowed = graph.overflowed();
            QVERIFY(graph.size() <= FunctionGraph::nodeLimit);
            function = finish(std::move(graph), {outer}, 1);
        }
        QVERIFY(overflowed);
    }

    void anOverflowedGraphHoldsNaN() {
        FunctionGraph graph;
        for (std::size_t i = 0; i < FunctionGraph::nodeLimit + 5; ++i) graph.constant(static_cast<double>(i));
        QVERIFY(graph.overflowed());
        QVERIFY(graph.size() <= FunctionGraph::nodeLimit);
        const NodeId late = graph.unary(Operation::sine, graph.variable(0));
        QVERIFY(late < graph.size());
        QVERIFY(graph.isConstant(late) && std::isnan(graph.value(late)));
    }

    void inlinedCallsEqualCalls() {
        FunctionGraph inner;
        const Expression a(inner, inner.variable(0)), b(inner, inner.variable(1));
        const Expression p(inner, inner.parameter(3));
        const std::vector<NodeId> results{(a * b + p).node(), (sin(a) - b).node()};
        const Function callee = finish(std::move(inner), results, 2);
        FunctionGraph outer;
        const Expression x(outer, outer.variable(0));
        const NodeId arguments[] = {(x * 2).node(), (x + 1).node()};
        const NodeId first = outer.inlineCall(callee, arguments, 0),
                     second = outer.inlineCall(callee, arguments, 1);
        const Function caller = finish(std::move(outer), {first, second}, 1);
        const std::vector<double> at{0.3}, inside{0.6, 1.3}, parameters{0, 0, 0, 4.5};
        for (std::size_t result = 0; result < 2; ++result)
            QCOMPARE(ReferenceEvaluator(caller).evaluate(at, parameters, result),
                     ReferenceEvaluator(callee).evaluate(inside, parameters, result));
    }

    void inliningWithConstantsFolds() {
        FunctionGraph inner;
        const Expression a(inner, inner.variable(0));
        const Function callee = finish(std::move(inner), {(a * a + 1).node()}, 1);
        FunctionGraph outer;
        const NodeId argument[] = {outer.constant(3)};
        const NodeId folded = outer.inlineCall(callee, argument);
        QVERIFY(outer.isConstant(folded));
        QCOMPARE(outer.value(folded), 10.0);
    }

    void inliningCopiesLoopsAndCrackle() {
        FunctionGraph inner;
        CrackleSettings settings;
        settings.form = {1, 0, 0};
        const NodeId x = inner.variable(0), y = inner.variable(1), z = inner.variable(2);
        const NodeId crackle = inner.crackle(settings, x, y, z);
        const Function callee = finish(std::move(inner), {crackle}, 3);
        FunctionGraph outer;
        outer.crackle({}, outer.variable(0), outer.variable(0), outer.variable(0));
        const NodeId arguments[] = {outer.variable(2), outer.variable(1), outer.variable(0)};
        const NodeId copied = outer.inlineCall(callee, arguments);
        QCOMPARE(outer.crackleSettings(outer[copied].index).form[0], 1.0);
        const Function caller = finish(std::move(outer), {copied}, 3);
        QCOMPARE(ReferenceEvaluator(caller).evaluate(std::vector<double>{0.3, 0.2, 0.1}),
                 ReferenceEvaluator(callee).evaluate(std::vector<double>{0.1, 0.2, 0.3}));
    }
};

QTEST_APPLESS_MAIN(FunctionGraphTest)
#include "function_graph_test.moc"
