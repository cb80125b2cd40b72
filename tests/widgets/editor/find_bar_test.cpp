// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/find_bar.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "tests/widgets/gui_events.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

class FindBarTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QWidget> window_;
    SceneEditor* editor_ = nullptr;
    FindBar* bar_ = nullptr;

    template <class Widget>
    Widget* control(const QString& name) const {
        for (Widget* widget : bar_->findChildren<Widget*>())
            if (widget->accessibleName() == name) return widget;
        return nullptr;
    }
    QLineEdit* pattern() const { return control<QLineEdit>("Find"); }
    QLineEdit* replacement() const { return control<QLineEdit>("Replace with"); }
    /// What a screen reader reads of it is its text.
    QString count() const {
        for (const QLabel* label : bar_->findChildren<QLabel*>())
            if (label->accessibleDescription() == "Number of matches") return label->text();
        return QStringLiteral("no label");
    }
    long selection() const { return editor_->SendScintilla(QsciScintillaBase::SCI_GETSELECTIONSTART); }

  private slots:
    void init() {
        window_ = std::make_unique<QWidget>();
        editor_ = new SceneEditor;
        bar_ = new FindBar(editor_);
        auto* layout = new QVBoxLayout(window_.get());
        layout->addWidget(editor_);
        layout->addWidget(bar_);
        window_->resize(700, 400);
        QVERIFY(showActive(window_.get()));
        editor_->setSceneText(QString::fromUtf8("// \xf0\x9f\x98\x80\nbox Box\nboxed box\n"));
        editor_->setFocus();
    }
    void cleanup() { window_.reset(); }

    void opensAndClosesByKeys() {
        QVERIFY(!bar_->isVisible());
        QTest::keyClick(editor_, Qt::Key_F, Qt::ControlModifier);
        QVERIFY(bar_->isVisible());
        QVERIFY(pattern()->hasFocus());
        QVERIFY(!replacement()->isVisible());
        QTest::keyClick(pattern(), Qt::Key_Escape);
        QVERIFY(!bar_->isVisible());
        QVERIFY(editor_->hasFocus());
        QTest::keyClick(editor_, Qt::Key_H, Qt::ControlModifier);
        QVERIFY(replacement()->isVisible());
        QTest::keyClick(editor_, Qt::Key_Escape);
        QVERIFY(!bar_->isVisible());
    }

    void countsWhileTyping() {
        bar_->showFind();
        QTest::keyClicks(pattern(), "box");
        QCOMPARE(count(), QString("1 of 4"));
        QVERIFY(pattern()->hasFocus());
        QCOMPARE(editor_->selectedText(), QString("box"));
        control<QToolButton>("Match case")->click();
        QCOMPARE(count(), QString("1 of 3"));
        control<QToolButton>("Whole words")->click();
        QCOMPARE(count(), QString("1 of 2"));
        pattern()->setText("nowhere");
        QCOMPARE(count(), QString("None"));
        QVERIFY(!control<QToolButton>("Next match")->isEnabled());
        control<QToolButton>("Regular expression")->click();
        pattern()->setText("(");
        QCOMPARE(count(), QString("Invalid"));
    }

    void goesRound() {
        bar_->showFind();
        pattern()->setText("box");
        const long first = selection();
        QTest::keyClick(pattern(), Qt::Key_Return);
        QTest::keyClick(pattern(), Qt::Key_F3);
        bar_->findNext();
        QCOMPARE(count(), QString("4 of 4"));
        bar_->findNext();
        QCOMPARE(selection(), first);
        QTest::keyClick(pattern(), Qt::Key_Return, Qt::ShiftModifier);
        QCOMPARE(count(), QString("4 of 4"));
    }

    void startsFromTheSelection() {
        editor_->jumpTo({0, 20, 23});
        QCOMPARE(editor_->selectedText(), QString("d b"));
        bar_->showFind();
        QCOMPARE(pattern()->text(), QString("d b"));
    }

    void f3WorksWithTheBarClosed() {
        bar_->showFind();
        pattern()->setText("boxed");
        bar_->hideBar();
        editor_->SendScintilla(QsciScintillaBase::SCI_GOTOPOS, 0UL);
        QTest::keyClick(editor_, Qt::Key_F3);
        QCOMPARE(editor_->selectedText(), QString("boxed"));
        QVERIFY(!bar_->isVisible());
    }

    void replacesOneByOne() {
        bar_->showReplace();
        pattern()->setText("box");
        replacement()->setText(QString::fromUtf8("\xe6\xbc\xa2"));
        replacement()->setFocus();
        QTest::keyClick(replacement(), Qt::Key_Return);
        QTest::keyClick(replacement(), Qt::Key_Return);
        QCOMPARE(editor_->sceneText(),
                 QString::fromUtf8("// \xf0\x9f\x98\x80\n\xe6\xbc\xa2 \xe6\xbc\xa2\nboxed box\n"));
        QCOMPARE(editor_->selectedText(), QString("box"));
    }

    void replacesAllInOneStep() {
        const QString before = editor_->sceneText();
        bar_->showReplace();
        control<QToolButton>("Regular expression")->click();
        pattern()->setText("b(ox)");
        replacement()->setText("\\1b");
        control<QPushButton>("Replace all")->click();
        QCOMPARE(editor_->sceneText(), QString::fromUtf8("// \xf0\x9f\x98\x80\noxb oxb\noxbed oxb\n"));
        QCOMPARE(count(), QString("4 replaced"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), before);
    }

    void theCountFollowsTheText() {
        bar_->showFind();
        pattern()->setText("boxed");
        QCOMPARE(count(), QString("1 of 1"));
        editor_->setSceneText("boxed boxed boxed");
        QTRY_COMPARE(count(), QString("3 found"));
    }
};

QTEST_MAIN(FindBarTest)
#include "find_bar_test.moc"
