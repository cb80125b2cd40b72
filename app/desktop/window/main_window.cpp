// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/main_window.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <utility>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/example_menu.h"
#include "app/desktop/files/export_controller.h"
#include "app/desktop/files/file_writer.h"
#include "app/desktop/editing/formula_offer.h"
#include "app/desktop/window/help_dialogs.h"
#include "app/desktop/editing/history_controller.h"
#include "app/desktop/files/include_folders_dialog.h"
#include "app/desktop/editing/insertion_controller.h"
#include "app/desktop/window/picture_room.h"
#include "app/desktop/editing/preview_light.h"
#include "app/desktop/editing/quick_fixer.h"
#include "app/desktop/files/session_memory.h"
#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/window/shortcut_router.h"
#include "app/desktop/window/shortcut_window.h"
#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/study_panels.h"
#include "app/desktop/window/tool_row.h"
#include "app/desktop/window/view_controller.h"
#include "app/desktop/window/whats_this.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/studies/effects_panel.h"
#include "widgets/editor/find_bar.h"
#include "widgets/functions/function_browser.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/editor/include_viewer.h"
#include "widgets/menu_on_release.h"
#include "widgets/notice_bar.h"
#include "widgets/numbers/number_tool.h"
#include "widgets/parameters/parameter_binding.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/studies/ray_panel.h"
#include "widgets/editor/reading_bar.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/document/scene_session.h"
#include "widgets/document/text_feed.h"
#include "widgets/viewport/scene_guides.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_view.h"
#include "widgets/timing.h"
#include "widgets/verdicts/verdict_badge.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

/// The resources of a static library are registered by hand; the macro wants to stand outside of namespaces.
static void registerResources() { Q_INIT_RESOURCE(isoscope); }

