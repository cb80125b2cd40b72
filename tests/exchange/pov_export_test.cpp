// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/pov_export.h"

#include <QTest>

#include "core/language/parse.h"
#include "core/scene/surface_normal.h"

using namespace isoscope;

namespace {

/// The range of the first `{ ... }` statement that begins with `word`.
SourceRange statementRange(const std::string& text, const std::string& word) {
    const std::size_t begin = text.find(word);
    std::size_t end = text.find('{', begin) + 1;
    for (int depth = 1; depth > 0 && end < text.size(); ++end)
        depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
    return {0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

Scene sceneOf(const std::string& text) {
    Scene scene;
    scene.camera.location = {0, 0, -4};
    if (text.find("camera") != std::string::npos) scene.cameraRange = statementRange(text, "camera");
    scene.lights.emplace_back().line = 3;
    return scene;
}

const std::string complete =
    "// mine\n#version 3.7;\ncamera { location -z*4 }\nlight_source { 5, 1 }\nsphere { 0, 1 } // end";

}  // namespace

class PovExportTest : public QObject {
    Q_OBJECT

  private slots:
    void aCompleteSceneStaysAsItIs() {
        const Scene scene = sceneOf(complete);
        QCOMPARE(exportScene(scene, scene.camera, complete, 320, 240), complete);
    }

    void anotherViewReplacesTheCameraBlockAlone() {
        const Scene scene = sceneOf(complete);
        Camera camera;
        camera.location = {1, 2, -3};
        camera.lookAt = {1, 2, 7};
        QCOMPARE(exportScene(scene, camera, complete, 320, 240),
                 "// mine\n#version 3.7;\n" + cameraBlock(camera) +
                     "\nlight_source { 5, 1 }\nsphere { 0, 1 } // end");
    }

    void whatIsMissingIsAdded() {
        const std::string text = "isosurface { function { x } } // no line end";
        Scene scene = sceneOf(text);
        scene.lights.front().line = 0;  // the parser's own
        scene.lights.front().location = {3, 2, -0.1};
        QCOMPARE(exportScene(scene, scene.camera, text, 320, 240),
                 "#version 3.7;\n" + text + "\n" + cameraBlock(scene.camera) +
                     "\nlight_source { <3, 2, -0.1>, rgb 1 }\n");
    }

    void aVersionInACommentIsNone() {
        const std::string text =
            "// #version 3.7;\n/* #version 3.6; */ camera { location 0 } sphere { 0, 1 }";
        const Scene scene = sceneOf(text);
        QVERIFY(exportScene(scene, scene.camera, text, 8, 8).starts_with("#version 3.7;\n//"));
    }

    void aRangeOutsideOfTheTextIsNotFollowed() {
        Scene scene = sceneOf(complete);
        scene.cameraRange = SourceRange{0, 10, 100000};
        const std::string result = exportScene(scene, Camera(), complete, 8, 8);
        QVERIFY(result.starts_with(complete));
        QVERIFY(result.ends_with(cameraBlock(Camera()) + "\n"));
    }

    void camerasAreWrittenExactly() {
        Camera camera;
        camera.location = {0.1, 1.0 / 3, -1e-7};
        camera = camera.withAngle(40).lookingAt({0, 0, 5});
        QVERIFY(cameraBlock(camera).find("<0.1, 0.3333333333333333, -1e-07>") != std::string::npos);
        QVERIFY(cameraBlock(camera).find("look_at <0, 0, 5>") != std::string::npos);
        QVERIFY(cameraBlock(camera).find("right <1.33, 0, 0>") != std::string::npos);
        camera.right = {1, 1, 0};  // not what look_at would make
        QVERIFY(cameraBlock(camera).find("look_at") == std::string::npos);
        QVERIFY(cameraBlock(camera).find("right <1, 1, 0>") != std::string::npos);
    }

    void mirroredAndParallelCamerasKeepTheirNature() {
        Camera camera;
        camera.location = {3, 2, 1};
        camera.right = {-1.5, 0, 0};
        camera.kind = CameraKind::orthographic;
        camera = camera.lookingAt({0, 0, 0});
        const std::string block = cameraBlock(camera);
        QVERIFY(block.starts_with("camera {\n    orthographic\n"));
        QVERIFY(block.find("right <-1.5, 0, 0>") != std::string::npos);
    }

    void camerasKeepTheirBlurAndTheirNormal() {
        const std::string text =
            "camera { location -4*z look_at 0 normal { bumps 0.3 scale 0.2 } aperture 0.4 "
            "blur_samples 12 focal_point x }\nlight_source { -9, 1 }\nsphere { 0, 1 }";
        const ParseResult parsed = parseScene(text);
        QVERIFY(parsed.ok());
        Camera moved = parsed.scene->camera;
        moved.location.y = 1;
        const ParseResult again = parseScene(exportScene(*parsed.scene, moved, text, 4, 3));
        QVERIFY(again.ok());
        const Camera& camera = again.scene->camera;
        QCOMPARE(camera.location.y, 1.0);
        QVERIFY(camera.blur == moved.blur);
        QVERIFY(camera.normal && camera.normalTape);
        QCOMPARE(camera.normal->amount, 0.3);
        QCOMPARE(camera.normalText, std::string("normal { bumps 0.3 scale 0.2 }"));
    }

    void curvedCamerasKeepKindAndAngles() {
        Camera camera;
        camera.kind = CameraKind::spherical;
        camera.angle = 200;
        camera.verticalAngle = 70;
        const std::string block = cameraBlock(camera);
        QVERIFY(block.starts_with("camera {\n    spherical\n"));
        QVERIFY(block.find("angle 200, 70\n") != std::string::npos);
        QCOMPARE(parseScene(block + " sphere { 0, 1 }").scene->camera.verticalAngle, 70.0);
        camera.kind = CameraKind::movingLyingCylinder;
        QVERIFY(cameraBlock(camera).starts_with("camera {\n    cylinder 4\n"));
    }
};

QTEST_APPLESS_MAIN(PovExportTest)
#include "pov_export_test.moc"
