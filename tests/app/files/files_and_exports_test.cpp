// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QTimer>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/export_controller.h"
#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "core/exchange/png.h"
#include "core/language/directives/library_paths.h"
#include "core/render/render_image.h"
#include "core/study/gradient/proof_note.h"
#include "tests/app/test_folder.h"
#include "tests/app/window_driver.h"
#include "tests/support/povray.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/pictures/image_export_dialog.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// What leaves the program, through the window's own commands and dialogs.
class FilesAndExportsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    TestFolder folder_;

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void saveAsGivesTheTextAName() {
        WindowDriver& d = *driver_;
        const QString suggested =
            WindowDriver::triggerAndChoose(d->actions()->saveAs, folder_.path(QStringLiteral("mine")));
        QVERIFY2(suggested.endsWith(QStringLiteral("scene.pov")), qPrintable(suggested));
        QCOMPARE(QString::fromUtf8(folder_.contents(QStringLiteral("mine.pov"))), d->editor()->sceneText());
        QVERIFY(d->windowTitle().contains(QStringLiteral("mine.pov")));
        QVERIFY(!d->isWindowModified());

        // Saving a text that has a name asks nothing.
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" // more"));
        d->actions()->save->trigger();
        QVERIFY(folder_.contents(QStringLiteral("mine.pov")).contains("// more"));
    }

    void cancelledDialogsWriteNothing() {
        WindowDriver& d = *driver_;
        QTimer poll;
        connect(&poll, &QTimer::timeout, this, [] {
            if (QWidget* dialog = QApplication::activeModalWidget()) QTest::keyClick(dialog, Qt::Key_Escape);
        });
        poll.start(10);
        for (QAction* action : {d->actions()->saveAs, d->actions()->open, d->actions()->exportInclude,
                                d->actions()->exportScene})
            action->trigger();
        QVERIFY(QDir(folder_.path({})).entryList({QStringLiteral("scene*")}).isEmpty());
        QVERIFY(d->documents()->document()->filePath().isEmpty());
    }

    void openThroughTheDialog() {
        WindowDriver& d = *driver_;
        folder_.write(QStringLiteral("plane.pov"), "isosurface { function { y } pigment { rgb 1 } }\n");
        WindowDriver::triggerAndChoose(d->actions()->open, folder_.path(QStringLiteral("plane.pov")));
        QVERIFY(d->windowTitle().contains(QStringLiteral("plane.pov")));
        QVERIFY(d.rests());
    }

    void theIsosurfaceIsWrittenAsAnIncludeFile() {
        WindowDriver& d = *driver_;
        WindowDriver::triggerAndChoose(d->actions()->exportInclude, folder_.path(QStringLiteral("blob")));
        const QString text = QString::fromUtf8(folder_.contents(QStringLiteral("blob.inc")));
        QVERIFY2(text.contains(QStringLiteral("#declare Melt = 0.015;")), qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("isosurface {")));
        QVERIFY(!text.contains(QStringLiteral("camera")));
        // It stands on its own.
        const ParseResult read = parseScene("#include \"blob.inc\"", [this] {
            ParseOptions options;
            options.file = folder_.path(QStringLiteral("scene.pov")).toStdString();
            return options;
        }());
        QVERIFY(read.ok());
        QCOMPARE(read.scene->isosurfaces.size(), std::size_t{1});
        QVERIFY(!d->notices()->isVisible());
    }

    void theExportHasTheTextOfThisMoment() {
        WindowDriver& d = *driver_;
        QGuiApplication::clipboard()->clear();
        d.typeBehind(QStringLiteral("#declare Melt = 0.01"), QStringLiteral("9"));
        QVERIFY(d->session()->busy());  // the pause in typing is not over
        d->actions()->copyIsosurface->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("#declare Melt = 0.0195;")));
    }

    void theIsosurfaceAtTheCaretIsTaken() {
        WindowDriver& d = *driver_;
        folder_.write(
            QStringLiteral("two.pov"),
            "isosurface { function { x } }\n#for (I, 1, 2)\nisosurface { function { y - I } translate I*x "
            "}\n#end\n");
        QVERIFY(d->openFile(folder_.path(QStringLiteral("two.pov"))));
        QVERIFY(d.rests());
        d->actions()->copyIsosurface->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("isosurface { function { x } }\n"));
        d.typeBehind(QStringLiteral("function { y - I"), {});
        d->actions()->copyIsosurface->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(),
                 QStringLiteral("#local I = 2;\nisosurface { function { y - I } translate I*x }\n"));
    }

    void whatCannotBeExportedIsSaid() {
        WindowDriver& d = *driver_;
        folder_.write(QStringLiteral("none.pov"), "sphere { 0, 1 pigment { rgb 1 } }\n");
        QVERIFY(d->openFile(folder_.path(QStringLiteral("none.pov"))));
        QVERIFY(d.rests());
        for (QAction* action : {d->actions()->copyIsosurface, d->actions()->exportInclude}) {
            action->trigger();
            QVERIFY(d->notices()->isVisible());
            QVERIFY(d->notices()->text().contains(QStringLiteral("no isosurface")));
            d->notices()->findChild<QPushButton*>()->click();
        }
    }

    void theSceneIsWrittenForPovrayWithThePresentView() {
        WindowDriver& d = *driver_;
        d.dragViewport(d->viewport()->rect().center(), {80, 20});
        QVERIFY(d.rests());
        WindowDriver::triggerAndChoose(d->actions()->exportScene, folder_.path(QStringLiteral("whole")));
        const QByteArray text = folder_.contents(QStringLiteral("whole.pov"));
        QVERIFY(text.contains("#version 3.7;"));
        QVERIFY(text.contains("isosurface {"));
        if (!hasPovray()) QSKIP(povrayIsMissing);
        PovrayRun run;
        run.width = d->viewport()->width();
        run.height = d->viewport()->height();
        const Image theirs = povrayPictureOfFile(folder_.path(QStringLiteral("whole.pov")), run);
        QVERIFY(!theirs.pixels.empty());
        Image ours(run.width, run.height);
        const QImage shown = d.picture();
        QCOMPARE(shown.size(), QSize(run.width, run.height));
        for (int y = 0; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x) {
                const QRgb p = shown.pixel(x, y);
                ours.pixels[static_cast<std::size_t>(y * shown.width() + x)] = {
                    decodeChannel(qRed(p) / 255.0), decodeChannel(qGreen(p) / 255.0),
                    decodeChannel(qBlue(p) / 255.0)};
            }
        const PictureDifference difference = comparePictures(ours, theirs);
        qInfo("viewport beside POV-Ray: %.2f %% within 8/255", 100 * difference.shareWithin8);
        QVERIFY(difference.shareWithin8 >= 0.99);
    }

    void virtualightOpensAndIsWrittenForPovray() {
        WindowDriver& d = *driver_;
        folder_.write(QStringLiteral("ring.vl"), "Shape [ Torus((0,0,0), (0,1,0), 2, 0.5) ]\n");
        WindowDriver::triggerAndChoose(d->actions()->open, folder_.path(QStringLiteral("ring.vl")));
        QVERIFY(d.rests());
        QCOMPARE(d->viewport()->scene()->objects.size(), std::size_t(1));
        WindowDriver::triggerAndChoose(d->actions()->exportScene, folder_.path(QStringLiteral("ring")));
        const QByteArray text = folder_.contents(QStringLiteral("ring.pov"));
        QVERIFY2(text.contains("torus { 2, 0.5"), text.constData());
        QVERIFY(parseScene(text.toStdString()).ok());
    }

    void theIsosurfaceHasACommentOfWhatIsProven() {
        WindowDriver& d = *driver_;
        d->editor()->setSceneText(QStringLiteral(
            "#version 3.7;\nisosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } "
            "max_gradient 2.4 }\n"));
        QVERIFY(d.rests());
        QTRY_VERIFY(!d->studies()->verdicts()->study()->busy());
        const QString plain = QString::fromStdString(d->exports()->isosurface().text);
        QVERIFY(!plain.contains(QStringLiteral("Proven by")));
        WindowDriver::trigger(d->actions()->exportNote);
        const std::string noted = d->exports()->isosurface().text;
        const ParseResult read = parseScene(noted);
        QCOMPARE(read.scene->isosurfaces.size(), std::size_t(1));
        const auto note = noteBefore(noted, read.scene->isosurfaces[0].range);
        QVERIFY(note);
        QVERIFY(std::abs(note->bound - 2.4) < 0.03);
        QCOMPARE(note->accuracy, 0.001);
        // But for the comment it is the same text; and the choice is kept.
        QCOMPARE(QString::fromStdString(noted.substr(0, note->range.begin)) +
                     QString::fromStdString(noted.substr(note->range.end)).trimmed(),
                 plain.left(static_cast<int>(note->range.begin)) +
                     plain.mid(static_cast<int>(note->range.begin)).trimmed());
        d.restart();
        QVERIFY(d->actions()->exportNote->isChecked());
    }

    void theImageIsWrittenAtTheSizeChosen() {
        WindowDriver& d = *driver_;
        d->actions()->exportImage->trigger();
        auto* dialog = d->findChild<ImageExportDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        const auto boxes = dialog->findChildren<QSpinBox*>();
        QCOMPARE(boxes.size(), 2);
        // Neither the proportions of the window nor smooth edges.
        for (QCheckBox* box : dialog->findChildren<QCheckBox*>()) box->setChecked(false);
        boxes[0]->setValue(300);
        boxes[1]->setValue(100);
        auto* file = dialog->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY(file);
        QVERIFY2(QFileInfo(file->text()).isAbsolute(), qPrintable(file->text()));
        file->setText(folder_.path(QStringLiteral("wide")));
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        for (QPushButton* button : dialog->findChildren<QPushButton*>())
            if (button->isDefault()) QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(finished.wait(20000));
        QCOMPARE(finished[0][1].toString(), QString());
        const QImage written(folder_.path(QStringLiteral("wide.png")));
        QCOMPARE(written.size(), QSize(300, 100));
        QVERIFY(distinctColors(written) > 50);

        // A file that is there already is not replaced without a word.
        dialog->start();
        QVERIFY(!dialog->running());
        bool asks = false;
        for (const QLabel* label : dialog->findChildren<QLabel*>())
            asks |= label->text().contains(QStringLiteral("exists"));
        QVERIFY(asks);
        dialog->close();
    }
};

QTEST_MAIN(FilesAndExportsTest)
#include "files_and_exports_test.moc"
