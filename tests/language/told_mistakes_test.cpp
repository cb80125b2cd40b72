// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

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
        row("#default { what }", "`what` is not understood in `#default`");
        row("global_settings { assumed_gamma -1 }", "`assumed_gamma` must be greater than 0.");
        row("global_settings { noise_generator 7 }", "`noise_generator` must be 1, 2 or 3.");
        row("light_source { 0, 1 area_light x, y, 0, 2 }", "An `area_light` has 1 to");

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
        row("sphere { 0, 1 pigment { density_file df3 \"none.df3\" } }", "There is no file `none.df3`.");
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
