// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen in image files of many kinds, beside the answers of POV-Ray (tools/image-kinds).
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "core/language/parse.h"
#include "core/scene/scene.h"
#include "core/shapes/isosurface/isosurface.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/problems.h"

using namespace isoscope;

namespace {

constexpr std::array parts{"red", "green", "blue", "filter", "transmit"};

std::string sceneOf(const test::CsvTable& table, std::size_t row) {
    const std::string file = table.field(row, "file"), gamma = table.field(row, "assumed_gamma");
    const std::string ending = file.substr(file.rfind('.') + 1);
    const std::string image = (ending == "jpg" ? "jpeg" : ending) + " \"" + file + "\"";
    std::string text = "#version " + table.field(row, "version") + ";\n";
    if (!gamma.empty()) text += "global_settings { assumed_gamma " + gamma + " }\n";
    text += "#declare F = function { pigment { image_map { " + image + " " + table.field(row, "settings") +
            " once } } }\n";
    for (const std::string part : parts) text += "isosurface { function { F(x, y, z)." + part + " } }\n";
    return text + "isosurface { function { pattern { image_pattern { " + image + " " +
           table.field(row, "pattern") + " once } } } }\nheight_field { " + image + " }\n";
}

double heightAt(const Scene& scene, double x) {
    const Ray ray{{std::min(x, 0.99), 2, 0.43}, {0, -1, 0}};
    TraceContext context;
    NearestHit hit;
    scene.objects.back().shape->nearest({&ray, 1}, context, {&hit, 1});
    return hit.found ? hit.hit.point.y : 0;
}

}  // namespace

class ImageKindsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Values were infinite, or above the bounds that enclosures rely on.
    void transparencyBeyondReasonStaysWithinBounds() {
        ParseOptions options;
        options.libraryPaths = {ISOSCOPE_TEST_DATA "/texture/kinds"};
        for (const std::string settings :
             {"premultiplied on transmit all 1e300", "premultiplied on transmit all -1e300",
              "premultiplied on filter all 1e400", "premultiplied on transmit all 0.999999",
              "premultiplied on"})
            for (const std::string part : parts) {
                const ParseResult surface =
                    parseScene("#declare F = function { pigment { image_map { png \"rgba16.png\" " +
                                   settings + " } } }\nisosurface { function { F(x, y, z)." + part + " } }",
                               options);
                QVERIFY2(surface.ok(), test::problems(surface).c_str());
                PointEvaluator points(surface.scene->isosurfaces.front().shape->tape(),
                                      *surface.scene->parameterTable);
                for (double x = 0.03; x < 1; x += 0.06) {
                    const double value = points.evaluate(x, 0.5, 0);
                    QVERIFY2(std::abs(value) <= 1e9, (settings + " " + part).c_str());
                }
            }
    }

    void isWhatPovraySees() {
        const test::CsvTable table(QStringLiteral(ISOSCOPE_TEST_DATA "/texture/kinds.csv"));
        QVERIFY(table.rowCount() > 1000);
        ParseOptions options;
        options.libraryPaths = {ISOSCOPE_TEST_DATA "/texture/kinds"};
        std::string text;
        ParseResult parsed;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const std::string wanted = sceneOf(table, row);
            if (wanted != text) {
                text = wanted;
                parsed = parseScene(text, options);
                QVERIFY2(parsed.ok(), (text + test::problems(parsed)).c_str());
            }
            const double x = (table.number(row, "column") + 0.5) / 8;
            const auto& surfaces = parsed.scene->isosurfaces;
            QCOMPARE(surfaces.size(), parts.size() + 1);
            for (std::size_t k = 0; k < surfaces.size(); ++k) {
                const char* column = k < parts.size() ? parts[k] : "value";
                PointEvaluator points(surfaces[k].shape->tape(), *parsed.scene->parameterTable);
                const double got = points.evaluate(x, 0.5, 0), right = table.number(row, column);
                QVERIFY2(test::goldenError(got, right) < 2e-6,
                         qPrintable(QStringLiteral("row %1, %2: %3 for %4\n%5")
                                        .arg(row + 2)
                                        .arg(column)
                                        .arg(got, 0, 'g', 9)
                                        .arg(right)
                                        .arg(text.c_str())));
            }
            const double height = heightAt(*parsed.scene, x), right = table.number(row, "height");
            QVERIFY2(std::abs(height - right) < 2e-6, qPrintable(QStringLiteral("row %1: %2 for %3\n%4")
                                                                     .arg(row + 2)
                                                                     .arg(height, 0, 'g', 9)
                                                                     .arg(right)
                                                                     .arg(text.c_str())));
        }
    }
};

QTEST_APPLESS_MAIN(ImageKindsTest)
#include "image_kinds_test.moc"
