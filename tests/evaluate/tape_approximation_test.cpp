// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_approximation.h"

#include <cmath>
#include <QTest>
#include <random>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/function/builtins/builtin.h"
#include "core/function/graph_builder.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(141421);

/// A landscape of f_ridged_mf.
std::shared_ptr<const Tape> landscape() {
    return tapeOf([](auto x, auto y, auto z) {
        const auto number = [x](double value) { return x.number(value); };
        const std::vector<Expression> arguments{x,         number(0),   z,           number(0.5), number(2.2),
                                                number(7), number(0.7), number(0.7), number(2)};
        return y - buildBuiltin(*findBuiltin("f_ridged_mf"), arguments, 2) * 0.35;
    });
}

/// Valid with the function.
std::vector<TapeApproximation> approximationsOf(const std::shared_ptr<const PreparedFunction>& function) {
    const auto global = function->global();
    return {global->approximations().begin(), global->approximations().end()};
}

std::size_t count(const SimplifiedTape& tape, Operation operation) {
    std::size_t result = 0;
    for (const Instruction& instruction : tape.instructions) result += instruction.operation == operation;
    return result;
}

/// The approximations are what they claim at many points; returns how much of the errors is used.
double largestShare(const std::shared_ptr<const Tape>& tape,
                    const std::vector<TapeApproximation>& approximations, std::mt19937_64& random) {
    constexpr std::size_t points = 20000;
    std::uniform_real_distribution<double> place(-5, 5);
    std::vector<double> x(points), y(points), z(points), wanted(points), found(points);
    for (auto* column : {&x, &y, &z})
        for (double& coordinate : *column) coordinate = place(random);
    PointEvaluator evaluator(tape, {});
    evaluator.evaluate(x, y, z, wanted);
    double share = 0;
    for (const TapeApproximation& approximation : approximations) {
        evaluator.evaluate(x, y, z, found, *approximation.tape);
        for (std::size_t i = 0; i < points; ++i) {
            const double apart = std::abs(found[i] + approximation.offset - wanted[i]);
            if (!(apart <= approximation.error + 1e-13)) return INFINITY;
            if (approximation.error > 0) share = std::max(share, apart / approximation.error);
        }
    }
    return share;
}

}  // namespace

class TapeApproximationTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// With gates that never close the clamps go, and the octaves one by one.
    void octavesAreLeftOutFromTheLast() {
        std::mt19937_64 random(seed);
        const auto tape = landscape();
        const auto function = PreparedFunction::of(tape, {});
        const std::vector<TapeApproximation> approximations = approximationsOf(function);
        QVERIFY(approximations.size() >= 6);
        QCOMPARE(approximations[0].error, 0.0);
        QCOMPARE(approximations[0].offset, 0.0);
        QCOMPARE(count(*approximations[0].tape, Operation::minimum), std::size_t(0));
        QCOMPARE(count(*approximations[0].tape, Operation::maximum), std::size_t(0));
        for (std::size_t k = 0; k < 6; ++k) QCOMPARE(count(*approximations[k].tape, Operation::noise), 7 - k);
        for (std::size_t k = 1; k < approximations.size(); ++k)
            QVERIFY(approximations[k].error > approximations[k - 1].error);
        QVERIFY(approximations[2].error < 1e-3);
        const double share = largestShare(tape, approximations, random);
        QVERIFY2(share > 0.5 && share <= 1, qPrintable(QString::number(share)));
    }

    /// A select on a number that is 0 everywhere leaves what stands for 0.
    void aChoiceAtZeroIsDecided() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const Expression turn(graph, graph.parameter(0));
        const NodeId root = (y + select(turn, noise(x.number(2), x, y, y), sin(x), cos(x))).node();
        const auto tape = Tape::compile(finish(std::move(graph), {root}, 3));
        const auto decided = [&](double value) {
            return PreparedFunction::of(tape, std::array{value})->global()->decided()->instructions;
        };
        const auto holds = [](const std::vector<Instruction>& instructions, Operation operation) {
            return std::any_of(instructions.begin(), instructions.end(),
                               [operation](const Instruction& at) { return at.operation == operation; });
        };
        QVERIFY(holds(decided(0), Operation::sine) && !holds(decided(0), Operation::cosine));
        QVERIFY(holds(decided(1), Operation::cosine) && !holds(decided(1), Operation::sine));
        QVERIFY(holds(decided(-1), Operation::noise) && !holds(decided(-1), Operation::sine));
        QCOMPARE(decided(0).size(), decided(1).size());
    }

    /// Terms behind signs, constant factors and either side of a difference.
    void termsOfAnySignAreLeftOut() {
        std::mt19937_64 random(seed + 1);
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            const auto waves = [](auto t) { return sin(t) * cos(2 * t) + sq(sin(3 * t)) * cos(5 * t); };
            auto sum = -(0.001 * waves(x) - (z - waves(y + z)) / 4);
            return 2 * (sum - 0.01 * waves(x + 2 * y) - waves(y) * waves(z)) - 0.1 * waves(x - z) + x;
        });
        const auto function = PreparedFunction::of(tape, {});
        const std::vector<TapeApproximation> approximations = approximationsOf(function);
        QVERIFY(approximations.size() >= 3);
        const double share = largestShare(tape, approximations, random);
        QVERIFY2(share > 0.3 && share <= 1, qPrintable(QString::number(share)));
    }

    /// A value that goes into the result in other ways too stays what it is.
    void valuesOfOtherUseStay() {
        std::mt19937_64 random(seed + 2);
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            const auto n = [x](auto a, auto b, auto c) { return noise(x.number(2), a, b, c); };
            const auto inner = x + 0.001 * n(x, y, z) + 0.01 * n(3 * x, y, z);
            return inner + sin(inner) * 50 + 0.1 * n(y, z, x) + 0.02 * n(2 * y, z, x);
        });
        const auto function = PreparedFunction::of(tape, {});
        const std::vector<TapeApproximation> approximations = approximationsOf(function);
        QVERIFY(approximations.size() >= 3);
        for (const TapeApproximation& approximation : approximations)
            QVERIFY(count(*approximation.tape, Operation::noise) >= 2);
        const double share = largestShare(tape, approximations, random);
        QVERIFY2(share > 0.3 && share <= 1, qPrintable(QString::number(share)));
    }

    /// A power of a sum that is 1 for its exponent of 0 is a factor, and depends on no term.
    void factorsThatAreTheSameEverywhereCount() {
        std::mt19937_64 random(seed + 4);
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)),
            z(graph, graph.variable(2));
        const Expression exponent(graph, graph.parameter(0));
        Expression sum = noise(x.number(2), x, y, z);
        for (int i = 1; i < 6; ++i) {
            const Expression scale = x.number(std::exp2(i));
            sum = sum + noise(x.number(2), scale * x, scale * y, scale * z) / scale * pow(sum, exponent);
        }
        const auto tape = Tape::compile(finish(std::move(graph), {sum.node()}, 3));
        const auto function = PreparedFunction::of(tape, {});
        const std::vector<TapeApproximation> approximations = approximationsOf(function);
        QVERIFY(approximations.size() >= 5);
        QCOMPARE(count(*approximations[4].tape, Operation::noise), std::size_t(2));
        const double share = largestShare(tape, approximations, random);
        QVERIFY2(share > 0.3 && share <= 1, qPrintable(QString::number(share)));
        const auto other = PreparedFunction::of(tape, std::vector<double>{0.5})->global();
        QVERIFY(other->approximations().size() <= 2);
    }

    /// Nor does what may have no value, or has no bounds.
    void valuesWithoutBoundsStay() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            const auto n = [x](auto a) { return noise(x.number(2), a, a, a); };
            return y + sqrt(n(x) - 0.5) + n(y) * z + exp(n(z) * x) + n(2 * z) / n(3 * z);
        });
        const auto function = PreparedFunction::of(tape, {});
        const std::vector<TapeApproximation> approximations = approximationsOf(function);
        QCOMPARE(approximations.size(), std::size_t(1));
        QCOMPARE(approximations[0].tape->instructions.size(), tape->instructions().size());
    }

    void loopsHaveNoOutline() {
        FunctionGraph body;
        const Expression k(body, body.variable(0)), t(body, body.variable(1));
        const NodeId term = (noise(k.number(2), k, t, t) * 0.001).node();
        FunctionGraph graph;
        const NodeId captured[] = {graph.variable(0)};
        const NodeId sum = graph.loop(Operation::sum, graph.constant(1), graph.parameter(0),
                                      finish(std::move(body), {term}, 2), captured);
        const auto tape = Tape::compile(finish(std::move(graph), {sum}, 3));
        QVERIFY(approximationsOf(PreparedFunction::of(tape, {})).empty());
    }

    /// Forms with a tolerance hold the values of the whole function, and are no wider than that allows.
    void formsWithSlackHoldTheFunction() {
        std::mt19937_64 random(seed + 3);
        std::uniform_real_distribution<double> place(-3, 3), length(1e-4, 0.05);
        const auto tape = landscape();
        AffineEvaluator evaluator(tape, {});
        PointEvaluator points(tape, {});
        QVERIFY(evaluator.hasApproximations());
        RayPieces pieces;
        for (const double tolerance : {0.0, 1e-4, 1e-3, 0.01, 1.0}) {
            for (std::size_t i = 0; i < batchLanes; ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    pieces.origin[c][i] = place(random);
                    pieces.direction[c][i] = place(random);
                }
                pieces.start[i] = length(random);
                pieces.length[i] = length(random);
            }
            std::array<AffineForm, batchLanes> exact;
            evaluator.evaluate(pieces, exact);
            const AffineLanes forms = evaluator.evaluate(pieces.columns(), batchLanes, tolerance);
            for (std::size_t i = 0; i < batchLanes; ++i) {
                const double e = forms.error[i];
                QVERIFY(tolerance > 0 || e == exact[i].e);
                for (const double s : {-1.0, -0.5, 0.0, 0.7, 1.0}) {
                    const double t = pieces.start[i] + 0.5 * (1 + s) * pieces.length[i];
                    const double value = points.evaluate(pieces.origin[0][i] + t * pieces.direction[0][i],
                                                         pieces.origin[1][i] + t * pieces.direction[1][i],
                                                         pieces.origin[2][i] + t * pieces.direction[2][i]);
                    QVERIFY(std::abs(value - forms.center[i] - s * forms.slope[i]) <= e + 1e-12);
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(TapeApproximationTest)
#include "tape_approximation_test.moc"
