// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_parser.h"

#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

double value(const ParsedFunction& parsed, double x, double y, double z) {
    const std::vector<double> point{x, y, z};
    return ReferenceEvaluator(parsed.value.function).evaluate(point, parsed.parameterTable);
}

std::string firstMessage(const Diagnostics& diagnostics) {
    return diagnostics.empty() ? std::string() : diagnostics.front().message;
}

/// Message and marked text of the first diagnostic of a function body.
QString complaint(const std::string& body, const std::string& prelude = {}) {
    const ParsedFunction parsed = parseFunction(body, prelude);
    if (parsed.diagnostics.empty()) return QStringLiteral("none");
    const Diagnostic& first = parsed.diagnostics.front();
    return QString::fromStdString(first.message + " [" + std::string(parsed.sources->slice(first.range)) +
                                  "]");
}

const char* const header = "#version 3.7;\n#include \"functions.inc\"\n";

ParseResult scene(const std::string& statements) { return parseScene(header + statements); }

std::string isosurfaceOf(const std::string& body) { return "isosurface { function { " + body + " } }"; }

std::string textOf(const ParseResult& parsed, const SourceRange& range) {
    return std::string(parsed.sources->slice(range));
}

/// The parameters whose numbers stand in the text.
std::vector<SceneParameter> written(const ParseResult& parsed) {
    std::vector<SceneParameter> parameters = parsed.scene->parameters;
    std::erase_if(parameters, [](const SceneParameter& parameter) { return parameter.implied; });
    return parameters;
}

}  // namespace

class FunctionParserTest : public QObject {
    Q_OBJECT

