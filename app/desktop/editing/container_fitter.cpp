// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/container_fitter.h"

#include <algorithm>
#include <cmath>

#include "core/study/accuracy/povray_time.h"
#include "core/study/accuracy/scene_variant.h"
#include "widgets/background_priority.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {

namespace {

/// Two digits, or whole seconds.
QString secondsText(double seconds) {
    return seconds >= 10 ? numberText(std::round(seconds)) : QString::number(seconds, 'g', 2);
}

}  // namespace

ContainerFitter::ContainerFitter(SceneEditor* editor, SceneSession* session, QObject* parent)
    : QObject(parent), editor_(editor), session_(session) {}

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
    emit said(tr("Looking for the smallest container…"));
    worker_.submit([this, parsed, revision, isosurface](const std::stop_token& stop) {
        lowerThreadPriority();
        const Result result = work(*parsed, isosurface, stop);
        QMetaObject::invokeMethod(this, [this, parsed, revision, result] {
            working_ = false;
            if (revision == editor_->revision())
                take(*parsed, result);
            else
                emit said(tr("The text has changed; its container is left alone."));
        });
    });
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
    view.scene = sceneVariant(scene, [&](const Isosurface& original, IsosurfaceSettings& settings) {
        if (&original == surface.get()) settings.container = *best;
    });
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
