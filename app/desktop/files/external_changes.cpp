// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/external_changes.h"

#include <QEvent>
#include <QWidget>
#include <utility>

#include "widgets/document/difference_window.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

namespace isoscope {

namespace {

const QString topic = QStringLiteral("disk");

}  // namespace

ExternalChanges::ExternalChanges(const Parts& parts) : QObject(parts.window), parts_(parts) {
    connect(&watch_, &FileWatch::touched, this, [this] { look(); });
    connect(parts_.document, &Document::changed, this, &ExternalChanges::follow);
    parts_.window->installEventFilter(this);
}

bool ExternalChanges::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::WindowActivate) look();
    return QObject::eventFilter(watched, event);
}

void ExternalChanges::follow() {
    const QString path = parts_.document->filePath();
    if (path != std::exchange(path_, path)) {
        ignored_.clear();
        parts_.notices->withdraw(topic);
        if (difference_) difference_->close();
    }
    watch_.watch(path);
}

void ExternalChanges::setFollowing(bool following) {
    following_ = following;
    if (following) look();
}

void ExternalChanges::look(bool thorough) {
    Document* document = parts_.document;
    const Document::OnDisk found = document->onDisk(thorough);
    document->setMissing(found == Document::OnDisk::missing);
    if (found == Document::OnDisk::same) {
        ignored_.clear();
        parts_.notices->withdraw(topic);
    } else if (document->diskDigest() != ignored_) {
        found == Document::OnDisk::changed ? tellChanged(false) : tellMissing(false);
    }
}

bool ExternalChanges::maySave() {
    const Document::OnDisk found = parts_.document->onDisk(true);
    if (found == Document::OnDisk::same) return true;
    found == Document::OnDisk::changed ? tellChanged(true) : tellMissing(true);
    return false;
}

void ExternalChanges::tellChanged(bool saving) {
    const QString name = parts_.document->name();
    const NoticeBar::Choice difference{tr("See the Difference"),
                                       tr("Show the lines in which the disk and the editor differ"),
                                       [this, saving] { showDifference(saving); }};
    if (!saving && following_ && !parts_.document->isModified()) {
        parts_.notices->withdraw(topic);
        return emit reloadRequested();
    }
    if (!saving && !parts_.document->isModified())
        return parts_.notices->ask(
            tr("Another program changed %1.").arg(name),
            {{tr("Reload"), tr("Show what stands on the disk now"), [this] { emit reloadRequested(); }},
             difference,
             {tr("Ignore"), tr("Go on with the text as it is here; saving asks again"),
              [this] { ignore(); }}},
            topic);
    parts_.notices->ask(
        saving ? tr("Not saved: another program changed %1 meanwhile.").arg(name)
               : tr("Another program changed %1, and so did you.").arg(name),
        {{tr("Take Theirs"), tr("Show what stands on the disk now; Undo brings your text back"),
          [this] { emit reloadRequested(); }},
         difference,
         {saving ? tr("Save Mine") : tr("Keep Mine"),
          saving ? tr("Replace the file by the text of the editor")
                 : tr("Go on with your text; saving replaces the file"),
          [this, saving] { keepMine(saving); }},
         {tr("Not Now"), tr("Change nothing, neither here nor on the disk"), [this] { ignore(); }}},
        topic);
}

void ExternalChanges::tellMissing(bool saving) {
    const QString path = parts_.document->filePath();
    parts_.notices->ask(
        saving ? tr("Not saved: %1 is no longer there.").arg(path)
               : tr("%1 is no longer there; its text stands only here.").arg(path),
        {{tr("Write It Again"), tr("Save the text under its old name"), [this] { emit saveRequested(); }},
         {tr("Save As…"), tr("Save the text under another name"), [this] { emit saveAsRequested(); }},
         {tr("Not Now"), tr("Leave the file away; the text counts as unsaved"), [this] { ignore(); }}},
        topic);
}

void ExternalChanges::keepMine(bool saving) {
    if (saving) return emit saveRequested();
    parts_.document->acceptDisk();
}

void ExternalChanges::ignore() { ignored_ = parts_.document->diskDigest(); }

void ExternalChanges::showDifference(bool saving) {
    // The question stays until it is answered.
    tellChanged(saving);
    const std::optional<QString> onDisk = parts_.document->textOnDisk();
    if (!onDisk) return look(true);
    if (difference_) difference_->close();
    difference_ =
        new DifferenceWindow(parts_.document->name(), *onDisk, parts_.editor->sceneText(), parts_.window);
    connect(difference_, &DifferenceWindow::takeTheirs, this, [this] {
        parts_.notices->withdraw(topic);
        emit reloadRequested();
    });
    connect(difference_, &DifferenceWindow::keepMine, this, [this] {
        parts_.notices->withdraw(topic);
        keepMine(false);
    });
    difference_->show();
}

}  // namespace isoscope
