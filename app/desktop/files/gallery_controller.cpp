// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/gallery_controller.h"

#include "app/desktop/editing/insertion_controller.h"
#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/example_menu.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/gallery/gallery_panel.h"
#include "widgets/gallery/gallery_sources.h"
#include "widgets/notice_bar.h"

namespace isoscope {
namespace {

QList<GalleryEntry> exampleEntries() {
    QList<GalleryEntry> entries;
    for (const Example& example : exampleContents()) {
        if (example.name.isEmpty()) continue;
        const QString text = example.text();
        // Its first comment is the title.
        entries.append({GalleryEntry::Kind::example, example.title(), example.name, text, nullptr, {}});
    }
    return entries;
}

}  // namespace

GalleryController::GalleryController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connect(parts_.panel, &GalleryPanel::firstShown, this, [this] {
        builtIn_ = exampleEntries() + functionEntries() + povrayEntries(povrayTemplateFolders());
        fill();
    });
    connect(parts_.panel, &GalleryPanel::openRequested, this, &GalleryController::open);
    connect(parts_.panel, &GalleryPanel::addRequested, this, &GalleryController::addPresent);
    connect(parts_.panel, &GalleryPanel::removeRequested, this, &GalleryController::remove);
}

void GalleryController::fill() { parts_.panel->setEntries(own_.entries() + builtIn_); }

void GalleryController::open(const GalleryEntry& entry) {
    // Examples and the person's own scenes have the view that was chosen for them.
    const bool composed = entry.kind == GalleryEntry::Kind::example || entry.kind == GalleryEntry::Kind::own;
    parts_.documents->showText(entry.text, entry.title, [this, composed] {
        if (!composed) parts_.insertions->fitNext();
    });
}

void GalleryController::addPresent() {
    QString title = parts_.documents->title();
    title.remove(QStringLiteral("[*]"));
    if (!own_.add(title, parts_.editor->text())) {
        parts_.notices->tell(tr("The text could not be kept in your collection."));
        return;
    }
    fill();
    emit said(tr("Added to your collection."));
}

void GalleryController::remove(const GalleryEntry& entry) {
    if (!own_.remove(entry.file)) {
        parts_.notices->tell(tr("“%1” could not be removed.").arg(entry.title));
        return;
    }
    fill();
    const auto undo = [this, entry] {
        if (own_.add(entry.title, entry.text)) fill();
    };
    parts_.notices->ask(tr("“%1” is removed from your collection.").arg(entry.title),
                        {{tr("Undo"), tr("Put it back into your collection"), undo},
                         {tr("Close"), tr("Leave it removed"), {}}},
                        QStringLiteral("gallery"));
}

}  // namespace isoscope
