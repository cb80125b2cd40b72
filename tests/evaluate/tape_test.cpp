// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape.h"

#include <QTest>
#include <algorithm>

#include "core/evaluate/tape/tape_axes.h"
#include "core/evaluate/tape/tape_cost.h"
#include "core/evaluate/tape/tape_workspace.h"
#include "core/function/graph_builder.h"

using namespace isoscope;

namespace {

struct Variables {
    explicit Variables(FunctionGraph& graph)
        : x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2)) {}
    Expression x, y, z;
};

std::shared_ptr<const Tape> compile(FunctionGraph& graph, Expression result) {
    const NodeId root = result.node();
    return Tape::compile(finish(std::move(graph), {root}, 3));
}

std::uint32_t reusedSlots(const Tape& tape) { return tape.slotCount() - tape.firstReused(); }

}  // namespace

class TapeTest : public QObject {
    Q_OBJECT

  private slots:
    void gradientsDependOnFewerAxes() {
        const auto axes = [](auto make) {
            FunctionGraph graph;
            const Variables v(graph);
            return gradientAxes(*compile(graph, make(v)));
        };
        QCOMPARE(axes([](const Variables& v) { return v.y - sin(v.x); }), std::uint8_t(0b001));
        QCOMPARE(axes([](const Variables& v) { return 2 * v.x / 3 - (v.y + 1) * 5; }), std::uint8_t(0));
        QCOMPARE(axes([](const Variables& v) { return max(v.y, v.x) + v.z; }), std::uint8_t(0b011));
        QCOMPARE(axes([](const Variables& v) { return v.x * v.y - v.z; }), std::uint8_t(0b011));
        QCOMPARE(axes([](const Variables& v) { return 1 / v.z + v.x; }), std::uint8_t(0b100));
        QCOMPARE(axes([](const Variables& v) { return sin(v.x + v.y) + v.z; }), std::uint8_t(0b011));
        FunctionGraph body;
        const Expression i(body, body.variable(0)), a(body, body.variable(1));
        const NodeId term = (a * i).node();
        const Function steps = finish(std::move(body), {term}, 2);
        FunctionGraph graph;
        const NodeId captured[] = {graph.variable(1)};
        const NodeId loop =
            graph.loop(Operation::sum, graph.parameter(0), graph.constant(3), steps, captured);
        QCOMPARE(
            gradientAxes(*compile(graph, Expression(graph, loop) + Expression(graph, graph.variable(0)))),
            std::uint8_t(0b010));
    }

    void dropsWhatNoResultNeeds() {
        FunctionGraph graph;
        const Variables v(graph);
        sin(v.x);
        exp(v.y) * 7;
        const auto tape = compile(graph, v.x + v.z);
        QCOMPARE(tape->instructions().size(), std::size_t(1));
        QCOMPARE(tape->uniformCount(), 0u);
    }

    void separatesWhatDependsOnParametersAlone() {
        FunctionGraph graph;
        const Variables v(graph);
        const Expression p(graph, graph.parameter(0)), q(graph, graph.parameter(1));
        const auto tape = compile(graph, v.x * (sin(p) + 3 * q) + 5);
        QCOMPARE(tape->instructions().size(), std::size_t(2));
        QCOMPARE(tape->uniformCount(), 2u);
        const double parameters[] = {0.5, 2};
        QCOMPARE(tape->uniforms(parameters), (std::vector<double>{std::sin(0.5) + 6, 5}));
        QCOMPARE(tape->uniforms({}), (std::vector<double>{0, 5}));
    }

