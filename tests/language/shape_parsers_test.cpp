// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/shape_parser.h"

#include <algorithm>
#include <cmath>
#include <QTest>

#include "core/language/directives/library_paths.h"
#include "core/language/objects/object_description.h"
#include "core/language/parse.h"
#include "core/shapes/isosurface/julia_fractal.h"
#include "core/shapes/solids/poly.h"

using namespace isoscope;

namespace {

/// "severity: message [marked text]" of every diagnostic but notes.
QStringList complaints(const ParseResult& parsed) {
    QStringList all;
    for (const Diagnostic& diagnostic : parsed.diagnostics) {
        if (diagnostic.severity == Severity::note) continue;
        const std::string marked(parsed.sources->slice(diagnostic.range));
        all << QString::fromStdString(
            std::string(diagnostic.severity == Severity::error ? "error" : "warning") + ": " +
            diagnostic.message + " [" + marked + "]");
    }
    return all;
}

}  // namespace

class ShapeParsersTest : public QObject {
    Q_OBJECT

  private slots:
    /// The tutorials disagree about where the number may follow: everywhere.
    void sturmTakesAnOptionalNumber_CONF_87() {
        for (const char* word : {"sturm", "sturm on", "sturm off", "sturm 0", "sturm 1"}) {
            const std::string sturm(word);
            const ParseResult parsed =
                parseScene("blob { threshold 0.5 sphere { 0, 1, 1 } " + sturm + " }\ntorus { 1, 0.2 " +
                           sturm + " }\nlathe { cubic_spline 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> " + sturm +
                           " }\nprism { 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> " + sturm +
                           " }\nsor { 4, <0.3, -0.5>, <0.5, 0>, <1, 1>, <0.5, 2> " + sturm + " }\n" +
                           "poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> " + sturm + " }");
            QCOMPARE(complaints(parsed), QStringList());
            QCOMPARE(parsed.scene->objects.size(), 6U);
        }
    }

    /// POV-Ray 3.7.0.10 takes it as well, undocumented: terms in any order, powers without what is behind
    /// their points, the last of two that are the same; its pictures of both statements are the same.
    void polynomialsAreMadeOfTerms() {
        const ParseResult parsed = parseScene(
            "#declare Terms = polynomial { 4, xyz(0,0,0): -9 xyz(4,0,0): 0.5 + 0.5, xyz(1.9,2,0): 3, "
            "xyz(0,1,2): -2, xyz(0, 0, 3) : 7 xyz(0,0,0): -1 sturm scale 1 }\n"
            "#declare List = poly { 4, <1,0,0,0,0,0,0,0,0,0, 0,0,3,0,0,0,0,0,0,0, 0,0,0,0,0,0,0,-2,0,0, "
            "0,7,0,0,-1> "
            "}");
        QCOMPARE(complaints(parsed), QStringList());
        const auto coefficients = [&](const char* name) {
            const ShapePointer shape = declaredShape(parsed, name);
            const auto* poly = dynamic_cast<const Poly*>(shape.get());
            return poly ? poly->coefficients() : std::vector<double>();
        };
        QCOMPARE(coefficients("Terms").size(), Poly::termCount(4));
        QVERIFY(coefficients("Terms") == coefficients("List"));
        const auto& sliders = parsed.scene->parameters;
        QVERIFY(std::any_of(sliders.begin(), sliders.end(), [](const SceneParameter& slider) {
            return slider.group == "polynomial" && slider.name == "yz2" && slider.value == -2;
        }));
    }

    /// Each term is where poly's list has it, for the largest order too.
    void everyTermOfAPolynomialHasItsPlace() {
        for (const int order : {2, 3, 7, 35}) {
            std::size_t index = 0;
            for (int x = order; x >= 0; --x)
                for (int y = order - x; y >= 0; --y)
                    for (int z = order - x - y; z >= 0; --z, ++index) {
                        if (order == 35 && index % 97 != 0) continue;
                        const ParseResult parsed = parseScene(
                            "#declare P = polynomial { " + std::to_string(order) + " xyz(" +
                            std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "): 5 }");
                        const ShapePointer shape = declaredShape(parsed, "P");
                        const auto* poly = dynamic_cast<const Poly*>(shape.get());
                        QVERIFY(poly && poly->coefficients().at(index) == 5);
                    }
        }
    }

