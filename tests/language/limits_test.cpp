// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QFile>
#include <QTest>
#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <random>
#include <thread>

#include "core/language/parse.h"
#include "core/text/number_format.h"
#include "test_folders.h"
#include "tests/language/stream_run.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

ParseOptions withBudget(std::size_t steps) {
    ParseOptions options;
    options.stepBudget = steps;
    return options;
}

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t k = 0; k < count; ++k) all += text;
    return all;
}

}  // namespace

/// Texts that ask for more than the machine has: each ends soon, with one message at the right place.
class LimitsTest : public QObject {
    Q_OBJECT

    static constexpr std::size_t budget = 200'000;

  private slots:
    /// A token that was looked at before the text was cut off stayed in front for ever, and what reads
    /// pigments did not take it: an endless loop, which no limit of time ended. Found by changes of a scene's
    /// tokens.
    void aTokenInFrontOfACutIsGone() {
        QFile file(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tests/fuzz/corpus/scene/nested_macro_arguments.pov"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const ParseResult result = parseScene(file.readAll().toStdString(), {});
        const auto isDeep = [](const Diagnostic& diagnostic) {
            return diagnostic.message.starts_with("Reading stops here: ");
        };
        QCOMPARE(std::ranges::count_if(result.diagnostics, isDeep), 1);
    }

    void cutsOffLoops_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* text, const char* place) {
            QTest::newRow(text) << QString(text) << QString(place);
        };
        row("a\n #while (1) #end b", "2:2");
        row("#while (1) a #end b", "1:1");
        row("#for (I, 1, 2) #while (1) #end #end", "1:16");
        row("#while (1) #for (I, 1, 3) #end #end", "1:1");
        row("#for (I, 1, 1e300) #end", "1:1");
        row("#for (I, 0, 1) #declare I = 0; #end", "1:1");
        row("#macro M() #while (1) #end #end M()", "1:12");
        row("#declare S = \"a\"; #while (1) #declare S = concat(S, S); #end", "1:19");
        row("#while (1) #local A = array[100]; #end", "1:1");
    }

    void cutsOffLoops() {
        QFETCH(QString, text);
        QFETCH(QString, place);
        const StreamRun done = run(text.toStdString(), withBudget(budget));
        QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(done.context->diagnostics[0].id), QString("loop-cut-off"));
        QVERIFY2(done.said().starts_with(place.toStdString() + ": error: This loop was cut off after "),
                 done.said().c_str());
    }

    /// The field had columns and rows by then, but no heights, and its limits were asked for.
    void aHeightFieldThatIsCutOffIsNoShape() {
        ParseOptions options = withBudget(budget);
        const ParseResult parsed =
            parseScene("height_field { function 500, 500 { pattern { wrinkles } } }", options);
        QVERIFY(!parsed.ok());
        QVERIFY(parsed.scene->objects.empty());
        QCOMPARE(parsed.diagnostics[0].id, std::string("too-long"));
    }

    /// 20 million of them, with the budget that texts have, took ten seconds.
    void roundsOfNothingAreFew() {
        const auto rounds = [](const char* text) {
            const StreamRun done = run(text);
            return QString::fromStdString(done.context->diagnostics.at(0).message).section(' ', 6, 6).toInt();
        };
        QVERIFY(rounds("#while (1) #end") > 1'000'000);
        QVERIFY(rounds("#while (1) #end") < 10'000'000);
        QVERIFY(rounds("#while (1) #declare A = 1; #end") < 10'000'000);
    }

    void saysHowManyRoundsThereWere() {
        QCOMPARE(QString::fromStdString(run("#while (1) #end", withBudget(10'000)).said()),
                 QString("1:1: error: This loop was cut off after 223 rounds, because the text asks for more "
                         "than 10000 steps."));
    }

    void refusesStringsThatWouldFillTheMemory() {
        const StreamRun done = run("#declare S = \"a\"; #for (I, 1, 30) #declare S = concat(S, S); #end",
                                   withBudget(40'000'000));
        QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
        QVERIFY2(done.said().ends_with("error: This string is longer than 10000000 characters."),
                 done.said().c_str());
    }

    void cutsOffRecursion_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("id");
        const auto row = [](const char* text, const char* id) {
            QTest::newRow(text) << QString(text) << QString(id);
        };
        row("#macro M() M() #end M()", "too-deep");
        row("#macro M(n) M(n + 1) #end M(1)", "too-deep");
        row("#macro M(n) #declare A = M(n + 1); #end M(1)", "too-deep");
        row("#macro A() B() #end #macro B() A() #end A()", "too-deep");
        row("#macro M() M() M() #end M()", "too-deep");
        row("#macro M(P) M(M(P)) #end M(1)", "too-deep");
    }

    void cutsOffRecursion() {
        QFETCH(QString, text);
        QFETCH(QString, id);
        const StreamRun done = run(text.toStdString(), withBudget(budget));
        QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(done.context->diagnostics[0].id), id);
    }

    void aMacroMayCallItself200Deep() {
        const StreamRun done = run("#macro M(n) #if (n > 1) M(n - 1) #else bottom #end #end M(200)");
        QCOMPARE(QString::fromStdString(done.tokens), QString("bottom"));
        QVERIFY2(done.said().empty(), done.said().c_str());
    }

    void cutsOffNesting_data() {
        QTest::addColumn<QString>("piece");
        for (const char* piece :
             {"(", "<", "-", "!", "sin(", "rgb ", "color rgb ", "(1 ? ", "concat(", "F(", "B[", "array[1] {",
              "M(", "#if (", "#declare A = ", "#while (", "#debug ", "{", "#if (1) "})
            QTest::newRow(piece) << QString(piece);
    }

    void cutsOffNesting() {
        QFETCH(QString, piece);
        const std::string text = "#macro M(P) #end #declare B = array[2] { 0, 0 } #declare A = " +
                                 repeated(piece.toStdString(), 100'000);
        QElapsedTimer timer;
        timer.start();
        const StreamRun done = run(text);
        QVERIFY(hasErrors(done.context->diagnostics));
        qInfo("%lld ms", timer.elapsed());
    }

    void anIndexInsideAnIndexDoesNotUseUpTheStack() {
        const StreamRun done = run("#declare B = array[1] { 0 } #declare A = " + repeated("B[", 100'000));
        QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(done.context->diagnostics[0].id), QString("too-deep"));
    }

    void chargesArraysToTheBudget() {
        for (const char* text : {"#declare A = array[1000000000];", "#declare A = array[30000][30000];",
                                 "#declare A = array[1000000][1000000][1000000];"}) {
            const StreamRun done = run(text);
            QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
            QCOMPARE(QString::fromStdString(done.context->diagnostics[0].id), QString("too-long"));
            QVERIFY(!done.context->symbols.find("A"));
        }
        QCOMPARE(valueAfter("#declare A = array[300][300]; #declare A = dimension_size(A, 1);"),
                 std::string("300"));
    }

    /// Each took a few steps and kept a few hundred bytes, or, of strings, megabytes.
    void paysForWhatIsKept_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("mostRounds");
        const auto row = [](const char* name, const char* text, std::size_t steps) {
            QTest::newRow(name) << QString(text) << static_cast<int>(budget / steps);
        };
        using Stream = TokenStream;
        row("lights", "#while (1) light_source { 0, 1 } #end", Stream::stepsPerItem);
        row("lights of a union",
            "#declare L = light_source { 0, 1 } union { #while (1) light_source { L } #end }",
            Stream::stepsPerItem);
        row("fogs", "#while (1) fog { distance 1 } #end", Stream::stepsPerItem);
        row("rainbows", "#while (1) rainbow { } #end", Stream::stepsPerItem);
        row("defaults", "#while (1) #default { } #end", Stream::stepsPerItem);
        row("textures of a map", "#declare T = texture_map { #while (1) [0 pigment { rgb 1 }] #end }",
            Stream::stepsPerItem);
        row("parts of a blob", "blob { #while (1) sphere { 0, 1, 1 } #end }", 3 * Stream::stepsPerNumber);
        row("corners of a mesh", "mesh { #while (1) triangle { 0, x, y } #end }", 3 * Stream::stepsPerNumber);
        row("points of a spline", "#declare S = spline { #while (1) 0, x #end }", Stream::stepsPerNumber);
        row("texts that Parse_String makes",
            "#include \"strings.inc\" #for (N, 1, 1e9)"
            " Parse_String(concat(\"#declare X\", str(N, 0, 0), \" = 1;\")) #end",
            2 * Stream::stepsPerItem);
        row("files that are opened", "#for (N, 1, 1e9) #fopen F concat(\"f\", str(N, 0, 0)) write #end",
            Stream::stepsPerItem);
        row("copies of a string",
            "#declare S = \"0123456789\"; #declare S = concat(S, S, S, S, S, S, S, S, S, S);"
            "#declare S = concat(S, S, S, S, S, S, S, S, S, S); #declare A = array[900];"
            "#for (I, 0, 899) #declare A[I] = S; #end",
            1000 / Stream::charactersPerStep);
        row("copies of strings in arrays",
            "#declare S = \"0123456789\"; #declare S = concat(S, S, S, S, S, S, S, S, S, S);"
            "#declare S = concat(S, S, S, S, S, S, S, S, S, S); #declare B = array[1] { S }"
            "#declare A = array[900]; #for (I, 0, 899) #declare A[I] = B; #end",
            1000 / Stream::charactersPerStep);
    }

    void paysForWhatIsKept() {
        QFETCH(QString, text);
        QFETCH(int, mostRounds);
        const ParseResult parsed = parseScene(text.toStdString(), withBudget(budget));
        const auto cut = std::find_if(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                                      [](const Diagnostic& one) { return one.id == "loop-cut-off"; });
        QVERIFY(cut != parsed.diagnostics.end());
        const QString message = QString::fromStdString(cut->message);
        const int rounds = message.section(' ', 6, 6).toInt();
        QVERIFY2(rounds > 0 && rounds <= mostRounds, qPrintable(message));
    }

    /// An element had room for the largest kind of value, a rainbow of 1.5 kB.
    void numbersInArraysTakeLittle() { QVERIFY(sizeof(Value) <= 128); }

    void limitsMessages() {
        const StreamRun done = run(repeated("#declar ", 10'000));
        QCOMPARE(done.context->diagnostics.size(), std::size_t(201));
        QCOMPARE(done.context->diagnostics.back().message,
                 std::string("9800 further messages are not shown."));
    }

    /// A name of a megabyte was cited whole, by every message that named it.
    void messagesAreShort() {
        const StreamRun done = run("#declare A = " + repeated("long\u00e4", 100'000) + ";\n#error \"" +
                                   repeated("\u00e4", 100'000) + '"');
        QVERIFY(hasErrors(done.context->diagnostics));
        for (const Diagnostic& said : done.context->diagnostics) {
            QVERIFY(said.message.size() < 3000 && said.hint.size() < 3000);
            const QString text = QString::fromStdString(said.message);
            QVERIFY(!text.contains(QChar::ReplacementCharacter));
        }
    }

    void survivesRandomDirectives() {
        const std::uint64_t seed = 20250607;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        static const std::vector<std::string> pieces{"#if (",
                                                     "#else ",
                                                     "#elseif (",
                                                     "#end ",
                                                     "#while (",
                                                     "#for (I, 0, 3) ",
                                                     "#switch (",
                                                     "#case (",
                                                     "#range (1, ",
                                                     "#break ",
                                                     "#macro M(P) ",
                                                     "#macro ",
                                                     "M(",
                                                     "M ",
                                                     "#declare A = ",
                                                     "#local A = ",
                                                     "#declare A[",
                                                     "#undef A ",
                                                     "#include \"functions.inc\" ",
                                                     "#include A ",
                                                     "#debug ",
                                                     "#version ",
                                                     "#default ",
                                                     "#ifdef (",
                                                     "array[2] ",
                                                     "{",
                                                     "}",
                                                     "(",
                                                     ")",
                                                     "<",
                                                     ">",
                                                     "[",
                                                     "]",
                                                     ",",
                                                     ";",
                                                     "1 ",
                                                     "A ",
                                                     "I ",
                                                     "P ",
                                                     "x ",
                                                     "rgb ",
                                                     "sin(",
                                                     "concat(",
                                                     "str(",
                                                     "\"s\" ",
                                                     "\"",
                                                     "/*",
                                                     "*/",
                                                     "//",
                                                     "\n",
                                                     "?",
                                                     ":",
                                                     "=",
                                                     "+",
                                                     "-",
                                                     "!",
                                                     "&",
                                                     ".y",
                                                     "sphere ",
                                                     "#",
                                                     "rand(",
                                                     "seed(",
                                                     "vrotate(",
                                                     "defined(",
                                                     "dimensions(",
                                                     "trace(",
                                                     "#fopen ",
                                                     "#read (",
                                                     "#write ("};
        std::mt19937_64 random(seed);
        for (int round = 0; round < 3000; ++round) {
            std::string text;
            const std::size_t count = 1 + random() % 80;
            for (std::size_t k = 0; k < count; ++k) text += pieces[random() % pieces.size()];
            const StreamRun done = run(text, withBudget(20'000));
            for (const Diagnostic& diagnostic : done.context->diagnostics) {
                QVERIFY2(!diagnostic.message.empty() || diagnostic.severity == Severity::warning,
                         text.c_str());
                QVERIFY2(diagnostic.range.file < done.context->sources.size(), text.c_str());
                const std::size_t size = done.context->sources[diagnostic.range.file].text().size();
                QVERIFY2(diagnostic.range.begin <= diagnostic.range.end && diagnostic.range.end <= size,
                         text.c_str());
            }
        }
    }

    /// One thread looks at all texts: each of those that are read at once ends by its own time, and one that
    /// begins after a long silence, too.
    void textsThatAreReadAtOnceHaveTimesOfTheirOwn() {
        const std::string endless = "#while (1) #end";
        const auto endsAfter = [&](double seconds) {
            ParseOptions options = withBudget(std::numeric_limits<std::size_t>::max());
            options.secondsBudget = seconds;
            QElapsedTimer timer;
            timer.start();
            const ParseResult result = parseScene(endless, options);
            const std::string told = "it has taken " + shortestNumber(seconds) + " seconds";
            const bool cut = std::ranges::any_of(result.diagnostics, [&](const Diagnostic& diagnostic) {
                return diagnostic.message.find(told) != std::string::npos;
            });
            return cut && timer.elapsed() >= 1000 * seconds - 1;
        };
        std::array<std::atomic<bool>, 6> right{};
        {
            std::vector<std::jthread> readers;
            for (std::size_t i = 0; i < right.size(); ++i)
                readers.emplace_back([&, i] { right[i] = endsAfter(0.3 - 0.05 * static_cast<double>(i)); });
        }
        for (const std::atomic<bool>& one : right) QVERIFY(one);
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        QVERIFY(endsAfter(0.001));
        QVERIFY(endsAfter(0.2));
    }

    void normalsAreNestedToALimit() {
        const auto nested = [](int depth) {
            std::string normal = "bumps 0.1";
            for (int i = 1; i < depth; ++i) normal = "checker normal { " + normal + " } normal { dents }";
            return parseScene("sphere { 0, 1 pigment { rgb 1 } normal { " + normal + " } }");
        };
        const auto tooLarge = [](const ParseResult& parsed) {
            return std::ranges::count(parsed.diagnostics, "too-large", &Diagnostic::id) > 0;
        };
        QVERIFY(!tooLarge(nested(MappedPigment::depthLimit)));
        QVERIFY(tooLarge(nested(MappedPigment::depthLimit + 1)));
    }

    /// One that says nothing is flat, and counts.
    void normalsHaveALimitOfParts() {
        const auto parsed = [](int entries) {
            return parseScene("sphere { 0, 1 pigment { rgb 1 } normal { average normal_map {" +
                              repeated(" []", static_cast<std::size_t>(entries)) + " } } }");
        };
        const ParseResult most = parsed(MappedPigment::sizeLimit - 1);
        QVERIFY(most.ok());
        const Material& material =
            most.scene->materials.at(static_cast<std::size_t>(most.scene->objects.at(0).material));
        QCOMPARE(static_cast<int>(material.normal->size), static_cast<int>(MappedPigment::sizeLimit));
        const ParseResult more = parsed(MappedPigment::sizeLimit);
        QVERIFY(std::ranges::count(more.diagnostics, "too-large", &Diagnostic::id) == 1);
    }

    void survivesRandomBytes() {
        const std::uint64_t seed = 20250608;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        std::mt19937_64 random(seed);
        std::string text(1 << 20, '\0');
        for (char& c : text) c = static_cast<char>(random());
        QElapsedTimer timer;
        timer.start();
        const StreamRun done = run(text);
        QVERIFY(hasErrors(done.context->diagnostics));
        qInfo("%lld ms", timer.elapsed());
    }
};

QTEST_APPLESS_MAIN(LimitsTest)
#include "limits_test.moc"
