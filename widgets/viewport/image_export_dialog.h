// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QDialog>
#include <QImage>
#include <QTimer>

#include "core/render/progressive/progressive_renderer.h"
#include "core/scene/scene.h"
#include "widgets/latest_worker.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace isoscope {

/// Renders the scene as it was when the dialog opened to a PNG file of any size, beside the work in the
/// window: with progress, and to be stopped at any time. A stopped or failed export leaves no file behind and
/// an existing one untouched.
class ImageExportDialog : public QDialog {
    Q_OBJECT
  public:
    ImageExportDialog(std::shared_ptr<const Scene> scene, const Camera& camera, const QString& suggestedFile,
                      QWidget* parent = nullptr);
    ~ImageExportDialog() override;

    /// POV-Ray's is the default.
    void setRootFinder(RootFinder finder) { rootFinder_ = finder; }
    /// Also the proportions that are kept.
    void setPictureSize(QSize size);
    QSize pictureSize() const;
    void setFile(const QString& file);
    bool running() const { return running_; }

    /// Longest side and number of pixels that fit into memory comfortably.
    static constexpr int longestSide = 16384;
    static constexpr qint64 mostPixels = 100'000'000;

  public slots:
    /// Renders; where the file exists already, it asks in the dialog first, and a second call answers yes.
    void start();
    void stop();

  signals:
    /// An image of this size is being made.
    void started(QSize size);
    /// The file was written (`error` empty), or why not.
    void finished(const QString& file, const QString& error);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void buildControls(const QString& suggestedFile);
    void chooseFile();
    void keepProportions(QSpinBox* changed);
    /// Another file, or another answer.
    void ask(bool toReplace);
    void openResult(bool folder);
    void setRunning(bool running);
    void drain();
    void write();
    void report(const QString& error);

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    RootFinder rootFinder_ = RootFinder::lipschitz;
    QSpinBox* width_;
    QSpinBox* height_;
    QCheckBox* proportions_;
    QCheckBox* antialias_;
    QLineEdit* file_;
    QProgressBar* progress_;
    QLabel* message_;
    QPushButton* start_;
    QPushButton* stop_;
    QPushButton* open_;
    QPushButton* reveal_;
    double ratio_ = 4.0 / 3;  ///< width over height
    bool asking_ = false;     ///< whether the file that exists may be replaced
    QString written_;
    QTimer timer_;
    QImage image_;
    qint64 received_ = 0;  ///< pixels, every pass counted
    bool running_ = false;
    std::uint64_t job_ = 0;
    std::unique_ptr<ProgressiveRenderer> renderer_;
    LatestWorker writer_;
};

}  // namespace isoscope
