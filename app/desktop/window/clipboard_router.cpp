// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/clipboard_router.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QLineEdit>
#include <QMainWindow>
#include <QTextEdit>

#include "app/desktop/window/actions.h"
#include "widgets/editor/scene_editor.h"

namespace isoscope {

ClipboardRouter::ClipboardRouter(QMainWindow* window, SceneEditor* editor, const Actions& actions)
    : QObject(window), window_(window), editor_(editor) {
    const auto on = [this](QAction* action, const char* slot) {
        connect(action, &QAction::triggered, this, [this, slot] { edit(slot); });
    };
    on(actions.cut, "cut");
    on(actions.copy, "copy");
    on(actions.paste, "paste");
    on(actions.selectAll, "selectAll");
}

void ClipboardRouter::edit(const char* slot) {
    QWidget* focused = window_->focusWidget();
    if (qobject_cast<QLineEdit*>(focused) || qobject_cast<QAbstractSpinBox*>(focused)) {
        auto* field = qobject_cast<QLineEdit*>(focused);
        if (!field) field = focused->findChild<QLineEdit*>();
        if (field && QMetaObject::invokeMethod(field, slot)) return;
    }
    // What can only be read has nothing to cut, nor room to paste.
    auto* page = qobject_cast<QTextEdit*>(focused);
    const bool reads = qstrcmp(slot, "copy") == 0 || qstrcmp(slot, "selectAll") == 0;
    QMetaObject::invokeMethod(page && reads ? static_cast<QWidget*>(page) : editor_, slot);
}

}  // namespace isoscope
