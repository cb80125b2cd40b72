// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>

#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/program.h"

using namespace isoscope::test;

/// A cell that is not what it has to be is told with line, row and column; the row is answered by `error`,
/// the rows around it by what they ask for, and the exit status is 1.
class MalformedTableTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

    QString file(const QString& name, const QByteArray& text) {
        return writeFile(folder_.path(), name, text);
    }

    /// The middle one of three rows is malformed; `good` is what `column` holds for those around it.
    static void checkAnswers(const ProgramResult& result, const char* column, const std::string& good,
                             const QByteArray& told) {
        QVERIFY2(result.status == 1, result.errors.left(300));
        QVERIFY2(result.errors.contains(":3: error: row 2: "), result.errors.left(300));
        QVERIFY2(result.errors.contains(told), result.errors.left(300));
        QVERIFY(result.errors.size() < 1000);
        const isoscope::CsvTable rows = tableOf(result);
        QCOMPARE(rows.rowCount(), 3u);
        QCOMPARE(rows.field(0, column), good);
        QCOMPARE(rows.field(1, column), std::string("error"));
        QCOMPARE(rows.field(2, column), good);
    }

  private slots:
    /// F1, F1b and F3 of `roots`.
    void rootsTellWhatIsMalformed_data() {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("told");
        const auto add = [](const char* name, const QByteArray& container, const QByteArray& line,
                            const QByteArray& told) {
            QTest::newRow(name) << "x,0,\"" + container + "\"," + line << told;
        };
        const QByteArray line = "-5,0,0,1,0,0", ball = "sphere{<0,0,0>,2}";
        add("F1b: 1e999", "sphere{<0,0,0>,1e999}", line, "column `container`");
        add("F1b: 1e-400", "sphere{<0,0,0>,1e-400}", line, "column `container`");
        add("F3: unknown shape", "spher{<0,0,0>,2}", line, "column `container`");
        add("F3: no radius", "sphere{<0,0,0>}", line, "column `container`");
        add("F3: word for a radius", "sphere{<0,0,0>,x2}", line, "column `container`");
        add("F3: negative radius", "sphere{<0,0,0>,-2}", line, "column `container`");
        add("F3: no brackets", "sphere{0,0,0,2}", line, "column `container`");
        add("F3: text behind", "sphere{<0,0,0>,2} 3", line, "column `container`");
        add("F3: box of one corner", "box{<0,0,0>}", line, "column `container`");
        add("F3: no container", "", line, "column `container`");
        add("F3: word", ball, "abc,0,0,1,0,0", "column `ox`: `abc` is no number");
        add("F3: nan", ball, "nan,0,0,1,0,0", "column `ox`: `nan` is no finite number");
        add("F3: direction 0", ball, "-5,0,0,0,0,0", "direction of length 0");
        add("F3: infinite direction", ball, "-5,0,0,inf,0,0", "column `dx`: `inf` is no finite number");
        add("F3: missing cells", ball, "-5,0,0", "column `dx`: the cell is empty");
        add("F3: too many cells", ball, "-5,0,0,1,0,0,7", "more than the header's");
    }

    void rootsTellWhatIsMalformed() {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, told);
        const QByteArray good = "x,0,\"sphere{<0,0,0>,2}\",-5,0,0,1,0,0\n";
        const QString table = file("roots.csv", "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\na," +
                                                    good + "b," + row + "\nc," + good);
        checkAnswers(runCli({"roots", "--table", table}), "t", "5", told);
    }

    /// A number of 30 000 digits is a number: F1 was a recursion of as many levels.
    void F1LongNumbersAreRead() {
        const QString table = file(
            "long.csv", "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\na,x,0,\"sphere{<0,0,0>,0." +
                            QByteArray(300000, '1') + "}\",-5,0,0,1,0,0\n");
        const ProgramResult result = runCli({"roots", "--table", table});
        QCOMPARE(result.status, 0);
        QCOMPARE(tableOf(result).field(0, "t"), std::string("5"));
    }

    void F3SettingsOfRootsAreChecked() {
        const QString table =
            file("settings.csv",
                 "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz,accuracy,settings,t_min\n"
                 "a,x,0,\"box{<1,1,1>,<-1,-1,-1>}\",-5,0,0,1,0,0,,,\n"
                 "b,x,0,\"box{<1,1,1>,<-1,-1,-1>}\",-5,0,0,1,0,0,0,,\n"
                 "c,x,0,\"box{<1,1,1>,<-1,-1,-1>}\",-5,0,0,1,0,0,,max_gradient_factor=,\n"
                 "d,x,0,\"box{<1,1,1>,<-1,-1,-1>}\",-5,0,0,1,0,0,,,soon\n");
        const ProgramResult result = runCli({"roots", "--table", table});
        QCOMPARE(result.status, 1);
        QVERIFY(result.errors.contains(":3: error: row 2: column `accuracy`: `0` is not above 0"));
        QVERIFY(result.errors.contains(":4: error: row 3: column `settings`"));
        QVERIFY(result.errors.contains(":5: error: row 4: column `t_min`: `soon` is no number"));
        QCOMPARE(tableOf(result).field(0, "t"), std::string("5"));  // corners in any order
        for (const std::size_t row : {1u, 2u, 3u})
            QCOMPARE(tableOf(result).field(row, "t"), std::string("error"));
    }

    void F3TraceTellsWhatIsMalformed_data() {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("word") << QByteArray("abc,0,-4,0,0,1") << QByteArray("column `ox`: `abc`");
        QTest::newRow("number and letter") << QByteArray("0,0,-4,0,0,1x") << QByteArray("column `dz`: `1x`");
        QTest::newRow("nan") << QByteArray("0,nan,-4,0,0,1") << QByteArray("column `oy`: `nan`");
        QTest::newRow("missing cells")
            << QByteArray("0,0,-4") << QByteArray("column `dx`: the cell is empty");
        QTest::newRow("direction 0") << QByteArray("0,0,-4,0,0,0") << QByteArray("direction of length 0");
    }

    void F3TraceTellsWhatIsMalformed() {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, told);
        const QString scene = file("ball.pov", "#version 3.7; sphere { 0, 1 pigment { rgb 1 } }\n");
        const QString rays = file("rays.csv", "ox,oy,oz,dx,dy,dz\n0,0,-4,0,0,1\n" + row + "\n0,0,-4,0,0,1\n");
        checkAnswers(runCli({"trace", scene, "--rays", rays}), "hit", "1", told);
    }

    void F3InsideTellsWhatIsMalformed_data() {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("word") << QByteArray("abc,0,0") << QByteArray("column `x`: `abc`");
        QTest::newRow("nan") << QByteArray("0,0,nan") << QByteArray("column `z`: `nan`");
        QTest::newRow("empty row") << QByteArray(",,") << QByteArray("column `x`: the cell is empty");
    }

    void F3InsideTellsWhatIsMalformed() {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, told);
        const QString scene = file("ball.pov", "#version 3.7; sphere { 0, 1 pigment { rgb 1 } }\n");
        const QString points = file("points.csv", "x,y,z\n0,0,0\n" + row + "\n0,0,0\n");
        checkAnswers(runCli({"inside", scene, "--points", points}), "inside", "1", told);
    }

    void F3PolynomialTellsWhatIsMalformed_data() {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("word") << QByteArray("1;abc;-1,-5,5")
                              << QByteArray("column `coefficients`: `1;abc;-1`");
        QTest::newRow("empty part") << QByteArray("1;;-1,-5,5")
                                    << QByteArray("column `coefficients`: `1;;-1`");
        QTest::newRow("blanks") << QByteArray("1 0 -1,-5,5") << QByteArray("column `coefficients`: `1 0 -1`");
        QTest::newRow("bound") << QByteArray("1;0;-1,x,5") << QByteArray("column `lo`: `x`");
        QTest::newRow("nothing") << QByteArray(",-5,5") << QByteArray("column `coefficients`");
        // A thousand took 40 s, a hundred thousand days.
        QTest::newRow("too many") << QByteArray("1;").repeated(100000) + "1,-5,5"
                                  << QByteArray("has 100001 numbers; 101 are read");
    }

    void F3PolynomialTellsWhatIsMalformed() {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, told);
        const QString table =
            file("polynomials.csv", "case_id,coefficients,lo,hi\na,1;-2,-5,5\nb," + row + "\nc,1;-2,-5,5\n");
        checkAnswers(runCli({"polynomial", "--table", table}), "roots", "2", told);
    }

    /// A coordinate may be left out where the expression does not read it.
    void F3EvaluateTellsWhatIsMalformed() {
        const QString table = file("values.csv",
                                   "expression,x,y,z,noise_generator,rx\n"
                                   "x,1,0,0,,\n"
                                   "x+y,1\n"
                                   "x,,,\n"
                                   "x,1\n"
                                   "x,1,abc,0,,\n"
                                   "x,1,0,0,9,\n"
                                   "x,1,0,0,,wide\n"
                                   "3,,,\n"
                                   "\"sum(i,1,2,i*z)\",1\n");
        for (const char* evaluator : {"batch", "reference"}) {
            const ProgramResult result = runCli({"evaluate", "--table", table, "--evaluator", evaluator});
            QCOMPARE(result.status, 1);
            QCOMPARE(result.errors.count('\n'), 6);
            for (const char* told :
                 {":3: error: row 2: column `y`: the cell is empty, but the expression reads it",
                  ":4: error: row 3: column `x`: the cell is empty",
                  ":6: error: row 5: column `y`: `abc` is no number",
                  ":7: error: row 6: column `noise_generator`: `9` is not 1, 2 or 3",
                  ":8: error: row 7: column `rx`: `wide` is no number",
                  ":10: error: row 9: column `z`: the cell is empty"})
                QVERIFY2(result.errors.contains(told), result.errors);
            const isoscope::CsvTable rows = tableOf(result);
            QCOMPARE(rows.rowCount(), 9u);
            for (const std::size_t row : {0u, 3u}) QCOMPARE(rows.field(row, "value"), std::string("1"));
            QCOMPARE(rows.field(7, "value"), std::string("3"));
            for (const std::size_t row : {1u, 2u, 4u, 5u, 6u, 8u}) {
                QVERIFY(rows.field(row, "value").empty());
                QCOMPARE(rows.field(row, "error"), std::string("the row is malformed"));
            }
        }
    }

    void aQuoteThatIsNeverClosedIsTold() {
        const QString table = file("quote.csv", "expression,x,y,z\nx,1,2,3\n\"x,1,2,3\nx,1,2,3\n");
        const ProgramResult result = runCli({"evaluate", "--table", table});
        QCOMPARE(result.status, 1);
        QVERIFY2(result.errors.contains("quote.csv:3: error: this quote is never closed"), result.errors);
    }

    /// F4: an output that got lost is a failure.
    void F4LostOutputIsAFailure() {
        const QString table = file("small.csv", "expression,x,y,z\nx,1,2,3\n");
        for (const QString& command : {QString("functions --csv"), "evaluate --table " + table}) {
            const ProgramResult result = runProgram(
                "sh", {"-c", QString(ISOSCOPE_BINARY_DIR "/isoscope-cli ") + command + " > /dev/full"});
            QVERIFY2(result.status == 1, qPrintable(command));
            QVERIFY(result.errors.contains("standard output cannot be written"));
        }
    }
};

QTEST_GUILESS_MAIN(MalformedTableTest)
#include "malformed_table_test.moc"
