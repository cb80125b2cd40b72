// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/line_difference.h"

#include <QRandomGenerator>
#include <QStringList>
#include <QTest>

using namespace isoscope;
using Kind = DifferenceLine::Kind;

class LineDifferenceTest : public QObject {
    Q_OBJECT

    static QString marks(const QString& first, const QString& second) {
        QString marks;
        for (const DifferenceLine& line : lineDifference(first, second))
            marks += QLatin1String(line.kind == Kind::both        ? "="
                                   : line.kind == Kind::onlyFirst ? "-"
                                                                  : "+") +
                     line.text + QLatin1Char(' ');
        return marks.trimmed();
    }
    static QString randomText(QRandomGenerator& random, int lines) {
        QStringList text;
        for (int i = 0; i < lines; ++i) text << QString(QChar('a' + random.bounded(4)));
        return text.join('\n');
    }

  private slots:
    void linesAreMatched() {
        QCOMPARE(marks("a\nb\nc", "a\nb\nc"), QString("=a =b =c"));
        QCOMPARE(marks("a\nb\nc", "a\nx\nc"), QString("=a -b +x =c"));
        QCOMPARE(marks("a\nc", "a\nb\nc"), QString("=a +b =c"));
        QCOMPARE(marks("a\nb\nc", "c"), QString("-a -b =c"));
        const auto lines = lineDifference("a\nb", "b");
        QCOMPARE(lines[0], (DifferenceLine{Kind::onlyFirst, "a", 1, 0}));
        QCOMPARE(lines[1], (DifferenceLine{Kind::both, "b", 2, 1}));
    }

    /// Both texts can be read off the result, whatever they are.
    void nothingIsLost() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        for (int turn = 0; turn < 500; ++turn) {
            const QString first = randomText(random, random.bounded(12)),
                          second = randomText(random, random.bounded(12));
            QStringList a, b;
            for (const DifferenceLine& line : lineDifference(first, second)) {
                if (line.kind != Kind::onlySecond) a << line.text;
                if (line.kind != Kind::onlyFirst) b << line.text;
            }
            QCOMPARE(a.join('\n'), first);
            QCOMPARE(b.join('\n'), second);
        }
    }

    void textsWithoutLikenessAreToldAsAWhole() {
        QStringList a, b;
        for (int i = 0; i < 3000; ++i) a << QString::number(i), b << QString::number(-1 - i);
        const auto lines = lineDifference(a.join('\n'), b.join('\n'));
        QCOMPARE(lines.size(), std::size_t(6000));
        QCOMPARE(lines.front().kind, Kind::onlyFirst);
    }
};

QTEST_APPLESS_MAIN(LineDifferenceTest)
#include "line_difference_test.moc"
