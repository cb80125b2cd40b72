// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "tests/desktop/real_input.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// Keys as the X server delivers them, under a window manager; shortcuts_test has all of them, in every
/// focus.
class KeysTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    RealInput hand_;

  private slots:
    void init() {
        if (!RealInput::available()) QSKIP("needs a display: tests/desktop/with-window-manager PROGRAM");
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(QTest::qWaitForWindowActive(&driver_->window()));
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void shortcutsInTheEditorTouchNeitherTextNorClipboard_D2() {
        WindowDriver& d = *driver_;
        const QString precious = QStringLiteral("what was in the clipboard");
        QGuiApplication::clipboard()->setText(precious);
        const QString text = d->editor()->sceneText();
        d->editor()->setFocus();
        const int size = d->editor()->textHeight(0);
        hand_.key(QStringLiteral("ctrl+l"));
        QTRY_VERIFY(d->actions()->sectionPlane->isChecked());
        d->editor()->setFocus();
        hand_.key(QStringLiteral("ctrl+d"));
        QTRY_VERIFY(d->actions()->overlayHoles->isChecked());
        hand_.key(QStringLiteral("ctrl+u"));
        QTRY_VERIFY(d->actions()->verdicts->isChecked());
        hand_.key(QStringLiteral("ctrl+t"));
        hand_.key(QStringLiteral("ctrl+shift+l"));
        hand_.key(QStringLiteral("ctrl+plus"));
        hand_.key(QStringLiteral("ctrl+equal"));
        QTRY_VERIFY(d->editor()->textHeight(0) > size);
        hand_.key(QStringLiteral("ctrl+minus"));
        hand_.key(QStringLiteral("ctrl+0"));
        QTRY_COMPARE(d->editor()->textHeight(0), size);
        QCOMPARE(d->editor()->sceneText(), text);
        QCOMPARE(QGuiApplication::clipboard()->text(), precious);
    }

    void typingAndUndoWork() {
        WindowDriver& d = *driver_;
        const QString text = d->editor()->sceneText();
        d->editor()->setFocus();
        hand_.key(QStringLiteral("ctrl+End"));
        hand_.type(QStringLiteral("// Aa+1"));
        QTRY_COMPARE(d->editor()->sceneText(), text + QStringLiteral("// Aa+1"));
        hand_.key(QStringLiteral("ctrl+BackSpace"));
        hand_.key(QStringLiteral("ctrl+z"));
        hand_.key(QStringLiteral("ctrl+z"));
        QTRY_COMPARE(d->editor()->sceneText(), text);
        hand_.key(QStringLiteral("ctrl+shift+z"));
        QTRY_COMPARE(d->editor()->sceneText(), text + QStringLiteral("// Aa+1"));
    }
};

QTEST_MAIN(KeysTest)
#include "keys_test.moc"
