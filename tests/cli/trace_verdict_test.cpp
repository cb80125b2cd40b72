// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMap>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace isoscope::test;

/// What `trace` says of rays whose answer the certified root finder cannot prove.
class TraceVerdictTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    /// How often each kind comes.
    QMap<QByteArray, int> kinds(const QByteArray& scene, const QString& solver) {
        QByteArray rays = "ox,oy,oz,dx,dy,dz\n";
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                rays +=
                    QByteArray::number(x / 10.0 - 1) + "," + QByteArray::number(y / 10.0 - 1) + ",-4,0,0,1\n";
        const ProgramResult result =
            runCli({"trace", writeFile(folder_.path(), "scene.pov", scene), "--rays",
                    writeFile(folder_.path(), "rays.csv", rays), "--solver", solver});
        QMap<QByteArray, int> counts;
        for (const QByteArray& line : result.output.trimmed().split('\n').mid(1))
            ++counts[line.split(',').last()];
        return counts;
    }

  private slots:
    /// No ray of the grid touches this ball: 77 is no sum of two squares.
    void certainRaysHaveTheKindOfTheirHit() {
        const QByteArray ball =
            "isosurface { function { x*x + y*y + z*z - 0.77 } contained_by { sphere { 0, 1 } } }";
        for (const char* solver : {"certified", "lipschitz"}) {
            const auto counts = kinds(ball + " camera { location 0 }", solver);
            QCOMPARE(counts.keys(), (QList<QByteArray>{"crossing", "miss"}));
            QCOMPARE(counts["crossing"] + counts["miss"], 400);
        }
    }

    void doubtfulRaysSaySo() {
        const QByteArray plateau =
            "isosurface { function { sin(1e5*(x*y + z))*max(0, sqrt(x*x + y*y) - 0.5)*1e-3 } "
            "contained_by { sphere { 0, 1.5 } } }";
        const auto counts = kinds(plateau, "certified");
        int doubtful = 0;
        for (const char* kind : {"gap", "budget-exceeded", "not-certified"}) doubtful += counts.value(kind);
        QVERIFY(doubtful > 0);
        QVERIFY(!kinds(plateau, "lipschitz").contains("budget-exceeded"));
    }
};

QTEST_GUILESS_MAIN(TraceVerdictTest)
#include "trace_verdict_test.moc"
