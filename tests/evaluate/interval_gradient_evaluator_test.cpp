// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/interval_gradient_evaluator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <QTest>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/function/graph_builder.h"
#include "core/numeric/noise_bounds.h"
#include "tests/support/random_function.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::uint64_t seed = 31415926;
const std::vector<double> parameters{1.5, -2, 0.3};

using Box = std::array<Interval, 3>;
using Point = std::array<double, 3>;

Box boxAround(std::mt19937_64& random, double reach, double smallest, double largest) {
    Box box;
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(smallest, largest)(random));
    for (Interval& axis : box) {
        const double center = std::uniform_real_distribution<double>(-reach, reach)(random);
        axis = {center - size, center + size, false};
    }
    return box;
}

Point inside(std::mt19937_64& random, const Box& box) {
    Point p;
    for (int k = 0; k < 3; ++k)
        p[k] = std::uniform_real_distribution<double>(box[k].low, box[k].high)(random);
    return p;
}

template <class Make>
Function functionOf(Make make) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const NodeId root = Expression(make(x, y, z)).node();
    return finish(std::move(graph), {root}, 3);
}

template <class Make>
IntervalGradient over(Make make, const Box& box) {
    return IntervalGradientEvaluator(Tape::compile(functionOf(make)), {}).evaluate(box);
}

constexpr Interval unit{-1, 1, false};

/// What a function must obey on a box; counts what could be checked.
struct Checks {
    int values = 0, climbs = 0, slopes = 0, bends = 0;
    int finer = 0;  ///< boxes of which UnivariateParts know more
};

/// Empty when `answer` holds for the function at the two points, else what does not.
QString contradiction(const IntervalGradient& answer, ReferenceEvaluator& reference,
                      GradientEvaluator& gradient, const Point& p, const Point& q, Checks& checks) {
    const double fp = reference.evaluate(p, parameters), fq = reference.evaluate(q, parameters);
    if (std::isfinite(fp)) {
        ++checks.values;
        const double rounding = 1e-9 * (1 + std::abs(fp));
        if (!(fp >= answer.value.low - rounding && fp <= answer.value.high + rounding)) return "value";
    }
    if (!answer.bounded() || answer.value.maybeUndefined || !std::isfinite(fp) || !std::isfinite(fq))
        return {};
    const double way = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    const double rounding = 1e-9 * (1 + std::abs(fp) + std::abs(fq));
    ++checks.climbs;
    if (std::abs(fp - fq) > answer.steepness * way * (1 + 1e-9) + rounding) return "steepness";
    const ValueAndGradient gp = gradient.evaluate(p[0], p[1], p[2]), gq = gradient.evaluate(q[0], q[1], q[2]);
    const auto& a = gp.gradient;
    const double slack = 1e-9 * (1 + answer.steepness);
    // The evaluator at points cuts slopes off.
    if (answer.steepness >= GradientEvaluator::steepest) return {};
    ++checks.slopes;
    if (std::hypot(a[0], a[1], a[2]) > answer.steepness + slack) return "length";
    for (int i = 0; i < 3; ++i)
        if (!(a[i] >= answer.slope[i].low - slack && a[i] <= answer.slope[i].high + slack)) return "slope";
    if (!answer.smooth || answer.pieced) return {};
    ++checks.bends;
    for (int i = 0; i < 3; ++i) {
        double most = slack;
        for (int j = 0; j < 3; ++j)
            most += answer.bend[bendIndex(i, j)].size() * std::abs(p[j] - q[j]) * (1 + 1e-9);
        if (std::abs(a[i] - gq.gradient[i]) > most) return "bend";
    }
    return {};
}

}  // namespace

