// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QTreeWidget>
#include <QUrl>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/export_controller.h"
#include "app/desktop/window/actions.h"
#include "tests/app/test_folder.h"
#include "tests/app/window_driver.h"
#include "tests/support/sanitizer.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_view.h"
#include "widgets/timing.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

QString squiggled(SceneEditor* editor) {
    // The text under any indicator that a diagnostic may use, found by asking each position.
    QByteArray marked;
    const QByteArray text = editor->sceneText().toUtf8();
    for (int i = 0; i < text.size(); ++i)
        for (int indicator = 8; indicator < 32; ++indicator) {
            const long style = editor->SendScintilla(QsciScintilla::SCI_INDICGETSTYLE, indicator);
            const bool squiggle = style == QsciScintilla::INDIC_SQUIGGLE ||
                                  style == QsciScintilla::INDIC_SQUIGGLELOW ||
                                  style == QsciScintilla::INDIC_SQUIGGLEPIXMAP;
            if (squiggle &&
                editor->SendScintilla(QsciScintilla::SCI_INDICATORVALUEAT, indicator, static_cast<long>(i)))
                marked += text[i];
        }
    return QString::fromUtf8(marked);
}

}  // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    TestFolder folder_;

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        (*driver_)->actions()->certified->trigger();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    /// Of two processors the panels took half while a picture was in the making.
    void panelsComeBehindThePicture() {
        WindowDriver& d = *driver_;
        QElapsedTimer since;
        qint64 pictureAfter = 0, sectionAfter = 0;
        connect(d->viewport(), &Viewport::pictureFinished, this,
                [&] { pictureAfter = since.nsecsElapsed(); });
        connect(d->study<SectionPanel>(), &SectionPanel::sampled, this,
                [&] { sectionAfter = since.nsecsElapsed(); });
        since.start();
        emit d->parameters()->valueChanged(d.parameter(QStringLiteral("Radius")), 0.7);
        QVERIFY(QTest::qWaitFor([&] { return sectionAfter > 0; }));
        const qint64 patience = qint64(timing::panelPatience) * 1000 * 1000;
        QVERIFY(sectionAfter > (pictureAfter > 0 ? std::min(pictureAfter, patience) : patience));
        QVERIFY(d.rests());
    }

    void panelsDoNotWaitForSlowPictures() {
        WindowDriver& d = *driver_;
        d->actions()->povray->trigger();
        QVERIFY(d.rests());
        QSignalSpy sampled(d->study<SectionPanel>(), &SectionPanel::sampled);
        emit d->parameters()->valueChanged(d.parameter(QStringLiteral("max_gradient")), 1e7);
        QVERIFY(QTest::qWaitFor([&] { return !sampled.empty(); }));
        QVERIFY(!d->viewport()->finished());
        d->viewport()->stop();
        QVERIFY(d.rests());
    }

    void firstStartShowsTheTutorial() {
        WindowDriver& d = *driver_;
        QVERIFY2(distinctColors(d.picture()) > 100, qPrintable(QString::number(distinctColors(d.picture()))));
        QVERIFY(distinctColors(d->study<SectionPanel>()->view()->grab().toImage()) > 100);
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("isosurface")));
        QVERIFY(!d->documents()->document()->isModified());
        for (const char* name :
             {"Radius", "Melt", "Major Radius", "Minor Radius", "threshold", "accuracy", "max_gradient"})
            QVERIFY2(d.parameter(QString::fromLatin1(name)) >= 0, name);
        QVERIFY2(d->viewportPanel()->status().startsWith(QStringLiteral("Finished")),
                 qPrintable(d->viewportPanel()->status()));
        QVERIFY(d->viewportPanel()->status().contains(QStringLiteral("evaluations")));
    }

    void mistakeIsMarkedListedAndTheLastPictureStays() {
        WindowDriver& d = *driver_;
        const QImage good = d.picture();
        d.typeBehind(QStringLiteral("function { Ball(x, y, z)"), QStringLiteral("*f_tor(x)"));
        QTRY_VERIFY(d->problems()->title().contains(QStringLiteral("error")));
        QVERIFY2(squiggled(d->editor()).contains(QStringLiteral("f_tor")),
                 qPrintable(squiggled(d->editor())));
        auto* list = d->problems()->findChild<QTreeWidget*>();
        QVERIFY(list && list->topLevelItemCount() >= 1);
        QVERIFY(d.rests());
        QCOMPARE(difference(d.picture(), good), 0.0);

        // Going back to a good text clears everything.
        d->actions()->undo->trigger();
        while (d->editor()->isUndoAvailable()) d->actions()->undo->trigger();
        QTRY_COMPARE(d->problems()->title(), QStringLiteral("Problems"));
        QVERIFY(d.rests());
        QCOMPARE(squiggled(d->editor()), QString());
    }

    void typingChangesThePicture() {
        WindowDriver& d = *driver_;
        const QImage before = d.picture();
        d.typeBehind(QStringLiteral("#declare Radius = 0."), QStringLiteral("7"));  // 0.755
        QTRY_VERIFY(d->session()->busy());
        QVERIFY(d.rests());
        QVERIFY(difference(d.picture(), before) > 0.01);
        QCOMPARE(d->parameters()->slider(d.parameter(QStringLiteral("Radius")))->value(), 0.755);
    }

    /// The tutorial's sphere has no max_gradient, and yet a slider.
    void aSettingThatIsLeftOutIsWrittenByItsSlider() {
        WindowDriver& d = *driver_;
        folder_.write(QStringLiteral("left-out.pov"),
                      "camera { location -4*z look_at 0 }\n"
                      "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } }\n"
                      "  pigment { rgb 1 } }\n");
        QVERIFY(d->openFile(folder_.path(QStringLiteral("left-out.pov"))));
        QVERIFY(d.rests());
        const QString text = d->editor()->sceneText();
        for (const char* name : {"threshold", "accuracy", "max_gradient"})
            QVERIFY2(d.parameter(QString::fromLatin1(name)) >= 0, name);
        int index = d.parameter(QStringLiteral("max_gradient"));
        QCOMPARE(d->parameters()->slider(index)->value(), 1.1);
        d.drag(index, 60, [&] {
            QVERIFY(d->editor()->sceneText().contains(QStringLiteral("1.2 } }\n  max_gradient ")));
        });
        QVERIFY(d.rests());
        const double written = d.numberBehind(QStringLiteral("max_gradient "));
        QVERIFY2(written > 1.5, qPrintable(QString::number(written)));
        index = d.parameter(QStringLiteral("max_gradient"));
        QCOMPARE(d->parameters()->slider(index)->value(), written);
        QVERIFY(d->session()->result()->ok());
        // threshold and accuracy are still offered, and the whole drag is one step.
        QVERIFY(d.parameter(QStringLiteral("threshold")) >= 0);
        d->actions()->undo->trigger();
        QCOMPARE(d->editor()->sceneText(), text);
    }

    void sliderMovesTextAndPictureInOneUndoStep_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("key");
        QTest::newRow("declared number") << "Radius"
                                         << "#declare Radius = ";
        QTest::newRow("argument of a built-in") << "Major Radius"
                                                << "f_torus(x, y, z, ";
        QTest::newRow("threshold") << "threshold"
                                   << "threshold ";
        QTest::newRow("max_gradient") << "max_gradient"
                                      << "max_gradient ";
    }
    void sliderMovesTextAndPictureInOneUndoStep() {
        QFETCH(QString, name);
        QFETCH(QString, key);
        WindowDriver& d = *driver_;
        const QString text = d->editor()->sceneText();
        // Certified roots do not use max_gradient.
        if (name == QLatin1String("max_gradient")) d->actions()->povray->trigger();
        QVERIFY(d.rests());
        const QImage before = d.picture();
        const int index = d.parameter(name);
        QVERIFY(index >= 0);
        const double start = d->parameters()->slider(index)->value();
        double midway = start;
        d.drag(index, name == QLatin1String("max_gradient") ? -60 : -25,
               [&] { midway = d.numberBehind(key); });
        QVERIFY2(midway != start, "the text follows while the slider is held");
        QVERIFY(d.rests());
        const int now = d.parameter(name);
        QCOMPARE(now, index);
        QCOMPARE(d.numberBehind(key), d->parameters()->slider(now)->value());
        QVERIFY(d.numberBehind(key) != start);
        QVERIFY2(difference(d.picture(), before) > 0.001,
                 qPrintable(QString::number(difference(d.picture(), before))));
        QTRY_VERIFY(d->editor()->isUndoAvailable());

        d->actions()->undo->trigger();
        QCOMPARE(d->editor()->sceneText(), text);
        QTRY_VERIFY(!d->session()->busy());
        QVERIFY(d.rests());
        QCOMPARE(d->parameters()->slider(index)->value(), start);
        QCOMPARE(difference(d.picture(), before), 0.0);
    }

    void scrubbedNumberMovesSliderAndPicture() {
        WindowDriver& d = *driver_;
        const QImage before = d.picture();
        const int index = d.parameter(QStringLiteral("Radius"));
        SceneEditor* editor = d->editor();
        const int at = static_cast<int>(editor->sceneText().indexOf(QStringLiteral("0.55;"))) + 1;
        const QPoint place(
            static_cast<int>(editor->SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, at)) + 1,
            static_cast<int>(editor->SendScintilla(QsciScintilla::SCI_POINTYFROMPOSITION, 0UL, at)) + 4);
        QWidget* area = editor->viewport();
        for (int i = 0; i < 8; ++i) {
            // With Alt, some platforms turn the wheel's direction sideways.
            QWheelEvent turn(place, area->mapToGlobal(QPointF(place)), {}, {120, 0}, Qt::NoButton,
                             Qt::AltModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(area, &turn);
        }
        const double now = d.numberBehind(QStringLiteral("#declare Radius = "));
        QVERIFY(now != 0.55);
        QCOMPARE(d->parameters()->slider(index)->value(), now);
        QVERIFY(d.rests());
        QVERIFY(difference(d.picture(), before) > 0.001);
        QCOMPARE(d->parameters()->slider(index)->value(), now);
    }

    void fastDragsKeepTextAndSliderTogether() {
        WindowDriver& d = *driver_;
        const int index = d.parameter(QStringLiteral("Radius"));
        for (int i = 0; i < 12; ++i) {
            d.drag(index, i % 2 ? -30 - i : 30 + i);
            QCOMPARE(d.numberBehind(QStringLiteral("#declare Radius = ")),
                     d->parameters()->slider(index)->value());
        }
        QVERIFY(d.rests());
        QCOMPARE(d.numberBehind(QStringLiteral("#declare Radius = ")),
                 d->parameters()->slider(index)->value());
        QVERIFY(!d->problems()->title().contains(QStringLiteral("error")));
    }

    void sectionFollowsSliders() {
        WindowDriver& d = *driver_;
        const QImage before = d->study<SectionPanel>()->view()->frame().copy();
        d.drag(d.parameter(QStringLiteral("Radius")), 30);
        QVERIFY(d.rests());
        QVERIFY(difference(d->study<SectionPanel>()->view()->frame(), before) > 0.005);
        d->study<SectionPanel>()->setAxis(0);
        d->study<SectionPanel>()->setPosition(0.4);
        QVERIFY(d.rests());
        QCOMPARE(d->study<SectionPanel>()->view()->field().plane.axis(), 0);
        QCOMPARE(d->study<SectionPanel>()->view()->field().plane.position(), 0.4);
    }

    void orbitChangesThePictureAndIsWrittenIntoTheText() {
        WindowDriver& d = *driver_;
        const QImage before = d.picture();
        const QString text = d->editor()->sceneText();
        d.dragViewport(d->viewport()->rect().center(), {90, 30});
        QVERIFY(d->viewport()->viewMoved());
        QVERIFY(d.rests());
        const QImage turned = d.picture();
        QVERIFY(difference(turned, before) > 0.01);
        QCOMPARE(d->editor()->sceneText(), text);

        d->actions()->writeView->trigger();
        QVERIFY(d->editor()->sceneText() != text);
        QCOMPARE(d->editor()->sceneText().count(QStringLiteral("camera {")), 1);
        QTRY_VERIFY(!d->session()->busy());
        QVERIFY(d.rests());
        QVERIFY2(difference(d.picture(), turned) < 0.01,
                 "the text's camera shows what the mouse had turned to");
        QVERIFY(!d->viewport()->viewMoved());

        // The camera block goes, and then the turn that it was made of.
        d->actions()->undo->trigger();
        QCOMPARE(d->editor()->sceneText(), text);
        QTRY_VERIFY(d->viewport()->viewMoved());
        d->actions()->undo->trigger();
        QVERIFY(!d->viewport()->viewMoved());
        QTRY_VERIFY(!d->session()->busy());
        QVERIFY(d.rests());
        QCOMPARE(difference(d.picture(), before), 0.0);
    }

    void viewWritesACameraWhereThereIsNone() {
        WindowDriver& d = *driver_;
        QString text = d->editor()->sceneText();
        const int from = static_cast<int>(text.indexOf(QStringLiteral("camera {")));
        const int to = static_cast<int>(text.indexOf(QLatin1Char('}'), from)) + 1;
        d->editor()->replaceRange({0, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)}, {});
        QTRY_VERIFY(!d->session()->busy());
        d.dragViewport(d->viewport()->rect().center(), {40, 0});
        d->actions()->writeView->trigger();
        QCOMPARE(d->editor()->sceneText().count(QStringLiteral("camera")), 1);
    }

    void panZoomAndReset() {
        WindowDriver& d = *driver_;
        const QImage home = d.picture();
        d.dragViewport(d->viewport()->rect().center(), {60, 0}, Qt::RightButton);
        QVERIFY(d.rests());
        QVERIFY(difference(d.picture(), home) > 0.01);
        QTest::keyClick(d->viewport(), Qt::Key_Home);
        QVERIFY(d.rests());
        QCOMPARE(difference(d.picture(), home), 0.0);
        d.wheel(d->viewport(), d->viewport()->rect().center(), 240);
        QVERIFY(d.rests());
        QVERIFY(difference(d.picture(), home) > 0.01);
        QTest::mouseDClick(d->viewport(), Qt::LeftButton);
        QTest::mouseRelease(d->viewport(), Qt::LeftButton);
        QVERIFY(d.rests());
        QCOMPARE(difference(d.picture(), home), 0.0);
        QTest::keyClick(d->viewport(), Qt::Key_Left);
        QVERIFY(d->viewport()->viewMoved());
        d->actions()->resetView->trigger();
        QVERIFY(!d->viewport()->viewMoved());
    }

    void wheelZoomsTowardsTheCursor() {
        WindowDriver& d = *driver_;
        // A point away from the middle keeps its colour, up to what the change of perspective does.
        const QPoint at(d->viewport()->width() / 3, d->viewport()->height() / 2);
        const Camera before = d->viewport()->camera();
        d.wheel(d->viewport(), at, 120);
        const Camera zoomed = d->viewport()->camera();
        QVERIFY(!(zoomed == before));
        // Zooming left of the middle shifts the camera to the left, against its `right`.
        QVERIFY(glm::dot(zoomed.lookAt - before.lookAt, before.right) < 0);
    }

    void openSaveAndRecent() {
        WindowDriver& d = *driver_;
        folder_.write(QStringLiteral("ball.pov"),
                      "isosurface { function { x*x + y*y + z*z - 0.5 } max_gradient 4 pigment { rgb 1 } }\n"
                      "camera { location <0, 0, -4> look_at 0 }\nlight_source { <5, 5, -5> rgb 1 }\n");
        QVERIFY(d->openFile(folder_.path(QStringLiteral("ball.pov"))));
        QVERIFY(d.rests());
        QVERIFY(distinctColors(d.picture()) > 50);
        QVERIFY(d->windowTitle().contains(QStringLiteral("ball.pov")));
        QVERIFY(!d->isWindowModified());

        d.typeBehind(QStringLiteral("z*z - 0."), QStringLiteral("9"));
        QVERIFY(d->isWindowModified());
        d->actions()->save->trigger();
        QVERIFY(!d->isWindowModified());
        QFile file(folder_.path(QStringLiteral("ball.pov")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("z*z - 0.95"));
        QCOMPARE(d->documents()->recentFiles()->paths().value(0), QFileInfo(file).absoluteFilePath());
        QVERIFY(d->documents()->saveTo(folder_.path(QStringLiteral("copy.pov"))));
        QCOMPARE(d->documents()->recentFiles()->paths().size(), 2);
    }

    void missingFileIsANoticeAndChangesNothing() {
        WindowDriver& d = *driver_;
        const QString text = d->editor()->sceneText();
        QVERIFY(!d->openFile(folder_.path(QStringLiteral("nowhere.pov"))));
        QVERIFY(d->notices()->isVisible());
        QCOMPARE(d->editor()->sceneText(), text);
    }

    void fileIsDroppedOnTheWindow() {
        WindowDriver& d = *driver_;
        folder_.write(QStringLiteral("dropped.inc"), "isosurface { function { x + y } }\n");
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(folder_.path(QStringLiteral("dropped.inc")))});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&d.window(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&d.window(), &drop);
        QCOMPARE(d->editor()->sceneText(), QStringLiteral("isosurface { function { x + y } }\n"));
        QVERIFY(d->windowTitle().contains(QStringLiteral("dropped.inc")));
    }

    void unsavedTextSurvivesACrash() {
        WindowDriver& d = *driver_;
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" // precious"));
        QTest::qWait(RecoveryStore::interval + 300);
        d.crash();
        d->documents()->offerRecovery();
        QVERIFY(d->notices()->isVisible());
        QVERIFY(!d->editor()->sceneText().contains(QStringLiteral("precious")));  // offered, not forced
        d->notices()->findChild<QPushButton*>()->click();
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("precious")));
        QVERIFY(d->documents()->document()->isModified());
    }

    void unsavedTextIsKeptAtClosingWithoutAQuestion() {
        WindowDriver& d = *driver_;
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" // kept"));
        d.restart();
        d->documents()->offerRecovery();
        QVERIFY(d->notices()->isVisible());
        d->notices()->findChild<QPushButton*>()->click();
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("// kept")));
    }

    void textThatMakesWayIsKeptToo() {
        WindowDriver& d = *driver_;
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" // replaced"));
        d->actions()->newFile->trigger();
        QVERIFY(!d->editor()->sceneText().contains(QStringLiteral("replaced")));
        QVERIFY(d->statusBar()->currentMessage().contains(QStringLiteral("kept")));
        d->documents()->offerRecovery();
        QVERIFY(d->notices()->isVisible());
        d->notices()->findChild<QPushButton*>()->click();
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("// replaced")));
    }

    void savedTextLeavesNothingToRecover() {
        WindowDriver& d = *driver_;
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" // saved"));
        QVERIFY(d->documents()->saveTo(folder_.path(QStringLiteral("saved.pov"))));
        d.restart();
        d->documents()->offerRecovery();
        QVERIFY(!d->notices()->isVisible());
    }

    void isosurfaceIsCopied() {
        WindowDriver& d = *driver_;
        QGuiApplication::clipboard()->clear();
        d->actions()->copyIsosurface->trigger();
        const QString copied = QGuiApplication::clipboard()->text();
        QVERIFY(copied.contains(QStringLiteral("isosurface")));
        QVERIFY(copied.contains(QStringLiteral("Radius")));  // with the declarations it needs
    }

    void layoutAndThemeAreRemembered() {
        WindowDriver& d = *driver_;
        d->actions()->themeDark->trigger();
        d->resize(1100, 760);
        auto* dock = d->findChild<QDockWidget*>(QStringLiteral("problems"));
        dock->close();
        d.restart();
        QVERIFY(d->actions()->themeDark->isChecked());
        QVERIFY(d->editor()->look() == Look::dark);
        QVERIFY(d->palette().color(QPalette::Window).lightness() < 80);
        QVERIFY(!d->findChild<QDockWidget*>(QStringLiteral("problems"))->isVisible());
        QCOMPARE(d->size(), QSize(1100, 760));
        d->actions()->resetLayout->trigger();
        QVERIFY(d->findChild<QDockWidget*>(QStringLiteral("problems"))->isVisible());
    }

    void themeSwitchesWhileRunning() {
        WindowDriver& d = *driver_;
        d->actions()->themeLight->trigger();
        QVERIFY(d.rests());
        const QImage light = d->grab().toImage();
        d->actions()->themeDark->trigger();
        QVERIFY(d.rests());
        const QImage dark = d->grab().toImage();
        QVERIFY(qGray(light.pixel(light.width() / 2, 5)) > qGray(dark.pixel(dark.width() / 2, 5)) + 100);
        QCOMPARE(d->study<SectionPanel>()->view()->settled(), true);
        d->actions()->themeLight->trigger();
    }

    void resizeRendersTheNewSize() {
        WindowDriver& d = *driver_;
        d->resize(1000, 700);
        QTRY_VERIFY(d->viewport()->finished() && d->viewport()->picture().size() == d->viewport()->size());
        QVERIFY(distinctColors(d.picture()) > 100);
    }

    void everyControlHasANameAndATooltip() {
        WindowDriver& d = *driver_;
        QStringList nameless;
        for (QWidget* widget : d->findChildren<QWidget*>()) {
            const bool control = widget->focusPolicy() != Qt::NoFocus && widget->isEnabled() &&
                                 !widget->objectName().startsWith(QLatin1String("qt_")) &&
                                 widget->isVisibleTo(&d.window());
            if (!control) continue;
            const QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
            const QString name = interface ? interface->text(QAccessible::Name) : QString();
            const QString what = QStringLiteral("%1 in %2")
                                     .arg(widget->metaObject()->className(),
                                          widget->parentWidget()->metaObject()->className());
            // Parts of a control are named by the control.
            const bool part = qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) ||
                              qobject_cast<QComboBox*>(widget->parentWidget());
            if (part) continue;
            if (name.isEmpty()) nameless << QStringLiteral("no name: ") + what;
            if (widget->toolTip().isEmpty()) nameless << QStringLiteral("no tooltip: ") + what;
        }
        for (const QAction* action : d->actions()->all())
            if (action->text().isEmpty() || action->toolTip().isEmpty()) nameless << action->objectName();
        nameless.removeDuplicates();
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
    }

    void memoryStaysBelow400Megabytes() {
        if (checksAddresses) QSKIP("the sanitizer takes more than that");
        QFile status(QStringLiteral("/proc/self/status"));
        if (!status.open(QIODevice::ReadOnly)) QSKIP("no /proc on this system");
        const QString text = QString::fromLatin1(status.readAll());
        const int kilobytes =
            text.section(QStringLiteral("VmHWM:"), 1).simplified().section(QLatin1Char(' '), 0, 0).toInt();
        qInfo("largest resident memory: %d MB", kilobytes / 1024);
        QVERIFY(kilobytes > 0);
        QVERIFY2(kilobytes < 400 * 1024, qPrintable(QString::number(kilobytes)));
    }
};

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
