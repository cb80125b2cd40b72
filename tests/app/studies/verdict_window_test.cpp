// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <QTreeWidget>

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/sphere_text.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_view.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/verdicts/verdict_badge.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/viewport/overlay_bar.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

VerdictStudy* studyOf(const WindowDriver& d) { return d->studies()->verdicts()->study(); }

bool judged(const WindowDriver& d) {
    return d.rests(60000) && QTest::qWaitFor(
                                 [&] {
                                     return studyOf(d)->judged() && !studyOf(d)->busy() &&
                                            studyOf(d)->judged() == d->session()->scene();
                                 },
                                 60000);
}

bool judgedText(const WindowDriver& d, const QString& text) {
    d->editor()->setSceneText(text);
    return judged(d);
}

QString withGradient(const QString& maxGradient, QString text = sphereText) {
    return text.replace(QStringLiteral("  contained_by"),
                        QStringLiteral("  max_gradient %1\n  contained_by").arg(maxGradient));
}

int lineOf(const QString& text, const QString& words) {
    return static_cast<int>(text.left(text.indexOf(words)).count('\n'));
}

/// Its proof takes long.
const QString noiseText = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0, 2, -5> look_at 0 }\n"
    "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { y - f_noise3d(9*x, 9*y, 9*z) }\n"
    "  max_gradient 12\n  contained_by { box { -2, 2 } }\n  pigment { rgb 0.9 }\n}\n");

QString manySpheres(int count) {
    QString text = QStringLiteral(
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -12> look_at 0 }\n"
        "light_source { <4, 6, -5> rgb 1 }\n");
    for (int i = 0; i < count; ++i)
        text += QStringLiteral(
                    "isosurface {\n  function { x*x + y*y + z*z - %1 }\n  max_gradient 1.2\n  contained_by { "
                    "sphere "
                    "{ 0, 1.2 } }\n  pigment { rgb 0.9 }\n  translate <%2, %3, 0>\n}\n")
                    .arg(0.9 + 0.01 * i)
                    .arg(-6 + 3 * (i % 5))
                    .arg(-4 + 2.6 * (i / 5));
    return text;
}

}  // namespace

class VerdictWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void D7_everyStateOfTheBadge_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("badge");
        QTest::newRow("right") << withGradient(QStringLiteral("2.4")) << "No holes: proven";
        QTest::newRow("holes") << sphereText << "Holes: ";
        // Steeper only where no surface is.
        QTest::newRow("holes elsewhere") << withGradient(QStringLiteral("2.3")) << "May have holes";
        QTest::newRow("wasteful") << withGradient(QStringLiteral("24")) << " × slower than need be";
        QString pole = withGradient(QStringLiteral("1e9"));
        pole.replace(QStringLiteral("x*x + y*y + z*z - 1"), QStringLiteral("y - 0.1/(x - 0.25)"));
        QTest::newRow("unbounded") << pole << "Infinitely steep";
        QTest::newRow("two") << sphereText + sphereText.mid(sphereText.indexOf(QStringLiteral("isosurface")))
                             << "(2 of 2)";
        QTest::newRow("none") << QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n")
                              << QString();
    }
    void D7_everyStateOfTheBadge() {
        QFETCH(QString, text);
        QFETCH(QString, badge);
        WindowDriver d;
        QVERIFY(judgedText(d, text));
        QCOMPARE(d->badge()->isHidden(), badge.isEmpty());
        if (badge.isEmpty()) return;
        QVERIFY2(d->badge()->text().contains(badge), qPrintable(d->badge()->text()));
        QVERIFY(!d->badge()->toolTip().isEmpty() && !d->badge()->icon().isNull());
    }

    void D7_tooLowWithoutAHoleIsNoRiddle() {
        WindowDriver d;
        QVERIFY(judgedText(d, withGradient(QStringLiteral("2.3"))));
        const QString sentence = QStringLiteral("No holes in this view; other views may have some.");
        QVERIFY2(d->badge()->toolTip().contains(sentence), qPrintable(d->badge()->toolTip()));
        d->docks()->find("gradient")->raise();
        QVERIFY(QTest::qWaitFor(
            [&] { return d->study<GradientPanel>()->isActive() && d->study<GradientPanel>()->upToDate(); },
            30000));
        QCOMPARE(d->study<GradientPanel>()->headline(), sentence);
    }

    void theBadgeOpensThePanel() {
        WindowDriver d;
        const QString second = sphereText.mid(sphereText.indexOf(QStringLiteral("isosurface")));
        QVERIFY(judgedText(d, withGradient(QStringLiteral("2.4")) + second));
        QCOMPARE(d->badge()->isosurface(), std::size_t(1));
        QTest::mouseClick(d->badge(), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([&] { return d->study<GradientPanel>()->isActive(); }));
        QCOMPARE(d->study<GradientPanel>()->chosen(), std::size_t(1));
    }

    void aSignStandsBesideTheLine() {
        WindowDriver d;
        const QString text = withGradient(QStringLiteral("2.3"));
        QVERIFY(judgedText(d, text));
        const int line = lineOf(text, QStringLiteral("max_gradient"));
        QVERIFY(d->editor()->verdictText(line).contains(QStringLiteral("No holes in this view")));
        QVERIFY(d->editor()->verdictText(line + 1).isEmpty());
        // It moves with its line.
        d.typeBehind(QStringLiteral("#version 3.7;"), {});
        QTest::keyClick(d->editor()->viewport(), Qt::Key_Return);
        QVERIFY(!d->editor()->verdictText(line + 1).isEmpty());
        // Without the setting it stands beside the statement.
        QVERIFY(judgedText(d, sphereText));
        QVERIFY(!d->editor()->verdictText(lineOf(sphereText, QStringLiteral("isosurface"))).isEmpty());
    }

    void D21_aProofSurvivesOrbitTabsThemesAndUndo() {
        WindowDriver d;
        QVERIFY(judgedText(d, sphereText));
        const std::uint64_t slices = studyOf(d)->slices();
        const auto begun = [&] { return studyOf(d)->proofs()->begun(); };
        const std::uint64_t proofs = begun();
        d.dragViewport({100, 100}, {60, 20});
        QVERIFY(judged(d));
        d->docks()->find("gradient")->raise();
        d->setTheme(Theme::dark);
        d.typeBehind(QStringLiteral("rgb 1 }"), QStringLiteral(" // edited"));
        QVERIFY(judged(d));
        QCOMPARE(begun(), proofs);
        QCOMPARE(studyOf(d)->slices(), slices);
        d.typeBehind(QStringLiteral("z*z - 1"), QStringLiteral(".5"));
        QVERIFY(judged(d));
        QCOMPARE(begun(), proofs + 1);
        d->editor()->undo();
        QVERIFY(judged(d));
        QCOMPARE(begun(), proofs + 1);
        d->setTheme(Theme::light);
    }

    void D21_theButtonStaysOnAcrossTabsAndViews() {
        WindowDriver d;
        QVERIFY(judgedText(d, sphereText));
        d->docks()->find("gradient")->raise();
        GradientPanel* panel = d->study<GradientPanel>();
        QVERIFY(QTest::qWaitFor([&] { return panel->isActive() && panel->upToDate(); }, 30000));
        QVERIFY(panel->useSuggested()->isEnabled());
        const QString suggested = panel->suggestedText();
        bool wentOff = false;
        QSignalSpy reports(panel, &GradientPanel::reported);
        connect(panel, &GradientPanel::reported, this, [&] {
            wentOff = wentOff || !panel->useSuggested()->isEnabled() || panel->suggestedText() != suggested;
        });
        d->docks()->find("section")->raise();
        QVERIFY(QTest::qWaitFor([&] { return !panel->isActive(); }));
        d->docks()->find("gradient")->raise();
        QVERIFY(QTest::qWaitFor([&] { return panel->isActive(); }));
        // Nothing has changed: nothing is measured.
        QVERIFY(panel->upToDate());
        QCOMPARE(reports.count(), 0);
        d.dragViewport({100, 100}, {60, 20});
        QVERIFY(panel->useSuggested()->isEnabled());
        QCOMPARE(panel->suggestedText(), suggested);
        QVERIFY(d.rests());
        QVERIFY(QTest::qWaitFor([&] { return panel->upToDate(); }, 30000));
        QVERIFY(reports.count() > 0 && !wentOff);
    }

    void D21_theSuggestionNeverGrows() {
        WindowDriver d;
        d->docks()->find("gradient")->raise();
        QList<double> said;
        connect(d->study<GradientPanel>(), &GradientPanel::reported, this, [&] {
            const QString text = d->study<GradientPanel>()->suggestedText();
            if (text.startsWith(QStringLiteral("at most "))) said << text.section(' ', 2, 2).toDouble();
        });
        d->editor()->setSceneText(noiseText);
        QVERIFY(d.rests());
        QTest::qWait(2000);
        for (qsizetype i = 1; i < said.size(); ++i) QVERIFY(said[i] <= said[i - 1]);
    }

    void aDragIsNotHindered() {
        WindowDriver d;
        d->editor()->setSceneText(noiseText);
        QVERIFY(QTest::qWaitFor([&] { return studyOf(d)->busy() && studyOf(d)->slices() > 2; }, 60000));
        QTest::mousePress(d->viewport(), Qt::LeftButton, {}, {100, 100});
        QTest::mouseMove(d->viewport(), {110, 100});
        // What ran is over within a slice; nothing begins until the view has come to rest.
        QTest::qWait(100);
        for (int i = 1; i <= 5; ++i) {
            QTest::mouseMove(d->viewport(), {110 + 8 * i, 100});
            const std::uint64_t slices = studyOf(d)->slices(), views = studyOf(d)->views();
            QTest::qWait(40);
            QCOMPARE(studyOf(d)->slices(), slices);
            QCOMPARE(studyOf(d)->views(), views);
        }
        QTest::mouseRelease(d->viewport(), Qt::LeftButton, {}, {150, 100});
        const std::uint64_t slices = studyOf(d)->slices();
        QVERIFY(QTest::qWaitFor([&] { return !studyOf(d)->busy() || studyOf(d)->slices() > slices; }, 60000));
    }

    /// The text has to be read first, and whoever moves a slider waits for that too.
    void aMovedSliderHoldsTheProofBeforeItsTextIsRead() {
        WindowDriver d;
        d->editor()->setSceneText(noiseText);
        QVERIFY(QTest::qWaitFor([&] { return studyOf(d)->busy() && studyOf(d)->slices() > 2; }, 60000));
        const int index = d.parameter("max_gradient");
        emit d->parameters()->valueChanged(index, d->parameters()->slider(index)->value() * 1.1);
        // No event is handled meanwhile: nothing but the change itself can have held it.
        QThread::msleep(50);  // the box at hand
        const std::uint64_t slices = studyOf(d)->slices();
        QThread::msleep(100);
        QCOMPARE(studyOf(d)->slices(), slices);
        QVERIFY(d.rests());
        QVERIFY(QTest::qWaitFor([&] { return !studyOf(d)->busy() || studyOf(d)->slices() > slices; }, 60000));
    }

    void theSteepestPlaceIsMarkedAndAClickGoesThere() {
        WindowDriver d;
        QVERIFY(judgedText(d, withGradient(QStringLiteral("2.3"))));
        const auto& marks = d->viewport()->placeMarks().marks();
        QCOMPARE(marks.size(), std::size_t(1));
        QVERIFY(std::abs(glm::length(marks[0].place) - 1.2) < 0.01);
        const auto pixel = d->viewport()->projection().pixelOf(marks[0].place);
        QVERIFY(pixel.has_value());
        QTest::mouseClick(d->viewport(), Qt::LeftButton, {}, pixel->toPoint());
        QVERIFY(d.rests());
        const auto now = d->viewport()->projection().pixelOf(marks[0].place);
        const QPointF middle = QRectF(d->viewport()->rect()).center();
        QVERIFY(now && QLineF(*now, middle).length() < 3);
        QVERIFY(d->viewport()->viewMoved());
        // A right one has no mark unless somebody looks at its gradient.
        QVERIFY(judgedText(d, withGradient(QStringLiteral("2.4"))));
        QVERIFY(d->viewport()->placeMarks().marks().empty());
        d->docks()->find("gradient")->raise();
        QVERIFY(QTest::qWaitFor([&] { return d->viewport()->placeMarks().marks().size() == 1; }, 30000));
    }

    /// A macro's hundreds of marks hid the picture once.
    void aStatementHasOneMarkHoweverManySurfacesItMakes() {
        WindowDriver d;
        QVERIFY(judgedText(
            d, QStringLiteral("#version 3.7;\ncamera { location -9*z look_at 0 }\n#for (I, 1, 5)\n"
                              "isosurface { function { x*x + y*y + z*z - 1 } max_gradient 2\n"
                              "contained_by { sphere { 0, 1 + 0.01*I } } translate (I - 3)*x }\n#end\n"
                              "isosurface { function { y } max_gradient 0.5 translate -2*y }\n")));
        const auto& marks = d->viewport()->placeMarks().marks();
        QCOMPARE(marks.size(), std::size_t(2));
        // The steepest is that of the largest container.
        QVERIFY(glm::distance(marks[0].place, glm::dvec3(2, 0, 0)) > 1.04);
    }

    void theSectionMarksItAndGoesThere() {
        WindowDriver d;
        QVERIFY(judgedText(d, sphereText));
        d->study<SectionPanel>()->setAxis(0);
        d->study<SectionPanel>()->setPosition(0.1);
        QVERIFY(d.rests());
        const auto& mark = d->study<SectionPanel>()->view()->markedPlace();
        QVERIFY(mark.has_value());
        const auto pixel = d->study<SectionPanel>()->view()->markPixel();
        QVERIFY(pixel.has_value());
        QTest::mouseClick(d->study<SectionPanel>()->view(), Qt::LeftButton, {}, pixel->toPoint());
        QVERIFY(std::abs(d->study<SectionPanel>()->position() - mark->place.x) < 0.01);
    }

    void D22_oneNumberOneRounding() {
        WindowDriver d;
        QVERIFY(judgedText(d, sphereText));
        d->docks()->find("gradient")->raise();
        QVERIFY(QTest::qWaitFor(
            [&] { return d->study<GradientPanel>()->isActive() && d->study<GradientPanel>()->upToDate(); },
            30000));
        QString proven;
        for (const ChartMark& mark : d->study<HistogramPanel>()->chart()->chart().marks)
            if (mark.text.startsWith(QStringLiteral("proven "))) proven = mark.text.mid(7);
        QVERIFY(!proven.isEmpty());
        bool same = false;
        for (const QLabel* label : d->study<GradientPanel>()->findChildren<QLabel*>())
            same = same || label->text().contains(QStringLiteral(" to %1,").arg(proven));
        QVERIFY2(same, qPrintable(proven));
    }

    void D22_anEmptySceneHasNothingToProve() {
        WindowDriver d;
        QVERIFY(judgedText(d, QStringLiteral("#version 3.7;\ncamera { location -3*z }\n")));
        const QString status = d->viewportPanel()->status();
        QVERIFY2(!status.contains(QStringLiteral("100 %")), qPrintable(status));
        QVERIFY2(status.contains(QStringLiteral("Nothing was there to prove")), qPrintable(status));
    }

    void D23_afterAStopTheOverlayDoesNotWait() {
        WindowDriver d;
        QVERIFY(d.rests());
        d->actions()->overlayHoles->trigger();
        d->viewport()->restart();
        QTest::keyClick(d->viewport(), Qt::Key_Escape);
        QVERIFY2(!d->viewport()->overlay().summary().contains(QStringLiteral("Waits")),
                 qPrintable(d->viewport()->overlay().summary()));
        d->viewport()->restart();
        QVERIFY(d.rests(60000));
        QVERIFY(d->viewport()->overlay().ready());
    }

    void D23_whileATextIsReadNothingIsClaimed() {
        WindowDriver d;
        QVERIFY(judgedText(d, withGradient(QStringLiteral("2.4"))));
        const auto* empty = d->problems()->findChild<QLabel*>();
        QVERIFY(empty->text().startsWith(QStringLiteral("No problems.")));
        QVERIFY2(empty->text().contains(QStringLiteral("proven")), qPrintable(empty->text()));
        d->editor()->setSceneText(QStringLiteral("#while (1)\n#end\n"));
        QVERIFY(empty->text().contains(QStringLiteral("still being read")));
        QTest::qWait(700);
        QVERIFY(empty->text().contains(QStringLiteral("still being read")));
        d->session()->stop();
        QVERIFY(QTest::qWaitFor([&] { return !d->session()->busy(); }));
    }

    void theBadgeMendsOneInOneStep() {
        WindowDriver d;
        QVERIFY(judgedText(d, sphereText));
        QVERIFY(d->badge()->menu());
        QCOMPARE(d->badge()->menu()->actions().size(), 1);
        QVERIFY(d->badge()->menu()->actions().first()->text().startsWith(QStringLiteral("Use 2.4")));
        d->badge()->menu()->actions().first()->trigger();
        QCOMPARE(d.numberBehind(QStringLiteral("max_gradient")), 2.4);
        QVERIFY(judged(d));
        QVERIFY(!d->badge()->menu());
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), sphereText);
    }

    void fixAllMendsTwentyInOneStep() {
        WindowDriver d;
        const QString text = manySpheres(20);
        QVERIFY(judgedText(d, text));
        QCOMPARE(studyOf(d)->verdicts().size(), std::size_t(20));
        QVERIFY(d->badge()->menu());
        QAction* all = d->badge()->menu()->actions().last();
        QCOMPARE(all->text(), QStringLiteral("Fix All 20"));
        all->trigger();
        QVERIFY(!d->editor()->sceneText().contains(QStringLiteral("max_gradient 1.2")));
        QVERIFY(judged(d));
        for (const SurfaceVerdict& one : studyOf(d)->verdicts())
            QVERIFY(one.verdict() == GradientVerdict::right);
        QVERIFY2(d->badge()->text().startsWith(QStringLiteral("No holes")), qPrintable(d->badge()->text()));
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), text);
    }

    void D8_aBadVerdictIsAProblemWithAFix() {
        WindowDriver d;
        QVERIFY(judgedText(d, sphereText));
        auto* list = d->problems()->findChild<QTreeWidget*>();
        QVERIFY(list->isVisible());
        QVERIFY2(d->problems()->title().contains(QStringLiteral("1 warning")),
                 qPrintable(d->problems()->title()));
        QVERIFY(list->topLevelItem(0)->text(0).contains(QStringLiteral("holes")));
        QAbstractButton* use = nullptr;
        for (auto* button : list->findChildren<QAbstractButton*>())
            if (button->text().contains(QStringLiteral("2.4"))) use = button;
        QVERIFY(use);
        QTest::mouseClick(use, Qt::LeftButton);
        QCOMPARE(d.numberBehind(QStringLiteral("max_gradient")), 2.4);
        QVERIFY(judged(d));
        QCOMPARE(d->problems()->title(), QStringLiteral("Problems"));
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), sphereText);
    }

    void D8_fixAllMendsTwentyInOneStep() {
        WindowDriver d;
        const QString text = manySpheres(20);
        QVERIFY(judgedText(d, text));
        QCOMPARE(studyOf(d)->verdicts().size(), std::size_t(20));
        auto* list = d->problems()->findChild<QTreeWidget*>();
        QAbstractButton* all = nullptr;
        // Laid out: a button that has just come has no size yet.
        QVERIFY(QTest::qWaitFor([&] {
            for (auto* button : list->findChildren<QAbstractButton*>())
                if (button->isVisible() && !button->size().isEmpty() &&
                    button->text().contains(QStringLiteral("All")))
                    all = button;
            return all != nullptr;
        }));
        QTest::mouseClick(all, Qt::LeftButton);
        QVERIFY(!d->editor()->sceneText().contains(QStringLiteral("max_gradient 1.2")));
        QVERIFY(judged(d));
        for (const SurfaceVerdict& one : studyOf(d)->verdicts())
            QVERIFY(one.verdict() == GradientVerdict::right);
        QVERIFY2(d->badge()->text().startsWith(QStringLiteral("No holes")), qPrintable(d->badge()->text()));
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), text);
    }
};

QTEST_MAIN(VerdictWindowTest)
#include "verdict_window_test.moc"
