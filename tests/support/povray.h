// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "core/render/image.h"

namespace isoscope::test {

/// Whether the program `povray` is installed here.
bool hasPovray();

/// How to run POV-Ray.
struct PovrayRun {
    int width = 160;
    int height = 120;
    QStringList options;       ///< further ones, e.g. "+KFI1", "+KFF78", "+SF5", "+EF5"
    QStringList libraryPaths;  ///< searched for includes
};

/// The picture that POV-Ray makes of a scene, without anti-aliasing; an empty image (and a printed reason)
/// when it fails.
Image povrayPicture(const std::string& scene, const PovrayRun& run);
Image povrayPictureOfFile(const QString& file, const PovrayRun& run);

/// How far two pictures agree.
struct PictureDifference {
    double shareWithin8 =
        0;  ///< of the pixels whose every channel differs by at most 8 of 255; 0 for unequal sizes
    int largest = 255;  ///< largest difference of a channel, of 255
};
PictureDifference comparePictures(const Image& ours, const Image& theirs);

/// Writes both pictures and their difference, side by side, as build/pictures/NAME.png.
void keepPictures(const QString& name, const Image& ours, const Image& theirs);

}  // namespace isoscope::test
