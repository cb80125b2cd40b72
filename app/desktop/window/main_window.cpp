// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/main_window.h"

#include <algorithm>
#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QUrl>
#include <QVBoxLayout>
#include <QWhatsThis>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/clipboard_router.h"
#include "app/desktop/window/command_keys.h"
#include "app/desktop/window/command_palette.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/example_menu.h"
#include "app/desktop/files/export_controller.h"
#include "app/desktop/files/file_writer.h"
#include "app/desktop/files/gallery_controller.h"
#include "app/desktop/editing/formula_offer.h"
#include "app/desktop/window/help_controller.h"
#include "app/desktop/window/help_dialogs.h"
#include "app/desktop/editing/history_controller.h"
#include "app/desktop/files/include_folders_dialog.h"
#include "app/desktop/editing/container_fitter.h"
#include "app/desktop/editing/insertion_controller.h"
#include "app/desktop/window/pane_walk.h"
#include "app/desktop/window/picture_room.h"
#include "app/desktop/window/scene_display.h"
#include "app/desktop/editing/preview_light.h"
#include "app/desktop/editing/quick_fixer.h"
#include "app/desktop/files/session_memory.h"
#include "app/desktop/files/start_page.h"
#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/editing/timeline_controller.h"
#include "app/desktop/window/shortcut_router.h"
#include "app/desktop/window/shortcut_window.h"
#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/tool_row.h"
#include "app/desktop/window/view_controller.h"
#include "app/desktop/window/whats_this.h"
#include "app/desktop/window/window_choices.h"
#include "widgets/editor/empty_text_hint.h"
#include "widgets/elided_label.h"
#include "widgets/editor/find_bar.h"
#include "widgets/functions/function_browser.h"
#include "widgets/gallery/gallery_panel.h"
#include "widgets/editor/include_viewer.h"
#include "widgets/interface_style.h"
#include "widgets/linked_probe.h"
#include "widgets/menu_on_release.h"
#include "widgets/notice_bar.h"
#include "widgets/numbers/number_tool.h"
#include "widgets/parameters/parameter_binding.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/preset_controller.h"
#include "widgets/parameters/slider_player.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/editor/reading_bar.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/document/scene_session.h"
#include "widgets/document/text_feed.h"
#include "widgets/section/section_panel.h"
#include "widgets/timeline/timeline_panel.h"
#include "widgets/timing.h"
#include "widgets/verdicts/verdict_badge.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

/// The resources of a static library are registered by hand; the macro wants to stand outside of namespaces.
static void registerResources() { Q_INIT_RESOURCE(isoscope); }