    /// Evaluators compute such neighbours together.
    void sineAndCosineOfAnAngleStandSideBySide() {
        FunctionGraph graph;
        const Variables v(graph);
        const Expression angle = v.x + v.y;
        const auto tape = compile(graph, sin(angle) * exp(v.z) + exp(cos(angle)) * cos(v.y));
        std::vector<Operation> operations;
        for (const Instruction& instruction : tape->instructions())
            operations.push_back(instruction.operation);
        const auto sine = std::find(operations.begin(), operations.end(), Operation::sine);
        QVERIFY(sine != operations.begin() && sine != operations.end());
        const bool before = *(sine - 1) == Operation::cosine;
        const bool after = sine + 1 != operations.end() && *(sine + 1) == Operation::cosine;
        QVERIFY(before || after);
        const std::size_t at = static_cast<std::size_t>(sine - operations.begin());
        const Instruction& partner = tape->instructions()[before ? at - 1 : at + 1];
        QCOMPARE(partner.operands[0], tape->instructions()[at].operands[0]);
        QVERIFY(tape->instructions()[before ? at - 1 : at].target != partner.operands[0]);
    }

    /// Evaluators compute them together, too.
    void componentsOfAVectorNoiseStandSideBySide() {
        FunctionGraph graph;
        const Variables v(graph);
        const auto noise = [&](Operation component) -> Expression {
            return {graph, graph.ternary(component, v.x.node(), v.y.node(), v.z.node())};
        };
        const auto tape = compile(graph, exp(noise(Operation::noiseGradientX)) *
                                             sin(noise(Operation::noiseGradientZ) + v.x) *
                                             sqrt(noise(Operation::noiseGradientY)));
        const auto isNoise = [](const Instruction& instruction) {
            return isVectorNoise(instruction.operation);
        };
        const auto instructions = tape->instructions();
        const auto first = std::find_if(instructions.begin(), instructions.end(), isNoise);
        QCOMPARE(std::count_if(instructions.begin(), instructions.end(), isNoise), 3);
        QCOMPARE(std::count_if(first, first + 3, isNoise), 3);
    }

    void aParameterAloneIsAResult() {
        FunctionGraph graph;
        const auto tape = compile(graph, Expression(graph, graph.parameter(3)));
        QCOMPARE(tape->instructions().size(), std::size_t(0));
        QVERIFY(tape->isUniform(tape->results()[0]));
    }

    void reusesSlotsOfUnions() {
        FunctionGraph graph;
        const Variables v(graph);
        Expression total = v.x;
        for (int k = 0; k < 100; ++k)
            total = min(total, sqrt(sq(v.x - k) + sq(v.y + 2 * k) + sq(v.z - 3 * k)) - 0.5);
        const auto tape = compile(graph, total);
        QVERIFY(tape->instructions().size() > 600);
        QVERIFY2(reusedSlots(*tape) <= 4, qPrintable(QString::number(reusedSlots(*tape))));
    }

    void reusesSlotsOfRightNestedUnions() {
        // min(a, min(b, min(c, ...))) with all arguments built before the first min.
        FunctionGraph graph;
        const Variables v(graph);
        std::vector<Expression> spheres;
        for (int k = 0; k < 100; ++k) spheres.push_back(sqrt(sq(v.x - k) + sq(v.y + k)) - 1);
        Expression total = spheres.back();
        for (int k = 98; k >= 0; --k) total = min(spheres[k], total);
        QVERIFY(reusedSlots(*compile(graph, total)) <= 4);
    }

    void operandsAreWrittenBeforeTheyAreRead() {
        FunctionGraph graph;
        const Variables v(graph);
        const Expression a = sin(v.x) * v.y, b = exp(a) - v.z;
        const auto tape = compile(graph, b * a + sqrt(b) / a);
        std::vector<bool> written(tape->slotCount(), false);
        std::fill_n(written.begin(), tape->firstReused(), true);
        for (const Instruction& instruction : tape->instructions()) {
            for (int k = 0; k < instruction.operandCount; ++k) QVERIFY(written[instruction.operands[k]]);
            QVERIFY(instruction.target >= tape->firstReused());
            written[instruction.target] = true;
        }
        QVERIFY(written[tape->results()[0]]);
    }

