// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/native_includes.h"

#include <cctype>
#include <cmath>
#include <QTest>

#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

/// The float that an expression has behind an include file.
double valueOf(const std::string& include, const std::string& expression) {
    const ParseResult parsed =
        parseScene("#version 3.7;\n#include \"" + include + "\"\n#declare Result = " + expression + ";\n");
    if (!parsed.ok()) qWarning("%s: %s", expression.c_str(), problems(parsed).c_str());
    const Value* value = parsed.symbols->find("Result");
    const auto* number = value ? std::get_if<NumberValue>(&value->data) : nullptr;
    return number ? number->value : std::nan("");
}

}  // namespace

/// Colours and constants as POV-Ray 3.7 prints them; functions of math.inc by docs/povray/operators.md,
/// section 7.
class NativeIncludesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyFileIsUnderstoodAndSilent_INC_GEN() {
        QVERIFY(nativeIncludes().size() >= 4);
        for (const NativeInclude& include : nativeIncludes()) {
            const ParseResult parsed = parseScene("#include \"" + std::string(include.name) + "\"\n");
            QVERIFY2(parsed.diagnostics.empty(), problems(parsed).c_str());
            QVERIFY(parsed.scene->objects.empty());
            // Twice is no harm either.
            const std::string twice = "#include \"" + std::string(include.name) + "\"\n";
            const ParseResult again = parseScene(twice + twice);
            QVERIFY2(again.diagnostics.empty(), problems(again).c_str());
        }
    }

    /// As the suggestions for misspelt names read them.
    void everyDeclarationIsFollowedByItsName() {
        for (const NativeInclude& include : nativeIncludes())
            for (const std::string_view directive : {"#declare ", "#macro "})
                for (std::size_t at = include.text.find(directive); at != std::string_view::npos;
                     at = include.text.find(directive, at + 1)) {
                    const char first = include.text.substr(at + directive.size()).front();
                    QVERIFY2(std::isalpha(static_cast<unsigned char>(first)) || first == '_',
                             std::string(include.text.substr(at, 40)).c_str());
                }
    }

    void numbers_data() {
        QTest::addColumn<QString>("include");
        QTest::addColumn<QString>("expression");
        QTest::addColumn<double>("value");
        const auto add = [](const char* include, const char* expression, double value) {
            QTest::newRow(expression) << QString(include) << QString(expression) << value;
        };
        add("colors.inc", "Brown.red", 0.647059);
        add("colors.inc", "Brown.green", 0.164706);
        add("colors.inc", "Gray85.blue", 0.85);
        add("colors.inc", "Clear.filter", 1);
        add("colors.inc", "Very_Light_Purple.red", 0.94);
        add("colors.inc", "CHSL2RGB(<30,0.8,0.4,0.1,0.2>).red", 0.72);
        add("colors.inc", "CHSL2RGB(<200,0.3,0.9,0,0>).green", 0.91);
        add("colors.inc", "CHSL2RGB(<-40,0.6,0.7,0,0>).blue", 0.76);
        add("colors.inc", "CHSV2RGB(<200,0.3,0.9,0,0>).red", 0.63);
        add("colors.inc", "CRGB2HSL(rgb <0.9,0.1,0.3>).red", -15);
        add("colors.inc", "CRGB2HSL(rgb <0.2,0.5,0.9>).green", 0.77777777777777768);
        add("colors.inc", "CRGB2HSV(rgb <0.3,0.8,0.2>).green", 0.75);
        add("consts.inc", "Flint_Glass_Ior", 1.71);
        add("consts.inc", "e", 2.718281828459045);
        add("consts.inc", "yz.z", 1);
        add("math.inc", "sind(30)", 0.49999999999999994);
        add("math.inc", "atan2d(1, 1)", 45);
        add("math.inc", "even(4) + 10*even(3) + 100*odd(2.5) + 1000*odd(-3)", 1101);
        add("math.inc", "sgn(-3) + 10*sgn(0) + 100*sgn(2)", 99);
        add("math.inc", "clip(5, 0, 3)", 3);
        add("math.inc", "clamp(7.5, 1, 4)", 1.5);
        add("math.inc", "clamp(-1, 1, 4)", 2);
        add("math.inc", "adj_range(0.5, 10, 20)", 15);
        add("math.inc", "adj_range2(5, 0, 10, 100, 200)", 150);
        add("math.inc", "min3(3, 1, 2) + 10*max3(3, 1, 2)", 31);
        add("math.inc", "VAngleD(x, y)", 90);
        add("math.inc", "VDist(<1,2,3>, <1,2,5>)", 2);
        add("functions.inc", "f_sphere(2, 0, 0, 0.5)", 1.5);
        add("functions.inc", "f_torus(1, 0, 0, 1, 0.25)", -0.25);
    }

    void numbers() {
        QFETCH(QString, include);
        QFETCH(QString, expression);
        QFETCH(double, value);
        const double got = valueOf(include.toStdString(), expression.toStdString());
        QVERIFY2(std::abs(got - value) <= 1e-6 * std::max(1.0, std::abs(value)),
                 qPrintable(QString::number(got, 'g', 17)));
    }

    void aLaterFunctionKnowsTheMacros() {
        const ParseResult parsed = parseScene(
            "#include \"math.inc\"\n#declare F = function { x*x + y }\n#declare G = fn_Gradient(F)\n"
            "#declare A = G(2, 0, 0);\n#declare B = vGradient(F, <2, 0, 0>).x;\n#declare C = "
            "Gradient_Length(F, <2, 0, 0>);\n");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const auto number = [&](const char* name) {
            return std::get<NumberValue>(parsed.symbols->find(name)->data).value;
        };
        QVERIFY(std::abs(number("A") - std::sqrt(17)) < 1e-9);
        QVERIFY(std::abs(number("B") - 4) < 1e-9);
        QVERIFY(std::abs(number("C") - std::sqrt(17)) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(NativeIncludesTest)
#include "native_includes_test.moc"
