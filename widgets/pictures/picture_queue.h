// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <QList>
#include <QObject>
#include <QSize>
#include <QString>
#include <QTimer>
#include <stop_token>

#include "core/exchange/picture_file.h"
#include "widgets/latest_worker.h"

namespace isoscope {

/// A picture that is to be drawn into a file, and where it stands.
struct QueuedPicture {
    /// Where a picture stands: it waits, is in the making, or has come to an end in one of three ways.
    enum class State { waiting, drawing, written, stopped, failed };

    int number = 0;  ///< its name in the queue
    QString file;
    QSize size;
    State state = State::waiting;
    double share = 0;  ///< that is drawn
    QString problem;   ///< why there is no file, once there will be none
    double secondsLeft =
        -1;  ///< of a picture that is being drawn, by its pace so far; below 0: not known yet

    /// Nothing more happens to it.
    bool ended() const { return state != State::waiting && state != State::drawing; }
};

/// Draws pictures into files, one after the other, beside the work in the window. A stopped one leaves no
/// file behind, and an existing file as it was.
class PictureQueue : public QObject {
    Q_OBJECT
  public:
    explicit PictureQueue(QObject* parent = nullptr);
    /// Stops what is drawn.
    ~PictureQueue() override;

    /// Puts a picture at the end. Returns its number, never 0.
    int add(const QString& file, const RenderRequest& request, const PictureFileOptions& options);
    /// A waiting picture is not drawn, one that is being drawn is given up; both at once.
    void stop(int number);
    void stopAll();
    /// Takes the pictures that have ended off the list.
    void forgetEnded();

    /// In the order in which they were added.
    const QList<QueuedPicture>& pictures() const { return pictures_; }
    /// The picture of this number; one of number 0 where there is none.
    QueuedPicture picture(int number) const;
    /// Pictures that are drawn, or wait for it.
    int open() const;

  signals:
    /// The picture was added, drawn further, or has ended.
    void changed(int number);
    void ended(int number);
    /// Pictures have left the list.
    void forgotten();

  private:
    struct Order {
        RenderRequest request;
        PictureFileOptions options;
    };
    struct Progress {
        std::atomic<double> share = 0;
        std::stop_source stop;
    };

    QueuedPicture* find(int number);
    void drawNext();
    void tellProgress();
    void finish(int number, QueuedPicture::State state, const QString& problem);

    QList<QueuedPicture> pictures_;
    std::map<int, Order> orders_;  ///< of the pictures that wait
    int next_ = 1;
    int drawn_ = 0;         ///< number of the picture in the making; 0: none
    bool working_ = false;  ///< the worker has a picture, which may be stopped already
    std::shared_ptr<Progress> progress_;
    std::chrono::steady_clock::time_point begun_;
    QTimer timer_;
    LatestWorker worker_;  // last: its task refers to the queue
};

}  // namespace isoscope
