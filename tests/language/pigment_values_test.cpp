// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

/// Channel `channel` of `pigment { text }` at a point.
double valueOf(const QString& text, double x, double y = 0.5, double z = 0.5, std::size_t channel = 0) {
    const ParsedFunction parsed = parseFunction("pigment { " + text.toStdString() + " }");
    if (!parsed.ok()) qWarning("%s", problems(parsed).c_str());
    if (!parsed.ok()) return std::nan("");
    ReferenceEvaluator evaluator(parsed.value.function);
    return evaluator.evaluate(std::vector<double>{x, y, z}, parsed.parameterTable, channel);
}

bool near(double a, double b) { return std::abs(a - b) < 1e-5; }

}  // namespace

/// Values that POV-Ray 3.7 prints.
class PigmentValuesTest : public QObject {
    Q_OBJECT

  private slots:
    /// An object without a formula is asked itself, at the point and no other.
    void objectsChooseByTheirInside() {
        const QString inX =
            "object { sphere_sweep { linear_spline 2, <5, 0, 0>, 1, <7, 0, 0>, 1 } color rgb 0 color rgb 1 }";
        QVERIFY(near(valueOf(inX, 6, 0.5, -0.5), 1));
        QVERIFY(near(valueOf(inX, 6, 6, -0.5), 0));
        QVERIFY(near(valueOf(inX, 6, 0.5, 6), 0));
        QVERIFY(near(valueOf(inX, 0, 0.5, -0.5), 0));
    }

    /// The formula of one that was moved is asked where the point was before.
    void objectsWithAFormulaMayBeMoved() {
        const QString moved = "object { sphere { 0, 1 scale <2, 1, 1> translate <6, 0, 3> } rgb 0 rgb 1 }";
        QVERIFY(near(valueOf(moved, 7.5, 0.5, 3), 1));
        QVERIFY(near(valueOf(moved, 4.5, 0.5, 3), 1));
        QVERIFY(near(valueOf(moved, 8.5, 0.5, 3), 0));
        QVERIFY(near(valueOf(moved, 6, 0.5, 1.5), 0));
        QVERIFY(near(valueOf(moved, 0, 0.5, 0), 0));
    }

