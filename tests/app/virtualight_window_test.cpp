// SPDX-License-Identifier: GPL-3.0-or-later
// VirtuaLight's texts in the window: opened, edited, moved by sliders and exported as POV-Ray's are.
#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/actions.h"
#include "tests/app/test_folder.h"
#include "tests/app/window_driver.h"
#include "widgets/document/recent_files.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/reading_bar.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/editor/scene_lexer.h"
#include "widgets/editor/scene_words.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/verdicts/problems_panel.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray ball =
    "Declare size = 1.5\n"
    "Shape [ ImplicitSurface(x^2 + y^2 + z^2 - 0.75*size) Bound((-2,-2,-2), (2,2,2)) ]\n";

}  // namespace

class VirtualightWindowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    TestFolder folder_;

    SceneStyle styleOf(const QString& word) const {
        return styleAt((*driver_)->editor(), (*driver_)->editor()->sceneText().indexOf(word));
    }
    /// Of the menu Examples.
    QList<QAction*> examples() const {
        QList<QAction*> found;
        for (QMenu* menu : (*driver_)->menuBar()->findChildren<QMenu*>()) found += menu->actions();
        for (QMenu* menu : driver_->window().findChildren<QMenu*>()) found += menu->actions();
        erase_if(found, [](const QAction* action) {
            return !action->toolTip().startsWith(QStringLiteral("Open the example"));
        });
        return found;
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void aDroppedFileOpensAsAnyScene() {
        WindowDriver& d = *driver_;
        const QString file = folder_.write(QStringLiteral("ball.vl"), ball);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&d.window(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&d.window(), &drop);
        QVERIFY(d.rests());
        QVERIFY(d->session()->result()->ok());
        QVERIFY(d->session()->result()->notation == Notation::virtualight);
        QVERIFY(distinctColors(d.picture()) > 50);
        QVERIFY(d->windowTitle().contains(QStringLiteral("ball.vl")));
        QVERIFY(d->documents()->recentFiles()->paths().contains(file));
    }

    void wordsAreColouredAndOffered() {
        WindowDriver& d = *driver_;
        QVERIFY(styleOf(QStringLiteral("isosurface")) == SceneStyle::keyword);
        QVERIFY(d->openFile(folder_.write(QStringLiteral("ball.vl"), ball)));
        QVERIFY(d.rests());
        QVERIFY(styleOf(QStringLiteral("Declare")) == SceneStyle::directive);
        QVERIFY(styleOf(QStringLiteral("ImplicitSurface")) == SceneStyle::keyword);
        QVERIFY(styleOf(QStringLiteral("size")) == SceneStyle::plain);
        QVERIFY(styleOf(QStringLiteral("0.75")) == SceneStyle::number);
        QVERIFY(sceneWords(Notation::virtualight).contains(QStringLiteral("SurfaceOfRevolution")));
        QVERIFY(!sceneWords(Notation::virtualight).contains(QStringLiteral("isosurface")));
        QCOMPARE(callTip(QStringLiteral("Sphere"), Notation::virtualight),
                 QStringLiteral("Sphere(center, radius)"));
        d->move(0, 0);
        d.typeBehind(QStringLiteral("(2,2,2)) ]\n"), QStringLiteral("Shape [ Cyl"));
        QTRY_VERIFY(d->editor()->isListActive());
        QTest::keyClick(d->editor()->viewport(), Qt::Key_Tab);
        QVERIFY2(d->editor()->sceneText().contains(QStringLiteral("Shape [ Cylinder")),
                 qPrintable(d->editor()->sceneText()));
        // And back; what is not saved would be asked about first.
        d->actions()->save->trigger();
        d->showTutorial();
        QVERIFY(d.rests());
        QVERIFY(styleOf(QStringLiteral("isosurface")) == SceneStyle::keyword);
    }

    void aLiteralOfAFormulaHasASlider() {
        WindowDriver& d = *driver_;
        QVERIFY(d->openFile(folder_.write(QStringLiteral("ball.vl"), ball)));
        QVERIFY(d.rests());
        const int index = d.parameter(QStringLiteral("function, number 4"));
        QVERIFY(index >= 0);
        QCOMPARE(d->parameters()->slider(index)->value(), 0.75);
        const QImage before = d.picture();
        d.drag(index, 60);
        QVERIFY(d.rests());
        const double now = d->parameters()->slider(index)->value();
        QVERIFY(now != 0.75);
        QVERIFY(difference(d.picture(), before) > 0.005);
        QCOMPARE(d.numberBehind(QStringLiteral("z^2 - ")), now);
        d->actions()->undo->trigger();
        QCOMPARE(d->editor()->sceneText().toUtf8(), ball);
    }

    void theGalleryShowsItsExamples() {
        WindowDriver& d = *driver_;
        QStringList titles;
        for (QAction* example : examples()) {
            if (!example->text().startsWith(QStringLiteral("VirtuaLight")) ||
                titles.contains(example->text()))
                continue;
            titles << example->text();
            WindowDriver::trigger(example);
            QVERIFY(d.rests());
            QVERIFY2(d->session()->result()->ok(), qPrintable(example->text()));
            QVERIFY(d->session()->result()->notation == Notation::virtualight);
            QVERIFY2(distinctColors(d.picture()) > 50, qPrintable(example->text()));
        }
        QCOMPARE(titles.size(), 4);
        // The ending tells the notation when it is opened again.
        const QString suggested =
            WindowDriver::triggerAndChoose(d->actions()->saveAs, folder_.path(QStringLiteral("mine")));
        QVERIFY2(suggested.endsWith(QStringLiteral("scene.vl")), qPrintable(suggested));
        QVERIFY(QFile::exists(folder_.path(QStringLiteral("mine.vl"))));
    }

    void exportsGoBothWays() {
        WindowDriver& d = *driver_;
        QVERIFY(d->openFile(folder_.write(QStringLiteral("ball.vl"), ball)));
        QVERIFY(d.rests());
        const QImage seen = d.picture();
        WindowDriver::triggerAndChoose(d->actions()->exportScene, folder_.path(QStringLiteral("out")));
        QVERIFY(folder_.contents(QStringLiteral("out.pov")).contains("isosurface {"));
        WindowDriver::triggerAndChoose(d->actions()->exportInclude, folder_.path(QStringLiteral("objects")));
        QVERIFY(folder_.contents(QStringLiteral("objects.inc")).contains("isosurface {"));
        QVERIFY(!folder_.contents(QStringLiteral("objects.inc")).contains("camera"));
        QVERIFY(d->openFile(folder_.path(QStringLiteral("out.pov"))));
        QVERIFY(d.rests());
        QVERIFY2(difference(d.picture(), seen) < 0.02,
                 qPrintable(QString::number(difference(d.picture(), seen))));
        WindowDriver::triggerAndChoose(d->actions()->exportVirtualight, folder_.path(QStringLiteral("back")));
        QVERIFY(folder_.contents(QStringLiteral("back.vl")).contains("ImplicitSurface("));
        QVERIFY(d->openFile(folder_.path(QStringLiteral("back.vl"))));
        QVERIFY(d.rests());
        QVERIFY(d->session()->result()->ok());
        QVERIFY(d->session()->result()->notation == Notation::virtualight);
        QVERIFY(distinctColors(d.picture()) > 50);
    }

    void aTextThatTakesLongHasAStopButton() {
        WindowDriver& d = *driver_;
        const QImage before = d.picture();
        ReadingBar* bar = d->readingBar();
        QVERIFY(!bar->isVisible());
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" #while (1) #local A = 1; #end "));
        QTRY_VERIFY(bar->isVisible());
        QVERIFY2(bar->text().startsWith(QStringLiteral("Reading the text: ")), qPrintable(bar->text()));
        QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY(!bar->isVisible());
        QTRY_VERIFY(d->problems()->title().contains(QStringLiteral("error")));
        auto* list = d->problems()->findChild<QTreeWidget*>();
        QVERIFY(list && list->topLevelItemCount() == 1);
        QVERIFY(d.rests());
        QCOMPARE(difference(d.picture(), before), 0.0);
    }
};

QTEST_MAIN(VirtualightWindowTest)
#include "virtualight_window_test.moc"
