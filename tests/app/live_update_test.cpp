// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/document/text_feed.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray scene =
    "camera { location <0, 0, -4> look_at 0 }\nlight_source { <5, 5, -5> 1 }\n"
    "sphere { 0, 0.5 pigment { rgb 1 } }\n";

}  // namespace

/// Typing that waits for being saved, and another editor that writes the file.
class LiveUpdateTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    bool writeFile(const QByteArray& text) const {
        QFile file(window().windowFilePath());
        return file.open(QFile::WriteOnly | QFile::Truncate) && file.write(text) == text.size();
    }
    QString text() const { return window().editor()->sceneText(); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void typingCanWaitForTheSaving_data() {
        QTest::addColumn<bool>("saves");
        QTest::newRow("saved") << true;
        QTest::newRow("drawn again") << false;
    }
    void typingCanWaitForTheSaving() {
        QFETCH(bool, saves);
        const QImage before = driver_->picture();
        window().actions()->liveUpdate->trigger();
        QVERIFY(!window().actions()->liveUpdate->isChecked());
        QSignalSpy parsed(window().session(), &SceneSession::parsed);
        driver_->typeBehind("sphere { 0, ", "1 + ");
        QTest::qWait(400);  // twice the pause that typing is given
        QCOMPARE(parsed.count(), 0);
        QVERIFY(window().feed()->isBehind());
        QVERIFY(window().viewport()->notice().contains("newer than the picture"));
        QVERIFY(driver_->rests());
        QVERIFY(difference(before, driver_->picture()) < 0.001);
        (saves ? window().actions()->save : window().actions()->redraw)->trigger();
        QVERIFY(driver_->rests());
        QCOMPARE(parsed.count(), 1);
        QVERIFY(!window().feed()->isBehind());
        QVERIFY(window().viewport()->notice().isEmpty());
        QVERIFY(difference(before, driver_->picture()) > 0.05);
    }

    void switchedOnAgainItShowsWhatWasTyped() {
        window().actions()->liveUpdate->trigger();
        driver_->typeBehind("sphere { 0, ", "1 + ");
        QSignalSpy parsed(window().session(), &SceneSession::parsed);
        window().actions()->liveUpdate->trigger();
        QVERIFY(driver_->rests());
        QCOMPARE(parsed.count(), 1);
        driver_->typeBehind("sphere { 0, ", "1 + ");
        QTRY_COMPARE(parsed.count(), 2);
    }

    void theChoiceIsRemembered() {
        window().actions()->liveUpdate->trigger();
        window().actions()->followFile->trigger();
        driver_->restart();
        QVERIFY(!window().actions()->liveUpdate->isChecked());
        QVERIFY(window().actions()->followFile->isChecked());
    }

    void anotherEditorIsFollowedTimeAfterTime() {
        window().actions()->followFile->trigger();
        for (const char* radius : {"0.7", "0.9", "1.1"}) {
            QByteArray changed = scene;
            changed.replace("0.5", radius);
            QVERIFY(writeFile(changed));
            QTRY_COMPARE_WITH_TIMEOUT(text().toUtf8(), changed, 10000);
            QVERIFY(!window().isWindowModified());
            QVERIFY(driver_->rests());
        }
        QVERIFY(!window().notices()->isVisible());
        // Undo still has what stood here before.
        window().actions()->undo->trigger();
        QVERIFY(text().contains("0.9"));
    }

    void ownChangesAreNotWrittenOver() {
        window().actions()->followFile->trigger();
        driver_->typeBehind("sphere { 0, ", "1 + ");
        const QString mine = text();
        QVERIFY(writeFile(scene + "// theirs\n"));
        QTRY_VERIFY_WITH_TIMEOUT(window().notices()->isVisible(), 10000);
        QCOMPARE(text(), mine);
    }
};

QTEST_MAIN(LiveUpdateTest)
#include "live_update_test.moc"
