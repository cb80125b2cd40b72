// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/document_controller.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>

#include "widgets/notice_bar.h"
#include "widgets/parameter_binding.h"
#include "widgets/save_path.h"
#include "widgets/scene_editor.h"
#include "widgets/scene_session.h"
#include "widgets/viewport.h"

namespace isoscope {

namespace {

const char* const fileFilter =
    QT_TRANSLATE_NOOP("DocumentController", "Scenes (*.pov *.inc *.vl *.vib);;All files (*)");

QString nameOf(const UnsavedText& text) {
    return text.filePath.isEmpty() ? QObject::tr("a new scene") : QFileInfo(text.filePath).fileName();
}

QString readResource(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

DocumentController::DocumentController(const Parts& parts)
    : QObject(parts.window), parts_(parts), store_(makeStore()) {
    SceneEditor* editor = parts_.editor;
    connect(editor, &QsciScintilla::modificationChanged, &document_, &Document::setModified);
    connect(editor, &SceneEditor::textEdited, this, [this] { store_->textChanged(); });
    connect(editor, &SceneEditor::numberReplaced, this, [this] { store_->textChanged(); });
    connect(editor, &SceneEditor::focusLost, this, [this] { store_->flush(); });
    connect(&recent_, &RecentFiles::openRequested, this, &DocumentController::openFile);
}

DocumentController::~DocumentController() = default;

std::unique_ptr<RecoveryStore> DocumentController::makeStore() {
    auto store = std::make_unique<RecoveryStore>([this] {
        UnsavedText text;
        text.filePath = document_.filePath();
        text.text = parts_.editor->sceneText();
        return text;
    });
    connect(store.get(), &RecoveryStore::failed, parts_.notices, &NoticeBar::tell);
    return store;
}

void DocumentController::keepCopy() {
    if (!document_.isModified()) return;
    store_->textChanged();
    store_->flush();
}

void DocumentController::retireStore(bool unsaved) {
    if (!unsaved) {
        store_->markSaved();
        return;
    }
    store_.reset();  // the copy stays and counts as abandoned
    store_ = makeStore();
}

void DocumentController::begin(const QString& text) {
    const std::string file = document_.filePath().toStdString();
    parts_.viewport->clear();
    parts_.binding->clear();
    parts_.session->begin(file);
    emit begun();
    parts_.editor->setSceneText(text);  // the binding hands it to the session
}

void DocumentController::newDocument() { showText(readResource(QStringLiteral(":/templates/new.pov"))); }

void DocumentController::showText(const QString& text) {
    keepCopy();
    retireStore(document_.isModified());
    document_.reset();
    begin(text);
    offerRecovery();
}

bool DocumentController::openFile(const QString& path) {
    keepCopy();
    const bool unsaved = document_.isModified();
    const std::optional<QString> text = document_.load(path);
    if (!text) {
        recent_.remove(path);
        parts_.notices->tell(document_.errorText());
        return false;
    }
    retireStore(unsaved);
    recent_.add(document_.filePath());
    begin(*text);
    offerRecovery();
    return true;
}

void DocumentController::chooseAndOpen() {
    const QString folder = QFileInfo(document_.filePath()).path();
    const QString path =
        QFileDialog::getOpenFileName(parts_.window, tr("Open a scene"), folder, tr(fileFilter));
    if (!path.isEmpty()) openFile(path);
}

bool DocumentController::save() {
    return document_.filePath().isEmpty() ? saveAs() : saveTo(document_.filePath());
}

bool DocumentController::saveAs() {
    const auto& result = parts_.session->result();
    // The ending tells the notation when the file is opened again.
    const QString suffix =
        result && result->notation == Notation::virtualight ? QStringLiteral("vl") : QStringLiteral("pov");
    const QString suggested = document_.filePath().isEmpty()
                                  ? pathInDocuments(QStringLiteral("scene.") + suffix)
                                  : document_.filePath();
    const QString path =
        chooseSavePath(parts_.window, tr("Save the scene"), suggested, tr(fileFilter), suffix);
    return !path.isEmpty() && saveTo(path);
}

bool DocumentController::saveTo(const QString& path) {
    if (!document_.save(path, parts_.editor->sceneText())) {
        parts_.notices->tell(document_.errorText());
        return false;
    }
    parts_.editor->setModified(false);
    store_->markSaved();
    recent_.add(document_.filePath());
    parts_.session->setFile(document_.filePath().toStdString());
    return true;
}

void DocumentController::offerRecovery() {
    const std::vector<UnsavedText> left = store_->abandoned();
    if (left.empty()) return;
    const UnsavedText& first = left.front();
    const QString when = QLocale().toString(first.saved, QLocale::ShortFormat);
    QString text = tr("The unsaved text of %1 (%2) was kept.").arg(nameOf(first), when);
    if (left.size() > 1) text += tr(" There are %1 more.").arg(left.size() - 1);
    const QString id = first.id;
    parts_.notices->ask(
        text, {{tr("Bring Back"), tr("Show the kept text in the editor"), [this, id] { restore(id); }},
               {tr("Discard"), tr("Delete the kept text for good"),
                [this, id] {
                    store_->discard(id);
                    offerRecovery();
                }},
               {tr("Later"), tr("Keep the text and ask at the next start"), {}}});
}

void DocumentController::restore(const QString& id) {
    keepCopy();
    retireStore(document_.isModified());
    const std::optional<UnsavedText> kept = store_->take(id);
    if (!kept) return;
    document_.reset();
    // The file gives the document its name, encoding and line ends; it may be gone by now. The kept text
    // becomes a change of it, so that undo leads back to what is on disk.
    std::optional<QString> saved;
    if (!kept->filePath.isEmpty()) saved = document_.load(kept->filePath);
    begin(saved.value_or(QString()));
    SceneEditor* editor = parts_.editor;
    editor->replaceRange({0, 0, static_cast<std::uint32_t>(editor->length())}, kept->text);
    offerRecovery();
}

bool DocumentController::prepareToClose() {
    if (!document_.isModified()) {
        store_->markSaved();
        return true;
    }
    keepCopy();
    if (store_->errorText().isEmpty()) return true;
    const auto answer =
        QMessageBox::warning(parts_.window, tr("Unsaved text"),
                             tr("The text is not saved and could not be kept: %1").arg(store_->errorText()),
                             QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Save) return save();
    return answer == QMessageBox::Discard;
}

QString DocumentController::exampleText(const QString& name) {
    return readResource(QStringLiteral(":/examples/") + name);
}

void DocumentController::fillExamples(QMenu* menu) {
    for (const QString& name :
         QDir(QStringLiteral(":/examples"))
             .entryList({QStringLiteral("*.pov"), QStringLiteral("*.vl")}, QDir::Files)) {
        // The first line of every example is a comment that says what it shows.
        const QString text = exampleText(name);
        QString title = text.section(QLatin1Char('\n'), 0, 0);
        title.remove(QRegularExpression(QStringLiteral("^/+\\s*|\\.$")));
        QAction* action = menu->addAction(title);
        action->setToolTip(tr("Open the example %1").arg(name));
        connect(action, &QAction::triggered, this, [this, name] { showText(exampleText(name)); });
    }
}

}  // namespace isoscope
