// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QMainWindow>
#include <QTimer>

#include "core/scene/scene.h"
#include "widgets/document/scene_session.h"
#include "widgets/theme.h"

class QLabel;

namespace isoscope {

class AccuracyPanel;
class Actions;
class Docks;
class DocumentController;
class EffectsPanel;
class ExportController;
class FileWriter;
class FindBar;
class FunctionBrowser;
class GradientPanel;
class HistogramPanel;
class IncludeViewer;
class InsertionController;
class NoticeBar;
class ParameterBinding;
class ParameterPanel;
class PictureRoom;
class PreviewLight;
class ProblemsPanel;
class RayPanel;
class ReadingBar;
class SceneEditor;
class SectionPanel;
class SessionMemory;
class SettingWriter;
class StudyController;
class StudyPanels;
class VerdictBadge;
class ViewController;
class Viewport;
class ViewportPanel;

/// The window: makes the panels and connects them; what they do is their own business.
class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    MainWindow();
    ~MainWindow() override;

    /// False, with a notice in the window, when the file cannot be read.
    bool openFile(const QString& path);
    /// Begins with `file`, or with what the last run ended with, and remembers from now on. Returns why the
    /// file cannot be read, which a notice says as well; else empty.
    QString start(const QString& file);
    /// The example of the first start.
    void showTutorial();
    /// For this run; what the menu chooses is stored.
    void setTheme(Theme theme);

    /// Parts of the window, for tests and for what drives it; none is null, and all live as long as the
    /// window.
    SceneEditor* editor() const { return editor_; }
    ParameterPanel* parameters() const { return parameters_; }
    IncludeViewer* includes() const { return includes_; }
    PreviewLight* previewLight() const { return light_; }
    ProblemsPanel* problems() const { return problems_; }
    SectionPanel* section() const;
    GradientPanel* gradient() const;
    HistogramPanel* histogram() const;
    AccuracyPanel* accuracy() const;
    StudyController* studies() const { return studies_; }
    RayPanel* ray() const;
    VerdictBadge* badge() const { return badge_; }
    EffectsPanel* effects() const;
    Docks* docks() const { return docks_; }
    PictureRoom* room() const { return room_; }
    SceneSession* session() const { return session_; }
    Viewport* viewport() const;
    ViewportPanel* viewportPanel() const { return viewportPanel_; }
    FunctionBrowser* functions() const { return functions_; }
    NoticeBar* notices() const { return notices_; }
    /// Above the text.
    NoticeBar* textNotices() const { return textNotices_; }
    ReadingBar* readingBar() const { return readingBar_; }
    Actions* actions() const { return actions_; }
    DocumentController* documents() const { return documents_; }
    ExportController* exports() const { return exports_; }
    ViewController* views() const { return views_; }
    InsertionController* insertions() const { return insertions_; }
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
    void connectPanels();
    void connectActions();
    void connectFileActions();
    void showScene(const std::shared_ptr<const Scene>& scene, bool sameLook);
    void schedulePanels();
    void showSceneInPanels();
    void showState(SceneSession::Shown shown);
    /// Sends a clipboard command to the field with the focus, else to the editor.
    void edit(const char* slot);
    void setRootFinder(RootFinder finder);
    void chooseRootFinder(RootFinder finder);
    void chooseTheme(Theme theme);
    void connectStudies();
    void updateTitle();
    void readSettings();
    void writeSettings() const;
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
    SettingWriter* settings_ = nullptr;
    ViewportPanel* viewportPanel_ = nullptr;
    SceneSession* session_ = nullptr;
    ParameterBinding* binding_ = nullptr;
    std::unique_ptr<StudyPanels> panels_;
    StudyController* studies_ = nullptr;
    Actions* actions_ = nullptr;
    DocumentController* documents_ = nullptr;
    ExportController* exports_ = nullptr;
    ViewController* views_ = nullptr;
    InsertionController* insertions_ = nullptr;
    FileWriter* files_ = nullptr;
    Docks* docks_ = nullptr;
    SessionMemory* memory_ = nullptr;
    PictureRoom* room_ = nullptr;
    QLabel* caret_ = nullptr;
    VerdictBadge* badge_ = nullptr;
    QByteArray factoryLayout_;
    SceneSession::Shown shown_ = SceneSession::Shown::complete;
    bool panelsBehind_ = false;  ///< the panels do not show the session's scene yet
    QTimer panelTimer_;          ///< when they follow
};

}  // namespace isoscope
