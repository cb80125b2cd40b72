// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <QDialog>
#include <QTimer>
#include <stop_token>

#include "core/mesh/files/mesh_file.h"
#include "core/scene/scene.h"
#include "widgets/latest_worker.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace isoscope {

/// Meshes the isosurfaces of the scene as it was when the dialog opened, and writes them to a file, beside
/// the work in the window: with progress, and to be stopped at any time. A stopped or failed export leaves no
/// file behind and an existing one untouched.
class MeshExportDialog : public QDialog {
    Q_OBJECT
  public:
    MeshExportDialog(std::shared_ptr<const Scene> scene, const QString& suggestedFile,
                     QWidget* parent = nullptr);
    ~MeshExportDialog() override;

    /// The ending says what is written; one that is unknown is replaced by that of the chosen format.
    void setFile(const QString& file);
    /// In world coordinates; an empty text stands for the usual one.
    void setTolerance(const QString& tolerance);
    /// Whether a mesh is being made.
    bool running() const { return running_; }

  public slots:
    /// Meshes; where the file exists already, it asks in the dialog first, and a second call answers yes.
    void start();
    void stop();

  signals:
    /// The file was written (`error` empty), or why not.
    void finished(const QString& file, const QString& error);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void buildControls(const QString& suggestedFile);
    void buildButtons();
    void chooseFile();
    void followFormat();
    void ask(bool toReplace);
    void setRunning(bool running);
    /// Whether the file and the tolerance can be used; says what is wrong.
    bool ready();
    void submit(double tolerance, MeshFormat format);
    void report(const QString& error, const QString& text);

    std::shared_ptr<const Scene> scene_;
    QComboBox* format_;
    QLineEdit* tolerance_;
    QCheckBox* colors_;
    QLineEdit* file_;
    QProgressBar* progress_;
    QLabel* message_;
    QPushButton* start_;
    QPushButton* stop_;
    QPushButton* reveal_;
    bool asking_ = false;  ///< whether the file that exists may be replaced
    bool running_ = false;
    QString written_;
    QTimer timer_;
    std::atomic<double> done_ = 0;
    std::stop_source stopSource_;
    LatestWorker worker_;  ///< last: it uses the others
};

}  // namespace isoscope
