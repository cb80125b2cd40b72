// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/scene_session.h"

#include <algorithm>

#include "core/animation/animation.h"
#include "core/exchange/read_scene.h"
#include "widgets/timing.h"

namespace isoscope {

SceneSession::SceneSession(QObject* parent) : QObject(parent) {
    options_.restrictedReading = true;
    timer_.setSingleShot(true);
    timer_.setInterval(timing::typingPause);
    connect(&timer_, &QTimer::timeout, this, &SceneSession::parseNow);
    readingTimer_.setInterval(timing::progressInterval);
    connect(&readingTimer_, &QTimer::timeout, this, &SceneSession::followReadings);
}

SceneSession::~SceneSession() { stop(); }

void SceneSession::begin(const std::string& file) {
    timer_.stop();
    stop();
    options_.file = file;
    setMoment(std::nullopt);
    ++look_;
    firstOfDocument_ = submitted_ + 1;
    answered_ = submitted_;
    scene_.reset();
    shown_.reset();
    result_.reset();
}

void SceneSession::setFile(const std::string& file) { options_.file = file; }

void SceneSession::setLibraryPaths(std::vector<std::filesystem::path> paths) {
    options_.libraryPaths = std::move(paths);
}

void SceneSession::setText(std::string text, quint64 revision, When when) {
    text_ = std::move(text);
    revision_ = revision;
    ++look_;
    if (when == When::now)
        parseNow();
    else
        timer_.start();
}

bool SceneSession::setParameters(const ParseResult* owner,
                                 const std::vector<std::pair<int, double>>& values) {
    if (!owner || owner != shown_.get()) return false;
    const std::size_t count = scene_->parameterTable->size();
    for (const auto& [slot, value] : values)
        if (slot < 0 || static_cast<std::size_t>(slot) >= count) return false;
    auto table = std::make_shared<std::vector<double>>(*scene_->parameterTable);
    for (const auto& [slot, value] : values) (*table)[static_cast<std::size_t>(slot)] = value;
    auto scene = std::make_shared<Scene>(*scene_);
    scene->parameterTable = std::move(table);
    scene_ = std::move(scene);
    emit sceneChanged(scene_, false);
    return true;
}

void SceneSession::setMoment(const std::optional<Moment>& moment) {
    const ParseOptions none;
    options_.clockOn = moment.has_value();
    options_.clock = moment ? moment->clock : none.clock;
    options_.frameNumber = moment ? moment->frame : none.frameNumber;
    options_.initialFrame = moment ? moment->first : none.initialFrame;
    options_.finalFrame = moment ? moment->last : none.finalFrame;
}

void SceneSession::followParameter(std::string text, quint64 revision) {
    text_ = std::move(text);
    revision_ = revision;
    timer_.start();
}

void SceneSession::parseNow() {
    timer_.stop();
    const std::uint64_t number = ++submitted_;
    const auto reading = std::make_shared<Reading>();
    reading->number = number;
    reading->length = text_.size();
    reading->since.start();
    readings_.push_back(reading);
    ParseOptions parseOptions = options_;
    parseOptions.stop = reading->stop.get_token();
    parseOptions.progress = reading->progress;
    followReadings();
    readingTimer_.start();
    worker_.submit([this, number, look = look_, text = text_, revision = revision_,
                    options = std::move(parseOptions)](std::stop_token) {
        ParseResult read = readScene(text, options);
        addTimelineWarnings(read);
        auto result = std::make_shared<const ParseResult>(std::move(read));
        QMetaObject::invokeMethod(
            this, [=, this] { receive(result, revision, number, look); }, Qt::QueuedConnection);
    });
}

void SceneSession::stop() {
    for (const auto& reading : readings_) reading->stop.request_stop();
}

void SceneSession::followReadings() {
    for (const auto& reading : readings_) {
        if (reading->since.elapsed() < timing::progressDelay) continue;
        if (reading->number != submitted_) {
            reading->stop.request_stop();
            continue;
        }
        slow_ = true;
        const auto place = static_cast<double>(reading->progress->place.load(std::memory_order_relaxed));
        emit readingSlowly(
            static_cast<double>(reading->since.elapsed()) / 1000,
            reading->progress->steps.load(std::memory_order_relaxed),
            std::min(1.0, place / static_cast<double>(std::max<std::size_t>(1, reading->length))));
    }
}

bool SceneSession::endReading(std::uint64_t number) {
    bool overtaken = false;
    for (const auto& reading : readings_)
        if (reading->number == number) overtaken = reading->stop.stop_requested() && number != submitted_;
    std::erase_if(readings_, [number](const auto& reading) { return reading->number <= number; });
    if (readings_.empty()) {
        readingTimer_.stop();
        if (slow_) emit readingEnded();
        slow_ = false;
    }
    return overtaken;
}

void SceneSession::receive(std::shared_ptr<const ParseResult> result, quint64 revision, std::uint64_t number,
                           std::uint64_t look) {
    const bool overtakenByText = endReading(number);
    if (number < firstOfDocument_) return;
    answered_ = number;
    if (overtakenByText) return;
    result_ = result;
    resultRevision_ = revision;
    // An older state of the sliders must not come back while they are being moved.
    const bool overtaken = revision != revision_ && look == shownLook_;
    // A correct scene with nothing in it, that of an empty text for one, is no picture to hold on to.
    const bool hasBetter = shown_ && shown_->ok() && !shown_->scene->objects.empty();
    const bool noneBetter = !hasBetter && !result->scene->objects.empty();
    if (!overtaken && (result->ok() || noneBetter)) show(result, look);
    emit parsed(result, revision);
    if (revision == revision_) emit shownChanged(shownOf(result));
}

SceneSession::Shown SceneSession::shownOf(const std::shared_ptr<const ParseResult>& result) const {
    if (result->ok()) return Shown::complete;
    if (!shown_) return Shown::nothing;
    return shown_ == result ? Shown::partial : Shown::older;
}

void SceneSession::show(std::shared_ptr<const ParseResult> result, std::uint64_t look) {
    const bool sameLook = scene_ && look == shownLook_;
    shownLook_ = look;
    shown_ = std::move(result);
    scene_ = shown_->scene;
    emit sceneChanged(scene_, sameLook);
}

}  // namespace isoscope
