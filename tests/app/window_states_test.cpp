// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QLineEdit>
#include <QPointer>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "core/language/directives/library_paths.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/empty_text_hint.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/find_bar.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_profile.h"
#include "widgets/section/section_view.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

using namespace isoscope;
using namespace isoscope::test;

/// What the window says and shows besides the picture of a good text.
class WindowStatesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    void open(const QByteArray& text) {
        QVERIFY(driver_->openText(text));
        QTRY_VERIFY(!(*driver_)->session()->busy());
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    /// A bug once: it said that the last good picture was shown, of which there was none, beside the
    /// cross-section and the size of the picture before.
    void nothingOfTheOldTextStaysBesideErrors() {
        WindowDriver& d = *driver_;
        open("} } isosurface { function { f_tours(x) } }\n");
        QVERIFY(d->viewport()->picture().isNull());
        QVERIFY2(d->viewport()->notice().contains(QStringLiteral("nothing can be shown")),
                 qPrintable(d->viewport()->notice()));
        QCOMPARE(d->viewportPanel()->status().trimmed(), QStringLiteral("No picture yet"));
        QTest::qWait(300);
        QVERIFY(d->study<SectionPanel>()->view()->field().empty());
    }

    /// An empty text once met a newcomer with nothing at all.
    void anEmptyTextSaysWhatToType() {
        WindowDriver& d = *driver_;
        auto* hint = d->editor()->findChild<EmptyTextHint*>();
        QVERIFY(hint && !hint->isVisible());
        const auto bright = [&] {
            const QImage image = d->viewport()->grab().toImage();
            int pixels = 0;
            for (int y = image.height() / 3; y < image.height() * 2 / 3; ++y)
                for (int x = 0; x < image.width(); ++x) pixels += qGray(image.pixel(x, y)) > 230;
            return pixels;
        };
        d->editor()->setSceneText({});
        QVERIFY(d.rests());
        QVERIFY(hint->isVisible());
        QVERIFY(d->editor()->viewport()->rect().contains(hint->geometry()));
        QTRY_VERIFY(bright() > 100);
        QTest::keyClicks(d->editor(), QStringLiteral("x"));
        QVERIFY(!hint->isVisible());
        d->editor()->undo();
        QVERIFY(hint->isVisible());
    }

    /// A bug once: --screenshot waited a whole minute for a picture of which there was none.
    void aTextThatShowsNothingComesToRest() {
        open("}}}} hello (((\n\x01\xff\"");
        QVERIFY((*driver_)->atRest());
        QVERIFY((*driver_)->viewport()->picture().isNull());
    }

    /// D19: crosshair, overlay, plane and profile of one document stayed over the next.
    void aNewDocumentBeginsWithNothingSwitchedOn() {
        WindowDriver& d = *driver_;
        const Actions& actions = *d->actions();
        WindowDriver::trigger(actions.overlayHoles);
        WindowDriver::trigger(actions.inspectRay);
        WindowDriver::trigger(actions.sectionPlane);
        d->study<SectionPanel>()->setProfileShown(true);
        d->study<SectionPanel>()->setFree();
        d->viewport()->setPicked(QPointF(0.5, 0.5));
        QVERIFY(d.rests());
        WindowDriver::trigger(actions.newFile);
        QVERIFY(d.rests());
        QVERIFY(actions.overlayNone->isChecked());
        QVERIFY(d->viewport()->overlay().kind() == OverlayKind::none);
        QVERIFY(!actions.inspectRay->isChecked() && !d->viewport()->picking());
        QVERIFY(!d->viewport()->pickedPlace());
        QVERIFY(!actions.sectionPlane->isChecked() && !d->viewport()->planeHandle().shown());
        QVERIFY(d->study<SectionPanel>()->profile()->isHidden());
        QVERIFY(!d->study<SectionPanel>()->plane().isFree());
    }

    /// D19: the crosshair stayed when its tool was put away.
    void theCrosshairGoesWithItsTool() {
        WindowDriver& d = *driver_;
        WindowDriver::trigger(d->actions()->inspectRay);
        d->viewport()->setPicked(QPointF(0.5, 0.5));
        WindowDriver::trigger(d->actions()->inspectRay);
        QVERIFY(!d->viewport()->pickedPlace());
    }

    void aRightClickOnThePictureOffersWhatCanBeDoneWithIt() {
        WindowDriver& d = *driver_;
        for (QAction* action : {d->actions()->resetView, d->actions()->writeView, d->actions()->exportImage})
            QVERIFY2(d->viewport()->actions().contains(action), qPrintable(action->text()));
    }

    void whatWasUnderstoodIsShownUndimmed() {
        WindowDriver& d = *driver_;
        open(
            "isosurface { function { x*x + y*y + z*z - 1 } max_gradient 4 pigment { rgb 1 } }\nsphere { 0, "
            "}\n");
        QVERIFY(d.rests());
        QVERIFY(distinctColors(d.picture()) > 20);
        QVERIFY2(d->viewport()->notice().contains(QStringLiteral("what was understood")),
                 qPrintable(d->viewport()->notice()));
        // It follows the text although that never was without errors.
        const QImage before = d.picture();
        d.typeBehind(QStringLiteral("z*z - 1"), QStringLiteral("/4"));
        QTRY_VERIFY(d->session()->busy());
        QVERIFY(d.rests());
        QVERIFY(difference(d.picture(), before) > 0.01);
    }

