// SPDX-License-Identifier: GPL-3.0-or-later
// Where the mathematical library has an exact answer, a whole number or a half, vectors have it too.
#include <array>
#include <cmath>
#include <QTest>
#include <vector>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/function/scalar_operations.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::array arguments{0.0,  -0.0, 1.0,  -1.0, 0.5,  -0.5, 0.25,  2.0,   -2.0, 3.0,    4.0,
                               9.0,  10.0, 16.0, 25.0, 32.0, 64.0, 100.0, 144.0, 1e3,  1024.0, 1e6,
                               1e-9, 1e9,  7.0,  11.0, 1.5,  2.5,  -3.0,  -8.0,  27.0, 81.0};

bool isPlain(double a) { return std::isfinite(a) && 2 * a == std::round(2 * a) && std::abs(a) < 1e15; }

}  // namespace

class ExactValuesTest : public QObject {
    Q_OBJECT

  private slots:
    void wholeNumbersAndHalvesAreExact_data() {
        QTest::addColumn<qint64>("target");
        for (const auto& [target, name] : instructionSets()) QTest::newRow(name) << qint64(target);
    }
    void wholeNumbersAndHalvesAreExact() {
        QFETCH(qint64, target);
        const ForcedInstructionSet forced(target);
        int compared = 0;
        for (int k = 0; k < operationCount; ++k) {
            const auto operation = static_cast<Operation>(k);
            if (arity(operation) != 1 && arity(operation) != 2) continue;
            const auto tape = tapeOf([=](auto x, auto y, auto) {
                return arity(operation) == 1 ? apply(operation, x) : apply(operation, x, y);
            });
            PointEvaluator evaluator(tape, {});
            for (const double second :
                 arity(operation) == 1 ? std::vector{0.0} : std::vector(arguments.begin(), arguments.end())) {
                std::vector<double> x(arguments.begin(), arguments.end()), y(x.size(), second);
                const std::vector<double> z(x.size(), 0.0);
                std::vector<double> values(x.size());
                evaluator.evaluate(x, y, z, values);
                for (std::size_t i = 0; i < x.size(); ++i) {
                    const std::array operands{x[i], second};
                    const double exact = evaluateOperation(
                        operation, std::span(operands).first(static_cast<std::size_t>(arity(operation))));
                    if (!isPlain(exact)) continue;
                    ++compared;
                    QVERIFY2(values[i] == exact,
                             qPrintable(QString::asprintf("%s(%.17g, %.17g) is %.17g, not %.17g",
                                                          name(operation).data(), x[i], second, values[i],
                                                          exact)));
                }
            }
        }
        QVERIFY(compared > 5000);
    }

    /// A power of 0 has a slope along its base alone: along the exponent it is 0, or 1 at 0 alone.
    void aPowerOfZeroIsFlatAlongItsExponent() {
        GradientEvaluator evaluator(tapeOf([](auto x, auto y, auto) { return pow(x, y); }), {});
        for (const double exponent : {0.0, 1.0, 2.0, -1.0})
            QVERIFY2(evaluator.evaluate(0, exponent, 0).gradient[1] == 0,
                     qPrintable(QString::number(exponent)));
        QVERIFY(std::abs(evaluator.evaluate(2, 3, 0).gradient[1] - 8 * std::log(2)) < 1e-14);
    }
};

QTEST_APPLESS_MAIN(ExactValuesTest)
#include "exact_values_test.moc"