namespace isoscope {

MainWindow::MainWindow() {
    registerResources();
    WindowChoices::applyStoredLook();
    setWindowIcon(QIcon(QStringLiteral(":/icons/isoscope.svg")));
    setAcceptDrops(true);
    actions_ = new Actions(this);
    keys_ = new CommandKeys(actions_, this);
    new MenuOnRelease(this);
    new ShortcutRouter(this, actions_);
    makePanels();
    makeDocks();
    makeMenus();
    // The list of problems hears of a new text before the studies add what they found.
    connectText();
    makeStudies();
    connectProblems();
    connectDocuments();
    connectInsertions();
    connectTimeline();
    connectTextActions();
    connectViewActions();
    connectFileActions();
    new WhatsThis(*actions_, *docks_, this);
    resize(WindowChoices::firstSize(screen()->availableSize()));
    docks_->arrange();
    choices_ = new WindowChoices({this, actions_, viewport(), editor_, room_});
    choices_->read();
    session_->setLibraryPaths(IncludeFoldersDialog::searchedPaths());
    updateTitle();
    memory_ = new SessionMemory({this, editor_, session_, documents_->document(), viewport()},
                                [this] { choices_->write(); });
    connect(documents_, &DocumentController::resumed, memory_, &SessionMemory::restore);
}

MainWindow::~MainWindow() {
    // While all parts live: they watch the window, and ask it where they are.
    hide();
}

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
    new EmptyTextHint(editor_);
    textNotices_ = new NoticeBar;
    readingBar_ = new ReadingBar;
    findBar_ = new FindBar(editor_);
    problems_ = new ProblemsPanel;
    parameters_ = new ParameterPanel;
    functions_ = new FunctionBrowser;
    gallery_ = new GalleryPanel;
    timelinePanel_ = new TimelinePanel;
    panels_ = std::make_unique<StudyPanels>();
    session_ = new SceneSession(this);
    feed_ = new TextFeed(editor_, session_, this);
    binding_ = new ParameterBinding(editor_, parameters_, session_, feed_, this);
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
    QList<Docks::Row> rows{
        {"editor", tr("Text"),
         tr("<p>The text of the scene, in POV-Ray's language. The picture follows while you type; signs in "
            "the "
            "margin tell what is wrong and whether surfaces have holes.</p>"),
         Docks::Place::upperLeft, text},
        {"parameters", tr("Parameters"),
         tr("<p>A slider for every number of the text that can be moved. Moving it writes the number.</p>"),
         Docks::Place::lowerLeft, parameters_},
        {"functions", tr("Functions"), tr("<p>The functions that can be inserted, with pictures.</p>"),
         Docks::Place::lowerLeft, functions_},
        {"problems", tr("Problems"),
         tr("<p>What is wrong with the text, what is not shown of it, and which isosurfaces have holes in "
            "POV-Ray. Click a line to go there; buttons mend what can be mended.</p>"),
         Docks::Place::lowerLeft, problems_},
        {"gallery", tr("Gallery"),
         tr("<p>Functions, examples, POV-Ray's snippets and your own scenes. A click opens one.</p>"),
         Docks::Place::lowerLeft, gallery_, true},
    };
    for (const StudyPanels::Entry& entry : panels_->entries())
        rows.append({entry.id, entry.title, entry.help, Docks::Place::below, entry.panel, entry.closed});
    rows.append(
        {"timeline", tr("Timeline"),
         tr("<p>The frames of an animation, and the keys of numbers and view that make them. All of it is "
            "kept in comments of the text.</p>"),
         Docks::Place::below, timelinePanel_, true});
    docks_ = new Docks(this, rows);
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
    setIconEdge(bar, 18);
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
    probed_ = new ElidedLabel;
    probed_->setContentsMargins(6, 0, 0, 0);
    probed_->setToolTip(
        tr("The point under the mouse in the picture, the cross-section or a chart, in the "
           "coordinates of its function, with f and its gradient"));
    probed_->setAccessibleDescription(tr("The probed point"));
    statusBar()->addWidget(probed_, 1);
    statusBar()->addPermanentWidget(badge_);
    statusBar()->addPermanentWidget(caret_);
}

void MainWindow::makeStudies() {
    settings_ = new SettingWriter(editor_, session_, this);
    connect(settings_, &SettingWriter::said, this, &MainWindow::say);
    studies_ = new StudyController({actions_, viewport(), docks_, panels_.get(), settings_, editor_, session_,
                                    problems_, badge_, parameters_, notices_},
                                   this);
    studies_->setExportSize(ExportController::exportSize());
    exports_->setProofs(studies_->verdicts()->study()->proofs());
    connect(actions_->exportNote, &QAction::toggled, exports_, &ExportController::setNoted);
    connect(exports_, &ExportController::exportSizeChanged, studies_, &StudyController::setExportSize);
    connect(studies_, &StudyController::said, this, &MainWindow::say);
    connect(studies_->probe(), &LinkedProbe::changed, probed_,
            [this] { probed_->setText(studies_->probe()->text()); });
    light_ = new PreviewLight(editor_, session_, textNotices_, this);
    display_ = new SceneDisplay({session_, viewport(), light_, studies_}, this);
}

void MainWindow::connectText() {
    connect(session_, &SceneSession::readingSlowly, readingBar_, &ReadingBar::showProgress);
    connect(session_, &SceneSession::readingEnded, readingBar_, &QWidget::hide);
    connect(readingBar_, &ReadingBar::stopRequested, session_, &SceneSession::stop);
    connect(session_, &SceneSession::parsed, this,
            [this](const auto& result, quint64 revision) { showResult(*result, revision); });
    connect(editor_, &SceneEditor::caretMoved, this, [this](int line, int column) {
        caret_->setText(tr("Line %1, column %2").arg(line).arg(column));
    });
    auto* numbers = new NumberTool(editor_, binding_, this);
    connect(actions_->adjustNumber, &QAction::triggered, numbers, &NumberTool::open);
    connect(numbers, &NumberTool::said, this, &MainWindow::say);
    connect(binding_, &ParameterBinding::said, this, &MainWindow::say);
    fitter_ = new ContainerFitter(editor_, session_, textNotices_, this);
    connect(actions_->fitContainer, &QAction::triggered, fitter_, &ContainerFitter::fit);
    connect(fitter_, &ContainerFitter::said, this, &MainWindow::say);
    auto* presets = new PresetController(editor_, parameters_, binding_, this);
    connect(presets, &PresetController::said, this, &MainWindow::say);
    new ClipboardRouter(this, editor_, *actions_);
}

