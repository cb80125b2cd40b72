// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/command_keys.h"

#include <algorithm>
#include <QAction>
#include <QSettings>

#include "app/desktop/window/actions.h"
#include "widgets/editor/editor_keys.h"

namespace isoscope {
namespace {

QString keyOf(const QAction* action) { return QStringLiteral("keys/") + action->objectName(); }

/// The editor's name for these keys; empty where they mean nothing in the text.
QString nameInText(QKeyCombination keys) {
    for (const EditorKey& entry : editorKeys())
        for (const QKeyCombination key : entry.keys) {
            const QKeyCombination selecting(key.keyboardModifiers() | Qt::ShiftModifier, key.key());
            if (keys == key || (entry.selecting != 0 && keys == selecting)) return entry.name;
        }
    return {};
}

}  // namespace

CommandKeys::CommandKeys(const Actions* actions, QObject* parent) : QObject(parent), actions_(actions) {
    for (const QAction* action : actions_->all()) usual_[action] = action->shortcuts();
    read();
}

QString CommandKeys::refusal(const QKeySequence& keys) {
    if (keys.count() > 1) return tr("A command has one combination of keys, not several in a row.");
    if (keys.isEmpty()) return {};
    const QKeyCombination one = keys[0];
    const bool plain = !(one.keyboardModifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    const bool function = one.key() >= Qt::Key_F1 && one.key() <= Qt::Key_F35;
    if (const QString name = nameInText(one); !name.isEmpty())
        return tr("These keys belong to the text: %1.").arg(name);
    if (plain && !function) return tr("A letter alone is text; add Ctrl or Alt.");
    return {};
}

QAction* CommandKeys::owner(const QKeySequence& keys) const {
    const auto& all = actions_->all();
    const auto found =
        std::ranges::find_if(all, [&](const QAction* action) { return action->shortcuts().contains(keys); });
    return keys.isEmpty() || found == all.end() ? nullptr : *found;
}

bool CommandKeys::isUsual(const QAction* action) const { return action->shortcuts() == usual_.value(action); }

bool CommandKeys::assign(QAction* action, const QKeySequence& keys) {
    if (!refusal(keys).isEmpty()) return false;
    const QList<QKeySequence> list = keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys};
    takeFromOthers(action, list);
    give(action, list);
    store(action);
    emit changed();
    return true;
}

void CommandKeys::reset(QAction* action) {
    const QList<QKeySequence> keys = usual_.value(action);
    takeFromOthers(action, keys);
    give(action, keys);
    store(action);
    emit changed();
}

void CommandKeys::resetAll() {
    for (QAction* action : actions_->all()) {
        give(action, usual_.value(action));
        store(action);
    }
    emit changed();
}

void CommandKeys::read() {
    const QSettings settings;
    for (QAction* action : actions_->all()) {
        const QVariant stored = action->objectName().isEmpty() ? QVariant() : settings.value(keyOf(action));
        if (!stored.isValid()) continue;
        QList<QKeySequence> keys;
        for (const QKeySequence& sequence :
             QKeySequence::listFromString(stored.toString(), QKeySequence::PortableText))
            if (!sequence.isEmpty() && (usual_[action].contains(sequence) || refusal(sequence).isEmpty()))
                keys << sequence;
        // A newer program may have given the same keys to another command.
        takeFromOthers(action, keys);
        give(action, keys);
    }
}

void CommandKeys::give(QAction* action, const QList<QKeySequence>& keys) {
    if (action->shortcuts() == keys) return;
    action->setShortcuts(keys);
    action->setToolTip(Actions::toolTip(action->statusTip(), action->shortcut()));
}

void CommandKeys::takeFromOthers(const QAction* action, const QList<QKeySequence>& keys) {
    for (QAction* other : actions_->all()) {
        if (other == action) continue;
        QList<QKeySequence> left = other->shortcuts();
        if (left.removeIf([&](const QKeySequence& one) { return keys.contains(one); }) == 0) continue;
        give(other, left);
        store(other);
    }
}

void CommandKeys::store(const QAction* action) const {
    QSettings settings;
    if (action->objectName().isEmpty()) return;
    if (isUsual(action)) return settings.remove(keyOf(action));
    settings.setValue(keyOf(action),
                      QKeySequence::listToString(action->shortcuts(), QKeySequence::PortableText));
}

}  // namespace isoscope
