// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/language/functions/bare_formula.h"
#include "core/language/parse.h"
#include "core/language/tokens/token_stream.h"
#include "core/language/tokens/unknown_name.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::complaints;
using test::problems;

namespace {

/// "word -> suggestion" of every error with a fix that replaces its word.
QStringList replacements(const ParseResult& parsed) {
    QStringList all;
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        for (const QuickFix& fix : diagnostic.fixes)
            if (fix.range == diagnostic.range)
                all << QString::fromStdString(std::string(parsed.sources->slice(fix.range)) + " -> " +
                                              fix.replacement);
    return all;
}

/// The text with the first fix of the diagnostic `id` made.
std::string mended(const std::string& text, const std::string& id) {
    const ParseResult parsed = parseScene(text);
    for (const Diagnostic& diagnostic : parsed.diagnostics) {
        if (diagnostic.id != id || diagnostic.fixes.empty()) continue;
        const QuickFix& fix = diagnostic.fixes.front();
        return text.substr(0, fix.range.begin) + fix.replacement + text.substr(fix.range.end);
    }
    return "no fix";
}

}  // namespace

class MendedMessagesTest : public QObject {
    Q_OBJECT

  private slots:
    /// D30, line 24 of the review: behind a wrong word the rest of an object went unread.
    void everyMistakeOfAnObjectIsTold() {
        const ParseResult parsed = parseScene(
            "isosurface { functon { x*x + y*y + z*z - 1 } max_gradent 3 spere { 0, 1 } pigment { rgb 1 } }");
        const auto all = complaints(parsed);
        QCOMPARE(all.size(), std::size_t(3));
        QCOMPARE(replacements(parsed),
                 QStringList({"functon -> function", "max_gradent -> max_gradient", "spere -> sphere"}));
    }

