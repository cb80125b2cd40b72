// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/march_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <QTest>
#include <vector>

using namespace isoscope;

class MarchOrderTest : public QObject {
    Q_OBJECT

  private slots:
    /// By powers of 2; within one, and without a known error, as they came.
    void largeErrorsComeFirst() {
        const std::vector<double> lines{0, 1, -1, 3, 4, 5, 6, 7};
        const std::vector<double> errors{1e-3, 0, 9, 3, 1.9, 1.1, 0, 1e300};
        MarchOrder order;
        QVERIFY(order.sort(lines.data(), errors.data(), 0).empty());
        const auto found = order.sort(lines.data(), errors.data(), lines.size());
        const std::vector<std::uint32_t> wanted{7, 3, 4, 5, 0, 1, 6};
        QVERIFY(std::ranges::equal(found, wanted));
        const std::vector<double> far{0, 1e-300, 1e-10, 1e20, 1e300};
        QVERIFY(std::ranges::equal(order.sort(lines.data(), far.data(), 2), std::array{0, 1}));
        QVERIFY(std::ranges::equal(order.sort(errors.data(), far.data(), 5), std::array{3, 4, 2, 0, 1}));
    }

    /// Rows of lines that have ended count for nothing.
    void theLeastErrorIsOfLinesThatGoOn() {
        const std::vector<double> lines{0, -1, 2}, errors{0.5, 0.1, 0.25};
        QCOMPARE(leastError(lines.data(), errors.data(), 3), 0.25);
        QCOMPARE(leastError(lines.data() + 1, errors.data() + 1, 1), std::numeric_limits<double>::max());
    }

    /// An order is by what was asked last.
    void memoryIsKeptAndForgotten() {
        MarchOrder order;
        const std::vector<double> lines{0, 1, 2, 3}, rising{1, 2, 4, 8}, falling{8, 4, 2, 1};
        QVERIFY(std::ranges::equal(order.sort(lines.data(), rising.data(), 4), std::array{3, 2, 1, 0}));
        QVERIFY(std::ranges::equal(order.sort(lines.data(), falling.data(), 4), std::array{0, 1, 2, 3}));
        QVERIFY(std::ranges::equal(order.sort(lines.data(), rising.data(), 2), std::array{1, 0}));
    }
};

QTEST_APPLESS_MAIN(MarchOrderTest)
#include "march_order_test.moc"
