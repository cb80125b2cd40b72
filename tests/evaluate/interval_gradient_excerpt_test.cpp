// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/numeric/noise_bounds.h"
#include "tests/support/gradient_bounds.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(31415926);

Box within(std::mt19937_64& random, const Box& box) {
    const Point p = inside(random, box), q = inside(random, box);
    Box result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = {std::min(p[k], q[k]), std::max(p[k], q[k]), false};
    return result;
}

}  // namespace

class IntervalGradientExcerptTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// In boxes within, by the excerpt of a box, and by the excerpt of that.
    void excerptsAreTheFunctionThere() {
        RandomFunctionSettings settings;
        for (int k = 0; k < operationCount; ++k)
            if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
                settings.operations.push_back(static_cast<Operation>(k));
        using enum Operation;
        for (const Operation choosing : {minimum, maximum, absolute, select3, select4, square, multiply})
            settings.operations.insert(settings.operations.end(), 4, choosing);
        std::mt19937_64 random(seed);
        Checks checks;
        std::size_t shorter = 0;
        for (int round = 0; round < 6000; ++round) {
            settings.nodes = 2 + static_cast<int>(random() % 14);
            const Function function = randomFunction(random, settings);
            const auto tape = Tape::compile(function);
            // Of loops nothing is left out.
            if (!tape->loops().empty()) continue;
            IntervalGradientEvaluator evaluator(tape, parameters);
            ReferenceEvaluator reference(function);
            GradientEvaluator gradient(tape, parameters);
            Box box = boxAround(random, 3, -5, 0.3);
            evaluator.evaluate(box);
            auto excerpt = evaluator.excerpt({});
            QVERIFY(!excerpt || excerpt->entries.size() < tape->instructions().size());
            shorter += excerpt != nullptr;
            for (int level = 0; level < 3; ++level) {
                box = within(random, box);
                const IntervalGradient answer = evaluator.evaluate(box, excerpt);
                for (int pair = 0; pair < 3; ++pair) {
                    const Point p = inside(random, box), q = inside(random, box);
                    const QString wrong = contradiction(answer, reference, gradient, p, q, checks);
                    QVERIFY2(wrong.isEmpty(),
                             (wrong.toStdString() + " is wrong for\n" + describe(function)).c_str());
                }
                excerpt = evaluator.excerpt(excerpt);
            }
            // Nothing of that stays behind.
            const IntervalGradient whole = evaluator.evaluate(box);
            const IntervalGradient fresh = IntervalGradientEvaluator(tape, parameters).evaluate(box);
            QVERIFY(whole.value.low == fresh.value.low || fresh.value.empty());
            QVERIFY(whole.steepness == fresh.steepness || std::isnan(fresh.steepness));
        }
        qInfo("%zu shorter, %d values, %d slopes", shorter, checks.values, checks.slopes);
        QVERIFY(shorter > 500 && checks.values > 20000 && checks.slopes > 10000);
    }

    /// In a small box what is left of a union is a few of its parts, and what is known of it the same.
    void littleIsLeftOfAUnion() {
        constexpr int count = 100;
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            Expression least = x.number(10);
            for (int k = 0; k < count; ++k) least = min(least, sqrt(sq(x - 0.1 * k) + sq(y) + sq(z)) - 0.04);
            return least;
        });
        IntervalGradientEvaluator evaluator(tape, {});
        std::mt19937_64 random(seed + 1);
        for (int round = 0; round < 200; ++round) {
            const double x = std::uniform_real_distribution<double>(1, 9)(random);
            const Box box{Interval{x, x + 0.02, false}, Interval{0.02, 0.04, false},
                          Interval{0.01, 0.03, false}};
            const IntervalGradient whole = evaluator.evaluate(box);
            const auto excerpt = evaluator.excerpt({});
            QVERIFY(excerpt && excerpt->entries.size() < tape->instructions().size() / 10);
            const IntervalGradient brief = evaluator.evaluate(box, excerpt);
            QVERIFY(brief.value.low == whole.value.low && brief.value.high == whole.value.high);
            QVERIFY(brief.steepness <= whole.steepness && brief.hazard == whole.hazard);
        }
    }
};

QTEST_APPLESS_MAIN(IntervalGradientExcerptTest)
#include "interval_gradient_excerpt_test.moc"
