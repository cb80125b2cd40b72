// SPDX-License-Identifier: GPL-3.0-or-later
// What the search for roots costs: for every built-in, and for functions of every kind, the enclosures, the
// values and the verdicts of a small picture, as tests/data/render/search_costs.csv has them. A change of the
// search that makes one dearer is seen here, and one that makes it cheaper is to be written down there: with
// ISOSCOPE_WRITE_COSTS=FILE the test writes the table as it is now.
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <optional>
#include <QTest>

#include "core/function/builtins/builtin.h"
#include "test_folders.h"
#include "tests/support/builtin_scene.h"
#include "tests/support/csv_table.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

struct Case {
    std::string name, statement;
};

std::string isosurface(const std::string& function,
                       const std::string& items = "contained_by { box { -1, 1 } }") {
    return "isosurface { function { " + function + " } " + items + " pigment { rgb 0.9 } }\n";
}

/// A union of balls on a spiral.
std::string balls(int count) {
    std::string text = "0";
    for (int k = 0; k < count; ++k) {
        const double turn = 0.7 * k, height = 1.6 * k / count - 0.8;
        const std::string ball = "sqrt(pow(x-(" + std::to_string(0.7 * std::cos(turn)) + "),2)+pow(y-(" +
                                 std::to_string(height) + "),2)+pow(z-(" +
                                 std::to_string(0.7 * std::sin(turn)) + "),2))-0.15";
        text = k == 0 ? ball : "min(" + text + ", " + ball + ")";
    }
    return text;
}

