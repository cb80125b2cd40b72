// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/prepared_function.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <thread>
#include <QTest>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/function_keeper.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/language/parse.h"
#include "core/shapes/isosurface/isosurface.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(314159);

/// A function of two parameters, of which it uses the second; with a choice that is decided everywhere.
std::shared_ptr<const Tape> clampedTape() {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const Expression radius(graph, graph.parameter(1));
    const NodeId root = (max(sq(x) + sq(y) + sq(z), x.number(-1)) - sq(radius)).node();
    return Tape::compile(finish(std::move(graph), {root}, 3));
}

std::shared_ptr<const Tape> longLoop() {
    return Tape::compile(parseFunction("sum(i, 1, 1000, sin(x * i))").value.function);
}

/// What an evaluator finds along 64 pieces, all its bits.
std::vector<std::uint64_t> formsOf(AffineEvaluator& evaluator) {
    RayPieces pieces;
    for (std::size_t i = 0; i < batchLanes; ++i) {
        const double at = 0.03 * static_cast<double>(i);
        for (std::size_t c = 0; c < 3; ++c) {
            pieces.origin[c][i] = 0.2 - at * static_cast<double>(c);
            pieces.direction[c][i] = 1 - at;
        }
        pieces.start[i] = at;
        pieces.length[i] = 0.1;
    }
    const AffineLanes lanes = evaluator.evaluate(pieces, batchLanes);
    std::vector<std::uint64_t> bits;
    for (const double* column : {lanes.center, lanes.slope, lanes.error})
        for (std::size_t i = 0; i < batchLanes; ++i) bits.push_back(std::bit_cast<std::uint64_t>(column[i]));
    return bits;
}

std::stop_token requestedStop() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

}  // namespace

class PreparedFunctionTest : public QObject {
    Q_OBJECT

  private slots:
    void theSameValuesGiveTheSameFunction() {
        const FunctionKeeper keeper(clampedTape());
        const auto function = keeper.prepared(std::array{7.0, 2.0});
        QCOMPARE(keeper.prepared(std::array{7.0, 2.0}), function);
        // The function does not use the first.
        QCOMPARE(keeper.prepared(std::array{8.0, 2.0}), function);
        QCOMPARE(keeper.prepared(std::array{8.0, 2.0}), function);
    }

    void otherValuesShareWhatIsOfTheTapeAlone() {
        const FunctionKeeper keeper(clampedTape());
        const auto function = keeper.prepared(std::array{0.0, 2.0});
        const auto moved = keeper.prepared(std::array{0.0, 3.0});
        QVERIFY(moved != function);
        QCOMPARE(AffineEvaluator(moved).certain(), true);
        QCOMPARE(GradientEvaluator(function).evaluate(0, 0, 0).value, -4.0);
        QCOMPARE(GradientEvaluator(moved).evaluate(0, 0, 0).value, -9.0);
        QCOMPARE(&moved->links(), &function->links());
        QCOMPARE(&moved->code(StepNumberKind::composed), &function->code(StepNumberKind::composed));
        QVERIFY(moved->global() != function->global());
    }

    /// A slider that needs a parse leaves the function as it was.
    void tapesThatComputeTheSameShareIt() {
        const FunctionKeeper keeper(clampedTape()), again(clampedTape());
        const auto function = keeper.prepared(std::array{0.0, 2.0});
        QCOMPARE(again.prepared(std::array{0.0, 2.0}), function);
        // Each goes on with its own tape.
        const auto moved = again.prepared(std::array{0.0, 3.0});
        QVERIFY(moved != function);
        QCOMPARE(GradientEvaluator(moved).evaluate(0, 0, 0).value, -9.0);
        QCOMPARE(keeper.prepared(std::array{0.0, 2.0}), function);
        QCOMPARE(keeper.prepared(std::array{0.0, 3.0}), moved);
        const FunctionKeeper other(longLoop());
        QVERIFY(other.prepared({}) != again.prepared({}));
        QCOMPARE(FunctionKeeper(longLoop()).prepared({}), other.prepared({}));
    }

    void aTextReadAgainKeepsItsFunction() {
        const auto read = [](const std::string& setting) {
            return parseScene("isosurface { function { x*x + y*y + z*z - 1 } " + setting + " }").scene;
        };
        const auto functionOf = [](const Scene& scene) {
            return scene.isosurfaces[0].shape->prepared(*scene.parameterTable);
        };
        const auto first = read("max_gradient 2"), second = read("max_gradient 3"),
                   other = read("threshold 1");
        QCOMPARE(functionOf(*second), functionOf(*first));
        QCOMPARE(functionOf(*other), functionOf(*first));
    }

    /// Parameters that are missing count as 0, and only those bits count that make a difference.
    void missingValuesAreZeros() {
        const FunctionKeeper keeper(clampedTape());
        const auto function = keeper.prepared({});
        QCOMPARE(keeper.prepared(std::array{1.0}), function);
        QCOMPARE(keeper.prepared(std::array{1.0, 0.0}), function);
    }

    void whatIsDecidedEverywhereIsLeftOut() {
        const auto function = PreparedFunction::of(clampedTape(), std::array{0.0, 2.0});
        QVERIFY(function->keptGlobal() == nullptr);
        const auto global = function->global();
        QCOMPARE(function->keptGlobal(), global.get());
        QCOMPARE(function->global(), global);
        const auto isMaximum = [](const Instruction& i) { return i.operation == Operation::maximum; };
        QVERIFY(std::ranges::any_of(function->tape()->instructions(), isMaximum));
        QVERIFY(std::ranges::none_of(global->decided()->instructions, isMaximum));
    }

