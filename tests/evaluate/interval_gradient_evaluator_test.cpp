// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/interval_gradient_evaluator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <QTest>

#include "core/numeric/noise_bounds.h"
#include "tests/support/gradient_bounds.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(31415926);

}  // namespace

class IntervalGradientEvaluatorTest : public QObject {
    Q_OBJECT

  private:
    static Checks holdFor(std::span<const Operation> operations, int rounds, std::uint64_t start) {
        RandomFunctionSettings settings;
        settings.operations.assign(operations.begin(), operations.end());
        return holdForAll(rounds, start, [&](std::mt19937_64& random) {
            settings.nodes = 1 + static_cast<int>(random() % 10);
            return randomFunction(random, settings);
        });
    }

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void randomFunctionsStayWithinTheirBounds() {
        std::vector<Operation> all;
        for (int k = 0; k < operationCount; ++k)
            if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
                all.push_back(static_cast<Operation>(k));
        const Checks checks = holdFor(all, 3000, seed);
        QVERIFY2(checks.values > 20000 && checks.climbs > 10000, qPrintable(QString::number(checks.climbs)));
    }

    void smoothFunctionsHaveBoundsOnTheirCurvature() {
        using enum Operation;
        const Operation smooth[] = {
            negate,  square,      squareRoot,        exponential, sine,        cosine,     arcTangent,
            tangent, add,         subtract,          multiply,    divide,      areaSine,   naturalLogarithm,
            power,   arcTangent2, hyperbolicTangent, arcSine,     areaTangent, areaCosine, hyperbolicCosine};
        const Checks checks = holdFor(smooth, 3000, seed + 1);
        QVERIFY2(checks.bends > 10000, qPrintable(QString::number(checks.bends)));
    }

    /// The second derivatives of these have their turns; a product of ranges seemed 5 times as large.
    void bendsOfFlatteningFunctionsAreSharp() {
        using enum Operation;
        const struct {
            Operation operation;
            double steepest, bent;
        } rows[] = {{hyperbolicTangent, 1, 4 / (3 * std::sqrt(3.0))},
                    {arcTangent, 1, 3 * std::sqrt(3.0) / 8},
                    {areaSine, 1, 2 / (3 * std::sqrt(3.0))}};
        const Box box{Interval{-2, 3, false}, unit, unit};
        for (const auto& row : rows) {
            const IntervalGradient a = over([&](auto x, auto, auto) { return apply(row.operation, x); }, box);
            QVERIFY(a.steepness >= row.steepest && a.steepness < row.steepest * (1 + 1e-12));
            QVERIFY(a.bend[0].high >= row.bent && a.bend[0].high < row.bent * (1 + 1e-12));
            QVERIFY(a.bend[0].low <= -row.bent && a.bend[0].low > -row.bent * (1 + 1e-12));
        }
    }

    /// From a point, with the choices of the box left open, bends lead to the slopes everywhere in the box.
    void piecesBendAsTheySay() {
        using enum Operation;
        std::mt19937_64 random(seed + 9);
        RandomFunctionSettings settings;
        const Operation choosing[] = {minimum,  maximum,  absolute, triangleWave, add,
                                      subtract, multiply, sine,     square,       negate};
        settings.operations.assign(std::begin(choosing), std::end(choosing));
        int checked = 0;
        for (int round = 0; round < 30000; ++round) {
            settings.nodes = 3 + static_cast<int>(random() % 10);
            const Function function = randomFunction(random, settings);
            const auto tape = Tape::compile(function);
            IntervalGradientEvaluator evaluator(tape, parameters);
            GradientEvaluator gradient(tape, parameters);
            const Box box = boxAround(random, 3, -3, 0.3);
            const IntervalGradient whole = evaluator.evaluate(box);
            if (!whole.bounded() || !whole.smooth || !whole.pieced) continue;
            // The evaluator at points cuts slopes off.
            if (whole.steepness >= GradientEvaluator::steepest) continue;
            const Point p = inside(random, box);
            const Box place{Interval::point(p[0]), Interval::point(p[1]), Interval::point(p[2])};
            const IntervalGradient at = evaluator.evaluatePieces(place);
            QVERIFY(at.bounded());
            for (int sample = 0; sample < 8; ++sample) {
                const Point q = inside(random, box);
                const auto g = gradient.evaluate(q[0], q[1], q[2]).gradient;
                double squares = 0, reach = 0;
                for (int i = 0; i < 3; ++i) {
                    SlopeRange slope = at.slope[i];
                    double turn = 0;
                    for (int j = 0; j < 3; ++j) {
                        const SlopeRange change =
                            whole.bend[bendIndex(i, j)] * SlopeRange{q[j] - p[j], q[j] - p[j]};
                        slope = slope + change;
                        turn += change.size();
                    }
                    const double slack = 1e-9 * (1 + whole.steepness);
                    QVERIFY2(g[i] >= slope.low - slack && g[i] <= slope.high + slack,
                             describe(function).c_str());
                    squares += g[i] * g[i];
                    reach += turn * turn;
                }
                QVERIFY2(std::sqrt(squares) <= at.steepness + std::sqrt(reach) + 1e-9 * (1 + whole.steepness),
                         describe(function).c_str());
                ++checked;
            }
        }
        QVERIFY2(checked > 3000, qPrintable(QString::number(checked)));
    }

