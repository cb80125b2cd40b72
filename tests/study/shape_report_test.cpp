// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/shape/shape_report.h"

#include <cmath>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

ShapeReport reportOn(const std::string& settings, int cells = 32) {
    const auto scene = studyScene("isosurface { " + settings + " }\n").scene;
    return shapeReport(scene->isosurfaces.at(0).shape, *scene->parameterTable, cells);
}

bool has(const ShapeReport& report, const std::string& symmetry) {
    for (const Symmetry& one : report.symmetries)
        if (one.name == symmetry) return true;
    return false;
}

std::string textOf(const ShapeReport& report, const std::string& topic) {
    for (const ReportLine& line : linesOf(report))
        if (line.topic == topic) return line.text;
    return {};
}

}  // namespace

class ShapeReportTest : public QObject {
    Q_OBJECT

  private slots:
    void aBall() {
        const ShapeReport report =
            reportOn("function { x*x + y*y + z*z - 1 } contained_by { box { -1.3, 1.3 } } accuracy 0.001");
        QVERIFY(report.known && !report.empty);
        QCOMPARE(report.solid, (SolidCount{1, 0, 0, true}));
        QVERIFY(report.check.complete());
        const double volume = 4 * M_PI / 3;
        QVERIFY(report.volume.low <= volume && volume <= report.volume.high);
        QVERIFY(report.volume.high - report.volume.low < 0.05 * volume);
        QVERIFY(std::abs(report.area - 4 * M_PI) <= report.areaError);
        QVERIFY(report.areaError < 0.02 * report.area);
        for (int k = 0; k < 3; ++k) {
            QVERIFY(report.high[k] >= 1 && report.high[k] < 1.01);
            QVERIFY(report.low[k] <= -1 && report.low[k] > -1.01);
        }
        QVERIFY(report.wall.measured > 500 && std::abs(report.wall.thickness - 2) < 0.01);
        for (const char* name : {"mirror x", "point", "x and y exchanged", "any turn about z"})
            QVERIFY2(has(report, name), name);
        QVERIFY(textOf(report, "Pieces").starts_with("1 piece with no tunnels and no hollows"));
        QVERIFY(textOf(report, "Pieces").find("Proven") != std::string::npos);
    }

    void aRing() {
        const ShapeReport report =
            reportOn("function { f_torus(x,y,z,0.8,0.2) } contained_by { box { -1.1, 1.1 } }", 48);
        QCOMPARE(report.solid, (SolidCount{1, 1, 0, true}));
        const double volume = 2 * M_PI * M_PI * 0.8 * 0.04, area = 4 * M_PI * M_PI * 0.8 * 0.2;
        QVERIFY(report.volume.low <= volume && volume <= report.volume.high);
        QVERIFY(std::abs(report.area - area) <= report.areaError);
        QVERIFY(std::abs(report.wall.thickness - 0.4) < 0.01);
        QVERIFY(has(report, "any turn about y") && has(report, "mirror y") &&
                !has(report, "any turn about x"));
    }

    /// Halves of a ball: its volume has no part outside of the container.
    void theContainerCuts() {
        const ShapeReport report = reportOn("function { x } contained_by { sphere { 0, 1 } }", 32);
        const double volume = 2 * M_PI / 3;
        QVERIFY(report.volume.low <= volume && volume <= report.volume.high);
        QVERIFY(report.volume.high - report.volume.low < 0.1 * volume);
        QVERIFY(!has(report, "mirror x") && has(report, "mirror y") && has(report, "any turn about x"));
    }

    /// As in pictures and meshes; half of the container has no value.
    void whereThereIsNoValueThereIsNoSolid() {
        const ShapeReport report =
            reportOn("function { x*x + y*y + z*z - 1 + 0.5*sqrt(x) } contained_by { box { -1.2, 1.2 } }", 32);
        // The discs of area pi*(1 - x^2 - sqrt(x)/2) to the root of that at x.
        const double x = 0.7525055546934396, volume = M_PI * (x - x * x * x / 3 - x * std::sqrt(x) / 3);
        QVERIFY(report.volume.low <= volume && volume <= report.volume.high);
        QVERIFY(report.volume.high - report.volume.low < 0.1 * volume);
    }

    void walls() {
        const ShapeReport thin = reportOn(
            "function { abs(sqrt(x*x + y*y + z*z) - 0.8) - 0.004 } contained_by { box { -1, 1 } } accuracy "
            "0.001",
            48);
        QVERIFY(thin.wall.measured > 0);
        QVERIFY(std::abs(thin.wall.thickness - 0.008) < 1e-4);
        QVERIFY(textOf(thin, "Thinnest wall").find("make accuracy smaller") != std::string::npos);
    }

    /// Digits that are left out make no box too small. Once a side was told as -1.8e-150.
    void whatIsProvenIsRoundedOutwards() {
        ShapeReport report;
        report.known = true;
        report.low = {-1.00004, 0.12344, -1e-150};
        report.high = {1.00004, 1.13341, 1};
        report.volume = {0.99996, 1.00004, 1};
        QVERIFY2(textOf(report, "Extent").starts_with("From <-1.001, 0.123, -0.001> to <1.001, 1.134, 1>"),
                 textOf(report, "Extent").c_str());
        QVERIFY2(textOf(report, "Volume").starts_with("Between 0.999 and 1.001"),
                 textOf(report, "Volume").c_str());
    }

    /// What a grid cannot see is not called proven.
    void finePartsAreNotProven() {
        const ShapeReport report = reportOn(
            "function { min(f_sphere(x,y,z,0.5), f_sphere(x-0.77,y-0.013,z-0.011,0.004)) } "
            "contained_by { box { -1, 1 } }",
            16);
        QCOMPARE(report.solid.pieces, std::int64_t(1));
        QVERIFY(!report.check.complete());
        QVERIFY(textOf(report, "Pieces").find("Not proven") != std::string::npos);
    }

    /// Of many parts, which are told with what matters in each place alone.
    void manyPartsAreCounted() {
        const ShapeReport report = reportOn(
            "function { min(10 #for (I, 0, 99) , f_sphere(x - 0.3*mod(I, 5), y - 0.3*mod(int(I/5), 5), "
            "z - 0.3*int(I/25), 0.1) #end) } contained_by { box { -0.2, <1.4, 1.4, 1.1> } }",
            64);
        QCOMPARE(report.solid, (SolidCount{100, 0, 0, true}));
        QVERIFY(report.check.complete());
        const double volume = 100 * 4.0 / 3 * M_PI * 1e-3;
        QVERIFY(report.volume.low <= volume && volume <= report.volume.high);
        QVERIFY(report.volume.high - report.volume.low < 0.25 * volume);
        QVERIFY(std::abs(report.wall.thickness - 0.2) < 0.01);
    }

    void nothingAndStops() {
        const ShapeReport empty =
            reportOn("function { x*x + y*y + z*z + 1 } contained_by { box { -1, 1 } }", 16);
        QVERIFY(empty.known && empty.empty);
        QCOMPARE(linesOf(empty).size(), std::size_t(1));
        const auto scene = studyScene("isosurface { function { x } }\n").scene;
        std::stop_source stop;
        stop.request_stop();
        const ShapeReport none =
            shapeReport(scene->isosurfaces[0].shape, *scene->parameterTable, 16, {}, stop.get_token());
        QVERIFY(!none.known && linesOf(none).size() == 1);
    }
};

QTEST_MAIN(ShapeReportTest)
#include "shape_report_test.moc"
