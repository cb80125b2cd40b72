// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/csv_table.h"

#include <QTest>
#include <cmath>

#include "core/text/number_format.h"

using namespace isoscope;

class CsvTableTest : public QObject {
    Q_OBJECT

  private slots:
    void readsQuotedFields() {
        const CsvTable table = CsvTable::parse("name,value\n\"a,\"\"b\"\"\nc\",2\r\nlast,inf");
        QCOMPARE(table.rowCount(), 2u);
        QCOMPARE(table.field(0, "name"), std::string("a,\"b\"\nc"));
        QCOMPARE(table.number(0, "value", 0), 2.0);
        QVERIFY(std::isinf(table.number(1, "value", 0)));
    }

    void fillsShortRowsAndUnknownColumns() {
        const CsvTable table = CsvTable::parse("a,b\n1\n\n");
        QCOMPARE(table.rowCount(), 1u);
        QCOMPARE(table.field(0, "b"), std::string());
        QCOMPARE(table.number(0, "c", 7), 7.0);
    }

    void whatIsNoNumberIsNaN() {
        const CsvTable table = CsvTable::parse("a\n1x\n0x1p-1\n");
        QVERIFY(std::isnan(table.number(0, "a", 0)));
        QCOMPARE(table.number(1, "a", 0), 0.5);
    }

    void writesWhatItReads() {
        const std::vector<std::string> fields{"plain", "with,comma", "with \"quotes\"", "two\nlines", ""};
        const CsvTable table = CsvTable::parse("a,b,c,d,e\n" + csvLine(fields));
        QCOMPARE(table.row(0), fields);
    }

    void numbersReadBack() {
        for (const double value : {0.1, 1.0 / 3, 1e300, -0.0, 5e-324}) {
            QCOMPARE(std::strtod(exactNumber(value).c_str(), nullptr), value);
            QCOMPARE(std::strtod(shortestNumber(value).c_str(), nullptr), value);
        }
        QCOMPARE(exactNumber(std::nan("")), std::string("nan"));
        QCOMPARE(exactNumber(-INFINITY), std::string("-inf"));
        QCOMPARE(shortestNumber(0.35), std::string("0.35"));
        QCOMPARE(fixedNumber(2.0105, 3), std::string("2.010"));
        QCOMPARE(fixedNumber(1e300, 3).size(), std::size_t(305));
    }
};

QTEST_APPLESS_MAIN(CsvTableTest)
#include "csv_table_test.moc"