    /// ceil(-0.1 - ceil z) is 0 on one side of a step and -1 on the other: not the same everywhere, whatever
    /// becomes of it.
    void aStepOfConstantsStaysAStep() {
        const Box box{unit, unit, Interval{-0.3, 0.4, false}};
        const auto make = [](auto, auto, auto z) {
            return apply(Operation::tangent, apply(Operation::ceiling, -apply(Operation::ceiling, z) - 0.1));
        };
        const IntervalGradient found = over(make, box);
        QVERIFY(found.hazard == GradientHazard::jump);
        QVERIFY(found.value.low <= std::tan(-1.0) && found.value.high >= 0);
    }

    /// A sum of a value with one step in the box and another without a bound on its slope has the values on
    /// both sides of the step.
    void aStepIsNotLostBesideWhatHasNoBounds() {
        const auto make = [](auto, auto, auto z) {
            const Expression part = apply(Operation::fraction, z);
            return apply(Operation::arcCosine, abs(part)) - part;
        };
        const auto tape = Tape::compile(functionOf(make));
        GradientEvaluator points(tape, {});
        for (const double low : {2.05, 2.41, 2.95}) {
            const Box box{unit, unit, Interval{low, low + 0.7, false}};
            const IntervalGradient whole = over(make, box);
            for (int k = 0; k <= 100; ++k) {
                const double value = points.evaluate(0, 0, low + 0.007 * k).value;
                QVERIFY(whole.value.low <= value && value <= whole.value.high);
            }
        }
    }

    /// One corner of a triangle wave is a choice between its two sides, also a period away across a cut.
    void aCornerOfATriangleWaveIsAChoice() {
        const auto wave = [](auto x, auto, auto) { return apply(Operation::triangleWave, x); };
        for (const double corner : {-1.0, -0.5, 0.0, 0.5, 2.0}) {
            const Box box{Interval{corner - 0.1, corner + 0.2, false}, unit, unit};
            IntervalGradientEvaluator evaluator(Tape::compile(functionOf(wave)), {});
            const IntervalGradient whole = evaluator.evaluate(box);
            QVERIFY(whole.bounded() && whole.smooth && whole.pieced);
            QCOMPARE(evaluator.openChoices(), std::size_t(1));
            // Sides of the choice are those behind and before the corner, wherever they are looked at.
            const double rises = corner == std::floor(corner) ? 2 : -2;
            for (const unsigned side : {0U, 1U}) {
                const IntervalGradient piece = evaluator.evaluatePiece(box, side);
                const double slope = 0.5 * piece.slope[0].low + 0.5 * piece.slope[0].high;
                QVERIFY(piece.smooth && !piece.pieced && std::abs(std::abs(slope) - 2) < 1e-12);
                const bool behind = slope * rises > 0;
                QVERIFY(std::abs(evaluator.margins()[0].value.high - (behind ? 0.4 : 0.2)) < 1e-9);
            }
        }
        for (const Interval& twoCorners :
             {Interval{-0.1, 0.6, false}, {-0.1, 0.5, false}, {-0.5, 0.1, false}})
            QVERIFY(!over(wave, {twoCorners, unit, unit}).smooth);
        // A box that ends within 1e-6 of the next corner is not told from one that holds it.
        for (const double end : {0.5 - 5e-7, 0.5 - 2e-6}) {
            const bool isOne = 0.5 - end > 1e-6;
            QCOMPARE(over(wave, {Interval{-0.1, end, false}, unit, unit}).smooth, isOne);
            QCOMPARE(over(wave, {Interval{-end, 0.1, false}, unit, unit}).smooth, isOne);
        }
        const Box behindAxis{Interval{-2, -1.9, false}, Interval{-0.1, 0.1, false}, unit};
        IntervalGradientEvaluator around(Tape::compile(functionOf([](auto x, auto y, auto) {
                                             return apply(Operation::triangleWave,
                                                          atan2(y, x) / (2 * std::numbers::pi));
                                         })),
                                         {});
        QVERIFY(around.evaluate(behindAxis).bounded());
        QCOMPARE(around.openChoices(), std::size_t(1));
        for (const double y : {-0.05, 0.05}) {
            const Box place{Interval::point(-1.95), Interval::point(y), Interval::point(0)};
            const double value = 1 - std::abs(std::atan(y / 1.95)) / std::numbers::pi;
            bool found = false;
            for (const unsigned side : {0U, 1U}) {
                const Interval piece = around.evaluatePiece(place, side).value;
                found = found || (piece.low <= value + 1e-12 && piece.high >= value - 1e-12);
            }
            QVERIFY(found);
        }
    }

