// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/fill_numbers.h"

#include <QTest>
#include <algorithm>
#include <vector>

#include "tests/support/instruction_sets.h"

using namespace isoscope;

class FillNumbersTest : public QObject {
    Q_OBJECT

  private slots:
    void fillsSoManyAndNoMoreWithAnyInstructionSet() {
        for (const auto& [target, name] : test::instructionSets()) {
            const test::ForcedInstructionSet forced(target);
            for (std::size_t count = 0; count < 70; ++count)
                for (const std::size_t first : {0, 1, 5}) {
                    std::vector<double> numbers(80, 7), expected(80, 7);
                    fillNumbers(&numbers[first], count, -2.5);
                    std::fill_n(expected.begin() + static_cast<std::ptrdiff_t>(first), count, -2.5);
                    QVERIFY2(numbers == expected, name);
                }
        }
    }
};

QTEST_APPLESS_MAIN(FillNumbersTest)
#include "fill_numbers_test.moc"