    void termsHaveTheirNames() {
        const ParseResult parsed =
            parseScene("cubic { <1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20> }");
        QStringList names;
        for (const SceneParameter& parameter : parsed.scene->parameters)
            names << QString::fromStdString(parameter.name);
        QCOMPARE(names.join(' '),
                 QString("x3 x2y x2z x2 xy2 xyz xy xz2 xz x y3 y2z y2 yz2 yz y z3 z2 z constant"));
    }

    void precisionOfJuliaSetsIsOneAtLeast_CONF_04() {
        const ParseResult parsed = parseScene(
            "#declare Low = julia_fractal { <-0.1, 0.5, 0, 0> precision 0.25 }\n"
            "#declare High = julia_fractal { <-0.1, 0.5, 0, 0> precision 30 }\n"
            "#declare Left = julia_fractal { <-0.1, 0.5, 0, 0> }");
        const auto precision = [&](const char* name) {
            const ShapePointer shape = declaredShape(parsed, name);
            const auto* julia = dynamic_cast<const JuliaFractal*>(shape.get());
            return julia ? julia->settings().precision : -1;
        };
        QCOMPARE(precision("Low"), 1.0);
        QCOMPARE(precision("High"), 30.0);
        QCOMPARE(precision("Left"), 20.0);
    }

    /// POV-Ray 3.7 takes the square instead. With the parameter 0 the set of the cube is, in each half of the
    /// pair, the disc |z| <= 1, as for the square; its escape after two iterations is at another radius.
    void hypercomplexCubeIsACube_CONF_94() {
        const ParseResult parsed = parseScene(
            "#declare Cube = julia_fractal { <0, 0, 0, 0> hypercomplex cube max_iteration 2 precision 1000 "
            "}\n"
            "#declare Square = julia_fractal { <0, 0, 0, 0> hypercomplex sqr max_iteration 2 precision 1000 "
            "}");
        TraceContext context;
        const auto edgeOf = [&](const char* name) {
            const ShapePointer shape = declaredShape(parsed, name);
            double in = 0, out = 4;
            for (int step = 0; step < 60; ++step)
                (shape->contains({(in + out) / 2, 0, 0}, context) ? in : out) = (in + out) / 2;
            return in;
        };
        // On the x axis both halves are x: |x^3| = 4 and |x^2| = 4.
        QVERIFY(std::abs(edgeOf("Cube") - std::cbrt(4.0)) < 1e-9);
        QVERIFY(std::abs(edgeOf("Square") - 2) < 1e-9);
    }