    /// At a point where both sides of a choice are equal, of which the box has taken one for certain.
    void piecesAreKeptWhereADecidedChoiceTies() {
        const Box box{unit, unit, Interval{-2.5, -1, false}};
        const Box place{Interval::point(0), Interval::point(0), Interval::point(-1.2)};
        const Function function =
            functionOf([](auto, auto, auto z) { return min(z.number(-2), min(z.number(-2), z)); });
        IntervalGradientEvaluator evaluator(Tape::compile(function), {});
        const IntervalGradient whole = evaluator.evaluate(box);
        QVERIFY(whole.smooth && whole.pieced);
        // The piece that has the slope 1 lies elsewhere in the box.
        QVERIFY(evaluator.evaluatePieces(place).slope[2].high >= 1);
    }

    /// Where no margin is below 0 a piece is the function; where one is, another piece is.
    void marginsTellWhereAPieceIsTheFunction() {
        using enum Operation;
        std::mt19937_64 random(seed + 11);
        RandomFunctionSettings settings;
        const Operation choosing[] = {minimum,  maximum,  absolute, triangleWave, add,
                                      subtract, multiply, sine,     square};
        settings.operations.assign(std::begin(choosing), std::end(choosing));
        int certain = 0, excluded = 0;
        for (int round = 0; round < 150000; ++round) {
            settings.nodes = 3 + static_cast<int>(random() % 8);
            const Function function = randomFunction(random, settings);
            IntervalGradientEvaluator evaluator(Tape::compile(function), parameters);
            ReferenceEvaluator reference(function);
            const Box box = boxAround(random, 2, -2, 0.3);
            evaluator.evaluate(box);
            const std::size_t choices = evaluator.openChoices();
            if (choices == 0 || choices > 3) continue;
            const Point q = inside(random, box);
            const Box place{Interval::point(q[0]), Interval::point(q[1]), Interval::point(q[2])};
            const double value = reference.evaluate(q, parameters), slack = 1e-9 * (1 + std::abs(value));
            if (!std::isfinite(value)) continue;
            bool isHeld = false;
            for (unsigned sides = 0; sides < 1U << choices; ++sides) {
                const Interval piece = evaluator.evaluatePiece(place, sides).value;
                const bool holds = value >= piece.low - slack && value <= piece.high + slack;
                const auto margins = evaluator.margins();
                QCOMPARE(margins.size(), choices);
                if (std::ranges::any_of(margins, [](const auto& m) { return m.value.high < 0; })) {
                    ++excluded;
                    continue;
                }
                isHeld = isHeld || holds;
                if (!std::ranges::all_of(margins, [](const auto& m) { return m.value.low >= 0; })) continue;
                ++certain;
                QVERIFY2(holds, describe(function).c_str());
            }
            QVERIFY2(isHeld, describe(function).c_str());
        }
        QVERIFY2(certain > 3000 && excluded > 3000, qPrintable(QString::number(certain)));
    }

