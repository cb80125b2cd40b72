// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/lexer.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace isoscope;

namespace {

std::string kindName(TokenKind kind) {
    switch (kind) {
        case TokenKind::number: return "n";
        case TokenKind::string: return "s";
        case TokenKind::word: return "w";
        case TokenKind::symbol: return "y";
        case TokenKind::end: return "e";
    }
    return "?";
}

/// `kind:text` of every token, and `!id@begin-end` for every mistake.
std::string cut(const std::string& text) {
    Lexer lexer(text, 0);
    std::string all;
    for (;;) {
        const Token token = lexer.next();
        if (const auto mistake = lexer.takeMistake())
            all += "!" + mistake->id + "@" + std::to_string(mistake->range.begin) + "-" +
                   std::to_string(mistake->range.end) + " ";
        if (token.kind == TokenKind::end) break;
        all += kindName(token.kind) + ":" + std::string(token.text) + " ";
    }
    if (!all.empty()) all.pop_back();
    return all;
}

}  // namespace

class LexerTest : public QObject {
    Q_OBJECT

  private slots:
    void cutsTokens_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("tokens");
        const auto row = [](const char* name, const char* text, const char* tokens) {
            QTest::newRow(name) << QString(text) << QString(tokens);
        };
        row("empty", "", "");
        row("words", "a Bc_9 _x", "w:a w:Bc_9 w:_x");
        row("numbers", "1 .5 5. 1e3 1.5e-3 2E+1", "n:1 n:.5 n:5. n:1e3 n:1.5e-3 n:2E+1");
        row("number and member", "V.x 1.x", "w:V y:. w:x n:1. w:x");
        row("number without exponent digits", "1e 2e+ 3ex", "n:1e n:2e+ n:3e w:x");
        row("two points", "1.2.3", "!malformed-number@0-5 n:1.2.3");
        row("symbols", "<=>=!=<>!", "y:<= y:>= y:!= y:< y:> y:!");
        row("all symbols", "{}()[],;+-*/&|=?:^#.",
            "y:{ y:} y:( y:) y:[ y:] y:, y:; y:+ y:- y:* y:/ y:& y:| y:= y:? y:: y:^ y:# y:.");
        row("line comment", "a // b\nc", "w:a w:c");
        row("block comment", "a /* b */ c", "w:a w:c");
        row("nested comment", "a /* b /* c */ d */ e", "w:a w:e");
        row("open comment", "a /* b /* c */", "w:a !unterminated-comment@2-4");
        row("string", "\"a b\" \"\"", "s:\"a b\" s:\"\"");
        row("escaped quote", "\"a\\\"b\" c", "s:\"a\\\"b\" w:c");
        row("string over lines", "\"a\nb\" c", "s:\"a\nb\" w:c");
        row("open string", "x \"a\nb", "w:x !unterminated-string@2-4 s:\"a w:b");
        row("stray characters", "a @$ b", "w:a !stray-character@2-4 w:b");
        row("byte order mark",
            "\xef\xbb\xbf"
            "a",
            "w:a");
        row("hash", "# declare", "y:# w:declare");
    }

    void cutsTokens() {
        QFETCH(QString, text);
        QFETCH(QString, tokens);
        QCOMPARE(QString::fromStdString(cut(text.toStdString())), tokens);
    }

    void aTextInUtf16IsOneMistake_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("wide");
        QTest::newRow("little end first, marked") << QByteArray(
                                                         "\xff\xfe"
                                                         "a\0 \0",
                                                         6)
                                                  << true;
        QTest::newRow("big end first, marked") << QByteArray(
                                                      "\xfe\xff"
                                                      "\0a\0 ",
                                                      6)
                                               << true;
        QTest::newRow("little end first") << QByteArray("s\0p\0h\0e\0r\0e\0", 12) << true;
        QTest::newRow("big end first") << QByteArray("\0s\0p\0h\0e\0r\0e", 12) << true;
        QTest::newRow("marked, taken for Latin-1") << QString::fromLatin1(
                                                          "\xff\xfe"
                                                          "a\0 \0",
                                                          6)
                                                          .toUtf8()
                                                   << true;
        QTest::newRow("one NUL") << QByteArray("sphere\0 { 0, 1 }", 16) << false;
        QTest::newRow("NULs alone") << QByteArray("\0\0\0\0\0\0", 6) << false;
        QTest::newRow("UTF-8, marked") << QByteArray(
                                              "\xef\xbb\xbf"
                                              "a")
                                       << false;
        QTest::newRow("nothing") << QByteArray() << false;
    }
    void aTextInUtf16IsOneMistake() {
        QFETCH(QByteArray, text);
        QFETCH(bool, wide);
        const std::string tokens = cut(text.toStdString());
        QCOMPARE(tokens.find("utf-16") != std::string::npos, wide);
        if (wide) QCOMPARE(tokens, std::string("!utf-16@0-2"));
    }

    void readsNumbers_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("integer") << "42" << 42.0;
        QTest::newRow("fraction") << ".5" << 0.5;
        QTest::newRow("point at the end") << "5." << 5.0;
        QTest::newRow("exponent") << "1.5e-3" << 1.5e-3;
        QTest::newRow("e alone") << "1e" << 1.0;
        QTest::newRow("nearest double") << "0.1" << 0.1;
        QTest::newRow("too large") << "1e999" << std::numeric_limits<double>::infinity();
        QTest::newRow("too small") << "1e-999" << 0.0;
        QTest::newRow("too small without exponent") << "." + QString(400, '0') + "1" << 0.0;
        QTest::newRow("long") << QString(400, '9') << std::numeric_limits<double>::infinity();
    }

    void readsNumbers() {
        QFETCH(QString, text);
        QFETCH(double, value);
        const std::string bytes = text.toStdString();
        QCOMPARE(Lexer(bytes, 0).next().number, value);
    }

    void tellsRanges() {
        const std::string text = "ab  <=";
        Lexer lexer(text, 7);
        QVERIFY((lexer.next().range == SourceRange{7, 0, 2}));
        QVERIFY((lexer.next().range == SourceRange{7, 4, 6}));
        QVERIFY((lexer.next().range == SourceRange{7, 6, 6}));
    }

    void readsAPieceAndSeeksBack() {
        const std::string text = "one two three";
        Lexer lexer(text, 0, 4, 7);
        QCOMPARE(lexer.next().text, std::string_view("two"));
        QCOMPARE(lexer.next().kind, TokenKind::end);
        lexer.seek(4);
        QCOMPARE(lexer.next().text, std::string_view("two"));
    }

    void aPieceEndsWithinAWord() {
        const std::string text = "1 twofold 345";
        QCOMPARE(Lexer(text, 0, 2, 5).next().text, std::string_view("two"));
        QCOMPARE(Lexer(text, 0, 10, 12).next().number, 34.0);
    }

    void decodesStrings_data() {
        QTest::addColumn<QString>("quoted");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("bad");
        QTest::newRow("plain") << "\"abc\""
                               << "abc" << -1;
        QTest::newRow("escapes") << "\"a\\n\\t\\\"\\\\b\""
                                 << "a\n\t\"\\b" << -1;
        QTest::newRow("unicode") << "\"\\u0041\\u00e4\\u20ac\"" << QString::fromUtf8("A\xc3\xa4\xe2\x82\xac")
                                 << -1;
        QTest::newRow("four digits") << "\"\\u0041B\""
                                     << "AB" << -1;
        QTest::newRow("unknown") << "\"a\\qb\""
                                 << "a\\qb" << 2;
        QTest::newRow("short unicode") << "\"\\u41\""
                                       << "\\u41" << 1;
    }

    void decodesStrings() {
        QFETCH(QString, quoted);
        QFETCH(QString, text);
        QFETCH(int, bad);
        std::optional<std::uint32_t> badEscape;
        QCOMPARE(QString::fromStdString(decodeString(quoted.toStdString(), badEscape)), text);
        QCOMPARE(badEscape ? static_cast<int>(*badEscape) : -1, bad);
    }

    void keepsBackslashesOfFileNames() {
        QCOMPARE(rawString("\"a\\new.inc\""), std::string_view("a\\new.inc"));
    }
};

QTEST_APPLESS_MAIN(LexerTest)
#include "lexer_test.moc"
