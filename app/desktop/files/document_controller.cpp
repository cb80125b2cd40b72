// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/document_controller.h"

#include <algorithm>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocale>
#include <utility>

#include "app/desktop/files/example_menu.h"
#include "app/desktop/files/external_changes.h"
#include "app/desktop/files/history_keeper.h"
#include "app/desktop/files/session_memory.h"
#include "widgets/document/kept_texts_window.h"
#include "widgets/document/save_path.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/parameters/parameter_binding.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

const char* const fileFilter =
    QT_TRANSLATE_NOOP("isoscope::DocumentController", "Scenes (*.pov *.inc *.vl *.vib);;All files (*)");

const QString recoveryTopic = QStringLiteral("recovery");
const QString leavingTopic = QStringLiteral("leaving");

/// The folder of a file, with the home folder as ~.
QString folderOf(const QString& path) {
    QString folder = QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    if (folder == home || folder.startsWith(home + QLatin1Char('/')))
        folder.replace(0, home.size(), QLatin1String("~"));
    return folder;
}

/// The editor's text becomes `text` by one change of the part that differs.
void rewrite(SceneEditor* editor, const QString& text) {
    const QByteArray before = QByteArray::fromStdString(editor->utf8()), after = text.toUtf8();
    const auto isInside = [](const QByteArray& bytes, qsizetype at) {
        return at < bytes.size() && (static_cast<unsigned char>(bytes[at]) & 0xc0) == 0x80;
    };
    const qsizetype shorter = std::min(before.size(), after.size());
    qsizetype head = 0, tail = 0;
    while (head < shorter && before[head] == after[head]) ++head;
    while (head > 0 && (isInside(before, head) || isInside(after, head))) --head;
    while (tail < shorter - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    while (tail > 0 && isInside(before, before.size() - tail)) --tail;
    editor->replaceRange(
        {0, static_cast<std::uint32_t>(head), static_cast<std::uint32_t>(before.size() - tail)},
        QString::fromUtf8(after.mid(head, after.size() - tail - head)));
}

QString readResource(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

DocumentController::DocumentController(const Parts& parts)
    : QObject(parts.window),
      parts_(parts),
      store_(makeStore()),
      history_(new HistoryKeeper(parts.editor, &document_, this)),
      external_(new ExternalChanges({parts.window, parts.editor, &document_, parts.notices})) {
    SceneEditor* editor = parts_.editor;
    connect(editor, &SceneEditor::modifiedChanged, &document_, &Document::setModified);
    connect(editor, &SceneEditor::textEdited, this, [this] { store_->textChanged(); });
    connect(editor, &SceneEditor::numberReplaced, this, [this] { store_->textChanged(); });
    connect(editor, &SceneEditor::focusLost, this, [this] { store_->flush(); });
    connect(&recent_, &RecentFiles::openRequested, this, &DocumentController::openFile);
    connect(&document_, &Document::changed, this, [this] {
        if (!document_.isModified()) parts_.notices->withdraw(leavingTopic);
        emit titleChanged();
    });
    connect(external_, &ExternalChanges::reloadRequested, this, &DocumentController::reload);
    connect(external_, &ExternalChanges::saveRequested, this, [this] {
        keepCopy();
        write(document_.filePath());
    });
    connect(external_, &ExternalChanges::saveAsRequested, this, &DocumentController::saveAs);
}

DocumentController::~DocumentController() = default;

std::unique_ptr<RecoveryStore> DocumentController::makeStore() {
    auto store = std::make_unique<RecoveryStore>([this] {
        UnsavedText text;
        text.filePath = document_.filePath();
        text.text = parts_.editor->sceneText();
        text.base = document_.digest();
        return text;
    });
    connect(store.get(), &RecoveryStore::kept, this, &DocumentController::titleChanged);
    connect(store.get(), &RecoveryStore::failed, parts_.notices, &NoticeBar::tell);
    return store;
}

void DocumentController::keepCopy() {
    if (!document_.isModified()) return;
    store_->textChanged();
    store_->flush();
}

void DocumentController::retireStore(Fate fate) {
    if (fate != Fate::kept) {
        store_->markSaved();
        return;
    }
    store_.reset();  // the copy stays and counts as abandoned
    store_ = makeStore();
}

QString DocumentController::title() const {
    if (!document_.filePath().isEmpty())
        return document_.title() + QStringLiteral(" – ") + folderOf(document_.filePath());
    return document_.isModified() && store_->isKept() ? tr("%1 (kept)").arg(document_.title())
                                                      : document_.title();
}

void DocumentController::leave(const Next& next) {
    parts_.notices->withdraw(leavingTopic);
    history_->write();
    if (!document_.isModified()) return next(Fate::saved);
    keepCopy();
    const bool kept = store_->errorText().isEmpty();
    if (!document_.filePath().isEmpty())
        return askAboutLeaving(tr("%1 has changes that are not saved.").arg(document_.name()), kept, next);
    if (!kept)
        return askAboutLeaving(
            tr("The text is not saved, and it cannot be kept. %1").arg(store_->errorText()), false, next);
    emit said(tr("The unsaved text is kept; File, Kept Texts brings it back."));
    next(Fate::kept);
}

void DocumentController::askAboutLeaving(const QString& question, bool canKeep, const Next& next) {
    std::vector<NoticeBar::Choice> choices{
        {tr("Save"), tr("Save the text to its file, then go on"), [this, next] {
             if (save()) next(Fate::saved);
         }}};
    if (canKeep)
        choices.push_back({tr("Keep for Next Time"),
                           tr("Leave the file as it is; the text is offered at the next start"),
                           [this, next] {
                               keepCopy();
                               next(Fate::kept);
                           }});
    choices.push_back({tr("Discard"), tr("Give the changes up for good"), [next] { next(Fate::discarded); }});
    choices.push_back({tr("Cancel"), tr("Go on with this text"), {}});
    parts_.notices->ask(question, std::move(choices), leavingTopic);
    parts_.notices->takeFocus();
}

void DocumentController::keepHistory() { history_->write(); }

void DocumentController::begin(const QString& text, const std::optional<EditJournal>& past) {
    const std::string file = document_.filePath().toStdString();
    parts_.viewport->clear();
    parts_.binding->clear();
    parts_.session->begin(file);
    emit begun();
    parts_.editor->setSceneText(text, past ? &*past : nullptr);  // the binding hands it to the session
}

QString DocumentController::start(const QString& file) {
    // A notice about the file covers the offer.
    offerRecovery();
    const QString last = SessionMemory::lastFile();
    const bool opened = (!file.isEmpty() || !last.isEmpty()) && openFile(file.isEmpty() ? last : file);
    const QString problem = opened || file.isEmpty() ? QString() : document_.errorText();
    if (!opened)
        showExample(QStringLiteral("tutorial.pov"));
    else if (file.isEmpty())
        emit resumed();
    return problem;
}

void DocumentController::newDocument() {
    // Behind what every scene begins with.
    showText(readResource(QStringLiteral(":/templates/new.pov")), {},
             [this] { parts_.editor->SendScintilla(QsciScintilla::SCI_DOCUMENTEND); });
}

void DocumentController::showText(const QString& text, const QString& name,
                                  const std::function<void()>& then) {
    leave([this, text, name, then](Fate fate) {
        retireStore(fate);
        document_.reset(name);
        begin(text);
        if (then) then();
    });
}

void DocumentController::showExample(const QString& name) {
    const std::vector<Example> examples = exampleContents();
    const auto found = std::ranges::find(examples, name, &Example::name);
    if (found == examples.end()) return;
    showLesson(found->text(), found->title(), found->asPovray);
}

void DocumentController::showLesson(const QString& text, const QString& title, bool asPovray) {
    showText(text, title, [this, asPovray] {
        if (asPovray) emit povrayLessonShown();
    });
}

bool DocumentController::openFile(const QString& path) {
    // The answer may come later.
    const auto opened = std::make_shared<bool>(true);
    leave([this, path, opened](Fate fate) { *opened = openNow(path, fate); });
    return *opened;
}

bool DocumentController::openNow(const QString& path, Fate fate) {
    const std::optional<QString> text = document_.load(path);
    if (!text) {
        recent_.remove(path);
        parts_.notices->tell(document_.errorText());
        return false;
    }
    retireStore(fate);
    recent_.add(document_.filePath());
    begin(*text, history_->past(*text));
    parts_.editor->setModified(false);
    return true;
}

void DocumentController::chooseAndOpen() {
    const QString folder = QFileInfo(document_.filePath()).path();
    const QString path =
        QFileDialog::getOpenFileName(parts_.window, tr("Open a scene"), folder, tr(fileFilter));
    if (!path.isEmpty()) openFile(path);
}

void DocumentController::setFollowing(bool following) { external_->setFollowing(following); }

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
    keepCopy();  // whatever comes of it; and while a file is written in place, it is the only whole one
    const bool own = QFileInfo(path).absoluteFilePath() == document_.filePath();
    return (!own || external_->maySave()) && write(path);
}

bool DocumentController::write(const QString& path) {
    if (!document_.save(path, parts_.editor->sceneText())) {
        parts_.notices->ask(document_.errorText(),
                            {{tr("Save As…"), tr("Save the text under another name"), [this] { saveAs(); }},
                             {tr("Close"), tr("Hide this line; the text stays here"), {}}},
                            QStringLiteral("save"));
        return false;
    }
    parts_.notices->withdraw(QStringLiteral("save"));
    parts_.editor->setModified(false);
    store_->markSaved();
    recent_.add(document_.filePath());
    parts_.session->setFile(document_.filePath().toStdString());
    emit agreesWithFile();
    emit said(tr("Saved: %1").arg(document_.filePath()));
    return true;
}

void DocumentController::reload() {
    const Fate fate = document_.isModified() ? Fate::kept : Fate::saved;
    keepCopy();
    const std::optional<QString> text = document_.load(document_.filePath());
    if (!text) return parts_.notices->tell(document_.errorText());
    retireStore(fate);
    rewrite(parts_.editor, *text);
    parts_.editor->setModified(false);
    store_->markSaved();
    emit agreesWithFile();
    emit said(tr("Read again: %1").arg(document_.filePath()));
}

void DocumentController::offerRecovery() {
    const std::vector<UnsavedText> left = store_->abandoned();
    if (left.empty()) return;
    const UnsavedText& first = left.front();
    const int count = static_cast<int>(left.size());
    const QString when = QLocale().toString(first.saved.toLocalTime(), QLocale::ShortFormat);
    const QString text =
        count == 1
            ? tr("An unsaved text was kept: %1, %2.").arg(keptName(first), when)
            : tr("%n unsaved texts were kept, the last one: %1, %2.", "", count).arg(keptName(first), when);
    parts_.notices->ask(
        text,
        {{tr("Bring Back"), tr("Show the last kept text in the editor"),
          [this, id = first.id] { restore(id); }},
         {tr("Show…"), tr("List the kept texts with their first lines"), [this] { showKeptTexts(); }},
         {tr("Later"), tr("Keep them, and ask at the next start"), {}}},
        recoveryTopic);
}

void DocumentController::showKeptTexts() {
    if (!keptTexts_) {
        keptTexts_ = new KeptTextsWindow(parts_.window);
        connect(keptTexts_, &KeptTextsWindow::bringBackRequested, this, &DocumentController::restore);
        connect(keptTexts_, &KeptTextsWindow::discardRequested, this, [this](const QStringList& ids) {
            for (const QString& id : ids) store_->discard(id);
            listKeptTexts();
        });
    }
    listKeptTexts();
    keptTexts_->show();
    keptTexts_->raise();
    keptTexts_->activateWindow();
}

void DocumentController::listKeptTexts() {
    const std::vector<UnsavedText> left = store_->abandoned();
    if (left.empty()) parts_.notices->withdraw(recoveryTopic);
    if (keptTexts_) keptTexts_->setTexts(left);
}

void DocumentController::restore(const QString& id) {
    leave([this, id](Fate fate) { restoreNow(id, fate); });
}

void DocumentController::restoreNow(const QString& id, Fate fate) {
    retireStore(fate);
    const std::optional<UnsavedText> kept = store_->take(id);
    listKeptTexts();
    if (!kept) return;
    document_.reset();
    // The file gives the document its name, encoding and line ends; it may be gone by now. The kept text
    // becomes a change of it, so that undo leads back to what is on disk.
    std::optional<QString> saved;
    if (!kept->filePath.isEmpty()) saved = document_.load(kept->filePath);
    const auto past = history_->past(kept->text);
    const auto before =
        past ? past->textAfter(std::max(0, past->saved()), kept->text.toUtf8()) : std::nullopt;
    // With the steps of the earlier run, if they begin with what is on disk.
    if (past && past->saved() >= 0 && before && saved && *before == saved->toUtf8()) {
        begin(kept->text, past);
    } else if (past && before && !saved) {
        begin(kept->text, past);
        parts_.editor->setModified(true);
    } else {
        begin(saved.value_or(QString()));
        parts_.editor->replaceRange({0, 0, static_cast<std::uint32_t>(parts_.editor->length())}, kept->text);
    }
    if (!saved && !kept->filePath.isEmpty())
        emit said(tr("%1 is no longer there; the text has no file now.").arg(kept->filePath));
    // What was written there after the text was kept must not be written over unseen.
    if (saved && *saved != kept->text && !kept->base.isEmpty()) {
        document_.setDigest(kept->base);
        external_->look();
    }
}

bool DocumentController::prepareToClose() {
    if (std::exchange(mayClose_, false)) return true;
    if (document_.isModified() && qGuiApp->isSavingSession()) {
        // The session ends: there is no user left to answer.
        keepCopy();
        return true;
    }
    const auto asking = std::make_shared<bool>(false), answered = std::make_shared<bool>(false);
    leave([this, asking, answered](Fate fate) {
        if (fate != Fate::kept) store_->markSaved();
        *answered = true;
        if (!*asking) return;
        mayClose_ = true;
        parts_.window->close();
    });
    *asking = true;
    return *answered;
}

}  // namespace isoscope
