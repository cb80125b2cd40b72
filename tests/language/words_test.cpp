// SPDX-License-Identifier: GPL-3.0-or-later
// Which words may be names, beside POV-Ray's answers.
#include "core/language/tokens/words.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <map>
#include <random>

#include "core/language/expressions/expression_functions.h"
#include "core/language/expressions/named_constants.h"
#include "core/language/functions/function_caller.h"
#include "core/language/functions/function_words.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/wrapping_modifier.h"
#include "core/language/parse.h"
#include "core/language/statement_description.h"
#include "core/language/tokens/block_words.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/povray.h"

using namespace isoscope;

namespace {

/// The columns of reserved_words.csv, each with a text that gives the name to something.
const std::map<std::string, QString> uses{{"declared", "#declare %1 = 1;"},
                                          {"macro_parameter", "#macro Macro(%1) #end"},
                                          {"function_parameter", "#declare F = function(%1) { 1 }"}};

bool accepts(const QString& text) {
    const ParseResult parsed = parseScene("#version 3.7;\n" + text.toStdString());
    return std::ranges::none_of(parsed.diagnostics,
                                [](const Diagnostic& said) { return said.severity == Severity::error; });
}

bool povrayAccepts(const QString& text) {
    const QTemporaryDir folder;
    QFile scene(folder.filePath("scene.pov"));
    if (!scene.open(QIODevice::WriteOnly)) return false;
    scene.write("#version 3.7;\n" + text.toLatin1() + "\nglobal_settings { assumed_gamma 1 }\n");
    scene.close();
    QProcess povray;
    povray.setWorkingDirectory(folder.path());
    povray.start("povray", {"+Iscene.pov", "-D", "-F", "+W8", "+H8"});
    return povray.waitForFinished() && povray.exitCode() == 0;
}

}  // namespace

class WordsTest : public QObject {
    Q_OBJECT

    const test::CsvTable answers_{QStringLiteral(ISOSCOPE_TEST_DATA "/language/reserved_words.csv")};

  private slots:
    void namesAreAcceptedWherePovrayAcceptsThem_data() {
        QTest::addColumn<std::size_t>("row");
        QVERIFY(answers_.rowCount() > 450);
        for (std::size_t row = 0; row < answers_.rowCount(); ++row)
            QTest::newRow(answers_.field(row, "word").c_str()) << row;
    }
    void namesAreAcceptedWherePovrayAcceptsThem() {
        QFETCH(std::size_t, row);
        const std::string& word = answers_.field(row, "word");
        for (const auto& [column, text] : uses)
            QVERIFY2(
                accepts(text.arg(QString::fromStdString(word))) == (answers_.field(row, column) == "yes"),
                column.c_str());
        QCOMPARE(isReservedWord(word), answers_.field(row, "declared") == "no");
    }

    void everyWordHasBeenAsked() {
        std::vector<std::string> asked, known;
        for (std::size_t row = 0; row < answers_.rowCount(); ++row) {
            asked.push_back(answers_.field(row, "word"));
            if (answers_.field(row, "function_parameter") == "no" && !findWord(asked.back()))
                known.push_back(asked.back());
        }
        QCOMPARE(known, std::vector<std::string>{});
        for (const Word& word : words())
            QVERIFY2(std::ranges::count(asked, word.text) == 1, word.text.data());
    }