    /// A side was excluded at places where what is chosen from has no value, though another operand counts
    /// there.
    void marginsOfWhatHasNoValueExcludeNothing() {
        const Function function = functionOf([](auto x, auto y, auto) { return max(abs(sqrt(x) - 0.5), y); });
        IntervalGradientEvaluator evaluator(Tape::compile(function), {});
        evaluator.evaluate(Box{unit, unit, unit});
        QCOMPARE(evaluator.openChoices(), std::size_t(2));
        const Box place{Interval::point(-0.5), Interval::point(0.25), Interval::point(0)};
        for (unsigned sides = 0; sides < 4; ++sides) {
            evaluator.evaluatePiece(place, sides);
            for (const IntervalGradient& margin : evaluator.margins()) QVERIFY(!(margin.value.high < 0));
        }
    }

    void whatHasNoValueMayHaveAPower() {
        const Function power = functionOf([](auto x, auto y, auto) { return pow(sqrt(x), y - floor(y)); });
        const Box place{Interval{-0.5, -0.25, false}, Interval{0, 0.5, false}, unit};
        IntervalGradientEvaluator evaluator(Tape::compile(power), {});
        const double at[] = {-0.5, 0, 0};
        QCOMPARE(ReferenceEvaluator(power).evaluate(at), 1.0);
        QVERIFY(evaluator.evaluate(place).value.holds(1));
    }

    /// A logarithm of 0 and a quotient by 0 are infinite, and so no number, but comparisons and angles of
    /// them have values: they seemed to have none, and what was made of them to be the same everywhere.
    void whatIsInfiniteSomewhereIsNoConstant() {
        const Box box{unit, Interval{-1.5, 0.25, false}, unit};
        const auto steps = [](auto y) { return apply(Operation::truncate, y); };
        const IntervalGradient compared = over(
            [&](auto, auto y, auto) {
                return apply(Operation::less, apply(Operation::naturalLogarithm, steps(y)), y.number(1));
            },
            box);
        QVERIFY(compared.value.holds(0) && compared.value.holds(1) && !compared.bounded());
        const IntervalGradient turned =
            over([&](auto x, auto, auto) { return apply(Operation::arcTangent, x / x.number(0)); },
                 {Interval{0.5, 1, false}, unit, unit});
        QVERIFY(turned.value.holds(std::numbers::pi / 2));
        // A sine of infinity has no value: max() takes the other side.
        const IntervalGradient chosen = over(
            [](auto x, auto, auto) { return max(x.number(-2), sin(x * x.number(1e300) * x.number(1e300))); },
            {Interval{0.5, 1, false}, unit, unit});
        QVERIFY(chosen.value.holds(-2));
    }

    void noiseStaysWithinItsBounds() {
        using enum Operation;
        const Operation noisy[] = {noise, noiseGradientX, noiseGradientY, noiseGradientZ, add, multiply,
                                   sine};
        const Checks checks = holdFor(noisy, 1500, seed + 2);
        QVERIFY2(checks.slopes > 5000, qPrintable(QString::number(checks.slopes)));
    }

