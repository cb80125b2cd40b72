// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of rays: what is true of a ray does not depend on the length of its direction, nor on how many roots
// there are.
#include <array>
#include <cmath>
#include <numbers>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/csv_table.h"
#include "tests/support/program.h"

using namespace isoscope::test;

class RayTableTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

    QString file(const QString& name, const QByteArray& text) {
        return writeFile(folder_.path(), name, text);
    }

  private slots:
    void directionsOfAnyLength_data() {
        QTest::addColumn<QByteArray>("size");
        for (const char* size : {"1e-310", "1e-300", "1e-162", "1e-100", "1", "1e100", "1e155", "1e300"})
            QTest::newRow(size) << QByteArray(size);
    }
    /// N1: a certified miss for directions whose square is 0 or infinite.
    void directionsOfAnyLength() {
        QFETCH(QByteArray, size);
        const double scale = size.toDouble();
        const QByteArray line = "-5,0.1,0.2," + size + ",0,0\n";
        const double exact = (5 - std::sqrt(1 - 0.05)) / scale;
        const auto isExact = [&](const std::string& t) {
            const double found = QByteArray::fromStdString(t).toDouble();
            return std::isinf(exact) ? std::isinf(found) : std::abs(found / exact - 1) < 1e-4;
        };
        const QString roots = file("roots.csv",
                                   "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n"
                                   "a,x*x+y*y+z*z-1,0,\"box{<-2,-2,-2>,<2,2,2>}\"," +
                                       line + "b,x*x+y*y+z*z-1,0,\"sphere{<0,0,0>,2}\"," + line);
        const isoscope::CsvTable found = tableOf(runCli({"roots", "--table", roots}));
        QCOMPARE(found.rowCount(), 2u);
        for (std::size_t row = 0; row < 2; ++row) {
            QCOMPARE(found.field(row, "kind"), std::string("certified-hit"));
            QVERIFY2(isExact(found.field(row, "t")), found.field(row, "t").c_str());
        }
        const QString scene = file("ball.pov",
                                   "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere "
                                   "{ 0, 2 } } max_gradient 4 }\n");
        const QString rays = file("rays.csv", "ox,oy,oz,dx,dy,dz\n" + line);
        for (const char* solver : {"certified", "lipschitz"}) {
            const isoscope::CsvTable hits =
                tableOf(runCli({"trace", scene, "--rays", rays, "--solver", solver}));
            QCOMPARE(hits.field(0, "hit"), std::string("1"));
            QVERIFY2(isExact(hits.field(0, "t")), hits.field(0, "t").c_str());
        }
    }

    /// A certified miss: the power is 0 as a double in the middle of the line and was taken for 0 all over.
    void powersThatUnderflowAreNotMissed() {
        const QString table = file("powers.csv",
                                   "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n"
                                   "a,\"pow(x,4347.25)-0.5\",0,\"box{<0.19263465628823384,-1,-1>,"
                                   "<1.013961883299079,1,1>}\",0,0,0,1,0,0\n"
                                   "b,\"pow(x,-10933.75)-1\",0,\"box{<0.9997665493113316,-1,-1>,"
                                   "<1.347968799348206,1,1>}\",3,0,0,-1,0,0\n");
        const isoscope::CsvTable rows = tableOf(runCli({"roots", "--table", table}));
        QCOMPARE(rows.rowCount(), 2u);
        const std::array exact{std::pow(0.5, 1 / 4347.25), 2.0};
        for (std::size_t k = 0; k < 2; ++k) {
            QCOMPARE(rows.field(k, "kind"), std::string("certified-hit"));
            const double t = QByteArray::fromStdString(rows.field(k, "t")).toDouble();
            QVERIFY2(std::abs(t - exact[k]) < 1e-6, rows.field(k, "t").c_str());
        }
    }

    /// A table may say that a function is flat, or has no bound.
    void boundsOfAnySize() {
        const QByteArray row = ",x,0,\"sphere{<0,0,0>,2}\",-5,0,0,1,0,0,";
        const QString table =
            file("bounds.csv", "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz,lipschitz\na" + row +
                                   "0\nb" + row + "inf\nc" + row + "1\n");
        const ProgramResult result = runCli({"roots", "--table", table});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = tableOf(result);
        for (std::size_t k = 0; k < 3; ++k) QCOMPARE(rows.field(k, "t"), std::string("5"));
    }

    /// N6: behind every tenth root a length of `accuracy` was skipped, and all behind the thousandth.
    /// Of 1/x there is one, of tan(x) one between any two roots; y - 1/x has a surface beside it. Where the
    /// sign does not change, or there is no value, nothing is told.
    void polesAreListedAndNoSurface() {
        const QString table = file("poles.csv",
                                   "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n"
                                   "one,1/x,0,\"box{<-1,-1,-1>,<1,1,1>}\",-2,0,0,1,0,0\n"
                                   "tan,tan(x),0,\"box{<-5,-1,-1>,<5,1,1>}\",-6,0,0,1,0,0\n"
                                   "both,y-1/x,0,\"box{<-2,-2,-2>,<2,2,2>}\",-3,1,0,1,0,0\n"
                                   "even,1/(x*x),0,\"box{<-1,-1,-1>,<1,1,1>}\",-2,0,0,1,0,0\n"
                                   "edge,sqrt(x)-1,0,\"box{<-4,-1,-1>,<4,1,1>}\",-5,0,0,1,0,0\n");
        const ProgramResult result = runCli({"roots", "--table", table});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = tableOf(result);
        const auto eventsOf = [&](std::size_t row) {
            QStringList words;
            for (const QString& event : QString::fromStdString(rows.field(row, "roots")).split(';')) {
                const QStringList parts = event.split(':');
                if (parts.size() == 2) words << QString::number(parts[0].toDouble(), 'f', 6) + ' ' + parts[1];
            }
            return words;
        };
        QCOMPARE(eventsOf(0), QStringList({"2.000000 pole"}));
        QCOMPARE(rows.field(0, "t"), std::string("miss"));
        QCOMPARE(eventsOf(1),
                 QStringList({"1.287611 pole", "2.858407 crossing", "4.429204 pole", "6.000000 crossing",
                              "7.570796 pole", "9.141593 crossing", "10.712389 pole"}));
        QCOMPARE(eventsOf(2), QStringList({"3.000000 pole", "4.000000 crossing"}));
        QVERIFY(std::abs(rows.number(2, "t", 0) - 4) < 1e-9);
        QCOMPARE(eventsOf(3), QStringList());
        QCOMPARE(eventsOf(4), QStringList({"6.000000 crossing"}));
    }

    void everyRootIsListed() {
        const QString table = file("many.csv",
                                   "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n"
                                   "a,sin(10000*x)-0.5,0,\"box{<-1,-1,-1>,<1,1,1>}\",-1,0,0,1,0,0\n");
        const ProgramResult result = runCli({"roots", "--table", table});
        const isoscope::CsvTable rows = tableOf(result);
        const QList<QByteArray> events = QByteArray::fromStdString(rows.field(0, "roots")).split(';');
        int expected = 0;
        for (int k = -3200; k < 3200; ++k)
            for (const double angle : {std::numbers::pi / 6, 5 * std::numbers::pi / 6}) {
                const double x = (angle + 2 * std::numbers::pi * k) / 10000;
                expected += x > -1 && x < 1;
            }
        QCOMPARE(events.size(), expected);
        double last = 0;
        for (const QByteArray& event : events) {
            const double t = event.split(':').front().toDouble();
            QVERIFY(t > last);
            QVERIFY2(std::abs(std::sin(10000 * (t - 1)) - 0.5) < 1e-3, event);
            last = t;
        }
    }
};

QTEST_GUILESS_MAIN(RayTableTest)
#include "ray_table_test.moc"
