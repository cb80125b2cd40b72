// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_program.h"

#include <QTest>

#include "core/function/graph_builder.h"

using namespace isoscope;

namespace {

/// The codes of a function's only stretch, or of its first.
template <class Formula>
std::vector<PointCode> codesOf(Formula formula) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const NodeId root = formula(x, y, z).node();
    TapeWorkspace workspace(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
    const PointProgram program(workspace);
    std::vector<PointCode> codes;
    for (const PointStep& step : program.steps(program.stretches().front())) codes.push_back(step.code);
    return codes;
}

using Codes = std::vector<PointCode>;

}  // namespace

class PointProgramTest : public QObject {
    Q_OBJECT

  private slots:
    void aSphereStaysInTheAccumulator() {
        const auto sphere = [](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1.0; };
        QCOMPARE(codesOf(sphere), (Codes{PointCode::loadSquare, PointCode::addSquare, PointCode::addSquare,
                                         PointCode::subtractUniform, PointCode::store}));
    }

    /// Twice computed costs less than stored and read again.
    void aScaledArgumentIsComputedWhereItIsAdded() {
        const auto both = [](auto x, auto y, auto z) { return (x + y * 2.0) * (z - y * 2.0); };
        const Codes codes = codesOf(both);
        QCOMPARE(std::count(codes.begin(), codes.end(), PointCode::store), 2);
        QVERIFY(std::count(codes.begin(), codes.end(), PointCode::addScaled) == 1);
        QVERIFY(std::count(codes.begin(), codes.end(), PointCode::subtractScaled) == 1);
    }

    void theOrderOfADifferenceIsKept() {
        const auto difference = [](auto x, auto y, auto z) { return x * y - sqrt(z); };
        QCOMPARE(codesOf(difference), (Codes{PointCode::load, PointCode::squareRoot,
                                             PointCode::subtractFromProduct, PointCode::store}));
    }

    /// Whatever is no step is an instruction between two stretches.
    void otherOperationsEndAStretch() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId root = (sin(x + y) * y).node();
        TapeWorkspace workspace(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
        const PointProgram program(workspace);
        QCOMPARE(program.stretches().size(), std::size_t(2));
        QCOMPARE(program.stretches()[0].instructions.size(), std::size_t(1));
        QCOMPARE(program.stretches()[0].instructions[0].operation, Operation::sine);
        QVERIFY(program.stretches()[1].instructions.empty());
        QCOMPARE(program.steps(program.stretches()[1]).size(), std::size_t(2));
    }

    /// Evaluators may compute neighbours together.
    void instructionsWithoutStepsBetweenBelongToOneStretch() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId root = (sin(x + y) * cos(x + y)).node();
        TapeWorkspace workspace(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
        const PointProgram program(workspace);
        QCOMPARE(program.stretches().size(), std::size_t(2));
        QCOMPARE(program.stretches()[0].instructions.size(), std::size_t(2));
        QCOMPARE(program.steps(program.stretches()[1]).size(), std::size_t(2));
    }
};

QTEST_APPLESS_MAIN(PointProgramTest)
#include "point_program_test.moc"
