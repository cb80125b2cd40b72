// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QMainWindow>
#include <QTimer>

#include "core/scene/scene.h"
#include "widgets/scene_session.h"
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
class NoticeBar;
class ParameterBinding;
class ParameterPanel;
class ProblemsPanel;
class RayPanel;
class ReadingBar;
class SceneEditor;
class SectionPanel;
class SettingWriter;
class StudyController;
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
    /// The example of the first start.
    void showTutorial();
    void setTheme(Theme theme);

    SceneEditor* editor() const { return editor_; }
    ParameterPanel* parameters() const { return parameters_; }
    ProblemsPanel* problems() const { return problems_; }
    SectionPanel* section() const { return section_; }
    GradientPanel* gradient() const { return gradient_; }
    HistogramPanel* histogram() const { return histogram_; }
    AccuracyPanel* accuracy() const { return accuracy_; }
    RayPanel* ray() const { return ray_; }
    EffectsPanel* effects() const { return effects_; }
    Docks* docks() const { return docks_; }
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
    /// Text parsed, picture finished, panels drawn.
    bool atRest() const;

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
    ProblemsPanel* problems_ = nullptr;
    ParameterPanel* parameters_ = nullptr;
    FunctionBrowser* functions_ = nullptr;
    SectionPanel* section_ = nullptr;
    GradientPanel* gradient_ = nullptr;
    HistogramPanel* histogram_ = nullptr;
    AccuracyPanel* accuracy_ = nullptr;
    RayPanel* ray_ = nullptr;
    EffectsPanel* effects_ = nullptr;
    SettingWriter* settings_ = nullptr;
    ViewportPanel* viewportPanel_ = nullptr;
    SceneSession* session_ = nullptr;
    ParameterBinding* binding_ = nullptr;
    StudyController* studies_ = nullptr;
    Actions* actions_ = nullptr;
    DocumentController* documents_ = nullptr;
    ExportController* exports_ = nullptr;
    FileWriter* files_ = nullptr;
    Docks* docks_ = nullptr;
    QLabel* caret_ = nullptr;
    QByteArray factoryLayout_;
    bool panelsBehind_ = false;  ///< the panels do not show the session's scene yet
    QTimer panelTimer_;          ///< when they follow
    Theme theme_ = Theme::system;
};

}  // namespace isoscope
