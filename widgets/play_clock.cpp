// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/play_clock.h"

#include <algorithm>
#include <QApplication>
#include <QKeyEvent>

#include "widgets/timing.h"

namespace isoscope {
namespace {

/// A picture that has not come by now may never come: the next value follows.
constexpr int patience = 5000;
constexpr qint64 framePause = 1'000'000'000 / 60;  // nanoseconds

}  // namespace

PlayClock::PlayClock(QObject* parent) : QObject(parent) {
    next_.setSingleShot(true);
    next_.setTimerType(Qt::PreciseTimer);
    connect(&next_, &QTimer::timeout, this, &PlayClock::due);
}

PlayClock::~PlayClock() = default;

void PlayClock::start() {
    clock_.start();
    due_ = 0;
    if (running_) return;
    running_ = true;
    awaited_ = false;
    qApp->installEventFilter(this);
    next_.start(timing::drainInterval);
}

void PlayClock::stop() {
    running_ = awaited_ = false;
    next_.stop();
    qApp->removeEventFilter(this);
}

void PlayClock::tellShown(bool changed) {
    if (!running_) return;
    if (!changed) return next_.start(timing::drainInterval);
    due_ = std::max(due_ + framePause, clock_.nsecsElapsed());
    awaited_ = true;
    next_.start(patience);
}

void PlayClock::pictureFinished() {
    if (!running_ || !awaited_) return;
    awaited_ = false;
    // What a timer is late is made up for, unless it is much.
    next_.start(static_cast<int>(std::max<qint64>(0, due_ - clock_.nsecsElapsed()) / 1'000'000));
}

bool PlayClock::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != Qt::Key_Escape || key->modifiers() != Qt::NoModifier ||
        QApplication::activePopupWidget())
        return false;
    // The shortcut that the key may be elsewhere is not to act.
    event->accept();
    if (event->type() == QEvent::KeyPress) emit escaped();
    return true;
}

}  // namespace isoscope
