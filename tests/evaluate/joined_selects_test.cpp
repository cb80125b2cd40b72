// SPDX-License-Identifier: GPL-3.0-or-later
// Selects that are continuous where their condition is 0: how they are told, and what gradients make of them.
#include "core/evaluate/tape/joined_selects.h"

#include <algorithm>
#include <QTest>

#include "tests/support/gradient_bounds.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(20261129);

/// How many selects a function has, and how many of them are joined.
struct Count {
    std::ptrdiff_t all = 0, joined = 0;
    bool operator==(const Count&) const = default;
};

template <class Make>
Count countOf(Make make) {
    const auto tape = Tape::compile(functionOf(make));
    const std::vector<bool> joined = joinedSelects(*tape, tape->uniforms({}));
    const auto isSelect = [](const Instruction& instruction) {
        return instruction.operation == Operation::select3 || instruction.operation == Operation::select4;
    };
    return {std::ranges::count_if(tape->instructions(), isSelect), std::ranges::count(joined, true)};
}

/// `low` at `from`, `high` at `to`, on a straight line.
Expression between(Expression u, double from, double to, Expression low, Expression high) {
    const Expression share = (u - from) / (to - from);
    return low * (1 - share) + high * share;
}

/// A colour map over u in two to four pieces, of numbers or of what changes from place to place.
Expression randomMap(std::mt19937_64& random, Expression u, std::span<const Expression> colors) {
    std::uniform_real_distribution<double> number(-1, 1);
    const int pieces = 2 + static_cast<int>(random() % 3);
    std::vector<double> ends;
    for (int k = 0; k <= pieces; ++k) ends.push_back(number(random));
    std::ranges::sort(ends);
    std::vector<Expression> chosen;
    for (int k = 0; k <= pieces; ++k)
        chosen.push_back(random() % 2 == 0 ? u.number(number(random)) : colors[random() % colors.size()]);
    Expression result = chosen.back();
    for (int k = pieces; k > 0; --k) {
        const auto i = static_cast<std::size_t>(k);
        const Expression piece = between(u, ends[i - 1], ends[i], chosen[i - 1], chosen[i]);
        result = random() % 2 == 0 ? select(ends[i] - u, result, piece) : select(u - ends[i], piece, result);
    }
    return select(u - ends[0], chosen[0], result);
}

}  // namespace

class JoinedSelectsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void sidesThatAgreeAreJoined() {
        QCOMPARE(countOf([](auto x, auto, auto) { return select(x, -x, x); }), (Count{1, 1}));
        QCOMPARE(countOf([](auto x, auto, auto) { return select(x - 1, sq(x), 2 * x - 1); }), (Count{1, 1}));
        QCOMPARE(countOf([](auto x, auto, auto) { return select(1 - x, sq(x), 2 * x - 1); }), (Count{1, 1}));
        QCOMPARE(countOf([](auto x, auto, auto) {
                     return select(x + 0.3, x + 0.3, x.number(0), x * 0 + 0.1 * x + 0.03);
                 }),
                 (Count{1, 1}));
        // Of something that is no coordinate, with sides that change elsewhere.
        QCOMPARE(countOf([](auto x, auto y, auto z) {
                     const auto u = sin(x * y);
                     return select(u - 0.25, between(u, 0, 0.25, x, z), between(u, 0.25, 1, z, y));
                 }),
                 (Count{1, 1}));
    }

    void sidesThatDoNotAreNot() {
        QCOMPARE(countOf([](auto x, auto, auto) { return select(x, -x, x + 1e-9); }), (Count{1, 0}));
        QCOMPARE(countOf([](auto x, auto y, auto) { return select(x, -y, y); }), (Count{1, 0}));
        QCOMPARE(countOf([](auto x, auto y, auto) { return select(x, x, y, x); }), (Count{1, 0}));
        QCOMPARE(countOf([](auto x, auto y, auto z) { return select(x - 0.5, y + x, z + x); }),
                 (Count{1, 0}));
        // However small a step is.
        QCOMPARE(countOf([](auto x, auto y, auto) { return select(x, 1e-15 + y, y); }), (Count{1, 0}));
        QCOMPARE(countOf([](auto x, auto, auto) { return select(x, x.number(1e-20), x.number(2e-20)); }),
                 (Count{1, 0}));
        // At 0 there is no value.
        QCOMPARE(countOf([](auto x, auto, auto) { return select(x, 1 / x, 1 / x + 1); }), (Count{1, 0}));
        // Equal where x is 1, but that is not where the condition is 0.
        QCOMPARE(countOf([](auto x, auto, auto) { return select(2 * x - 1, sq(x), 2 * x - 1); }),
                 (Count{1, 0}));
    }

    /// The sides agree at 0, but one of them has a step of its own there.
    void aStepOfASideIsAJump() {
        const IntervalGradient steps = over([](auto x, auto, auto) { return select(x, x - floor(x), x); },
                                            Box{Interval{-0.2, 0.3, false}, unit, unit});
        QCOMPARE(steps.hazard, GradientHazard::jump);
        const IntervalGradient none = over([](auto x, auto, auto) { return select(x, -2 * x, x); },
                                           Box{Interval{-0.2, 0.3, false}, unit, unit});
        QCOMPARE(none.hazard, GradientHazard::none);
        QVERIFY(none.pieced && std::abs(none.slope[0].low + 2) < 1e-12 &&
                std::abs(none.slope[0].high - 1) < 1e-12);
        QVERIFY(none.steepness >= 2 && none.steepness < 2 * (1 + 1e-12));
    }

    void mapsHaveNoJumpsAndStayWithinTheirBounds() {
        const auto draw = [](std::mt19937_64& random) {
            return functionOf([&](auto x, auto y, auto z) {
                const Expression colors[] = {x, sin(y), x * z};
                const Expression u = random() % 3 == 0 ? x * y : random() % 2 == 0 ? sin(x + z) : x;
                return randomMap(random, u, colors) + 0.5 * z;
            });
        };
        const Checks checks = holdForAll(5000, seed, draw);
        QVERIFY2(checks.slopes > 50000, qPrintable(QString::number(checks.slopes)));
        std::mt19937_64 random(seed + 1);
        int open = 0;
        for (int round = 0; round < 2000; ++round) {
            const Function function = draw(random);
            IntervalGradientEvaluator evaluator(Tape::compile(function), {});
            const IntervalGradient whole = evaluator.evaluate(boxAround(random, 1, -3, 0));
            QVERIFY2(whole.hazard == GradientHazard::none, describe(function).c_str());
            open += evaluator.openChoices() > 0 ? 1 : 0;
        }
        QVERIFY2(open > 500, qPrintable(QString::number(open)));
    }

    /// With each of the sides taken it is one of the pieces: between its ends no steeper than that.
    void sidesAreTakenOneByOne() {
        const Box box{Interval{0.4, 0.6, false}, unit, unit};
        IntervalGradientEvaluator evaluator(
            Tape::compile(functionOf([](auto x, auto, auto) { return select(0.5 - x, 3 * x - 1, x); })), {});
        evaluator.evaluate(box);
        QCOMPARE(evaluator.openChoices(), std::size_t(1));
        for (const unsigned side : {0U, 1U}) {
            const IntervalGradient piece = evaluator.evaluatePiece(box, side);
            QVERIFY(piece.smooth && !piece.pieced);
            QCOMPARE(piece.steepness, side == 0 ? 3.0 : 1.0);
            const Interval margin = evaluator.margins()[0].value;
            QVERIFY(std::abs(margin.low + 0.1) < 1e-12 && std::abs(margin.high - 0.1) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(JoinedSelectsTest)
#include "joined_selects_test.moc"