    /// The height that a height field of this colour has: red, and green for what is below.
    void aColorHasAHeight() {
        const ParsedFunction parsed =
            parseFunction("P(x, y, z).hf", "#declare P = function { pigment { rgb <0.25, 0.5, 0.75> } }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        ReferenceEvaluator evaluator(parsed.value.function);
        const double height = evaluator.evaluate(std::vector<double>{0, 0, 0}, parsed.parameterTable);
        QVERIFY(near(height, (0.25 + 0.5 / 255) * 0.996093));
    }

    void colors_data() {
        QTest::addColumn<QString>("pigment");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("red");
        const auto row = [](const char* pigment, double x, double red) {
            QTest::addRow("%s at %g", pigment, x) << QString(pigment) << x << red;
        };
        // The last entry is looked at first, then the first that is not below.
        for (const auto& [x, red] : {std::pair(0.1, 0.25), {0.3, 1.0}, {0.5, 1.0}, {0.75, 1.0}})
            row("gradient x color_map { [0.7 rgb 0.25] [0.2 rgb 1] }", x, red);
        for (const auto& [x, red] : {std::pair(0.2, 0.25), {0.4, 0.5}, {0.400001, 0.999995}, {0.6, 0.0}})
            row("gradient x color_map { [0.2 rgb 0.25] [0.4 rgb 0.5] [0.4 rgb 0.75] [0.4 rgb 1] [0.6 rgb 0] "
                "}",
                x, red);
        row("gradient x color_map { [0.5 rgb 0.25] }", 0.2, 0.25);
        row("gradient x scale 2 pigment_map { [0 gradient x] [1 gradient x] }", 0.5, 0.25);
        row("gradient x translate 0.1 pigment_map { [0 gradient x] [1 gradient x] } scale 2", 0.5, 0.15);
        row("gradient x turbulence 0.5 pigment_map { [0 gradient x] [1 gradient x] }", 0.5, 0.543897);
        row("checker pigment { gradient x } pigment { gradient y } scale 2", 0.5, 0.25);
        // No surface is known.
        row("slope <1, 2, 3> color_map { [0 rgb 0.25] [1 rgb 1] }", 0.5, 0.25);
        row("gradient x pigment_map { [0 slope y] [1 aoi color_map { [0 rgb 0.5] [1 rgb 1] }] }", 0.5, 0.25);
        row("checker rgb 0.25", 0.5, 0.25);
        row("checker rgb 0.25", 1.5, 0);  // and the second is green
        row("hexagon rgb 0.25", 1.5, 1);
        row("brick rgb 0.25", 0.6, 0.6);
        row("marble", 0.25, 0.9);
        row("rgb 0.5 filter 0.25", 0, 0.5);
    }

    void colors() {
        QFETCH(QString, pigment);
        QFETCH(double, x);
        QFETCH(double, red);
        const double got = valueOf(pigment, x);
        QVERIFY2(near(got, red), qPrintable(QString::number(got, 'g', 12)));
    }

    void averages() {
        const QString average = "average scale 2 pigment_map { [1 gradient x] [3 gradient y] }";
        QVERIFY(near(valueOf(average, 0.5, 0.7), 0.325));
        QVERIFY(near(valueOf("average pigment_map { [gradient x] [gradient y] }", 0.5, 0.7), 0.6));
    }

    void colorsOfListsNeedNoComma() {
        const QString list = "checker rgb 0.25 rgb 0.75";
        QVERIFY(near(valueOf(list, 0.5), 0.25));
        QVERIFY(near(valueOf(list, 1.5), 0.75));
        QVERIFY(near(valueOf("checker color red 1 color green 1", 1.5, 0.5, 0.5, 1), 1));
    }

    void squaresAreCountedAboutACorner() {
        const QString squares = "square rgb 0.1 rgb 0.2 rgb 0.3 rgb 0.4";
        QVERIFY(near(valueOf(squares, -1.4, 0, 0.17), 0.1));
        QVERIFY(near(valueOf(squares, 0.22, 0, 1.2), 0.2));
        QVERIFY(near(valueOf(squares, 1.3, 0, 1.6), 0.3));
        QVERIFY(near(valueOf(squares, 1.2, 0, 0.1), 0.4));
    }

    /// `srgb` and its siblings are decoded, into the colours of the scene.
    void storedColors_data() {
        QTest::addColumn<QString>("gamma");
        QTest::addColumn<QString>("stored");
        QTest::addColumn<QString>("color");
        const auto row = [](const char* gamma, const char* stored, const char* color) {
            QTest::addRow("%s at %s", stored, gamma) << QString(gamma) << QString(stored) << QString(color);
        };
        row("1", "srgb 0.5", "<0.214041, 0.214041, 0.214041, 0, 0>");
        row("1", "color srgb <0.2, 0.5, 0.7>", "<0.033105, 0.214041, 0.447988, 0, 0>");
        row("1", "srgbf <0.2, 0.5, 0.7, 0.3>", "<0.033105, 0.214041, 0.447988, 0.3, 0>");
        row("1", "srgbt <0.2, 0.5, 0.7, 0.3>", "<0.033105, 0.214041, 0.447988, 0, 0.3>");
        row("1", "srgbft <0.2, 0.5, 0.7, 0.3, 0.4>", "<0.033105, 0.214041, 0.447988, 0.3, 0.4>");
        row("1", "srgbt 0.5", "<0.214041, 0.214041, 0.214041, 0, 0.5>");
        row("1", "srgb <-0.2, 1.5, 0.02>", "<-0.015480, 2.537156, 0.001548, 0, 0>");
        row("1", "srgb 0.5 red 0.3", "<0.3, 0.214041, 0.214041, 0, 0>");
        row("1", "color srgbt 0.5 filter 0.1", "<0.214041, 0.214041, 0.214041, 0.1, 0.5>");
        row("1", "srgb Grey", "<0.214041, 0.214041, 0.214041, 0.3, 0.2>");
        row("2.2", "srgb 0.5", "<0.496227, 0.496227, 0.496227, 0, 0>");
        row("2.2", "srgb <0.2, 0.02, -0.1>", "<0.212433, 0.052799, 0, 0, 0>");
        row("srgb", "srgb <0.2, 0.02, -0.1>", "<0.2, 0.02, -0.1, 0, 0>");
    }

    void storedColors() {
        QFETCH(QString, gamma);
        QFETCH(QString, stored);
        QFETCH(QString, color);
        const std::string text =
            "global_settings { assumed_gamma " + gamma.toStdString() +
            " }\n#declare Grey = rgbft <0.5, 0.5, 0.5, 0.3, 0.2>;\n#declare Read = " + stored.toStdString() +
            ";\n#declare Meant = color " + color.toStdString() +
            ";\n#declare Far = abs(Read.red - Meant.red) + abs(Read.green - Meant.green)"
            " + abs(Read.blue - Meant.blue) + abs(Read.filter - Meant.filter)"
            " + abs(Read.transmit - Meant.transmit);\n"
            "#if (Far > 3e-6) #error concat(\"read as \", vstr(5, Read, \",\", 0, 6)) #end";
        const ParseResult parsed = parseScene(text);
        QVERIFY2(!hasErrors(parsed.diagnostics), problems(parsed).c_str());
        // A pigment may begin with them.
        QVERIFY(
            !hasErrors(parseScene("global_settings { assumed_gamma 1 }\nsphere { 0, 1 pigment { srgb 1 } }")
                           .diagnostics));
    }

    /// POV-Ray refuses them there; what they stand for would depend on what comes later.
    void storedColorsNeedTheGamma() {
        QVERIFY(test::has(parseScene("#declare C = srgb 0.5; global_settings { assumed_gamma 1 }"),
                          Severity::warning, "missing-gamma"));
        QVERIFY(!test::has(parseScene("global_settings { assumed_gamma 1 } #declare C = srgb 0.5;"),
                           Severity::warning, "missing-gamma"));
    }

    void refusesWhatPovrayRefuses_data() {
        QTest::addColumn<QString>("pigment");
        for (const char* text : {"gradient x color_map { [0.2 rgb }", "bozo color_map { 0.2 rgb 1 }",
                                 "nonsense", "bozo nonsense"})
            QTest::addRow("%s", text) << QString(text);
    }

    void refusesWhatPovrayRefuses() {
        QFETCH(QString, pigment);
        const ParsedFunction parsed = parseFunction("pigment { " + pigment.toStdString() + " }");
        QVERIFY(!parsed.ok());
        QVERIFY(hasErrors(parsed.diagnostics));
    }
};

QTEST_APPLESS_MAIN(PigmentValuesTest)
#include "pigment_values_test.moc"
