// SPDX-License-Identifier: GPL-3.0-or-later
// What functions look up in images and densities, beside the values of POV-Ray 3.7.
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "core/language/parse.h"
#include "core/scene/scene.h"
#include "core/shapes/isosurface/isosurface.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/problems.h"

using namespace isoscope;

class LookupGoldenTest : public QObject {
    Q_OBJECT

  private slots:
    void isWhatPovrayLooksUp() {
        const test::CsvTable table(QStringLiteral(ISOSCOPE_TEST_DATA "/texture/lookups.csv"));
        QVERIFY(table.rowCount() > 500);
        ParseOptions options;
        options.libraryPaths = {ISOSCOPE_TEST_DATA "/texture"};
        std::string text;
        ParseResult parsed;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const std::string part = table.field(row, "part");
            const std::string wanted =
                "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare P = function { " +
                table.field(row, "function") + " }\nisosurface { function { P(x, y, z)" +
                (part.empty() ? "" : "." + part) + " } }\n";
            if (wanted != text) {
                text = wanted;
                parsed = parseScene(text, options);
                QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
            }
            const Isosurface& shape = *parsed.scene->isosurfaces.front().shape;
            PointEvaluator points(shape.tape(), *parsed.scene->parameterTable);
            const double got =
                points.evaluate(table.number(row, "x"), table.number(row, "y"), table.number(row, "z"));
            QVERIFY2(std::abs(got - table.number(row, "value")) < 2e-6,
                     qPrintable(QStringLiteral("row %1: %2").arg(row + 2).arg(got, 0, 'g', 12)));
        }
    }
};

QTEST_APPLESS_MAIN(LookupGoldenTest)
#include "lookup_golden_test.moc"
