// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QDialog>

#include "core/render/render_request.h"
#include "widgets/pictures/picture_queue.h"

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace isoscope {

class PictureForecast;

/// Renders the scene as it was when the dialog opened to a PNG or OpenEXR file of any size, beside the work
/// in the window: with progress, and to be stopped at any time. A stopped or failed export leaves no file
/// behind and an existing one untouched.
class ImageExportDialog : public QDialog {
    Q_OBJECT
  public:
    /// Pictures are drawn by `queue`, which must outlive the dialog; without one by a queue of its own.
    ImageExportDialog(std::shared_ptr<const Scene> scene, const Camera& camera, const QString& suggestedFile,
                      QWidget* parent = nullptr, PictureQueue* queue = nullptr);
    ~ImageExportDialog() override;

    /// POV-Ray's is the default.
    void setRootFinder(RootFinder finder);
    /// Also the proportions that are kept.
    void setPictureSize(QSize size);
    QSize pictureSize() const;
    void setFile(const QString& file);
    bool running() const { return number_ != 0; }
    /// What would be drawn now, and how it would be stored.
    RenderRequest request() const;
    PictureFileOptions options() const;
    /// How long it will take.
    const PictureForecast* forecast() const { return forecast_; }

    static constexpr int longestSide = 1 << 16;

  public slots:
    /// Renders; where the file exists already, it asks in the dialog first, and a second call answers yes.
    void start();
    /// The same, but the dialog is free at once for another picture: this one goes on when it is closed.
    void enqueue();
    void stop();

  signals:
    /// An image of this size is being made, or waits for it.
    void started(QSize size);
    /// The file was written (`error` empty), or why not.
    void finished(const QString& file, const QString& error);
    /// enqueue() has put a picture into the queue.
    void enqueued(int number);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void buildPicture(QFormLayout* form);
    void buildFile(QFormLayout* form, const QString& suggestedFile);
    void buildButtons(QBoxLayout* layout);
    void chooseFile();
    void keepProportions(QSpinBox* changed);
    PictureFormat format() const;
    void showFormat();
    /// Another picture: its time is found anew.
    void forecastAgain();
    /// Another file, or another answer.
    void ask(bool toReplace, bool toEnqueue = false);
    /// Whether everything is as it must be to draw now; else says what is not, or asks.
    bool mayBegin(bool toEnqueue);
    /// Puts the picture into the queue.
    int order();
    void openResult(bool folder);
    void setRunning(bool running);
    void showProgress(int number);
    void report(int number);

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    RootFinder rootFinder_ = RootFinder::lipschitz;
    PictureQueue* queue_;
    QSpinBox* width_;
    QSpinBox* height_;
    QCheckBox* proportions_;
    QCheckBox* antialias_;
    QCheckBox* transparent_;
    QComboBox* depth_;
    QLineEdit* file_;
    QLabel* layers_;
    QProgressBar* progress_;
    QLabel* message_;
    QLabel* time_;
    PictureForecast* forecast_;
    QPushButton* start_;
    QPushButton* enqueue_;
    QPushButton* stop_;
    QPushButton* open_;
    QPushButton* reveal_;
    double ratio_ = 4.0 / 3;  ///< width over height
    bool asking_ = false;     ///< whether the file that exists may be replaced
    QString written_;
    int number_ = 0;  ///< of the picture that is waited for
};

}  // namespace isoscope
