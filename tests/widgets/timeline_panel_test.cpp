// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline_panel.h"

#include <QAbstractSpinBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "widgets/theme.h"
#include "widgets/timeline/timeline_view.h"

using namespace isoscope;

namespace {

Timeline many(int count) {
    Timeline timeline;
    timeline.stated = true;
    for (int i = 0; i < count; ++i)
        for (const int frame : {0, 50 + i, 119}) timeline.putKey("n" + std::to_string(i), {frame, 1.0 * i});
    return timeline;
}

}  // namespace

/// The panel alone: what has room, and what asks for what.
class TimelinePanelTest : public QObject {
    Q_OBJECT

    QWidget host_;  ///< as in the window, where another widget decides how large it is
    std::unique_ptr<TimelinePanel> panel_;

    QWidget* box(const QString& name) const {
        for (auto* one : panel_->findChildren<QAbstractSpinBox*>())
            if (one->accessibleName() == name) return one;
        return nullptr;
    }

  private slots:
    void initTestCase() { applyTheme(Theme::light); }
    void init() {
        panel_ = std::make_unique<TimelinePanel>(&host_);
        panel_->setTimeline(many(12), {});
        panel_->resize(900, 150);
        panel_->show();
        host_.resize(900, 150);
        host_.show();
        QVERIFY(QTest::qWaitForWindowActive(&host_));
    }
    void cleanup() { panel_.reset(); }

    void aNarrowPanelLeavesOutTheClock() {
        QVERIFY(box("Clock of the last frame")->isVisible());
        panel_->resize(panel_->minimumSizeHint().width(), 150);
        QTRY_VERIFY(!box("Clock of the last frame")->isVisible());
        for (auto* button : panel_->findChildren<QToolButton*>())
            if (button->isVisible())
                QVERIFY2(
                    panel_->rect().contains(QRect(button->mapTo(panel_.get(), QPoint()), button->size())),
                    qPrintable(button->accessibleName()));
        panel_->resize(900, 150);
        QTRY_VERIFY(box("Clock of the last frame")->isVisible());
    }

    void rowsWithoutRoomAreScrolledToByKeys() {
        TimelineView* view = panel_->view();
        QCOMPARE(view->rows().size(), 12u);
        view->setFocus();
        for (int i = 0; i < 11; ++i) QTest::keyClick(view, Qt::Key_Down);
        QCOMPARE(view->row()->title, QString("n11"));
        QVERIFY(view->rect().contains(view->placeOf(61, 11)));
        QVERIFY(!view->rect().contains(view->placeOf(50, 0)));
        QSignalSpy picked(panel_.get(), &TimelinePanel::framePicked);
        QTest::mouseClick(view, Qt::LeftButton, {}, view->placeOf(61, 11));
        QCOMPARE(picked.count(), 1);
        QCOMPARE(panel_->frame(), 61);
    }

    /// A screen reader hears the place and what is there.
    void thePlaceIsToldInWords() {
        panel_->setFrame(50);
        QCOMPARE(panel_->view()->accessibleDescription(),
                 QString("Frame 50 of 0 to 119; n0 = 0 at frame 50, then smooth"));
        panel_->setFrame(51);
        QCOMPARE(panel_->view()->accessibleDescription(),
                 QString("Frame 51 of 0 to 119; n0 has no key here"));
    }

    void keysThatAreHeldAreOneVisit() {
        TimelineView* view = panel_->view();
        QSignalSpy picked(panel_.get(), &TimelinePanel::framePicked);
        QSignalSpy settled(panel_.get(), &TimelinePanel::frameSettled);
        view->setFocus();
        for (int i = 0; i < 5; ++i) QTest::keyClick(view, Qt::Key_Right);
        QTest::keyClick(view, Qt::Key_PageDown);
        QCOMPARE(picked.count(), 6);
        QCOMPARE(panel_->frame(), 15);
        QCOMPARE(settled.count(), 0);
        QTRY_COMPARE(settled.count(), 1);
    }

    void aKeyIsMovedByTheMouse() {
        TimelineView* view = panel_->view();
        QSignalSpy changed(panel_.get(), &TimelinePanel::timelineChanged);
        QTest::mousePress(view, Qt::LeftButton, {}, view->placeOf(50, 0));
        const QPoint to = view->placeOf(80, 0);
        QMouseEvent move(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(view, &move);
        QCOMPARE(changed.count(), 0);
        QTest::mouseRelease(view, Qt::LeftButton, {}, to);
        QCOMPARE(changed.count(), 1);
        const auto wanted = changed[0][0].value<Timeline>();
        QVERIFY(wanted.track("n0")->at(80) && !wanted.track("n0")->at(50));
        QCOMPARE(panel_->frame(), 80);
    }
};

QTEST_MAIN(TimelinePanelTest)
#include "timeline_panel_test.moc"
