// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/gallery_controller.h"

#include "app/desktop/editing/insertion_controller.h"
#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/example_menu.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/gallery/gallery_panel.h"
#include "widgets/gallery/gallery_sources.h"
#include "app/desktop/files/start_page.h"
#include "widgets/notice_bar.h"

namespace isoscope {
namespace {

/// What a person can learn or change in an example.
QString sentenceOf(const Example& example) {
    const std::pair<const char*, QString> sentences[] = {
        {"tutorial.pov",
         GalleryController::tr("Two shapes with a blend between them, and what each number does.")},
        {"sphere.pov", GalleryController::tr("What a wrong max_gradient does to POV-Ray's picture.")},
        {"twisted_box.pov", GalleryController::tr("A box whose cross-section turns with its height.")},
        {"blob_product.pov", GalleryController::tr("The product of two functions melts their surfaces.")},
        {"heart.pov", GalleryController::tr("A polynomial of the sixth degree.")},
        {"noise_rock.pov", GalleryController::tr("Noise added to a ball makes a stone of it.")},
        {"terrain.pov", GalleryController::tr("A height for every place, from f_ridged_mf.")},
        {"gyroid.pov", GalleryController::tr("Sines and cosines that part space into two halves.")},
        {"klein_bottle.pov", GalleryController::tr("A surface without inside or outside.")},
        {"set_operators.vl", GalleryController::tr("VirtuaLight: union, intersection and the rest.")},
        {"virtualight_surfaces.vl", GalleryController::tr("VirtuaLight: surfaces that it knows by name.")},
        {"virtualight_polynomials.vl",
         GalleryController::tr("VirtuaLight: polynomials by their coefficients.")},
        {"virtualight_implicit.vl", GalleryController::tr("VirtuaLight: formulas of your own.")},
    };
    for (const auto& [name, sentence] : sentences)
        if (example.name == QLatin1String(name)) return sentence;
    return {};
}

QList<GalleryEntry> exampleEntries() {
    QList<GalleryEntry> entries;
    for (const Example& example : exampleContents()) {
        if (example.name.isEmpty()) continue;
        const QString text = example.text();
        // Its first comment is the title.
        entries.append({GalleryEntry::Kind::example,
                        example.title(),
                        sentenceOf(example),
                        text,
                        nullptr,
                        {},
                        example.asPovray,
                        true});
    }
    return entries;
}

}  // namespace

GalleryController::GalleryController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connectPanel(parts_.panel);
}

void GalleryController::connectPanel(GalleryPanel* panel) {
    connect(panel, &GalleryPanel::firstShown, this, &GalleryController::load);
    connect(panel, &GalleryPanel::openRequested, this, &GalleryController::open);
    connect(panel, &GalleryPanel::insertRequested, parts_.insertions, &InsertionController::insertStatement);
    connect(panel, &GalleryPanel::addRequested, this, &GalleryController::addPresent);
    connect(panel, &GalleryPanel::removeRequested, this, &GalleryController::remove);
    connect(panel, &GalleryPanel::renameRequested, this, &GalleryController::rename);
}

void GalleryController::showPage() {
    if (!page_) {
        page_ = new StartPage(parts_.host);
        connectPanel(page_->gallery());
        connect(page_, &StartPage::newRequested, parts_.documents, &DocumentController::newDocument);
        connect(page_, &StartPage::fileRequested, parts_.documents, &DocumentController::chooseAndOpen);
        connect(page_, &StartPage::lessonsRequested, this, &GalleryController::lessonsRequested);
        // Who changes the scene, or opens another one, wants to see it.
        connect(parts_.documents, &DocumentController::begun, page_, &StartPage::leave);
        connect(parts_.editor, &SceneEditor::textEdited, page_, &StartPage::leave);
        connect(parts_.editor, &SceneEditor::numberReplaced, page_, &StartPage::leave);
    }
    page_->open();
}

void GalleryController::load() {
    if (builtIn_.isEmpty())
        builtIn_ =
            exampleEntries() + lessonEntries() + functionEntries() + povrayEntries(povrayTemplateFolders());
    fill();
}

void GalleryController::fill() {
    const QList<GalleryEntry> all = own_.entries() + builtIn_;
    parts_.panel->setEntries(all);
    if (page_) page_->gallery()->setEntries(all);
}

void GalleryController::open(const GalleryEntry& entry) {
    if (entry.composed) return parts_.documents->showLesson(entry.text, entry.title, entry.asPovray);
    parts_.documents->showText(entry.text, entry.title, [this] { parts_.insertions->fitNext(); });
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

void GalleryController::rename(const GalleryEntry& entry, const QString& title) {
    if (!own_.rename(entry.file, title))
        return parts_.notices->tell(tr("“%1” could not be renamed.").arg(entry.title));
    fill();
    emit said(tr("Renamed to “%1”.").arg(title));
}

}  // namespace isoscope
