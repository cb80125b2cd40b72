// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QTest>

#include "core/language/directives/library_paths.h"
#include "core/language/parse.h"
#include "core/render/render_image.h"
#include "tests/support/povray.h"
#include "tests/support/problems.h"

namespace isoscope::test {

/// To draw a scene by its own camera, in the size of the pictures that are compared with POV-Ray's.
inline RenderRequest requestFor(std::shared_ptr<const Scene> scene, int width = PovrayRun{}.width,
                                int height = PovrayRun{}.height) {
    RenderRequest request;
    request.camera = scene->camera;
    request.scene = std::move(scene);
    request.width = width;
    request.height = height;
    return request;
}
inline RenderRequest requestFor(const ParseResult& parsed, int width = PovrayRun{}.width,
                                int height = PovrayRun{}.height) {
    return requestFor(parsed.scene, width, height);
}

/// What a picture of this text costs.
inline RenderStatistics costOf(const std::string& text, const StageSet& leftOut = {},
                               int width = PovrayRun{}.width, int height = PovrayRun{}.height) {
    RenderRequest request = requestFor(parseScene(text), width, height);
    request.leftOut = leftOut;
    RenderStatistics statistics;
    renderImage(request, 1, &statistics);
    return statistics;
}

/// The report of a stage; none when it did not run.
inline const StageReport* find(const RenderStatistics& statistics, StageKind kind) {
    for (const StageReport& stage : statistics.stages)
        if (stage.kind == kind) return &stage;
    return nullptr;
}

/// Rows of a data-driven test: every scene of a folder.
inline void addScenes(const QDir& folder) {
    QTest::addColumn<QString>("name");
    for (const QString& name : folder.entryList({"*.pov"}, QDir::Files, QDir::Name))
        QTest::addRow("%s", qPrintable(name)) << name;
}

/// Our picture of a file beside POV-Ray's, kept as `keptAs`; fails the test when the file has a problem of
/// any kind.
inline PictureDifference differenceFromPovray(const QString& file, const QString& keptAs,
                                              RootFinder finder = RootFinder::lipschitz) {
    ParseOptions options;
    options.libraryPaths = installedLibraryPaths();
    options.imageWidth = PovrayRun{}.width;
    options.imageHeight = PovrayRun{}.height;
    const ParseResult parsed = parseSceneFile(file.toStdString(), options);
    if (!parsed.ok() || !parsed.diagnostics.empty()) {
        QTest::qFail(problems(parsed).c_str(), __FILE__, __LINE__);
        return {};
    }
    RenderRequest request = requestFor(parsed);
    request.rootFinder = finder;
    const Image ours = renderImage(request), theirs = povrayPictureOfFile(file, {});
    keepPictures(keptAs, ours, theirs);
    const PictureDifference difference = comparePictures(ours, theirs);
    qInfo("%s: %.2f %% within 8/255, mean %.2f", qPrintable(keptAs), 100 * difference.shareWithin8,
          difference.mean);
    return difference;
}

}  // namespace isoscope::test
