// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/expression_parser.h"

#include <QTest>
#include <cmath>

#include "tests/language/stream_run.h"

using namespace isoscope;
using namespace isoscope::test;

class ExpressionParserTest : public QObject {
    Q_OBJECT

    static void columns() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("value");
    }

    static void row(const char* expression, const char* value) {
        QTest::newRow(expression) << QString(expression) << QString(value);
    }

    static QString valueOf(const QString& expression) {
        const std::string prelude =
            "#declare N = 3; #declare V = <1, 2, 3>; #declare C = rgb <0.1, 0.2, 0.3>; #declare S = \"text\";"
            "#declare B = array[2][3] { {1, 2, 3}, {4, <5, 6, 7>, \"s\"} }";
        return QString::fromStdString(
            valueAfter(prelude + "\n#declare A = " + expression.toStdString() + ";"));
    }

  private slots:
    /// All values are what POV-Ray 3.7 gives, where it accepts the expression.
    void evaluatesFloats_data() {
        columns();
        row("1+2*3", "7");
        row("2-3-4", "-5");
        row("8/2/2", "2");
        row("-2*-3", "6");
        row("2--3", "5");
        row("--3", "3");
        row("+3", "3");
        row("!3", "0");
        row("!0", "1");
        row("!3 + 1", "1");
        row("-!0", "-1");
        row("5*!0", "5");
        row("!1e-11", "1");
        row("(1+2)*3", "9");
        row("N*N", "9");
        row("(3 > 2)", "1");
        row("(1 < 2 < 1)", "0");
        row("(1 | 0 & 0)", "0");
        row("(0 & 0 = 0)", "0");
        row("(1e-11 & 1)", "0");
        row("(1 = 1+1e-11)", "1");
        row("(1 != 1+1e-11)", "0");
        row("(1 < 1+1e-11)", "1");
        row("(1 <= 1-1e-11)", "1");
        row("(1 > 1-1e-11)", "1");
        row("(1 >= 1+1e-11)", "1");
        row("(0 ? 5 : 6)", "6");
        row("(0 ? 5 : 1 ? 7 : 8)", "7");
        row("(2 > 1 ? N : 0)", "3");
        row("V.x + V.y*10 + V.z*100", "321");
        row("V.u + V.v", "3");
        row("(V + 1).y", "3");
        row("<1, 2, 3>.red", "1");
        row("C.gray", "0.1817");
        row("N.x + N.red + N.u", "9");
        row("(N + 1).gray", "1.188");
        row("<1, 0>.gray", "0.297");
        row("<1, 0, 0>.gray", "0.297");
        row("C.green + C.filter + C.transmit", "0.2");
        row("B[0][2]", "3");
        row("B[0.5][1.9]", "2");
        row("B[1][1].y", "6");
        row("pi", "3.141592653589793");
        row("tau", "6.283185307179586");
        row("true + yes + on + false + no + off", "3");
        row("version", "3.7");
        row("clock + frame_number + clock_on", "0");
        row("image_width", "800");
        row("1e", "1");
        row(".5+5.+1E2+1e+1", "115.5");
    }
    void evaluatesFloats() { check(); }

    void evaluatesFloatFunctions_data() {
        columns();
        row("abs(-2)", "2");
        row("abs(3>2)", "1");
        row("int(-2.7)", "-2");
        row("int(3e9)", "-2147483648");
        row("div(-7, 2)", "-3");
        row("div(5, 0)", "-2147483648");
        row("mod(-7, 2)", "-1");
        row("mod(7.5, -2)", "1.5");
        row("floor(-0.5)", "-1");
        row("ceil(0.2)", "1");
        row("min(3, 1, 2)", "1");
        row("max(3)", "3");
        row("max(1, 2, 7, 3)", "7");
        row("select(-1, 1, 2)", "1");
        row("select(0, 1, 2)", "2");
        row("select(0, 1, 2, 3)", "2");
        row("select(1e-11, 1, 2, 3)", "3");
        row("pow(2, 10)", "1024");
        row("pow(0, 1)", "0");
        row("pow(0, 0.5)", "0");
        row("pow(0, -1)", "inf");
        row("1/pow(0, -2.5)", "0");
        row("sqrt(9)", "3");
        row("sqrt(0)", "0");
        row("exp(0)", "1");
        row("ln(1)", "0");
        row("log(100)", "2");
        row("degrees(pi)", "180");
        row("radians(180)", "3.141592653589793");
        row("atan2(1, 1)", "0.7853981633974483");
        row("sin(0) + cos(0) + tan(0)", "1");
        row("sinh(0) + cosh(0) + tanh(0)", "1");
        row("asin(1) - acos(0)", "0");
        row("asinh(0) + acosh(1) + atanh(0) + atan(0)", "0");
        row("bitwise_and(6, 3)", "2");
        row("bitwise_or(6, 3)", "7");
        row("bitwise_xor(6, 3)", "5");
        row("vdot(x, x + y)", "1");
        row("vdot(1, 2)", "6");
        row("vlength(<3, 4, 0>)", "5");
        row("strlen(\"abc\")", "3");
        row("asc(\"A\")", "65");
        row("asc(\"\")", "0");
        row("val(\"3.5x\")", "3.5");
        row("val(\" 12 \")", "12");
        row("val(\"abc\")", "0");
        row("strcmp(\"b\", \"a\")", "1");
        row("strcmp(\"abc\", \"a\")", "98");
        row("strcmp(\"a\", \"abcd\")", "-98");
        row("dimensions(B)", "2");
        row("dimension_size(B, 2)", "3");
        row("defined(N) + defined(Nothing)", "1");
        row("defined(B[0][1])", "1");
        row("rand(seed(3))", "0.26597287698322275");
        row("seed(1) + seed(1)", "1");
    }
    void evaluatesFloatFunctions() { check(); }

    void evaluatesVectors_data() {
        columns();
        row("<1, 2, 3>", "<1, 2, 3>");
        row("<1 2 3>", "<1, 2, 3>");
        row("<1, -2>", "<1, -2>");
        row("<1, 2, 3,>", "<1, 2, 3>");
        row("<1, 2, (3 > 2)>", "<1, 2, 1>");
        row("-V", "<-1, -2, -3>");
        row("!<1, 0, 3>", "<0, 1, 0>");
        row("x + 1", "<2, 1, 1>");
        row("<1, 2> + <1, 2, 3>", "<2, 4, 3>");
        row("<1, 2, 3> * <2, 2>", "<2, 4, 0>");
        row("u + v", "<1, 1>");
        row("x + 2*y + 3*z", "<1, 2, 3>");
        row("(<1, 2, 3> < <2, 1, 4>)", "<1, 0, 1>");
        row("(V & <0, 1, 4>)", "<0, 1, 1>");
        row("(V = V)", "<1, 1, 1>");
        row("vcross(x, y)", "<0, 0, 1>");
        row("vnormalize(<3, 4, 0>)", "<0.6, 0.8, 0>");
        row("(vnormalize(<acosh(0.5), 1, 0>).y < 1 ? 1 : 2)", "2");
        row("vrotate(x, <0, 0, 0>)", "<1, 0, 0>");
    }
    void evaluatesVectors() { check(); }

    void turnsVectorsAsPovRayDoes() {
        const auto near = [](const char* expression, std::array<double, 3> wanted) {
            const StreamRun done = run(std::string("#declare A = ") + expression + ";");
            const auto& got = std::get<VectorValue>(done.context->symbols.find("A")->data).components;
            for (std::size_t i = 0; i < 3; ++i) QVERIFY2(std::abs(got[i] - wanted[i]) < 1e-9, expression);
        };
        near("vrotate(x, <0, 0, 90>)", {0, 1, 0});
        near("vrotate(<1, 2, 3>, <10, 20, 30>)", {1.067425379, 2.289059483, 2.760581414});
        near("vaxis_rotate(x, y, 90)", {0, 0, -1});
        near("vturbulence(2.5, 0.3, 3, <-2.449, -0.046, -0.505>)",
             {0.379763245219, -0.380139686125, -0.114957717044});
        // Octaves beyond 1 to 10 count as these.
        near("vturbulence(2, 0.5, 12, <2.623, -4.979, -0.546>)",
             {-0.342169012552, 0.176880804702, -0.061147390403});
        near("vturbulence(2, 0.5, -1, <0.414, 4.391, -1.188>)",
             {-0.083715826725, 0.265312009429, -0.122615685653});
        near("vaxis_rotate(<1, 2, 3>, <1, 1, 1>, 40)", {1.605069156, 1.257772801, 3.137158043});
    }

    void evaluatesColors_data() {
        columns();
        row("rgb 0.5 + 0.5", "color <1, 1, 1, 0, 0>");
        row("rgb <1, 0, 0> filter 0.5", "color <1, 0, 0, 0.5, 0>");
        row("rgb <1, 2>", "color <1, 2, 0, 0, 0>");
        row("rgb x", "color <1, 0, 0, 0, 0>");
        row("rgb (1 < 2)", "color <1, 1, 1, 0, 0>");
        row("rgbf 0.5", "color <0.5, 0.5, 0.5, 0.5, 0>");
        row("rgbt <1, 2, 3, 4>", "color <1, 2, 3, 0, 4>");
        row("color",
            "color <0, 0, 0, 0, 0> | 2:14: warning: There is no value behind `color`, which makes it black.");
        row("rgbt <1, 2, 3, 4, 5>",
            "color <1, 2, 3, 0, 4> | 2:14: warning: `rgbt` expects 4 components, but all 5 of this color are "
            "taken.");
        row("rgbft <1, 2, 3, 4, 5>", "color <1, 2, 3, 4, 5>");
        row("color red 1 green 0.5", "color <1, 0.5, 0, 0, 0>");
        row("red 1 green 2", "color <1, 2, 0, 0, 0>");
        row("color <1, 2, 3, 4, 5>", "color <1, 2, 3, 4, 5>");
        row("color 0.5", "color <0.5, 0.5, 0.5, 0.5, 0.5>");
        row("colour C filter 0.2 red 0", "color <0, 0.2, 0.3, 0.2, 0>");
        row("color C*0.5 filter 0.2+0.5", "color <0.05, 0.1, 0.15, 0.7, 0>");
        row("C*10+1", "color <2, 3, 4, 1, 1>");
        row("rgb 1 + 0.5*x", "color <1.5, 1, 1, 0, 0>");
    }
    void evaluatesColors() { check(); }

    void evaluatesStrings_data() {
        columns();
        row("\"a b\"", "\"a b\"");
        row("concat(\"a\", \"b\" \"c\", S)", "\"abctext\"");
        row("str(3.14159, 8, 2)", "\"    3.14\"");
        row("str(3.14159, -8, 2)", "\"00003.14\"");
        row("str(-1.5, -8, 2)", "\"-0001.50\"");
        row("str(2.5, 0, 0)", "\"2\"");
        row("str(3, 0, -1)", "\"3.000000\"");
        row("str(1/3, 0, 3)", "\"0.333\"");
        row("vstr(2, <1, 2, 3>, \" ; \", 6, 2)", "\"  1.00 ;   2.00\"");
        row("vstr(7, <1, 2, 3, 4, 5>, \",\", 0, 1)", "\"1.0,2.0,3.0,4.0,5.0\"");
        row("vstr(-1, V, \",\", 0, 0)", "\"1,2\"");
        row("substr(\"abcdef\", 2, 3)", "\"bcd\"");
        row("substr(\"abc\", 3, 1)", "\"c\"");
        row("strupr(\"aBc1\")", "\"ABC1\"");
        row("strlwr(\"AbC1\")", "\"abc1\"");
        row("chr(65)", "\"A\"");
        row("chr(127)", "\"\x7f\"");
        row("chr(128)", "\"\xc2\x80\"");
        row("chr(233)", "\"é\"");
        row("chr(2047)", "\"\xdf\xbf\"");
        row("chr(2048)", "\"\xe0\xa0\x80\"");
        row("chr(8364)", "\"€\"");
        row("chr(65535)", "\"\xef\xbf\xbf\"");
        row("datetime(0)", "\"2000-01-01 00:00:00Z\"");
        row("datetime(0.5, \"%H\")", "\"12\"");
        row("B[1][2]", "\"s\"");
    }
    void evaluatesStrings() { check(); }

    void callsDeclaredFunctions() {
        FunctionGraph graph;
        const NodeId sum = graph.binary(Operation::add, graph.variable(0), graph.variable(1));
        const Function function = finish(std::move(graph), {sum}, 2);
        ParseContext context{ParseOptions{}};
        context.symbols.declare("F", {FunctionValue{function, {"a", "b"}, ""}});
        TokenStream tokens(context, context.sources.add("scene.pov", "F(1, 2)*10 F(1)"));
        QCOMPARE(ExpressionParser(tokens).parseFloat(), 30.0);
        QVERIFY(context.diagnostics.empty());
        ExpressionParser(tokens).parseFloat();
        QCOMPARE(QString::fromStdString(context.diagnostics.at(0).message),
                 QString("`F` takes 2 arguments; 1 is missing."));
    }

    void carriesVectorsByDeclaredTransforms() {
        ParseContext context{ParseOptions{}};
        context.symbols.declare("T", {Transform::scaling({2, 2, 2}).then(Transform::translation({1, 0, 0}))});
        TokenStream tokens(context,
                           context.sources.add("scene.pov",
                                               "vtransform(<1, 2, 3>, T) vinv_transform(<3, 4, 6>, T) "
                                               "vtransform(x, Nothing)"));
        ExpressionParser expressions(tokens);
        QVERIFY(expressions.parseVector() == glm::dvec3(3, 4, 6));
        QVERIFY(expressions.parseVector() == glm::dvec3(1, 2, 3));
        QVERIFY(context.diagnostics.empty());
        expressions.parseVector();
        QCOMPARE(QString::fromStdString(context.diagnostics.at(0).message),
                 QString("`vtransform` asks for a declared transform, but this is not declared."));
    }

    /// Message and place; the place is that of the expression, which begins at column 1.
    void explainsMistakes_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("message");
        row("Q", "1:1: error: `Q` is not declared.");
        row("1 + Q", "1:5: error: `Q` is not declared.");
        row("sphere", "1:1: error: `sphere` cannot stand here; expected a value.");
        row("1 +", "1:4: error: Expected a number, a vector or a name, but the text or statement ends here.");
        row("1 + }", "1:5: error: Expected a number, a vector or a name, but found `}`.");
        row("(1", "1:3: error: Expected `)` to close the parenthesis, but the text ends here.");
        row("\"a\" + 1", "1:7: error: Expected a float or a vector, but this is a string.");
        row("<1>", "1:1: error: A vector has 2 to 5 components, not 1.");
        row("<1, 2, 3, 4, 5, 6>", "1:1: error: A vector has 2 to 5 components, not 6.");
        row("<1, x, 3>", "1:5: error: Expected a float, but this is a vector.");
        row("<1, 2", "1:6: error: Expected `>` to close the vector, but the text ends here.");
        row("<1, 2, 3>.t", "1:11: error: `.t` asks for a component that a vector of 3 does not have.");
        row("<1, 2, 3>.q",
            "1:11: error: Expected a component such as `x`, `red` or `gray` behind `.`, but found `q`.");
        row("<1, 2, 3>.wordsOfMoreThanFortyCharactersAreCutOffThere",
            "1:11: error: Expected a component such as `x`, `red` or `gray` behind `.`, but found "
            "`wordsOfMoreThanFortyCharactersAreCutOffT`.");
        row("<Q, 2, R>", "1:2: error: `Q` is not declared.");
        row("sin(x)", "1:5: error: Argument 1 of `sin` must be a float, but this is a vector.");
        row("sin 1", "1:5: error: Expected `(` and the arguments of `sin`, but found `1`.");
        row("atan2(1)", "1:1: error: `atan2` takes 2 arguments; 1 is missing.");
        row("sin(1, 2)", "1:8: error: `sin` takes 1 argument; expected `)` here.");
        row("select(1)", "1:1: error: `select` takes 3 or 4 arguments; 2 are missing.");
        row("max()", "1:1: error: `max` takes at least 1 argument; 1 is missing.");
        row("max(3 > 2, 1)", "1:7: error: `>` needs parentheses around the whole comparison here.");
        row("concat(\"a\", 3)", "1:13: error: Argument 2 of `concat` must be a string, but this is a float.");
        row("vlength(<1, 2, 3, 4>)",
            "1:9: error: Argument 1 of `vlength` must be a vector, but this is a vector.");
        row("1/0", "1:2: warning: This divides by zero; the result is infinite or no number.");
        row("sqrt(-1)", "1:1: error: The square root of a negative number does not exist.");
        row("ln(0)", "1:1: error: `ln` needs a positive number.");
        row("acos(2)", "1:1: warning: `acos` is defined from -1 to 1 only; the nearer end is taken.");
        row("pow(0, 0)", "1:1: error: 0 to the power of 0 does not exist.");
        row("atan2(0, 0)", "1:1: warning: POV-Ray takes no `atan2(0, 0)`; here it is 0.");
        row("rand(3)", "1:1: error: `rand` needs a stream that `seed` has begun.");
        row("vnormalize(0)", "1:1: warning: A vector of length 0 has no direction; it stays <0, 0, 0>.");
        row("substr(\"abc\", 3, 5)",
            "1:1: error: `substr` asks for characters outside the string, which has 3.");
        row("chr(-1)", "1:1: error: `chr` needs the number of a character, 0 to 65535.");
        row("dimensions(Q)", "1:12: error: `dimensions` asks for an array, but this is not declared.");
        row("rgb <1, 2, 3, 4>",
            "1:1: warning: `rgb` expects 3 components, but all 4 of this color are taken.");
        row("rgb <1, 2, 3, 4, 5>",
            "1:1: warning: `rgb` expects 3 components, but all 5 of this color are taken.");
    }

    void explainsMistakes() {
        QFETCH(QString, expression);
        QFETCH(QString, message);
        StreamRun done;
        done.context = std::make_unique<ParseContext>(ParseOptions{});
        TokenStream tokens(*done.context, done.context->sources.add("scene.pov", expression.toStdString()));
        ExpressionParser(tokens).parseValue();
        QCOMPARE(QString::fromStdString(done.said()), message);
    }

    void hintsAtCloseNames_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("hint");
        row("Raduis", "did you mean `Radius`?");
        row("sine(1)", "did you mean `sin`?");
        row("f_torus(1, 2, 3, 4, 5)", "add #include \"functions.inc\"");
    }

    void hintsAtCloseNames() {
        QFETCH(QString, expression);
        QFETCH(QString, hint);
        const StreamRun done = run("#declare Radius = 1; #declare A = " + expression.toStdString() + ";");
        QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(done.context->diagnostics[0].hint), hint);
    }

    void knowsWhereAnExpressionBegins_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<bool>("begins");
        for (const char* text :
             {"1", "\"s\"", "(", "<", "+", "-", "!", "x", "rgb", "red", "sin", "clock", "N", "F"})
            QTest::newRow(text) << QString(text) << true;
        for (const char* text : {"", "}", ",", "sphere", "T", "Unknown", ">"})
            QTest::newRow(*text ? text : "end") << QString(text) << false;
    }

    void knowsWhereAnExpressionBegins() {
        QFETCH(QString, expression);
        QFETCH(bool, begins);
        ParseContext context{ParseOptions{}};
        context.symbols.declare("N", {NumberValue{1}});
        context.symbols.declare("F", {FunctionValue{}});
        context.symbols.declare("T", {OpaqueValue{"texture"}});
        TokenStream tokens(context, context.sources.add("scene.pov", expression.toStdString()));
        QCOMPARE(ExpressionParser(tokens).atExpression(), begins);
    }

    void readsTypedValues() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "2 <1, 2> 3 1 rgbt 0.5 \"s\""));
        ExpressionParser expressions(tokens);
        QCOMPARE(expressions.parseFloat(), 2.0);
        QVERIFY(expressions.parseVector() == glm::dvec3(1, 2, 0));
        QVERIFY(expressions.parseVector() == glm::dvec3(3, 3, 3));
        QVERIFY(expressions.parseBool());
        QVERIFY((expressions.parseColor() == Color{0.5, 0.5, 0.5, 0, 0.5}));
        QCOMPARE(expressions.parseString(), std::string("s"));
        QVERIFY(context.diagnostics.empty());
    }

    void readsOptionsOfTheRun() {
        ParseOptions options;
        options.clock = 0.25;
        options.clockOn = true;
        options.frameNumber = 3;
        options.initialFrame = 1;
        options.finalFrame = 5;
        const StreamRun done =
            run("#declare A = clock + 10*frame_number + 100*clock_on + 1000*clock_delta;", options);
        QCOMPARE(printed(*done.context->symbols.find("A")), std::string("380.25"));
        options.file = "/scenes/torus.pov";
        const StreamRun named = run("#declare A = strlen(concat(\"<\", input_file_name, \">\"));", options);
        QCOMPARE(printed(*named.context->symbols.find("A")), std::string("11"));
    }

  private:
    void check() {
        QFETCH(QString, expression);
        QFETCH(QString, value);
        QCOMPARE(valueOf(expression), value);
    }
};

QTEST_APPLESS_MAIN(ExpressionParserTest)
#include "expression_parser_test.moc"
