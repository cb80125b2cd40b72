// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures by cases: the values of functions with jumps, at 200 bits, are in one of them.
#include "core/evaluate/jumps/affine_cases.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <QTest>
#include <utility>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
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
constexpr std::array shares{0.0, 0.1, 0.35, 0.5, 0.65, 0.9, 1.0};
constexpr int mostParts = 40;

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

/// A part of a lane's piece, the sides it is on, and its form.
struct Part {
    double start, length;
    std::vector<std::pair<std::uint32_t, double>> sides;
    AffineForm form;
};

/// The parts of the pieces of a batch, lane by lane, each divided at its first jump until there is none; none
/// where there are too many.
std::array<std::vector<Part>, batchLanes> divide(AffineEvaluator& evaluator, const RayPieces& pieces) {
    std::array<std::vector<Part>, batchLanes> done, waiting;
    for (std::size_t lane = 0; lane < batchLanes; ++lane)
        waiting[lane].push_back({pieces.start[lane], pieces.length[lane], {}, {}});
    CaseLanes cases;
    evaluator.evaluateCases(pieces, batchLanes, cases);
    for (int round = 0; round < mostParts; ++round) {
        RayPieces parts = pieces;
        for (auto& sides : cases.sides) sides.fill(NAN);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            if (waiting[lane].empty()) continue;
            const Part& part = waiting[lane].back();
            parts.start[lane] = part.start;
            parts.length[lane] = part.length;
            for (const auto& [jump, side] : part.sides) cases.sides[jump][lane] = side;
        }
        const AffineLanes forms = evaluator.evaluateCases(parts, batchLanes, cases);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            if (waiting[lane].empty()) continue;
            Part part = waiting[lane].back();
            waiting[lane].pop_back();
            part.form = {forms.center[lane], forms.slope[lane], forms.error[lane]};
            if (cases.jump[lane] == CaseLanes::noJump || std::isnan(cases.higher[lane])) {
                done[lane].push_back(part);
                continue;
            }
            // The sum may be rounded to less than where the part ends, much less beside a short part.
            const double end = std::nextafter(part.start + part.length, INFINITY);
            const double half = part.length / 2, slack = 1e-15 * (1 + end);
            const double low = std::max(part.start, part.start + (1 + cases.low[lane]) * half - slack);
            const double high = std::min(end, part.start + (1 + cases.high[lane]) * half + slack);
            for (const bool higher : {false, true}) {
                Part side = part;
                side.sides.emplace_back(static_cast<std::uint32_t>(cases.jump[lane]),
                                        higher ? cases.higher[lane] : cases.lower[lane]);
                if (cases.rises[lane] != 0) {
                    const bool isFirst = (cases.rises[lane] > 0) != higher;
                    side.start = isFirst ? part.start : low;
                    side.length = std::nextafter((isFirst ? high : end) - side.start, INFINITY);
                }
                waiting[lane].push_back(side);
            }
        }
    }
    for (std::size_t lane = 0; lane < batchLanes; ++lane)
        if (!waiting[lane].empty()) done[lane].clear();
    return done;
}