    void aUniformOperandIsSpreadOnce() {
        FunctionGraph graph;
        const Variables v(graph);
        const auto tape = compile(graph, v.x * 3 + 5);
        const UniformValues uniforms(*tape, {});
        TapeWorkspace workspace(*tape, uniforms, 1);
        const Slot slot = tape->firstUniform();
        QVERIFY(!workspace.isSpread(0, slot, 16));
        QVERIFY(workspace.isSpread(0, slot, 16) && workspace.isSpread(0, slot, 8));
        // Not over more lanes, for another operand, or from another slot.
        QVERIFY(!workspace.isSpread(0, slot, 32));
        QVERIFY(workspace.isSpread(0, slot, 32));
        QVERIFY(!workspace.isSpread(1, slot, 32));
        QVERIFY(!workspace.isSpread(0, slot + 1, 8));
        QVERIFY(!workspace.isSpread(0, slot, 8));
        // The same memory is room for other things.
        workspace.scratch();
        QVERIFY(!workspace.isSpread(0, slot, 8));
    }

    void compilesTheLargestGraphQuickly() {
        FunctionGraph graph;
        const Variables v(graph);
        Expression total = v.x;
        for (int k = 0; !graph.overflowed() && graph.size() + 4 < FunctionGraph::nodeLimit; ++k)
            total = (total + v.y) * (k + 0.5);
        const auto tape = compile(graph, total);
        // A chain of a quarter of a million operations: a recursive or a quadratic pass would not come back.
        QVERIFY(tape->instructions().size() > 250'000);
        QCOMPARE(reusedSlots(*tape), 1u);
        QVERIFY(tape->uniforms({}).size() > 100'000);
    }

    void loopsHaveTapesOfTheirOwn() {
        FunctionGraph body;
        const NodeId term = body.binary(Operation::multiply, body.variable(0), body.variable(1));
        FunctionGraph graph;
        const NodeId captured[] = {graph.variable(1)};
        const NodeId root = graph.loop(Operation::sum, graph.constant(1), graph.variable(0),
                                       finish(std::move(body), {term}, 2), captured);
        const auto tape = Tape::compile(finish(std::move(graph), {root}, 3));
        QCOMPARE(tape->instructions().size(), std::size_t(1));
        const TapeLoop& loop = tape->loop(tape->instructions()[0].index);
        QCOMPARE(loop.body->instructions().size(), std::size_t(1));
        QCOMPARE(loop.captured, std::vector<Slot>{1});
    }

    void costsKnowNoiseAndLength() {
        const auto cost = [](auto make) {
            FunctionGraph graph;
            const Variables v(graph);
            const Expression root = make(graph, v);
            return TapeCost(*compile(graph, root));
        };
        for (const Operation noise : {Operation::noise, Operation::noiseGradientX, Operation::noiseGradientY,
                                      Operation::noiseGradientZ}) {
            const TapeCost found = cost([noise](FunctionGraph& graph, const Variables& v) -> Expression {
                return {graph, graph.ternary(noise, v.x.node(), v.y.node(), v.z.node())};
            });
            QVERIFY(found.holdsNoise && !found.cheap && !found.isLong);
        }
        const auto sines = [&](int count) {
            return cost([count](FunctionGraph&, const Variables& v) {
                Expression chain = v.x;
                for (int k = 0; k < count; ++k) chain = sin(chain);
                return chain;
            });
        };
        QVERIFY(sines(10).cheap && !sines(11).cheap && !sines(10).holdsNoise);
        QVERIFY(sines(41).isLong && !sines(40).isLong);
        // A loop counts by what it repeats.
        const TapeCost loop = cost([](FunctionGraph& graph, const Variables& v) -> Expression {
            FunctionGraph body;
            const NodeId term =
                body.ternary(Operation::noise, body.variable(0), body.variable(1), body.variable(1));
            const NodeId captured[] = {v.y.node()};
            return {graph, graph.loop(Operation::sum, graph.constant(1), v.x.node(),
                                      finish(std::move(body), {term}, 2), captured)};
        });
        QVERIFY(loop.holdsNoise && !loop.cheap && loop.isLong);
    }
};

QTEST_APPLESS_MAIN(TapeTest)
#include "tape_test.moc"