void MainWindow::showResult(const ParseResult& result, quint64 revision) {
    if (revision != editor_->revision()) return;
    editor_->setNotation(result.notation);
    editor_->setDiagnostics(result.diagnostics, *result.sources);
    QStringList names;
    if (result.symbols)
        for (const std::string& name : result.symbols->names()) names << QString::fromStdString(name);
    editor_->setNames(names);
    problems_->setDiagnostics(result.diagnostics, result.sources);
}

void MainWindow::connectProblems() {
    connect(problems_, &ProblemsPanel::activated, this, [this](const SourceRange& range) {
        if (range.file == 0) return editor_->jumpTo(range);
        includes_->show(problems_->sources(), range);
    });
    connect(includes_, &IncludeViewer::closed, editor_, qOverload<>(&QWidget::setFocus));
    connect(problems_, &ProblemsPanel::titleChanged, docks_->find("problems"), &QWidget::setWindowTitle);
    auto* fixer = new QuickFixer(editor_, session_, this);
    connect(problems_, &ProblemsPanel::fixRequested, fixer, &QuickFixer::apply);
    connect(fixer, &QuickFixer::said, this, &MainWindow::say);
    new FormulaOffer({editor_, session_, textNotices_, fixer}, this);
}

void MainWindow::connectDocuments() {
    connect(documents_, &DocumentController::begun, files_, &FileWriter::begin);
    connect(documents_, &DocumentController::begun, this, [this] {
        choices_->restoreRootFinder();
        display_->begin();
        problems_->clear();
        includes_->hide();
    });
    connect(documents_, &DocumentController::begun, light_, &PreviewLight::begin);
    connect(documents_, &DocumentController::povrayLessonShown, this,
            [this] { choices_->setRootFinder(RootFinder::lipschitz); });
    connect(documents_, &DocumentController::titleChanged, this, &MainWindow::updateTitle);
    connect(documents_, &DocumentController::said, this, &MainWindow::say);
    connect(actions_->followFile, &QAction::toggled, documents_, &DocumentController::setFollowing);
    connect(actions_->liveUpdate, &QAction::toggled, feed_, &TextFeed::setLive);
    const auto showTyped = [this] {
        if (feed_->isBehind()) feed_->submit(SceneSession::When::now);
    };
    connect(documents_, &DocumentController::agreesWithFile, this, showTyped);
    connect(actions_->redraw, &QAction::triggered, this, showTyped);
    connect(feed_, &TextFeed::behindChanged, this, [this](bool behind) {
        if (behind) viewport()->setNotice(tr("The text is newer than the picture; saving or F5 shows it."));
    });
    connect(files_, &FileWriter::said, this, &MainWindow::say);
    connect(exports_, &ExportController::said, this, &MainWindow::say);
}

void MainWindow::connectInsertions() {
    views_ = new ViewController(actions_, viewport(), this);
    connect(views_, &ViewController::said, this, &MainWindow::say);
    insertions_ = new InsertionController(editor_, session_, views_, this);
    connect(insertions_, &InsertionController::said, this, &MainWindow::say);
    connect(functions_, &FunctionBrowser::statementRequested, insertions_,
            &InsertionController::insertStatement);
    connect(functions_, &FunctionBrowser::callRequested, insertions_, &InsertionController::insertCall);
    scenes_ =
        new GalleryController({gallery_, documents_, insertions_, editor_, notices_, centralWidget()}, this);
    connect(scenes_, &GalleryController::said, this, &MainWindow::say);
    connect(scenes_, &GalleryController::lessonsRequested, this, [this] { help()->showLessons(); });
    connect(actions_->startPage, &QAction::triggered, scenes_, &GalleryController::showPage);
}

