// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/slope_evaluator.h"

#include <cmath>
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/support/exact_evaluator.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(57721);
/// 200 bits do not tell flatter slopes from 0.
constexpr double leastRise = 1e-25;

/// A ray of a bundle, and two places on its piece.
struct Ray {
    std::array<double, 3> origin, direction;
    std::array<double, 2> t;

    std::array<ExactNumber, 3> exactPoint(int k) const {
        std::array<ExactNumber, 3> point;
        for (std::size_t c = 0; c < 3; ++c) {
            mpfr_set_d(point[c].get(), t[static_cast<std::size_t>(k)], MPFR_RNDN);
            mpfr_mul_d(point[c].get(), point[c].get(), direction[c], MPFR_RNDN);
            mpfr_add_d(point[c].get(), point[c].get(), origin[c], MPFR_RNDN);
        }
        return point;
    }
    double coordinate(int k, std::size_t c) const {
        const double way = t[static_cast<std::size_t>(k)] * direction[c];
        return origin[c] + way;
    }
};

RaySpread randomSpread(std::mt19937_64& random) {
    RaySpread spread;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        const double width = lane % 8 == 0 ? 0 : std::pow(10.0, uniform(random, -6, -0.5));
        for (std::size_t c = 0; c < 3; ++c) {
            spread.origin[c][lane] = lane % 2 == 0 ? 0 : uniform(random, 0, width);
            spread.direction[c][lane] = uniform(random, 0, width);
        }
    }
    return spread;
}

Ray rayOf(const RayPieces& pieces, const RaySpread& spread, std::size_t lane, std::mt19937_64& random) {
    Ray ray;
    // Rounding must not lead out of the bundle.
    const double inside = 1 - 1e-12;
    for (std::size_t c = 0; c < 3; ++c) {
        const double a = uniform(random, -inside, inside), b = uniform(random, -inside, inside);
        ray.origin[c] = pieces.origin[c][lane] + a * spread.origin[c][lane];
        ray.direction[c] = pieces.direction[c][lane] + b * spread.direction[c][lane];
        if (spread.origin[c][lane] == 0) ray.origin[c] = pieces.origin[c][lane];
        if (spread.direction[c][lane] == 0) ray.direction[c] = pieces.direction[c][lane];
    }
    for (double& t : ray.t) t = pieces.start[lane] + uniform(random, 0, inside) * pieces.length[lane];
    return ray;
}

bool isNoMoreThan(ExactNumber value, double limit) {
    return mpfr_cmpabs(value.get(), ExactNumber(limit).get()) <= 0;
}

struct Counts {
    int slopes = 0, noises = 0;
};

/// The mean slope between two places is a slope in between.
void checkSlopes(const Function& function, std::mt19937_64& random, Counts& counts) {
    const auto tape = Tape::compile(function);
    if (!SlopeEvaluator::covers(*tape)) return;
    SlopeEvaluator slopes(tape, {});
    PointEvaluator points(tape, {});
    const RayPieces pieces = randomPieces(random);
    const RaySpread spread = randomSpread(random);
    const SlopeLanes found = slopes.evaluate(pieces, spread, batchLanes);
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        // Nor slopes of larger numbers.
        if (!(std::abs(found.value.error[lane]) < INFINITY) || found.rounding[lane] > 1e10) continue;
        const Ray ray = rayOf(pieces, spread, lane, random);
        bool regular = true;
        const std::array values{evaluateExactly(function, ray.exactPoint(0), {}, regular),
                                evaluateExactly(function, ray.exactPoint(1), {}, regular)};
        if (!regular) continue;
        if (found.spread[lane] < INFINITY && ray.t[0] != ray.t[1]) {
            ExactNumber rise, way(ray.t[1]);
            mpfr_sub(rise.get(), values[1].get(), values[0].get(), MPFR_RNDN);
            mpfr_sub_d(way.get(), way.get(), ray.t[0], MPFR_RNDN);
            mpfr_div(rise.get(), rise.get(), way.get(), MPFR_RNDN);
            mpfr_sub_d(rise.get(), rise.get(), found.slope[lane], MPFR_RNDN);
            QVERIFY2(isNoMoreThan(rise, found.spread[lane] + leastRise), describe(function).c_str());
            ++counts.slopes;
        }
        if (!(found.rounding[lane] < INFINITY)) continue;
        for (int k = 0; k < 2; ++k) {
            ExactNumber error(
                points.evaluate(ray.coordinate(k, 0), ray.coordinate(k, 1), ray.coordinate(k, 2)));
            mpfr_sub(error.get(), error.get(), values[static_cast<std::size_t>(k)].get(), MPFR_RNDN);
            QVERIFY2(isNoMoreThan(error, found.rounding[lane]), describe(function).c_str());
        }
        ++counts.noises;
    }
}

}  // namespace

class SlopeEvaluatorTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void slopesAndNoiseHold() {
        std::mt19937_64 random(seed);
        Counts counts;
        for (int round = 0; round < 6000 && !QTest::currentTestFailed(); ++round) {
            // Each instruction set in turn.
            const auto sets = instructionSets();
            const ForcedInstructionSet forced(sets[static_cast<std::size_t>(round) % sets.size()].first);
            RandomFunctionSettings settings;
            settings.nodes = 3 + round % 12;
            settings.loops = false;
            settings.parameters = 0;
            settings.operations = operationsWithSlopes();
            checkSlopes(randomFunction(random, settings), random, counts);
        }
        qInfo("%d slopes, %d noises", counts.slopes, counts.noises);
        QVERIFY(counts.slopes > 20000 && counts.noises > 20000);
    }

    /// Straight at a sphere, all is known closely.
    void aSphereIsSteepWhereItIsMet() {
        SlopeEvaluator slopes(tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1; }), {});
        RayPieces pieces;
        RaySpread spread;
        pieces.origin[2].fill(-3);
        pieces.direction[2].fill(1);
        pieces.start.fill(1.95);
        pieces.length.fill(0.1);
        for (std::size_t c = 0; c < 3; ++c) spread.direction[c].fill(c == 2 ? 1e-4 : 0.01);
        const SlopeLanes found = slopes.evaluate(pieces, spread, 1);
        QVERIFY(std::abs(found.slope[0] + 2) < 0.01);
        QVERIFY(found.spread[0] > 0.1 && found.spread[0] < 0.13);
        QVERIFY(found.rounding[0] > 1e-16 && found.rounding[0] < 5e-14);
    }

    void onlyTapesWithSlopesAreCovered() {
        QVERIFY(SlopeEvaluator::covers(*tapeOf([](auto x, auto y, auto z) { return sqrt(x) / y + sin(z); })));
        QVERIFY(!SlopeEvaluator::covers(*tapeOf([](auto x, auto y, auto) { return floor(x) + y; })));
        QVERIFY(!SlopeEvaluator::covers(*tapeOf([](auto x, auto, auto) { return x.number(3); })));
    }
};

QTEST_APPLESS_MAIN(SlopeEvaluatorTest)
#include "slope_evaluator_test.moc"
