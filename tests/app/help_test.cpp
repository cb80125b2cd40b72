// SPDX-License-Identifier: GPL-3.0-or-later
// F1: what it opens from where, and what the scenes of its pages do to the text.
#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QSpinBox>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/document/kept_texts_window.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/functions/function_browser.h"
#include "widgets/help/help_browser.h"
#include "widgets/help/help_panel.h"
#include "widgets/notice_bar.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

class HelpTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    HelpPanel* panel() const { return window().findChild<HelpPanel*>(); }
    QString address() const { return panel() ? panel()->browser()->address() : QString(); }
    /// Presses F1 in this widget.
    static void ask(QWidget* widget) {
        widget->setFocus();
        QTRY_VERIFY(widget->hasFocus());
        QTest::keyClick(widget, Qt::Key_F1);
    }
    /// Puts the caret into the first `word` of the text.
    void askIn(const QString& word) const {
        SceneEditor* editor = window().editor();
        const qsizetype at = editor->sceneText().toUtf8().indexOf(word.toUtf8());
        QVERIFY(at >= 0);
        editor->SendScintilla(SceneEditor::SCI_GOTOPOS, static_cast<long>(at) + 1);
        ask(editor);
    }
    /// Clicks the link to scene number `index` of the page.
    void openScene(int index) const {
        emit panel()->browser()->anchorClicked(QUrl(QString("scene:%1").arg(index)));
    }
    QByteArray text() const { return window().editor()->sceneText().toUtf8(); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void nothingIsMadeBeforeItIsWanted() {
        QVERIFY(!panel());
        QVERIFY(!window().docks()->find("help"));
        askIn("max_gradient");
        QVERIFY(panel()->isVisible());
        QVERIFY(window().docks()->find("help"));
    }

    void wordsHaveTheirPages() {
        askIn("max_gradient");
        QCOMPARE(address(), QString("help/isosurface.md#max_gradient"));
        // Its section is marked, for it may be too near to the end of the page to stand at the top.
        const HelpBrowser* browser = panel()->browser();
        QCOMPARE(browser->extraSelections().size(), 1);
        const QTextCursor heading = browser->extraSelections().first().cursor;
        QCOMPARE(heading.selectedText(), QString("max_gradient"));
        QTRY_VERIFY(browser->viewport()->rect().contains(browser->cursorRect(heading)));
        askIn("f_torus");
        QCOMPARE(address(), QString("function/f_torus"));
        askIn("contained_by");
        QCOMPARE(address(), QString("help/isosurface.md#contained_by"));
        askIn("sqrt");
        QCOMPARE(address(), QString("povray/operators.md"));
        QVERIFY(!browser->extraSelections().isEmpty());
    }

    void aNumberHasThePageOfWhatItBelongsTo() {
        askIn("2.1");
        QCOMPARE(address(), QString("help/isosurface.md#max_gradient"));
        askIn("0.18");
        QCOMPARE(address(), QString("function/f_torus"));
        askIn("Radius = 0.55");
        QCOMPARE(address(), HelpLibrary::index());
    }

    void anEmptyPlaceHasTheIndex() {
        SceneEditor* editor = window().editor();
        editor->append("\n\n\n");
        editor->SendScintilla(SceneEditor::SCI_DOCUMENTEND);
        QCOMPARE(editor->wordAtCaret(), QString());
        ask(editor);
        QCOMPARE(address(), HelpLibrary::index());
        // The same behind the last letter of a text without a line's end.
        editor->setSceneText("x");
        editor->SendScintilla(SceneEditor::SCI_DOCUMENTEND);
        QCOMPARE(editor->wordAtCaret(), QString("x"));
        editor->setSceneText("");
        QCOMPARE(editor->wordAtCaret(), QString());
    }

    void panelsHaveTheirSections() {
        ask(window().viewport());
        QCOMPARE(address(), QString("help/window.md#picture"));
        for (auto* slider : window().parameters()->findChildren<ParameterSlider*>())
            if (slider->name() == "threshold") ask(slider->findChild<QAbstractSpinBox*>());
        QCOMPARE(address(), QString("help/isosurface.md#threshold"));
        // Every dock's section is there.
        const QString page = panel()->library().text("help/window.md");
        QStringList headings;
        for (const QString& line : page.split('\n'))
            if (line.startsWith("## ")) headings << headingAnchor(line.mid(3));
        for (const QDockWidget* dock : window().docks()->all()) {
            const QString name = dock->objectName();
            if (name == "help") continue;
            const QString anchor = name == "editor" ? "text" : name == "section" ? "cross-section" : name;
            QVERIFY2(headings.contains(anchor), qPrintable(name));
        }
        // A function that is selected has a page.
        window().actions()->insertFunction->trigger();
        QVERIFY(window().functions()->current());
        QWidget* search = QApplication::focusWidget();
        QTRY_VERIFY(window().functions()->isAncestorOf(search));
        QTest::keyClick(search, Qt::Key_F1);
        QCOMPARE(address(), "function/" + QString::fromStdString(window().functions()->current()->name));
    }

    void escapeGivesTheFocusBack() {
        askIn("max_gradient");
        QTRY_VERIFY(panel()->browser()->hasFocus());
        QTest::keyClick(panel()->browser(), Qt::Key_Escape);
        QTRY_VERIFY(window().editor()->hasFocus());
        QVERIFY(panel()->isVisible());
    }

    void copiedIsWhatIsSelectedOnThePage() {
        askIn("max_gradient");
        HelpBrowser* browser = panel()->browser();
        QTRY_VERIFY(browser->hasFocus());
        const QByteArray before = text();
        QTest::keyClick(browser, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(browser, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QGuiApplication::clipboard()->text().startsWith("The isosurface statement"));
        QCOMPARE(text(), before);
    }

    /// *View, Cut Faces* of a page is a command of the menus.
    void pagesNameCommandsThatAreThere() {
        QStringList commands;
        const std::function<void(const QMenu*, const QString&)> collect = [&](const QMenu* menu,
                                                                              const QString& path) {
            for (const QAction* action : menu->actions()) {
                const QString name = path + ", " + QString(action->text()).remove('&').remove("…");
                commands << name;
                if (action->menu()) collect(action->menu(), name);
            }
        };
        QStringList menus;
        for (const QAction* action : window().menuBar()->actions()) {
            menus << QString(action->text()).remove('&');
            collect(action->menu(), menus.last());
        }
        const QRegularExpression named("\\*((?:" + menus.join('|') + "),\\s[^*]+)\\*");
        window().actions()->lessons->trigger();
        int count = 0;
        for (const HelpPage& page : panel()->library().contents())
            for (auto found = named.globalMatch(page.text); found.hasNext(); ++count) {
                const QString name = found.next().captured(1).simplified();
                QVERIFY2(commands.contains(name), qPrintable(page.address + ": " + name));
            }
        qInfo("%d commands", count);
        QVERIFY(count > 12);
    }

    void lettersFollowTheText() {
        askIn("max_gradient");
        const double size = panel()->browser()->document()->defaultFont().pointSizeF();
        window().actions()->largerText->trigger();
        QTRY_VERIFY(panel()->browser()->document()->defaultFont().pointSizeF() > size);
        window().actions()->normalText->trigger();
        QTRY_COMPARE(panel()->browser()->document()->defaultFont().pointSizeF(), size);
    }

    /// Its scene becomes the text; what was typed before is among the kept texts.
    void aSceneIsOpenedAndNothingIsLost() {
        driver_->typeBehind("Radius = 0.55;", " // mine");
        window().actions()->lessons->trigger();
        QCOMPARE(address(), QString("help/README.md#lessons"));
        panel()->open("help/lessons/01-what-is-an-isosurface.md");
        openScene(1);
        QTRY_VERIFY(text().startsWith("// A ball with waves."));
        QVERIFY(driver_->rests());
        QVERIFY(window().windowTitle().contains("A ball with waves"));
        QVERIFY(window().actions()->certified->isChecked());
        QVERIFY(distinctColors(driver_->picture()) > 50);
        window().actions()->keptTexts->trigger();
        auto* kept = window().findChild<KeptTextsWindow*>();
        QVERIFY(kept);
        QCOMPARE(kept->count(), 1);
        QVERIFY(kept->findChild<QPlainTextEdit*>()->toPlainText().contains("// mine"));
        kept->close();

        // A lesson about what POV-Ray loses shows that.
        panel()->open("help/lessons/05-max-gradient-and-holes.md");
        openScene(0);
        QTRY_VERIFY(text().contains("Too low a max_gradient"));
        QVERIFY(window().actions()->povray->isChecked());
        // The next one is shown as usual.
        openScene(1);
        QTRY_VERIFY(text().contains("The right max_gradient"));
        QVERIFY(window().actions()->certified->isChecked());
    }

    void aFileWithChangesIsAskedAbout() {
        QVERIFY(driver_->openText("// a file\n"));
        driver_->typeBehind("// a file", " changed");
        window().actions()->lessons->trigger();
        panel()->open("function/f_torus");
        openScene(0);
        QVERIFY(text().startsWith("// a file changed"));
        QTRY_VERIFY(window().notices()->isVisible());
        QVERIFY(WindowDriver::press(window().notices(), "Discard"));
        QTRY_VERIFY(text().startsWith("// f_torus."));
        QVERIFY(driver_->rests());
    }

    void resetLayoutClosesIt() {
        askIn("max_gradient");
        window().actions()->resetLayout->trigger();
        QVERIFY(!panel()->isVisible());
        QTest::keyClick(window().editor(), Qt::Key_F1);
        QVERIFY(panel()->isVisible());
        // At the next start it is closed, and made again when it is wanted.
        driver_->restart();
        window().showTutorial();
        QVERIFY(driver_->rests());
        QVERIFY(!panel());
        askIn("max_gradient");
        QVERIFY(panel()->isVisible());
    }
};

QTEST_MAIN(HelpTest)
#include "help_test.moc"
