// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace isoscope {

/// The clock of what moves by itself: it asks for the next value when the picture of the last one is
/// finished, so that none waits in a queue, at most 60 times in a second; and it hears Escape, wherever the
/// focus is, while it runs.
class PlayClock : public QObject {
    Q_OBJECT
  public:
    explicit PlayClock(QObject* parent = nullptr);
    ~PlayClock() override;

    /// Begins at 0 seconds; one that runs begins anew, without another question.
    void start();
    void stop();
    bool isRunning() const { return running_; }
    /// Since the start.
    double seconds() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }
    /// The answer to due(): another value is shown, whose picture is waited for, or none.
    void tellShown(bool changed);

  public slots:
    /// The picture of the latest scene is complete, or will not come.
    void pictureFinished();

  signals:
    /// The next value may be shown; answered by tellShown() or stop().
    void due();
    void escaped();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QElapsedTimer clock_;
    qint64 due_ = 0;  ///< nanoseconds of the clock at which the next value may be shown
    QTimer next_;
    bool running_ = false;
    bool awaited_ = false;  ///< the picture of the present value
};

}  // namespace isoscope
