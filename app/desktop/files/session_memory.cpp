// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/session_memory.h"

#include <algorithm>
#include <cmath>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QSettings>
#include <utility>

#include "core/scene/orbit_view.h"
#include "widgets/document/document.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

const QString fileKey = QStringLiteral("session/file");
const QString caretKey = QStringLiteral("session/caret");
const QString lineKey = QStringLiteral("session/firstLine");
const QString viewKey = QStringLiteral("session/view");

/// So that a number comes back as it was.
constexpr int exactDigits = 17;

QVariantList numbersOf(Camera camera) {
    QVariantList numbers;
    for (const glm::dvec3* vector : movableVectors(camera))
        for (int axis = 0; axis < 3; ++axis) numbers << QString::number((*vector)[axis], 'g', exactDigits);
    return numbers;
}

}  // namespace

SessionMemory::SessionMemory(const Parts& parts, std::function<void()> writeWindow)
    : QObject(parts.window), parts_(parts), writeWindow_(std::move(writeWindow)) {
    timer_.setSingleShot(true);
    timer_.setInterval(pause);
    connect(&timer_, &QTimer::timeout, this, &SessionMemory::write);
    connect(parts_.editor, &SceneEditor::caretMoved, this, &SessionMemory::changed);
    connect(parts_.document, &Document::changed, this, &SessionMemory::changed);
    connect(parts_.viewport, &Viewport::viewChanged, this, &SessionMemory::changed);
    connect(parts_.session, &SceneSession::sceneChanged, this, &SessionMemory::restoreView,
            Qt::QueuedConnection);  // when the viewport has the scene
    parts_.window->installEventFilter(this);
    for (QDockWidget* dock : parts_.window->findChildren<QDockWidget*>()) dock->installEventFilter(this);
}

void SessionMemory::begin() {
    begun_ = true;
    changed();
}

void SessionMemory::changed() {
    // Not restarted: somebody who moves things without a pause is remembered, too.
    if (begun_ && !timer_.isActive()) timer_.start();
}

bool SessionMemory::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Resize:
        case QEvent::Move:
        case QEvent::Show:
        case QEvent::Hide:
        case QEvent::WindowStateChange: changed(); break;
        default: break;
    }
    return QObject::eventFilter(watched, event);
}

QString SessionMemory::lastFile() { return QSettings().value(fileKey).toString(); }

void SessionMemory::write() {
    timer_.stop();
    if (!begun_) return;
    writeWindow_();
    QSettings settings;
    settings.setValue(fileKey, parts_.document->filePath());
    settings.setValue(caretKey, qlonglong(parts_.editor->SendScintilla(QsciScintilla::SCI_GETCURRENTPOS)));
    settings.setValue(lineKey, parts_.editor->firstVisibleLine());
    const bool moved = parts_.viewport->viewMoved();
    settings.setValue(viewKey, moved ? numbersOf(parts_.viewport->camera()) : QVariantList());
    // Written when the program ends otherwise, or whenever Qt sees fit.
    settings.sync();
}

void SessionMemory::restore() {
    const QSettings settings;
    const qlonglong caret = settings.value(caretKey).toLongLong();
    if (caret > 0 && caret <= parts_.editor->length()) {
        parts_.editor->SendScintilla(QsciScintilla::SCI_GOTOPOS, static_cast<unsigned long>(caret));
        parts_.editor->setFirstVisibleLine(settings.value(lineKey).toInt());
    }
    view_.clear();
    for (const QVariant& number : settings.value(viewKey).toList()) view_ << number.toDouble();
}

void SessionMemory::restoreView() {
    if (!parts_.viewport->scene()) return;
    const QList<double> numbers = std::exchange(view_, {});
    Camera camera = parts_.viewport->camera();
    const auto vectors = movableVectors(camera);
    if (numbers.size() != 3 * std::ssize(vectors) ||
        !std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
        return;
    for (int i = 0; i < numbers.size(); ++i) (*vectors[static_cast<std::size_t>(i / 3)])[i % 3] = numbers[i];
    parts_.viewport->showCamera(camera);
}

}  // namespace isoscope
