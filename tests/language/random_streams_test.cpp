// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/random_streams.h"

#include <QTest>
#include <cmath>

using namespace isoscope;

class RandomStreamsTest : public QObject {
    Q_OBJECT

  private slots:
    /// What POV-Ray 3.7 printed for `str(rand(seed(S)), 0, 12)` and the calls after it.
    void givesPovRaysNumbers_data() {
        QTest::addColumn<double>("seed");
        QTest::addColumn<QList<double>>("numbers");
        QTest::newRow("0") << 0.0
                           << QList<double>{0.000002874294, 0.466563684509, 0.249070228834, 0.965876042136};
        QTest::newRow("1") << 1.0
                           << QList<double>{0.421992875268, 0.487121198207, 0.665896215631, 0.975731905078};
        QTest::newRow("3") << 3.0
                           << QList<double>{0.265972876983, 0.528236225603, 0.499548188993, 0.995443630963};
        QTest::newRow("1234567") << 1234567.0
                                 << QList<double>{0.929413943768, 0.094571539456, 0.856992651442,
                                                  0.689017956073};
        QTest::newRow("negative fraction") << -5.5 << QList<double>{0.890052870123, 0.363776116018};
        QTest::newRow("fraction") << 2.9 << QList<double>{0.843982876242, 0.507678711905};
        QTest::newRow("beyond 32 bits") << 5e9 << QList<double>{0.500002874411, 0.966563684625};
    }

    void givesPovRaysNumbers() {
        QFETCH(double, seed);
        QFETCH(QList<double>, numbers);
        RandomStreams streams;
        const double stream = streams.seed(seed);
        for (const double wanted : numbers) {
            const std::optional<double> got = streams.next(stream);
            QVERIFY(got);
            QVERIFY2(std::abs(*got - wanted) < 1e-12, qPrintable(QString::number(*got, 'g', 17)));
        }
    }

    void streamsAreIndependent() {
        RandomStreams streams;
        QCOMPARE(streams.seed(1), 0.0);
        QCOMPARE(streams.seed(1), 1.0);
        const double first = *streams.next(0);
        QVERIFY(*streams.next(0) != first);
        QCOMPARE(*streams.next(1), first);
    }

    void refusesWhatIsNoStream() {
        RandomStreams streams;
        QVERIFY(!streams.next(0));
        streams.seed(1);
        QVERIFY(!streams.next(-1));
        QVERIFY(!streams.next(1));
        QVERIFY(!streams.next(std::nan("")));
    }

    void takesAnySeed() {
        RandomStreams streams;
        for (const double seed : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300})
            QVERIFY(streams.next(streams.seed(seed)).has_value());
    }
};

QTEST_APPLESS_MAIN(RandomStreamsTest)
#include "random_streams_test.moc"
