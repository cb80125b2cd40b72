// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/certain_starts.h"

#include <QTest>

#include "tests/roots/line_table.h"
#include "tests/support/instruction_sets.h"

using namespace isoscope;

class CertainStartsTest : public QObject {
    Q_OBJECT

  private slots:
    void newOnesKnowNothing() {
        CertainStarts starts(20);
        starts.set(0, 20, {2, 1, 0.5});
        QCOMPARE(starts[19].sign, 1.0);
        // Longer lists and shorter ones, whatever was known before.
        for (const std::size_t lines : {std::size_t{300}, std::size_t{1024}, std::size_t{7}}) {
            starts.reset(lines);
            for (std::size_t i = 0; i < lines; ++i) QCOMPARE(starts[i].sign, 0.0);
            starts.set(0, lines, {2, -1, 0.5});
            QCOMPARE(starts[lines - 1].start, 2.0);
        }
    }

    void openAreLinesOfWhichNoneIsKnownToItsEnd() {
        for (const auto& [target, name] : test::instructionSets()) {
            const test::ForcedInstructionSet forced(target);
            std::vector<LineQuery> lines(21, LineQuery{{0, 0, 0}, {0, 0, 1}, 1, 4});
            for (std::size_t i = 0; i < 8; ++i) lines[i].far = 0;
            const test::LineTable table(lines);
            const LineColumns columns = table.columns();
            CertainStarts starts(lines.size());
            QVERIFY2(starts.open(columns, 3, 18), name);
            // Nothing passes there.
            QVERIFY2(!starts.open(columns, 0, 8), name);
            QVERIFY2(!starts.open(columns, 2, 5), name);
            starts.set(0, 21, {3.9, 1, 0.1});
            QVERIFY2(starts.open(columns, 0, 21), name);
            starts.set(20, 1, {4, -1, 0.1});
            QVERIFY2(!starts.open(columns, 0, 21), name);
            QVERIFY2(starts.open(columns, 0, 20), name);
            // Lines that do not pass have no end to be known.
            starts.set(0, 8, {5, 1, 0.1});
            QVERIFY2(starts.open(columns, 0, 20), name);
        }
    }
};

QTEST_APPLESS_MAIN(CertainStartsTest)
#include "certain_starts_test.moc"
