// SPDX-License-Identifier: GPL-3.0-or-later
// What operands can be at all: from their ranges, and from what they are made of.
#include "core/evaluate/tape/operand_domains.h"

#include <QTest>

#include "core/evaluate/prepared_function.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// What the operand of the sine of make(x, y, z) can be.
template <class Make>
std::pair<double, double> operandOfSine(Make make) {
    const auto tape = tapeOf([&](auto x, auto y, auto z) { return sin(make(x, y, z)); });
    const auto function = std::make_shared<const PreparedFunction>(tape, std::span<const double>{});
    const auto& limits = function->global()->domains().limits;
    for (std::size_t i = 0; i < tape->instructions().size(); ++i)
        if (tape->instructions()[i].operation == Operation::sine) return {limits[i][0], limits[i][1]};
    qFatal("there is no sine");
    return {};
}

}  // namespace

class OperandDomainsTest : public QObject {
    Q_OBJECT

  private slots:
    /// By intervals y and the root are apart, and their quotient is anything.
    void aCoordinateByItsDistanceIsNoMoreThanOne() {
        const std::pair<double, double> sine{-1, 1};
        QVERIFY(operandOfSine([](auto x, auto y, auto) { return y / sqrt(sq(x) + sq(y)); }) == sine);
        QVERIFY(operandOfSine([](auto x, auto y, auto) { return x / sqrt(sq(x) + sq(y)); }) == sine);
        QVERIFY(operandOfSine([](auto x, auto y, auto z) { return y / sqrt(sq(x) + (sq(y) + sq(z))); }) ==
                sine);
    }

    void otherQuotientsAreNotLimited() {
        const auto wide = [](auto make) {
            const auto [low, high] = operandOfSine(make);
            return low < -1e6 && high > 1e6;
        };
        // Of another coordinate, and with a part that is no square: 1 / sqrt(1 - 0.99) is 10.
        QVERIFY(wide([](auto x, auto y, auto z) { return z / sqrt(sq(x) + sq(y)); }));
        QVERIFY(wide([](auto, auto y, auto z) { return y / sqrt(sq(y) + z); }));
        QVERIFY(wide([](auto x, auto y, auto) { return y / sqrt(x + sq(y)); }));
        QVERIFY(wide([](auto x, auto y, auto) { return y / (sq(x) + sq(y)); }));
        QVERIFY(wide([](auto x, auto y, auto) { return y / sqrt(sq(x) - sq(y)); }));
    }
};

QTEST_GUILESS_MAIN(OperandDomainsTest)
#include "operand_domains_test.moc"