void MainWindow::connectTimeline() {
    history_ = new HistoryController({editor_, viewport(), study<SectionPanel>(), actions_, views_}, this);
    timeline_ = new TimelineController(
        {editor_, session_, parameters_, binding_, viewport(), timelinePanel_, history_}, this);
    connect(timeline_, &TimelineController::said, this, &MainWindow::say);
    // Undo takes frames that go by back, before the text has a step of them.
    connect(timeline_, &TimelineController::movingChanged, display_, &SceneDisplay::setPlaying);
    connect(timeline_, &TimelineController::movingChanged, this, &MainWindow::offerUndoOfPlay);
}

void MainWindow::offerUndoOfPlay(bool playing) {
    if (playing)
        actions_->undo->setEnabled(true);
    else
        editor_->history()->tellMoved();
}

void MainWindow::say(const QString& message) { statusBar()->showMessage(message, timing::messageDuration); }

void MainWindow::connectTextActions() {
    const auto on = [](QAction* action, auto receiver, auto method) {
        connect(action, &QAction::triggered, receiver, method);
    };
    // A slider that plays has not told the text yet.
    for (QAction* action :
         {actions_->undo, actions_->redo, actions_->save, actions_->saveAs, actions_->copyIsosurface,
          actions_->exportInclude, actions_->exportScene, actions_->exportVirtualight, actions_->exportImage,
          actions_->exportMesh, actions_->exportAnimation, actions_->exportFrames}) {
        on(action, parameters_, &ParameterPanel::settle);
        on(action, timeline_, &TimelineController::settle);
    }
    // Undo takes the play back, before the text has a step of it.
    connect(parameters_->player(), &SliderPlayer::playingChanged, display_, &SceneDisplay::setPlaying);
    connect(parameters_->player(), &SliderPlayer::playingChanged, this, &MainWindow::offerUndoOfPlay);
    connect(viewport(), &Viewport::progressed, parameters_->player(), [this](const RenderProgress& progress) {
        if (progress.finished) parameters_->player()->pictureFinished();
    });
    on(actions_->undo, editor_, &SceneEditor::undo);
    on(actions_->redo, editor_, &SceneEditor::redo);
    on(actions_->find, findBar_, &FindBar::showFind);
    on(actions_->replace, findBar_, &FindBar::showReplace);
    on(actions_->findNext, findBar_, &FindBar::findNext);
    on(actions_->findPrevious, findBar_, &FindBar::findPrevious);
    on(actions_->comment, editor_, &SceneEditor::toggleComment);
    on(actions_->insertFunction, this, [this] {
        docks_->bringUp(docks_->find("functions"));
        functions_->startSearch();
    });
    on(actions_->gallery, this, [this] {
        docks_->bringUp(docks_->find("gallery"));
        gallery_->startSearch();
    });
    on(actions_->largerText, editor_, [this] { editor_->zoomIn(); });
    on(actions_->smallerText, editor_, [this] { editor_->zoomOut(); });
    on(actions_->normalText, editor_, &SceneEditor::resetZoom);
}

void MainWindow::connectViewActions() {
    const auto on = [](QAction* action, auto receiver, auto method) {
        connect(action, &QAction::triggered, receiver, method);
    };
    on(actions_->resetView, viewport(), &Viewport::resetView);
    on(actions_->writeView, exports_, &ExportController::writeView);
    on(actions_->redraw, viewport(), &Viewport::restart);
    on(actions_->stop, viewport(), &Viewport::stop);
    on(actions_->verdicts, viewport(), &Viewport::setVerdictsShown);
    on(actions_->includeFolders, this, &MainWindow::editIncludeFolders);
    on(actions_->nextPane, this, [this] { walkPanes(true); });
    on(actions_->previousPane, this, [this] { walkPanes(false); });
    for (QAction* language : actions_->languages)
        on(language, this, [this] { notices_->tell(tr("The language changes at the next start.")); });
    on(actions_->help, this, [this] { help()->showForFocus(); });
    on(actions_->lessons, this, [this] { help()->showLessons(); });
    on(actions_->commands, this, [this] { CommandPalette::toggle(this); });
    on(actions_->shortcuts, this, &MainWindow::showShortcuts);
    on(actions_->whatsThis, this, [] { QWhatsThis::enterWhatsThisMode(); });
    on(actions_->about, this, &MainWindow::showAbout);
}

