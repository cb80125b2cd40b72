// SPDX-License-Identifier: GPL-3.0-or-later
// VirtuaLight's shapes beside POV-Ray's: our picture of the text, our picture of the POV-Ray scene it is
// exported to, and POV-Ray's own picture of that scene.
#include <cmath>
#include <map>
#include <QTemporaryDir>
#include <QTest>

#include "core/exchange/virtualight_export.h"
#include "tests/support/csv_table.h"
#include "tests/support/scene_picture.h"
#include "tests/virtualight/example_texts.h"

using namespace isoscope;

namespace {

constexpr int width = 160;
constexpr int height = 120;
constexpr double wantedShare = 0.99;

Image drawn(const std::shared_ptr<const Scene>& scene) {
    return renderImage(test::requestFor(scene, width, height));
}

/// Pixels that are not black: a picture of nothing agrees with any other one.
int litPixels(const Image& image) {
    const Image black(image.width, image.height);
    return static_cast<int>(
        std::lround((1 - test::comparePictures(image, black).shareWithin8) * image.width * image.height));
}

std::string errors(const ParseResult& parsed) { return test::messages(parsed, Severity::error); }

}  // namespace

class PicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void examplesLookAsTheirExport_data() {
        QTest::addColumn<QString>("name");
        // CONF-56: 23 shapes are described; CONF-75: a UV pair occurs twice.
        const std::map<QString, QString> settled{{"statics.vl", "CONF-56"},
                                                 {"triangular_patch.vl", "CONF-75"}};
        const test::CsvTable rows(test::dataFile("spec/example_ids.csv"));
        for (const QString& name : test::exampleNames()) {
            QString tag = name;
            for (std::size_t row = 0; row < rows.rowCount(); ++row)
                if (rows.field(row, "file") == "vl_" + name.toStdString())
                    tag += " " + QString::fromStdString(rows.field(row, "id"));
            if (settled.contains(name)) tag += " " + settled.at(name);
            QTest::newRow(qPrintable(tag)) << name;
        }
    }
    void examplesLookAsTheirExport() {
        QFETCH(QString, name);
        const ParseResult parsed = test::readExample(name);
        QVERIFY2(parsed.ok(), errors(parsed).c_str());
        QCOMPARE(parsed.notation, Notation::virtualight);
        if (name == "statics.vl") {
            // Constants alone show nothing.
            QVERIFY(parsed.scene->objects.empty());
            return;
        }
        compare(name, parsed);
    }

    void furtherTextsLookAsTheirExport_CONF_64_data() {
        QTest::addColumn<QString>("text");
        const auto add = [](const char* name, const char* text) { QTest::newRow(name) << QString(text); };
        const char* net =
            "(-1.5,0.3,-1.5),(-0.5,-0.1,-1.5),(0.5,-0.1,-1.5),(1.5,0.3,-1.5),"
            "(-1.5,-0.2,-0.5),(-0.5,1.1,-0.5),(0.5,0.1,-0.5),(1.5,-0.2,-0.5),"
            "(-1.5,0,0.5),(-0.5,0.4,0.5),(0.5,1.4,0.5),(1.5,0,0.5),"
            "(-1.5,0.2,1.5),(-0.5,-0.2,1.5),(0.5,-0.2,1.5),(1.5,0.2,1.5)";
        for (const char* basis : {"BEZIER", "BSPLINE", "CATMULLROM", "HERMITE"})
            QTest::newRow(qPrintable(QString("bicubic_%1").arg(basis)))
                << QString("Shape [ BicubicPatch(%1, 12, 8, [ %2 ]) Rotate(-30, 20, 0) ]").arg(basis, net);
        add("blobby_with_plane",
            "Shape [ Blobby(0.4, Sphere((0, 0.9, 0), 1, 1), Cylinder((-1,0.3,0), (1,0.3,0.5), 0.5, -0.8), "
            "Plane((0,2,0), 0, 0.6, 1)) Bound((-2,-1,-2), (2,2,2)) ]");
        add("blobby_negative",
            "Shape [ Blobby(0.5, Sphere((0,0,0), 1.5, 1), Sphere((0.5,0.4,-0.7), 0.9, -1.2)) SturmSolver ]");
        add("extruded_closed",
            "Shape [ ExtrudedSurface(STRAIGHT, 5, (0,0,2), {-1,-1},{1,-0.6},{0.4,0},{1,1},{-1,-1}) "
            "Rotate(0, 30, 0) ]");
        add("extruded_along_y",
            "Shape [ ExtrudedSurface(POLYNOMIAL, 5, (0,1.5,0), {0,0},{1,0},{1,1},{0,2},{-1,0}) ]");
        add("extruded_conditional",
            "Shape [ ExtrudedSurface(CONDITIONAL, 6, (0.5,1,2), { {0,0},{OFF : 2,0},{1 : 2,1},{0 : 2,3},{ON "
            ": "
            "0,3},{0,0} }) VietaSolver ]");
        add("extruded_backwards",
            "Shape [ ExtrudedSurface(STRAIGHT, 4, (0,0,-1), {0,0},{2,0},{1,1.5},{0,0}) ]");
        add("revolved_straight",
            "Shape [ SurfaceOfRevolution(STRAIGHT, 4, (1,2,0), {0,-1},{1,-0.5},{0.6,0.5},{0,1}) ]");
        add("revolved_cone", "Shape [ SurfaceOfRevolution(STRAIGHT, 2, (0,1,0), {1,0},{0,2}) ]");
        add("torus_tilted", "Shape [ Torus((1,2,3), (1,1,-1), 2, 0.6) FerrariSolver ]");
        add("paraboloid_tilted", "Shape [ Paraboloid((1,0,0), (0,2,-1), 1.2) ]");
        add("polynomial_cubic",
            "Shape [ PolynomialSurface(x*y*z + 0.3*(x^2 + y^2 + z^2) - 0.4) Bound((-1.5,-1.5,-1.5), "
            "(1.5,1.5,1.5)) FerrariSolver ]");
        add("polynomial_sextic",
            "Shape [ PolynomialSurface(4*(2.618*x^2 - y^2)*(2.618*y^2 - z^2)*(2.618*z^2 - x^2) - 4.236*(x^2 "
            "+ "
            "y^2 + z^2 - 1)^2) Bound((-1.5,-1.5,-1.5), (1.5,1.5,1.5)) ]");
        add("bound_cuts", "Shape [ Sphere((0,0,0), 1) Bound((-1,-0.3,-1), (0.5,1,1)) Rotate(0,0,30) ]");
        add("height_field_flat",
            "Shape [ ImplicitPlanarHeightField(-2, 2, -1, 1, 0.3*sin(3*Po.x) + 0.2*z, 20, 10) ]");
        add("height_field_round",
            "Shape [ ImplicitSphericalHeightField(1, 0.5, 0.3*cos(5*u)*sin(v)^2, 40, 20) Scale(1,1.5,1) ]");
        add("solid_with_modifiers",
            "Declare C = Shape [ Cylinder((0,-1,0), (0,1,0), 0.5) ]\n"
            "Declare D = Shape [ Disk((0,1,0), (0,1,0), 0.5) ]\n"
            "Declare S = Solid [ C + D Rotate(20,0,30) ]\n"
            "Solid [ S + Shape [ S Translate(1.5,0,0) ] + Shape [ Torus((0,0,0),(0,1,0),1,0.2) ] "
            "Scale(1,0.8,1) ]");
        add("inherited_modifiers",
            "Solid [ Shape [ ImplicitSurface(x^2 + y^2 - 0.3) ] - Shape [ PolynomialSurface(y^2 + z^2 - 0.1) "
            "] "
            "Bound((-1,-1,-1), (1,1,1)) ]");
        add("inverse_alone",
            "Solid [ Shape [ Box((-1,-1,-1), (1,1,1)) ] * ~Shape [ Sphere((0.4,0.6,-0.8), 0.9) ] ]");
    }
    void furtherTextsLookAsTheirExport_CONF_64() {
        QFETCH(QString, text);
        const ParseResult parsed = test::readText(text.toStdString());
        QVERIFY2(parsed.ok(), errors(parsed).c_str());
        compare(QString("text_") + QTest::currentDataTag(), parsed);
    }

    /// An image stays an image: grey, with 16 bits, beside the export and named after it.
    void planarFieldsOfImagesBecomeHeightFields_VL_PLANARHF() {
        const ParseResult parsed = test::readExample("planar_height_field.vl");
        QVERIFY2(parsed.ok(), errors(parsed).c_str());
        const VirtualightExport made = exportVirtualight(parsed, parsed.scene->camera, "field");
        QVERIFY2(made.text.find("height_field { png \"field-1.png\"") != std::string::npos,
                 made.text.c_str());
        QCOMPARE(made.images.images.size(), std::size_t(1));
        const HeightGrid& grid = made.images.images.at("field-1.png");
        const QTemporaryDir folder;
        QCOMPARE(made.write(folder.filePath("field.pov").toStdString()), std::string());
        std::string problem;
        const std::optional<Raster> raster =
            readRaster(folder.filePath("field-1.png").toStdString(), problem);
        QVERIFY2(raster, problem.c_str());
        QCOMPARE(raster->largest, 65535);
        const HeightGrid again = heightGrid(*raster);
        QCOMPARE(again.heights.size(), grid.heights.size());
        for (std::size_t i = 0; i < grid.heights.size(); ++i)
            // White is 65535 of 65536 there, which the scale of the height field makes good.
            QVERIFY(std::abs(again.heights[i] * 65536 / 65535 - grid.heights[i]) <= 0.5 / 65535 + 1e-12);
        // Nowhere to write to.
        QVERIFY(!made.write(folder.filePath("none/field.pov").toStdString()).empty());
    }

  private:
    static void compare(const QString& name, const ParseResult& parsed) {
        const Image ours = drawn(parsed.scene);
        QVERIFY2(litPixels(ours) > 150, qPrintable(QString("%1 pixels").arg(litPixels(ours))));
        const QTemporaryDir folder;
        const QString scene = folder.filePath("scene.pov");
        QCOMPARE(exportVirtualight(parsed, parsed.scene->camera).write(scene.toStdString()), std::string());
        const ParseResult exported = parseSceneFile(scene.toStdString());
        QVERIFY2(exported.ok(), errors(exported).c_str());
        const Image again = drawn(exported.scene);
        const test::PictureDifference own = test::comparePictures(ours, again);
        qInfo("our pictures of both: %.2f %% within 8/255", 100 * own.shareWithin8);
        if (own.shareWithin8 < wantedShare) test::keepPictures("virtualight_own_" + name, ours, again);
        QVERIFY(own.shareWithin8 >= wantedShare);
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        test::PovrayRun run;
        run.width = width;
        run.height = height;
        const Image theirs = test::povrayPictureOfFile(scene, run);
        QVERIFY(theirs.width == width);
        const test::PictureDifference difference = test::comparePictures(ours, theirs);
        qInfo("beside POV-Ray: %.2f %% within 8/255", 100 * difference.shareWithin8);
        if (difference.shareWithin8 < wantedShare) test::keepPictures("virtualight_" + name, ours, theirs);
        QVERIFY(difference.shareWithin8 >= wantedShare);
    }
};

QTEST_GUILESS_MAIN(PicturesTest)
#include "pictures_test.moc"
