// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "core/exchange/isosurface_export.h"
#include "core/exchange/pov_export.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int width = 320;
constexpr int height = 240;
constexpr double wantedShare = 0.99;

QDir exampleFolder() { return QDir(test::dataFile("spec/examples")); }

/// The scenes that come with the program.
QDir ownFolder() { return QDir(ISOSCOPE_SOURCE_DIR "/examples"); }

QStringList ownNames() { return ownFolder().entryList({"*.pov"}, QDir::Files, QDir::Name); }

/// The file of an example of either kind.
QString fileOf(const QString& name) {
    return exampleFolder().exists(name) ? exampleFolder().filePath(name) : ownFolder().filePath(name);
}

/// The tutorial's texts that show an isosurface.
QStringList exampleNames() {
    QStringList names;
    for (const QString& name : exampleFolder().entryList({"*.pov", "*.inc"}, QDir::Files, QDir::Name)) {
        QFile file(exampleFolder().filePath(name));
        if (file.open(QIODevice::ReadOnly) && file.readAll().contains("isosurface")) names << name;
    }
    return names;
}

/// The text of an example. Snippets have no look of their own and would be black on black: they get one.
std::string contents(const QString& name) {
    QFile file(fileOf(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const std::string text = file.readAll().toStdString();
    if (name.endsWith(".pov")) return text;
    return "background { rgb <0.2, 0.3, 0.5> }\n#default { texture { pigment { rgb <0.9, 0.8, 0.6> } } }\n" +
           text;
}

ParseResult parsed(const QString& name) {
    ParseOptions options;
    options.file = fileOf(name).toStdString();
    options.libraryPaths = installedLibraryPaths();
    options.imageWidth = width;
    options.imageHeight = height;
    return parseScene(contents(name), options);
}

Image drawn(std::shared_ptr<const Scene> scene, const Camera& camera) {
    RenderRequest request = test::requestFor(std::move(scene), width, height);
    request.camera = camera;
    return renderImage(request);
}

void compare(const QString& name, const Image& ours, const std::string& text) {
    test::PovrayRun run;
    run.width = width;
    run.height = height;
    const Image theirs = test::povrayPicture(text, run);
    QVERIFY2(!theirs.pixels.empty(), text.c_str());
    const test::PictureDifference difference = test::comparePictures(ours, theirs);
    std::printf("%s: %.2f %% within 8/255, largest difference %d\n", qPrintable(name),
                100 * difference.shareWithin8, difference.largest);
    if (difference.shareWithin8 < wantedShare) test::keepPictures(name, ours, theirs);
    QVERIFY2(difference.shareWithin8 >= wantedShare, text.c_str());
}

void addRows(const QStringList& names) {
    QTest::addColumn<QString>("name");
    for (const QString& name : names) QTest::newRow(qPrintable(name)) << name;
}

/// Those that stand alone: the others are snippets.
QStringList wholeScenes(const QStringList& names) { return names.filter(QRegularExpression("[.]pov$")); }

}  // namespace

class PovrayPictureTest : public QObject {
    Q_OBJECT

  private slots:
    void theExamplesAreThere() {
        QVERIFY(exampleNames().size() >= 25);
        QVERIFY(ownNames().size() >= 9);
    }

    void exportsMakeTheSamePicture_data() { addRows(exampleNames() + ownNames()); }
    void exportsMakeTheSamePicture() {
        QFETCH(QString, name);
        const ParseResult result = parsed(name);
        QVERIFY2(result.ok(), test::problems(result).c_str());
        QVERIFY(!result.scene->isosurfaces.empty());
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const Image ours = drawn(result.scene, result.scene->camera);
        compare(name, ours, exportScene(*result.scene, result.scene->camera, contents(name), width, height));
    }

    void scenesMakeTheSamePictureUnchanged_data() { addRows(wholeScenes(exampleNames())); }
    void scenesMakeTheSamePictureUnchanged() {
        QFETCH(QString, name);
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const ParseResult result = parsed(name);
        compare(name + " unchanged", drawn(result.scene, result.scene->camera), contents(name));
    }

    void anotherViewIsExportedToo() {
        const QString name = "iso_union_min.pov";
        const ParseResult result = parsed(name);
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        Camera camera = result.scene->camera;
        camera.location += glm::dvec3(-2, 1.5, 1);
        camera = camera.withAngle(35).lookingAt({0.1, 0.2, 0.3});
        compare(name + " from elsewhere", drawn(result.scene, camera),
                exportScene(*result.scene, camera, contents(name), width, height));
        camera.kind = CameraKind::orthographic;
        camera.right *= 4;
        camera.up *= 4;
        compare(name + " in parallel projection", drawn(result.scene, camera),
                exportScene(*result.scene, camera, contents(name), width, height));
        camera.right = {3, 0.5, 0};  // no look_at makes this one
        compare(name + " sheared", drawn(result.scene, camera),
                exportScene(*result.scene, camera, contents(name), width, height));
    }

    void anExportedIsosurfaceMakesTheSamePicture_data() { addRows(wholeScenes(exampleNames())); }
    void anExportedIsosurfaceMakesTheSamePicture() {
        QFETCH(QString, name);
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const ParseResult result = parsed(name);
        const Scene& scene = *result.scene;
        QCOMPARE(scene.isosurfaces.size(), std::size_t{1});
        // Version and background come from the scene around it, which an include file leaves alone.
        const Color& back = scene.background;
        const std::string around = "#version 3.6;\n" + cameraBlock(scene.camera) +
                                   "\nlight_source { <-100,200,-100> rgb 1 }\nbackground { rgb <" +
                                   std::to_string(back.red) + "," + std::to_string(back.green) + "," +
                                   std::to_string(back.blue) + "> }\n";
        compare(name + ", its isosurface alone", drawn(result.scene, scene.camera),
                around + exportIsosurface(result, 0).text);
    }

    void gradientsAreReportedInsideOfCsgToo() {
        const ParseResult result = parseScene(
            "#version 3.7; camera { location -z*4 look_at 0 } difference { box { -1, 1 } union {"
            " isosurface { function { x*x + y*y + z*z - 1.3 } contained_by { box { -2, 2 } } max_gradient 9 }"
            " sphere { 2, 1 } } pigment { rgb 1 } rotate y*20 }");
        QVERIFY2(result.ok(), test::problems(result).c_str());
        RenderStatistics statistics;
        renderImage(test::requestFor(result, 60, 45), 2, &statistics);
        QCOMPARE(statistics.gradients.size(), std::size_t{1});
        QCOMPARE(statistics.gradients[0].maxGradient, 9.0);
        QVERIFY(statistics.gradients[0].searches > 100);
        QVERIFY(statistics.gradients[0].steepest > 2);
    }

    void noShadowCountsForWholeObjectsAlone_data() {
        QTest::addColumn<QString>("object");
        for (const char* object :
             {"intersection { sphere { 0, 1 no_shadow } box { -2, 2 no_shadow }",
              "difference { sphere { 0, 1 no_shadow } box { 0, 2 }",
              "union { sphere { 0, 1 no_shadow } sphere { x*2, 1 }",
              "union { sphere { 0, 1 no_shadow } sphere { x*2, 1 } clipped_by { box { -2, 2 } }",
              "intersection { union { sphere { 0, 1 no_shadow } sphere { x*2, 1 } } box { -2, 2 }",
              "merge { sphere { 0, 1 no_shadow } sphere { x*2, 1 }",
              "union { intersection { sphere { 0, 1 } box { -2, 2 } no_shadow } sphere { x*2, 1 }"})
            QTest::newRow(object) << QString(object);
    }
    void noShadowCountsForWholeObjectsAlone() {
        QFETCH(QString, object);
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const std::string text =
            "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
            "camera { location <0, 6, -6> right x*4/3 look_at 0 }\nlight_source { <0, 20, 0>, 1 }\n"
            "plane { y, -1 pigment { rgb 1 } }\n" +
            object.toStdString() + " pigment { rgb <1, 0.5, 0> } }\n";
        const ParseResult result = parseScene(text);
        QVERIFY2(result.ok(), test::problems(result).c_str());
        compare("no_shadow in CSG", drawn(result.scene, result.scene->camera), text);
    }

    void theSphereOfTheTutorialHasPovraysHoles() {
        const QString name = "iso_sphere_default_gradient.inc";
        const ParseResult result = parsed(name);
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const Camera camera = result.scene->camera;
        test::PovrayRun run;
        run.width = width;
        run.height = height;
        const Image theirs =
            test::povrayPicture(exportScene(*result.scene, camera, contents(name), width, height), run);
        const Image ours = drawn(result.scene, camera);
        QCOMPARE(theirs.pixels.size(), ours.pixels.size());
        int missing = 0, differing = 0;
        for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
            const bool hole = theirs.pixels[i] == theirs.pixels.front();
            missing += hole;
            differing += hole != (ours.pixels[i] == ours.pixels.front());
        }
        std::printf("pixels without surface: %d of %zu, of them otherwise here: %d\n", missing,
                    ours.pixels.size(), differing);
        QVERIFY(missing > width * height / 20);
        QVERIFY(differing <= static_cast<int>(ours.pixels.size() / 100));
    }
};

QTEST_GUILESS_MAIN(PovrayPictureTest)
#include "povray_picture_test.moc"
