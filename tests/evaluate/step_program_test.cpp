// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/step_program.h"

#include <algorithm>
#include <functional>
#include <QTest>

#include "core/function/graph_builder.h"

using namespace isoscope;

namespace {

/// A tape's program, with all that it needs.
struct Bound {
    std::shared_ptr<const Tape> tape;
    UniformValues uniforms;
    TapeWorkspace workspace;
    StepCode code;
    StepProgram program;

    Bound(std::shared_ptr<const Tape> of, std::size_t components)
        : tape(std::move(of)),
          uniforms(*tape, {}),
          workspace(*tape, uniforms, components),
          code(*tape, tape->instructions(), tape->results(), StepProgram::numbersOf(workspace)),
          program(workspace, code) {}
};

/// The codes of a function's only stretch, or of its first.
template <class Formula>
std::vector<std::uint8_t> codesOf(Formula formula) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const NodeId root = formula(x, y, z).node();
    const Bound bound(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
    const StepProgram& program = bound.program;
    std::vector<std::uint8_t> codes;
    for (const ProgramStep& step : program.steps(program.stretches().front())) codes.push_back(step.code);
    return codes;
}

using Codes = std::vector<std::uint8_t>;
using enum StepOperation;

constexpr std::uint8_t code(StepOperation operation, StepOperand operand = StepOperand::lanes) {
    return ProgramStep::codeOf(operation, operand);
}

}  // namespace

class StepProgramTest : public QObject {
    Q_OBJECT

  private slots:
    void everyStepHasACodeOfItsOwn() {
        std::vector<bool> used(code(end) + 1);
        const auto use = [&](std::uint8_t number) {
            QVERIFY(number < used.size() && !used[number]);
            used[number] = true;
        };
        for (int k = 0; k <= static_cast<int>(end); ++k)
            for (int operand = 0;
                 operand < (k < ProgramStep::operandlessFrom ? ProgramStep::operandCount : 1); ++operand)
                use(code(static_cast<StepOperation>(k), static_cast<StepOperand>(operand)));
        QVERIFY(std::ranges::all_of(used, std::identity()));
    }

    void aSphereStaysInTheAccumulator() {
        const auto sphere = [](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1.0; };
        QCOMPARE(codesOf(sphere),
                 (Codes{code(load, StepOperand::square), code(add, StepOperand::square),
                        code(add, StepOperand::square), code(subtract, StepOperand::uniform), code(store)}));
    }

    /// Twice computed costs less than stored and read again.
    void aScaledArgumentIsComputedWhereItIsAdded() {
        const auto both = [](auto x, auto y, auto z) { return (x + y * 2.0) * (z - y * 2.0); };
        const Codes codes = codesOf(both);
        QCOMPARE(codes.size(), std::size_t(7));
        QCOMPARE(std::ranges::count(codes, code(add, StepOperand::scaled)), 1);
        QCOMPARE(std::ranges::count(codes, code(subtract, StepOperand::scaled)), 1);
        QCOMPARE(std::ranges::count(codes, code(store)), 1);
    }

    void aScaledSquareOfAnArgumentIsComputedWhereItIsUsed() {
        const auto both = [](auto x, auto y, auto z) { return (x - sq(y) * 2.0) * (z + sq(y)); };
        const Codes codes = codesOf(both);
        QCOMPARE(std::ranges::count(codes, code(subtract, StepOperand::scaledSquare)), 1);
        QCOMPARE(std::ranges::count(codes, code(add, StepOperand::square)), 1);
        QCOMPARE(std::ranges::count(codes, code(store)), 1);
    }

    void theOrderOfADifferenceIsKept() {
        const auto difference = [](auto x, auto y, auto z) { return x * y - sqrt(z); };
        QCOMPARE(codesOf(difference), (Codes{code(load), code(squareRoot),
                                             code(subtractFrom, StepOperand::product), code(store)}));
    }

    void aValueThatIsReadAgainSoonStaysInACopyOfTheAccumulator() {
        const auto product = [](auto x, auto y, auto z) { return (x + y) * (y + z); };
        QCOMPARE(codesOf(product), (Codes{code(load), code(add), code(save0), code(load), code(add),
                                          code(multiply, StepOperand::saved0), code(store)}));
    }