void MainWindow::connectFileActions() {
    const auto on = [](QAction* action, auto receiver, auto method) {
        connect(action, &QAction::triggered, receiver, method);
    };
    on(actions_->newFile, documents_, &DocumentController::newDocument);
    on(actions_->newWindow, this, &MainWindow::windowRequested);
    on(actions_->open, documents_, &DocumentController::chooseAndOpen);
    on(actions_->save, documents_, &DocumentController::save);
    on(actions_->saveAs, documents_, &DocumentController::saveAs);
    on(actions_->keptTexts, documents_, &DocumentController::showKeptTexts);
    on(actions_->copyIsosurface, exports_, &ExportController::copyIsosurface);
    on(actions_->copyPicture, exports_, &ExportController::copyPicture);
    on(actions_->pictureQueue, exports_, &ExportController::showQueue);
    on(actions_->exportInclude, exports_, &ExportController::exportInclude);
    on(actions_->exportScene, exports_, &ExportController::exportScene);
    on(actions_->exportVirtualight, exports_, &ExportController::exportVirtualightText);
    on(actions_->exportImage, exports_, &ExportController::exportImage);
    on(actions_->exportAnimation, exports_, &ExportController::exportAnimation);
    on(actions_->exportFrames, exports_, &ExportController::exportFrames);
    connect(timelinePanel_, &TimelinePanel::exportRequested, actions_->exportFrames, &QAction::trigger);
    on(actions_->exportMesh, exports_, &ExportController::exportMesh);
    on(actions_->quit, this, &QWidget::close);
}

Viewport* MainWindow::viewport() const { return viewportPanel_->viewport(); }

void MainWindow::walkPanes(bool forward) {
    if (!paneWalk_) paneWalk_ = new PaneWalk(this, docks_, viewport());
    paneWalk_->setCover(scenes_->page());
    paneWalk_->go(forward);
}

HelpController* MainWindow::help() {
    if (!help_)
        help_ =
            new HelpController({this, docks_, documents_, editor_, functions_, actions_, insertions_}, this);
    return help_;
}

bool MainWindow::openFile(const QString& path) { return documents_->openFile(path); }

QString MainWindow::start(const QString& file) {
    // Behind the first painting of the window.
    if (file.isEmpty() && StartPage::wantedAtStart())
        QTimer::singleShot(0, scenes_, &GalleryController::showPage);
    const QString problem = documents_->start(file);
    memory_->begin();
    return problem;
}

void MainWindow::showTutorial() { documents_->showExample(QStringLiteral("tutorial.pov")); }

bool MainWindow::atRest() const {
    if (session_->busy() || display_->panelsBehind() || !views_->idle() || !insertions_->idle() ||
        !fitter_->idle())
        return false;
    // A text of which nothing can be shown gives no picture to wait for.
    if (!session_->scene()) return session_->result() != nullptr;
    const auto& studies = panels_->entries();
    return viewport()->finished() && !viewport()->picture().isNull() && !viewport()->overlay().busy() &&
           !viewport()->softening() &&
           std::all_of(studies.begin(), studies.end(), [](const auto& one) { return one.panel->settled(); });
}

void MainWindow::setTheme(Theme theme) { choices_->setTheme(theme); }

void MainWindow::updateTitle() {
    setWindowTitle(tr("%1 – Isoscope").arg(documents_->title()));
    setWindowFilePath(documents_->document()->filePath());
    setWindowModified(documents_->document()->isModified());
}

void MainWindow::showShortcuts() { (new ShortcutWindow(menuBar(), actions_->all(), keys_, this))->show(); }

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
    parameters_->settle();
    timeline_->settle();
    if (!documents_->prepareToClose()) {
        event->ignore();
        return;
    }
    choices_->write();
    memory_->write();
    documents_->keepHistory();
    // All are asked before the first is waited for.
    session_->stop();
    viewport()->stop();
    studies_->stop();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QMimeData* dragged = event->mimeData();
    if (dragged->hasUrls() && dragged->urls().first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.isEmpty() || !urls.first().isLocalFile()) return;
    event->acceptProposedAction();
    openFile(urls.first().toLocalFile());
}

}  // namespace isoscope
