// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pictures/picture_forecast.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/study/accuracy/povray_time.h"
#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/studies/cost_strip.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

/// Counts for POV-Ray are taken in a picture of this width.
constexpr int countedWidth = 120;

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

/// Of work that all cores share.
QString timeOf(double processorSeconds) {
    constexpr double least = 0.095;
    const double seconds = processorSeconds / cores();
    return seconds < least ? PictureForecast::tr("0.1 s or less") : roughTime(seconds);
}

QString percent(double share) { return QString::number(std::lround(100 * share)); }

}  // namespace

PictureForecast::PictureForecast(QObject* parent) : QObject(parent) {
    pause_.setSingleShot(true);
    pause_.setInterval(timing::settlePause);
    connect(&pause_, &QTimer::timeout, this, &PictureForecast::begin);
}

PictureForecast::~PictureForecast() { stop_.request_stop(); }

void PictureForecast::follow(const RenderRequest& request) {
    stop();
    request_ = request;
    own_ = {};
    povray_.reset();
    pending_ = request_.scene != nullptr;
    if (pending_) pause_.start();
    emit changed();
}

void PictureForecast::stop() {
    stop_.request_stop();
    ++generation_;
    pause_.stop();
    pending_ = false;
}

void PictureForecast::begin() {
    stop_ = std::stop_source();
    worker_.submit([this, request = request_, generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        const auto tell = [this, generation](auto change) {
            QMetaObject::invokeMethod(
                this,
                [this, generation, change] {
                    if (generation != generation_) return;
                    change();
                    emit changed();
                },
                Qt::QueuedConnection);
        };
        predictPictureTime(request, {}, either.token(),
                           [&](const PictureTime& time) { tell([this, time] { own_ = time; }); });
        std::optional<double> povray;
        if (!request.scene->isosurfaces.empty() && !either.requested()) {
            const PovrayCounts counts =
                countForPovray(request, std::min(request.width, countedWidth), either.token());
            if (counts.complete)
                povray = povraySeconds(counts, static_cast<double>(request.width) * request.height);
        }
        tell([this, povray] {
            povray_ = povray;
            pending_ = false;
        });
    });
}

QString PictureForecast::text() const {
    if (own_.squares == 0) return pending_ ? tr("Being measured…") : QString();
    QString text = tr("Here about %1 (±%2 %)").arg(timeOf(own_.cpuSeconds), percent(own_.error));
    if (povray_)
        text += (request_.antialias ? tr(", POV-Ray without smooth edges about %1 (±%2 %)")
                                    : tr(", POV-Ray about %1 (±%2 %)"))
                    .arg(timeOf(*povray_), percent(povrayTimeError));
    return text;
}

}  // namespace isoscope