    /// Elsewhere its square would be computed from memory where it is added.
    void aValueThatIsJustThereIsSquaredThere() {
        const auto both = [](auto x, auto y, auto z) { return (z - sq(x - y)) * (x - y); };
        const Codes codes = codesOf(both);
        QCOMPARE(std::ranges::count(codes, code(StepOperation::square)), 1);
        QCOMPARE(std::ranges::count(codes, code(save0)), 1);
        QCOMPARE(std::ranges::count(codes, code(store)), 1);
    }

    /// Forms cost more to compute than to store, and have no copies of the accumulator.
    void otherNumbersAreComputedOnce() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)),
            z(graph, graph.variable(2));
        const NodeId root = ((x + sq(y)) * (z - sq(y))).node();
        const auto tape = Tape::compile(finish(std::move(graph), {root}, 3));
        const auto squares = [&](std::size_t components) {
            const Bound bound(tape, components);
            const StepProgram& program = bound.program;
            int count = 0;
            for (const ProgramStep& step : program.steps(program.stretches().front()))
                for (const StepOperation operation : {load, add, subtract, subtractFrom})
                    count += step.code == code(operation, StepOperand::square);
            return count;
        };
        QCOMPARE(squares(1), 2);
        QCOMPARE(squares(3), 1);
    }

    /// Choices of numbers with several components take their operands from memory as they are.
    void otherNumbersAreChosenInTheAccumulator() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)),
            z(graph, graph.variable(2));
        const NodeId root = (max(abs(x - y), x * z) * 3 - y).node();
        const Bound bound(Tape::compile(finish(std::move(graph), {root}, 3)), 4);
        const StepProgram& program = bound.program;
        QCOMPARE(program.stretches().size(), std::size_t(1));
        Codes codes;
        for (const ProgramStep& step : program.steps(program.stretches().front())) codes.push_back(step.code);
        QCOMPARE(std::ranges::count(codes, code(absolute)), 1);
        QCOMPARE(std::ranges::count(codes, code(load, StepOperand::product)), 1);
        QCOMPARE(std::ranges::count(codes, code(maximum)) + std::ranges::count(codes, code(maximumFrom)), 1);
    }

    /// There are two copies; the third value goes through memory.
    void valuesBeyondTheCopiesAreStored() {
        const auto product = [](auto x, auto y, auto z) {
            const auto p = x + y, q = y + z, r = x + z, s = x - z;
            return (p / q) / (r / s) + sqrt(p - s) * sqrt(q - r);
        };
        const Codes codes = codesOf(product);
        QVERIFY(std::ranges::count(codes, code(store)) > 1);
        QVERIFY(std::ranges::count(codes, code(save0)) >= 1);
        QVERIFY(std::ranges::count(codes, code(save1)) >= 1);
    }

    /// Copies of the accumulator do not live from one stretch to the next, nor do instructions read them.
    void whatOtherInstructionsReadIsStored() {
        const auto wave = [](auto x, auto y, auto z) { return sin(x + y) * (x + y) + z; };
        QCOMPARE(codesOf(wave), (Codes{code(load), code(add), code(store)}));
    }

    /// Memory of the caller is written once; then the workspace's own is again.
    void aResultGoesToTheCallerUntilTheNextBinding() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId root = (x * y + 1).node();
        Bound bound(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
        const Slot result = bound.tape->results()[0];
        const auto target = [&] {
            return bound.program.steps(bound.program.stretches().back()).back().target;
        };
        double* const own = bound.workspace.slot(result);
        QCOMPARE(target(), own);
        std::array<double, batchLanes> lanes{};
        QVERIFY(!bound.program.writeTo(0, lanes.data()));
        QCOMPARE(target(), own);
        QVERIFY(bound.program.writeTo(result, lanes.data()));
        QCOMPARE(target(), lanes.data());
        bound.program.bind(bound.workspace);
        QCOMPARE(target(), own);
    }

    /// Whatever is no step is an instruction between two stretches.
    void otherOperationsEndAStretch() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId root = (sin(x + y) * y).node();
        const Bound bound(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
        const StepProgram& program = bound.program;
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
        const Bound bound(Tape::compile(finish(std::move(graph), {root}, 3)), 1);
        const StepProgram& program = bound.program;
        QCOMPARE(program.stretches().size(), std::size_t(2));
        QCOMPARE(program.stretches()[0].instructions.size(), std::size_t(2));
        QCOMPARE(program.steps(program.stretches()[1]).size(), std::size_t(2));
    }
};

QTEST_APPLESS_MAIN(StepProgramTest)
#include "step_program_test.moc"