/// Functions that the built-ins do not stand for, and settings that are not the defaults.
std::vector<Case> writtenCases() {
    const std::string ball = "x*x + y*y + z*z - 0.8", box = "contained_by { box { -1, 1 } } ";
    return {
        {"ball", isosurface(ball)},
        {"ball, fine", isosurface(ball, box + "accuracy 1e-9")},
        {"ball, coarse", isosurface(ball, box + "accuracy 0.1")},
        {"ball, threshold", isosurface(ball, box + "threshold 0.15")},
        {"ball, inside out", isosurface("-(" + ball + ")", box + "polarity 1")},
        {"ball, cut", isosurface(ball, "contained_by { box { <-1, -1, -0.5>, 0.6 } }")},
        {"ball, cut open", isosurface(ball, "contained_by { box { <-1, -1, -0.5>, 0.6 } } open")},
        {"ball, hollowed",
         "difference { " + isosurface(ball, box + "all_intersections") + "sphere { -0.5*z, 0.7 } }"},
        {"sheets", isosurface("sin(12*x)*sin(9*y + 1) - 0.3*z", box + "open")},
        {"sheets, all", "intersection { " +
                            isosurface("sin(12*x) + sin(9*y + 1) - 3*z", box + "all_intersections") +
                            "box { -0.9, 0.8 rotate 20*y } }"},
        {"plateau", isosurface("max(0, sqrt(x*x + y*y) - 0.5) + max(0, abs(z) - 0.4) - 1e-4")},
        {"touching", isosurface("pow(x*x + y*y + z*z - 0.8, 2)")},
        {"steps", isosurface("floor(6*x)/6 + y*y + z*z - 0.4")},
        {"steps in two directions", isosurface("floor(4*x)/4 + ceil(5*z)/5 + y")},
        {"teeth", isosurface("y - 0.3*mod(3*x + z, 1)")},
        {"checks",
         isosurface("select(mod(int(4*x + 9) + int(4*y + 9) + int(4*z + 9), 2) - 0.5, x*x + y*y + z*z - 0.9, "
                    "x*x + y*y + z*z - 0.5)")},
        {"sectors", isosurface("sqrt(x*x + z*z) - 0.5 - 0.2*sin(5*atan2(z, x)) + 0.3*y*y")},
        {"cut of atan2", isosurface("y - 0.2*atan2(z, x)")},
        {"pole", isosurface("1/(x + 0.3*y) - 2 + z")},
        {"domain", isosurface("sqrt(x*y) + ln(z + 1.2) - 0.3")},
        {"powers", isosurface("pow(abs(x), 2.5) + pow(abs(y), 0.7) + exp(z) - 1.4")},
        {"circle functions", isosurface("asin(x) + acos(y) - atan(3*z) - 1.2")},
        {"hyperbolic", isosurface("sinh(x) + cosh(y) - tanh(3*z) - 1.2")},
        {"tangent", isosurface("tan(2*x) + y - z")},
        {"polynomial", isosurface("x*x*x*x - 2*x*x*y*y + y*y*y*y*z - z*z + 0.05")},
        {"rough ball", isosurface("x*x + y*y + z*z - 0.7 + 0.3*f_noise3d(5*x, 5*y, 5*z)")},
        {"rough ball of generator 1",
         "global_settings { noise_generator 1 }\n" +
             isosurface("x*x + y*y + z*z - 0.7 + 0.2*f_noise_generator(5*x, 5*y, 5*z, 1)")},
        {"ridges", isosurface("y - 0.4*f_ridged_mf(2*x, 0, 2*z, 0.8, 2.1, 5, 1, 2, 2)")},
        {"octaves",
         isosurface(
             "y + 0.3*(f_noise3d(2*x, 0, 2*z) + f_noise3d(4*x, 0, 4*z)/2 + f_noise3d(8*x, 0, 8*z)/4)")},
        {"blend",
         isosurface("0.9 - exp(-8*(pow(x-0.4,2)+y*y+z*z)) - exp(-6*(pow(x+0.3,2)+y*y+pow(z-0.2,2))) - "
                    "exp(-9*(x*x+pow(y-0.4,2)+z*z)) - 0.4")},
        {"balls", isosurface(balls(24))},
        {"many balls", isosurface(balls(80))},
        {"spline",
         "#declare S = function { spline { natural_spline 0, <0.1, 0, 0> 0.4, <0.5, 0, 0> 0.7, <0.2, 0, 0> "
         "1, "
         "<0.4, 0, 0> } }\n" +
             isosurface("sqrt(x*x + z*z) - S((y + 1)/2).x")},
        {"crackle", "#declare P = function { pattern { crackle form <-1, 1, 0> scale 0.4 } }\n" +
                        isosurface("x*x + y*y + z*z - 0.6 - 0.6*P(x, y, z)")},
        {"cells", "#declare P = function { pattern { cells scale 0.5 } }\n" +
                      isosurface("x*x + y*y + z*z - 0.5 - 0.4*P(x, y, z)")},
        {"crackle of whole cells", "#declare P = function { pattern { crackle solid scale 0.4 } }\n" +
                                       isosurface("x*x + y*y + z*z - 0.6 - 0.3*P(x, y, z)")},
        {"crackle of another metric", "#declare P = function { pattern { crackle metric 1.5 scale 0.4 } }\n" +
                                          isosurface("x*x + y*y + z*z - 0.6 - 0.3*P(x, y, z)")},
        {"turbulent wood", "#declare P = function { pattern { wood turbulence 0.2 octaves 3 scale 0.4 } }\n" +
                               isosurface("x*x + y*y + z*z - 0.8 + 0.3*P(x, y, z)")},
        {"turbulent marble", "#declare P = function { pattern { marble turbulence 0.5 scale 0.6 } }\n" +
                                 isosurface("x*x + y*y + z*z - 0.8 + 0.3*P(x, y, z)")},
        {"pigment",
         "#declare P = function { pigment { gradient y color_map { [0 rgb 0.1] [0.4 rgb 0.8] [0.4 rgb 0.2] "
         "[1 "
         "rgb 0.9] } scale 0.7 } }\n" +
             isosurface("x*x + z*z - 0.6*P(x, y, z).gray")},
        {"mandel", "#declare P = function { pattern { mandel 20 } }\n" + isosurface("z + 0.5*P(x, y, 0)")},
        {"far away", "object { " + isosurface(ball) +
                         " scale <1, 0.3, 0.8> rotate <20, 30, 40> translate <0.2, 0.1, 0> }"},
    };
}

std::vector<Case> allCases() {
    std::vector<Case> cases = writtenCases();
    for (const Builtin& builtin : builtins())
        if (!builtin.name.empty() && builtin.pointArguments == 3)
            cases.push_back({builtin.name, builtinStatement(builtin, "max_gradient 5 pigment { rgb 0.9 }")});
    return cases;
}

