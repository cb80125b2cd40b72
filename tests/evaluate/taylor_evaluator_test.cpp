// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/taylor_evaluator.h"

#include <QTest>
#include <cmath>

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

const std::uint64_t seed = seedSetting(141421);

/// The middles of pieces, with a reach to their ends.
struct Places {
    RayPieces pieces;
    alignas(64) std::array<double, batchLanes> t, reach;

    explicit Places(const RayPieces& from) : pieces(from) {
        for (std::size_t i = 0; i < batchLanes; ++i) {
            reach[i] = pieces.length[i] / 2;
            t[i] = pieces.start[i] + reach[i];
        }
    }
    RayPlaces columns() const {
        const PieceColumns columns = pieces.columns();
        return {columns.origin, columns.direction, t.data(), reach.data()};
    }
    /// At t + s reach.
    std::array<ExactNumber, 3> exactPoint(std::size_t lane, double s) const {
        ExactNumber place(s);
        mpfr_mul_d(place.get(), place.get(), reach[lane], MPFR_RNDN);
        mpfr_add_d(place.get(), place.get(), t[lane], MPFR_RNDN);
        std::array<ExactNumber, 3> point;
        for (std::size_t k = 0; k < 3; ++k) {
            mpfr_mul_d(point[k].get(), place.get(), pieces.direction[k][lane], MPFR_RNDN);
            mpfr_add_d(point[k].get(), point[k].get(), pieces.origin[k][lane], MPFR_RNDN);
        }
        return point;
    }
};

/// |value - (center + slope s)| <= remainder s^2 + rounding, at 200 bits.
bool admits(const TaylorLanes& found, std::size_t lane, double s, const ExactNumber& value) {
    if (value.isNan()) return false;
    ExactNumber rest(s), limit(s);
    mpfr_mul_d(rest.get(), rest.get(), found.slope[lane], MPFR_RNDN);
    mpfr_add_d(rest.get(), rest.get(), found.point.value[lane], MPFR_RNDN);
    mpfr_sub(rest.get(), value.get(), rest.get(), MPFR_RNDN);
    mpfr_sqr(limit.get(), limit.get(), MPFR_RNDN);
    mpfr_mul_d(limit.get(), limit.get(), found.remainder[lane], MPFR_RNDN);
    mpfr_add_d(limit.get(), limit.get(), found.rounding[lane], MPFR_RNDN);
    return mpfr_cmpabs(rest.get(), limit.get()) <= 0;
}

void checkTangents(const Function& function, std::mt19937_64& random, int& checked) {
    const auto tape = Tape::compile(function);
    if (!TaylorEvaluator::covers(*tape)) return;
    TaylorEvaluator tangents(tape, {});
    const Places places(randomPieces(random));
    const TaylorLanes found = tangents.evaluate(places.columns(), batchLanes);
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        if (!std::isfinite(found.point.value[lane])) continue;
        if (!(found.remainder[lane] + found.rounding[lane] < INFINITY)) continue;
        // Near the place as well, where next to nothing is left open.
        for (const double most : {1.0, 1e-3, 1e-9}) {
            const double s = uniform(random, -most, most);
            bool regular = true;
            const ExactNumber value = evaluateExactly(function, places.exactPoint(lane, s), {}, regular);
            if (!regular) continue;
            QVERIFY2(admits(found, lane, s, value), describe(function).c_str());
            ++checked;
        }
    }
}

}  // namespace

class TaylorEvaluatorTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void functionsStayByTheirTangents() {
        std::mt19937_64 random(seed);
        int checked = 0;
        for (int round = 0; round < 6000 && !QTest::currentTestFailed(); ++round) {
            // Each instruction set in turn.
            const auto sets = instructionSets();
            const ForcedInstructionSet forced(sets[static_cast<std::size_t>(round) % sets.size()].first);
            RandomFunctionSettings settings;
            settings.nodes = 3 + round % 12;
            settings.loops = false;
            settings.parameters = 0;
            settings.operations = operationsWithSlopes();
            for (const Operation noise :
                 {Operation::noiseGradientX, Operation::noiseGradientY, Operation::noiseGradientZ})
                settings.operations.push_back(noise);
            checkTangents(randomFunction(random, settings), random, checked);
        }
        qInfo("%d places", checked);
        QVERIFY(checked > 100000);
    }

    /// Every generator, along rays in planes of lattice points too, and clipped.
    void noiseStaysByItsTangent() {
        std::mt19937_64 random(seed + 1);
        int checked = 0;
        for (int round = 0; round < 600 && !QTest::currentTestFailed(); ++round) {
            FunctionGraph graph;
            const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)),
                z(graph, graph.variable(2));
            const double scale = std::pow(10.0, uniform(random, -1, 2));
            const Expression level = round % 3 == 0 ? x.number(round % 7 - 3) : y * scale;
            const NodeId root =
                (noise(x.number(round % 4), x * scale, level, z * scale) * (sq(x) + 0.3)).node();
            checkTangents(finish(std::move(graph), {root}, 3), random, checked);
        }
        qInfo("%d places", checked);
        QVERIFY(checked > 50000);
    }

    /// Of a sphere the tangent leaves open what the square of the way adds.
    void aSphereLeavesItsTangentBySquares() {
        TaylorEvaluator tangents(tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1; }),
                                 {});
        RayPieces pieces;
        pieces.origin[2].fill(-3);
        pieces.direction[2].fill(1);
        pieces.start.fill(1.75);
        pieces.length.fill(0.5);
        const Places places(pieces);
        const TaylorLanes found = tangents.evaluate(places.columns(), 1);
        QCOMPARE(found.point.value[0], 0.0);
        QCOMPARE(found.point.gradient[2][0], -2.0);
        QCOMPARE(found.slope[0], -0.5);
        QVERIFY(std::abs(found.remainder[0] - 0.0625) < 1e-12);
        QVERIFY(found.rounding[0] < 1e-14);
    }

    /// A kink within reach leaves nothing of the tangent, one beyond it all.
    void kinksCountWithinReach() {
        TaylorEvaluator tangents(tapeOf([](auto x, auto, auto) { return abs(x); }), {});
        RayPieces pieces;
        pieces.direction[0].fill(1);
        pieces.start.fill(1);
        pieces.length.fill(1);
        pieces.start[1] = -0.25;
        const Places places(pieces);
        const TaylorLanes found = tangents.evaluate(places.columns(), 2);
        QVERIFY(found.slope[0] == 0.5 && found.rounding[0] < 1e-15);
        QVERIFY(found.slope[1] == 0 && found.remainder[1] == 0);
        QVERIFY(std::abs(found.rounding[1] - 0.5) < 1e-12);
    }

    void onlyTapesWithTangentsAreCovered() {
        QVERIFY(TaylorEvaluator::covers(
            *tapeOf([](auto x, auto y, auto z) { return sqrt(x) / y + noise(x.number(2), x, y, z); })));
        QVERIFY(!TaylorEvaluator::covers(*tapeOf([](auto x, auto y, auto) { return floor(x) + y; })));
        QVERIFY(!TaylorEvaluator::covers(*tapeOf([](auto x, auto, auto) { return x.number(3); })));
    }
};

QTEST_APPLESS_MAIN(TaylorEvaluatorTest)
#include "taylor_evaluator_test.moc"