    void anOlderPictureIsCalledSo() {
        WindowDriver& d = *driver_;
        d.typeBehind(QStringLiteral("function { Ball(x, y, z)"), QStringLiteral("*("));
        QTRY_VERIFY(!d->viewport()->notice().isEmpty());
        QVERIFY2(d->viewport()->notice().contains(QStringLiteral("picture from before")),
                 qPrintable(d->viewport()->notice()));
        d->actions()->undo->trigger();
        d->actions()->undo->trigger();
        QTRY_VERIFY(d->viewport()->notice().isEmpty());
    }

    /// A bug once: only the command line looked into an installed POV-Ray's folder.
    void includeFilesOfAnInstalledPovrayAreFound() {
        if (installedLibraryPaths().empty()) QSKIP("POV-Ray's include files are not installed");
        WindowDriver& d = *driver_;
        open("#include \"textures.inc\"\n#include \"stones.inc\"\nsphere { 0, 1 }\n");
        for (const Diagnostic& diagnostic : d->session()->result()->diagnostics)
            QVERIFY2(diagnostic.message.find("was not found") == std::string::npos,
                     diagnostic.message.c_str());
    }

    void clipboardCommandsGoWhereTheCaretIs() {
        WindowDriver& d = *driver_;
        const QString text = d->editor()->sceneText();
        d->editor()->setFocus();
        d->actions()->selectAll->trigger();
        d->actions()->copy->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), text);
        d->actions()->cut->trigger();
        QCOMPARE(d->editor()->sceneText(), QString());
        d->actions()->paste->trigger();
        QCOMPARE(d->editor()->sceneText(), text);

        d->actions()->find->trigger();
        auto* field = qobject_cast<QLineEdit*>(d->focusWidget());
        QVERIFY(field);
        field->setText(QStringLiteral("Radius"));
        d->actions()->selectAll->trigger();
        d->actions()->cut->trigger();
        QCOMPARE(field->text(), QString());
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("Radius"));
        QCOMPARE(d->editor()->sceneText(), text);
    }

    /// Whatever is typed, and wherever: mistakes are told in the window itself.
    void nothingTypedOpensAModalBox() {
        WindowDriver& d = *driver_;
        QString opened;
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [&] {
            QWidget* box = QApplication::activeModalWidget();
            if (!box) return;
            opened += box->windowTitle() + ' ' + box->metaObject()->className();
            box->close();
        });
        watch.start(0);
        d->editor()->setFocus();
        for (const char* nonsense :
             {"}}{ #if (", "isosurface { function { f_tours(x) 1/0 } max_gradient 1e999 }",
              "#include \"none.inc\"", "#declare x = \"", "#end #end ~?", "#fopen f \"/etc/passwd\" write"}) {
            d.typeBehind({}, QString::fromLatin1(nonsense));
            QTest::keyClick(d->editor()->viewport(), Qt::Key_Return);
            QVERIFY(d.rests(60000));
        }
        d->showTutorial();
        QVERIFY(d.rests(60000));
        for (QDockWidget* dock : d->docks()->all()) d->docks()->bringUp(dock);
        d->actions()->find->trigger();
        int boxes = 0, fields = 0;
        const auto type = [&](QWidget* field, const char* text) {
            field->setFocus();
            QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(field, QString::fromLatin1(text));
            QTest::keyClick(field, Qt::Key_Return);
        };
        // What is typed may take its own field away.
        QList<QPointer<QWidget>> all;
        for (auto* box : d->findChildren<QAbstractSpinBox*>()) all << box;
        for (auto* field : d->findChildren<QLineEdit*>())
            if (!qobject_cast<QAbstractSpinBox*>(field->parentWidget())) all << field;
        for (const QPointer<QWidget>& one : all)
            for (const char* wrong : {"abc", "-1e99", "1/0", "nan", "../no/such.name", ""}) {
                if (!one || !one->isEnabled()) break;
                qobject_cast<QAbstractSpinBox*>(one) ? ++boxes : ++fields;
                type(one, wrong);
            }
        QVERIFY(d.rests(60000));
        QVERIFY2(boxes > 100 && fields > 10, qPrintable(QString("%1 %2").arg(boxes).arg(fields)));
        QVERIFY2(opened.isEmpty(), qPrintable(opened));
        QVERIFY(!QApplication::activeModalWidget());
    }

    void pressedKeysReachTheField() {
        WindowDriver& d = *driver_;
        d->actions()->find->trigger();
        auto* field = qobject_cast<QLineEdit*>(d->focusWidget());
        QVERIFY(field);
        QGuiApplication::clipboard()->setText(QStringLiteral("Melt"));
        QTest::keyClick(field, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(field->text(), QStringLiteral("Melt"));
    }
};

QTEST_MAIN(WindowStatesTest)
#include "window_states_test.moc"
