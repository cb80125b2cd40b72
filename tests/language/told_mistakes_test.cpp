// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "core/language/parse.h"

using namespace isoscope;

/// A mistake in a scene is told once, in words that say what should stand there, and what follows is read.
class ToldMistakesTest : public QObject {
    Q_OBJECT

  private slots:
    void aMistakeIsToldOnce_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* text, const char* message) {
            QTest::newRow(text) << text << message;
        };
        row("camera { cylinder 7 }", "A `cylinder` camera is one of 1, 2, 3 or 4.");
        row("camera { aperture 1 blur_samples 1e9 }", "`blur_samples` are sent");
        row("background { rgb 1 z }", "Expected `}` to close `background`.");
        // What a mistake leaves of a statement is no mistake of its own.
        row("foo bar baz 3 qux", "Expected a statement such as `isosurface`, but found `foo`.");
        row("camera what location -3*z look_at 0 }", "Expected `{` to begin `camera`, but found `what`.");
        row("fog what\n distance 3\n fog_type 2\n}", "Expected `{` to begin `fog`, but found `what`.");
        row("sphere what 0, 1 texture { pigment { rgb 1 } } }", "Expected `{` to begin `sphere`");
        row("sphere { 0, 1 } } }", "This `}` closes nothing.");
        row("\x01", "A control character (code 1) has no meaning here");
        row("sphere { 0, 1 \x7f }", "A control character (code 127) has no meaning here");
        row("fog { distance 3 what }", "`what` is not understood in `fog`");
        // They were taken, and POV-Ray refuses them.
        row("#default { texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } } }",
            "A default texture cannot be made of other textures.");
        row("#declare T = texture { checker texture { } texture { } } #default { texture { T } }",
            "A default texture cannot be made of other textures.");
        row("superellipsoid { <1, 0> }", "must be greater than 0.");
        row("superellipsoid { <0, 1> }", "must be greater than 0.");
        row("#declare A what 5;\nsphere { A, 1 }", "Expected `=` behind the name in `#declare`");
        row("#declare A 5\nsphere { A, 1 }", "Expected `=` behind the name in `#declare`");
        row("#declare A = 1 + what; sphere { 2*A, 1 }", "`what` is not declared.");
        row("#declare T texture { } sphere { 0, 1 texture { T } }",
            "Expected `=` behind the name in `#declare`");
        row("#declare A = <1 ; sphere { A, 1 }", "Expected `>` to close the vector");
        row("#declare rgb 5;", "`rgb` is a word of the language and cannot be declared.");
        row("blob { threshold 1 sphere what }", "Expected `{` to begin `sphere`");
        row("blob { threshold 1 cylinder what }", "Expected `{` to begin `cylinder`");
        row("#default { what }", "`what` is not understood in `#default`");
        row("global_settings { assumed_gamma -1 }", "`assumed_gamma` must be greater than 0.");
        row("global_settings { noise_generator 7 }", "`noise_generator` must be 1, 2 or 3.");
        row("light_source { 0, 1 area_light x, y, 0, 2 }", "An `area_light` has 1 to");

        // What an array would have behind its name is passed over.
        row("#declare B[0] = 5; sphere { 0, 1 }", "`B` is not declared, but `[` asks for an array.");
        row("#declare B[0] =\n5; sphere { 0, 1 }", "`B` is not declared, but `[` asks for an array.");
        row("sphere { 0, dimension_size(B, 1) }", "asks for an array, but this is not declared.");
        row("#declare N = dimension_size(B, 1) + 2; sphere { 0, N }",
            "asks for an array, but this is not declared.");
        row("#declare A = array[2]; #declare B = A[0];", "This element of `A` has not been given a value.");
        row("#declare A = array[1] { pigment { rgb 1 } } sphere { 0, A[0] }",
            "Expected a float, vector, color or string, but this element of `A` is a pigment.");
        row("#declare A = array[2]; #declare B = dimension_size(A, 3);", "expected 1 to 1");
        row("#declare A = array[1] { \"a\" } #declare F = function { A[0] }",
            "This element of `A` is not a float.");
        row("#declare V = <\"a\", 1, 2>;", "Expected a float, but this is a string.");
        row("#declare N = 1; #declare F = function { sum(N, 1, 3, N) }", "needs a new name");
        row("#declare F = function(1) { x }", "Expected the name of a parameter here.");
        row("#declare F = function(a) { spline { 0, 0, 1, 1 } }", "takes no list of parameters");
        row("#declare F = function { x y }", "Expected");

        row("isosurface { function(u, v) { u } }", "An isosurface needs a function of x, y and z");
        row("isosurface { threshold 1 }", "An `isosurface` needs a `function { ... }`.");
        row("isosurface { function { x } contained_by { box { -1, 1 2 } } }", "Expected `}` to close `box`.");
        row("isosurface { function { x } max_trace 99 }", "`max_trace` must be 1 to 10.");
        for (const char* evaluate : {"0, 2, 0.5", "1, 0.5, 0.5", "1, 2, 0", "1, 2, 1.5"})
            row(("isosurface { function { x } evaluate " + std::string(evaluate) + " }").c_str(),
                "it is ignored");
        row("#declare C = camera { } object { C }", "`C` is a camera, not an object.");
        row("#declare F = function { x } object { F }", "`F` is a function, not an object.");
        row("#declare T = transform { scale 2 } object { T }", "`T` is a transform, not an object.");
        row("#declare T = texture { } object { T }", "`T` is a texture, not an object.");
        row("#declare T = finish { } object { T }", "`T` is a finish, not an object.");
        row("#declare T = normal { bumps 1 } object { T }", "`T` is a normal, not an object.");
        row("#declare T = interior { } object { T }", "`T` is an interior, not an object.");
        row("#declare T = spline { 0, 0, 1, 1 } object { T }", "`T` is a spline, not an object.");
        row("sphere { <1, 2, 3, 4>, 1 }", "Expected a vector of 3 components, but this has 4.");
        row("sphere { \"a\", 1 }", "Expected a vector here.");
        row("sphere { 0, 1 matrix <1, 2, 3> }", "`matrix` takes 12 numbers.");
        row("sphere { 0, 1 matrix <0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0> }", "flattens everything");
        row("#declare T = transform { what }", "Expected `translate`, `rotate`, `scale`, `matrix`");

        row("lathe { linear_spline 4, <0, 0>, <1, 1> }", "announces 4 points, but has 2.");
        row("prism { linear_spline 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }",
            "The outline of this prism does not end where it begins");
        row("height_field { function 1, 1 { x } }", "The number of columns of `height_field` must be 2");
        row("height_field { function 9, 9 { \"a\" } }", "Expected");
        row("mesh { triangle { 0, x } }", "Expected a number, a vector or a name, but found `}`.");
        row("mesh { triangle 0 }", "A triangle of this mesh is incomplete.");
        row("mesh { triangle { 0, x, 2*x } }", "whose corners lie on one line are left out: 1.");
        row("mesh2 { vertex_vectors { 3, 0, x } face_indices { 1, <0, 1, 2> } }", "entries too few");
        row("mesh2 { vertex_vectors { 3, 0, x, y, z } face_indices { 1, <0, 1, 2> } }",
            "`vertex_vectors` has more entries than announced.");
        row("mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2>, 7 } }",
            "There is no such texture in the list of this mesh.");
        row("parametric { what }", "Expected the `function` of a coordinate");
        row("parametric { function { u }, function { v }, function { u } <0, 0>, <1, 1> contained_by { cone "
            "{ 0 } } }",
            "Expected `sphere` or `box` in `contained_by`, but found `cone`.");
        row("polygon { 4, 0, x, 2*x, 3*x }", "The points of this polygon lie on one line; it is left out.");
        row("poly { 2, 1 }", "The coefficients of `poly` stand between `<` and `>`.");
        row("quartic { <1, 2> }", "has 35 coefficients, but here are 2.");
        row("text { what }", "Expected `ttf` or `internal` and a font, but found `what`.");

        row("sphere { 0, 1 pigment { magnet 1 what } }", "Expected `mandel` or `julia` behind `magnet`.");
        row("sphere { 0, 1 pigment { mandel 1e9 } }", "is computed with at most");
        row("sphere { 0, 1 pigment { function(a) { a } } }", "A pattern needs a function of x, y and z");
        row("sphere { 0, 1 pigment { density_file df3 \"none.df3\" interpolate 1 } }",
            "There is no file `none.df3`.");
        row("sphere { 0, 1 material { what } }", "`what` is not understood in `material`");
        row("sphere { 0, 1 texture { what } }", "`what` is not understood in `texture`");
    }

    /// The messages of directives there were taken back together with those about the list.
    void whatIsSaidBehindAMistakeIsKept() {
        const ParseResult parsed = parseScene(
            "mesh2 { vertex_vectors { 3, 0, x } face_indices { 1,\n#warning \"said\"\n<0, 1, 2> } }\n");
        QCOMPARE(parsed.diagnostics.size(), std::size_t(2));
        QVERIFY(parsed.diagnostics[1].message.find("said") != std::string::npos);
    }

    void anEndOfReadingIsToldWhereverItComes() {
        for (const char* text : {"x*x + y*y + z*z - 1\n#warning \"read\"\n",
                                 "mesh2 { vertex_vectors { 3, 0, x } f { 1 2 3 4 } }\n#warning \"read\"\n"}) {
            int ended = 0;
            for (std::size_t budget = 1; budget < 120; ++budget) {
                ParseOptions options;
                options.stepBudget = budget;
                bool isRead = false, isEnded = false;
                for (const Diagnostic& diagnostic : parseScene(text, options).diagnostics) {
                    isRead = isRead || diagnostic.message == "read";
                    isEnded = isEnded || diagnostic.message.find("asks for more than") != std::string::npos;
                }
                QVERIFY2(isRead || isEnded, qPrintable(QString::number(budget) + ' ' + text));
                ended += isEnded;
            }
            QVERIFY(ended > 5);
        }
    }

    void misspeltStatementsAreToldEach() {
        const ParseResult parsed = parseScene("shpere { 0, 1 }\nbxo { 0, 1 }\nfoo bar\nbal { 0, 1 }\n");
        QCOMPARE(parsed.diagnostics.size(), std::size_t(4));
        QVERIFY(parsed.diagnostics[1].message.find("`bxo`") != std::string::npos);
        QVERIFY(parsed.diagnostics[2].message.find("`foo`") != std::string::npos);
        QVERIFY(parsed.diagnostics[3].message.find("`bal`") != std::string::npos);
    }

    /// Every statement behind it was a mistake, and none of them was read.
    void aMissingBraceIsToldOnceAndWhatFollowsIsRead_data() {
        QTest::addColumn<QString>("block");
        QTest::addColumn<QString>("closed");
        const auto row = [](const char* block, const char* closed) {
            QTest::newRow(block) << block << closed;
        };
        row("global_settings { assumed_gamma 1", "global_settings");
        row("camera { location -3*z", "camera");
        row("light_source { 9, 1", "light_source");
        row("background { rgb 1", "background");
        row("fog { distance 3", "fog");
        row("sky_sphere { pigment { gradient y }", "sky_sphere");
        row("sky_sphere { pigment { gradient y", "pigment");
        row("sphere { 0, 1", "sphere");
        row("sphere { 0, 1 pigment { rgb 1\n}", "sphere");
        row("sphere { 0, 1 pigment { rgb 1\nfinish { phong 1 } }", "pigment");
        row("sphere { 0, 1 texture { pigment { rgb 1 } finish { phong 1", "finish");
        row("isosurface { function { x\nmax_gradient 3 }", "function");
        row("isosurface { function { x } max_gradient 3", "isosurface");
        row("#declare T = texture { pigment { rgb 1 }", "texture");
        row("#declare S = sphere { 0, 1", "sphere");
        row("#if (1) fog { distance 3\n#end", "fog");
        row("#macro M() sphere { 0, 1\n#end\nM()", "sphere");
        row("#default { finish { phong 1 }", "#default");
        row("#declare K = 3; #while (K > 0) sphere { 0, 1\nfog { distance 3 } #declare K = K - 1; #end",
            "sphere");
    }
    void aMissingBraceIsToldOnceAndWhatFollowsIsRead() {
        QFETCH(QString, block);
        QFETCH(QString, closed);
        const std::string text = "#version 3.7;\n" + block.toStdString() + "\n",
                          rest =
                              "global_settings { charset utf8 }\ncamera { location -5*z look_at 0 }\n"
                              "\tplane { y, -1 pigment { rgb 1 } }\nbox { 0, 1 pigment { rgb 1 } }\n";
        const ParseResult parsed = parseScene(text + rest);
        QStringList told;
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.severity != Severity::note) told += QString::fromStdString(diagnostic.message);
        QVERIFY2(told.size() == 1 && told[0].startsWith("Expected `}` to close `" + closed + "` before `"),
                 qPrintable(told.join(" | ")));
        QCOMPARE(parsed.scene->camera.location[2], -5.0);
        QVERIFY(parsed.scene->objects.size() >= 2);
        // The fix is the brace, behind what was there; each of several has its own.
        std::string mended = text + rest;
        for (int braces = 0; braces < 3 && !parseScene(mended).ok(); ++braces) {
            const std::vector<Diagnostic> left = parseScene(mended).diagnostics;
            const auto mistake = std::find_if(left.begin(), left.end(), [](const Diagnostic& diagnostic) {
                return diagnostic.severity == Severity::error;
            });
            QVERIFY(mistake->fixes.size() == 1 && mistake->fixes[0].replacement == " }");
            mended.insert(mistake->fixes[0].range.begin, " }");
        }
        QVERIFY2(parseScene(mended).ok(), mended.c_str());
    }

    /// It was left out.
    void anObjectThatTheTextLeavesOpenIsThere() {
        const std::string begun = "#version 3.7;\ncamera { look_at 0 }\n";
        for (const char* object :
             {"sphere { 0, 1 pigment { rgb 1 }\n", "union { sphere { 0, 1 }\nbox { 0, 1 }",
              "isosurface { function { x } // }\n"}) {
            const ParseResult parsed = parseScene(begun + object);
            QVERIFY2(!parsed.scene->objects.empty(), object);
            std::vector<Diagnostic> told;
            for (const Diagnostic& diagnostic : parsed.diagnostics)
                if (diagnostic.severity == Severity::error) told.push_back(diagnostic);
            QVERIFY2(told.size() == 1 && told[0].fixes.size() == 1, object);
            std::string mended = begun + object;
            mended.insert(told[0].fixes[0].range.begin, told[0].fixes[0].replacement);
            QVERIFY2(parseScene(mended).ok(), mended.c_str());
        }
        const ParseResult function = parseScene(begun + "isosurface { function { x*x + y*y + z*z - 1");
        QCOMPARE(function.scene->objects.size(), std::size_t(1));
        // Nothing is said of what had not been typed yet.
        const ParseResult parsed = parseScene(begun + "isosurface { max_gradient 3");
        QCOMPARE(
            std::count_if(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                          [](const Diagnostic& diagnostic) { return diagnostic.severity != Severity::note; }),
            1);
    }

    /// What was between them was read word by word, as so many mistakes.
    void aMissingOpeningBraceIsToldOnceAndTheBlockIsRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("fixed");
        QTest::newRow("missing") << "sphere 0, 1 pigment { rgb 1 } }" << true;
        QTest::newRow("replaced") << "sphere what 0, 1 pigment { rgb 1 } }" << false;
        QTest::newRow("behind a word") << "sphere what { 0, 1 pigment { rgb 1 } }" << false;
        QTest::newRow("inside") << "sphere { 0, 1 pigment rgb 1 } }" << true;
        QTest::newRow("component") << "blob { threshold 0.5 sphere 0, 1, 1 } pigment { rgb 1 } }" << true;
        QTest::newRow("twice") << "sphere { 0, 1 texture pigment rgb 1 } } }" << true;
        QTest::newRow("function") << "isosurface { function x } pigment { rgb 1 } }" << true;
        QTest::newRow("map") << "sphere { 0, 1 pigment { gradient y color_map [0 rgb 1] [1 rgb 0] } } }"
                             << true;
        QTest::newRow("declared") << "#declare S = sphere 0, 1 pigment { rgb 1 } }\nobject { S }" << true;
        QTest::newRow("loop") << "union { #for (K, 1, 3) sphere 0, 1 pigment { rgb 1 } } #end }" << true;
        QTest::newRow("argument") << "#macro M(P) sphere { 0, 1 pigment { P } } #end\nM(pigment rgb 1 })"
                                  << true;
    }
    void aMissingOpeningBraceIsToldOnceAndTheBlockIsRead() {
        QFETCH(QString, text);
        QFETCH(bool, fixed);
        std::string scene = text.toStdString() + "\nbox { 0, 1 pigment { rgb 1 } }\n";
        const std::size_t mistakes = QTest::currentDataTag() == std::string("twice") ? 2 : 1;
        for (std::size_t left = mistakes; left > 0; --left) {
            const ParseResult parsed = parseScene(scene);
            QVERIFY(parsed.scene->objects.size() >= 2);
            std::vector<Diagnostic> told;
            for (const Diagnostic& diagnostic : parsed.diagnostics)
                if (diagnostic.severity == Severity::error) told.push_back(diagnostic);
            QCOMPARE(told.size(), left);
            QVERIFY2(told[0].message.starts_with("Expected `{` to begin"), told[0].message.c_str());
            QCOMPARE(told[0].fixes.size(), std::size_t(fixed));
            if (fixed) scene.insert(told[0].fixes[0].range.begin, told[0].fixes[0].replacement);
        }
        QCOMPARE(parseScene(scene).ok(), fixed);
    }

    /// Where braces are even, and in the middle of a line, what cannot stand there is passed over.
    void noBraceIsMissingWhereTheyAreEven() {
        for (const char* text : {"camera { location -3*z\nsphere { 0, 1 }\nlook_at 0 }\n",
                                 "camera { location -3*z // {\nsphere { 0, 1 }\nlook_at 0 }\n",
                                 "camera { location -3*z sphere { 0, 1 } look_at 0 }\nsphere { 0, 1\n"}) {
            const ParseResult parsed = parseScene(text);
            QVERIFY(!parsed.diagnostics.empty());
            QCOMPARE(parsed.diagnostics[0].message, std::string("`sphere` is not understood in `camera`."));
            // It was taken for `Sphere` of shapes_old.inc.
            QCOMPARE(parsed.diagnostics[0].hint, std::string());
        }
    }

    /// Two of them have one each, and not more: what is behind the second may have no block around it.
    void asManyBracesAreSuppliedAsAreMissing() {
        const ParseResult parsed =
            parseScene("fog { distance 1\nsphere { 0, 1\ncamera { look_at 0 }\nfinish { }\n");
        std::vector<std::string> told;
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.severity == Severity::error) told.push_back(diagnostic.message);
        QCOMPARE(told.size(), std::size_t(3));
        QCOMPARE(told[0], std::string("Expected `}` to close `fog` before `sphere`."));
        QCOMPARE(told[1], std::string("Expected `}` to close `sphere` before `camera`."));
    }

    /// What was left of its condition was true again and again, until the budget was spent.
    void aLoopWithAMistakeInItsConditionEnds() {
        for (const char* loop : {"#while (I < 3) #warning \"round\" #declare I = 0; #end",
                                 "#while 1) #warning \"round\" #end", "#while (1 #warning \"round\" #end"}) {
            const ParseResult parsed = parseScene(loop);
            QVERIFY2(parsed.diagnostics.size() < 5, loop);
            for (const Diagnostic& diagnostic : parsed.diagnostics) QVERIFY(diagnostic.id != "loop-cut-off");
        }
    }

    /// Behind a call without its `)` reading went on in the body of the next macro, round and round.
    void aCallWithoutItsParenthesisIsToldOnce() {
        const ParseResult parsed = parseScene(
            "#macro Ball(Place) sphere { Place, 1 pigment { rgb 1 } } #end\nBall(x\nBall(y)\nBall(z)\n");
        std::vector<Diagnostic> told;
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.severity == Severity::error) told.push_back(diagnostic);
        QCOMPARE(told.size(), std::size_t(1));
        QVERIFY2(told[0].message.find("before this call") != std::string::npos, told[0].message.c_str());
        QCOMPARE(parsed.scene->objects.size(), std::size_t(2));
    }

    void aMistakeIsToldOnce() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const ParseResult parsed = parseScene(text.toStdString() + "\n#warning \"what follows is read\"\n");
        QStringList told;
        bool goesOn = false;
        for (const Diagnostic& diagnostic : parsed.diagnostics) {
            const QString words = QString::fromStdString(diagnostic.message);
            if (words.contains("what follows is read"))
                goesOn = true;
            else if (diagnostic.severity == Severity::error || diagnostic.severity == Severity::warning)
                told += words;
        }
        QVERIFY2(told.size() == 1 && told[0].contains(message), qPrintable("told: " + told.join(" | ")));
        QVERIFY2(goesOn, "what follows is not read");
    }
};

QTEST_APPLESS_MAIN(ToldMistakesTest)
#include "told_mistakes_test.moc"