/// Roots of sums of powers of random functions of each coordinate, of every kind of exponent.
Function randomNorm(std::mt19937_64& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return functionOf([&](auto x, auto y, auto z) {
        const double exponents[] = {1, 1.5, 2, 2, 2.6, 4, 5, 2 / 0.3};
        const double e = exponents[random() % std::size(exponents)];
        const auto part = [&] {
            const auto along = number(-2, 2) * x + number(-2, 2) * y + number(-1, 1) * z;
            const auto u = random() % 3 == 0   ? sin(along)
                           : random() % 2 == 0 ? along + number(-1, 1)
                                               : sq(along);
            if (e == 2 && random() % 2 == 0) return sq(u);
            if (e == 4 && random() % 2 == 0) return pow(u, u.number(4));
            return pow(abs(u), u.number(e));
        };
        auto sum = number(0.1, 2) * part() + part();
        if (random() % 3 == 0) sum = sum + part() / 3;
        if (random() % 3 == 0) sum = sum + number(0, 0.5);
        if (random() % 4 == 0) sum = sum / number(0.2, 3);
        if (random() % 8 == 0) sum = select(sum, sum, sum.number(number(-1, 1)), sum);
        const double root = random() % 4 == 0 ? number(1, 3) / e : 1 / e;
        return root == 0.5 ? sqrt(sum) : pow(sum, x.number(root));
    });
}