/// One row of the table.
struct Cost {
    double evaluations = 0, found = 0, missed = 0, others = 0;
    /// The mean of the colours, of 255: where the surface is, and its normals.
    double brightness = 0;
};

Cost costOf(const Case& searched, RootFinder finder) {
    RenderRequest request = studyScene(searched.statement, 64, 48);
    request.rootFinder = finder;
    const Bounds bounds = request.scene->objects.front().shape->bounds();
    const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
    request.camera.location =
        middle + 0.5 * glm::distance(bounds.low, bounds.high) * glm::dvec3(1.3, 1.7, -2.6);
    request.camera = request.camera.lookingAt(middle);
    RenderStatistics statistics;
    const Image image = renderImage(request, 1, &statistics);
    Cost cost;
    cost.evaluations = static_cast<double>(statistics.evaluations);
    for (const auto& [verdict, count] : statistics.verdicts) {
        const bool found = verdict == "hit" || verdict == "certified-hit";
        const bool missed = verdict == "miss" || verdict == "certified-miss";
        (found ? cost.found : missed ? cost.missed : cost.others) += static_cast<double>(count);
    }
    for (const auto& [red, green, blue] : image.pixels) cost.brightness += red + green + blue;
    cost.brightness *= 255.0 / (3 * static_cast<double>(image.pixels.size()));
    return cost;
}

}  // namespace

class SearchCostTest : public QObject {
    Q_OBJECT

  private:
    std::ofstream written_;
    std::optional<ForcedInstructionSet> instructions_;

  private slots:
    /// Others round in their own ways, and take up to 1 % more or less.
    void initTestCase() {
#if HWY_ARCH_X86 && !(defined(HWY_COMPILE_ONLY_STATIC) && HWY_STATIC_TARGET < HWY_SSE4)
        instructions_.emplace(HWY_SSE4);
#else
        QSKIP("the table is that of SSE4");
#endif
        if (const QByteArray file = qgetenv("ISOSCOPE_WRITE_COSTS"); !file.isEmpty()) {
            written_.open(file.toStdString());
            written_ << "name,solver,evaluations,found,missed,others,brightness\n";
        }
    }

    void costsWhatItDid_data() {
        QTest::addColumn<QString>("statement");
        for (const Case& searched : allCases())
            QTest::newRow(searched.name.c_str()) << QString::fromStdString(searched.statement);
    }

    void costsWhatItDid() {
        QFETCH(QString, statement);
        const std::string name = QTest::currentDataTag();
        static const test::CsvTable table(QStringLiteral(ISOSCOPE_TEST_DATA "/render/search_costs.csv"));
        for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
            const std::string solver = finder == RootFinder::certified ? "certified" : "lipschitz";
            const Cost cost = costOf({name, statement.toStdString()}, finder);
            if (written_.is_open()) {
                const auto number = [](double value) {
                    return QByteArray::number(value, 'f', 0).toStdString();
                };
                written_ << csvLine({name, solver, number(cost.evaluations), number(cost.found),
                                     number(cost.missed), number(cost.others),
                                     QByteArray::number(cost.brightness, 'f', 2).toStdString()});
                continue;
            }
            std::size_t row = 0;
            while (row < table.rowCount() &&
                   (table.field(row, "name") != name || table.field(row, "solver") != solver))
                ++row;
            QVERIFY2(row < table.rowCount(), "not in the table");
            // Compilers round in their own ways, too.
            const auto near = [&](const char* column, double got, double slack) {
                const double wanted = table.number(row, column);
                return QTest::qVerify(std::abs(got - wanted) <= slack, column,
                                      qPrintable(QStringLiteral("%1, %2: %3 for %4")
                                                     .arg(QString::fromStdString(solver), column)
                                                     .arg(got)
                                                     .arg(wanted)),
                                      __FILE__, __LINE__);
            };
            if (!near("evaluations", cost.evaluations, 4 + 0.005 * table.number(row, "evaluations"))) return;
            if (!near("found", cost.found, 2)) return;
            if (!near("missed", cost.missed, 2)) return;
            if (!near("others", cost.others, 2)) return;
            if (!near("brightness", cost.brightness, 0.05)) return;
        }
    }
};

QTEST_APPLESS_MAIN(SearchCostTest)
#include "search_cost_test.moc"
