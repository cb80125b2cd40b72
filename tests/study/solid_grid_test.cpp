// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/shape/solid_grid.h"

#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

SolidCount countOf(const std::string& settings, int cells = 40) {
    const auto scene = studyScene("isosurface { " + settings + " }\n").scene;
    return SolidGrid(*scene->isosurfaces.at(0).shape, *scene->parameterTable, cells).count();
}

SolidCount counted(std::int64_t pieces, std::int64_t tunnels, std::int64_t hollows) {
    return {pieces, tunnels, hollows, true};
}

}  // namespace

namespace QTest {
template <>
char* toString(const SolidCount& c) {
    return toString(QString("%1 pieces, %2 tunnels, %3 hollows, known %4")
                        .arg(c.pieces)
                        .arg(c.tunnels)
                        .arg(c.hollows)
                        .arg(c.known));
}
}  // namespace QTest

class SolidGridTest : public QObject {
    Q_OBJECT

  private slots:
    void simpleSolids() {
        const std::string box = " } contained_by { box { -1.3, 1.3 } }";
        QCOMPARE(countOf("function { x*x + y*y + z*z - 1" + box), counted(1, 0, 0));
        QCOMPARE(countOf("function { f_torus(x,y,z,0.8,0.3)" + box), counted(1, 1, 0));
        QCOMPARE(countOf("function { abs(sqrt(x*x + y*y + z*z) - 0.8) - 0.2" + box), counted(1, 0, 1));
        QCOMPARE(countOf("function { abs(f_torus(x,y,z,0.8,0.3)) - 0.12" + box, 60), counted(1, 2, 1));
        QCOMPARE(countOf("function { min(f_sphere(x-0.6,y,z,0.4), f_sphere(x+0.6,y,z,0.4))" + box),
                 counted(2, 0, 0));
        QCOMPARE(countOf("function { 1" + box), counted(0, 0, 0));
        QCOMPARE(countOf("function { -1" + box), counted(1, 0, 0));
    }

    /// Two linked rings, one through the other.
    void rings() {
        QCOMPARE(countOf("function { min(f_torus(x,y,z,0.5,0.15), f_torus(x-0.5,z,y,0.5,0.15)) } "
                         "contained_by { box { <-1,-1,-1>, <1.5,1,1> } }",
                         80),
                 counted(2, 2, 0));
    }

    /// The container's wall closes what it cuts.
    void theContainerCuts() {
        QCOMPARE(countOf("function { abs(y) - 0.2 } contained_by { box { -1, 1 } }"), counted(1, 0, 0));
        QCOMPARE(countOf("function { 0.2 - abs(y) } contained_by { box { -1, 1 } }"), counted(2, 0, 0));
        QCOMPARE(countOf("function { 0.3 - sqrt(x*x + z*z) } contained_by { sphere { 0, 1 } }"),
                 counted(1, 1, 0));
        QCOMPARE(countOf("function { 0.3 - sqrt(x*x + y*y + z*z) } contained_by { sphere { 0, 1 } }"),
                 counted(1, 0, 1));
        QCOMPARE(countOf("function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 0.9 } }"),
                 counted(1, 0, 0));
    }

    void polarityAndThresholdCount() {
        QCOMPARE(countOf("function { x*x + y*y + z*z } threshold 0.5 polarity 1 "
                         "contained_by { sphere { 0, 1 } }"),
                 counted(1, 0, 1));
        QCOMPARE(countOf("function { cos(pi*x) + cos(pi*y) + cos(pi*z) } threshold -2 "
                         "contained_by { box { -1.9, 1.9 } }"),
                 counted(8, 0, 0));
        // Eight balls joined along the edges of a cube: 12 bridges, 5 tunnels.
        QCOMPARE(countOf("function { cos(pi*x) + cos(pi*y) + cos(pi*z) } threshold -0.5 "
                         "contained_by { box { -1.4, 1.4 } }"),
                 counted(1, 5, 0));
    }

    void flatContainersAndStops() {
        QCOMPARE(countOf("function { x*x + z*z - 0.5 } contained_by { box { <-1,0,-1>, <1,0,1> } }").known,
                 true);
        const auto scene = studyScene("isosurface { function { x } }\n").scene;
        std::stop_source stop;
        stop.request_stop();
        const SolidGrid grid(*scene->isosurfaces.at(0).shape, *scene->parameterTable, 40, stop.get_token());
        QVERIFY(!grid.known() && !grid.count().known);
    }
};

QTEST_MAIN(SolidGridTest)
#include "solid_grid_test.moc"