/// Whether the form of the part admits `value` at t; also where t is beside it by a rounding.
bool holds(const Part& part, const ExactNumber& t, const ExactNumber& value) {
    ExactNumber share(0.5);
    if (part.length > 0) {
        mpfr_sub_d(share.get(), t.get(), part.start, MPFR_RNDN);
        mpfr_div_d(share.get(), share.get(), part.length, MPFR_RNDN);
    }
    const double rounded = share.rounded();
    if (rounded < -1e-9 || rounded > 1 + 1e-9) return false;
    if (rounded < 0 || rounded > 1) share = ExactNumber(std::clamp(rounded, 0.0, 1.0));
    return admits(part.form, share, value);
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
            const auto parts = divide(evaluator, pieces);
            for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                if (parts[lane].empty()) continue;
                for (const double share : shares) {
                    bool regular = true;
                    const ExactNumber t = distanceAt(pieces, lane, share);
                    const ExactNumber value =
                        evaluateExactly(function, pointAt(pieces, lane, share), {}, regular);
                    if (!regular) continue;
                    inCases += parts[lane].size() > 1;
                    const bool held = std::any_of(parts[lane].begin(), parts[lane].end(),
                                                  [&](const Part& part) { return holds(part, t, value); });
                    QVERIFY2(held, qPrintable(QString::asprintf("graph %d, lane %zu, share %g: %.17g\n",
                                                                graph, lane, share, value.rounded()) +
                                              QString::fromStdString(describe(function))));
                }
            }
        }
        QVERIFY(inCases > 5000);
    }

    /// Many lanes are run by steps, few by instructions: with the same answers.
    void stepsGiveWhatInstructionsGive() {
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings = jumpingOperations();
        int jumps = 0;
        for (int graph = 0; graph < 400; ++graph) {
            settings.nodes = 2 + static_cast<int>(random() % 20);
            Function function = randomFunction(random, settings);
            function.results.resize(1);
            AffineEvaluator evaluator(Tape::compile(function), {});
            const RayPieces pieces = randomPieces(random);
            constexpr std::size_t few = 8;
            CaseLanes many, some;
            std::array<AffineForm, few> forms;
            const AffineLanes all = evaluator.evaluateCases(pieces, batchLanes, many);
            for (std::size_t lane = 0; lane < few; ++lane)
                forms[lane] = {all.center[lane], all.slope[lane], all.error[lane]};
            const AffineLanes first = evaluator.evaluateCases(pieces, few, some);
            for (std::size_t lane = 0; lane < few; ++lane) {
                const AffineForm form{first.center[lane], first.slope[lane], first.error[lane]};
                const bool same = std::memcmp(&form, &forms[lane], sizeof form) == 0 ||
                                  (!std::isfinite(form.e) && !(forms[lane].e < INFINITY)) ||
                                  (form.e == forms[lane].e && !std::isfinite(form.e));
                QVERIFY2(same, qPrintable(QString::asprintf("graph %d, lane %zu\n", graph, lane) +
                                          QString::fromStdString(describe(function))));
                QCOMPARE(some.jump[lane], many.jump[lane]);
                QCOMPARE(some.firstLow[lane], many.firstLow[lane]);
                jumps += some.jump[lane] != CaseLanes::noJump;
            }
        }
        QVERIFY(jumps > 200);
    }

    void aJumpIsPlaced() {
        const auto tape = tapeOf([](auto x, auto, auto) { return floor(x); });
        AffineEvaluator evaluator(tape, {});
        CaseLanes cases;
        evaluator.evaluateCases(alongX(0.25, 1), 1, cases);
        QCOMPARE(cases.jump[0], 0.0);
        QCOMPARE(cases.lower[0], 0.0);
        QCOMPARE(cases.higher[0], 1.0);
        QCOMPARE(cases.rises[0], 1.0);
        // At x = 1, which is s = 0.5.
        QVERIFY(cases.low[0] <= 0.5 && cases.low[0] > 0.5 - 1e-12);
        QVERIFY(cases.high[0] >= 0.5 && cases.high[0] < 0.5 + 1e-12);
        QCOMPARE(cases.firstLow[0], cases.low[0]);
        QCOMPARE(cases.firstHigh[0], cases.high[0]);
    }

    void sidesAreNarrow() {
        const auto tape = tapeOf([](auto x, auto, auto) { return 10.0 * floor(x) + x; });
        AffineEvaluator evaluator(tape, {});
        CaseLanes cases;
        evaluator.evaluateCases(alongX(0.5, 1), 2, cases);
        QCOMPARE(cases.sides.size(), std::size_t(1));
        cases.sides[0][0] = 0;
        cases.sides[0][1] = 1;
        const AffineLanes forms = evaluator.evaluateCases(alongX(0.5, 1), 2, cases);
        for (const auto& [lane, center] : {std::pair(0, 1.0), std::pair(1, 11.0)}) {
            QCOMPARE(cases.jump[lane], CaseLanes::noJump);
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
        QCOMPARE(cases.jump[0], CaseLanes::noJump);
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
        QCOMPARE(cases.sides.size(), std::size_t(1));
        QCOMPARE(cases.jump[0], 0.0);
        for (const double side : {0.0, 1.0}) {
            cases.sides[0].fill(side);
            const AffineLanes forms = evaluator.evaluateCases(pieces, 1, cases);
            QCOMPARE(cases.jump[0], CaseLanes::noJump);
            QVERIFY(std::abs(forms.center[0] - 6) < 1e-12 && forms.error[0] < 1e-12);
        }
    }

    /// The floor and the fraction of a value jump together.
    void floorAndFractionAreOneJump() {
        const auto tape = tapeOf([](auto x, auto, auto) { return floor(x) + (x - floor(x)); });
        AffineEvaluator evaluator(tape, {});
        CaseLanes cases;
        evaluator.evaluateCases(alongX(0.5, 1), 1, cases);
        QCOMPARE(cases.sides.size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(AffineCasesTest)
#include "affine_cases_test.moc"
