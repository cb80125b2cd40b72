// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QString>

class QImage;
class QMimeData;

namespace isoscope {

/// A picture for the clipboard: as an image, and as the bytes of a PNG.
std::unique_ptr<QMimeData> pictureMimeData(const QImage& picture);

/// The same and, for programs that take files, a PNG file of this name (without ending), which is there until
/// the program ends; left out where it cannot be written.
std::unique_ptr<QMimeData> pictureFileMimeData(const QImage& picture, const QString& name);

}  // namespace isoscope