    /// Steps from 0.1 to 0.9 about 0.5: which of those above it is met does not count, nor of those below.
    void casesOnOneSideOfTheThresholdAreOne() {
        const auto tape = test::tapeOf([](auto x, auto y, auto z) {
            const auto above = select(sq(x) + y - 0.3, x.number(0.8), x.number(0.9));
            const auto below = select(sq(z) - y, x.number(0.1), x.number(0.2));
            return min(select(x + y * z, above, below), 3 + sq(x));
        });
        const auto function = PreparedFunction::of(tape, {});
        const auto signs = function->globalFor(0.5);
        QCOMPARE(function->globalFor(0.5), signs);
        QVERIFY(signs != function->global());
        const auto operations = [](const GlobalSimplification& global) {
            std::vector<Operation> kinds;
            for (const Instruction& instruction : global.decided()->instructions)
                kinds.push_back(instruction.operation);
            return kinds;
        };
        const std::vector<Operation> left = operations(*signs), all = operations(*function->global());
        QCOMPARE(std::count(left.begin(), left.end(), Operation::select3), 1);
        QCOMPARE(std::count(all.begin(), all.end(), Operation::select3), 3);
        // Between two of its steps the select of the lower ones counts.
        const std::vector<Operation> between = operations(*function->globalFor(0.15));
        QCOMPARE(std::count(between.begin(), between.end(), Operation::select3), 2);
        // Nothing is left out where no case is certain to be on one side.
        const auto smooth = PreparedFunction::of(
            test::tapeOf([](auto x, auto y, auto) { return select(x, x + y, sq(y)); }), {});
        QCOMPARE(smooth->globalFor(0.5), smooth->global());

        // Nor beside what may be no number: min makes 5 of it.
        const auto rooted = PreparedFunction::of(
            test::tapeOf([](auto x, auto, auto) { return min(sqrt(x), x.number(5)); }), {});
        QCOMPARE(rooted->globalFor(0.5), rooted->global());

        AffineEvaluator values(function), sides(function, signs);
        std::mt19937_64 random(seed);
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        std::size_t certain = 0;
        for (int round = 0; round < 50; ++round) {
            RayPieces pieces = test::randomPieces(random);
            std::array<AffineForm, batchLanes> own, other;
            values.evaluate(pieces, own);
            sides.evaluate(pieces, other);
            for (std::size_t i = 0; i < batchLanes; ++i) {
                const auto sign = [](const AffineForm& form) {
                    const double reach = std::abs(form.b) + form.e;
                    return form.a - reach > 0.5 ? 1 : form.a + reach < 0.5 ? -1 : 0;
                };
                if (sign(own[i]) == 0 || sign(other[i]) == 0) continue;
                QCOMPARE(sign(other[i]), sign(own[i]));
                ++certain;
            }
        }
        QVERIFY(certain > 500);
        AffineEvaluator again(function, signs);
        again.keepValues();
        QCOMPARE(formsOf(again), formsOf(values));
    }

    /// A jump that shows in no sign is one of the values.
    void keptValuesHaveTheirJumpsAgain() {
        const auto tape = test::tapeOf([](auto x, auto y, auto z) {
            return min(sq(x) + y, 3 + sq(z) + select(x, x.number(0), x.number(1)));
        });
        const auto function = PreparedFunction::of(tape, {});
        const auto signs = function->globalFor(0.5);
        const auto isMinimum = [](const Instruction& i) { return i.operation == Operation::minimum; };
        QVERIFY(std::ranges::none_of(signs->decided()->instructions, isMinimum));
        AffineEvaluator evaluator(function, signs);
        QVERIFY(!evaluator.canJump());
        evaluator.keepValues();
        QVERIFY(evaluator.canJump());
    }

    /// Threads that share a function find what each would find with its own, though the parts are made while
    /// they ask.
    void threadsShareIt() {
        for (const auto& tape : {clampedTape(), longLoop()})
            for (int round = 0; round < 20; ++round) {
                const auto function = PreparedFunction::of(tape, std::array{0.0, 2.0});
                constexpr std::size_t count = 8;
                std::array<std::vector<std::uint64_t>, count> found;
                std::array<const StepCode*, count> codes{};
                {
                    std::vector<std::jthread> threads;
                    for (std::size_t k = 0; k < count; ++k)
                        threads.emplace_back([&, k] {
                            AffineEvaluator evaluator(function);
                            found[k] = formsOf(evaluator);
                            codes[k] = &function->code(StepNumberKind::composed);
                        });
                }
                AffineEvaluator alone(tape, std::array{0.0, 2.0});
                const std::vector<std::uint64_t> wanted = formsOf(alone);
                QVERIFY(std::ranges::all_of(found, [&](const auto& forms) { return forms == wanted; }));
                QVERIFY(std::ranges::all_of(codes, [&](const StepCode* code) { return code == codes[0]; }));
            }
    }

    /// A picture that is given up must not leave wide bounds to the next one.
    void whatAStopCutsShortIsNotKept() {
        const auto function = PreparedFunction::of(longLoop(), {});
        {
            const LoopStop loops(requestedStop());
            QVERIFY(function->global() != nullptr);
            QVERIFY(function->keptGlobal() == nullptr);
        }
        AffineEvaluator shared(function), alone(longLoop(), {});
        QVERIFY(function->keptGlobal() != nullptr);
        QVERIFY(formsOf(shared) == formsOf(alone));
    }
};

QTEST_APPLESS_MAIN(PreparedFunctionTest)
#include "prepared_function_test.moc"