/// Of one operand, which is a form or a product, and beside it of the coordinates.
Function randomRidge(std::mt19937_64& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return functionOf([&](auto x, auto y, auto z) {
        const auto u = random() % 3 == 0 ? number(-1, 1) * x * y + z
                                         : number(-2, 2) * x + number(-2, 2) * y + number(-1, 1) * z;
        auto value = u;
        for (int k = 2 + static_cast<int>(random() % 3); k > 0; --k) {
            using enum Operation;
            const Operation some[] = {sine,   exponential, hyperbolicTangent, arcTangent, areaSine,
                                      square, cosine,      absolute};
            value = apply(some[random() % std::size(some)], number(-2, 2) * value + number(-1, 1));
            if (random() % 3 == 0) value = value * u;
            if (random() % 4 == 0) value = 1 / (1.5 + sq(value));
        }
        return random() % 2 == 0 ? value : value + x * sin(y) * number(-1, 1);
    });
}

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

    template <class Draw>
    static Checks holdForAll(int rounds, std::uint64_t start, Draw draw) {
        std::mt19937_64 random(start);
        Checks checks;
        for (int round = 0; round < rounds; ++round) {
            const Function function = draw(random);
            const auto tape = Tape::compile(function);
            IntervalGradientEvaluator evaluator(tape, parameters);
            ReferenceEvaluator reference(function);
            GradientEvaluator gradient(tape, parameters);
            for (int tries = 0; tries < 3; ++tries) {
                const Box box = boxAround(random, 3, -5, 0.3);
                const IntervalGradient answer = evaluator.evaluate(box),
                                       finer = evaluator.evaluateFinely(box);
                checks.finer += finer.steepness < answer.steepness ? 1 : 0;
                for (int pair = 0; pair < 6; ++pair) {
                    const Point p = inside(random, box), q = inside(random, box);
                    QString wrong = contradiction(answer, reference, gradient, p, q, checks);
                    Checks others;
                    if (wrong.isEmpty()) wrong = contradiction(finer, reference, gradient, p, q, others);
                    if (!(finer.steepness <= answer.steepness)) wrong = "finer";
                    if (wrong.isEmpty()) continue;
                    qCritical("%s is wrong at %a %a %a in [%a,%a]x[%a,%a]x[%a,%a] for\n%s", qPrintable(wrong),
                              p[0], p[1], p[2], box[0].low, box[0].high, box[1].low, box[1].high, box[2].low,
                              box[2].high, describe(function).c_str());
                    return {};
                }
            }
        }
        return checks;
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

    void functionsOfOneOperandStayWithinFinerBounds() {
        const Checks checks = holdForAll(20000, seed + 12, randomRidge);
        QVERIFY2(checks.slopes > 200000 && checks.bends > 100000 && checks.finer > 20000,
                 qPrintable(QString::number(checks.finer)));
    }

    /// A sigmoid is no steeper than a quarter, and bends by 1/(6 sqrt 3) at most; by its operations alone it
    /// seemed steeper than 20 over this box.
    void aSigmoidIsKnownFinely() {
        const Function sigmoid =
            functionOf([](auto x, auto y, auto z) { return 1 / (1 + exp(-(x + y + z))); });
        IntervalGradientEvaluator evaluator(Tape::compile(sigmoid), {});
        QVERIFY(evaluator.hasFiner());
        const IntervalGradient coarse = evaluator.evaluate(Box{unit, unit, unit});
        const IntervalGradient fine = evaluator.evaluateFinely(Box{unit, unit, unit});
        const double steepest = std::sqrt(3.0) / 4, bent = 1 / (6 * std::sqrt(3.0));
        QVERIFY(coarse.steepness > 50 * steepest);
        QVERIFY(fine.steepness >= steepest && fine.steepness < 2.5 * steepest);
        const Interval part{-0.25, 0.25, false};
        QVERIFY(evaluator.evaluate(Box{part, part, part}).steepness > 3 * steepest);
        const IntervalGradient near = evaluator.evaluateFinely(Box{part, part, part});
        QVERIFY(near.steepness >= steepest && near.steepness < 1.06 * steepest);
        QVERIFY(near.slope[0].low > 0 && near.slope[0].high < 1.06 * 0.25);
        QVERIFY(near.bend[0].size() < 3 * bent);
        // Nothing is kept of the box.
        QCOMPARE(evaluator.evaluate(Box{unit, unit, unit}).steepness, coarse.steepness);
    }

    void whatHasNoPartsHasNothingFiner() {
        const auto hasFiner = [](auto make) {
            return IntervalGradientEvaluator(Tape::compile(functionOf(make)), {}).hasFiner();
        };
        QVERIFY(!hasFiner([](auto x, auto y, auto z) { return x * y + z; }));
        QVERIFY(!hasFiner([](auto x, auto y, auto z) { return sin(x + y) + z; }));
        // A length has its slope of its own, and one operation beside it is known exactly.
        QVERIFY(!hasFiner([](auto x, auto y, auto z) { return sin(sqrt(sq(x) + sq(y) + sq(z))); }));
        QVERIFY(hasFiner([](auto x, auto y, auto z) { return sq(sin(x * y)) + z; }));
        QVERIFY(hasFiner([](auto x, auto y, auto z) { return sq(sin(x)) * y + z; }));
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

    void rootsOfSumsOfPowersStayWithinTheirBounds() {
        const Checks checks = holdForAll(20000, seed + 4, randomNorm);
        QVERIFY2(checks.slopes > 100000 && checks.bends > 50000, qPrintable(QString::number(checks.bends)));
    }

    /// Not as wide as what the sum and its root say one after the other.
    void normsHaveSharpSlopes() {
        const Box box{Interval{0.3, 0.7, false}, Interval{0.9, 1.1, false}, unit};
        const IntervalGradient circle = over([](auto x, auto y, auto) { return sqrt(sq(x) + sq(y)); }, box);
        const double least = 0.3 / std::hypot(0.3, 1.1), most = 0.7 / std::hypot(0.7, 0.9);
        QVERIFY(std::abs(circle.slope[0].low - least) < 1e-9 && std::abs(circle.slope[0].high - most) < 1e-9);
        // A section with rounded corners, across the middle of a side: straight there, and no kink.
        const Box side{Interval{-0.1, 0.1, false}, Interval{0.9, 1.1, false}, unit};
        const IntervalGradient section = over(
            [](auto x, auto y, auto) {
                return pow(pow(abs(x), x.number(4)) + pow(abs(y), x.number(4)), x.number(0.25));
            },
            side);
        QVERIFY(section.smooth && !section.pieced);
        QVERIFY(section.slope[0].size() < 0.0015 && section.slope[1].low > 0.999);
        QVERIFY(section.bend[bendIndex(0, 0)].size() < 0.05);
    }

    /// Also about the centre, where the slopes of the sum and its root tell nothing.
    void normsOfScaledSumsHaveTheirSteepness() {
        const auto steepness = [](double factor, double exponent) {
            return over(
                       [&](auto x, auto y, auto) {
                           return pow(
                               (pow(abs(x), x.number(exponent)) + pow(abs(y), x.number(exponent))) / factor,
                               x.number(1 / exponent));
                       },
                       {unit, unit, unit})
                .steepness;
        };
        for (const double factor : {0.25, 1.0, 9.0})
            for (const double exponent : {2.0, 3.0, 4.0}) {
                const double exact = std::pow(factor, -1 / exponent), found = steepness(factor, exponent);
                QVERIFY2(found >= exact && found < exact * (1 + 1e-9),
                         qPrintable(QString("%1 for %2").arg(found).arg(exact)));
            }
    }

    /// d2/dy2 sqrt(x^2 + y^2) is x^2 / sqrt(x^2 + y^2)^3.
    void normsHaveSharpBends() {
        const Box box{Interval{0.99, 1.01, false}, Interval{-0.01, 0.01, false}, unit};
        const IntervalGradient circle =
            over([](auto x, auto y,
                    auto) { return pow(pow(abs(x), x.number(2)) + pow(abs(y), x.number(2)), x.number(0.5)); },
                 box);
        QVERIFY(circle.smooth && !circle.pieced);
        const SlopeRange across = circle.bend[bendIndex(1, 1)];
        QVERIFY2(across.low > 0.9 && across.high < 1.1,
                 qPrintable(QString("%1 to %2").arg(across.low).arg(across.high)));
        QVERIFY(circle.bend[bendIndex(0, 0)].size() < 0.01);
    }

    /// Wherever the two parts of a section are perpendicular, its slope is that of the steeper one.
    void sectionsOfPerpendicularPartsAreNoSteeperThanThese() {
        const Box box{Interval{0.45, 0.55, false}, Interval{0.45, 0.55, false}, unit};
        const auto turned = [](auto x, auto y, auto) {
            const auto a = 0.6 * x - 0.8 * y, b = 0.8 * x + 0.6 * y;
            return pow(pow(abs(a), x.number(10)) + pow(abs(b), x.number(10)), x.number(0.1));
        };
        QVERIFY(over(turned, box).bounded() && over(turned, box).steepness < 1 + 1e-9);
        const Box middle{unit, unit, unit};
        QVERIFY(over(turned, middle).bounded() && over(turned, middle).steepness < 1 + 1e-9);
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
            const Point q = ::inside(random, box);
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

    void distancesKeepTheirSlopeAtTheirCentre() {
        const Box box{unit, unit, unit};
        const IntervalGradient sphere =
            over([](auto x, auto y, auto z) { return sqrt(sq(x) + sq(y) + sq(z)) - 1; }, box);
        QVERIFY(sphere.bounded() && sphere.steepness < 1 + 1e-12);
        const IntervalGradient torus = over(
            [](auto x, auto y, auto z) { return sqrt(sq(sqrt(sq(x) + sq(z)) - 1) + sq(y)) - 0.25; }, box);
        QVERIFY(torus.bounded() && torus.steepness < 1 + 1e-12);
        const IntervalGradient turned = over(
            [](auto x, auto y, auto) { return sqrt(sq(0.6 * x - 0.8 * y) + sq(0.8 * x + 0.6 * y)); }, box);
        QVERIFY(turned.bounded() && turned.steepness < 1 + 1e-12);
        const IntervalGradient cube =
            over([](auto x, auto y, auto z) { return max(abs(x), max(abs(y), abs(z))); }, box);
        QVERIFY(cube.bounded() && cube.steepness < 1 + 1e-12);
        const IntervalGradient octahedron =
            over([](auto x, auto y, auto z) { return abs(x) + abs(y) + abs(z); }, box);
        QVERIFY(octahedron.bounded() && octahedron.steepness < std::sqrt(3.0) + 1e-12);
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
};

QTEST_APPLESS_MAIN(IntervalGradientEvaluatorTest)
#include "interval_gradient_evaluator_test.moc"
