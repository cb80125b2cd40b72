// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/animation.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/animation/animation_export.h"
#include "core/render/render_image.h"
#include "tests/support/povray.h"
#include "tests/support/problems.h"
#include "tests/support/program.h"

using namespace isoscope;

namespace {

/// A slider with a slot, one without (a loop's end), a literal of a call, and clock itself.
const std::string scene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#include \"functions.inc\"\n"
    "#declare R = 0.7;\n#declare Count = 2;\n"
    "camera { location <0, 1, -4> look_at <0, 0.1, 0> angle 40 }\nlight_source { <5, 9, -8> 1 }\n"
    "isosurface { function { f_torus(x, y, z, R, 0.2) } contained_by { sphere { 0, 1.3 } } max_gradient 1.2\n"
    "  rotate 90*clock*x pigment { rgb <1, 0.6, 0.3> } }\n"
    "#for (I, 1, Count) sphere { <I/3 - 1, 0.9, 0>, 0.15 pigment { rgb 1 } } #end\n"
    "// timeline: frames 0 to 20, clock 0 to 1, 10 per second\n"
    "// keys \"R\": 0 = 0.7, 10 = 0.4 curve, 20 = 0.9\n"
    "// keys \"Count\": 0 = 1 hold, 10 = 5 linear, 20 = 2\n"
    "// keys \"f_torus Minor Radius\": 5 = 0.1 slow-start, 15 = 0.35\n";
const std::string turning =
    "// keys \"camera azimuth\": 0 = -20 linear, 20 = 340\n// keys \"camera elevation\": 0 = 10, 20 = 60\n"
    "// keys \"camera distance\": 0 = 4 slow-end, 20 = 5\n// keys \"camera angle\": 0 = 40, 20 = 55\n";

ParseOptions optionsAt(double clock) {
    ParseOptions options;
    options.clock = clock;
    options.clockOn = true;
    options.imageWidth = 120;
    options.imageHeight = 90;
    return options;
}

double clockOf(int frame) { return timelineOf(scene).frames.clock(frame); }

double numberOf(const Scene& scene, const std::string& name) {
    for (const SceneParameter& parameter : scene.parameters)
        if (parameter.name == name)
            return parameter.slot < 0 ? parameter.value : (*scene.parameterTable)[parameter.slot];
    return -1;
}

Image pictureOf(const Scene& scene, int width, int height) {
    RenderRequest request;
    request.scene = std::make_shared<Scene>(scene);
    request.camera = scene.camera;
    request.width = width;
    request.height = height;
    request.rootFinder = RootFinder::lipschitz;
    return renderImage(request);
}

double apart(const Camera& a, const Camera& b) {
    return glm::length(a.location - b.location) + glm::length(a.direction - b.direction) +
           glm::length(a.right - b.right) + glm::length(a.up - b.up);
}

}  // namespace

class AnimationTest : public QObject {
    Q_OBJECT

  private slots:
    void keysMoveNumbersWithAndWithoutSlots() {
        for (const auto& [frame, r, count, minor] :
             {std::tuple{0, 0.7, 1.0, 0.1}, {10, 0.4, 5.0, 0.1625}, {20, 0.9, 2.0, 0.35}}) {
            const ParseResult read = readAtClock(scene, optionsAt(clockOf(frame)));
            QVERIFY2(read.ok(), test::problems(read).c_str());
            QCOMPARE(numberOf(*read.scene, "R"), r);
            QCOMPARE(numberOf(*read.scene, "Count"), count);
            QVERIFY(std::abs(numberOf(*read.scene, "Minor Radius") - minor) < 1e-12);
            QCOMPARE(read.scene->objects.size(), 1 + static_cast<std::size_t>(count));
        }
    }

    /// What is moved through its slot looks as the text with that number does.
    void slotsAndTextsGiveOnePicture() {
        const std::string plain = scene.substr(0, scene.find("// timeline"));
        const std::string keyed = plain + "// keys \"R\": 0 = 0.45\n";
        std::string written = plain;
        written.replace(written.find("0.7"), 3, "0.45");
        const ParseResult moved = readAtClock(keyed, optionsAt(0.5));
        QVERIFY(moved.ok());
        QVERIFY(numberOf(*moved.scene, "R") == 0.45);
        const Image a = pictureOf(*moved.scene, 80, 60),
                    b = pictureOf(*readAtClock(written, optionsAt(0.5)).scene, 80, 60);
        QCOMPARE(test::comparePictures(a, b).largest, 0);
    }