    void povrayAnswersTheSameAgain() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        constexpr unsigned seed = 20261122;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        for (int count = 0; count < 4; ++count)
            for (const auto& [column, text] : uses) {
                const std::size_t row = random() % answers_.rowCount();
                const std::string& word = answers_.field(row, "word");
                QVERIFY2(povrayAccepts(text.arg(QString::fromStdString(word))) ==
                             (answers_.field(row, column) == "yes"),
                         (column + " " + word).c_str());
            }
    }

    void wordsAreFound() {
        QVERIFY(std::ranges::is_sorted(words(), {}, &Word::text));
        for (const Word& word : words()) {
            QCOMPARE(findWord(word.text), &word);
            QVERIFY(!findWord(std::string(word.text) + "_"));
            QVERIFY(!word.is(WordUse::constant) ||
                    namedConstant(word.text, ParseContext(ParseOptions())).has_value());
        }
        QVERIFY(!findWord(""));
        QVERIFY(!findWord("Sphere"));
        QVERIFY(!findWord(std::string(100000, 'a')));
    }

    void functionsAreThoseThatCanBeCalled() {
        for (const auto* table : {&floatFunctions(), &vectorFunctions(), &stringFunctions()})
            for (const ExpressionFunction& function : *table)
                QVERIFY2(FunctionCaller::knows(function.name), function.name.data());
        for (const Word& word : words()) {
            QCOMPARE(findElementaryFunction(word.text) != nullptr, word.is(WordUse::elementaryFunction));
            QCOMPARE(!word.call.empty(), word.is(WordUse::elementaryFunction | WordUse::expressionFunction));
            QVERIFY(word.call.empty() || word.call.starts_with(std::string(word.text) + "("));
        }
    }

    void shapesAreWordsOfTheirUse() {
        for (const ShapeParser& parser : shapeParsers()) {
            QVERIFY2(isWordFor(WordUse::shape, parser.keyword), parser.keyword.data());
            QCOMPARE(findShapeParser(parser.keyword), &parser);
            QVERIFY(parser.parse != nullptr);
        }
        QVERIFY(std::ranges::adjacent_find(shapeParsers(), {}, &ShapeParser::keyword) ==
                shapeParsers().end());
        std::vector<std::string_view> unread;
        for (const Word& word : words())
            if (isUnreadShape(word.text)) unread.push_back(word.text);
        QCOMPARE(unread, (std::vector<std::string_view>{"lemon", "ovus"}));
        QVERIFY(!findShapeParser("union") && !isUnreadShape("union"));
    }

    void wrappingModifiersAreWords() {
        std::vector<std::string_view> keywords;
        for (const WrappingModifier& modifier : wrappingModifiers()) {
            QVERIFY2(isReservedWord(modifier.keyword), modifier.keyword.data());
            keywords.push_back(modifier.keyword);
        }
        QCOMPARE(keywords, (std::vector<std::string_view>{"inverse", "clipped_by", "bounded_by"}));
        QVERIFY(!findWrappingModifier("hollow"));
        for (const std::string_view keyword : keywords)
            QVERIFY(std::ranges::find(wordsOfBlock("torus"), keyword) != wordsOfBlock("torus").end());
    }

    void itemsOfBlocksAreWords() {
        for (const std::string& word : wordsOfBlock("?")) QVERIFY2(findWord(word), word.c_str());
    }

    /// Descriptions are written by the example of others: each must be found by its own word, and that be
    /// one.
    void statementsAreFoundByTheirWords() {
        const std::vector<std::string>& offered = wordsOfBlock("");
        for (const StatementDescription* statement : statementDescriptions) {
            QCOMPARE(findStatement(statement->word), statement);
            QVERIFY(isWordFor(WordUse::keyword, statement->word));
            QVERIFY(!isWordFor(WordUse::notSimulated, statement->word));
            QVERIFY(std::count(offered.begin(), offered.end(), statement->word) == 1);
            QVERIFY(wordsOfBlock(statement->word) != wordsOfBlock("?"));
        }
        QVERIFY(!findStatement("camera"));
    }

    /// `image_width` and the like are declared before the text begins.
    void predeclaredConstantsGiveWay() {
        const std::string text =
            "#declare image_width = 3; #declare F = function { image_width + frame_number }\n"
            "#if (F(0, 0, 0) != 3 | image_width != 3) #error \"not declared anew\" #end\n"
            "#ifndef (frame_number) #error \"not declared\" #end #ifdef (clock) #error \"a word\" #end";
        QVERIFY(accepts(QString::fromStdString(text)));
    }

    /// POV-Ray prints 0 for each of them.
    void withoutAnAnimationItsConstantsAreZero() {
        for (const char* word : {"initial_clock", "final_clock", "clock_delta", "clock_on", "initial_frame",
                                 "final_frame", "frame_number"}) {
            const std::optional<Operand> value = namedConstant(word, ParseContext(ParseOptions()));
            QVERIFY(value);
            QCOMPARE(value->value(), 0.0);
        }
    }

    /// As POV-Ray 3.7.0.10 says by `#debug`.
    void predeclaredConstantsCanBeUndefined_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("there");
        const auto row = [](const char* text, bool there) { QTest::newRow(text) << text << there; };
        row("", true);
        row("#undef image_width", false);
        row("#declare image_width = 3; #undef image_width", false);
        row("#macro M() #undef image_width #end M()", false);
        row("#macro M() #local image_width = 7; #undef image_width #end M()", true);
        row("#declare F = function { image_width } #undef image_width #if (F(0, 0, 0) != 800) #error \"\" "
            "#end",
            false);
    }
    void predeclaredConstantsCanBeUndefined() {
        QFETCH(QString, text);
        QFETCH(bool, there);
        QVERIFY(accepts(text));
        QCOMPARE(accepts(text + "\n#ifndef (image_width) #error \"\" #end"), there);
        QCOMPARE(accepts(text + "\n#declare A = image_width;"), there);
        QCOMPARE(accepts(text + "\n#declare A = function { image_width };"), there);
    }

    void reservedWordsCannotBeForgotten() {
        QVERIFY(accepts("#declare A = 1; #undef A"));
        QVERIFY(!accepts("#undef text"));
    }

    void countersOfSums_data() {
        QTest::addColumn<bool>("accepted");
        QTest::newRow("I") << true;
        QTest::newRow("x") << true;
        QTest::newRow("sphere") << false;
        QTest::newRow("text") << false;
    }
    void countersOfSums() {
        QFETCH(bool, accepted);
        QCOMPARE(accepts(QString("#declare F = function { sum(%1, 1, 3, %1) }").arg(QTest::currentDataTag())),
                 accepted);
    }

    /// What is put together from objects takes them, and nothing else does.
    void onlyCombiningObjectsTakeObjects() {
        const auto has = [](const char* block, const char* word) {
            const std::vector<std::string>& words = wordsOfBlock(block);
            return std::find(words.begin(), words.end(), word) != words.end();
        };
        for (const char* object : {"union", "merge", "intersection", "difference", "light_group"})
            QVERIFY2(has(object, "sphere") && has(object, "split_union") && has(object, "pigment"), object);
        for (const char* object : {"sphere", "box", "torus", "isosurface", "mesh"})
            QVERIFY2(!has(object, "sphere") && !has(object, "split_union") && has(object, "pigment"), object);
    }
};

QTEST_GUILESS_MAIN(WordsTest)
#include "words_test.moc"
