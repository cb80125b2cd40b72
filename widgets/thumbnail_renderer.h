// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QImage>
#include <QObject>
#include <QString>
#include <string>

namespace isoscope {

/// Little pictures of scenes, everything in view, as POV-Ray's root finder shows it. Rendered by the program
/// itself in a background thread (one core), newest request first, and cached in the cache folder under the
/// program's version and the text of the scene; of
/// 2000 pictures and more the oldest go. A damaged file is rendered again.
class ThumbnailRenderer : public QObject {
    Q_OBJECT
  public:
    /// `folder` empty means "thumbnails" in the cache folder. `size` is in device pixels.
    explicit ThumbnailRenderer(int size = 96, QString folder = {}, QObject* parent = nullptr);
    /// Stops the picture at hand and waits.
    ~ThumbnailRenderer() override;

    /// The edge of the square pictures, in device pixels.
    int size() const { return size_; }
    /// The picture of a scene in POV-Ray's or VirtuaLight's notation, or a null image and a promise to emit
    /// ready() with its `index`.
    QImage thumbnail(int index, std::string scene);

  signals:
    /// The picture is there; null when it could not be made.
    void ready(int index, const QImage& image);

  private:
    struct Worker;

    int size_;
    std::unique_ptr<Worker> worker_;
};

}  // namespace isoscope