    void explainsMistakes_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("complaint");
        const auto row = [](const char* text, const char* complaint) {
            QTest::newRow(text) << QString(text) << QString(complaint);
        };
        row("cylinder { <1, 2, 3>, <1, 2, 3>, 1 }",
            "error: Both ends of this `cylinder` are the same point. [<1, 2, 3>]");
        row("plane { <0, 0, 0>, 1 }", "error: The normal of a plane must have a length. [<0, 0, 0>]");
        row("disc { 0, 0*y, 1 }", "error: The normal of a disc must have a length. [0*y]");
        row("cubic { <1, 2, 3> }",
            "error: A polynomial of order 3 has 20 coefficients, but here are 3. [<1, 2, 3>]");
        row("poly { 36, <1> }", "error: The order of `poly` must be 2 to 35. [36]");
        row("polynomial { 3, xyz(4,0,0): 1 }",
            "error: The powers of a term of this polynomial are not negative, and their sum is at most 3. "
            "[xyz(4,0,0)]");
        row("polynomial { 3, xyz(-1,0,0): 1 }",
            "error: The powers of a term of this polynomial are not negative, and their sum is at most 3. "
            "[xyz(-1,0,0)]");
        row("polynomial { 36 }", "error: The order of `polynomial` must be 2 to 35. [36]");
        row("polynomial { 2, xyz(1,0,0) 1 }",
            "error: Expected `:` and the coefficient behind the powers, but found `1`. [1]");
        row("polygon { 4, <0, 0>, <1, 0>, <1, 1> }",
            "error: This polygon announces 4 points, but has 3. [polygon { 4, <0, 0>, <1, 0>, <1, 1>]");
        row("triangle { 0, x, 2*x }",
            "warning: The corners of this triangle lie on one line; it is left out. [triangle { 0, x, 2*x]");
        row("superellipsoid { <1, 0> }",
            "error: Both exponents of a superellipsoid must be greater than 0. [<1, 0>]");
        row("superellipsoid { <0, 1> }",
            "error: Both exponents of a superellipsoid must be greater than 0. [<0, 1>]");
        row("blob { threshold 0.5 }", "error: A blob needs at least one component. [blob]");
        row("blob { threshold -1 sphere { 0, 1, 1 } }",
            "error: The threshold of a blob must be greater than 0. [-1]");
        row("lathe { bezier_spline 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 2> }",
            "error: The number of points of a `bezier_spline` must be a multiple of 4. [lathe { "
            "bezier_spline 5, <0, "
            "0>, <1, 0>, <1, 1>, <0, 1>, <0, 2>]");
        row("prism { 0, 1, 3, <0, 0>, <1, 0>, <0, 1> }",
            "warning: The outline of this prism does not end where it begins; a line closes it. [prism { 0, "
            "1, 3, <0, "
            "0>, <1, 0>, <0, 1>]");
        row("sphere_sweep { 2, 0, 1, x, 1 }",
            "error: Expected the kind of spline of this `sphere_sweep`, but found `2`. [2]");
        row("mesh { }", "warning: This mesh has no triangles. [mesh]");
        row("mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 3> } }",
            "error: An index of `face_indices` lies outside 0 to 2. [<0, 1, 3>]");
        row("julia_fractal { <1, 0, 0, 0> sin }",
            "error: Quaternions know only `sqr` and `cube`. [julia_fractal]");
        row("julia_fractal { <1, 0, 0, 0> slice <1, 1, 1, 0>, 0 }",
            "error: The fourth component of the slice of a `julia_fractal` must not be 0. [<1, 1, 1, 0>]");
        row("height_field { png \"nowhere.png\" }",
            "error: The image \"nowhere.png\" was not found beside the scene or in the library paths. "
            "[\"nowhere.png\"]");
        row("text { ttf \"nowhere.ttf\" \"A\" 1, 0 }",
            "error: The font \"nowhere.ttf\" was not found beside the scene or in the library paths. "
            "[\"nowhere.ttf\"]");
        row("bicubic_patch { type 1 u_steps 3 v_steps 3 <0, 0, 0>, <1, 0, 0> }",
            "error: A bicubic patch has 16 points, but here are 2. [bicubic_patch { type 1 u_steps 3 v_steps "
            "3 <0, 0, "
            "0>, <1, 0, 0>]");
        row("torus { 1e999, 1 }", "error: The numbers of this `torus` are not all finite. [torus]");
        row("torus { 1, 0.2 wobble 3 }", "error: `wobble` is not understood in `torus`. [wobble]");
    }
    void explainsMistakes() {
        QFETCH(QString, text);
        QFETCH(QString, complaint);
        const ParseResult parsed = parseScene(text.toStdString());
        QVERIFY2(complaints(parsed).contains(complaint), qPrintable(complaints(parsed).join("\n")));
    }

    /// Bytes that are no UTF-8 are Latin-1: both spell the same letter.
    void textsAreUtf8OrLatin1() {
        if (installedLibraryPaths().empty()) QSKIP("POV-Ray's fonts are not installed");
        ParseOptions options;
        options.libraryPaths = installedLibraryPaths();
        const auto widthOf = [&](const std::string& letters) {
            const ParseResult parsed = parseScene(
                "text { ttf \"cyrvetic.ttf\", \"" + letters + "\", 1, 0 pigment { rgb 1 } }", options);
            return parsed.scene->objects.at(0).shape->bounds().high.x;
        };
        QCOMPARE(widthOf("W\u00fcW"), widthOf("W\xfcW"));
        QVERIFY(widthOf("W\u00fcW") != widthOf("W\u00ecW"));
    }

    void waterLevelsAreFromZeroToOne() {
        const auto said = [](const std::string& level) {
            return complaints(parseScene("height_field { function 3, 3 { 0.5 } water_level " + level + " }"));
        };
        QCOMPARE(said("0"), QStringList());
        QCOMPARE(said("1"), QStringList());
        QCOMPARE(said("1.01").size(), 1);
        QCOMPARE(said("-0.01").size(), 1);
    }

    void outlinesAreClosedByALine() {
        const ParseResult parsed = parseScene(
            "#declare Closed = prism { -0.5, 0.5, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }\n"
            "#declare Open = prism { -0.5, 0.5, 4, <-1, -1>, <1, -1>, <1, 1>, <-1, 1> }");
        const ShapePointer closed = declaredShape(parsed, "Closed"), open = declaredShape(parsed, "Open");
        QVERIFY(closed && open);
        TraceContext context;
        for (double x = -1.25; x <= 1.25; x += 0.5)
            for (double z = -1.25; z <= 1.25; z += 0.5) {
                const bool wanted = std::abs(x) < 1 && std::abs(z) < 1;
                QCOMPARE(closed->contains({x, 0.1, z}, context), wanted);
                QCOMPARE(open->contains({x, 0.1, z}, context), wanted);
            }
    }

    /// Corners and normals stand where the kind of triangle has them.
    void meshesHaveBothKindsOfTriangles() {
        const ParseResult parsed = parseScene(
            "mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> } "
            "smooth_triangle { <-1, -1, 2>, z, <1, -1, 2>, z, <0, 1, 2>, x } }");
        QCOMPARE(complaints(parsed), QStringList());
        TraceContext context;
        HitList hits;
        parsed.scene->objects.at(0).shape->intersect({{0, 0, -5}, {0, 0, 1}}, {}, context, hits);
        QCOMPARE(hits.size(), std::size_t(2));
    }

    /// A part ends where its first point comes again, be it at once.
    void partsOfPrismsMayBeOnePoint() {
        const ParseResult parsed =
            parseScene("prism { linear_spline 0, 1, 6, <9, 9>, <9, 9>, <0, 0>, <1, 0>, <0, 1>, <0, 0> }");
        QCOMPARE(complaints(parsed), QStringList());
        TraceContext context;
        QVERIFY(parsed.scene->objects.at(0).shape->contains({0.25, 0.5, 0.25}, context));
        QVERIFY(!parsed.scene->objects.at(0).shape->contains({0.75, 0.5, 0.75}, context));
    }

    /// Too small a number was also said to be that of the points, of which there were too few then.
    void aWrongCountIsSaidOnce() {
        for (const char* text : {"sor { 3, <0, 0>, <1, 1>, <2, 2> }", "lathe { 1, <0, 0> }",
                                 "polygon { 2, 0, x }", "sphere_sweep { linear_spline 1, 0, 1 }"}) {
            const ParseResult parsed = parseScene(text);
            const auto errors =
                std::count_if(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                              [](const Diagnostic& one) { return one.severity == Severity::error; });
            QVERIFY2(errors == 1, qPrintable(complaints(parsed).join("\n")));
        }
    }

    /// POV-Ray refuses them in unions.
    void cutawayTexturesAskForACut() {
        const auto said = [](const std::string& keyword) {
            const ParseResult parsed =
                parseScene(keyword + " { box { -1, 1 pigment { rgb 1 } } sphere { 1, 1 } cutaway_textures }");
            return std::any_of(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                               [](const Diagnostic& one) {
                                   return one.message.find("cutaway_textures") != std::string::npos;
                               });
        };
        QVERIFY(!said("difference"));
        QVERIFY(!said("intersection"));
        QVERIFY(said("union"));
        QVERIFY(said("merge"));
    }

    /// Each of 100 levels is made once more: of up to 10 000 shapes.
    void cutawayTexturesOfManyShapesAreLeftOut() {
        for (const int spheres : {1, 2}) {
            const ParseResult parsed = parseScene(
                "#declare Row = union { #for (I, 1, 99) sphere { I*x, 1 } #end }\n"
                "#declare U = union { #for (I, 1, 99) object { Row } #end #for (I, 1, " +
                std::to_string(spheres) +
                ") sphere { I*y, 1 } #end }\n"
                "#for (I, 1, 96) #declare U = union { object { U } } #end\n"
                "#declare D = difference { object { U } sphere { 0, 1 } cutaway_textures }\n"
                "sphere { 0, 1 }");  // else what is declared is drawn
            const ObjectPointer object = std::get<ObjectPointer>(parsed.symbols->find("D")->data);
            QCOMPARE(object->depth, 100);
            QCOMPARE(object->shapeCount, std::size_t(9'999 + spheres));
            QCOMPARE(object->cutawayTextures, spheres == 1);
            QCOMPARE(complaints(parsed).size(), spheres - 1);
        }
    }

    void leavesTheRestOfTheSceneInPlace() {
        const ParseResult parsed = parseScene(
            "cylinder { 0, 0, 1 }\nblob { }\nsphere { 0, 1 }\nunion { torus { 1, 0.2 } cubic { <1> } }\n");
        QCOMPARE(parsed.scene->objects.size(), std::size_t{2});
    }

    void numbersBecomeSliders() {
        const ParseResult parsed = parseScene("torus { 1.5, 0.25 }\ncone { <0, -1, 2>, 0.5, y*3, 0 }\n");
        QStringList names;
        for (const SceneParameter& parameter : parsed.scene->parameters)
            names << QString::fromStdString(parameter.group + " " + parameter.name) +
                         QString(" %1").arg(parameter.value);
        QCOMPARE(names, (QStringList{"torus major radius 1.5", "torus minor radius 0.25", "cone base x 0",
                                     "cone base y -1", "cone base z 2", "cone base radius 0.5",
                                     "cone cap radius 0"}));
    }

    void pointsAreCountedFromOne() {
        const ParseResult parsed = parseScene("lathe { 2, <3, 0>, <4, 1> }");
        QStringList names;
        for (const SceneParameter& parameter : parsed.scene->parameters)
            names << QString::fromStdString(parameter.name);
        QCOMPARE(names, (QStringList{"point 1 x", "point 1 y", "point 2 x", "point 2 y"}));
    }

    void openEndsAndOptionsAreRead() {
        const ParseResult parsed = parseScene(
            "cylinder { 0, y, 1 open }\ntorus { 1, 0.2 sturm }\nsor { 4, <0.3, -0.5>, <0.5, 0>, <1, 1>, "
            "<0.8, 2> open "
            "sturm }\nprism { conic_sweep linear_spline 0.5, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> open }\n"
            "blob { sphere { 0, 1, strength 2 scale 2 } component 1, 1, <1, 0, 0> threshold 0.5 hierarchy "
            "off sturm }\n");
        QVERIFY2(parsed.ok(), qPrintable(complaints(parsed).join("\n")));
        QCOMPARE(parsed.scene->objects.size(), std::size_t{5});
        // The tube is open: a ray along its axis meets nothing.
        TraceContext context;
        HitList hits;
        parsed.scene->objects[0].shape->intersect({{0.1, 5, 0}, {0, -1, 0}}, {}, context, hits);
        QVERIFY(hits.empty());
    }
};

QTEST_APPLESS_MAIN(ShapeParsersTest)
#include "shape_parsers_test.moc"