namespace isoscope {

namespace {

constexpr QSize smallestFirstSize{1280, 800};
constexpr QSize largestFirstSize{1800, 1120};
constexpr double shareOfScreen = 0.85;
/// Raised when panels come or go, so that an old layout is not forced on new ones.
constexpr int layoutVersion = 7;
const QString rootFinderKey = QStringLiteral("view/rootFinder");
const QString movingSecondsKey = QStringLiteral("view/movingSeconds");
constexpr double defaultMovingSeconds = 0.4;
const QString certifiedName = QStringLiteral("certified");
const QString povrayName = QStringLiteral("povray");
const QString antialiasKey = QStringLiteral("view/antialias");
const QString containersKey = QStringLiteral("view/containers");
const QString axesKey = QStringLiteral("view/axes");
const QString cutsKey = QStringLiteral("view/cuts");
/// Seconds; smooth edges take about as long again.
constexpr double quickPicture = 2;
const QString wordWrapKey = QStringLiteral("text/wordWrap");
const QString themeKey = QStringLiteral("window/theme");

RootFinder chosenRootFinder() {
    const QString finder = QSettings().value(rootFinderKey).toString();
    return finder == certifiedName ? RootFinder::certified
           : finder == povrayName  ? RootFinder::lipschitz
                                   : Viewport::defaultRootFinder;
}

QSize firstSize(const QScreen* screen) {
    const QSize available =
        screen ? (QSizeF(screen->availableSize()) * shareOfScreen).toSize() : smallestFirstSize;
    return available.expandedTo(smallestFirstSize).boundedTo(largestFirstSize);
}

}  // namespace

MainWindow::MainWindow() {
    registerResources();
    // Before any panel, which would otherwise take icons and colours of the desktop's.
    applyTheme(themeFromName(QSettings().value(themeKey).toString()));
    setWindowIcon(QIcon(QStringLiteral(":/icons/isoscope.svg")));
    setAcceptDrops(true);
    actions_ = new Actions(this);
    new MenuOnRelease(this);
    new ShortcutRouter(this, actions_);
    makePanels();
    makeDocks();
    makeMenus();
    connectPanels();
    connectStudies();
    connectActions();
    connectFileActions();
    new WhatsThis(*actions_, *docks_, this);
    auto* numbers = new NumberTool(editor_, binding_, this);
    connect(actions_->adjustNumber, &QAction::triggered, numbers, &NumberTool::open);
    connect(numbers, &NumberTool::said, this,
            [this](const QString& message) { statusBar()->showMessage(message, timing::messageDuration); });
    new HistoryController({editor_, viewport(), section(), actions_, views_}, this);
    resize(firstSize(screen()));
    docks_->arrange();
    factoryLayout_ = saveState(layoutVersion);
    readSettings();
    updateTitle();
    memory_ = new SessionMemory({this, editor_, session_, documents_->document(), viewport()},
                                [this] { writeSettings(); });
    connect(documents_, &DocumentController::resumed, memory_, &SessionMemory::restore);
}

MainWindow::~MainWindow() {
    // While all parts live: they watch the window, and ask it where they are.
    hide();
}

SectionPanel* MainWindow::section() const { return panels_->get<SectionPanel>(); }
GradientPanel* MainWindow::gradient() const { return panels_->get<GradientPanel>(); }
HistogramPanel* MainWindow::histogram() const { return panels_->get<HistogramPanel>(); }
AccuracyPanel* MainWindow::accuracy() const { return panels_->get<AccuracyPanel>(); }
RayPanel* MainWindow::ray() const { return panels_->get<RayPanel>(); }
EffectsPanel* MainWindow::effects() const { return panels_->get<EffectsPanel>(); }

void MainWindow::makePanels() {
    auto* center = new QWidget;
    auto* layout = new QVBoxLayout(center);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    viewportPanel_ = new ViewportPanel;
    layout->addWidget(viewportPanel_, 1);
    notices_ = new NoticeBar;
    notices_->floatOver(viewport());
    setCentralWidget(center);

    editor_ = new SceneEditor;
    textNotices_ = new NoticeBar;
    readingBar_ = new ReadingBar;
    findBar_ = new FindBar(editor_);
    problems_ = new ProblemsPanel;
    parameters_ = new ParameterPanel;
    functions_ = new FunctionBrowser;
    panels_ = std::make_unique<StudyPanels>();
    session_ = new SceneSession(this);
    binding_ =
        new ParameterBinding(editor_, parameters_, session_, new TextFeed(editor_, session_, this), this);
    documents_ = new DocumentController({this, editor_, session_, binding_, viewport(), notices_});
    exports_ = new ExportController({this, editor_, session_, viewport(), documents_->document(), notices_});
    files_ = new FileWriter({editor_, session_, documents_->document(), textNotices_}, this);
}

void MainWindow::makeDocks() {
    auto* text = new QWidget;
    auto* layout = new QVBoxLayout(text);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(textNotices_);
    layout->addWidget(readingBar_);
    layout->addWidget(editor_, 1);
    includes_ = new IncludeViewer;
    layout->addWidget(includes_, 1);
    layout->addWidget(findBar_);
    docks_ = new Docks(this, {text, problems_, parameters_, functions_, *panels_});
    room_ = new PictureRoom(this, docks_, viewport());
}

void MainWindow::makeMenus() {
    auto* recent = new QMenu(this);
    documents_->recentFiles()->fill(recent);
    auto* examples = new ExampleMenu(this);
    connect(examples, &ExampleMenu::chosen, documents_, &DocumentController::showExample);
    actions_->fillMenuBar(menuBar(), recent, examples, docks_->actions() << room_->foldAction());
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setIconSize({18, 18});
    actions_->fillToolBar(bar);
    QToolBar* viewTools = viewportPanel_->tools();
    addToolBar(viewTools);
    viewTools->setObjectName(QStringLiteral("viewTools"));
    // One row without handles: the width is for the tools.
    for (QToolBar* tools : {bar, viewTools}) tools->setMovable(false);
    new ToolRow(this, {bar, viewTools}, actions_->fillViewTools(viewTools));
    actions_->fillContextMenu(viewport());
    caret_ = new QLabel;
    caret_->setToolTip(tr("Place of the caret in the text"));
    caret_->setAccessibleDescription(tr("Place of the caret"));
    badge_ = new VerdictBadge;
    statusBar()->addPermanentWidget(badge_);
    statusBar()->addPermanentWidget(caret_);
}

void MainWindow::connectPanels() {
    connect(session_, &SceneSession::sceneChanged, this, &MainWindow::showScene);
    connect(session_, &SceneSession::shownChanged, this, &MainWindow::showState);
    connect(session_, &SceneSession::readingSlowly, readingBar_, &ReadingBar::showProgress);
    connect(session_, &SceneSession::readingEnded, readingBar_, &QWidget::hide);
    // What was under way is there.
    connect(viewport(), &Viewport::pictureFinished, this, [this] {
        if (shown_ == SceneSession::Shown::older) showState(shown_);
    });
    connect(readingBar_, &ReadingBar::stopRequested, session_, &SceneSession::stop);
    connect(viewport(), &Viewport::progressed, this, &MainWindow::schedulePanels);
    panelTimer_.setSingleShot(true);
    connect(&panelTimer_, &QTimer::timeout, this, &MainWindow::showSceneInPanels);
    connect(documents_, &DocumentController::begun, files_, &FileWriter::begin);
    connect(documents_, &DocumentController::begun, this, [this] { setRootFinder(chosenRootFinder()); });
    connect(documents_, &DocumentController::povrayLessonShown, this,
            [this] { setRootFinder(RootFinder::lipschitz); });
    connect(files_, &FileWriter::said, this,
            [this](const QString& message) { statusBar()->showMessage(message, timing::messageDuration); });
    connect(documents_, &DocumentController::begun, this, [this] {
        panelsBehind_ = false;
        studies_->leaveDocument();
        problems_->setDiagnostics({}, nullptr);
        viewport()->setNotice({});
        shown_ = SceneSession::Shown::complete;
    });
    connect(session_, &SceneSession::parsed, this, [this](const auto& result, quint64 revision) {
        if (revision != editor_->revision()) return;
        editor_->setNotation(result->notation);
        editor_->setDiagnostics(result->diagnostics, *result->sources);
        QStringList names;
        if (result->symbols)
            for (const std::string& name : result->symbols->names()) names << QString::fromStdString(name);
        editor_->setNames(names);
        problems_->setDiagnostics(result->diagnostics, result->sources);
    });
    connect(editor_, &SceneEditor::caretMoved, this, [this](int line, int column) {
        caret_->setText(tr("Line %1, column %2").arg(line).arg(column));
    });
    connect(problems_, &ProblemsPanel::activated, this, [this](const SourceRange& range) {
        if (range.file == 0) return editor_->jumpTo(range);
        includes_->show(problems_->sources(), range);
    });
    connect(includes_, &IncludeViewer::closed, editor_, qOverload<>(&QWidget::setFocus));
    auto* fixer = new QuickFixer(editor_, session_, this);
    connect(problems_, &ProblemsPanel::fixRequested, fixer, &QuickFixer::apply);
    new FormulaOffer({editor_, session_, textNotices_, fixer}, this);
    light_ = new PreviewLight(editor_, session_, textNotices_, this);
    connect(light_, &PreviewLight::changed, this, [this] { showScene(session_->scene(), false); });
    connect(documents_, &DocumentController::begun, light_, &PreviewLight::begin);
    connect(documents_, &DocumentController::begun, includes_, &QWidget::hide);
    connect(fixer, &QuickFixer::said, this,
            [this](const QString& message) { statusBar()->showMessage(message, timing::messageDuration); });
    connect(problems_, &ProblemsPanel::titleChanged, docks_->problems, &QWidget::setWindowTitle);
    const auto say = [this](const QString& message) {
        statusBar()->showMessage(message, timing::messageDuration);
    };
    views_ = new ViewController(actions_, viewport(), this);
    connect(views_, &ViewController::said, this, say);
    insertions_ = new InsertionController(editor_, session_, views_, this);
    connect(insertions_, &InsertionController::said, this, say);
    connect(functions_, &FunctionBrowser::statementRequested, insertions_,
            &InsertionController::insertStatement);
    connect(functions_, &FunctionBrowser::callRequested, insertions_, &InsertionController::insertCall);
    connect(documents_, &DocumentController::titleChanged, this, &MainWindow::updateTitle);
    connect(documents_, &DocumentController::said, this, say);
    connect(exports_, &ExportController::said, this,
            [this](const QString& message) { statusBar()->showMessage(message, timing::messageDuration); });
}

void MainWindow::connectStudies() {
    settings_ = new SettingWriter(editor_, session_, this);
    connect(settings_, &SettingWriter::said, this,
            [this](const QString& message) { statusBar()->showMessage(message, timing::messageDuration); });
    studies_ = new StudyController({actions_, viewport(), docks_, panels_.get(), settings_, editor_, session_,
                                    problems_, badge_, parameters_},
                                   this);
    studies_->setExportSize(ExportController::exportSize());
    connect(exports_, &ExportController::exportSizeChanged, studies_, &StudyController::setExportSize);
    connect(studies_, &StudyController::said, this,
            [this](const QString& message) { statusBar()->showMessage(message, timing::messageDuration); });
}

void MainWindow::connectActions() {
    const auto on = [this](QAction* action, auto receiver, auto method) {
        connect(action, &QAction::triggered, receiver, method);
    };
    for (QAction* action : {actions_->undo, actions_->redo}) on(action, parameters_, &ParameterPanel::settle);
    on(actions_->undo, editor_, &SceneEditor::undo);
    on(actions_->redo, editor_, &SceneEditor::redo);
    on(actions_->cut, this, [this] { edit("cut"); });
    on(actions_->copy, this, [this] { edit("copy"); });
    on(actions_->paste, this, [this] { edit("paste"); });
    on(actions_->selectAll, this, [this] { edit("selectAll"); });
    on(actions_->find, findBar_, &FindBar::showFind);
    on(actions_->replace, findBar_, &FindBar::showReplace);
    on(actions_->findNext, findBar_, &FindBar::findNext);
    on(actions_->findPrevious, findBar_, &FindBar::findPrevious);
    on(actions_->comment, editor_, &SceneEditor::toggleComment);
    on(actions_->insertFunction, this, [this] {
        docks_->bringUp(docks_->functions);
        functions_->startSearch();
    });
    on(actions_->resetView, viewport(), &Viewport::resetView);
    on(actions_->writeView, exports_, &ExportController::writeView);
    on(actions_->redraw, viewport(), &Viewport::restart);
    on(actions_->stop, viewport(), &Viewport::stop);
    // Stored only when it was chosen; else pictures that come quickly get smooth edges by themselves.
    on(actions_->antialias, this, [this](bool on) {
        QSettings().setValue(antialiasKey, on);
        viewport()->setAntialias(on);
    });
    on(actions_->showContainers, &viewport()->guides(), &SceneGuides::setContainersShown);
    on(actions_->showAxes, &viewport()->guides(), &SceneGuides::setAxesShown);
    on(actions_->showCuts, viewport(), &Viewport::setCutsShown);
    on(actions_->certified, this, [this] { chooseRootFinder(RootFinder::certified); });
    on(actions_->povray, this, [this] { chooseRootFinder(RootFinder::lipschitz); });
    on(actions_->verdicts, viewport(), &Viewport::setVerdictsShown);
    on(actions_->themeSystem, this, [this] { chooseTheme(Theme::system); });
    on(actions_->themeLight, this, [this] { chooseTheme(Theme::light); });
    on(actions_->themeDark, this, [this] { chooseTheme(Theme::dark); });
    on(actions_->largerText, editor_, [this] { editor_->zoomIn(); });
    on(actions_->smallerText, editor_, [this] { editor_->zoomOut(); });
    on(actions_->normalText, editor_, &SceneEditor::resetZoom);
    on(actions_->wordWrap, editor_, &SceneEditor::setWordWrap);
    on(actions_->resetLayout, this, [this] {
        restoreState(factoryLayout_, layoutVersion);
        room_->reset();
    });
    on(actions_->includeFolders, this, &MainWindow::editIncludeFolders);
    on(actions_->shortcuts, this, &MainWindow::showShortcuts);
    on(actions_->whatsThis, this, [] { QWhatsThis::enterWhatsThisMode(); });
    on(actions_->about, this, &MainWindow::showAbout);
}

void MainWindow::connectFileActions() {
    const auto on = [this](QAction* action, auto receiver, auto method) {
        connect(action, &QAction::triggered, receiver, method);
    };
    on(actions_->newFile, documents_, &DocumentController::newDocument);
    on(actions_->newWindow, this, &MainWindow::windowRequested);
    on(actions_->open, documents_, &DocumentController::chooseAndOpen);
    on(actions_->save, documents_, &DocumentController::save);
    on(actions_->saveAs, documents_, &DocumentController::saveAs);
    on(actions_->keptTexts, documents_, &DocumentController::showKeptTexts);
    on(actions_->copyIsosurface, exports_, &ExportController::copyIsosurface);
    on(actions_->exportInclude, exports_, &ExportController::exportInclude);
    on(actions_->exportScene, exports_, &ExportController::exportScene);
    on(actions_->exportVirtualight, exports_, &ExportController::exportVirtualightText);
    on(actions_->exportImage, exports_, &ExportController::exportImage);
    on(actions_->quit, this, &QWidget::close);
}

Viewport* MainWindow::viewport() const { return viewportPanel_->viewport(); }

bool MainWindow::openFile(const QString& path) { return documents_->openFile(path); }

QString MainWindow::start(const QString& file) {
    const QString problem = documents_->start(file);
    memory_->begin();
    return problem;
}

void MainWindow::showTutorial() { documents_->showExample(QStringLiteral("tutorial.pov")); }

void MainWindow::showScene(const std::shared_ptr<const Scene>& scene, bool sameLook) {
    viewport()->setScene(light_->shown(scene), sameLook);
    panelsBehind_ = true;
    schedulePanels();
}

void MainWindow::schedulePanels() {
    if (!panelsBehind_) return;
    // The picture comes first: the panels would take half of its processors. They do not wait for slow ones,
    // but for that of a new document: they may have to start OpenGL, which takes far longer.
    if (viewport()->finished())
        panelTimer_.start(0);  // once it is painted
    else if (!panelTimer_.isActive() && !viewport()->picture().isNull())
        panelTimer_.start(timing::panelPatience);
}

void MainWindow::showSceneInPanels() {
    if (!std::exchange(panelsBehind_, false)) return;
    studies_->setScene(session_->scene());
}

void MainWindow::showState(SceneSession::Shown shown) {
    shown_ = shown;
    switch (shown) {
        case SceneSession::Shown::complete: return viewport()->setNotice({});
        case SceneSession::Shown::partial:
            return viewport()->setNotice(tr("The text has errors; what was understood of it is shown."));
        case SceneSession::Shown::older:
            if (viewport()->picture().isNull())
                return viewport()->setNotice(
                    tr("The text has errors; the first picture, of the text before them, is under way."));
            return viewport()->setNotice(tr("The text has errors; this is the picture from before."),
                                         Viewport::Dimmed::yes);
        case SceneSession::Shown::nothing:
            return viewport()->setNotice(
                tr("The text has errors, listed under Problems; nothing can be shown yet."));
    }
}

void MainWindow::edit(const char* slot) {
    QWidget* focused = focusWidget();
    if (qobject_cast<QLineEdit*>(focused) || qobject_cast<QAbstractSpinBox*>(focused)) {
        auto* field = qobject_cast<QLineEdit*>(focused);
        if (!field) field = focused->findChild<QLineEdit*>();
        if (field && QMetaObject::invokeMethod(field, slot)) return;
    }
    QMetaObject::invokeMethod(editor_, slot);
}

bool MainWindow::atRest() const {
    if (session_->busy() || panelsBehind_ || !views_->idle() || !insertions_->idle()) return false;
    // A text of which nothing can be shown gives no picture to wait for.
    if (!session_->scene()) return session_->result() != nullptr;
    // Behind another tab a panel is visible all the same, but never painted.
    const bool sectionDrawn =
        section()->visibleRegion().isEmpty() || (section()->upToDate() && section()->view()->settled());
    return viewport()->finished() && !viewport()->picture().isNull() && !viewport()->overlay().busy() &&
           !viewport()->softening() && sectionDrawn;
}

void MainWindow::chooseTheme(Theme theme) {
    QSettings().setValue(themeKey, themeName(theme));
    setTheme(theme);
}

void MainWindow::setTheme(Theme theme) {
    applyTheme(theme);
    editor_->applyTheme(isDark(theme));
    actions_->themeSystem->setChecked(theme == Theme::system);
    actions_->themeLight->setChecked(theme == Theme::light);
    actions_->themeDark->setChecked(theme == Theme::dark);
}

void MainWindow::setRootFinder(RootFinder finder) {
    const bool certified = finder == RootFinder::certified;
    (certified ? actions_->certified : actions_->povray)->setChecked(true);
    // The other one tells nothing.
    actions_->verdicts->setEnabled(certified);
    viewport()->setRootFinder(finder);
}

void MainWindow::chooseRootFinder(RootFinder finder) {
    // Stored only when it was chosen, so that a better default reaches everybody else.
    QSettings().setValue(rootFinderKey, finder == RootFinder::certified ? certifiedName : povrayName);
    setRootFinder(finder);
}

void MainWindow::updateTitle() {
    setWindowTitle(tr("%1 – Isoscope").arg(documents_->title()));
    setWindowFilePath(documents_->document()->filePath());
    setWindowModified(documents_->document()->isModified());
}

void MainWindow::readSettings() {
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), layoutVersion);
    room_->setChoices(settings.value(QStringLiteral("window/room")).toString());
    setTheme(themeFromName(settings.value(themeKey).toString()));
    const QVariant smooth = settings.value(antialiasKey);
    actions_->antialias->setChecked(smooth.isValid() ? smooth.toBool() : true);
    viewport()->setAntialias(actions_->antialias->isChecked(),
                             smooth.isValid() ? Viewport::anyTime : quickPicture);
    const auto readGuide = [&settings](QAction* action, const QString& key, bool usual) {
        if (settings.value(key, usual).toBool() != action->isChecked()) action->trigger();
    };
    readGuide(actions_->showContainers, containersKey, false);
    readGuide(actions_->showAxes, axesKey, false);
    readGuide(actions_->showCuts, cutsKey, true);
    actions_->wordWrap->setChecked(settings.value(wordWrapKey, true).toBool());
    editor_->setWordWrap(actions_->wordWrap->isChecked());
    const double movingSeconds = settings.value(movingSecondsKey, defaultMovingSeconds).toDouble();
    viewport()->setMovingSeconds(movingSeconds);
    effects()->setMovingSeconds(movingSeconds);
    setRootFinder(chosenRootFinder());
    session_->setLibraryPaths(IncludeFoldersDialog::searchedPaths());
}

