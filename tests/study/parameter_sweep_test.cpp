// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/sweep/parameter_sweep.h"

#include <cmath>
#include <QTest>

#include "core/exchange/varied_number.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::string lattice =
    "#version 3.7;\n#declare R = 1;\ncamera { location <0.3,0.7,-9> look_at 0 angle 40 }\n"
    "isosurface { function { cos(pi*x) + cos(pi*y) + cos(pi*z)*R } contained_by { box { -1.4, 1.4 } }\n"
    "  threshold -2 max_gradient 6 }\n";

std::vector<SweepPoint> swept(const ParseResult& parsed, const std::string& name,
                              const std::vector<double>& values) {
    const FoundNumber found = findNumber(parsed, name);
    if (!found.parameter) qCritical("%s", found.problem.c_str());
    SweepRequest request;
    request.view = requestFor(parsed, 80, 60);
    request.values = values;
    request.sceneAt = [&](double value) {
        const NumberSetting setting{*found.parameter, value};
        return sceneWithNumbers(parsed, {&setting, 1});
    };
    ParameterSweep sweep(std::move(request));
    std::vector<SweepPoint> points;
    while (const auto point = sweep.next({}, 1)) points.push_back(*point);
    return points;
}

}  // namespace

class ParameterSweepTest : public QObject {
    Q_OBJECT

  private slots:
    void valuesAreSpreadFromEndToEnd() {
        QCOMPARE(sweepValues(0, 1, 5), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
        QCOMPARE(sweepValues(2, -2, 3), (std::vector<double>{2, 0, -2}));
        const std::vector<double> powers = sweepValues(0.01, 1, 3, true);
        QVERIFY(std::abs(powers[1] - 0.1) < 1e-15 && powers[2] == 1);
        QCOMPARE(sweepValues(-1, 1, 3, true)[1], 0.0);
        QCOMPARE(sweepValues(3, 4, 1), std::vector<double>{3});
        QVERIFY(sweepValues(0, std::nan(""), 3).empty() && sweepValues(0, 1, 0).empty());
    }

    /// Balls, then joined along the edges of a cube, then nothing but a hollow room with windows.
    void piecesFollowTheThreshold() {
        const ParseResult parsed = parseScene(lattice);
        QVERIFY(parsed.ok());
        const std::vector<SweepPoint> points = swept(parsed, "threshold", {-4, -2, -0.5});
        QCOMPARE(points.size(), std::size_t(3));
        for (const SweepPoint& point : points) QVERIFY(point.known);
        QCOMPARE(points[0].solid, (SolidCount{0, 0, 0, true}));
        QCOMPARE(points[1].solid, (SolidCount{8, 0, 0, true}));
        QCOMPARE(points[2].solid, (SolidCount{1, 5, 0, true}));
        QCOMPARE(points[0].hitShare, 0.0);
        QVERIFY(points[1].hitShare > 0.05 && points[2].hitShare > points[1].hitShare);
        // The gradient has nothing to do with the threshold.
        for (const SweepPoint& point : points) {
            QVERIFY(point.gradientLow <= M_PI * std::sqrt(3) && point.gradientHigh >= M_PI * std::sqrt(3));
            QVERIFY(point.gradientHigh < 1.03 * point.gradientLow);
            QVERIFY(point.evaluationsPerPixel[0] > 0 && point.evaluationsPerPixel[1] > 0);
        }
    }

    void theGradientFollowsTheFunction() {
        const std::vector<SweepPoint> points = swept(parseScene(lattice), "R", {1, 4});
        QVERIFY(points[1].gradientLow > 2 * points[0].gradientHigh);
    }

    /// A number of the camera asks for another parse; a text with errors is no scene.
    void whatCannotBeReadIsNotKnown() {
        const ParseResult parsed = parseScene(lattice);
        const std::vector<SweepPoint> points = swept(parsed, "max_gradient", {6, -1, 12});
        QVERIFY(points[0].known && !points[1].known && points[2].known);
        QVERIFY(points[2].evaluationsPerPixel[0] > points[0].evaluationsPerPixel[0]);
        QCOMPARE(sweepTableLine(points[1]), std::string("-1,,,,,,,,\n"));
    }

    void numbersAreFoundByTheirNames() {
        const ParseResult parsed = parseScene(
            "#version 3.7;\n#include \"functions.inc\"\n#declare R = 1;\n#declare S = R;\n"
            "isosurface { function { f_torus(x,y,z,0.5,0.1) }\n  contained_by { box { -1, 1 } } }\n"
            "isosurface { function { f_torus(x,y,z,R,0.2) }\n  contained_by { box { -1, 1 } } }\n");
        QVERIFY(findNumber(parsed, "r").parameter && findNumber(parsed, "f_torus major radius").parameter);
        const FoundNumber twice = findNumber(parsed, "Minor Radius");
        QVERIFY(!twice.parameter);
        QCOMPARE(twice.problem, std::string("several numbers are called `Minor Radius`, in the lines 5, 7"));
        const FoundNumber found = findNumber(parsed, "Minor Radius", 7);
        QVERIFY(found.parameter && parsed.scene->parameters[*found.parameter].value == 0.2);
        const FoundNumber none = findNumber(parsed, "Q");
        QVERIFY(none.problem.find("no number is called `Q`; there are: R") == 0);
    }

    void aStopEndsIt() {
        const ParseResult parsed = parseScene(lattice);
        SweepRequest request;
        request.view = requestFor(parsed, 80, 60);
        request.values = {1, 2};
        request.sceneAt = [&](double) { return parsed.scene; };
        ParameterSweep sweep(std::move(request));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!sweep.next(stop.get_token()) && sweep.done() == 0);
        QVERIFY(sweep.next().has_value());
    }
};

QTEST_MAIN(ParameterSweepTest)
#include "parameter_sweep_test.moc"
