// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/token_stream.h"

#include <QTest>

#include "tests/language/stream_run.h"

using namespace isoscope;
using namespace isoscope::test;

class TokenStreamTest : public QObject {
    Q_OBJECT

    static void row(const char* text, const char* result) {
        QTest::newRow(text) << QString(text) << QString(result);
    }

    static void columns() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("result");
    }

  private slots:
    /// The tokens that are left, and behind `|` the messages.
    void runsDirectives_data() {
        columns();
        row("a b", "a b");
        row("#if (1) a #end b", "a b");
        row("#if (0) a #end b", "b");
        row("#if (0) a #else b #end", "b");
        row("#if (1) a #else b #end c", "a c");
        row("#if (0) a #elseif (1) b #elseif (1) c #else d #end e", "b e");
        row("#if (0) a #elseif (0) b #else d #end", "d");
        row("#if (0) #if (1) a #else b #end #else c #end", "c");
        row("#if (1) #if (0) a #else b #end #else c #end", "b");
        row("#if (1e-11) a #else b #end", "b");
        row("#ifdef (N) a #else b #end", "b");
        row("#declare N = 1; #ifdef (N) a #else b #end", "a");
        row("#ifndef (N) a #end", "a");
        row("#declare N = 1; #undef N #ifdef (N) a #else b #end", "b");
        row("#macro M() c #end #ifdef (M) a #end", "a");
        row("#declare B = array[2]; #declare B[1] = 5; #ifdef (B[1]) a #end #ifndef (B[0]) b #end", "a b");
        row("# if (1) a # end", "a");
        row("f{ 0 #declare i = 0; #while (i < 3) + x #declare i = i + 1; #end }", "f { 0 + x + x + x }");
        row("#declare i = 0; #while (i < 9) a #declare i = i + 1; #if (i = 2) #break #end #end b", "a a b");
        row("#while (0) a #end b", "b");
        row("#for (I, 1, 3) a #end", "a a a");
        row("#for (I, 0, 1, 0.1) a #end", "a a a a a a a a a a a");
        row("#for (I, 3, 1, -1) a #end", "a a a");
        row("#for (I, 3, 1) a #end b", "b");
        row("#for (I, 3, 1) a #end #ifdef (I) b #end", "b");
        row("#for (I 0 4 2) a #end", "a a a");
        row("##if (1) a # #end b", "a b");
        row("# box a",
            "box a | 1:1: warning: `#` is not followed by the word of a directive, so it is passed over.");
        row("#for (I, 1, 5) a #declare I = I + 1; #end", "a a a");
        row("#for (I, 1, 2) #for (J, 1, 2) a #end b #end", "a a b a a b");
        row("#switch (3) #case (1) a #break #case (3) b #case (4) c #break #else d #end e", "b c e");
        row("#switch (3.00000000001) #case (3) a #break #else b #end", "a");
        row("#switch (3) #range (1, 2) a #break #range (2, 3) b #else c #end", "b c");
        row("#switch (9) #case (1) a #break #else b #end", "b");
        row("#switch (9) #case (1) a #end b", "b");
        row("#switch (1) #case (1) #switch (2) #case (2) a #break #end b #break #case (3) c #end", "a b");
        row("#include \"functions.inc\" a", "a");
        row("#version 3.5; a", "a");
        row("#version unofficial MegaPov 0.7; a",
            "a | 1:1: warning: There is no such version of the scene language; "
            "expected a number such as 3.7.");
        row("#default { texture { finish { ambient 1 } } } a", "a");
        row("#debug \"two\\nlines\\n\" a", "a | 1:1: note: two\nlines");
        row("#debug \"\\n\" a", "a");
        row("#warning concat(\"n = \", str(3, 0, 0)) a", "a | 1:1: warning: n = 3");
        row("#error \"no more\" a", " | 1:1: error: no more");
        row("#render \"r\" #statistics \"s\" a", "a | 1:1: note: r; 1:13: note: s");
        row("#fopen F \"out.txt\" write #write (F, \"a\", 1, <1, 2, 3>) #fclose F a",
            "a | 1:1: note: `out.txt` is not written until you allow it; the picture is the same.");
        row("#write (F \"a\" \"b\", 1 <1, 2, 3>) a",
            "a | 1:9: error: `F` is not the name of a file that is open for writing, or it is full.");
        row("#write (F) a", "a");
        row("#fopen F \"in.txt\" read #while (defined(F)) #read (F, A) #end a",
            "a | 1:10: error: The file \"in.txt\" was not found beside the scene or in the library paths.");
        row("#read (F, A, B) #ifdef (A) a #end",
            " | 1:8: error: `F` is not the name of a file that is open for reading.");
        const char* const kept = "1:1: note: `f` is not written until you allow it; the picture is the same.";
        // What POV-Ray 3.7 reads and writes: the name is forgotten with the last value.
        row("#fopen F \"f\" write #write (F, \"1.5, \\\"a b\\\", \", <1, 2.5, 1/3>) #fclose F "
            "#fopen F \"f\" read #read (F, A, B) #debug concat(str(A, 0, 1), B) #read (F, C) "
            "#debug vstr(3, C, \" \", 0, 7) #ifndef (F) end #end",
            ("end | " + std::string(kept) +
             "; 1:108: note: 1.5a b; 1:152: note: 1.0000000 2.5000000 0.3333330")
                .c_str());
        row("#if (file_exists(\"f\")) a #end #fopen F \"f\" write #fclose F "
            "#if (file_exists(\"f\")) b #end",
            "b | 1:31: note: `f` is not written until you allow it; the picture is the same.");
        row("#fopen F \"f\" write #write (F, \"a b\") #fclose F #include \"f\" c",
            ("a b c | " + std::string(kept)).c_str());
    }
    void runsDirectives() { checkTokens(); }

    void callsMacros_data() {
        columns();
        row("#macro M() a b #end M() c", "a b c");
        row("#macro M(P) P #end M(1) M(2)", "1 2 | ");
        row("#macro M(A, B) #if (A > B) a #else b #end #end M(2, 1) M(1, 2)", "a b");
        row("#macro M(A B) #if (A > B) a #else b #end #end M(2 1)", "a");
        row("#macro R(n) #if (n > 0) R(n - 1) #else a #end #end R(5)", "a");
        row("#macro M() #local L = 1; #ifdef (L) a #end #end M() #ifndef (L) b #end", "a b");
        row("#macro M() #declare G = 1; #end M() #ifdef (G) a #end", "a");
        row("#macro A() #for (I, 1, 2) B() #end #end #macro B() b #end A()", "b b");
    }
    void callsMacros() {
        QFETCH(QString, text);
        QFETCH(QString, result);
        const StreamRun done = run(text.toStdString());
        QVERIFY2(done.said().empty(), done.said().c_str());
        if (!result.contains('|')) QCOMPARE(QString::fromStdString(done.tokens), result);
        // A parameter's name stays a word; what it stands for is the parser's business.
        else
            QCOMPARE(QString::fromStdString(done.tokens), QString("P P"));
    }

    /// `value of A | messages` after the text.
    void declares_data() {
        columns();
        row("#declare A = 5;", "5");
        row("#local A = 5;", "5");
        row("#declare A = 1, B = 2; #declare A = A + B;", "3");
        row("#declare A = \"s\" #declare B = 1;", "\"s\"");
        row("#declare A = sphere { 0, 1 } #declare B = A;", "a `sphere`");
        row("#declare A = array[3] { 1, 2, 3 } #declare A = A[2];", "3");
        row("#declare B = array[2][2] { {1, 2}, {3, 4} } #declare A = B[1][0];", "3");
        row("#declare B = array[2] { 1, 2 } #declare C = B; #declare C[0] = 5; #declare A = B[0];", "1");
        row("#declare B = array[2]; #declare B[0] = array[2] { 7, 8 } #declare A = B[0][1];", "8");
        row("#declare B = array[2]; #declare B[1] = sphere { 0 } #declare A = B[1];", "a `sphere`");
        row("#declare A = <1, 2, 3>; #declare A.y = 9;", "<1, 9, 3>");
        row("#declare B = array[1] { <1, 2> } #declare B[0].x = 4; #declare A = B[0];", "<4, 2>");
        row("#declare X = 3 #declare A = X;", "3 | 1:14: warning: A `;` is missing behind the value of `X`.");
        row("#declare A = 3 #if (A = 3) #declare A = 4; #end",
            "4 | 1:14: warning: A `;` is missing behind the value of `A`.");
        row("#declare A = 1 #while (A < 3) #declare A = A + 1; #end",
            "3 | 1:14: warning: A `;` is missing behind the value of `A`.");
        row("#declare A = #if (0) 1 #else 2 #end ;", "2");
        row("#declare A = rgb #if (0) 1 #else 2 #end ;", "color <2, 2, 2, 0, 0>");
        row("#declare A = max(1, #if (1) 5 #end 2);", "5");
        row("#macro M(P, Q) ((P + Q)/2) #end #declare A = 1 + M(1, 2)*4;", "7");
        row("#macro M(P, Q) (P + Q)/2 #end #declare A = M(1, 2)*4;", "6");
        row("#declare A = 1; #macro M(P) #declare P = 9; #end M(A)", "9");
        row("#declare A = 1; #macro M(P) #local P = 9; #end M(A)", "9");
        row("#declare A = 1; #macro M(P) #declare P = 9; #end M(A + 0)", "1");
        row("#declare A = 1; #macro I(P) #declare P = 9; #end #macro M(P) I(P) #end M(A)", "9");
        row("#declare B = array[2] { 1, 2 } #macro M(P) #declare P = 9; #end M(B[1]) #declare A = B[1];",
            "9");
        row("#declare B = array[2] { 1, 2 } #macro M(P) #declare P[0] = 9; #end M(B) #declare A = B[0];",
            "9");
        row("#declare B = array[2]; #macro M(P) #declare P = 9; #end M(B[1]) #declare A = B[1];", "9");
        row("#macro I() #declare L = 7; #end #macro M() #local L = 1; I() #declare A = L; #end M()", "7");
        row("#declare X = version; #version 3.5; #declare A = version; #version X; #declare B = version;",
            "3.5");
        row("#declare deprecated once \"old\" A = 3;", "3");
        row("#declare A = 1; #macro M() #declare A = 2; #end #declare A = 5; M()", "2");
    }
    void declares() { checkValue(); }

    /// A macro may end a `#declare` with its own `;` while it is still running: the name must not become one
    /// of the macro's.
    void aLocalValueFromAMacroStaysLocalToTheCaller() {
        QCOMPARE(
            valueAfter("#macro V() #local T = 3; T; #end #macro M() #local L = V() #declare A = L; #end M()"),
            std::string("3"));
    }

    /// A missing semicolon in front of a macro call: the call must see the new value.
    void aMacroBehindAValueIsCalledAfterTheDeclaration() {
        QCOMPARE(valueAfter("#macro M(P) #declare A = concat(P, \"b\"); #end #declare S = \"a\" M(S)"),
                 std::string("\"ab\""));
    }

    void explainsMistakes_data() {
        columns();
        row("#declar A = 1;", "1:1: error: `#declar` is not a directive.");
        row("a # 1", "1:3: warning: `#` is not followed by the word of a directive, so it is passed over.");
        row("#if (1) a", "1:1: error: `#if` is never closed; expected `#end`.");
        row("#if (0) a", "1:1: error: `#if` is never closed; expected `#end`.");
        row("#while (0) a", "1:1: error: `#while` is never closed; expected `#end`.");
        row("#switch (1) #case (2) a", "1:1: error: `#switch` is never closed; expected `#end`.");
        row("#macro M() a", "1:1: error: `#macro` is never closed; expected `#end`.");
        row("a #end", "1:3: error: `#end` closes nothing: no `#if`, loop, `#switch` or `#macro` is open.");
        row("#else", "1:1: error: `#else` stands outside any `#if`.");
        row("#case (1)", "1:1: error: `#case` stands outside any `#switch`.");
        row("#break", "1:1: error: `#break` stands outside any loop or `#switch`.");
        row("#if 1 a #end", "1:5: error: Expected `(` after `#if`, but found `1`.");
        row("#if (<1, 2, 3>) a #end", "1:6: error: Expected a float, but this is a vector.");
        row("#if (1 #end",
            "1:8: error: Expected `)` to close the condition of `#if`, but the text ends here.");
        row("#ifdef N #end", "1:8: error: Expected `(` behind `#ifdef`, but found `N`.");
        row("#declare = 3;", "1:10: error: Expected the name that is to be declared.");
        row("#declare sphere = 3;",
            "1:10: error: `sphere` is a word of the language and cannot be declared.");
        row("#declare x = 3;", "1:10: error: `x` is a word of the language and cannot be declared.");
        row("#declare A 3;", "1:12: error: Expected `=` behind the name in `#declare`, but found `3`.");
        row("#declare A = Q; #declare B = A;", "1:14: error: `Q` is not declared.");
        row("#declare A = ;", "1:14: error: Expected a value, but found `;`.");
        row("#declare A = 3 > 2; b", "1:16: error: `>` needs parentheses around the whole comparison here.");
        row("#declare A = 2^3;", "1:15: error: Expected `;` behind the value of `A`, but found `^`.");
        row("#declare A[0] = 3;", "1:10: error: `A` is not declared, but `[` asks for an array.");
        row("#declare A = array[2]; #declare A[2] = 3;",
            "1:35: error: This index is outside the array: expected 0 to 1.");
        row("#declare A = array[2]; #declare A[-1] = 3;",
            "1:35: error: This index is outside the array: expected 0 to 1.");
        row("#declare A = array[2]; #declare B = A[0];",
            "1:37: error: This element of `A` has not been given a value.");
        row("#declare A = array { 1 }",
            "1:20: error: Expected `[` and the size of the array behind `array`.");
        row("#declare A = array[2] { 1, 2, 3 }",
            "1:31: error: Expected `}` to close the elements of the array, which has room for 2 here.");
        row("#declare A = array[2e9];",
            "1:23: error: An array of 2e+09 elements is too large; the most is 1000000000.");
        row("#declare A = array[0];",
            "1:21: error: An array has 1 to 5 dimensions, each with at least 1 element.");
        row("#declare A = 1; #declare A.y = 2;", "1:26: error: `A` is a float without such a component.");
        row("#undef Q", "1:8: warning: `Q` is not declared, so `#undef` does nothing.");
        row("#include \"nowhere.inc\"",
            "1:1: error: The include file \"nowhere.inc\" was not found beside the including file, beside "
            "the scene or in "
            "the library paths.");
        row("#include 3", "1:10: error: Expected a string, but this is a float.");
        row("#for (I, 1, 3, 0) a #end", "1:1: error: The step of this `#for` is 0, so it would never end.");
        row("#for (x, 1, 3) a #end", "1:7: error: Expected the name of the loop's variable after `#for (`.");
        row("#for (I, 1, 3) #declare I = \"s\"; #end",
            "1:1: error: The variable `I` of this `#for` is no float any more, so the loop ends.");
        row("#macro M(A, B) #end M(1)", "1:21: error: The macro `M(A, B)` takes 2 arguments; 1 is missing.");
        row("#macro M(A, B) #end M(1, 2, 3) c",
            "1:27: error: The macro `M(A, B)` takes 2 arguments; expected `)` here.");
        row("#macro M() #end M c",
            "1:19: error: Expected `(` and the arguments of the macro `M()`, but found `c`.");
        row("#macro M(A) #end M(New)", "1:20: error: `New` is not declared.");
        row("#macro 3() #end", "1:8: error: Expected the name of the macro behind `#macro`.");
        row("#macro M A #end", "1:10: error: Expected the parameters of the macro `M` as `(A, B)` or `()`.");
        row("#version x;", "1:10: error: Expected a float, but this is a vector.");
        row("#fopen F \"f\" delete",
            "1:14: error: Expected `read`, `write` or `append` behind the name of the file.");
        row("\"a\\qb\"", "1:3: warning: `\\q` is no escape sequence.");
        row("a \"b", "1:3: error: This string is never closed; expected `\"`.");
        row("a /* b", "1:3: error: This comment is never closed; expected `*/`.");
        row("#if (0) \" #end\n b",
            "1:9: error: This string is never closed; expected `\"`.; "
            "1:1: error: `#if` is never closed; expected `#end`.");
        row("#if (0) ' \xc3\xa4 1.2.3 #end", "");
        row("a\n\n  #declar", "3:3: error: `#declar` is not a directive.");
    }

    void explainsMistakes() {
        QFETCH(QString, text);
        QFETCH(QString, result);
        QCOMPARE(QString::fromStdString(run(text.toStdString()).said()), result);
    }

    void tellsHowAPlaceWasReached() {
        const StreamRun done = run("#macro I()\n #declar\n#end\n#macro M()\n I()\n#end\nM()\nI()\n#declar");
        QCOMPARE(done.messages(),
                 (std::vector<std::string>{"2:2: error: `#declar` is not a directive. < 5:2 < 7:1",
                                           "9:1: error: `#declar` is not a directive."}));
    }

    /// The brace that is missing is noticed when the macro's text has been left already.
    void tellsHowAPlaceWasReachedOneTokenLate() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "#macro M() a #end\nM() b"));
        const Token a = tokens.next();
        tokens.peek();
        context.error("x", a.range, "late");
        QCOMPARE(context.diagnostics.at(0).reachedFrom.size(), std::size_t(1));
        QVERIFY((context.diagnostics[0].reachedFrom[0] == SourceRange{0, 18, 21}));
    }

    /// A string is taken by itself, any other name as an expression.
    void theNameOfAnIncludeCountsAsRead() {
        for (const char* name : {"\"f\"", "concat(\"f\", \"\")"}) {
            const std::string text =
                std::string("#fopen F \"f\" write #write (F, \"b\") #fclose F a #include ") + name;
            ParseContext context{ParseOptions{}};
            TokenStream tokens(context, context.sources.add("scene.pov", text));
            QCOMPARE(tokens.next().text, std::string_view("a"));
            QCOMPARE(tokens.peek().text, std::string_view("b"));
            QCOMPARE(tokens.lastRange().file, 0u);
            QCOMPARE(std::size_t(tokens.lastRange().end), text.size());
        }
    }

    void namesAreReadWithoutCallingMacros() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "#macro M() a #end ( M )"));
        QVERIFY(tokens.accept("("));
        QCOMPARE(tokens.nextName().text, std::string_view("M"));
        QVERIFY(tokens.accept(")"));
    }

    void givesBackTokens() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "a b"));
        const Token a = tokens.next();
        tokens.peek();
        tokens.pushBack(a);
        QCOMPARE(tokens.next().text, std::string_view("a"));
        QCOMPARE(tokens.next().text, std::string_view("b"));
        QCOMPARE(tokens.next().kind, TokenKind::end);
        QCOMPARE(tokens.next().kind, TokenKind::end);
        QVERIFY((tokens.lastRange() == SourceRange{0, 2, 3}));
    }

    void skipsBlocksAndStatements_data() {
        columns();
        row("photons { target { 1 } } b", "b");
        row("max_trace 4 b", "b");
        row("thing <1, 2> \"s\", 3 b", "b");
        row("thing }", "}");
        row("thing { ", "");
        row("thing #if (1) { 3 } #end b", "b");
    }

    void skipsBlocksAndStatements() {
        QFETCH(QString, text);
        QFETCH(QString, result);
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", text.toStdString()));
        tokens.skipStatement();
        QCOMPARE(QString::fromUtf8(tokens.next().text.data(), static_cast<int>(result.size())), result);
        QVERIFY(context.diagnostics.empty());
    }

    void saysWhatWasExpected() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "sphere 3"));
        QVERIFY(tokens.expect("sphere"));
        QVERIFY(!tokens.expect("{", "to begin `sphere`"));
        QCOMPARE(QString::fromStdString(context.diagnostics.at(0).message),
                 QString("Expected `{` to begin `sphere`, but found `3`."));
        QVERIFY((context.diagnostics[0].range == SourceRange{0, 7, 8}));
    }

    void asksForDefaults() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "#default { a } b"));
        std::string block;
        tokens.setDefaultParser([&block](TokenStream& stream) {
            for (Token token = stream.next(); token.kind != TokenKind::end && !token.is("}");
                 token = stream.next())
                block += token.text;
        });
        QCOMPARE(tokens.next().text, std::string_view("b"));
        QCOMPARE(block, std::string("{a"));
    }

  private:
    void checkTokens() {
        QFETCH(QString, text);
        QFETCH(QString, result);
        const StreamRun done = run(text.toStdString());
        const std::string said = done.said();
        QCOMPARE(QString::fromStdString(done.tokens + (said.empty() ? "" : " | " + said)), result);
    }

    void checkValue() {
        QFETCH(QString, text);
        QFETCH(QString, result);
        QCOMPARE(QString::fromStdString(valueAfter(text.toStdString())), result);
    }
};

QTEST_APPLESS_MAIN(TokenStreamTest)
#include "token_stream_test.moc"
