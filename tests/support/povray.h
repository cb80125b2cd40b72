// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "core/render/image.h"

namespace isoscope::test {

/// Whether the program `povray` is installed here.
bool hasPovray();
/// What a test says that is skipped without it.
constexpr const char* povrayIsMissing = "NOT COMPARED: povray is not installed";

/// How to run POV-Ray.
struct PovrayRun {
    int width = 160;
    int height = 120;
    QStringList options;       ///< further ones
    QStringList libraryPaths;  ///< searched for includes
};

/// The picture that POV-Ray makes of a scene, without anti-aliasing; an empty image (and a printed reason)
/// when it fails.
Image povrayPicture(const std::string& scene, const PovrayRun& run);
Image povrayPictureOfFile(const QString& file, const PovrayRun& run);
/// Frames 1 to `count` of an animation, in order; fewer when POV-Ray stops early.
std::vector<Image> povrayFrames(const QString& file, const PovrayRun& run, int count);

/// How far two pictures agree.
struct PictureDifference {
    double shareWithin8 =
        0;  ///< of the pixels whose every channel differs by at most 8 of 255; 0 for unequal sizes
    int largest = 255;  ///< largest difference of a channel, of 255
    double mean = 255;  ///< over all channels, of 255
};
PictureDifference comparePictures(const Image& ours, const Image& theirs);

/// Writes both pictures and their difference, side by side, as build/pictures/NAME.png.
void keepPictures(const QString& name, const Image& ours, const Image& theirs);

}  // namespace isoscope::test
