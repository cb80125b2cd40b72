// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/gradient_evaluator.h"

#include <bit>
#include <cmath>
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/support/random_function.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::tapeOf;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(4711);
constexpr double steep = GradientEvaluator::steepest;

bool same(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// A formula of x, y, z as a tape.
template <class Make>
std::array<double, 3> gradientAt(Make make, double x, double y, double z) {
    return GradientEvaluator(tapeOf(make), {}).evaluate(x, y, z).gradient;
}

std::array<double, 3> differences(PointEvaluator& evaluator, std::array<double, 3> p) {
    constexpr double h = 1e-5;
    std::array<double, 3> result;
    for (int axis = 0; axis < 3; ++axis) {
        auto low = p, high = p;
        low[axis] -= h;
        high[axis] += h;
        result[axis] =
            (evaluator.evaluate(high[0], high[1], high[2]) - evaluator.evaluate(low[0], low[1], low[2])) /
            (high[axis] - low[axis]);
    }
    return result;
}

}  // namespace

class GradientEvaluatorTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void valuesAreThoseOfTheBatchEvaluator() {
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings;
        for (int k = 0; k < operationCount; ++k)
            if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
                settings.operations.push_back(static_cast<Operation>(k));
        for (int round = 0; round < 300; ++round) {
            const Function function = randomFunction(random, settings);
            const std::vector<double> parameters{1.5, -2, 0.3};
            const auto tape = Tape::compile(function);
            PointEvaluator batch(tape, parameters);
            GradientEvaluator gradient(tape, parameters);
            std::vector<double> x, y, z, values(90);
            for (int k = 0; k < 90; ++k) {
                x.push_back(anyNumber(random));
                y.push_back(anyNumber(random));
                z.push_back(anyNumber(random));
            }
            batch.evaluate(x, y, z, values);
            std::vector<ValueAndGradient> got(90);
            gradient.evaluate(x, y, z, got);
            for (int k = 0; k < 90; ++k) {
                QVERIFY(same(got[k].value, values[k]));
                for (const double slope : got[k].gradient) QVERIFY(std::abs(slope) <= steep);
            }
        }
    }

    void gradientsAgreeWithDifferences_data() {
        QTest::addColumn<int>("number");
        for (int k = 0; k < 30; ++k) QTest::newRow(qPrintable(QString::number(k))) << k;
    }

    void gradientsAgreeWithDifferences() {
        QFETCH(int, number);
        const auto tape = tapeOf([number](Expression x, Expression y, Expression z) {
            const Expression p = sq(x) + sq(y) + 0.5, q = x * y - z;
            switch (number) {
                case 0: return sqrt(p);
                case 1: return exp(q);
                case 2: return apply(Operation::naturalLogarithm, p);
                case 3: return apply(Operation::decimalLogarithm, p);
                case 4: return sin(q) * cos(p);
                case 5: return apply(Operation::tangent, q * 0.3);
                case 6: return apply(Operation::arcSine, sin(q) * 0.9);
                case 7: return apply(Operation::arcCosine, sin(q) * 0.9);
                case 8: return apply(Operation::arcTangent, q);
                case 9: return apply(Operation::hyperbolicSine, q);
                case 10: return apply(Operation::hyperbolicCosine, q);
                case 11: return apply(Operation::hyperbolicTangent, q);
                case 12: return apply(Operation::areaSine, q);
                case 13: return apply(Operation::areaCosine, p + 1);
                case 14: return apply(Operation::areaTangent, sin(q) * 0.9);
                case 15: return pow(p, q);
                case 16: return pow(p, p.number(2.5));
                case 17: return pow(q, p.number(3));
                case 18: return q / p;
                case 19: return 3 / p - p / 3;
                case 20: return atan2(q + 3, p);
                case 21: return mod(p * 7, p.number(2));
                case 22: return mod(p.number(2), p);
                case 23: return min(p, q) + max(q, z) - abs(q);
                case 24: return select(q, p, z * y) + select(q, x, y, z);
                case 25: return noise(p.number(2), p, q, z * 3);
                case 26: return noise(p.number(3), q, x, y * 2);
                case 27: return -q + (2 - p) * 4 - z * p;
                case 28: {
                    FunctionGraph body;
                    const Expression i(body, body.variable(0)), a(body, body.variable(1));
                    const NodeId term = (a / (i + 1)).node();
                    const NodeId captured[] = {q.node()};
                    FunctionGraph& graph = q.graph();
                    return Expression(graph, graph.loop(Operation::sum, graph.constant(1), floor(p).node(),
                                                        finish(std::move(body), {term}, 2), captured));
                }
                default: {
                    FunctionGraph body;
                    const Expression i(body, body.variable(0)), a(body, body.variable(1));
                    const NodeId term = (a + i).node();
                    const NodeId captured[] = {q.node()};
                    FunctionGraph& graph = q.graph();
                    return Expression(graph, graph.loop(Operation::product, z.node(), (z + 2.5).node(),
                                                        finish(std::move(body), {term}, 2), captured));
                }
            }
        });
        std::mt19937_64 random(seed + number);
        std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
        GradientEvaluator gradient(tape, {});
        PointEvaluator batch(tape, {});
        int agreed = 0;
        for (int round = 0; round < 200; ++round) {
            const std::array<double, 3> p{coordinate(random), coordinate(random), coordinate(random)};
            const auto got = gradient.evaluate(p[0], p[1], p[2]).gradient;
            const auto wanted = differences(batch, p);
            bool close = true;
            for (int axis = 0; axis < 3; ++axis)
                close = close &&
                        std::abs(got[axis] - wanted[axis]) <= 1e-4 * std::max(1.0, std::abs(wanted[axis]));
            agreed += close;
        }
        // A difference across a kink, a jump or a step of the quantised noise differs; few points lie there.
        QVERIFY2(agreed >= 197, qPrintable(QString::number(agreed)));
    }

    void crackleSlopesTowardsTheCellWalls() {
        FunctionGraph graph;
        const NodeId root = graph.crackle({}, graph.variable(0), graph.variable(1), graph.variable(2));
        GradientEvaluator gradient(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        const auto slopes = gradient.evaluate(0.3, 1.4, -2.2).gradient;
        const double length = std::hypot(slopes[0], slopes[1], slopes[2]);
        QVERIFY(length > 0 && length <= 2.0001);
    }

    void pointsThatLieWhereTheyAreEvaluatedGiveTheSame() {
        const auto tape =
            tapeOf([](auto x, auto y, auto z) { return sq(x) * y - sin(z * y) + sq(x - z) * 0.3; });
        GradientEvaluator evaluator(tape, {}), other(tape, {});
        const std::array<double*, 3> lanes = evaluator.pointLanes();
        std::array<std::vector<double>, 3> points;
        for (const std::size_t count : {std::size_t{64}, std::size_t{13}}) {
            for (std::size_t c = 0; c < 3; ++c) {
                points[c].resize(count);
                for (std::size_t k = 0; k < count; ++k)
                    lanes[c][k] = points[c][k] = 0.1 * static_cast<double>(k) - static_cast<double>(c);
            }
            const GradientLanes there = evaluator.evaluateLanes({lanes[0], lanes[1], lanes[2]}, count);
            const GradientLanes copied =
                other.evaluateLanes({points[0].data(), points[1].data(), points[2].data()}, count);
            for (std::size_t k = 0; k < count; ++k) {
                QCOMPARE(there.value[k], copied.value[k]);
                for (std::size_t c = 0; c < 3; ++c) {
                    QCOMPARE(there.gradient[c][k], copied.gradient[c][k]);
                    QCOMPARE(lanes[c][k], points[c][k]);
                }
            }
        }
    }

    void singularPlacesHaveADefinedAnswer() {
        using Triple = std::array<double, 3>;
        // The cone's tip: the root has no slope of its own there.
        QCOMPARE(gradientAt([](auto x, auto y, auto z) { return sqrt(sq(x) + sq(y)) - z; }, 0, 0, 0),
                 (Triple{0, 0, -1}));
        QCOMPARE(gradientAt([](auto x, auto, auto) { return sqrt(x); }, 0, 0, 0), (Triple{steep, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto, auto z) { return abs(x) + z; }, 0, 0, 0), (Triple{1, 0, 1}));
        QCOMPARE(gradientAt([](auto x, auto y, auto) { return min(x, y); }, 2, 2, 0), (Triple{1, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto y, auto) { return max(x, y); }, 2, 2, 0), (Triple{1, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto, auto) { return pow(x, x.number(0)); }, 0, 0, 0),
                 (Triple{0, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto, auto) { return pow(x, x.number(0.5)); }, 0, 0, 0),
                 (Triple{steep, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto, auto) { return pow(x, x.number(1)); }, 0, 0, 0),
                 (Triple{1, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto, auto) { return pow(x, x.number(3)); }, 0, 0, 0),
                 (Triple{0, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto y, auto) { return y / x; }, 0, 0, 0), (Triple{0, steep, 0}));
        QCOMPARE(gradientAt([](auto x, auto y, auto) { return atan2(y, x); }, 0, 0, 0), (Triple{0, 0, 0}));
        QCOMPARE(gradientAt([](auto x, auto y, auto) { return floor(x) + y; }, 3, 0, 0), (Triple{0, 1, 0}));
        QCOMPARE(gradientAt([](auto x, auto y, auto) { return sqrt(x) + y; }, -1, 0, 0), (Triple{0, 1, 0}));
        QCOMPARE(gradientAt([](auto x, auto, auto) { return apply(Operation::arcSine, x); }, 1, 0, 0),
                 (Triple{steep, 0, 0}));
    }
};

QTEST_APPLESS_MAIN(GradientEvaluatorTest)
#include "gradient_evaluator_test.moc"
