// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <QFile>
#include <QTest>

#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int frameCount = 78;
constexpr int width = 160;
constexpr int height = 120;
constexpr double wantedShare = 0.98;

/// Where Debian's package povray-examples keeps the demonstration of all built-in functions.
QString demoFile() {
    for (const char* file : {"/usr/share/doc/povray/examples/incdemo/i_internal.pov",
                             "/usr/share/povray-3.7/scenes/incdemo/i_internal.pov"})
        if (QFile::exists(file)) return file;
    return {};
}

ParseResult parsedFrame(int frame) {
    ParseOptions options;
    options.imageWidth = width;
    options.imageHeight = height;
    options.frameNumber = frame;
    options.finalFrame = frameCount;
    options.libraryPaths = installedLibraryPaths();
    options.clock = (frame - 1.0) / (frameCount - 1);
    options.clockOn = true;
    return parseSceneFile(demoFile().toStdString(), options);
}

Image drawnFrame(int frame) {
    const ParseResult result = parsedFrame(frame);
    if (!result.ok()) {
        std::printf("%s", test::problems(result).c_str());
        return {};
    }
    return renderImage(test::requestFor(result, width, height));
}

}  // namespace

class PovrayFramesTest : public QObject {
    Q_OBJECT

  private slots:
    void allBuiltInsAgreeWithPovray() {
        if (demoFile().isEmpty())
            QSKIP("NOT COMPARED: i_internal.pov (package povray-examples) is not installed");
        std::vector<Image> theirs;
        test::PovrayRun run;
        run.width = width;
        run.height = height;
        if (test::hasPovray()) theirs = test::povrayFrames(demoFile(), run, frameCount);
        int good = 0;
        for (int frame = 1; frame <= frameCount; ++frame) {
            const Image ours = drawnFrame(frame);
            QVERIFY2(!ours.pixels.empty(), std::to_string(frame).c_str());
            if (static_cast<std::size_t>(frame) > theirs.size()) continue;
            const Image& picture = theirs[static_cast<std::size_t>(frame) - 1];
            const double share = test::comparePictures(ours, picture).shareWithin8;
            std::printf("frame %2d: %6.2f %% within 8/255%s\n", frame, 100 * share,
                        share < wantedShare ? "  <-- below 98 %" : "");
            if (share < wantedShare) test::keepPictures(QString("i_internal %1").arg(frame), ours, picture);
            good += share >= wantedShare;
        }
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);  // every frame was drawn all the same
        std::printf("%d of %d frames reach 98 %%\n", good, frameCount);
        QCOMPARE(static_cast<int>(theirs.size()), frameCount);
        QCOMPARE(good, frameCount);
    }
};

QTEST_GUILESS_MAIN(PovrayFramesTest)
#include "povray_frames_test.moc"
