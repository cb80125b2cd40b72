// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic on what steps: it steps with it, and is no step of its own.
#include <QTest>

#include "core/evaluate/jumps/affine_cases.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// The operations of make(x, y, z) that are arithmetic on steps, in the tape's order.
template <class Make>
std::vector<Operation> stepping(Make make) {
    const auto tape = tapeOf(make);
    const std::vector<bool> found = findWholeNumbers(*tape, tape->instructions());
    std::vector<Operation> operations;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i]) operations.push_back(tape->instructions()[i].operation);
    return operations;
}

}  // namespace

class WholeNumbersTest : public QObject {
    Q_OBJECT

  private slots:
    void arithmeticOnStepsIsFound() {
        QVERIFY(stepping([](auto x, auto, auto) { return floor(x) * 2.0; }) ==
                std::vector{Operation::multiply});
        QVERIFY(stepping([](auto x, auto y, auto) { return floor(x) + floor(y); }) ==
                std::vector{Operation::add});
        QVERIFY(stepping([](auto x, auto y, auto) { return lessThan(x, y) - floor(y); }) ==
                std::vector{Operation::subtract});
    }

    /// What makes steps of steps hands them on, and is none itself.
    void choicesOfStepsHandThemOn() {
        QVERIFY(stepping([](auto x, auto y, auto) { return min(floor(x), floor(y)) * 3.0; }) ==
                std::vector{Operation::multiply});
        QVERIFY(stepping([](auto x, auto, auto) { return abs(floor(x)) + 0.5; }) ==
                std::vector{Operation::add});
        QVERIFY(stepping([](auto x, auto, auto) { return sin(floor(x)) + 0.5; }).empty());
    }

    void whatMovesBetweenStepsIsNot() {
        QVERIFY(stepping([](auto x, auto, auto) { return floor(x) + x; }).empty());
        QVERIFY(stepping([](auto x, auto y, auto) { return min(floor(x), y) * 2.0; }).empty());
        QVERIFY(stepping([](auto x, auto y, auto) { return x + y; }).empty());
    }
};

QTEST_GUILESS_MAIN(WholeNumbersTest)
#include "whole_numbers_test.moc"
