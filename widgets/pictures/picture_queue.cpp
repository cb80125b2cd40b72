// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pictures/picture_queue.h"

#include <algorithm>
#include <QFile>
#include <thread>

#include "widgets/either_stop.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

/// All cores, less one for the window where there are enough.
int threadsBeside(int threads) {
    if (threads > 0) return threads;
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return cores > 2 ? cores - 1 : std::max(cores, 1);
}

}  // namespace

PictureQueue::PictureQueue(QObject* parent) : QObject(parent) {
    timer_.setInterval(timing::progressInterval);
    connect(&timer_, &QTimer::timeout, this, &PictureQueue::tellProgress);
}

PictureQueue::~PictureQueue() {
    if (progress_) progress_->stop.request_stop();
}

int PictureQueue::add(const QString& file, const RenderRequest& request, const PictureFileOptions& options) {
    const int number = next_++;
    QueuedPicture picture;
    picture.number = number;
    picture.file = file;
    picture.size = {request.width, request.height};
    pictures_ << picture;
    orders_[number] = {request, options};
    orders_[number].options.threads = threadsBeside(options.threads);
    emit changed(number);
    drawNext();
    return number;
}

QueuedPicture* PictureQueue::find(int number) {
    const auto found = std::find_if(pictures_.begin(), pictures_.end(),
                                    [number](const QueuedPicture& one) { return one.number == number; });
    return found == pictures_.end() ? nullptr : &*found;
}

QueuedPicture PictureQueue::picture(int number) const {
    const auto found = std::find_if(pictures_.begin(), pictures_.end(),
                                    [number](const QueuedPicture& one) { return one.number == number; });
    return found == pictures_.end() ? QueuedPicture() : *found;
}

int PictureQueue::open() const {
    return static_cast<int>(std::count_if(pictures_.begin(), pictures_.end(),
                                          [](const QueuedPicture& one) { return !one.ended(); }));
}

void PictureQueue::drawNext() {
    if (working_ || orders_.empty()) return;
    const auto first = orders_.begin();
    const int number = first->first;
    Order order = std::move(first->second);
    orders_.erase(first);
    QueuedPicture* picture = find(number);
    picture->state = QueuedPicture::State::drawing;
    drawn_ = number;
    working_ = true;
    progress_ = std::make_shared<Progress>();
    begun_ = std::chrono::steady_clock::now();
    timer_.start();
    emit changed(number);
    const std::string file = QFile::encodeName(picture->file).toStdString();
    worker_.submit([this, number, file, order = std::move(order), progress = progress_](std::stop_token end) {
        const EitherStop stop(end, progress->stop.get_token());
        const PictureFileResult result = writePictureFile(file, order.request, order.options, stop.token(),
                                                          [&](double share) { progress->share = share; });
        const QString problem = QString::fromLocal8Bit(result.problem);
        const auto state = result.stopped      ? QueuedPicture::State::stopped
                           : problem.isEmpty() ? QueuedPicture::State::written
                                               : QueuedPicture::State::failed;
        QMetaObject::invokeMethod(
            this,
            [this, number, state, problem] {
                working_ = false;
                finish(number, state, problem);
                drawNext();
            },
            Qt::QueuedConnection);
    });
}

void PictureQueue::tellProgress() {
    QueuedPicture* picture = find(drawn_);
    if (!picture || !progress_) return timer_.stop();
    picture->share = progress_->share;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
    // The first tiles tell little.
    constexpr double fewest = 0.02;
    if (picture->share > fewest) picture->secondsLeft = passed.count() * (1 / picture->share - 1);
    emit changed(drawn_);
}

void PictureQueue::finish(int number, QueuedPicture::State state, const QString& problem) {
    QueuedPicture* picture = find(number);
    if (!picture || picture->ended()) return;
    picture->state = state;
    picture->secondsLeft = -1;
    if (state == QueuedPicture::State::written)
        picture->share = 1;
    else if (state == QueuedPicture::State::failed)
        picture->problem = tr("%1 could not be written: %2.").arg(picture->file, problem);
    else
        picture->problem = tr("Stopped; nothing was written.");
    if (number == drawn_) {
        drawn_ = 0;
        timer_.stop();
    }
    emit changed(number);
    emit ended(number);
}

void PictureQueue::stop(int number) {
    orders_.erase(number);
    if (number == drawn_ && progress_) progress_->stop.request_stop();
    finish(number, QueuedPicture::State::stopped, {});
}

void PictureQueue::stopAll() {
    QList<int> numbers;
    for (const QueuedPicture& picture : pictures_)
        if (!picture.ended()) numbers << picture.number;
    for (const int number : numbers) stop(number);
}

void PictureQueue::forgetEnded() {
    pictures_.removeIf([](const QueuedPicture& picture) { return picture.ended(); });
    emit forgotten();
}

}  // namespace isoscope