    void crackleStaysWithinItsBounds() {
        std::mt19937_64 random(seed + 3);
        for (const double metric : {1.0, 1.5, 2.0, 3.0}) {
            CrackleSettings settings;
            settings.metric = metric;
            FunctionGraph graph;
            const NodeId root =
                graph.crackle(settings, graph.variable(0), graph.variable(1), graph.variable(2));
            const Function function = finish(std::move(graph), {root}, 3);
            IntervalGradientEvaluator evaluator(Tape::compile(function), {});
            ReferenceEvaluator reference(function);
            int checked = 0;
            for (int round = 0; round < 500; ++round) {
                const Box box = boxAround(random, 5, -3, 0);
                const IntervalGradient& answer = evaluator.evaluate(box);
                QVERIFY(answer.bounded());
                const Point p = inside(random, box), q = inside(random, box);
                const double rise = std::abs(reference.evaluate(p) - reference.evaluate(q));
                QVERIFY(rise <= answer.steepness * std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) + 1e-12);
                ++checked;
            }
            QCOMPARE(checked, 500);
        }
    }

    /// Cells are constant, but only where there are any: behind a root they end within the box.
    void aPatternOfWhatMayHaveNoValueIsUnknown() {
        const auto cells = [](bool isCells, double from) {
            FunctionGraph graph;
            const Expression x(graph, graph.variable(0));
            CrackleSettings settings;
            settings.cells = isCells;
            const NodeId root = graph.crackle(settings, sqrt(x).node(), graph.variable(1), graph.variable(2));
            return IntervalGradientEvaluator(Tape::compile(finish(std::move(graph), {root}, 3)), {})
                .evaluate(
                    Box{Interval{from, 0.5, false}, Interval{0.2, 0.4, false}, Interval{0.2, 0.4, false}});
        };
        QVERIFY(cells(true, 0.25).bounded());
        for (const bool isCells : {true, false})
            QCOMPARE(cells(isCells, -0.25).hazard, GradientHazard::unknown);
    }

    void hazardsAreNamed() {
        const Box box{unit, unit, unit};
        const auto hazardOf = [&](auto make) { return over(make, box).hazard; };
        QCOMPARE(hazardOf([](auto x, auto, auto) { return sqrt(abs(x)); }), GradientHazard::steepEdge);
        QCOMPARE(hazardOf([](auto x, auto, auto) { return pow(abs(x), x.number(0.3)); }),
                 GradientHazard::steepEdge);
        QCOMPARE(hazardOf([](auto x, auto y, auto z) { return sqrt(1 - sq(x) - sq(y)) - z; }),
                 GradientHazard::steepEdge);
        QCOMPARE(hazardOf([](auto x, auto, auto) { return 1 / x - 2; }), GradientHazard::pole);
        QCOMPARE(
            hazardOf([](auto x, auto y, auto) { return apply(Operation::naturalLogarithm, sq(x) + sq(y)); }),
            GradientHazard::pole);
        QCOMPARE(hazardOf([](auto x, auto y, auto) { return atan2(y, x) - 1; }), GradientHazard::pole);
        QCOMPARE(hazardOf([](auto x, auto, auto) { return apply(Operation::tangent, 2 * x); }),
                 GradientHazard::pole);
        QCOMPARE(hazardOf([](auto x, auto y, auto) { return floor(4 * x) - y; }), GradientHazard::jump);
        QCOMPARE(hazardOf([](auto x, auto y, auto) { return mod(x, x.number(0.5)) - y; }),
                 GradientHazard::jump);
        QCOMPARE(hazardOf([](auto x, auto, auto) { return select(x, x.number(-1), x.number(1)); }),
                 GradientHazard::jump);
        QCOMPARE(hazardOf([](auto x, auto, auto) { return exp(1e4 * x); }), GradientHazard::overflow);
        QCOMPARE(hazardOf([](auto x, auto, auto) { return lessThan(x, x.number(0)); }), GradientHazard::jump);
    }

    void noiseNarrowsWithTheBox() {
        const auto formula = [](auto x, auto y, auto z) { return noise(x.number(3), x, y, z); };
        const Interval small{0.3, 0.301, false};
        const IntervalGradient wide = over(formula, {unit, unit, unit}),
                               narrow = over(formula, {small, small, small});
        QVERIFY(wide.steepness <= unclippedNoiseBounds(3).lipschitz * (1 + 1e-12));
        QVERIFY(narrow.steepness < wide.steepness && narrow.value.width() < 0.01);
    }

    void loopsAddTheirSteps() {
        FunctionGraph body;
        const Expression i(body, body.variable(0)), a(body, body.variable(1));
        const NodeId term = sin(a * i).node();
        FunctionGraph graph;
        const NodeId captured[] = {graph.variable(0)};
        const Function steps = finish(std::move(body), {term}, 2);
        const NodeId fixed =
            graph.loop(Operation::sum, graph.parameter(0), graph.constant(3), steps, captured);
        IntervalGradientEvaluator known(Tape::compile(finish(FunctionGraph(graph), {fixed}, 3)),
                                        std::vector<double>{1});
        const IntervalGradient sum = known.evaluate(Box{unit, unit, unit});
        QVERIFY(sum.bounded() && sum.steepness >= 6 && sum.steepness < 6 + 1e-9);
        const NodeId open = graph.loop(Operation::sum, graph.constant(1), graph.variable(1), steps, captured);
        IntervalGradientEvaluator unknown(Tape::compile(finish(std::move(graph), {open}, 3)), {});
        QCOMPARE(unknown.evaluate(Box{unit, unit, unit}).hazard, GradientHazard::unknown);
    }

    /// The end of a loop was taken for the one number that a floor has before its step.
    void aLoopToAStepIsUnknown() {
        FunctionGraph body;
        const Expression i(body, body.variable(0));
        const Function steps = finish(std::move(body), {i.node()}, 1);
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0));
        const NodeId end = floor(x).node();
        const NodeId loop = graph.loop(Operation::sum, graph.constant(0), end, steps, {});
        IntervalGradientEvaluator evaluator(Tape::compile(finish(std::move(graph), {loop}, 3)), {});
        const IntervalGradient across = evaluator.evaluate(Box{Interval{2.5, 3.5, false}, unit, unit});
        QVERIFY(across.hazard == GradientHazard::unknown && across.value.high >= 6);
        const IntervalGradient between = evaluator.evaluate(Box{Interval{2.25, 2.5, false}, unit, unit});
        QVERIFY(between.bounded() && between.value.holds(3) && between.value.width() < 1e-9);
    }

    /// The cosine of the angle from an axis: its operands' ranges alone allow more than 1.
    void valuesAboutTheMiddleAreNarrower() {
        const Box beside{Interval{0.1, 0.14, false}, Interval{0.5, 0.54, false},
                         Interval{-0.02, 0.02, false}};
        const Function angle = functionOf([](auto x, auto y, auto z) {
            return apply(Operation::arcCosine, y / sqrt(sq(x) + sq(y) + sq(z)));
        });
        IntervalGradientEvaluator evaluator(Tape::compile(angle), {});
        QCOMPARE(evaluator.evaluate(beside).hazard, GradientHazard::steepEdge);
        const IntervalGradient narrower = evaluator.evaluateAboutMiddle(beside);
        // The angle turns by 1 / 0.51 at most.
        QVERIFY(narrower.bounded() && narrower.steepness > 1 / 0.51 && narrower.steepness < 20);
        QVERIFY(narrower.value.low <= std::atan2(0.1, 0.54) && narrower.value.high >= std::atan2(0.14, 0.5));
        // Nothing is kept of the box.
        QCOMPARE(evaluator.evaluate(beside).hazard, GradientHazard::steepEdge);
    }

    void aPointHasItsGradient() {
        const Interval p = Interval::point(0.3), q = Interval::point(-0.7);
        const IntervalGradient at = over([](auto x, auto y, auto) { return sq(x) * y; }, {p, q, p});
        QVERIFY(std::abs(at.slope[0].low + 0.42) < 1e-14 && std::abs(at.slope[0].high + 0.42) < 1e-14);
        QVERIFY(std::abs(at.slope[1].low - 0.09) < 1e-14 && at.slope[2].low == 0 && at.slope[2].high == 0);
        QVERIFY(gradient_rules::lengthBelow(at.slope) <= std::hypot(0.42, 0.09));
    }

    /// A coordinate with one value in a flat box was taken for a constant: where x is negative, f is y.
    void aCoordinateOfOneValueIsNoConstant() {
        const IntervalGradient flat = over(
            [](auto x, auto y, auto) {
                const Expression part = max(x.number(0), x);
                return select(part, part, y, part);
            },
            {Interval{-1.5, 1.5, false}, Interval::point(0.3), unit});
        QVERIFY2(flat.slope[1].low <= 0 && flat.slope[1].high >= 1,
                 qPrintable(QString::asprintf("[%g, %g]", flat.slope[1].low, flat.slope[1].high)));
    }

    void aRemainderOfInfinityIsTheNumberItself() {
        const IntervalGradient rest = over([](auto x, auto, auto) { return mod(x, x.number(INFINITY)); },
                                           {Interval{2, 2.5, false}, unit, unit});
        QVERIFY(rest.bounded() && rest.value.holds(2.25) && rest.slope[0].high >= 1);
    }

    /// 0 counts as above 0 where there is no case of its own.
    void aSelectFrom0OnHasTheSlopesOfOneCase() {
        const IntervalGradient other = over([](auto x, auto y, auto z) { return select(x, y, z); },
                                            {Interval{0, 0.5, false}, unit, unit});
        QVERIFY(other.bounded() && other.slope[1].isZero() && other.slope[2].low == 1);
    }

    /// Beside the jump of its base a power climbs as each case does.
    void aPowerOfASelectHasTheSlopesOfItsCases() {
        const IntervalGradient power = over(
            [](auto x, auto y, auto z) { return pow(select(z, x, y), x.number(2.5)); }, {unit, unit, unit});
        QCOMPARE(power.hazard, GradientHazard::jump);
        for (const std::size_t axis : {0, 1}) QVERIFY(power.slope[axis].high >= 2.5);
    }

    /// Its slopes are those of the places where it has a value; it is not smooth, since it ends there.
    void aPowerWithoutAValueBelow0IsKnownAbove() {
        const IntervalGradient power = over([](auto x, auto, auto) { return pow(x, x.number(2.5)); },
                                            {Interval{-1, 4, false}, unit, unit});
        QVERIFY(power.bounded() && power.value.maybeUndefined && !power.smooth);
        QVERIFY(power.slope[0].high >= 20 && power.slope[0].high < 20 * (1 + 1e-12));
        QVERIFY(power.steepness >= 20 && power.steepness < 20 * (1 + 1e-12));
    }

    /// Along the divisor, too, of which the box has one value: the angle has another sign beyond its cut.
    void aQuotientOfAnAngleHasTheSlopesOfBothSidesOfTheCut() {
        const IntervalGradient quotient =
            over([](auto x, auto y, auto z) { return atan2(y, x) / z; },
                 {Interval{-2, -1, false}, Interval{-0.5, 0.5, false}, Interval::point(2)});
        QCOMPARE(quotient.hazard, GradientHazard::jump);
        const double slope = std::numbers::pi / 4;
        QVERIFY(quotient.slope[2].low <= -slope && quotient.slope[2].high >= slope);
    }

    void aCycleHasTheValuesOfBothSidesOfACut() {
        // An eighth of a cycle on one side, minus that on the other.
        const Interval cycle =
            over([](auto x, auto y,
                    auto) { return apply(Operation::cycle, atan2(y, x) / (8 * std::numbers::pi)); },
                 {Interval{-2, -1, false}, Interval{-0.5, 0.5, false}, unit})
                .value;
        const double end = std::sin(std::numbers::pi / 4);
        QVERIFY(cycle.low <= -end && cycle.high >= end);
    }

    /// The longest gradient of a function of one coordinate is its slope, also of noise.
    void noiseAlongOneAxisIsNoSteeperThanItsSlope() {
        for (const double at : {0.125, 0.5, 0.75}) {
            const IntervalGradient line =
                over([](auto x, auto, auto) { return noise(x.number(3), x, x.number(0.3), x.number(0.6)); },
                     {Interval{at, at + 0.001, false}, unit, unit});
            QVERIFY(line.bounded() && line.slope[0].size() > 0);
            QVERIFY(line.steepness <= line.slope[0].size());
        }
    }

    void theFoldIsThatOfTheLastBox() {
        const Function tube = functionOf([](auto x, auto y, auto z) { return sqrt(sq(x) + sq(y)) + sin(z); });
        IntervalGradientEvaluator evaluator(Tape::compile(tube), {});
        const Box box{Interval{3, 3.5, false}, Interval{4, 4.5, false}, unit};
        evaluator.evaluate(box);
        QVERIFY(evaluator.fold());
        const IntervalGradientEvaluator::Fold whole = *evaluator.fold();
        QVERIFY(whole.value.holds(5) && whole.axis == 0);
        IntervalGradientEvaluator::Fold part = whole;
        part.value = {5, 5.125, false};
        const IntervalGradient folded = evaluator.evaluateFolded(box, part);
        QVERIFY(folded.bounded() && folded.value.high < 6.126);
        QCOMPARE(evaluator.fold()->value, whole.value);
        QCOMPARE(evaluator.fold()->steepness, whole.steepness);
    }
};

QTEST_APPLESS_MAIN(IntervalGradientEvaluatorTest)
#include "interval_gradient_evaluator_test.moc"
