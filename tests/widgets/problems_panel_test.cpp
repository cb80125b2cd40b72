// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/problems_panel.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/widgets/gui_events.h"
#include "widgets/icons.h"

using namespace isoscope;

Q_DECLARE_METATYPE(isoscope::Diagnostics)

namespace {

Diagnostic make(Severity severity, const char* message, SourceRange range, const char* hint = "") {
    return {severity, message, range, message, hint, {}, {}};
}

}  // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ProblemsPanel> panel_;
    std::shared_ptr<SourceLibrary> sources_ = std::make_shared<SourceLibrary>();

    QTreeWidget* list() const { return panel_->findChild<QTreeWidget*>(); }
    QTreeWidgetItem* row(int i) const { return list()->topLevelItem(i); }

  private slots:
    void initTestCase() {
        useIconTheme(false);
        sources_->add("scene.pov", "one\ntwo\nthree\n");
        sources_->add("/usr/share/colors.inc", "red\ngreen\n");
    }
    void init() {
        panel_ = std::make_unique<ProblemsPanel>();
        panel_->resize(500, 200);
        QVERIFY(test::showActive(panel_.get()));
    }

    void sayNothingIsWrong() {
        QVERIFY(!list()->isVisible());
        QVERIFY(panel_->findChild<QLabel*>()->text().startsWith("No problems"));
        QCOMPARE(panel_->title(), QString("Problems"));
        panel_->setDiagnostics({make(Severity::error, "e", {0, 0, 1})}, sources_);
        QVERIFY(list()->isVisible());
        panel_->setDiagnostics({}, sources_);
        QVERIFY(!list()->isVisible());
    }

    void worstFirstWithLinesAndCounts() {
        QSignalSpy title(panel_.get(), &ProblemsPanel::titleChanged);
        panel_->setDiagnostics(
            {make(Severity::leftOut, "`fog` is not simulated", {0, 8, 9}),
             make(Severity::warning, "w", {0, 4, 5}), make(Severity::error, "e", {0, 9, 10}, "try this"),
             make(Severity::error, "f", {0, 0, 1})},
            sources_);
        QCOMPARE(list()->topLevelItemCount(), 4);
        QCOMPARE(row(0)->text(0), QString("e"));
        QCOMPARE(row(0)->text(1), QString("3:2"));
        QVERIFY(row(0)->toolTip(0).contains("try this"));
        QVERIFY(!row(0)->icon(0).isNull());
        QCOMPARE(row(2)->text(0), QString("w"));
        QCOMPARE(row(3)->text(0), QString("“fog” is not simulated"));
        QCOMPARE(panel_->title(), QString("Problems: 2 errors, 1 warning, 1 left out"));
        QCOMPARE(title.count(), 1);
    }

    /// A bug once: what was expected, at the end of the sentence, was cut off.
    void longMessagesTakeSeveralLines() {
        const char* message =
            "Expected a statement such as `isosurface` or `camera` here, but found `dolor`, which is no "
            "word of the language and was not declared before.";
        panel_->setDiagnostics(
            {make(Severity::error, "short", {0, 0, 1}), make(Severity::error, message, {0, 0, 1}),
             make(Severity::error, "short too", {0, 0, 1}, message)},
            sources_);
        QCoreApplication::processEvents();
        const int one = list()->visualItemRect(row(0)).height();
        const int wide = list()->visualItemRect(row(1)).height();
        QVERIFY2(wide > one, qPrintable(QString("%1 %2").arg(wide).arg(one)));
        QVERIFY(list()->visualItemRect(row(2)).height() > wide);
        panel_->resize(250, 400);
        QTRY_VERIFY(list()->visualItemRect(row(1)).height() > wide);
    }

    void repeatedMessagesCollapse() {
        Diagnostics many;
        for (std::uint32_t i = 0; i < 3; ++i)
            many.push_back(make(Severity::warning, "again", {0, 4 * i, 4 * i + 1}));
        panel_->setDiagnostics(many, sources_);
        QCOMPARE(list()->topLevelItemCount(), 1);
        QCOMPARE(row(0)->text(0), QString("again (3 times)"));
        QCOMPARE(row(0)->childCount(), 3);
        QCOMPARE(row(0)->child(2)->text(1), QString("3:1"));
        QCOMPARE(panel_->title(), QString("Problems: 3 warnings"));
    }

    void clickAndEnterJump() {
        panel_->setDiagnostics({make(Severity::error, "a", {0, 0, 1}), make(Severity::error, "b", {0, 4, 7})},
                               sources_);
        QSignalSpy activated(panel_.get(), &ProblemsPanel::activated);
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualItemRect(row(1)).center());
        QCOMPARE(activated.count(), 1);
        QCOMPARE(activated[0][0].value<SourceRange>(), (SourceRange{0, 4, 7}));
        list()->setFocus();
        QTest::keyClick(list(), Qt::Key_Up);
        QTest::keyClick(list(), Qt::Key_Return);
        QCOMPARE(activated.last()[0].value<SourceRange>(), (SourceRange{0, 0, 1}));
    }

    /// D16: neither the window nor the command line showed how a place in a macro or an include was reached.
    void callsThatLedToAPlaceAreRowsBelowIt() {
        auto sources = std::make_shared<SourceLibrary>();
        sources->add("scene.pov", "#include \"balls.inc\"\nBall(3)\n");
        sources->add("/somewhere/balls.inc", "#macro Ball(R)\n  Part(R)\n#end\n");
        Diagnostic inside = make(Severity::error, "bad", {1, 17, 21});
        inside.reachedFrom = {{1, 17, 24}, {0, 21, 28}};
        Diagnostic included = make(Severity::error, "worse", {1, 0, 6});
        included.reachedFrom = {{0, 0, 20}};
        panel_->setDiagnostics({inside, included}, sources);
        QCOMPARE(row(0)->text(1), QString("balls.inc:2:3"));
        QCOMPARE(row(0)->childCount(), 2);
        QVERIFY(row(0)->isExpanded());
        QCOMPARE(row(0)->child(0)->text(0), QString("in macro “Part”, called at"));
        QCOMPARE(row(0)->child(0)->text(1), QString("balls.inc:2:3"));
        QCOMPARE(row(0)->child(1)->text(0), QString("in macro “Ball”, called at"));
        QCOMPARE(row(0)->child(1)->text(1), QString("2:1"));
        QCOMPARE(row(1)->child(0)->text(0), QString("included at"));
        QSignalSpy activated(panel_.get(), &ProblemsPanel::activated);
        for (QTreeWidgetItem* item : {row(0), row(0)->child(0), row(0)->child(1)})
            emit list()->itemActivated(item, 0);
        QCOMPARE(activated[0][0].value<SourceRange>(), (SourceRange{1, 17, 21}));
        QCOMPARE(activated[1][0].value<SourceRange>(), (SourceRange{1, 17, 24}));
        QCOMPARE(activated[2][0].value<SourceRange>(), (SourceRange{0, 21, 28}));
    }

    void columnsCountCharacters() {
        auto sources = std::make_shared<SourceLibrary>();
        sources->add("scene.pov", "// \n/*äöü*/ x");
        panel_->setDiagnostics({make(Severity::error, "e", {0, 15, 16})}, sources);
        QCOMPARE(row(0)->text(1), QString("2:9"));
    }

    void whatCanBeMendedHasAButton() {
        Diagnostic first = make(Severity::error, "`on` is wrong.", {0, 0, 3});
        first.fixes = {{"Use `one`", {0, 0, 3}, "one"}};
        panel_->setDiagnostics({first, make(Severity::error, "plain", {0, 4, 7})}, sources_);
        const auto buttons = list()->findChildren<QToolButton*>();
        QCOMPARE(buttons.size(), 1);
        QCOMPARE(buttons[0]->text(), QString("Use “one”"));
        QTRY_VERIFY(buttons[0]->isVisible());
        const QRect cell = list()->visualItemRect(row(0));
        const QRect button(buttons[0]->mapTo(list()->viewport(), QPoint()), buttons[0]->size());
        QTRY_VERIFY(cell.contains(QRect(buttons[0]->mapTo(list()->viewport(), QPoint()), button.size())));
        QSignalSpy asked(panel_.get(), &ProblemsPanel::fixRequested);
        QSignalSpy activated(panel_.get(), &ProblemsPanel::activated);
        QTest::mouseClick(buttons[0], Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
        QCOMPARE(activated.count(), 0);
        const auto fixes = asked[0][0].value<std::vector<QuickFix>>();
        QCOMPARE(fixes.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(fixes[0].replacement), QString("one"));
    }

    void severalOfAKindAreMendedTogether() {
        Diagnostics many;
        for (std::uint32_t i = 0; i < 2; ++i) {
            many.push_back(make(Severity::warning, i == 0 ? "a" : "b", {0, 4 * i, 4 * i + 3}));
            many.back().id = "max-gradient";
            many.back().fixes = {{"Use 2.06", {0, 4 * i, 4 * i + 3}, "2.06"}};
        }
        panel_->setDiagnostics({many[0]}, sources_);
        QCOMPARE(list()->findChildren<QToolButton*>().size(), 1);
        panel_->setFindings({many[1]});
        QCOMPARE(list()->topLevelItemCount(), 2);
        QCOMPARE(panel_->title(), QString("Problems: 2 warnings"));
        const auto buttons = list()->itemWidget(row(1), 0)->findChildren<QToolButton*>();
        QCOMPARE(buttons.size(), 2);
        QCOMPARE(buttons[1]->text(), QString("Fix All 2"));
        QSignalSpy asked(panel_.get(), &ProblemsPanel::fixRequested);
        buttons[1]->click();
        QCOMPARE(asked[0][0].value<std::vector<QuickFix>>().size(), std::size_t(2));
        panel_->setFindings({});
        QCOMPARE(list()->topLevelItemCount(), 1);
    }

    /// A slider that is moved has its text read again and again: what stays the same must not flicker.
    void anEqualTextKeepsTheRows() {
        const Diagnostics read{make(Severity::warning, "a", {0, 0, 3})};
        const Diagnostics found{make(Severity::note, "b", {0, 4, 7})};
        panel_->setDiagnostics(read, sources_);
        panel_->setFindings(found);
        QTreeWidgetItem* const first = row(0);
        QSignalSpy title(panel_.get(), &ProblemsPanel::titleChanged);
        panel_->setDiagnostics(read, std::make_shared<SourceLibrary>(*sources_));
        panel_->setFindings(found);
        QCOMPARE(row(0), first);
        QCOMPARE(title.count(), 0);
        // The same bytes stand in another line.
        auto moved = std::make_shared<SourceLibrary>();
        moved->add("scene.pov", "one two\nthree\n");
        panel_->setDiagnostics(read, moved);
        QCOMPARE(row(1)->text(1), QString("1:5"));
        panel_->clear();
        QCOMPARE(list()->topLevelItemCount(), 0);
        QCOMPARE(panel_->title(), QString("Problems"));
    }

    void theSelectionStaysWhileTyping() {
        panel_->setDiagnostics({make(Severity::error, "a", {0, 0, 1}), make(Severity::error, "b", {0, 4, 7})},
                               sources_);
        list()->setCurrentItem(row(1));
        panel_->setDiagnostics(
            {make(Severity::error, "new", {0, 0, 1}), make(Severity::error, "b", {0, 5, 8})}, sources_);
        QCOMPARE(list()->currentItem(), row(1));
    }

    void messagesAreTextNotMarkup() {
        panel_->setDiagnostics({make(Severity::error, "expected <b>", {0, 0, 1})}, sources_);
        QVERIFY(row(0)->toolTip(0).contains("&lt;b&gt;"));
    }
};

QTEST_MAIN(ProblemsPanelTest)
#include "problems_panel_test.moc"
