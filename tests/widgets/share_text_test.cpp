// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/share_text.h"

#include <QTest>

using namespace isoscope;

class ShareTextTest : public QObject {
    Q_OBJECT

  private slots:
    void sharesDoNotLie_data() {
        QTest::addColumn<qulonglong>("part");
        QTest::addColumn<qulonglong>("whole");
        QTest::addColumn<QString>("text");
        QTest::newRow("all but four: D22") << 432636ull << 432640ull << "99.999 %";
        QTest::newRow("four") << 4ull << 432640ull << "0.001 %";
        QTest::newRow("all") << 7ull << 7ull << "100 %";
        QTest::newRow("none") << 0ull << 7ull << "0 %";
        QTest::newRow("half") << 50ull << 100ull << "50 %";
        QTest::newRow("a third") << 1ull << 3ull << "33.3 %";
        QTest::newRow("one in a million missing") << 999999ull << 1000000ull << "99.9999 %";
        QTest::newRow("half a unit") << 99995ull << 100000ull << "99.995 %";
        QTest::newRow("nothing at all") << 0ull << 0ull << "";
        QTest::newRow("more than all") << 8ull << 7ull << "100 %";
    }
    void sharesDoNotLie() {
        QFETCH(qulonglong, part);
        QFETCH(qulonglong, whole);
        QTEST(formatShare(part, whole), "text");
    }

    void onlyAllIsAHundred() {
        for (std::uint64_t whole = 1; whole < 1'000'000'000'000; whole = whole * 3 + 1) {
            QVERIFY(formatShare(whole - 1, whole) != "100 %");
            if (whole > 1) QVERIFY(formatShare(1, whole).chopped(2).toDouble() > 0);
        }
    }

    void countsAreGrouped() {
        QCOMPARE(formatCount(7), QString("7"));
        QCOMPARE(formatCount(1234567), QString("1\u202f234\u202f567"));
    }
};

QTEST_APPLESS_MAIN(ShareTextTest)
#include "share_text_test.moc"
