// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QString>

#include "widgets/document.h"
#include "widgets/recent_files.h"
#include "widgets/recovery_store.h"

class QMenu;
class QWidget;

namespace isoscope {

class NoticeBar;
class ParameterBinding;
class SceneEditor;
class SceneSession;
class Viewport;

/// Opens, saves and looks after the text. Nothing unsaved is ever lost and nobody is nagged: a text that
/// makes way for another, or is left unsaved at the end, is kept on disk and offered in the notice bar.
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

    Document* document() { return &document_; }
    RecentFiles* recentFiles() { return &recent_; }

    void newDocument();
    /// A text without a file: an example.
    void showText(const QString& text);
    /// False, with a notice, when the file cannot be read.
    bool openFile(const QString& path);
    void chooseAndOpen();
    bool save();
    bool saveAs();
    bool saveTo(const QString& path);
    /// Offers what earlier runs left unsaved.
    void offerRecovery();
    /// True when the window may close: everything is in a file or kept.
    bool prepareToClose();
    /// Fills the menu with the examples that come with the program.
    void fillExamples(QMenu* menu);

    /// Text of an example by its file name; empty when there is none.
    static QString exampleText(const QString& name);

  signals:
    /// Another text takes the place of the present one: nothing of that may stay.
    void begun();

  private:
    void begin(const QString& text);
    void keepCopy();
    /// The document makes way for another: its kept copy goes, or is left for the notice bar to offer.
    void retireStore(bool unsaved);
    void restore(const QString& id);
    std::unique_ptr<RecoveryStore> makeStore();

    Parts parts_;
    Document document_;
    RecentFiles recent_;
    std::unique_ptr<RecoveryStore> store_;
};

}  // namespace isoscope
