// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/notice_bar.h"
#include "widgets/timeline/animation_export_dialog.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray scene =
    "#version 3.7;\n#declare R = 0.5;\ncamera { location <0, 0, -4> look_at 0 }\nlight_source { <5, 5, -5> 1 "
    "}\n"
    "isosurface { function { f_sphere(x, y, z, R) } contained_by { box { -1.1, 1.1 } } pigment { rgb 1 } }\n"
    "// timeline: frames 8 to 11, clock 0 to 1, 12 per second\n// keys \"R\": 8 = 0.2 linear, 11 = 1\n";

/// Says what it was given, in the place of a film.
const QByteArray ffmpeg = "#!/bin/sh\nfor last; do :; done\necho frame=2\necho \"$@\" > \"$last\"\n";

}  // namespace

/// Frames, films and POV-Ray's animations out of the real window.
class AnimationExportTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    QTemporaryDir folder_;

    QString in(const QString& name) const { return folder_.filePath(name); }
    AnimationExportDialog* dialog() const {
        WindowDriver::trigger(driver_->window().actions()->exportFrames);
        auto* found = driver_->window().findChild<AnimationExportDialog*>();
        for (auto* box : found->findChildren<QSpinBox*>())
            box->setValue(box->toolTip().contains("Width") ? 64 : 48);
        return found;
    }
    static QPushButton* button(QWidget* dialog, const QString& text) {
        for (auto* one : dialog->findChildren<QPushButton*>())
            if (one->text() == text) return one;
        return nullptr;
    }
    static QString message(const QWidget* dialog) {
        for (auto* label : dialog->findChildren<QLabel*>())
            if (label->accessibleDescription() == "Result") return label->text();
        return {};
    }
    static double share(const QString& file) {
        const QImage picture(file);
        int seen = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) seen += qRed(picture.pixel(x, y)) > 8;
        return double(seen) / (picture.width() * picture.height());
    }

  private slots:
    void initTestCase() {
        QFile program(in("ffmpeg"));
        QVERIFY(program.open(QFile::WriteOnly));
        program.write(ffmpeg);
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
        qputenv("PATH", (folder_.path() + ':' + qEnvironmentVariable("PATH")).toUtf8());
    }
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void framesAndFilmAreWritten() {
        AnimationExportDialog* dialog = this->dialog();
        dialog->findChild<QLineEdit*>()->setText(in("new/ball"));
        for (auto* box : dialog->findChildren<QCheckBox*>())
            if (box->text().contains("film")) box->setChecked(true);
        QSignalSpy finished(dialog, &AnimationExportDialog::finished);
        button(dialog, "Draw")->click();
        QVERIFY(dialog->running());
        QVERIFY(finished.wait(30000));
        QCOMPARE(finished[0][0].toString(), QString());
        QCOMPARE(QDir(in("new")).entryList(QDir::Files, QDir::Name),
                 (QStringList{"ball.mp4", "ball08.png", "ball09.png", "ball10.png", "ball11.png"}));
        QCOMPARE(QImage(in("new/ball08.png")).size(), QSize(64, 48));
        // The ball grows from 0.2 to 1.
        QVERIFY(share(in("new/ball08.png")) > 0);
        QVERIFY(share(in("new/ball11.png")) > 10 * share(in("new/ball08.png")));
        QFile film(in("new/ball.mp4"));
        QVERIFY(film.open(QFile::ReadOnly));
        const QByteArray arguments = film.readAll();
        QVERIFY2(arguments.contains("-framerate 12 -start_number 8") && arguments.contains("ball%02d.png") &&
                     arguments.contains("-frames:v 4"),
                 arguments.constData());
        // What stands there now is asked about.
        QVERIFY(!button(dialog, "Replace"));
        button(dialog, "Draw")->click();
        QVERIFY(!dialog->running());
        QVERIFY2(message(dialog).contains("Replace them?"), qPrintable(message(dialog)));
        button(dialog, "Replace")->click();
        QVERIFY(finished.wait(30000));
        QCOMPARE(finished[1][0].toString(), QString());
        dialog->close();
    }

    void filesOfOthersStay() {
        QVERIFY(QDir(folder_.path()).mkpath("others"));
        QFile other(in("others/a09.png"));
        QVERIFY(other.open(QFile::WriteOnly));
        other.write("my notes");
        other.close();
        AnimationExportDialog* dialog = this->dialog();
        dialog->findChild<QLineEdit*>()->setText(in("others/a"));
        button(dialog, "Draw")->click();
        QVERIFY(!dialog->running());
        QVERIFY2(message(dialog).contains("a09.png is no PNG picture"), qPrintable(message(dialog)));
        dialog->close();
    }

    void aStopLeavesWholeFrames() {
        AnimationExportDialog* dialog = this->dialog();
        dialog->findChild<QLineEdit*>()->setText(in("stopped/b"));
        for (auto* box : dialog->findChildren<QSpinBox*>()) box->setValue(1500);
        QSignalSpy finished(dialog, &AnimationExportDialog::finished);
        button(dialog, "Draw")->click();
        QVERIFY(button(dialog, "Stop")->isEnabled());
        button(dialog, "Stop")->click();
        QVERIFY(finished.wait(10000));
        QCOMPARE(finished[0][0].toString(), QString("stopped"));
        QVERIFY(!QFile::exists(in("stopped/b11.png")));
        for (const QString& name : QDir(in("stopped")).entryList(QDir::Files))
            QCOMPARE(QImage(in("stopped/" + name)).size(), QSize(1500, 1500));
        dialog->close();
    }

    void anAnimationForPovrayHasItsSettings() {
        WindowDriver::triggerAndChoose(driver_->window().actions()->exportAnimation, in("out.pov"));
        QTRY_VERIFY(QFile::exists(in("out.ini")));
        QFile exported(in("out.pov")), settings(in("out.ini"));
        QVERIFY(exported.open(QFile::ReadOnly) && settings.open(QFile::ReadOnly));
        QVERIFY(exported.readAll().contains("#declare R = Key_R;"));
        const QByteArray lines = settings.readAll();
        QVERIFY2(lines.contains("Input_File_Name=\"out.pov\"\nInitial_Frame=8\nFinal_Frame=11\n"),
                 lines.constData());
    }

    void aTextWithoutTimelineSaysSo() {
        QVERIFY(driver_->openText("sphere { 0, 1 pigment { rgb 1 } }", "plain.pov"));
        QVERIFY(driver_->rests());
        WindowDriver::trigger(driver_->window().actions()->exportAnimation);
        QVERIFY(driver_->window().notices()->isVisible());
    }
};

QTEST_MAIN(AnimationExportTest)
#include "animation_export_test.moc"
