// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;
class QWidget;

namespace isoscope {

class ElidedLabel;
class PictureQueue;
struct QueuedPicture;

/// Lists the pictures of a queue, each with its progress and a button that stops it, or opens it once it is
/// there.
class PictureQueueWindow : public QDialog {
    Q_OBJECT
  public:
    /// `queue` must outlive the window.
    explicit PictureQueueWindow(PictureQueue* queue, QWidget* parent = nullptr);

    /// What is said of a picture; empty where it is not listed.
    QString stateText(int number) const;
    /// Stops a picture, or opens it; null where it is not listed.
    QToolButton* button(int number) const;

  private:
    struct Row {
        QWidget* widget;
        ElidedLabel* name;
        QLabel* state;
        QProgressBar* progress;
        QToolButton* button;
    };

    Row makeRow(int number);
    void showPicture(int number);
    void forgetEnded();
    void showEmptiness();
    void act(int number);

    PictureQueue* queue_;
    std::map<int, Row> rows_;
    QVBoxLayout* list_;
    QLabel* none_;
    QPushButton* stopAll_;
    QPushButton* clear_;
};

}  // namespace isoscope