    void brokenLinesAreTold() {
        ParseResult read = parseScene(
            "sphere { 0, 1 }\n// keys are kept below\n// keys \"R\": 1 = 2,\n"
            "  // timeline: frames 5 to 1\n// keys \"R\": 1 = 2 bounce\n");
        addTimelineWarnings(read);
        std::vector<std::string> lines;
        for (const Diagnostic& one : read.diagnostics)
            if (one.id == brokenTimelineId) lines.emplace_back(read.sources->slice(one.range));
        QCOMPARE(lines, (std::vector<std::string>{"// keys \"R\": 1 = 2,", "  // timeline: frames 5 to 1",
                                                  "// keys \"R\": 1 = 2 bounce"}));
    }

    void unknownNamesAreWarnings() {
        const ParseResult read = readAtClock("sphere { 0, 1 }\n// keys \"Gone\": 0 = 1\n", optionsAt(0));
        QVERIFY(read.ok());
        QCOMPARE(read.diagnostics.back().id, std::string(unknownKeysId));
        QVERIFY(read.diagnostics.back().message.find("`Gone`") != std::string::npos);
        QCOMPARE(read.sources->slice(read.diagnostics.back().range),
                 std::string_view("// keys \"Gone\": 0 = 1"));
    }

    void wordsOfTheClockAreFound() {
        const auto asks = [](const std::string& text) {
            return asksForClock(*readAtClock(text, {}).sources);
        };
        QVERIFY(asks(scene) && asks("sphere { frame_number*x, 1 }"));
        QVERIFY(!asks("sphere { 0, 1 } // clock\n/* clock */ #declare clocks = \"clock\";"));
    }

