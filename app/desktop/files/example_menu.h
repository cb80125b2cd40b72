// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QString>
#include <vector>

namespace isoscope {

class ThumbnailRenderer;

/// An example that comes with the program.
struct Example {
    QString name;           ///< of its file; empty for a separator
    bool asPovray = false;  ///< it is about what POV-Ray loses
    /// The whole scene, from the resources; empty for a separator.
    QString text() const;
    /// What it shows, which the comment in its first line says.
    QString title() const;
};

/// All examples, as examples/contents.txt orders them: a file a line, an empty line for a separator, and
/// behind the name "as-povray".
std::vector<Example> exampleContents();

/// The examples with their titles and pictures. The pictures are asked for when the menu first opens, come
/// from the cache or the background, and have their room from the beginning.
class ExampleMenu : public QMenu {
    Q_OBJECT
  public:
    explicit ExampleMenu(QWidget* parent);

    /// The edge of a picture in logical pixels.
    static constexpr int pictureSize = 48;

  signals:
    /// By its file name.
    void chosen(const QString& name);

  private:
    void startPictures();
    void showPicture(int index, QImage image);

    ThumbnailRenderer* renderer_ = nullptr;
    QList<QAction*> entries_;
};

}  // namespace isoscope
