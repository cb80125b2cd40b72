// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_browser.h"

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/gui_events.h"
#include "widgets/functions/function_snippet.h"

using namespace isoscope;
using namespace isoscope::test;

class FunctionBrowserTest : public QObject {
    Q_OBJECT

    std::unique_ptr<FunctionBrowser> browser_;

    QLineEdit* search() const { return browser_->findChild<QLineEdit*>(); }
    QListView* list() const { return browser_->findChild<QListView*>(); }

  private slots:
    void init() {
        browser_ = std::make_unique<FunctionBrowser>();
        browser_->resize(360, 640);
        QVERIFY(showActive(browser_.get()));
    }
    void cleanup() { browser_.reset(); }

    void listsThemAll() {
        // All but internal(77), which has no name and cannot be called.
        QCOMPARE(list()->model()->rowCount(), static_cast<int>(builtins().size()) - 1);
        QVERIFY(builtins().size() >= 100);
        QVERIFY(browser_->current());
    }

    void numberedFunctionsComeFirst() {
        QCOMPARE(list()->model()->index(0, 0).data().toString(), QString("f_algbr_cyl1"));
        const int last = list()->model()->rowCount() - 1;
        QCOMPARE(list()->model()->index(last, 0).data().toString(), QString("f_wrinkles"));
    }

    void searchesNamesAndParameters() {
        search()->setText("torus");
        const int tori = list()->model()->rowCount();
        QVERIFY(tori >= 2 && tori < 10);
        search()->setText("TORUS major");
        QVERIFY(list()->model()->rowCount() >= 1);
        QVERIFY(browser_->current());
        search()->setText("no such function");
        QCOMPARE(list()->model()->rowCount(), 0);
        QVERIFY(!browser_->current());
        for (QPushButton* button : browser_->findChildren<QPushButton*>()) QVERIFY(!button->isEnabled());
        search()->clear();
        QVERIFY(browser_->current());
    }

    void insertsByKeysAndMouse() {
        QSignalSpy inserted(browser_.get(), &FunctionBrowser::statementRequested);
        QSignalSpy called(browser_.get(), &FunctionBrowser::callRequested);
        browser_->startSearch();
        QVERIFY(search()->hasFocus());
        QTest::keyClicks(search(), "f_torus");
        QTest::keyClick(search(), Qt::Key_Return);
        const Builtin* torus = browser_->current();
        QCOMPARE(inserted.takeFirst()[0].value<const Builtin*>(), torus);
        QTest::keyClick(search(), Qt::Key_Return, Qt::ShiftModifier);
        QCOMPARE(called.takeFirst()[0].value<const Builtin*>(), torus);
        const Builtin* first = browser_->current();
        QTest::keyClick(search(), Qt::Key_Down);
        QVERIFY(browser_->current() != first);
        QVERIFY(search()->hasFocus());
        const QPoint row = list()->visualRect(list()->model()->index(0, 0)).center();
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, row);
        QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, row);
        QCOMPARE(inserted.count(), 1);
        QCOMPARE(inserted[0][0].value<const Builtin*>(), torus);
    }

    /// The text of the details was laid out in a panel behind another one, before the first picture.
    void thereAreNoDetailsBeforeItIsPainted() {
        FunctionBrowser browser;
        const auto details = [&] {
            for (const QLabel* label : browser.findChildren<QLabel*>())
                if (label->accessibleName() == "About the function") return label->text();
            return QString("no label");
        };
        QCOMPARE(details(), QString());
        QVERIFY(browser.current());
        browser.show();
        QTRY_VERIFY(details().contains(QString::fromStdString(browser.current()->name)));
    }

    void showsFormulaAndDefaults() {
        search()->setText("f_torus");
        QString shown;
        for (QLabel* label : browser_->findChildren<QLabel*>())
            if (label->accessibleName() == "About the function") shown = label->text();
        const Builtin* torus = browser_->current();
        QVERIFY(shown.contains("Major Radius"));
        QVERIFY(shown.contains(QString::fromStdString(torus->formula).toHtmlEscaped()));
    }
};

QTEST_MAIN(FunctionBrowserTest)
#include "function_browser_test.moc"
