// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QProcess>

#include "widgets/timeline/frame_writer.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace isoscope {

/// Draws the frames of an animation into numbered PNG files, beside the work in the window, and then, where
/// `ffmpeg` is installed and it is wished, makes a film of them: with progress, and to be stopped at any
/// time. Frames that were written before a stop stay.
class AnimationExportDialog : public QDialog {
    Q_OBJECT
  public:
    /// `order` is what is drawn, size and names apart, which the dialog asks for; `rate` is in frames per
    /// second.
    AnimationExportDialog(const FrameOrder& order, double rate, QWidget* parent = nullptr);
    ~AnimationExportDialog() override;

    /// Frames are drawn, or the film is made.
    bool running() const { return writer_.isRunning() || film_.state() != QProcess::NotRunning; }
    /// Where ffmpeg is; empty where it is not installed.
    static QString filmProgram();

  public slots:
    /// Draws; where files exist already, it asks in the dialog first, and a second call answers yes.
    void start();
    void stop();

  signals:
    /// All was written (`error` empty), or why not.
    void finished(const QString& error);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void buildFields();
    void buildButtons();
    void chooseFolder();
    void ask(bool toReplace);
    /// Why the files cannot be written; empty when they can be.
    QString problem() const;
    bool filesExist() const;
    QString filmFile() const;
    void setRunning(bool running);
    void makeFilm();
    void readFilmProgress();
    void report(const QString& error);

    FrameOrder order_;
    double rate_;
    QSpinBox *width_ = nullptr, *height_ = nullptr;
    QCheckBox *antialias_ = nullptr, *makesFilm_ = nullptr;
    QLineEdit* beginning_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* message_ = nullptr;
    QPushButton *start_ = nullptr, *stop_ = nullptr;
    bool asking_ = false;  ///< whether files that exist may be replaced
    bool stopped_ = false;
    FrameWriter writer_;
    QProcess film_;
};

}  // namespace isoscope
