// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QMainWindow>

#include "app/desktop/studies/study_panels.h"
#include "widgets/theme.h"

class QLabel;

namespace isoscope {

struct ParseResult;

class Actions;
class CommandKeys;
class Docks;
class DocumentController;
class ExportController;
class FileWriter;
class FindBar;
class FunctionBrowser;
class GalleryController;
class GalleryPanel;
class HelpController;
class IncludeViewer;
class ContainerFitter;
class HistoryController;
class InsertionController;
class NoticeBar;
class PaneWalk;
class ParameterBinding;
class ParameterPanel;
class PictureRoom;
class PreviewLight;
class ProblemsPanel;
class ReadingBar;
class SceneEditor;
class SceneDisplay;
class SceneSession;
class SessionMemory;
class SettingWriter;
class StudyController;
class TextFeed;
class TimelineController;
class TimelinePanel;
class VerdictBadge;
class ViewController;
class Viewport;
class ViewportPanel;
class WindowChoices;

/// The window: makes the panels and connects them; what they do is their own business.
class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    MainWindow();
    ~MainWindow() override;

    /// False, with a notice in the window, when the file cannot be read.
    bool openFile(const QString& path);
    /// Begins with `file`, or with what the last run ended with, at the very first start below the start
    /// page, and remembers from now on. Returns why the file cannot be read, which a notice says as well;
    /// else empty.
    QString start(const QString& file);
    /// The example of the first start.
    void showTutorial();
    /// For this run; what the menu chooses is stored.
    void setTheme(Theme theme);

    /// Parts of the window, for tests and for what drives it; none is null, and all live as long as the
    /// window.
    SceneEditor* editor() const { return editor_; }
    TextFeed* feed() const { return feed_; }
    ParameterPanel* parameters() const { return parameters_; }
    IncludeViewer* includes() const { return includes_; }
    PreviewLight* previewLight() const { return light_; }
    ProblemsPanel* problems() const { return problems_; }
    StudyController* studies() const { return studies_; }
    /// The panel of this class among StudyPanels.
    template <class Panel>
    Panel* study() const {
        return panels_->get<Panel>();
    }
    VerdictBadge* badge() const { return badge_; }
    /// Coordinates and values of the probed point, in the status line.
    QLabel* probed() const { return probed_; }
    Docks* docks() const { return docks_; }
    PictureRoom* room() const { return room_; }
    SceneSession* session() const { return session_; }
    Viewport* viewport() const;
    ViewportPanel* viewportPanel() const { return viewportPanel_; }
    FunctionBrowser* functions() const { return functions_; }
    GalleryPanel* gallery() const { return gallery_; }
    GalleryController* scenes() const { return scenes_; }
    NoticeBar* notices() const { return notices_; }
    /// Above the text.
    NoticeBar* textNotices() const { return textNotices_; }
    ReadingBar* readingBar() const { return readingBar_; }
    Actions* actions() const { return actions_; }
    CommandKeys* keys() const { return keys_; }
    DocumentController* documents() const { return documents_; }
    ExportController* exports() const { return exports_; }
    ViewController* views() const { return views_; }
    InsertionController* insertions() const { return insertions_; }
    TimelinePanel* timelinePanel() const { return timelinePanel_; }
    TimelineController* timeline() const { return timeline_; }
    /// Text parsed, picture finished, panels drawn.
    bool atRest() const;

  signals:
    /// Another window is asked for: the program starts it, for tests of this one must not.
    void windowRequested();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makePanels();
    void makeDocks();
    void makeMenus();
    void makeStudies();
    void connectText();
    void connectProblems();
    void connectDocuments();
    void connectInsertions();
    void connectTextActions();
    void connectTimeline();
    void connectViewActions();
    void connectFileActions();
    void showResult(const ParseResult& result, quint64 revision);
    /// Undo ends what plays, and takes it back.
    void offerUndoOfPlay(bool playing);
    /// In the status line, for a while.
    void say(const QString& message);
    void updateTitle();
    void walkPanes(bool forward);
    /// Made on first use.
    HelpController* help();
    void showShortcuts();
    void showAbout();
    void editIncludeFolders();

    NoticeBar* notices_ = nullptr;
    SceneEditor* editor_ = nullptr;
    NoticeBar* textNotices_ = nullptr;
    ReadingBar* readingBar_ = nullptr;
    FindBar* findBar_ = nullptr;
    IncludeViewer* includes_ = nullptr;
    PreviewLight* light_ = nullptr;
    ProblemsPanel* problems_ = nullptr;
    ParameterPanel* parameters_ = nullptr;
    FunctionBrowser* functions_ = nullptr;
    GalleryPanel* gallery_ = nullptr;
    GalleryController* scenes_ = nullptr;
    SettingWriter* settings_ = nullptr;
    ViewportPanel* viewportPanel_ = nullptr;
    SceneSession* session_ = nullptr;
    TextFeed* feed_ = nullptr;
    ParameterBinding* binding_ = nullptr;
    std::unique_ptr<StudyPanels> panels_;
    StudyController* studies_ = nullptr;
    Actions* actions_ = nullptr;
    CommandKeys* keys_ = nullptr;
    DocumentController* documents_ = nullptr;
    ExportController* exports_ = nullptr;
    ViewController* views_ = nullptr;
    ContainerFitter* fitter_ = nullptr;
    InsertionController* insertions_ = nullptr;
    TimelinePanel* timelinePanel_ = nullptr;
    TimelineController* timeline_ = nullptr;
    HistoryController* history_ = nullptr;
    FileWriter* files_ = nullptr;
    Docks* docks_ = nullptr;
    SessionMemory* memory_ = nullptr;
    PictureRoom* room_ = nullptr;
    QLabel* caret_ = nullptr;
    QLabel* probed_ = nullptr;
    VerdictBadge* badge_ = nullptr;
    SceneDisplay* display_ = nullptr;
    WindowChoices* choices_ = nullptr;
    PaneWalk* paneWalk_ = nullptr;
    HelpController* help_ = nullptr;
};

}  // namespace isoscope
