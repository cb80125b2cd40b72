// SPDX-License-Identifier: GPL-3.0-or-later
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace isoscope::test;

/// What reading costs, in instructions.
class ReadingCostTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

    /// Of `count` declarations with `between` behind each.
    double instructionsFor(int count, const char* between) {
        QByteArray text;
        for (int i = 0; i < count; ++i) text += "#declare A" + QByteArray::number(i) + " = 1;" + between;
        return instructionsOfCli({"check", writeFile(folder_.path(), "scene.pov", text)});
    }

  private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable("valgrind").isEmpty()) QSKIP("NOT MEASURED: valgrind is missing");
    }

    /// Each number looks behind itself for its slider's note; it once looked to the end of its line.
    void aLongLineCostsWhatManyLinesCost() {
        constexpr int count = 5000;
        const double lines = instructionsFor(count, "\n"), line = instructionsFor(count, " ");
        qInfo("%d lines: %.1f million instructions, in one line: %.1f", count, lines / 1e6, line / 1e6);
        QVERIFY(lines > 0 && line > 0);
        QVERIFY(line < 1.1 * lines);
    }
};

QTEST_GUILESS_MAIN(ReadingCostTest)
#include "reading_cost_test.moc"
