// SPDX-License-Identifier: GPL-3.0-or-later
// The vector code of noise beside the scalar one, on every instruction set.
#include "core/evaluate/affine_evaluator.h"

#include <bit>
#include <cmath>
#include <limits>
#include <QTest>
#include <random>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/taylor_evaluator.h"
#include "core/function/graph_builder.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_gradient.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(271828);
constexpr std::size_t pointCount = 6400;

using Column = std::vector<double>;

/// Lattice points and places just beside them, huge and unusable coordinates, and plain ones.
double coordinate(std::mt19937_64& random) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double whole = std::floor(uniform(-5, 5));
    switch (random() % 8) {
        case 0: return whole;
        case 1: return whole + (random() % 2 ? 1e-11 : -1e-11);
        case 2: return uniform(-3e9, 3e9);
        case 3: {
            constexpr double special[] = {
                0,    -0.0, 2147483647.5, -2147483647.5, 2147483648.0,  -2147483648.0,
                1e30, NAN,  INFINITY,     -INFINITY,     -2147483646.5, -5.5e6};
            return special[random() % std::size(special)];
        }
        default: return uniform(-20, 20);
    }
}

/// Function of x, y, z with one result: noise of the generator, or from 4 on a component of the vector noise.
Function noiseFunction(int kind) {
    FunctionGraph graph;
    const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
    constexpr Operation components[] = {Operation::noiseGradientX, Operation::noiseGradientY,
                                        Operation::noiseGradientZ};
    const NodeId root = kind < 4 ? graph.quaternary(Operation::noise, graph.constant(kind), x, y, z)
                                 : graph.ternary(components[kind - 4], x, y, z);
    return finish(std::move(graph), {root}, 3);
}

/// noise(generator, x, 0, z) of x, y, z.
Function groundNoise(int generator) {
    FunctionGraph graph;
    const NodeId x = graph.variable(0), z = graph.variable(2);
    const NodeId root =
        graph.quaternary(Operation::noise, graph.constant(generator), x, graph.constant(0), z);
    return finish(std::move(graph), {root}, 3);
}

NoiseGradient wanted(int kind, double x, double y, double z) {
    return kind < 4 ? noiseWithGradient(kind, x, y, z) : vectorNoiseWithGradient(x, y, z)[kind - 4];
}

struct Points {
    Column x, y, z;

    explicit Points(std::uint64_t number) {
        std::mt19937_64 random(number);
        for (Column* column : {&x, &y, &z})
            for (std::size_t i = 0; i < pointCount; ++i) column->push_back(coordinate(random));
        // Planes where two corners of every cell have no weight.
        for (std::size_t i = 0; i < pointCount / 4; ++i) y[i] = 3;
        for (std::size_t i = pointCount / 8; i < pointCount / 2; ++i) z[i] = -2;
        // Neighbours that mostly share a cell, in space and in a plane.
        std::uniform_real_distribution<double> apart(0, 0.2);
        for (std::size_t i = 3 * pointCount / 4; i < pointCount; ++i)
            for (Column* column : {&x, &y, &z})
                if (i % 16 != 0) (*column)[i] = (*column)[i / 16 * 16] + apart(random);
        for (std::size_t i = 7 * pointCount / 8; i < pointCount; ++i) y[i] = 5;
        // The ground, as in noise(x, 0, z), alone and beside a plane above it.
        for (std::size_t i = pointCount / 2; i < 5 * pointCount / 8; ++i) y[i] = 0;
        for (std::size_t i = 19 * pointCount / 32; i < 5 * pointCount / 8; i += 3) y[i] = 1;
    }
};

bool sameBits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

class NoiseKernelTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// All components at one place, and two at a place which the first of them makes.
    void componentsTogetherAreThoseOneByOne() {
        FunctionGraph graph;
        const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
        const auto component = [&](Operation operation, NodeId at) {
            return graph.ternary(operation, at, y, z);
        };
        const NodeId first = component(Operation::noiseGradientX, x);
        const std::vector<NodeId> results{
            first, component(Operation::noiseGradientY, x), component(Operation::noiseGradientZ, x),
            component(Operation::noiseGradientZ, first), component(Operation::noiseGradientX, first)};
        const auto tape = Tape::compile(finish(std::move(graph), results, 3));
        const Points p(seed + 1);
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            PointEvaluator evaluator(tape, {});
            std::array<Column, 5> values;
            std::array<double*, 5> columns;
            for (std::size_t k = 0; k < values.size(); ++k) {
                values[k].resize(pointCount);
                columns[k] = values[k].data();
            }
            evaluator.evaluateAll(std::array<const double*, 3>{p.x.data(), p.y.data(), p.z.data()},
                                  pointCount, columns);
            for (std::size_t i = 0; i < pointCount; ++i) {
                const auto outer = vectorNoise(p.x[i], p.y[i], p.z[i]);
                const auto inner = vectorNoise(outer[0], p.y[i], p.z[i]);
                const std::array expected{outer[0], outer[1], outer[2], inner[2], inner[0]};
                for (std::size_t k = 0; k < expected.size(); ++k)
                    QVERIFY2(sameBits(values[k][i], expected[k]),
                             qPrintable(QString::asprintf("%s: result %zu at %.17g %.17g %.17g", name, k,
                                                          p.x[i], p.y[i], p.z[i])));
            }
        }
    }

    void valuesAreTheScalarOnesBitForBit() {
        const Points p(seed);
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (int kind = 0; kind < 7; ++kind) {
                PointEvaluator evaluator(Tape::compile(noiseFunction(kind)), {});
                Column values(pointCount);
                evaluator.evaluate(p.x, p.y, p.z, values);
                for (std::size_t i = 0; i < pointCount; ++i) {
                    const double value = kind < 4 ? noise(kind, p.x[i], p.y[i], p.z[i])
                                                  : vectorNoise(p.x[i], p.y[i], p.z[i])[kind - 4];
                    QVERIFY2(
                        sameBits(values[i], value),
                        qPrintable(QString::asprintf("%s: noise %d at %.17g %.17g %.17g: %.17g, not %.17g",
                                                     name, kind, p.x[i], p.y[i], p.z[i], values[i], value)));
                }
            }
        }
    }

    void gradientsAreTheScalarOnes() {
        const Points p(seed + 1);
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (int kind = 0; kind < 7; ++kind) {
                GradientEvaluator evaluator(Tape::compile(noiseFunction(kind)), {});
                std::vector<ValueAndGradient> found(pointCount);
                evaluator.evaluate(p.x, p.y, p.z, found);
                for (std::size_t i = 0; i < pointCount; ++i) {
                    const NoiseGradient right = wanted(kind, p.x[i], p.y[i], p.z[i]);
                    bool good = sameBits(found[i].value, right.value);
                    for (int k = 0; k < 3; ++k)
                        good = good && std::abs(found[i].gradient[k] - right.gradient[k]) < 1e-13;
                    QVERIFY2(good, qPrintable(QString::asprintf("%s: noise %d at %.17g %.17g %.17g", name,
                                                                kind, p.x[i], p.y[i], p.z[i])));
                }
            }
        }
    }

    void onTheGroundValuesAndGradientsAreTheScalarOnes() {
        const Points p(seed + 3);
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (int generator = 0; generator < 4; ++generator) {
                const auto tape = Tape::compile(groundNoise(generator));
                PointEvaluator points(tape, {});
                GradientEvaluator gradients(tape, {});
                Column values(pointCount);
                std::vector<ValueAndGradient> found(pointCount);
                points.evaluate(p.x, p.y, p.z, values);
                gradients.evaluate(p.x, p.y, p.z, found);
                for (std::size_t i = 0; i < pointCount; ++i) {
                    const NoiseGradient right = wanted(generator, p.x[i], 0, p.z[i]);
                    const auto& [x, y, z] = found[i].gradient;
                    const bool good =
                        sameBits(values[i], right.value) && sameBits(found[i].value, right.value) && y == 0 &&
                        std::abs(x - right.gradient[0]) < 1e-13 && std::abs(z - right.gradient[2]) < 1e-13;
                    QVERIFY2(good, qPrintable(QString::asprintf("%s: noise %d at %.17g 0 %.17g", name,
                                                                generator, p.x[i], p.z[i])));
                }
            }
        }
    }

    void onTheGroundFormsAndTangentsHoldTheNoise() {
        std::mt19937_64 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (int round = 0; round < 80; ++round) {
                const int generator = round % 4;
                const auto tape = Tape::compile(groundNoise(generator));
                AffineEvaluator forms(tape, {});
                TaylorEvaluator tangents(tape, {});
                RayPieces pieces;
                alignas(64) std::array<double, batchLanes> middle, reach;
                for (std::size_t i = 0; i < batchLanes; ++i) {
                    for (int k = 0; k < 3; ++k) {
                        pieces.origin[k][i] = uniform(-20, 20);
                        pieces.direction[k][i] = uniform(-1, 1);
                    }
                    pieces.length[i] = std::exp2(uniform(-12, 1));
                    middle[i] = reach[i] = pieces.length[i] / 2;
                }
                std::array<AffineForm, batchLanes> found;
                forms.evaluate(pieces, found);
                const PieceColumns columns = pieces.columns();
                const TaylorLanes lanes = tangents.evaluate(
                    {columns.origin, columns.direction, middle.data(), reach.data()}, batchLanes);
                for (std::size_t i = 0; i < batchLanes; ++i)
                    for (int k = 0; k <= 8; ++k) {
                        const double s = k / 4.0 - 1, t = middle[i] + s * reach[i];
                        const double value =
                            noise(generator, pieces.origin[0][i] + t * pieces.direction[0][i], 0,
                                  pieces.origin[2][i] + t * pieces.direction[2][i]);
                        // The places are rounded, which the bounds of exact ones need not hold.
                        const double rounding = 1e-13;
                        const double fromForm = std::abs(value - found[i].a - found[i].b * s);
                        const double fromTangent =
                            std::abs(value - lanes.point.value[i] - lanes.slope[i] * s);
                        const double bend = lanes.remainder[i] * s * s + lanes.rounding[i];
                        QVERIFY2(fromForm <= found[i].e + rounding && fromTangent <= bend + rounding,
                                 qPrintable(QString::asprintf("%s: noise %d: off by %g of %g, %g of %g", name,
                                                              generator, fromForm, found[i].e, fromTangent,
                                                              bend)));
                    }
            }
        }
    }

    /// Within cells and across their walls, along axes and lattice planes, of single rays and of bundles.
    void formsHoldTheNoiseAlongPieces() {
        std::mt19937_64 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (int round = 0; round < 140; ++round) {
                const int kind = round % 7;
                AffineEvaluator evaluator(Tape::compile(noiseFunction(kind)), {});
                RayPieces pieces;
                RaySpread spread;
                for (std::size_t i = 0; i < batchLanes; ++i) {
                    for (int k = 0; k < 3; ++k) {
                        const double place = uniform(-20, 20);
                        pieces.origin[k][i] = random() % 8 == 0 ? std::round(place) : place;
                        pieces.direction[k][i] = random() % 4 == 0 ? 0 : uniform(-1, 1);
                        spread.origin[k][i] = random() % 2 == 0 ? 0 : std::exp2(uniform(-20, -3));
                    }
                    pieces.length[i] = std::exp2(uniform(-14, 0));
                }
                const AffineLanes forms =
                    evaluator.evaluate(pieces, batchLanes, 0, round % 2 == 0 ? nullptr : &spread);
                for (std::size_t i = 0; i < batchLanes; ++i)
                    for (int k = 0; k <= 8; ++k) {
                        const double s = k / 4.0 - 1, t = 0.5 * (1 + s) * pieces.length[i];
                        std::array<double, 3> at;
                        for (int c = 0; c < 3; ++c) {
                            const double aside = round % 2 == 0 ? 0 : uniform(-1, 1) * spread.origin[c][i];
                            at[c] = pieces.origin[c][i] + t * pieces.direction[c][i] + aside;
                        }
                        const double value = wanted(kind, at[0], at[1], at[2]).value;
                        const double rest = std::abs(value - forms.center[i] - forms.slope[i] * s);
                        // The places are rounded, which the bounds of exact ones need not hold; generator 3
                        // rounds them more coarsely, and knows that.
                        QVERIFY2(rest <= forms.error[i] + 1e-13,
                                 qPrintable(QString::asprintf("%s: noise %d: off by %g of %g", name, kind,
                                                              rest, forms.error[i])));
                    }
            }
        }
    }

    /// Most short pieces leave open far less than the bound on all curvatures does.
    void bendsWithinCellsAreUsed() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> place(-20, 20);
        AffineEvaluator evaluator(Tape::compile(noiseFunction(4)), {});
        RayPieces pieces;
        for (auto* column : {&pieces.origin[0], &pieces.origin[1], &pieces.origin[2]})
            for (double& coordinate : *column) coordinate = place(random);
        pieces.direction[0].fill(0.6);
        pieces.direction[1].fill(0.8);
        pieces.length.fill(0.04);
        std::array<AffineForm, batchLanes> forms;
        evaluator.evaluate(pieces, forms);
        const double everywhere = 0.5 * latticeNoiseBounds.curvature * 0.02 * 0.02;
        int narrow = 0;
        for (const AffineForm& form : forms) {
            QVERIFY(form.e <= 1.01 * everywhere);
            narrow += form.e < everywhere / 4;
        }
        QVERIFY2(narrow > 40, qPrintable(QString::number(narrow)));
    }

    void lanesMayHaveGeneratorsOfTheirOwn() {
        FunctionGraph graph;
        const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
        const NodeId root = graph.quaternary(Operation::noise, graph.variable(3), x, y, z);
        PointEvaluator evaluator(Tape::compile(finish(std::move(graph), {root}, 4)), {});
        const Points p(seed + 2);
        Column generators;
        constexpr double numbers[] = {0, 1, 2, 3, 7, -1, 2.9, NAN, 1e30};
        for (std::size_t i = 0; i < pointCount; ++i) generators.push_back(numbers[i % std::size(numbers)]);
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            Column values(pointCount);
            const std::array<const double*, 4> arguments{p.x.data(), p.y.data(), p.z.data(),
                                                         generators.data()};
            evaluator.evaluate(arguments, pointCount, values);
            for (std::size_t i = 0; i < pointCount; ++i)
                QVERIFY2(sameBits(values[i], noise(generators[i], p.x[i], p.y[i], p.z[i])), name);
        }
    }

    /// The noise of POV-Ray in doubles lies in the form, also where generator 3 rounds its coordinates more
    /// coarsely than 2^-29 (from 6.7e6 on).
    void formsHoldNoiseThatIsQuantisedFarFromTheOrigin() {
        std::mt19937_64 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (const double distance : {1.0, 1e6, 6.7e6, 3e7, 1e9, 2.1e9})
                for (int round = 0; round < 70; ++round) {
                    const int kind = round % 7;
                    AffineEvaluator evaluator(Tape::compile(noiseFunction(kind)), {});
                    RayPieces pieces;
                    for (std::size_t i = 0; i < batchLanes; ++i) {
                        // Both ends are doubles: coordinates in one binade and a length in units of the last
                        // place.
                        for (int k = 0; k < 3; ++k) {
                            pieces.origin[k][i] = uniform(0.7, 1) * (random() % 2 ? distance : -distance);
                            pieces.direction[k][i] = double(random() % 3) - 1;
                        }
                        pieces.length[i] = std::ldexp(double(random() % 4096), std::ilogb(distance) - 52);
                    }
                    std::array<AffineForm, batchLanes> forms;
                    evaluator.evaluate(pieces, forms);
                    for (std::size_t i = 0; i < batchLanes; ++i)
                        for (const double end : {0.0, 1.0}) {
                            std::array<double, 3> at;
                            for (int k = 0; k < 3; ++k)
                                at[k] = pieces.origin[k][i] + end * pieces.length[i] * pieces.direction[k][i];
                            const double value = wanted(kind, at[0], at[1], at[2]).value;
                            const double rest = std::abs(value - forms[i].a - forms[i].b * (2 * end - 1));
                            QVERIFY2(rest <= forms[i].e,
                                     qPrintable(QString::asprintf(
                                         "%s: noise %d at %.17g %.17g %.17g: off by %g of %g", name, kind,
                                         at[0], at[1], at[2], rest, forms[i].e)));
                        }
                }
        }
    }

    void slopesOfShortPiecesAreUsed() {
        AffineEvaluator evaluator(Tape::compile(noiseFunction(2)), {});
        RayPieces pieces;
        pieces.direction[0].fill(1);
        for (std::size_t i = 0; i < batchLanes; ++i) pieces.origin[0][i] = 0.37 * double(i);
        pieces.length.fill(1e-3);
        std::array<AffineForm, batchLanes> forms;
        evaluator.evaluate(pieces, forms);
        for (const AffineForm& form : forms) QVERIFY(form.e < 1e-5);
    }
};

QTEST_APPLESS_MAIN(NoiseKernelTest)
#include "noise_kernel_test.moc"