void MainWindow::writeSettings() const {
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/layout"), saveState(layoutVersion));
    settings.setValue(QStringLiteral("window/room"), room_->choices());
    settings.setValue(containersKey, actions_->showContainers->isChecked());
    settings.setValue(axesKey, actions_->showAxes->isChecked());
    settings.setValue(cutsKey, actions_->showCuts->isChecked());
    settings.setValue(wordWrapKey, actions_->wordWrap->isChecked());
    settings.setValue(movingSecondsKey, viewport()->movingSeconds());
}

void MainWindow::showShortcuts() { (new ShortcutWindow(menuBar(), this))->show(); }

void MainWindow::showAbout() { (new AboutDialog(this))->show(); }

void MainWindow::editIncludeFolders() {
    auto* dialog = new IncludeFoldersDialog(this);
    connect(dialog, &QDialog::accepted, this, [this] {
        session_->setLibraryPaths(IncludeFoldersDialog::searchedPaths());
        session_->setText(editor_->utf8(), editor_->revision(), SceneSession::When::now);
    });
    dialog->show();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!documents_->prepareToClose()) {
        event->ignore();
        return;
    }
    writeSettings();
    memory_->write();
    // All are asked before the first is waited for.
    session_->stop();
    viewport()->stop();
    studies_->stop();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QMimeData* data = event->mimeData();
    if (data->hasUrls() && data->urls().first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.isEmpty() || !urls.first().isLocalFile()) return;
    event->acceptProposedAction();
    openFile(urls.first().toLocalFile());
}

}  // namespace isoscope
