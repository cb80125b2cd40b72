// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures by cases: the values of functions with jumps, at 200 bits, are in one of them.
#include "core/evaluate/algebra/affine_cases.h"

#include <algorithm>
#include <cmath>
#include <QTest>

#include "core/evaluate/affine_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/support/exact_evaluator.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::uint64_t seed = 141421;
constexpr std::array shares{0.0, 0.1, 0.35, 0.5, 0.65, 0.9, 1.0};
constexpr int mostJumps = 4;

/// Jumps and what they are made of, without parameters.
RandomFunctionSettings jumpingOperations() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.parameters = 0;
    for (int k = 0; k < operationCount; ++k)
        if (hasSides(static_cast<Operation>(k))) settings.operations.push_back(static_cast<Operation>(k));
    for (const Operation smooth :
         {Operation::add, Operation::subtract, Operation::multiply, Operation::divide, Operation::square,
          Operation::sine, Operation::absolute, Operation::minimum})
        for (int k = 0; k < 2; ++k) settings.operations.push_back(smooth);
    return settings;
}

/// The forms of all cases of a batch of pieces, lane by lane; none where there are too many.
struct Cases {
    std::array<std::vector<AffineForm>, batchLanes> forms;
    CaseLanes whole;
};

Cases enclose(AffineEvaluator& evaluator, const RayPieces& pieces) {
    Cases cases;
    cases.whole.bySides = false;
    const AffineLanes hull = evaluator.evaluateCases(pieces, batchLanes, cases.whole);
    CaseLanes sides;
    sides.bySides = true;
    std::array<bool, batchLanes> complete;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        complete[lane] = cases.whole.jumps[lane] <= mostJumps;
        if (cases.whole.jumps[lane] == 0)
            cases.forms[lane] = {{hull.center[lane], hull.slope[lane], hull.error[lane]}};
    }
    for (int side = 0; side < 1 << mostJumps; ++side) {
        sides.sides.fill(side);
        const AffineLanes forms = evaluator.evaluateCases(pieces, batchLanes, sides);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            complete[lane] = complete[lane] && sides.jumps[lane] <= cases.whole.jumps[lane];
            if (side < 1 << static_cast<int>(std::min(cases.whole.jumps[lane], double(mostJumps))))
                cases.forms[lane].push_back({forms.center[lane], forms.slope[lane], forms.error[lane]});
        }
    }
    for (std::size_t lane = 0; lane < batchLanes; ++lane)
        if (!complete[lane]) cases.forms[lane].clear();
    return cases;
}

/// A piece along the x axis from `start` on, in all lanes.
RayPieces alongX(double start, double length) {
    RayPieces pieces;
    pieces.direction[0].fill(1);
    pieces.start.fill(start);
    pieces.length.fill(length);
    return pieces;
}

}  // namespace

class AffineCasesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyValueIsInACase_data() {
        QTest::addColumn<qint64>("target");
        for (const auto& [target, name] : instructionSets()) QTest::newRow(name) << qint64(target);
    }
    void everyValueIsInACase() {
        QFETCH(qint64, target);
        const ForcedInstructionSet forced(target);
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings = jumpingOperations();
        double inCases = 0;
        for (int graph = 0; graph < 400; ++graph) {
            settings.nodes = 2 + static_cast<int>(random() % 12);
            Function function = randomFunction(random, settings);
            function.results.resize(1);
            AffineEvaluator evaluator(Tape::compile(function), {});
            const RayPieces pieces = randomPieces(random);
            const Cases cases = enclose(evaluator, pieces);
            for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                if (cases.forms[lane].empty()) continue;
                for (const double share : shares) {
                    bool regular = true;
                    const ExactNumber value =
                        evaluateExactly(function, pointAt(pieces, lane, share), {}, regular);
                    if (!regular) continue;
                    inCases += cases.forms[lane].size() > 1;
                    const bool held =
                        std::any_of(cases.forms[lane].begin(), cases.forms[lane].end(),
                                    [&](const AffineForm& form) { return admits(form, share, value); });
                    QVERIFY2(held, qPrintable(QString::asprintf("graph %d, lane %zu, share %g: %.17g\n",
                                                                graph, lane, share, value.rounded()) +
                                              QString::fromStdString(describe(function))));
                }
            }
        }
        QVERIFY(inCases > 5000);
    }

    void aJumpIsPlaced() {
        const auto tape = tapeOf([](auto x, auto, auto) { return floor(x); });
        AffineEvaluator evaluator(tape, {});
        CaseLanes cases;
        evaluator.evaluateCases(alongX(0.25, 1), 1, cases);
        QCOMPARE(cases.jumps[0], 1.0);
        // At x = 1, which is s = 0.5.
        QVERIFY(cases.first[0] <= 0.5 && cases.first[0] > 0.5 - 1e-12);
        QVERIFY(cases.last[0] >= 0.5 && cases.last[0] < 0.5 + 1e-12);
    }

    void sidesAreNarrow() {
        const auto tape = tapeOf([](auto x, auto, auto) { return 10.0 * floor(x) + x; });
        AffineEvaluator evaluator(tape, {});
        CaseLanes cases;
        cases.bySides = true;
        cases.sides.fill(0);
        cases.sides[1] = 1;
        const AffineLanes forms = evaluator.evaluateCases(alongX(0.5, 1), 2, cases);
        for (const auto& [lane, center] : {std::pair(0, 1.0), std::pair(1, 11.0)}) {
            QVERIFY(std::abs(forms.center[lane] - center) < 1e-12);
            QVERIFY(forms.error[lane] < 1e-12);
        }
    }

    /// Whole numbers remain whole: the floor of a half of an even sum is open nowhere.
    void stepsOfStepsAreExact() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            const Expression sum = floor(x) + floor(y) + floor(z);
            return sum - 2 * floor(sum / 2);
        });
        AffineEvaluator evaluator(tape, {});
        CaseLanes cases;
        RayPieces pieces = alongX(1.25, 0.5);
        pieces.origin[1].fill(-1.5);
        pieces.origin[2].fill(3.5);
        const AffineLanes forms = evaluator.evaluateCases(pieces, 1, cases);
        QCOMPARE(cases.jumps[0], 0.0);
        QCOMPARE(forms.center[0], 0.0);
        QCOMPARE(forms.error[0], 0.0);
    }

    void aConditionIsOneJump_data() {
        QTest::addColumn<bool>("isArgument");
        QTest::newRow("a value") << false;
        QTest::newRow("an argument") << true;
    }
    /// Selects on one condition take one side.
    void aConditionIsOneJump() {
        QFETCH(bool, isArgument);
        const auto tape = tapeOf([=](auto x, auto y, auto z) {
            const Expression condition = isArgument ? x : sin(x);
            return select(condition, y, z) + select(condition, z, y);
        });
        AffineEvaluator evaluator(tape, {});
        RayPieces pieces = alongX(-0.5, 1);
        pieces.origin[1].fill(1);
        pieces.origin[2].fill(5);
        CaseLanes cases;
        evaluator.evaluateCases(pieces, 1, cases);
        QCOMPARE(cases.jumps[0], 1.0);
        cases.bySides = true;
        for (const double side : {0.0, 1.0}) {
            cases.sides.fill(side);
            const AffineLanes forms = evaluator.evaluateCases(pieces, 1, cases);
            QCOMPARE(cases.jumps[0], 1.0);
            QVERIFY(std::abs(forms.center[0] - 6) < 1e-12 && forms.error[0] < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(AffineCasesTest)
#include "affine_cases_test.moc"
