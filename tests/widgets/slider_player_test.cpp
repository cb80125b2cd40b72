// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/slider_player.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "tests/widgets/gui_events.h"
#include "widgets/numbers/number_box.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

SceneParameter number(const char* name) {
    SceneParameter parameter;
    parameter.role = ParameterRole::argument;
    parameter.group = "f_torus";
    parameter.name = name;
    parameter.value = 0.5;
    parameter.minimum = 0;
    parameter.maximum = 2;
    return parameter;
}

}  // namespace

class SliderPlayerTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ParameterPanel> panel_;
    std::unique_ptr<QSignalSpy> played_, finished_, changed_;

    SliderPlayer* player() const { return panel_->player(); }
    ParameterSlider* row(int index = 0) const { return panel_->slider(index); }
    QToolButton* button(const QString& name, int index = 0) const {
        for (auto* button : row(index)->findChildren<QToolButton*>())
            if (button->accessibleName() == name) return button;
        return nullptr;
    }
    /// Answers each value by a picture until there are so many.
    bool plays(int count) const {
        const auto answer = connect(player(), &SliderPlayer::played, player(), &SliderPlayer::pictureFinished,
                                    Qt::QueuedConnection);
        const bool came = QTest::qWaitFor([&] { return played_->count() >= count; }, 3000);
        disconnect(answer);
        return came;
    }

  private slots:
    void init() {
        panel_ = std::make_unique<ParameterPanel>();
        panel_->resize(320, 400);
        panel_->setParameters({number("A"), number("B")});
        QVERIFY(showActive(panel_.get()));
        played_ = std::make_unique<QSignalSpy>(player(), &SliderPlayer::played);
        finished_ = std::make_unique<QSignalSpy>(player(), &SliderPlayer::finished);
        changed_ = std::make_unique<QSignalSpy>(panel_.get(), &ParameterPanel::valueChanged);
    }
    void cleanup() {
        played_.reset();
        finished_.reset();
        changed_.reset();
        panel_.reset();
    }

    void aValueWaitsForThePictureOfTheLast() {
        QTest::mouseClick(button("Play f_torus A"), Qt::LeftButton);
        QVERIFY(player()->isPlaying());
        QTRY_COMPARE(played_->count(), 1);
        QTest::qWait(150);
        QCOMPARE(played_->count(), 1);
        player()->pictureFinished();
        player()->pictureFinished();  // of no value
        QTRY_COMPARE(played_->count(), 2);
        // It goes by the clock: the wait is in the way.
        const double way = (*played_)[1][1].toDouble() - 0.5;
        QVERIFY2(way > 0.5 * 0.15 && way < 0.5, qPrintable(QString::number(way)));
        QVERIFY(changed_->isEmpty() && finished_->isEmpty());
    }

    void noMoreThanSixtyASecond() {
        player()->start(0);
        QElapsedTimer time;
        time.start();
        QVERIFY(plays(20));
        QVERIFY2(time.elapsed() >= 19 * 15, qPrintable(QString::number(time.elapsed())));
        QCOMPARE(row()->value(), played_->last()[1].toDouble());
    }

    void theButtonStopsWithTheLastValue() {
        player()->start(0);
        QVERIFY(plays(5));
        QTest::mouseClick(button("Stop f_torus A"), Qt::LeftButton);
        QVERIFY(!player()->isPlaying());
        QCOMPARE(finished_->count(), 1);
        QCOMPARE(finished_->first()[0].toInt(), 0);
        QCOMPARE(finished_->first()[1].toDouble(), played_->last()[1].toDouble());
        QVERIFY(button("Play f_torus A"));
        const auto count = played_->count();
        player()->pictureFinished();
        QTest::qWait(100);
        QCOMPARE(played_->count(), count);
    }

    void aTouchStopsBeforeItChangesAnything_data() {
        QTest::addColumn<int>("touch");
        QTest::newRow("press on the slider") << 0;
        QTest::newRow("key on the slider") << 1;
        QTest::newRow("click in the box") << 2;
        QTest::newRow("Escape") << 3;
        QTest::newRow("double click on the name") << 4;
        QTest::newRow("another slider plays") << 5;
    }
    void aTouchStopsBeforeItChangesAnything() {
        QFETCH(int, touch);
        player()->start(0);
        QVERIFY(plays(5));
        // What the text hears first is the end of the play.
        int before = -1;
        connect(player(), &SliderPlayer::finished, this,
                [&] { before = static_cast<int>(changed_->count()); });
        auto* slider = row()->findChild<QSlider*>();
        switch (touch) {
            case 0: QTest::mousePress(slider, Qt::LeftButton, {}, handleCenter(slider)); break;
            case 1: QTest::keyClick(slider, Qt::Key_Right); break;
            case 2:
                QTest::mouseClick(row()->findChild<NumberBox*>()->findChild<QLineEdit*>(), Qt::LeftButton);
                break;
            case 3: QTest::keyClick(panel_.get(), Qt::Key_Escape); break;
            case 4: row()->resetToInitial(); break;
            default: player()->start(1); break;
        }
        QCOMPARE(before, 0);
        QCOMPARE(finished_->count(), 1);
        QCOMPARE(player()->isPlaying(), touch == 5);
        QVERIFY(!row()->isPlaying());
        if (touch == 0) QTest::mouseRelease(slider, Qt::LeftButton, {}, handleCenter(slider));
        if (touch == 1) QCOMPARE(changed_->count(), 1);
        player()->abandon();
    }

    void onceEndsAtTheUpperEnd() {
        row()->setPlay({PlayMode::once, 0.1});
        player()->start(0);
        const auto answer = connect(player(), &SliderPlayer::played, player(), &SliderPlayer::pictureFinished,
                                    Qt::QueuedConnection);
        QTRY_COMPARE(finished_->count(), 1);
        disconnect(answer);
        QCOMPARE(finished_->first()[1].toDouble(), 2.0);
        QCOMPARE(row()->value(), 2.0);
    }

    void valuesKeepToTheNote() {
        row()->setParameter(number("A"), SliderNote{0, 2, 0.5, false, 1, false});
        row()->setPlay({PlayMode::loop, 0.2});
        player()->start(0);
        QVERIFY(plays(6));
        for (const auto& one : *played_) QCOMPARE(std::fmod(one[1].toDouble(), 0.5), 0.0);
        player()->stop();
    }

    void aLockedRowDoesNotPlay() {
        row()->setParameter(number("A"), SliderNote{0, 2, 0, false, -1, true});
        QVERIFY(!button("Play f_torus A")->isVisible());
        player()->start(0);
        QVERIFY(!player()->isPlaying());
    }

    /// A new text has nothing to do with the value.
    void aRowThatGoesIsForgotten() {
        player()->start(0);
        QVERIFY(plays(3));
        QSignalSpy playing(player(), &SliderPlayer::playingChanged);
        panel_->setParameters({number("B")});
        QVERIFY(!player()->isPlaying());
        QCOMPARE(playing.count(), 1);
        QVERIFY(finished_->isEmpty());
    }

    void aParseDoesNotDisturbIt() {
        player()->start(0);
        QVERIFY(plays(3));
        const double value = row()->value();
        panel_->setParameters({number("A"), number("B")});
        QCOMPARE(row()->value(), value);
        QVERIFY(player()->isPlaying());
        player()->abandon();
    }
};

QTEST_MAIN(SliderPlayerTest)
#include "slider_player_test.moc"