    void inEveryBlockReadingGoesOn_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char* text, const QStringList& expected) {
            QTest::newRow(text) << QString(text) << expected;
        };
        row("sphere { 0, 1 pigmet { rgb 1 } translat <1, 2, 3> finsh { phong 1 } }",
            {"pigmet -> pigment", "translat -> translate", "finsh -> finish"});
        row("camera { locaton <0, 0, -3> look_at 0 anlge 2*20 }", {"locaton -> location", "anlge -> angle"});
        row("light_source { <1, 2, 3> rgb 1 shadowles fade_distanc 3 }",
            {"shadowles -> shadowless", "fade_distanc -> fade_distance"});
        row("sphere { 0, 1 finish { phongg 1 ambien 0.1 } pigment { grannite scale 2 } }",
            {"phongg -> phong", "ambien -> ambient", "grannite -> granite"});
        row("isosurface { function { x } contained_by { spere { 0, 1 } } }", {"spere -> sphere"});
        row("global_settings { asumed_gamma 1 max_trace_levl 5 }",
            {"asumed_gamma -> assumed_gamma", "max_trace_levl -> max_trace_level"});
        row("union { sphere { 0, 1 } bx { -1, 1 } pigmnt { rgb 1 } }", {"bx -> box", "pigmnt -> pigment"});
        row("SPHERE { 0, 1 }", {"SPHERE -> sphere"});
        row("#declare Radius = 1; sphere { 0, Raduis }", {"Raduis -> Radius"});
        row("#include \"colors.inc\"\nsphere { 0, 1 pigment { Read } }", {"Read -> Red"});
        row("#macro Ball(R) sphere { 0, R } #end\nBalll(1)", {"Balll -> Ball"});
        row("wibble { 0, 1 }", {});
        row("sphere { 0, 1 zzzz 3 }", {});
    }

    void inEveryBlockReadingGoesOn() {
        QFETCH(QString, text);
        QFETCH(QStringList, expected);
        const ParseResult parsed = parseScene(text.toStdString());
        QCOMPARE(replacements(parsed), expected);
        // Nothing else is complained about.
        const auto found = static_cast<qsizetype>(complaints(parsed).size());
        QVERIFY2(found == std::max<qsizetype>(expected.size(), 1), problems(parsed).c_str());
    }

    /// What follows the word is passed by, however it looks, and what follows that is read.
    void aMistakeInsideHasNoOthersBehindIt() {
        for (const char* text :
             {"#declare A = 1; #declare A[0] = 5; sphere { 0, A pigment { rgb 1 } }",
              "sphere { 0, 1 pigment { rgb 1 } finish { reflection { 0.2 glossy 3 } diffuse 1 } }"}) {
            const ParseResult parsed = parseScene(text);
            QCOMPARE(complaints(parsed).size(), std::size_t(1));
            QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
        }
    }

    /// The words that name a file may be computed: all of them are marked.
    void theWholeIncludeIsMarked() {
        const std::string text = "#include concat(\"no\", \"where.inc\")\nsphere { 0, 1 pigment { rgb 1 } }";
        const ParseResult parsed = parseScene(text);
        QCOMPARE(complaints(parsed).size(), std::size_t(1));
        const auto error = std::ranges::find(parsed.diagnostics, Severity::error, &Diagnostic::severity);
        QVERIFY(error != parsed.diagnostics.end());
        QCOMPARE(std::string(parsed.sources->slice(error->range)), text.substr(0, text.find('\n')));
    }

    /// A message is cut where it is endless, but not within a character.
    void endlessMessagesAreCutBetweenCharacters() {
        for (int before = 0; before < 3; ++before) {
            std::string said(static_cast<std::size_t>(before), 'a');
            for (int i = 0; i < 2000; ++i) said += "\u20ac";
            const ParseResult parsed = parseScene("#error \"" + said + "\"");
            QVERIFY(!parsed.diagnostics.empty());
            const std::string& message = parsed.diagnostics.front().message;
            QVERIFY(message.size() < 1000 && message.find("\u20ac") != std::string::npos);
            QCOMPARE(QString::fromStdString(message).toStdString(), message);
        }
    }

    void aNameOfAMissingIncludeIsNamedWithIt() {
        const std::string text = "#version 3.7;\nsphere { 0, 1 pigment { color Red } }\n";
        QCOMPARE(QString::fromStdString(mended(text, "unknown-name")),
                 QString("#version 3.7;\n#include \"colors.inc\"\nsphere { 0, 1 pigment { color Red } }\n"));
    }

    /// F2: the suggestion was looked for at each occurrence, and a loop took more than a minute.
    void suggestionsAreLookedForOnce() {
        ParseContext context{ParseOptions{}};
        const std::uint32_t file = context.sources.add(
            "scene",
            "#declare i = 0; #while (i < 20000) #declare i = i + 1; undeclared_name #end other_name");
        TokenStream tokens(context, file);
        for (Token token = tokens.next(); token.kind != TokenKind::end; token = tokens.next())
            reportUnknownName(context, token);
        QCOMPARE(context.suggestionsLookedFor, std::size_t(2));
        QCOMPARE(context.diagnostics.size(), std::size_t(2));
    }

    void nothingIsLookedForBehindTheLimit() {
        ParseContext context{ParseOptions{}};
        context.options.diagnosticLimit = 3;
        std::string text;
        for (int i = 0; i < 50; ++i) text += "name" + std::to_string(i) + " ";
        TokenStream tokens(context, context.sources.add("scene", text));
        for (Token token = tokens.next(); token.kind != TokenKind::end; token = tokens.next())
            reportUnknownName(context, token);
        QCOMPARE(context.suggestionsLookedFor, std::size_t(3));
        QCOMPARE(context.droppedDiagnostics, std::size_t(47));
    }

    /// D31: a formula gave an error for each of its words.
    void aFormulaIsOneMistake_data() {
        QTest::addColumn<QString>("formula");
        QTest::addColumn<QString>("function");
        const auto row = [](const char* formula, const char* function) {
            QTest::newRow(formula) << QString(formula) << QString(function);
        };
        row("x^2 + y^2 + z^2 = 1", "x*x + y*y + z*z - 1");
        row("x*x+y*y+z*z-1", "x*x + y*y + z*z - 1");
        row("sin(x)+cos(y)-z", "sin(x) + cos(y) - z");
        row("(x^2+9/4*y^2+z^2-1)^3 = x^2*z^3 + 9/80*y^2*z^3",
            "pow(x*x + 9/4*y*y + z*z - 1, 3) - (x*x*z*z*z + 9/80*y*y*z*z*z)");
        row("z = sin(x)*cos(y)", "z - sin(x)*cos(y)");
        row("|x|+|y|+|z| = 1", "abs(x) + abs(y) + abs(z) - 1");
        row("||x|-1| + y^2 = 0", "abs(abs(x) - 1) + y*y");
        row("2x + 3y", "2*x + 3*y");
        row("2xy = z", "2*x*y - z");
        row("x² + y² = 1", "x*x + y*y - 1");
        row("x⁴ + y⁴ + z⁴ = 1", "pow(x, 4) + pow(y, 4) + pow(z, 4) - 1");
        row("-x^2 + y = 0", "-x*x + y");
        row("2^3^x = y", "pow(2, pow(3, x)) - y");
        row("x^-2 = z", "pow(x, -2) - z");
        row("x - -y", "x - (-y)");
        row("1/x^2 = z", "1/(x*x) - z");
        row("x/(y*z) = 1", "x/(y*z) - 1");
        row("3(x+1)(x-1) = z", "3*(x + 1)*(x - 1) - z");
        row("e^x = z", "exp(x) - z");
        row("z = e*x", "z - 2.718281828459045*x");
        row("z = π*x", "z - pi*x");
        row("z = √(x^2+y^2)", "z - sqrt(x*x + y*y)");
        row("log10(x) + ln(y) = z", "log(x) + ln(y) - z");
        row("arctan(x) = sin y", "atan(x) - sin(y)");
        row("x^2 + y^2 <= 1", "x*x + y*y - 1");
        row("x^2 + y^2 >= 1", "1 - (x*x + y*y)");
        row("x^2 +\n  y^2 = 1", "x*x + y*y - 1");
        row("x^2\n  + y^2 = 1", "x*x + y*y - 1");
        row("x**2 + y·z − 1", "x*x + y*z - 1");
    }

    void aFormulaIsOneMistake() {
        QFETCH(QString, formula);
        QFETCH(QString, function);
        const auto known = [](std::string_view) { return false; };
        const std::string text = formula.toStdString();
        const auto read = readBareFormula(text, 0, known);
        QVERIFY(read.has_value());
        QCOMPARE(QString::fromStdString(read->function), function);
        QCOMPARE(read->end, text.size());
        QVERIFY2(parseFunction(read->function).ok(), read->function.c_str());
        for (const std::string& whole :
             {text, "sphere { 0, 1 pigment { rgb 1 } }\n" + text + "\nbox { -1, 1 pigment { rgb 1 } }\n"}) {
            const ParseResult parsed = parseScene(whole);
            QVERIFY2(complaints(parsed).size() == 1, problems(parsed).c_str());
            QVERIFY(test::has(parsed, Severity::error, "bare-formula"));
            QVERIFY(whole == text || parsed.scene->objects.size() == 2);
        }
    }

    void whatIsNoFormulaStaysWhatItWas() {
        const auto known = [](std::string_view name) { return name == "R"; };
        for (const char* text : {"x", "foo", "1 + 2", "x +", "x * wibble", "sphere { 0, 1 }",
                                 "x^2 sphere { 0, 1 }", "(x", "|x", "sin()", "x = = y", "", "x 3 {"})
            QVERIFY2(!readBareFormula(text, 0, known), text);
        const auto named = readBareFormula("x^2 + y^2 = R^2", 0, known);
        QVERIFY(named && named->names == std::vector<std::string>{"R"});
        QVERIFY(readBareFormula("foo\nx + y // sum", 4, known)->end == 9);
        std::string longest = "x";
        for (int k = 0; k < 4998; ++k) longest += " + y";
        const auto whole = readBareFormula(longest + " + 1234", 0, known);
        QVERIFY(whole && whole->function.size() == 20'000);
        QVERIFY(!readBareFormula(longest + " + 12345", 0, known));
        // Deep and long ones end.
        QVERIFY(!readBareFormula(std::string(100'000, '('), 0, known));
        QVERIFY(!readBareFormula(std::string(100'000, '-') + "x", 0, known));
    }

    /// D17: black on black without a word.
    void objectsWithoutAPigmentAreTold() {
        const std::string text =
            "camera { location -3*z look_at 0 }\nlight_source { -5*z rgb 1 }\nsphere { 0, 1 }\n";
        const ParseResult parsed = parseScene(text);
        QVERIFY(parsed.ok());
        QVERIFY(test::has(parsed, Severity::note, "no-pigment"));
        const std::string better = mended(text, "no-pigment");
        QVERIFY2(better.ends_with("sphere { 0, 1 pigment { rgb 0.8 } }\n"), better.c_str());
        QVERIFY(!test::has(parseScene(better), Severity::note, "no-pigment"));
        QCOMPARE(QString::fromStdString(mended("box {\n  -1, 1\n}\n", "no-pigment")),
                 QString("box {\n  -1, 1\n  pigment { rgb 0.8 }\n}\n"));
        for (const char* black :
             {"sphere { 0, 1 finish { phong 1 } }", "sphere { 0, 1 texture { finish { ambient 1 } } }",
              "#default { finish { diffuse 1 } } sphere { 0, 1 }"})
            QVERIFY2(test::has(parseScene(black), Severity::note, "no-pigment"), black);
        for (const char* fine :
             {"#declare P = pigment { rgb 1 } sphere { 0, 1 texture { P } }",
              "sphere { 0, 1 finish { reflection 0.8 } }", "sphere { 0, 1 pigment { rgb 0 } }",
              "sphere { 0, 1 texture { pigment { rgb 1 } } }",
              "#default { pigment { rgb 1 } } sphere { 0, 1 }", "sphere { 0, 1 no_image }",
              "union { sphere { 0, 1 } box { -1, 1 } pigment { rgb 1 } }", "#declare A = sphere { 0, 1 }"})
            QVERIFY2(!test::has(parseScene(fine), Severity::note, "no-pigment"), fine);
    }

    void missingLightsAndCamerasCanBeAdded() {
        std::string text = "sphere { <1, 2, 3>, 1 pigment { rgb 1 } }\n";
        for (const char* id : {"no-camera", "no-light"}) {
            text = mended(text, id);
            QVERIFY2(!test::has(parseScene(text), Severity::note, id), text.c_str());
        }
        const ParseResult parsed = parseScene(text);
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY(glm::distance(parsed.scene->camera.lookAt, {1, 2, 3}) < 0.02);
    }
};

QTEST_APPLESS_MAIN(MendedMessagesTest)
#include "mended_messages_test.moc"
