// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/problems_panel.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/widgets/gui_events.h"
#include "widgets/icons.h"

using namespace isoscope;

Q_DECLARE_METATYPE(isoscope::Diagnostics)

namespace {

Diagnostic make(Severity severity, const char* message, SourceRange range, const char* hint = "") {
    return {severity, message, range, message, hint, {}};
}

}  // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ProblemsPanel> panel_;
    SourceLibrary sources_;

    QTreeWidget* list() const { return panel_->findChild<QTreeWidget*>(); }
    QTreeWidgetItem* row(int i) const { return list()->topLevelItem(i); }

  private slots:
    void initTestCase() {
        useIconTheme(false);
        sources_.add("scene.pov", "one\ntwo\nthree\n");
        sources_.add("/usr/share/colors.inc", "red\ngreen\n");
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
        QCOMPARE(row(0)->text(1), QString("3"));
        QVERIFY(row(0)->toolTip(0).contains("try this"));
        QVERIFY(!row(0)->icon(0).isNull());
        QCOMPARE(row(2)->text(0), QString("w"));
        QCOMPARE(row(3)->text(0), QString("`fog` is not simulated"));
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
        QCOMPARE(row(0)->child(2)->text(1), QString("3"));
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

    void placesInIncludesLeadToTheInclude() {
        Diagnostic inside = make(Severity::error, "bad", {1, 4, 5});
        inside.reachedFrom = {{0, 4, 7}};
        Diagnostic lost = make(Severity::error, "lost", {1, 0, 1});
        panel_->setDiagnostics({inside, lost}, sources_);
        QCOMPARE(row(0)->text(1), QString("colors.inc:2"));
        QSignalSpy activated(panel_.get(), &ProblemsPanel::activated);
        emit list()->itemActivated(row(0), 0);
        QCOMPARE(activated.takeFirst()[0].value<SourceRange>(), (SourceRange{0, 4, 7}));
        emit list()->itemActivated(row(1), 0);
        QCOMPARE(activated.count(), 0);
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
