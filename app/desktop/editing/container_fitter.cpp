// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/container_fitter.h"

#include <algorithm>
#include <cmath>

#include "core/study/accuracy/povray_time.h"
#include "widgets/background_priority.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/either_stop.h"
#include "widgets/notice_bar.h"
#include "widgets/numbers/number_text.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

const QString topic = QStringLiteral("container");

/// Two digits, or whole seconds.
QString secondsText(double seconds) {
    return seconds >= 10 ? numberText(std::round(seconds)) : QString::number(seconds, 'g', 2);
}

}  // namespace

ContainerFitter::ContainerFitter(SceneEditor* editor, SceneSession* session, NoticeBar* notices,
                                 QObject* parent)
    : QObject(parent), editor_(editor), session_(session), notices_(notices) {
    slow_.setSingleShot(true);
    slow_.setInterval(timing::progressDelay);
    connect(&slow_, &QTimer::timeout, this, [this] {
        notices_->ask(tr("Looking for the smallest container that is proven to show the same…"),
                      {{tr("&Stop"), tr("Leaves the container as it is"), [this] { stop_.request_stop(); }}},
                      topic);
    });
}

ContainerFitter::~ContainerFitter() = default;

void ContainerFitter::fit() {
    if (working_) return;
    const auto parsed = session_->result();
    const quint64 revision = editor_->revision();
    if (!parsed || session_->resultRevision() != revision || !parsed->scene) {
        emit said(tr("The text is still being read."));
        return;
    }
    const auto& surfaces = parsed->scene->isosurfaces;
    if (surfaces.empty()) {
        emit said(tr("There is no isosurface in the text."));
        return;
    }
    const auto caret = static_cast<std::uint32_t>(editor_->SendScintilla(QsciScintilla::SCI_GETCURRENTPOS));
    std::size_t isosurface = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (surfaces[i].range.file == 0 && surfaces[i].range.begin <= caret && caret <= surfaces[i].range.end)
            isosurface = i;
    working_ = true;
    stop_ = {};
    slow_.start();
    emit said(tr("Looking for the smallest container…"));
    worker_.submit(
        [this, parsed, revision, isosurface, user = stop_.get_token()](const std::stop_token& ending) {
            lowerThreadPriority();
            const EitherStop stop(user, ending);
            const Result result = work(*parsed, isosurface, stop.token());
            QMetaObject::invokeMethod(
                this, [this, parsed, revision, result] { finish(*parsed, revision, result); });
        });
}

void ContainerFitter::finish(const ParseResult& parsed, quint64 revision, const Result& result) {
    working_ = false;
    slow_.stop();
    notices_->withdraw(topic);
    if (stop_.stop_requested())
        emit said(tr("Stopped; the container is left alone."));
    else if (revision != editor_->revision())
        emit said(tr("The text has changed; its container is left alone."));
    else
        take(parsed, result);
}

ContainerFitter::Result ContainerFitter::work(const ParseResult& parsed, std::size_t isosurface,
                                              const std::stop_token& stop) {
    const Scene& scene = *parsed.scene;
    const auto& surface = scene.isosurfaces[isosurface].shape;
    Result result;
    result.isosurface = isosurface;
    result.fit = fitContainer(surface, *scene.parameterTable, containerReach, stop);
    const std::optional<Container> best = result.fit.best();
    if (!best) return result;
    result.share = volumeOf(*best) / volumeOf(surface->settings().container);
    RenderRequest view;
    view.scene = parsed.scene;
    view.camera = scene.camera;
    view.width = 640;
    view.height = 480;
    const auto seconds = [&] { return povraySeconds(countForPovray(view, 120, stop), 640 * 480); };
    result.seconds = seconds();
    view.scene = sceneWithContainer(scene, *surface, *best);
    result.fitted = seconds();
    return result;
}

void ContainerFitter::take(const ParseResult& parsed, const Result& result) {
    const std::optional<Container> best = result.fit.best();
    if (result.fit.empty) {
        emit said(tr("Nothing of this isosurface is in its container."));
        return;
    }
    if (!best) {
        emit said(tr("No container is proven to show the same with less room."));
        return;
    }
    const auto change = containerChange(*parsed.scene, *parsed.sources, result.isosurface, *best);
    if (!change) {
        emit said(
            tr("The isosurface does not stand in the text itself, or stands for several; its container "
               "is left alone."));
        return;
    }
    editor_->beginDrag();
    editor_->replaceRange(change->range, QString::fromStdString(change->text));
    editor_->endDrag();
    emit said(
        tr("The container has %1 % of its room now; POV-Ray takes about %2 s instead of %3 s at 640 x 480.")
            .arg(numberText(std::max(1.0, std::round(100 * result.share))), secondsText(result.fitted),
                 secondsText(result.seconds)));
}

}  // namespace isoscope
