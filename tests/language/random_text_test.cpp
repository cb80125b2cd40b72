// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <random>

#include "core/language/parse.h"

using namespace isoscope;

/// Texts of random words: the parser must come to an end, and say something.
class RandomTextTest : public QObject {
    Q_OBJECT

    static constexpr std::uint64_t seed = 20240611;

    static std::string randomWords(std::mt19937_64& random, std::size_t count) {
        static const std::vector<std::string> words{"isosurface",
                                                    "function",
                                                    "{",
                                                    "}",
                                                    "(",
                                                    ")",
                                                    "<",
                                                    ">",
                                                    ",",
                                                    ";",
                                                    "x",
                                                    "y",
                                                    "z",
                                                    "1",
                                                    "-2.5e3",
                                                    "+",
                                                    "-",
                                                    "*",
                                                    "/",
                                                    "#declare",
                                                    "#local",
                                                    "A",
                                                    "B",
                                                    "=",
                                                    "#if",
                                                    "#else",
                                                    "#end",
                                                    "#while",
                                                    "#macro",
                                                    "union",
                                                    "object",
                                                    "sphere",
                                                    "box",
                                                    "pigment",
                                                    "texture",
                                                    "finish",
                                                    "rgb",
                                                    "translate",
                                                    "rotate",
                                                    "scale",
                                                    "camera",
                                                    "location",
                                                    "look_at",
                                                    "light_source",
                                                    "pattern",
                                                    "bozo",
                                                    "turbulence",
                                                    "internal",
                                                    "f_torus",
                                                    "sum",
                                                    "select",
                                                    "min",
                                                    "contained_by",
                                                    "threshold",
                                                    "max_gradient",
                                                    "array",
                                                    "[",
                                                    "]",
                                                    "\"text\"",
                                                    "color_map",
                                                    "difference",
                                                    "clipped_by",
                                                    "#default",
                                                    "global_settings",
                                                    "#include \"functions.inc\"\n",
                                                    "#switch",
                                                    "#case",
                                                    "#break",
                                                    "transform",
                                                    "matrix",
                                                    ".",
                                                    "red",
                                                    "&",
                                                    "|"};
        std::string text;
        for (std::size_t k = 0; k < count; ++k) text += words[random() % words.size()] + ' ';
        return text;
    }

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void aMegabyteOfRandomBytes() {
        std::mt19937_64 random(seed);
        std::string text(1 << 20, '\0');
        for (char& c : text) c = static_cast<char>(random());
        const ParseResult parsed = parseScene(text);
        QVERIFY(!parsed.ok());
        QVERIFY(parsed.scene != nullptr);
        QVERIFY2(parsed.seconds < 20, qPrintable(QString::number(parsed.seconds)));
        QCOMPARE((*parsed.sources)[0].text(), std::string_view(text));
    }

    void wordsInRandomOrder() {
        std::mt19937_64 random(seed);
        for (int round = 0; round < 400; ++round) {
            const std::string text = randomWords(random, 5 + random() % 200);
            ParseOptions options;
            options.stepBudget = 50'000;
            const ParseResult parsed = parseScene(text, options);
            QVERIFY2(parsed.scene != nullptr, text.c_str());
            QVERIFY2(parsed.seconds < 20, text.c_str());
            for (const Diagnostic& diagnostic : parsed.diagnostics) {
                QVERIFY2(diagnostic.range.begin <= diagnostic.range.end, text.c_str());
                QVERIFY2(diagnostic.range.file < parsed.sources->size(), text.c_str());
                QVERIFY2(diagnostic.range.end <= (*parsed.sources)[diagnostic.range.file].text().size(),
                         text.c_str());
                QVERIFY2(!diagnostic.message.empty(), text.c_str());
            }
        }
    }

    void anEndInsideTheConditionOfALoop() {
        for (const char* text :
             {"#while #end 1 #while", "#while (#end 1) #end", "#while ( #while #end #end ) #end #end",
              "turbulence box #else matrix #while #end 1 ] ) pigment #end rgb #local 1 rotate #while "})
            QVERIFY(!parseScene(text).ok());
    }

    void everyPrefixOfAScene() {
        const std::string text = R"(#version 3.7; #include "functions.inc" #declare R = 0.5;
camera { location <0, 1, -5> look_at <0, 0, 0> angle 40 } light_source { <5, 5, -5>, rgb 1 }
#macro M(A) sphere { <A, 0, 0>, R pigment { rgb <1, A, 0> } } #end
union { M(1) M(2) isosurface { function { f_torus(x, y, z, 0.8, R/2) + sum(i, 1, 3, sin(i*x)) } contained_by { sphere { 0, 2 } } } }
)";
        for (std::size_t size = 0; size < text.size(); ++size) {
            const ParseResult parsed = parseScene(text.substr(0, size));
            QVERIFY(parsed.scene != nullptr);
        }
        QVERIFY(parseScene(text).ok());
    }

    void functionBodiesOfRandomSymbols() {
        std::mt19937_64 random(seed + 1);
        for (int round = 0; round < 1500; ++round) {
            const std::string body = randomWords(random, 1 + random() % 30);
            const ParsedFunction parsed = parseFunction(body);
            QVERIFY2(parsed.ok() || !parsed.diagnostics.empty(), body.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(RandomTextTest)
#include "random_text_test.moc"
