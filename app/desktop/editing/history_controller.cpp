// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/history_controller.h"

#include <cmath>
#include <QAction>
#include <utility>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/view_controller.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// The numbers of a view that a hand moves.
QByteArray packedView(const OrbitView::State& view) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    OrbitView::State copy = view;
    for (const glm::dvec3* vector : movableVectors(copy.camera))
        stream << vector->x << vector->y << vector->z;
    stream << copy.pivot.x << copy.pivot.y << copy.pivot.z;
    return bytes;
}

/// `present` with those numbers; as it is where they are none.
OrbitView::State unpackedView(const QByteArray& bytes, const OrbitView::State& present) {
    OrbitView::State view = present;
    QDataStream stream(bytes);
    bool finite = true;
    const auto read = [&](glm::dvec3& vector) {
        stream >> vector.x >> vector.y >> vector.z;
        finite = finite && std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
    };
    for (glm::dvec3* vector : movableVectors(view.camera)) read(*vector);
    read(view.pivot);
    return finite && stream.status() == QDataStream::Ok ? view : present;
}

}  // namespace

HistoryController::HistoryController(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      home_(parts.viewport->home()),
      view_(
          parts.editor->history(),
          {[viewport = parts.viewport] { return viewport->view(); },
           [viewport = parts.viewport](const OrbitView::State& view) { viewport->showView(view); },
           [viewport = parts.viewport] { return viewport->isDragging(); }, QStringLiteral("view"), packedView,
           [viewport = parts.viewport](const QByteArray& bytes) {
               return unpackedView(bytes, viewport->view());
           }}),
      plane_(parts.editor->history(),
             {[section = parts.section] { return section->state(); },
              [section = parts.section](const SectionPanel::State& state) { section->showState(state); },
              [parts] { return parts.section->isDragging() || parts.viewport->isDragging(); }}) {
    connectView();
    connectPlane();
    connect(parts.editor, &SceneEditor::textLoaded, this, [this] {
        view_.reset();
        plane_.reset();
    });
    connect(parts.editor->history(), &EditHistory::changed, this, &HistoryController::tellAvailable);
    tellAvailable();
}

void HistoryController::connectView() {
    connect(parts_.viewport, &Viewport::viewChanged, this, [this] {
        if (!held_) followView(std::exchange(joinView_, false));
    });
    connect(parts_.views, &ViewController::followsText, this, [this] { joinView_ = true; });
    connect(parts_.viewport, &Viewport::dragFinished, this, [this] {
        view_.end();
        plane_.end();
    });
}

void HistoryController::followView(bool joined) {
    if (parts_.viewport->home() == home_) return view_.changed(joined);
    home_ = parts_.viewport->home();
    view_.replaced();
}

bool HistoryController::release(bool joined) {
    held_ = false;
    const quint64 before = parts_.editor->history()->serial();
    followView(joined);
    view_.end();
    return parts_.editor->history()->serial() != before;
}

void HistoryController::connectPlane() {
    connect(parts_.section, &SectionPanel::planeChanged, this,
            [this] { parts_.section->isAdopting() ? plane_.replaced() : plane_.changed(); });
    connect(parts_.section, &SectionPanel::dragFinished, this, [this] { plane_.end(); });
}

void HistoryController::tellAvailable() {
    parts_.actions->undo->setEnabled(parts_.editor->isUndoAvailable());
    parts_.actions->redo->setEnabled(parts_.editor->isRedoAvailable());
}

}  // namespace isoscope