    void aPoseIsReadBack_data() {
        QTest::addColumn<double>("azimuth");
        QTest::addColumn<double>("elevation");
        QTest::newRow("front") << 0.0 << 0.0;
        QTest::newRow("right") << 90.0 << 10.0;
        QTest::newRow("many turns") << 1000.0 << -35.0;
        QTest::newRow("left, high") << -120.0 << 80.0;
    }
    void aPoseIsReadBack() {
        QFETCH(double, azimuth);
        QFETCH(double, elevation);
        for (const glm::dvec3 sky : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 2), glm::dvec3(1, 2, -0.5)})
            for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
                Camera camera;
                camera.kind = kind;
                camera.sky = sky;
                const CameraPose pose{azimuth, elevation, 3.5, {0.5, -1, 2}, 50};
                const Camera posed = posedCamera(camera, pose);
                QVERIFY(std::abs(glm::length(posed.location - pose.lookAt) - 3.5) < 1e-12);
                const glm::dvec3 way = glm::normalize(pose.lookAt - posed.location);
                QVERIFY(glm::length(glm::normalize(posed.direction) - way) < 1e-9);
                const auto read = poseNumbers(poseOf(posed, pose.lookAt, azimuth));
                const auto wanted = poseNumbers(pose);
                for (std::size_t i = 0; i < read.size(); ++i) QVERIFY(std::abs(read[i] - wanted[i]) < 1e-9);
            }
        QCOMPARE(posedCamera(Camera(), {0, 0, -1, {}, 50}), Camera());
    }

    void azimuthsCountFromTheFrontToTheRight() {
        Camera camera;
        camera.location = {3, 0, 0};
        QVERIFY(std::abs(poseOf(camera, {}).azimuth - 90) < 1e-12);
        QVERIFY(std::abs(poseOf(camera, {}, 400).azimuth - 450) < 1e-12);
        camera.location = {0, 0, -3};
        QVERIFY(std::abs(poseOf(camera, {}).azimuth) < 1e-12);
    }

    /// The exported scene, which has no timeline that counts, is at each moment what the timeline makes.
    void theExportedSceneFollowsTheClock_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("numbers") << QByteArray::fromStdString(scene);
        QTest::newRow("camera") << QByteArray::fromStdString(scene + turning);
        std::string rotated = scene + turning;
        rotated.insert(rotated.find("angle 40"), "rotate 20*y ");
        QTest::newRow("camera that is rotated") << QByteArray::fromStdString(rotated);
        std::string none = scene + turning;
        none.erase(none.find("camera {"), none.find("light_source") - none.find("camera {"));
        QTest::newRow("no camera, no version")
            << QByteArray::fromStdString(none.substr(none.find("global_settings")));
        QTest::newRow("no camera") << QByteArray::fromStdString(none);
    }
    void theExportedSceneFollowsTheClock() {
        QFETCH(QByteArray, text);
        const std::string own = text.toStdString();
        const ParseResult parsed = readAtClock(own, optionsAt(0));
        QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
        ParseOptions plain;
        plain.imageWidth = 120;
        plain.imageHeight = 90;
        const std::string exported = animationScene(parseScene(own, plain), timelineOf(own));
        QVERIFY(timelineOf(exported).tracks.empty() && timelineOf(exported).stated);
        for (const double clock : {0.0, 0.2, 0.25, 0.4999, 0.5, 0.77, 1.0}) {
            const ParseResult wanted = readAtClock(own, optionsAt(clock));
            const ParseResult got = parseScene(exported, optionsAt(clock));
            QVERIFY2(got.ok(), (test::problems(got) + exported).c_str());
            QCOMPARE(got.scene->objects.size(), wanted.scene->objects.size());
            QVERIFY2(apart(got.scene->camera, wanted.scene->camera) < 1e-9,
                     (std::to_string(clock) + exported).c_str());
            const auto picture =
                test::comparePictures(pictureOf(*got.scene, 60, 45), pictureOf(*wanted.scene, 60, 45));
            QVERIFY(picture.shareWithin8 > 0.999);
        }
    }

    void namesOfTheTextAreLeftAlone() {
        const std::string text =
            "#declare Key_Frame = 3;\n#declare Key_R = 4;\n#declare R = 1;\n"
            "sphere { Key_R*x, R }\n// keys \"R\": 0 = 2 linear, 119 = 3\n";
        const std::string exported = animationScene(parseScene(text), timelineOf(text));
        const ParseResult read = parseScene(exported, optionsAt(1));
        QVERIFY2(read.ok(), (test::problems(read) + exported).c_str());
        QVERIFY(exported.find("#declare R = Key_R_2;") != std::string::npos);
        QVERIFY(exported.find("#declare Key_R = 4;") != std::string::npos);
    }

    void textsWithoutKeysAreExportedAsTheyAre() {
        const std::string text =
            "#version 3.7;\ncamera { location -3*z }\nlight_source { 9, 1 }\nsphere { 0, 1 }\n";
        QCOMPARE(animationScene(parseScene(text), timelineOf(text)), text);
    }

    /// POV-Ray itself, told of one frame by the exported `.ini`: its numbers and its picture.
    void povrayRendersTheSameFrame() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const QTemporaryDir folder;
        const std::string own = scene + turning;
        ParseOptions plain;
        plain.imageWidth = 120;
        plain.imageHeight = 90;
        std::string exported = animationScene(parseScene(own, plain), timelineOf(own));
        exported +=
            "#debug concat(\"VALUES \", str(R, 0, 12), \" \", str(Count, 0, 12), \" \","
            " str(Key_f_torus_Minor_Radius, 0, 12), \" \", str(Key_camera_azimuth, 0, 12), \"\\n\")\n";
        test::writeFile(folder.path(), "out.pov", QByteArray::fromStdString(exported));
        test::writeFile(folder.path(), "out.ini",
                        QByteArray::fromStdString(animationSettings(timelineOf(own), "out.pov", 120, 90)));
        const test::ProgramResult run = test::runProgram(
            "povray", {"out.ini", "+SF13", "+EF13", "-D", "+Oframe.png"}, 120, folder.path());
        QVERIFY2(run.status == 0, run.errors.constData());
        const QByteArray all = run.output + run.errors;
        const QList<QByteArray> words = all.mid(all.indexOf("VALUES ")).split('\n').front().split(' ');
        QCOMPARE(words.size(), 5);
        const Timeline timeline = timelineOf(own);
        const Animation animation(timeline, parseScene(own).scene->parameters);
        for (int i = 0; i < 3; ++i)
            QVERIFY(std::abs(words[i + 1].toDouble() -
                             animation.values(13)[static_cast<std::size_t>(i)].second) < 1e-10);
        QVERIFY(std::abs(words[4].toDouble() - timeline.track("camera azimuth")->value(13)) < 1e-9);
        const ParseResult ours = readAtClock(own, optionsAt(clockOf(13)));
        // The picture of the exported text by the usual way, which names the frame by its clock.
        test::PovrayRun one;
        one.width = 120;
        one.height = 90;
        one.options = {"+K" + QString::number(clockOf(13), 'g', 17)};
        const Image theirs = test::povrayPicture(exported, one);
        const auto compared = test::comparePictures(pictureOf(*ours.scene, 120, 90), theirs);
        QVERIFY2(compared.shareWithin8 > 0.98, QByteArray::number(compared.shareWithin8));
        QVERIFY(QFile::exists(folder.filePath("frame13.png")));
    }

    void filmsAreAskedForByThePictures() {
        const auto arguments = filmArguments({5, 120, 0, 1, "a%b/f"}, 24, "out.mp4");
        const auto has = [&](const char* word) {
            return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
        };
        QVERIFY(has("a%%b/f%03d.png") && has("24") && has("5") && has("116") &&
                arguments.back() == "out.mp4");
    }
};

QTEST_GUILESS_MAIN(AnimationTest)
#include "animation_test.moc"
