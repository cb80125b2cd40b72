// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <cstdlib>
#include <QTest>

#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int width = 160;
constexpr int height = 120;
constexpr double wantedShare = 0.97;

/// A camera, two lights and a floor around one object.
std::string sceneOf(const QString& object) {
    return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb <0.2, 0.3, 0.5> }\n"
           "camera { location <1.5, 2.2, -4.5> right x*4/3 angle 40 look_at <0, 0, 0> }\n"
           "light_source { <-6, 9, -8>, rgb 0.8 }\nlight_source { <8, 3, -6>, rgb 0.3 shadowless }\n"
           "plane { y, -1.2 pigment { rgb <0.7, 0.7, 0.6> } }\n"
           "#default { texture { pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.4 phong_size 30 } } }\n" +
           object.toStdString() + "\n";
}

}  // namespace

/// One small scene for each shape, beside POV-Ray's picture of the same text.
class ShapePicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void looksAsInPovray_PRIM_GEN_data() {
        QTest::addColumn<QString>("object");
        const auto add = [](const char* name, const char* object) { QTest::newRow(name) << QString(object); };
        add("cylinder", "cylinder { <-1, -0.5, 0>, <0.8, 0.6, 0.3>, 0.6 }");
        add("cylinder_open", "cylinder { -y, y, 0.8 open rotate <40, 0, 30> }");
        add("cone", "cone { <0, -1.1, 0>, 1, <0.3, 1.2, 0>, 0.2 }");
        add("cone_open", "cone { <0, -1, 0>, 0.4, <0, 0.8, 0>, 1.1 open rotate -30*x }");
        add("torus", "torus { 1, 0.35 rotate <-30, 0, 20> }");
        add("torus_spindle", "torus { 0.4, 0.7 rotate <-40, 0, 20> }");
        add("disc", "disc { 0, <0.3, 1, -1>, 1.2, 0.4 }");
        add("triangle", "triangle { <-1, -1, 0>, <1.2, -0.5, 0.5>, <0, 1.2, 0> }");
        add("smooth_triangle",
            "smooth_triangle { <-1, -1, 0>, <-1, -1, -1>, <1.2, -1, 0>, <1, -1, -1>, <0, 1.2, 0>, <0, 1, -1> "
            "}");
        add("polygon",
            "polygon { 10, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <-0.5, -0.5>, <0.5, -0.5>, "
            "<0.5, 0.5>, <-0.5, 0.5>, <-0.5, -0.5> rotate <20, 30, 0> }");
        add("mesh",
            "mesh { triangle { <-1, -1, -1>, <1, -1, -1>, <0, 1, 0> } "
            "triangle { <1, -1, -1>, <1, -1, 1>, <0, 1, 0> } triangle { <-1, -1, 1>, <-1, -1, -1>, <0, 1, 0> "
            "} }");
        add("mesh2",
            "mesh2 { vertex_vectors { 4, <-1, -1, -0.5>, <1, -1, -0.5>, <1, 1, 0.5>, <-1, 1, 0.5> } "
            "normal_vectors { 4, <-1, -1, -2>, <1, -1, -2>, <1, 1, -2>, <-1, 1, -2> } "
            "face_indices { 2, <0, 1, 2>, <0, 2, 3> } }");
        add("quadric",
            "quadric { <1, -0.6, 1>, <0, 0, 0>, <0, 0, 0>, -0.3 clipped_by { box { -1.1, 1.1 } } }");
        add("cubic",
            "cubic { <1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0> "
            "clipped_by { sphere { 0, 1.3 } } rotate 60*y }");
        add("quartic",
            "quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.32, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, "
            "1.68, 0, 0, 0, 0, 1, 0, -2.32, 0, 0.7056> sturm rotate -40*x }");
        add("superellipsoid", "superellipsoid { <0.3, 0.2> scale 0.9 rotate <20, 30, 0> }");
        // These took for ever: powers of small exponents are too small for doubles.
        add("superellipsoid_square_across", "superellipsoid { <1e-3, 0.5> scale 0.9 rotate <20, 30, 0> }");
        add("superellipsoid_square_along", "superellipsoid { <0.5, 1e-4> scale 0.9 rotate <20, 30, 0> }");
        add("superellipsoid_limit", "superellipsoid { <1e-300, 0.5> scale 0.9 rotate <20, 30, 0> }");
        add("superellipsoid_star", "superellipsoid { <2.5, 2.5> scale 1.2 rotate <20, 30, 0> }");
        add("blob",
            "blob { threshold 0.6 sphere { <0.75, 0, 0>, 1, 1 } sphere { <-0.375, 0.65, 0>, 1, 1 } "
            "cylinder { <-0.4, -0.6, 0.4>, <0.4, -0.6, -0.6>, 0.7, 1.2 } sphere { <0, 0.1, -0.9>, 0.5, -1 } "
            "}");
        add("sor",
            "sor { 7, <0, 0> <0.118143, 0> <0.620253, 0.540084> <0.210970, 0.827004> <0.194093, 0.962025> "
            "<0.286920, 1> <0.468354, 1.033755> open scale 2 translate -1.1*y }");
        add("lathe",
            "lathe { cubic_spline 7, <0.6, 1>, <1, 0>, <1.4, 0.5>, <1.2, 1.2>, <0.6, 1>, <1, 0>, <1.4, 0.5> "
            "sturm translate -0.5*y rotate -30*x }");
        add("lathe_linear", "lathe { linear_spline 5, <0.5, -1>, <1, -0.8>, <0.4, 0>, <1, 0.9>, <0.2, 1> }");
        add("prism",
            "prism { cubic_spline -0.4, 0.4, 8, <-1, 0.5>, <0, -1>, <1, 0>, <0.3, 0.3>, <0, 1>, <-1, 0>, "
            "<0, -1>, <1, 0> rotate -50*x }");
        add("prism_conic",
            "prism { conic_sweep linear_spline 0.2, 1.6, 5, <0.7, 0.7>, <-0.7, 0.7>, <-0.7, -0.7>, "
            "<0.7, -0.7>, <0.7, 0.7> translate -0.9*y rotate 20*y }");
        add("parametric",
            "parametric { function { sin(u)*cos(v) } function { 1.2*cos(u) } function { sin(u)*sin(v) } "
            "<0, 0>, <pi, 2*pi> contained_by { box { <-0.9, -1.3, -1.1>, 1.3 } } accuracy 0.01 "
            "max_gradient 1.5 precompute 16 x, y, z }");
        add("sphere_sweep",
            "sphere_sweep { cubic_spline 6, <-1, -1.5, 0>, 0.3, <-1, 0.8, 0>, 0.25, <1, -0.6, 0.3>, "
            "0.4, <1, 1, 0>, 0.2, <-0.5, 0.7, 0.6>, 0.25, <-1, 0, 0>, 0.3 }");
        add("sphere_sweep_linear",
            "sphere_sweep { linear_spline 3, <-1, -0.7, 0>, 0.4, <0, 0.8, 0>, 0.2, "
            "<1.1, -0.3, 0>, 0.5 }");
        add("height_field",
            "height_field { function 60, 60 { 0.4 + 0.3*sin(9*x)*cos(7*y) } translate -0.5 "
            "scale <3, 1, 3> }");
        add("height_field_smooth",
            "height_field { function 20, 30 { 0.4 + 0.3*sin(9*x)*cos(7*y) } smooth "
            "water_level 0.2 translate -0.5 scale <3, 1, 3> rotate 20*y }");
        add("text", "text { ttf \"timrom.ttf\" \"Iso AV\" 0.3, 0.02*x translate <-1.2, -0.3, 0> scale 1.2 }");
        add("bicubic_patch",
            "bicubic_patch { type 1 flatness 0 u_steps 5 v_steps 5 <-1.5, 0.3, -1.5>, <-0.5, -0.12, "
            "-1.5>, <0.5, -0.12, -1.5>, <1.5, 0.3, -1.5>, <-1.5, -0.24, -0.5>, <-0.5, 1.12, -0.5>, "
            "<0.5, 0.12, -0.5>, <1.5, -0.24, -0.5>, <-1.5, 0, 0.5>, <-0.5, 0.36, 0.5>, <0.5, 1.36, "
            "0.5>, <1.5, 0, 0.5>, <-1.5, 0.24, 1.5>, <-0.5, -0.18, 1.5>, <0.5, -0.18, 1.5>, <1.5, "
            "0.24, 1.5> }");
        const QString bent =
            "<-1.5, -1.5, 0> <-0.5, -1.5, 1> <0.5, -1.5, -1> <1.5, -1.5, 0> <-1.5, -0.5, 0.5> <-0.5, -0.5, "
            "-2>"
            "<0.5, -0.5, 1> <1.5, -0.5, 0> <-1.5, 0.5, 0.3> <-0.5, 0.5, 0> <0.5, 0.5, -1> <1.5, 0.5, 0.6>"
            "<-1.5, 1.5, 0> <-0.5, 1.5, 0> <0.5, 1.5, 1> <1.5, 1.5, 0>";
        for (const char* steps : {"u_steps 5 v_steps 0", "v_steps 5 u_steps 1", "u_steps 2 v_steps 4"})
            QTest::addRow("bicubic_patch %s", steps)
                << "bicubic_patch { type 0 flatness 0.01 " + QString(steps) + " " + bent + " }";
        add("quartic_without_commas",
            "quartic { <1 0 0 0 2 0 0 2 0, -2.32 0 0 0 0 0 0 0 0 0 0 1 0 0 2 0 1.68 0 0 0 0, 1 0, -2.32 0 "
            "0.7056>"
            "rotate -40*x }");
        add("julia_quaternion", "julia_fractal { <-0.083, 0, -0.83, -0.025> max_iteration 8 precision 500 }");
        add("julia_hypercomplex",
            "julia_fractal { <-0.1, 0.5, -0.3, 0.05> hypercomplex sqr max_iteration 6 precision "
            "1000 slice <0.1, 0.2, 0.3, 1>, 0.1 rotate 20*y }");
        add("csg",
            "difference { merge { torus { 0.9, 0.3 } cylinder { -0.9*y, 0.9*y, 0.35 } } "
            "cone { <0, 1.2, 0>, 0.3, 0, 0.1 } box { <0.2, -2, -2>, <2, 2, 0> } rotate <-20, 30, 0> }");
        add("cut_union",
            "difference { box { -0.9, 0.9 } union { sphere { <-0.3, 0.3, -1>, 0.7 pigment { rgb x } } "
            "cylinder { <0.2, -2, -0.8>, <0.2, 2, -0.8>, 0.5 pigment { rgb y } } } }");
        add("cut_clipped",
            "difference { box { -0.9, 0.9 } union { sphere { <-0.3, 0.3, -1>, 0.7 } "
            "cylinder { <0.2, -2, -0.8>, <0.2, 2, -0.8>, 0.5 } clipped_by { plane { y, 0.5 } } } }");
        add("height_field_inside",
            "intersection { height_field { function 40, 40 { 0.5 + 0.3*sin(12*x)*cos(9*y) } translate -0.5 "
            "scale <2.5, 1.2, 2.5> } cylinder { -2*y, 2*y, 0.8 } translate 0.5*y }");
        add("shared_walls",
            "union { intersection { cylinder { -y, y, 0.5 } box { <-0.3, -1, -1>, <1, 1, 1> } } "
            "difference { merge { cone { -y, 0.7, y, 0.3 } cone { y, 0.3, 1.3*y, 0.2 pigment { rgb x } } } "
            "cone { -y, 0.7, 0.5*y, 0.1 } translate 1.3*z - 1.2*x } }");
        const char* const disc = "disc { <0.1, 0.2, 0>, <-0.229, -0.509, 0.441>, 0.63, 0.39 }";
        for (const char* operation : {"merge", "intersection", "difference"})
            for (const char* other : {"sphere { -0.3*x, 0.8 }", "plane { y, -0.3 }", "torus { 0.6, 0.2 }",
                                      "union { sphere { 0.3*x, 0.4 } box { -0.5, <0, 0.5, 0.5> } }",
                                      "triangle { <-1, -1, 0>, <1, -1, 0.3>, <0, 1, -0.2> }",
                                      "mesh { triangle { <-1, -1, 0>, <1, -1, 0.3>, <0, 1, -0.2> } }"}) {
                const QString name = QString("disc_%1_%2").arg(operation, QString(other).section(' ', 0, 0));
                add(qPrintable(name + "_first"),
                    qPrintable(QString("%1 { %2 %3 }").arg(operation, disc, other)));
                add(qPrintable(name), qPrintable(QString("%1 { %3 %2 }").arg(operation, disc, other)));
            }
        add("nested",
            "union { object { torus { 0.5, 0.2 } scale <2, 1, 1> } union { cone { 0, 0.5, y, 0 pigment "
            "{ rgb <0, 0.6, 0.2> } } translate 0.2*y } rotate <-30, 40, 10> translate -0.3*y }");
    }
    void looksAsInPovray_PRIM_GEN() {
        QFETCH(QString, object);
        const std::string text = sceneOf(object);
        ParseOptions options;
        options.libraryPaths = installedLibraryPaths();
        options.imageWidth = width;
        options.imageHeight = height;
        const ParseResult parsed = parseScene(text, options);
        QVERIFY2(parsed.diagnostics.empty(), test::problems(parsed).c_str());
        const Image ours = renderImage(test::requestFor(parsed));
        const QString name = QString("shape_") + QTest::currentDataTag();
        if (!test::hasPovray()) {
            std::printf("NOT COMPARED, povray is not installed: %s\n", qPrintable(name));
            return;
        }
        test::PovrayRun run;
        run.width = width;
        run.height = height;
        const Image theirs = test::povrayPicture(text, run);
        QVERIFY(!theirs.pixels.empty());
        const test::PictureDifference difference = test::comparePictures(ours, theirs);
        std::printf("%s: %.2f %% within 8/255, largest difference %d\n", qPrintable(name),
                    100 * difference.shareWithin8, difference.largest);
        if (difference.shareWithin8 < 0.99 || std::getenv("ISOSCOPE_KEEP_PICTURES"))
            test::keepPictures(name, ours, theirs);
        QVERIFY(difference.shareWithin8 >= wantedShare);
    }
};

QTEST_GUILESS_MAIN(ShapePicturesTest)
#include "shape_pictures_test.moc"
