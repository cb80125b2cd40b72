// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QObject>
#include <QPointer>
#include <QString>

#include "widgets/document/document.h"
#include "widgets/document/recent_files.h"
#include "widgets/document/recovery_store.h"
#include "widgets/editor/edit_journal.h"

class QWidget;

namespace isoscope {

class ExternalChanges;
class HistoryKeeper;
class KeptTextsWindow;
class NoticeBar;
class ParameterBinding;
class SceneEditor;
class SceneSession;
class Viewport;

/// Opens, saves and looks after the text. Nothing unsaved is ever lost: a text of a file that makes way for
/// another, or is to be left unsaved at the end, is asked about once, in the notice bar; one without a file
/// is kept. Kept texts are offered at the next start, and stand in a list.
class DocumentController : public QObject {
    Q_OBJECT
  public:
    /// All parts belong to `window` and outlive the controller.
    struct Parts {
        QWidget* window;
        SceneEditor* editor;
        SceneSession* session;
        ParameterBinding* binding;
        Viewport* viewport;
        NoticeBar* notices;
    };
    explicit DocumentController(const Parts& parts);
    ~DocumentController() override;

    /// The file of the text and the files opened last; owned by this.
    Document* document() { return &document_; }
    RecentFiles* recentFiles() { return &recent_; }

    /// For the window: the name with Qt's "[*]", and where the file is or that the text is kept.
    QString title() const;

    /// The first document of a run: `file`, else that of the last run, else the tutorial; and offers what
    /// was kept. Returns why `file` cannot be read, which a notice says as well; else empty.
    QString start(const QString& file);
    void newDocument();
    /// A text without a file; `then` is called when it is there.
    void showText(const QString& text, const QString& name = {}, const std::function<void()>& then = {});
    /// An example by its file name, under its title.
    void showExample(const QString& name);
    /// A scene of a lesson; `asPovray` tells that it shows what POV-Ray's root finder makes of it.
    void showLesson(const QString& text, const QString& title, bool asPovray);
    /// False, with a notice, when the file cannot be read. Unsaved text may have to be asked about first;
    /// then it is opened with the answer.
    bool openFile(const QString& path);
    void chooseAndOpen();
    bool save();
    bool saveAs();
    bool saveTo(const QString& path);
    /// Offers what earlier runs left unsaved; "later" means the next start.
    void offerRecovery();
    /// The list of kept texts.
    void showKeptTexts();
    /// True when the window may close: everything is in a file, kept or given up. Else the notice bar asks,
    /// and closes the window with the answer.
    bool prepareToClose();
    /// Whether changes that other programs make are taken over unasked, as ExternalChanges::setFollowing().
    void setFollowing(bool following);
    /// Writes the undo history now, if anything of it waits.
    void keepHistory();

  signals:
    /// Another text takes the place of the present one: nothing of that may stay.
    void begun();
    /// An example or a lesson was opened that shows what POV-Ray's root finder makes of it.
    void povrayLessonShown();
    /// The document of the last run is back.
    void resumed();
    void titleChanged();
    /// The text was saved, or read again: it is that of the file.
    void agreesWithFile();
    /// For the status line.
    void said(const QString& message);

  private:
    /// What becomes of the text that makes way.
    enum class Fate { saved, kept, discarded };
    using Next = std::function<void(Fate)>;

    /// Calls `next` when the present text may go: at once, or with the answer to the question.
    void leave(const Next& next);
    void askAboutLeaving(const QString& question, bool canKeep, const Next& next);
    bool openNow(const QString& path, Fate fate);
    bool write(const QString& path);
    void reload();
    /// With a past, the text comes with the undo history of an earlier run.
    void begin(const QString& text, const std::optional<EditJournal>& past = {});
    void keepCopy();
    /// The document makes way for another: its kept copy goes, or is left for the notice bar to offer.
    void retireStore(Fate fate);
    void restore(const QString& id);
    void restoreNow(const QString& id, Fate fate);
    void listKeptTexts();
    std::unique_ptr<RecoveryStore> makeStore();

    Parts parts_;
    Document document_;
    RecentFiles recent_;
    std::unique_ptr<RecoveryStore> store_;
    HistoryKeeper* history_;
    ExternalChanges* external_;
    QPointer<KeptTextsWindow> keptTexts_;
    bool mayClose_ = false;  ///< the question was answered
};

}  // namespace isoscope
