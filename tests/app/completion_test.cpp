// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

class CompletionTest : public QObject {
    Q_OBJECT

  private slots:
    void typingWithTheCaretOffTheScreenDoesNotCrash() {
        SceneEditor editor;
        editor.resize(400, 300);
        editor.show();
        QVERIFY(QTest::qWaitForWindowExposed(&editor));
        editor.move(-5000, -5000);
        editor.setFocus();
        QTest::keyClicks(editor.viewport(), QStringLiteral("isosu"));
        QCOMPARE(editor.sceneText(), QStringLiteral("isosu"));
        QVERIFY(!editor.isListActive());

        editor.move(20, 20);
        QTest::keyClicks(editor.viewport(), QStringLiteral("r"));
        QTRY_VERIFY(editor.isListActive());
    }

    void typingInAWordScrolledOffTheScreensEdgeDoesNotCrash() {
        SceneEditor editor;
        editor.resize(400, 300);
        editor.setSceneText(QString(200, QLatin1Char(' ')) + QStringLiteral("isosurfac"));
        editor.move(0, 0);
        editor.show();
        QVERIFY(QTest::qWaitForWindowExposed(&editor));
        editor.setFocus();
        const auto xOf = [&](long position) {
            return static_cast<int>(
                editor.SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, position));
        };
        for (const int beyond : {-30, 2, 30}) {
            editor.SendScintilla(QsciScintilla::SCI_GOTOPOS, 205);
            // The word begins left of the screen; its caret does too, or not.
            const long offset = editor.SendScintilla(QsciScintilla::SCI_GETXOFFSET);
            editor.SendScintilla(QsciScintilla::SCI_SETXOFFSET, offset + xOf(205) + beyond);
            QVERIFY(xOf(200) < 0);
            QTest::keyClicks(editor.viewport(), QStringLiteral("o"));
            editor.undo();
        }
        QVERIFY(editor.sceneText().endsWith(QStringLiteral("isosurfac")));
    }

    void declaredNamesOfTheTextAreOffered() {
        WindowDriver d;
        QVERIFY(d.rests());
        d->move(0, 0);
        d.typeBehind(QStringLiteral("Ring(x, y, z) - "), QStringLiteral("Me"));
        QTRY_VERIFY(d->editor()->isListActive());
        QTest::keyClick(d->editor()->viewport(), Qt::Key_Tab);
        QVERIFY2(d->editor()->sceneText().contains(QStringLiteral("- MeltMelt")),
                 qPrintable(d->editor()->sceneText()));
    }
};

QTEST_MAIN(CompletionTest)
#include "completion_test.moc"
