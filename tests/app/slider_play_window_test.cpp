// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/slider_player.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray scene =
    "#declare R = 0.5; // [0.2:1]\n"
    "#declare Count = 2; // [1:6:1]\n"
    "camera { location <0, 0, -4> look_at 0 }\n"
    "light_source { <5, 5, -5> 1 }\n"
    "isosurface { function { f_sphere(x, y, z, R) } contained_by { box { -1.1, 1.1 } } pigment { rgb 1 } }\n"
    "#for (I, 1, Count) sphere { <I/3, 1.2, 0>, 0.15 pigment { rgb 1 } } #end\n";

}  // namespace

/// A slider that plays in the real window.
class SliderPlayWindowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    SliderPlayer* player() const { return window().parameters()->player(); }
    QString text() const { return window().editor()->sceneText(); }
    void undo() const { window().actions()->undo->trigger(); }
    /// Begins by a click on the button.
    bool play(const char* name) const {
        ParameterSlider* row = window().parameters()->slider(driver_->parameter(name));
        for (auto* button : row->findChildren<QToolButton*>())
            if (button->accessibleName() == QString("Play #declare %1").arg(name))
                QTest::mouseClick(button, Qt::LeftButton);
        return player()->isPlaying();
    }
    bool shows(QSignalSpy& played, int more) const {
        const auto wanted = played.count() + more;
        return QTest::qWaitFor([&] { return played.count() >= wanted; }, 10000);
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void aPlayIsOneStepForUndo_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("with a slot") << QByteArray("R");
        QTest::newRow("by new parses") << QByteArray("Count");
    }
    void aPlayIsOneStepForUndo() {
        QFETCH(QByteArray, name);
        const QString before = text();
        const quint64 revision = window().editor()->revision();
        const quint64 serial = window().editor()->history()->serial();
        const QImage first = driver_->picture();
        QSignalSpy played(player(), &SliderPlayer::played);
        QVERIFY(play(name));
        QVERIFY(shows(played, 3));
        // The picture is that of the slider, while neither text nor history know.
        QTRY_VERIFY(difference(first, driver_->picture()) > 0.001);
        QCOMPARE(window().editor()->revision(), revision);
        QCOMPARE(window().editor()->history()->serial(), serial);
        QVERIFY(!window().isWindowModified());
        QTest::keyClick(window().editor(), Qt::Key_Escape);
        QVERIFY(!player()->isPlaying());
        const QString key = QString("#declare %1 = ").arg(QString(name));
        QCOMPARE(driver_->numberBehind(key), played.last()[1].toDouble());
        const QString after = text();
        QVERIFY(driver_->rests());
        QCOMPARE(window().parameters()->slider(driver_->parameter(name))->value(),
                 driver_->numberBehind(key));
        undo();
        QCOMPARE(text(), before);
        QVERIFY(!window().actions()->undo->isEnabled());
        QVERIFY(driver_->rests());
        QVERIFY(difference(first, driver_->picture()) < 0.001);
        window().actions()->redo->trigger();
        QCOMPARE(text(), after);
    }

    void undoWhileItPlaysTakesThePlayBack() {
        const QString before = text();
        QSignalSpy played(player(), &SliderPlayer::played);
        QVERIFY(play("R"));
        QVERIFY(shows(played, 3));
        undo();
        QVERIFY(!player()->isPlaying());
        QCOMPARE(text(), before);
        QVERIFY(driver_->rests());
        QCOMPARE(window().parameters()->slider(driver_->parameter("R"))->value(), 0.5);
    }

    void typingStopsIt() {
        QSignalSpy played(player(), &SliderPlayer::played);
        QVERIFY(play("R"));
        QVERIFY(shows(played, 3));
        driver_->typeBehind("Count = 2", "5");
        QTRY_VERIFY(!player()->isPlaying());
        QCOMPARE(driver_->numberBehind("R = "), played.last()[1].toDouble());
        QCOMPARE(driver_->numberBehind("Count = "), 25.0);
        undo();
        QCOMPARE(driver_->numberBehind("R = "), 0.5);
        QCOMPARE(driver_->numberBehind("Count = "), 25.0);
        undo();
        QCOMPARE(text().toUtf8(), scene);
    }

    void savingKeepsWhatIsSeen() {
        QSignalSpy played(player(), &SliderPlayer::played);
        QVERIFY(play("R"));
        QVERIFY(shows(played, 3));
        window().actions()->save->trigger();
        QVERIFY(!player()->isPlaying());
        QVERIFY(!window().isWindowModified());
        QFile file(window().windowFilePath());
        QVERIFY(file.open(QFile::ReadOnly));
        QCOMPARE(QString::fromUtf8(file.readAll()), text());
        QCOMPARE(driver_->numberBehind("R = "), played.last()[1].toDouble());
    }

    void anotherDocumentEndsIt() {
        QSignalSpy played(player(), &SliderPlayer::played), finished(player(), &SliderPlayer::finished);
        QVERIFY(play("R"));
        QVERIFY(shows(played, 2));
        QVERIFY(driver_->openText("sphere { 0, 1 pigment { rgb 1 } }", "other.pov"));
        QVERIFY(driver_->rests());
        QVERIFY(!player()->isPlaying());
        QCOMPARE(text(), QString("sphere { 0, 1 pigment { rgb 1 } }"));
    }

    /// Each value that is shown was drawn: there is a picture between any two.
    void noValueOvertakesItsPicture() {
        QStringList order;
        connect(player(), &SliderPlayer::played, this, [&] { order << "value"; });
        const auto picture =
            connect(window().viewport(), &Viewport::progressed, this, [&](const RenderProgress& progress) {
                if (progress.finished) order << "picture";
            });
        QVERIFY(play("R"));
        QTRY_VERIFY_WITH_TIMEOUT(order.count("value") >= 20, 20000);
        disconnect(picture);
        for (int i = 1; i < order.size(); ++i)
            QVERIFY2(order[i] != "value" || order[i - 1] == "picture", qPrintable(order.join(' ')));
        player()->stop();
        QVERIFY(driver_->rests());
    }

    /// A value that the scene cannot have gives no picture to wait for.
    void aValueWithAnErrorDoesNotHoldItUp() {
        QVERIFY(
            driver_->openText("#declare S = 0.2; // [-1:1:0.5]\n"
                              "#for (I, 0, S) sphere { 0, 1/(S > 0) pigment { rgb 1 } } #end\n"
                              "#if (S < 0) nonsense { #end\n",
                              "errors.pov"));
        QVERIFY(driver_->rests());
        window().parameters()->slider(0)->setPlay({PlayMode::loop, 0.5});
        QSignalSpy played(player(), &SliderPlayer::played);
        QVERIFY(play("S"));
        QVERIFY(QTest::qWaitFor([&] { return played.count() >= 12; }, 4500));
        player()->stop();
    }
};

QTEST_MAIN(SliderPlayWindowTest)
#include "slider_play_window_test.moc"
