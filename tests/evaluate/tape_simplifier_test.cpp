// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_simplifier.h"

#include <bit>
#include <cmath>
#include <QTest>
#include <random>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/function/builtins/builtin.h"
#include "core/function/graph_builder.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(161803);

std::shared_ptr<const Tape> unionOfBalls(int count) {
    return tapeOf([count](auto x, auto y, auto z) {
        Expression result = x.number(10);
        for (int k = 0; k < count; ++k)
            result = min(result, sq(x - std::cos(k)) + sq(y - std::sin(k)) + sq(z - k * 0.1) - 0.01);
        return result;
    });
}

RayPieces alongX(double y, double z, double start, double length) {
    RayPieces pieces;
    pieces.origin[0].fill(-3);
    pieces.origin[1].fill(y);
    pieces.origin[2].fill(z);
    pieces.direction[0].fill(1);
    pieces.start.fill(start);
    pieces.length.fill(length);
    return pieces;
}

}  // namespace

class TapeSimplifierTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void openChoicesKeepTheWholeTape() {
        const auto tape = unionOfBalls(5);
        const TapeLinks links(*tape);
        TapeSimplifier simplifier(links);
        QCOMPARE(simplifier.choiceCount(), std::size_t(5));
        SimplifiedTape simplifiedTape;
        simplifier.simplify(std::vector<Choice>(5, Choice::open), 0, simplifiedTape);
        QCOMPARE(simplifiedTape.instructions.size(), tape->instructions().size());
    }

    void decidedChoicesLeaveOneBall() {
        const auto tape = unionOfBalls(5);
        const TapeLinks links(*tape);
        TapeSimplifier simplifier(links);
        SimplifiedTape simplifiedTape;
        // The last ball alone: three differences (or arguments), three squares, two sums, one difference.
        std::vector<Choice> choices(5, Choice::first);
        choices[4] = Choice::second;
        simplifier.simplify(choices, 0, simplifiedTape);
        QVERIFY(simplifiedTape.instructions.size() <= 9);
        // None of them: the constant.
        simplifier.simplify(std::vector<Choice>(5, Choice::first), 0, simplifiedTape);
        QVERIFY(simplifiedTape.instructions.empty());
        QVERIFY(tape->isUniform(simplifiedTape.result));
        GradientEvaluator gradients(tape, {});
        const double at[] = {1, 2};
        const GradientLanes constant = gradients.evaluateLanes({at, at, at}, 2, simplifiedTape);
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(constant.value[i], 10.0);
            for (const double* slope : constant.gradient) QCOMPARE(slope[i], 0.0);
        }
    }

    /// Of a union nothing has to be left; a clamped factor can go, what it is a factor of cannot.
    void theLeastLengthIsWhatNoChoiceSpares() {
        const auto balls = unionOfBalls(5);
        QCOMPARE(TapeLinks(*balls).leastLength(), std::size_t(0));
        // The difference, the product, the absolute value, and y + 2.
        const auto clamped =
            tapeOf([](auto x, auto y, auto z) { return abs(y + 2) * max(x * x - z, 0) - 1; });
        QCOMPARE(TapeLinks(*clamped).leastLength(), std::size_t(4));
    }

    /// Long chains of min and max are passed many links at once: what is left is the same.
    void chainsLeaveWhatTheirLinksLeave() {
        std::mt19937_64 random(seed);
        const auto below = [&](int count) {
            return static_cast<int>(random() % static_cast<unsigned>(count));
        };
        for (int round = 0; round < 200; ++round) {
            const auto tape = tapeOf([&](auto x, auto y, auto z) {
                const auto part = [&] { return sq(x - below(100)) + sq(y) - z * below(100); };
                std::vector<Expression> values{part()};
                for (int k = 0; k < 300; ++k) {
                    // Mostly chains, to the left and to the right, with others among them.
                    const Expression last = values.back();
                    const Expression other =
                        below(8) > 0 ? part() : values[static_cast<std::size_t>(below(k + 1))];
                    const int kind = below(20);
                    values.push_back(kind == 0   ? abs(last)
                                     : kind == 1 ? select(other, last, part())
                                     : kind < 10 ? min(last, other)
                                     : kind < 14 ? min(other, last)
                                                 : max(last, other));
                }
                return values.back();
            });
            const TapeLinks links(*tape);
            TapeSimplifier simplifier(links);
            const int open = below(20);
            std::vector<LaneChoices> choices(simplifier.choiceCount());
            for (LaneChoices& choice : choices)
                if (below(20) >= open) (below(3) > 0 ? choice.first : choice.second) = 1;
            DecidedChoices decided;
            decided.reset(links);
            decided.add(links.chains().places, choices, 1);
            SimplifiedTape oneByOne, atOnce;
            simplifier.simplify(choices, 1, 0, oneByOne);
            simplifier.simplify(decided, atOnce);
            QCOMPARE(atOnce.result, oneByOne.result);
            QCOMPARE(atOnce.resultValue, oneByOne.resultValue);
            QCOMPARE(atOnce.levelNumbers, oneByOne.levelNumbers);
            QCOMPARE(atOnce.instructions.size(), oneByOne.instructions.size());
            for (std::size_t k = 0; k < atOnce.instructions.size(); ++k) {
                const Instruction &a = atOnce.instructions[k], &b = oneByOne.instructions[k];
                QVERIFY(a.operation == b.operation && a.target == b.target && a.operands == b.operands &&
                        a.number == b.number);
            }
        }
    }

    /// A union of 1000 parts is one chain; what is left of it is found by some words of bits.
    void aUnionIsOneChain() {
        const auto tape = unionOfBalls(1000);
        const TapeLinks links(*tape);
        const TapeLinks::Chains& chains = links.chains();
        std::size_t leading = 0;
        for (const std::uint64_t bits : chains.leadsByFirst)
            leading += static_cast<std::size_t>(std::popcount(bits));
        QCOMPARE(leading, std::size_t(999));
        for (const std::uint64_t bits : chains.leadsBySecond) QCOMPARE(bits, std::uint64_t(0));
    }

    void negativeAbsoluteValueBecomesANegation() {
        const auto tape = tapeOf([](auto x, auto, auto) { return abs(x) - 1; });
        const TapeLinks links(*tape);
        TapeSimplifier simplifier(links);
        SimplifiedTape simplifiedTape;
        simplifier.simplify(std::vector{Choice::second}, 0, simplifiedTape);
        QCOMPARE(simplifiedTape.instructions.front().operation, Operation::negate);
        simplifier.simplify(std::vector{Choice::first}, 0, simplifiedTape);
        QCOMPARE(simplifiedTape.instructions.size(), std::size_t(1));
    }

    void choicesOfAPieceAreNoted() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            return max(x, y) + min(x, y) + abs(x) + select(x, y, z) + select(y, z, x, y);
        });
        const TapeLinks links(*tape);
        TapeSimplifier simplifier(links);
        AffineEvaluator evaluator(tape, {});
        std::vector<LaneChoices> choices;
        // x from 1 to 2, y = -1: every choice is decided.
        evaluator.evaluateChoices(alongX(-1, 0, 4, 1), 1, nullptr, choices);
        QCOMPARE(choices.size(), simplifier.choiceCount());
        for (const LaneChoices& choice : choices) QVERIFY(choice.of(0) != Choice::open);
        // x from -2 to 2, y = 0: none is.
        evaluator.evaluateChoices(alongX(0, 0, 1, 4), 1, nullptr, choices);
        for (const LaneChoices& choice : choices) QCOMPARE(choice.of(0), Choice::open);
    }

    void aPieceTakesTheSideThatItsValuesAreOn() {
        // x from 1 to 2, and the y that is told.
        const auto sideOf = [](auto make, double y) {
            AffineEvaluator evaluator(tapeOf(make), {});
            std::vector<LaneChoices> choices;
            evaluator.evaluateChoices(alongX(y, 0, 4, 1), 3, nullptr, choices);
            return evaluator.evaluations() == 3 && choices.size() == 1 ? choices[0].ofAll(0b111)
                                                                       : Choice::open;
        };
        const auto least = [](auto x, auto y, auto) { return min(x, y); };
        QCOMPARE(sideOf(least, 5), Choice::first);
        QCOMPARE(sideOf(least, -1), Choice::second);
        const auto greatest = [](auto x, auto y, auto) { return max(x, y); };
        QCOMPARE(sideOf(greatest, -1), Choice::first);
        QCOMPARE(sideOf(greatest, 5), Choice::second);
        const auto size = [](auto, auto y, auto) { return abs(y); };
        QCOMPARE(sideOf(size, 5), Choice::first);
        QCOMPARE(sideOf(size, -1), Choice::second);
        const auto selected = [](auto x, auto y, auto z) { return select(y, x, z); };
        QCOMPARE(sideOf(selected, -1), Choice::first);
        QCOMPARE(sideOf(selected, 5), Choice::second);
    }

    void ofCasesThatComeToTheSameAConstantIsLeft() {
        const auto left = [](auto make) {
            const auto tape = tapeOf(make);
            return cheapestCase(*tape, tape->instructions().back());
        };
        QCOMPARE(left([](auto x, auto y, auto) { return select(x, y, x.number(1)); }), Choice::second);
        QCOMPARE(left([](auto x, auto y, auto z) { return select(x, y, z, x.number(1)); }), Choice::second);
        QCOMPARE(left([](auto x, auto y, auto) { return select(x, x.number(1), y); }), Choice::first);
        QCOMPARE(left([](auto x, auto y, auto z) { return select(x, y, z); }), Choice::first);
        QCOMPARE(left([](auto x, auto, auto) { return select(x, x.number(1), x.number(2)); }), Choice::first);
    }

    void signsAreAtStakeInUnionsAndDifferences() {
        constexpr double threshold = 0.75;
        constexpr double none = 1e9;
        const auto levelsOf = [&](const std::shared_ptr<const Tape>& tape) {
            const TapeLinks links(*tape);
            const std::vector<SignLevel> levels = links.levels(UniformValues(*tape, {}), threshold);
            const SignStakes stakes{levels, links.whole().levelNumbers};
            std::vector<double> values;
            for (std::size_t k = 0; k < stakes.levelNumbers.size(); ++k)
                values.push_back(stakes.of(k) == nullptr ? none : stakes.of(k)->value);
            return values;
        };
        using Levels = std::vector<double>;
        // Inner choices come first.
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto z) { return max(min(x, y), z); })),
                 (Levels{threshold, threshold}));
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto z) { return max(z, -min(x, y)); })),
                 (Levels{-threshold, threshold}));
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto z) { return min(z, sin(min(x, y))); })),
                 (Levels{none, threshold}));
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto) { return min(x, y) + 1; })), Levels{threshold - 1});
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto) { return 2 - min(x, y) / 4; })),
                 Levels{4 * (2 - threshold)});
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto) { return 2 - min(sin(x), y); })),
                 Levels{2 - threshold});
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto z) { return max(z, -8 * min(x, y) - 1); })),
                 (Levels{-(threshold + 1) / 8, threshold}));
        // By what is no number the sign can change.
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto z) { return min(x, y) + z; })), Levels{none});
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto) { return 2 / min(x, y); })), Levels{none});
        // Of what is used twice, the other user may need the value.
        QCOMPARE(levelsOf(tapeOf([](auto x, auto y, auto z) {
                     const auto both = min(x, y);
                     return max(both, z * both);
                 })),
                 (Levels{none, threshold}));
    }

    /// Levels reach as far as roundings may move them; behind a factor of 0 nothing is beyond them.
    void levelsKnowTheirRoundings() {
        const auto tape = tapeOf([](auto x, auto y, auto) { return (min(x, y) - 1e6) * 3; });
        const auto levels = TapeLinks(*tape).levels(UniformValues(*tape, {}), -3e6);
        QVERIFY(std::abs(levels.back().value) <= levels.back().reach);
        QVERIFY(levels.back().reach > 1e-10 && levels.back().reach < 1e-8);
        const auto scaled = tapeOf(
            [](auto x, auto y, auto) { return min(x, y) * Expression(x.graph(), x.graph().parameter(0)); });
        const TapeLinks links(*scaled);
        const double zero = 0, three = 3;
        QCOMPARE(links.levels(UniformValues(*scaled, {&zero, 1}), 1).back().reach,
                 std::numeric_limits<double>::infinity());
        QCOMPARE(links.levels(UniformValues(*scaled, {&three, 1}), 1).back().value, 1.0 / 3);
        // Products of what is nearer to 0 than this underflow.
        const double tiny = 1e-300;
        QVERIFY(links.levels(UniformValues(*scaled, {&tiny, 1}), 0).back().reach > 2e-8);
    }

    /// With levels, tapes keep the sign of the whole on the piece, and less than half is left of what can go.
    void shortenedTapesKeepTheSign() {
        std::mt19937_64 random(seed + 4);
        std::uniform_real_distribution<double> place(-1.5, 1.5), part(0, 1), threshold(-0.02, 0.05);
        const auto holes = tapeOf([](auto x, auto y, auto z) {
            Expression result = x.number(10);
            for (int k = 0; k < 30; ++k)
                result = min(result, sq(x - std::cos(k)) + sq(y - std::sin(k)) + sq(z - k * 0.1) - 0.04);
            return max(sq(x) + sq(y) - 1, -result);
        });
        const auto scaled = tapeOf([](auto x, auto y, auto z) {
            Expression result = x.number(10);
            for (int k = 0; k < 30; ++k)
                result =
                    min(result, 0.7 - (0.71 - sq(x - std::cos(k)) - sq(y - std::sin(k)) - sq(z - k * 0.1)));
            return (3 - (result * -2 + 5.1)) / 2.1 + 1;
        });
        for (const auto& tape : {unionOfBalls(30), holes, scaled}) {
            AffineEvaluator evaluator(tape, {});
            PointEvaluator points(tape, {});
            const TapeLinks links(*tape);
            TapeSimplifier simplifier(links);
            SimplifiedTape simplifiedTape;
            std::vector<LaneChoices> choices;
            std::size_t bySign = 0, byValue = 0, inside = 0;
            for (int round = 0; round < 2000; ++round) {
                const double level = threshold(random);
                const std::vector<SignLevel> levels = links.levels(UniformValues(*tape, {}), level);
                const SignStakes signs{levels, simplifier.levelNumbers()};
                const double y = place(random), z = place(random), start = 3 + place(random), length = 0.5;
                const RayPieces pieces = alongX(y, z, start, length);
                evaluator.evaluateChoices(pieces, 1, nullptr, choices);
                simplifier.simplify(choices, 1, 0, simplifiedTape);
                byValue += simplifiedTape.instructions.size();
                evaluator.evaluateChoices(pieces, 1, nullptr, choices, nullptr, &signs);
                simplifier.simplify(choices, 1, 0, simplifiedTape);
                bySign += simplifiedTape.instructions.size();
                for (int k = 0; k < 10; ++k) {
                    const double x = -3 + start + length * part(random);
                    double value = 0;
                    points.evaluate({&x, 1}, {&y, 1}, {&z, 1}, {&value, 1}, simplifiedTape);
                    const bool wanted = points.evaluate(x, y, z) < level;
                    QCOMPARE(value < level, wanted);
                    inside += wanted;
                }
            }
            qInfo("instructions left: %zu, by their values %zu; %zu points inside", bySign, byValue, inside);
            const std::size_t always = 2000 * links.leastLength();
            QVERIFY(2 * (bySign - always) < byValue - always);
            QVERIFY(inside > 100);
        }
    }

    /// Of cases that are all on one side of the threshold one is left, though no condition is decided.
    void casesOfOneSideAreOne() {
        constexpr int count = 20;
        constexpr double threshold = 0.475;  // between the cases 9 and 10
        const auto cases = tapeOf([](auto x, auto y, auto z) {
            Expression result = x.number(1);
            for (int k = count; k-- > 0;) {
                const Expression condition = sq(x) + sq(y) - sq(z + k) * 0.01;
                const Expression value = x.number(static_cast<double>(k) / count);
                result =
                    k % 2 == 0 ? select(condition, value, result) : select(-condition, result, value, value);
            }
            return -result;
        });
        const TapeLinks links(*cases);
        TapeSimplifier simplifier(links);
        QCOMPARE(simplifier.choiceCount(), std::size_t(count));
        const std::vector<SignLevel> levels = links.levels(UniformValues(*cases, {}), -threshold);
        const SignStakes signs{levels, simplifier.levelNumbers()};
        AffineEvaluator forms(cases, {});
        BoxEvaluator boxes(cases, {});
        PointEvaluator points(cases, {});
        std::vector<LaneChoices> ofPiece, ofBox;
        forms.evaluateChoices(alongX(0, 0, 0, 6), 1, nullptr, ofPiece, nullptr, &signs);
        BoxLanes box;
        for (std::size_t axis = 0; axis < 3; ++axis) box.low[axis][0] = -3, box.high[axis][0] = 3;
        Interval values;
        boxes.evaluateChoices(box, links.whole(), signs, {&values, 1}, ofBox);
        std::mt19937_64 random(seed + 5);
        std::uniform_real_distribution<double> place(-3, 3);
        for (const bool isBox : {false, true}) {
            const std::vector<LaneChoices>& choices = isBox ? ofBox : ofPiece;
            SimplifiedTape left;
            simplifier.simplify(choices, 1, 0, left);
            // Those up to the first case beyond the threshold.
            QCOMPARE(left.levelNumbers.size(), std::size_t(count / 2));
            int inside = 0;
            for (int round = 0; round < 1000; ++round) {
                const double x = place(random), y = isBox ? place(random) : 0, z = isBox ? place(random) : 0;
                double value = 0;
                points.evaluate({&x, 1}, {&y, 1}, {&z, 1}, {&value, 1}, left);
                const bool wanted = points.evaluate(x, y, z) < -threshold;
                QCOMPARE(value < -threshold, wanted);
                inside += wanted;
            }
            QVERIFY(inside > 10 && inside < 990);
        }
    }

    /// What a part of a piece leaves of the short tape of the whole is what it leaves of the tape.
    void shortTapesAreShortenedFurther() {
        std::mt19937_64 random(seed + 3);
        std::uniform_real_distribution<double> place(-1.5, 1.5);
        const auto tape = unionOfBalls(30);
        AffineEvaluator evaluator(tape, {});
        GradientEvaluator gradients(tape, {});
        PointEvaluator points(tape, {});
        const TapeLinks links(*tape);
        TapeSimplifier direct(links), simplifier(links);
        std::vector<LaneChoices> choices;
        std::size_t shorter = 0;
        for (int round = 0; round < 300; ++round) {
            const double y = place(random), z = place(random), start = 3 + place(random);
            SimplifiedTape base, inOneGo, inTwo;
            simplifier.setBase(nullptr);
            evaluator.evaluateChoices(alongX(y, z, start, 1), 1, nullptr, choices);
            simplifier.simplify(choices, 1, 0, base);
            const RayPieces part = alongX(y, z, start + 0.25, 0.125);
            evaluator.evaluateChoices(part, 1, nullptr, choices);
            direct.simplify(choices, 1, 0, inOneGo);
            const AffineLanes lanes = evaluator.evaluateChoices(part, 1, nullptr, choices, &base);
            const AffineForm form{lanes.center[0], lanes.slope[0], lanes.error[0]};
            simplifier.setBase(&base);
            simplifier.simplify(choices, 1, 0, inTwo);
            QCOMPARE(inTwo.instructions.size(), inOneGo.instructions.size());
            shorter += inTwo.instructions.size() < base.instructions.size();
            const AffineLanes twice = evaluator.evaluate(part, 1, inTwo);
            QVERIFY(twice.center[0] == form.a && twice.slope[0] == form.b && twice.error[0] == form.e);
            const double x = -3 + start + 0.3;
            const ValueAndGradient whole = gradients.evaluate(x, y, z);
            ValueAndGradient atPoint;
            gradients.evaluate({&x, 1}, {&y, 1}, {&z, 1}, {&atPoint, 1}, inTwo);
            QCOMPARE(atPoint.value, whole.value);
            QVERIFY(atPoint.gradient == whole.gradient);
            // More points than go through the tape at once.
            std::vector<double> xs(batchLanes + 5), ys(xs.size(), y), zs(xs.size(), z);
            for (std::size_t k = 0; k < xs.size(); ++k)
                xs[k] = -2.75 + start + 0.001 * static_cast<double>(k);
            std::vector<double> expected(xs.size()), found(xs.size());
            points.evaluate(xs, ys, zs, expected);
            points.evaluate(xs, ys, zs, found, inTwo);
            QCOMPARE(found, expected);
        }
        QVERIFY(shorter > 100);
    }

    void builtinsKeepTheirValues() {
        std::mt19937_64 random(seed + 2);
        std::uniform_real_distribution<double> place(-2, 2), length(0.01, 1);
        for (const Builtin& builtin : builtins()) {
            if (builtin.pointArguments != 3) continue;
            const auto tape = tapeOf([&builtin](auto x, auto y, auto z) {
                std::vector<Expression> arguments{x, y, z};
                for (const BuiltinParameter& parameter : builtin.parameters)
                    arguments.push_back(x.number(parameter.defaultValue));
                return buildBuiltin(builtin, arguments, 2);
            });
            if (TapeLinks(*tape).whole().levelNumbers.empty()) continue;
            AffineEvaluator evaluator(tape, {});
            PointEvaluator points(tape, {});
            const TapeLinks links(*tape);
            TapeSimplifier simplifier(links);
            SimplifiedTape simplifiedTape;
            std::vector<LaneChoices> choices;
            RaySpread spread;
            for (int round = 0; round < 100; ++round) {
                RayPieces pieces;
                for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                    for (std::size_t k = 0; k < 3; ++k) {
                        pieces.origin[k][lane] = place(random);
                        pieces.direction[k][lane] = place(random);
                        spread.direction[k][lane] = round % 2 ? 0.01 : 0;
                    }
                    pieces.start[lane] = length(random);
                    pieces.length[lane] = length(random);
                }
                evaluator.evaluateChoices(pieces, batchLanes, &spread, choices);
                for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                    simplifier.simplify(choices, std::uint64_t(1) << lane, 0, simplifiedTape);
                    const AffineLanes shorter = evaluator.evaluate(pieces, batchLanes, simplifiedTape);
                    for (const double s : {-1.0, 0.0, 1.0}) {
                        const double t = pieces.start[lane] + 0.5 * (1 + s) * pieces.length[lane];
                        const double value =
                            points.evaluate(pieces.origin[0][lane] + t * pieces.direction[0][lane],
                                            pieces.origin[1][lane] + t * pieces.direction[1][lane],
                                            pieces.origin[2][lane] + t * pieces.direction[2][lane]);
                        const double e = shorter.error[lane];
                        if (!(std::abs(e) < INFINITY)) continue;
                        if (!(std::abs(value - shorter.center[lane] - s * shorter.slope[lane]) <=
                              e * (1 + 1e-9) + 1e-12))
                            QFAIL(qPrintable(QString("%1 value %2 form %3 %4 %5 at %6")
                                                 .arg(builtin.name.data())
                                                 .arg(value)
                                                 .arg(shorter.center[lane])
                                                 .arg(shorter.slope[lane])
                                                 .arg(e)
                                                 .arg(s)));
                    }
                }
            }
        }
    }

    /// On the piece that decided them, shortened tapes are worth what the whole tape is.
    void shortenedTapesHaveTheValuesOfTheWhole() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> place(-1.5, 1.5), length(0.01, 1);
        const std::vector tapes{unionOfBalls(30), tapeOf([](auto x, auto y, auto z) {
                                    return select(x - y, max(x, sin(z * 3)), min(abs(y) - abs(z), abs(x - z)),
                                                  sq(z)) +
                                           max(min(x, y), max(y, -z)) * abs(x + y);
                                })};
        std::size_t shorter = 0;
        for (const auto& tape : tapes) {
            AffineEvaluator evaluator(tape, {});
            const TapeLinks links(*tape);
            TapeSimplifier simplifier(links);
            SimplifiedTape simplifiedTape;
            std::vector<LaneChoices> choices;
            for (int round = 0; round < 300; ++round) {
                const double y = place(random), z = place(random);
                const RayPieces pieces = alongX(y, z, 3 + place(random), length(random));
                evaluator.evaluateChoices(pieces, 1, nullptr, choices);
                simplifier.simplify(choices, 1, 0, simplifiedTape);
                shorter += simplifiedTape.instructions.size() < tape->instructions().size() / 2;
                QVERIFY(simplifiedTape.instructions.size() <= tape->instructions().size());
                RayPieces part = pieces;
                part.length[0] *= 0.25;
                part.start[0] += 0.5 * pieces.length[0];
                const AffineLanes whole = evaluator.evaluate(part, 1);
                const AffineForm expected{whole.center[0], whole.slope[0], whole.error[0]};
                const AffineLanes lanes = evaluator.evaluate(part, 1, simplifiedTape);
                const double difference = std::abs(lanes.center[0] - expected.a);
                QVERIFY(difference <=
                        lanes.error[0] + expected.e + std::abs(expected.b) + std::abs(lanes.slope[0]));
                // Both hold the value in the middle of the piece.
                const double x = -3 + part.start[0] + 0.5 * part.length[0];
                const double value = PointEvaluator(tape, {}).evaluate(x, y, z);
                QVERIFY(std::abs(value - lanes.center[0]) <= lanes.error[0] * (1 + 1e-12) + 1e-15);
            }
        }
        QVERIFY(shorter > 100);
    }
};

QTEST_APPLESS_MAIN(TapeSimplifierTest)
#include "tape_simplifier_test.moc"