  private slots:
    void messages_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("expected");
        const auto add = [](const char* body, const char* expected) {
            QTest::newRow(body) << QString(body) << QString(expected);
        };
        add("f_torus(x, y, z, 1)",
            "`f_torus` takes x, y, z and 2 parameters; 1 is missing. [f_torus(x, y, z, 1)]");
        add("f_torus(x, y, z, 1, 2, 3, 4)",
            "`f_torus` takes x, y, z and 2 parameters; 2 are too many. [f_torus(x, y, z, 1, 2, 3, 4)]");
        add("f_sphere(x, y)", "`f_sphere` takes x, y, z and 1 parameter; 2 are missing. [f_sphere(x, y)]");
        add("f_r(x)", "`f_r` takes x, y and z; 2 are missing. [f_r(x)]");
        add("sin(x, y)", "`sin` takes 1 argument; 1 is too many. [sin(x, y)]");
        add("max(x)", "`max` takes at least 2 arguments; 1 is missing. [max(x)]");
        add("select(x, y)", "`select` takes 3 or 4 arguments; 1 is missing. [select(x, y)]");
        add("sum(i, 1, 3)",
            "`sum` takes 4 arguments: a variable, its first and last value, and an expression; 1 is missing. "
            "[sum(i, 1, 3)]");
        add("x +", "Expected a number, a name, a call or `(` here, but found the end of the text. []");
        add("x * * y", "Expected a number, a name, a call or `(` here, but found `*`. [*]");
        add("x/0", "Division by the constant 0. [/]");
        add("--x", "Only one sign may stand before an operand. [-]");
        add("x y", "Expected an operator or the end of the function here, but found `y`. [y]");
        add("(x", "Expected an operator or `)` here, but found the end of the text. []");
        add("true + x", "`true` cannot stand in a function. [true]");
        add("Radius*x", "`Radius` is not declared. [Radius]");
        add("f_tours(x,y,z,1,2)", "`f_tours` is not declared: there is no function of that name. [f_tours]");
        add("f_hexagon(x,y,z)",
            "Expected `.` and a component, because `f_hexagon` gives a colour, here, but found the end of "
            "the text. []");
        add("internal(79)", "There is no built-in function number 79; they are 0 to 78. [79]");
        add("sum(1,2,3,4)",
            "Expected the name of the variable that `sum` counts with here, but found `1`. [1]");
        add("sum(i,1,1e9,x)", "`sum` would take more than a million steps at every point. [sum(i,1,1e9,x)]");
    }

    void messages() {
        QFETCH(QString, body);
        QFETCH(QString, expected);
        QCOMPARE(complaint(body.toStdString()), expected);
    }

    /// Also behind a form, which ends by itself.
    void aFunctionAloneIsTheWholeText() {
        for (const char* body : {"internal(4)", "pattern { bozo }", "x + 1"}) {
            QVERIFY2(parseFunction(body).ok(), body);
            const ParsedFunction more = parseFunction(std::string(body) + " y");
            QVERIFY2(!more.ok() && !more.value.function.valid(), body);
            QCOMPARE(more.diagnostics.size(), std::size_t(1));
            const std::string& message = more.diagnostics[0].message;
            QVERIFY2(message.find("the end of the function") != std::string::npos, message.c_str());
        }
    }

    void suggestsTheNameThatWasMeant() {
        const ParsedFunction parsed = parseFunction("f_tours(x,y,z,1,2)");
        QCOMPARE(parsed.diagnostics.front().hint, std::string("did you mean `f_torus`?"));
    }

    void namesWhatADeclaredNameIs() {
        QCOMPARE(complaint("V.x", "#declare V = <1,2,3>;"),
                 QStringLiteral("`V` is a vector; a function can use declared floats only. [V]"));
    }

    void comparesNeighbouringConstantsFirst() {
        // a < (0.2 < 0.1), not (a < 0.2) < 0.1; measured on POV-Ray 3.7.
        QCOMPARE(value(parseFunction("x<0.2<0.1"), 0.5, 0, 0), 0.0);
        // Further arguments do not combine.
        QCOMPARE(value(parseFunction("max(-9,x<0.2<0.1)"), 0.5, 0, 0), 1.0);
        QCOMPARE(value(parseFunction("max(x<0.2<0.1,-9)"), 0.5, 0, 0), 0.0);
        QCOMPARE(value(parseFunction("sum(i,1,2,x<0.2<0.1)"), 0.5, 0, 0), 2.0);
    }

    void parenthesesMakeNoConstant() {
        // Measured on POV-Ray 3.7: a parenthesis compares and divides as at run time.
        QCOMPARE(value(parseFunction("0/0>0"), 0, 0, 0), 0.0);
        QCOMPARE(value(parseFunction("(0/0)>0"), 0, 0, 0), 1.0);
        QVERIFY(std::isinf(value(parseFunction("x/(1-1)"), 1, 0, 0)));
        QVERIFY(!parseFunction("x*1/0").ok());
        QVERIFY(!parseFunction("atan2(1,(1/0))").ok());
        QVERIFY(parseFunction("pow(1,(1/0))").ok());
    }

    void dividesByMultiplyingWithTheReciprocal() {
        QCOMPARE(value(parseFunction("x/49"), 49, 0, 0), 49 * (1 / 49.0));
        QVERIFY(value(parseFunction("x/49"), 49, 0, 0) != 1.0);
    }

    void coordinatesInListsOfOtherParametersAreZero() {
        const ParsedFunction parsed = parseFunction("a + 10*x + 100*u", {}, {}, {"a", "b", "c"});
        QCOMPARE(value(parsed, 3, 4, 5), 3.0);
    }

    void xAndUAreOneParameter() {
        QCOMPARE(value(parseFunction("x - u", {}, {}, {"x", "u", "c"}), 3, 4, 5), 0.0);
        QCOMPARE(value(parseFunction("x", {}, {}, {"x", "u", "c"}), 3, 4, 5), 4.0);
        QCOMPARE(value(parseFunction("x", {}, {}, {"a", "u", "c"}), 3, 4, 5), 4.0);
    }

    void loopsSeeWhatIsAroundThem() {
        const ParsedFunction parsed = parseFunction("sum(i,1,100*x,sum(j,1,2,i*j*y + z))");
        double expected = 0;
        for (int i = 1; i <= 100; ++i)
            for (int j = 1; j <= 2; ++j) expected += i * j * 2.0 + 3;
        QCOMPARE(value(parsed, 1, 2, 3), expected);
        QCOMPARE(value(parseFunction("sum(x,1,3,x)"), 5, 0, 0), 15.0);
    }

    void transformFunctionsMoveThePoint() {
        const std::string prelude = "#declare T = function { transform { translate <1,2,3> scale 2 } };";
        QCOMPARE(value(parseFunction("T(x,y,z).x + 10*T(x,y,z).y", prelude), 1, 1, 1), 4.0 + 60.0);
    }

    void literalParametersBecomeSliders() {
        const ParseResult parsed = scene(isosurfaceOf("f_torus(x, y, z, 0.8, -0.3)"));
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const std::vector<SceneParameter> parameters = written(parsed);
        QCOMPARE(parameters.size(), std::size_t(2));
        QCOMPARE(parameters[0].name, std::string("Major Radius"));
        QCOMPARE(parameters[0].group, std::string("f_torus"));
        QCOMPARE(parameters[0].value, 0.8);
        QCOMPARE(textOf(parsed, parameters[0].range), std::string("0.8"));
        QCOMPARE(textOf(parsed, parameters[1].range), std::string("-0.3"));
        QCOMPARE(parameters[1].value, -0.3);
        QVERIFY(parameters[1].minimum <= -0.3);
        for (const SceneParameter& parameter : parameters) {
            QVERIFY(parameter.role == ParameterRole::argument && !parameter.expression);
            QVERIFY(parameter.slot >= 0);
            QCOMPARE((*parsed.scene->parameterTable)[std::size_t(parameter.slot)], parameter.value);
        }
    }

    void movingASliderIsTheSameAsWritingItsNumber() {
        const auto built = [](const std::string& radius) {
            return scene(isosurfaceOf("f_torus(x, y, z, " + radius + ", 0.3) + x/3"));
        };
        const ParseResult first = built("0.8"), second = built("1.25");
        QVERIFY(first.ok() && second.ok());
        std::vector<double> table = *first.scene->parameterTable;
        table[std::size_t(first.scene->parameters[0].slot)] = 1.25;
        const auto at = [](const ParseResult& parsed, std::span<const double> parameters) {
            const std::vector<double> point{0.3, -0.7, 1.1};
            return ReferenceEvaluator(parsed.scene->isosurfaces.at(0).shape->settings().function)
                .evaluate(point, parameters);
        };
        QCOMPARE(at(first, table), at(second, *second.scene->parameterTable));
        QVERIFY(at(first, *first.scene->parameterTable) != at(second, *second.scene->parameterTable));
    }

    void countsHaveNoSlot() {
        const ParseResult parsed = scene(isosurfaceOf("y - f_ridged_mf(x, 0, z, 0.5, 2.2, 7, 0.7, 0.7, 2)"));
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QCOMPARE(written(parsed).size(), std::size_t(6));
        const SceneParameter& octaves = parsed.scene->parameters[2];
        QCOMPARE(octaves.name, std::string("Octaves"));
        QCOMPARE(octaves.slot, -1);
        QVERIFY(octaves.integral);
        QVERIFY(parsed.scene->parameters[0].slot >= 0);
    }

    void expressionsAreOfferedAsText() {
        const ParseResult parsed = scene("#declare R = 2;\n" + isosurfaceOf("f_torus(x, y, z, R*0.5, 1/3)"));
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        std::vector<std::string> texts;
        for (const SceneParameter& parameter : parsed.scene->parameters)
            if (parameter.expression) texts.push_back(parameter.text);
        QCOMPARE(texts, (std::vector<std::string>{"R*0.5", "1/3"}));
    }

    void aLiteralInALoopIsOneSlider() {
        const ParseResult parsed = scene(
            "isosurface { function { min(1 #declare I = 0; #while (I < 5) , f_sphere(x - I, y, z, 0.4) "
            "#declare I = I + 1; #end ) } }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        std::size_t arguments = 0;
        for (const SceneParameter& parameter : parsed.scene->parameters)
            arguments += parameter.role == ParameterRole::argument;
        QCOMPARE(arguments, std::size_t(1));
    }

    void declaredNumbersMove() {
        const ParseResult parsed = scene("#declare R = 1.5;\n" + isosurfaceOf("x*x + y*y + z*z - R*R"));
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QCOMPARE(written(parsed).size(), std::size_t(1));
        const SceneParameter& radius = parsed.scene->parameters[0];
        QVERIFY(radius.role == ParameterRole::declared);
        QVERIFY(radius.slot >= 0);
        const std::vector<double> point{2, 0, 0};
        ReferenceEvaluator evaluator(parsed.scene->isosurfaces.at(0).shape->settings().function);
        QCOMPARE(evaluator.evaluate(point, *parsed.scene->parameterTable), 4 - 2.25);
        QCOMPARE(evaluator.evaluate(point, std::vector<double>{2.0}), 0.0);
    }

    void warnsOfAMissingInclude() {
        const ParseResult parsed = parseScene(isosurfaceOf("f_sphere(x, y, z, 1)"));
        QVERIFY(parsed.ok());
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
        QVERIFY(firstMessage(parsed.diagnostics).find("functions.inc") != std::string::npos);
        QVERIFY(parsed.diagnostics.front().severity == Severity::warning);
    }

    void aFunctionCannotCallItself() {
        const ParseResult parsed = scene("#declare F = function { F(x,y,z) + 1 }");
        QVERIFY(!parsed.ok());
        QVERIFY(firstMessage(parsed.diagnostics).find("`F` is not declared") == 0);
    }

    void parameterNamesAreNew() {
        QVERIFY(!scene("#declare K = 1; #declare F = function(K) { K }").ok());
        QVERIFY(!scene("#declare F = function(r, s, t) { r }").ok());
        QVERIFY(!scene("#declare F = function(red) { 1 }").ok());
        QVERIFY(scene("#declare F = function(r, s, w) { r }").ok());
    }

    void deepParenthesesEndInAMessage() {
        const ParsedFunction parsed = parseFunction(std::string(200'000, '('));
        QVERIFY(!parsed.ok());
        QVERIFY(hasErrors(parsed.diagnostics));
    }

    void callsThatMultiplyEndInAMessage() {
        std::string text = "#declare F0 = function { sin(x) + y*z }\n";
        for (int k = 1; k < 40; ++k) {
            const std::string before = "F" + std::to_string(k - 1);
            text += "#declare F" + std::to_string(k) + " = function { " + before + "(x*1.1,y,z) + " + before +
                    "(x,y*1.2,z+" + std::to_string(k) + ") }\n";
        }
        const ParseResult parsed = scene(text);
        QVERIFY(!parsed.ok());
        qInfo("%.1f s", parsed.seconds);
    }

    /// The functions of a text have a limit together; what is beyond it is told, and not what POV-Ray would
    /// say of its form.
    void manyLargeFunctionsEndInAMessageEach() {
        std::string body = "x";
        for (int k = 0; k < 5'000; ++k) body += "+" + std::to_string(k) + ".5*y";
        const ParseResult parsed = scene("#declare F = function { " + body +
                                         " }\n#for (I, 1, 140) #declare G = function { F(x, y, z) } #end\n" +
                                         isosurfaceOf("pattern { bozo }"));
        qInfo("%.1f s", parsed.seconds);
        std::vector<std::string> told;
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.severity != Severity::note) told.push_back(diagnostic.message);
        const std::string message = "The functions of this text hold more than 2000000 operations.";
        QCOMPARE(told,
                 (std::vector<std::string>{message, message,
                                           "The isosurface is not drawn: its function was not understood."}));
    }

    void manyCallsOfALargeFunctionEndInAMessage() {
        std::string body = "x", text;
        for (int k = 0; k < 20'000; ++k) body += "+sin(x*" + std::to_string(k) + ".5)";
        text = "#declare F = function { " + body + " }\n#declare G = function { 0";
        for (int k = 0; k < 5'000; ++k) text += "+F(x,y,z)";
        const ParseResult parsed = scene(text + " }");
        QVERIFY(!parsed.ok());
        qInfo("%.1f s", parsed.seconds);
    }
};

QTEST_APPLESS_MAIN(FunctionParserTest)
#include "function_parser_test.moc"
