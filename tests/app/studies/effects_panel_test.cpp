// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/effects_panel.h"

#include <QDockWidget>
#include <QSpinBox>
#include <QTreeWidget>
#include <algorithm>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString litSphere = QStringLiteral(
    "#version 3.7;\ncamera { location <0, 2, -5> look_at 0 angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\n"
    "sphere { 0, 1 pigment { granite } }\nplane { y, -1 pigment { rgb 0.9 } }\n");

/// Nearly all of its time goes into one effect, whatever else the machine does.
const QString softlyLitSphere = QString(litSphere).replace(QStringLiteral("rgb 1 }\n"),
                                                           QStringLiteral("rgb 1 area_light x, y, 5, 5 }\n"));

QTreeWidgetItem* row(const WindowDriver& d, StageKind kind) { return d->study<EffectsPanel>()->row(kind); }

QString text(const WindowDriver& d, StageKind kind, EffectsPanel::Column column) {
    return row(d, kind)->text(column);
}

void shows(WindowDriver& d, const QString& scene) {
    d->docks()->find("effects")->raise();
    d->editor()->setSceneText(scene);
    QVERIFY(d.rests());
}

}  // namespace

/// The stages of the picture, in the real window.
class EffectsPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void stagesThatRanTellWhyAndWhatTheyCost() {
        WindowDriver d;
        shows(d, litSphere);
        const RenderProgress progress = d->viewport()->progress();
        QCOMPARE(text(d, StageKind::shadows, EffectsPanel::effect), QStringLiteral("Shadows"));
        QCOMPARE(text(d, StageKind::shadows, EffectsPanel::reason),
                 QStringLiteral("light_source at line 3 casts; 2 objects can occlude"));
        for (const StageReport& stage : progress.statistics.stages) {
            QVERIFY(!row(d, stage.kind)->font(EffectsPanel::effect).strikeOut());
            QVERIFY(!text(d, stage.kind, EffectsPanel::milliseconds).isEmpty());
        }
        QVERIFY(!text(d, StageKind::shadows, EffectsPanel::rays).isEmpty());
        QVERIFY(text(d, StageKind::textures, EffectsPanel::rays).isEmpty());
        QVERIFY(!text(d, StageKind::textures, EffectsPanel::evaluations).isEmpty());
        // Every ray of the camera is told: with a root or without one.
        const QString sum = d->study<EffectsPanel>()->summary();
        const auto numberBefore = [&sum](const QString& word) {
            QString digits;
            for (const QChar c : sum.section(word, 0, 0).section(QStringLiteral(", "), -1))
                if (c.isDigit()) digits += c;
            return digits.toLongLong();
        };
        const qint64 roots = numberBefore(QStringLiteral(" roots")),
                     misses = numberBefore(QStringLiteral(" misses"));
        qint64 all = 0;
        for (const auto& [verdict, count] : progress.statistics.verdicts) all += static_cast<qint64>(count);
        QVERIFY2(roots > 0, qPrintable(sum));
        QCOMPARE(roots + misses, all);
        // Not called for: struck out, without a switch.
        QVERIFY(row(d, StageKind::sky)->font(EffectsPanel::effect).strikeOut());
        QVERIFY(!row(d, StageKind::sky)->data(EffectsPanel::mark, Qt::CheckStateRole).isValid());
        QCOMPARE(text(d, StageKind::sky, EffectsPanel::reason), QStringLiteral("There is no sky_sphere"));
        QVERIFY(text(d, StageKind::sky, EffectsPanel::milliseconds).isEmpty());
    }

    void aSwitchLeavesAnEffectOutOfTheView() {
        WindowDriver d;
        shows(d, litSphere);
        const QImage whole = d.picture();
        row(d, StageKind::shadows)->setCheckState(EffectsPanel::mark, Qt::Unchecked);
        QVERIFY(d.rests());
        QVERIFY(difference(whole, d.picture()) > 0.01);
        QVERIFY(text(d, StageKind::shadows, EffectsPanel::rays).isEmpty());
        QVERIFY(text(d, StageKind::shadows, EffectsPanel::reason).startsWith(QStringLiteral("Left out")));
        QVERIFY(!row(d, StageKind::shadows)->font(EffectsPanel::effect).strikeOut());
        // The next scene is drawn without it too.
        d->editor()->setSceneText(litSphere + QStringLiteral("// the same\n"));
        QVERIFY(d.rests());
        QCOMPARE(row(d, StageKind::shadows)->checkState(EffectsPanel::mark), Qt::Unchecked);
        row(d, StageKind::shadows)->setCheckState(EffectsPanel::mark, Qt::Checked);
        QVERIFY(d.rests());
        QCOMPARE(difference(whole, d.picture()), 0.0);
    }

    void whileMovingTheDearestGoAndComeBackAtRest() {
        WindowDriver d;
        shows(d, softlyLitSphere);
        const QImage whole = d.picture();
        d->viewport()->setMovingSeconds(1e-6);
        Viewport* viewport = d->viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, {100, 100});
        QTest::mouseMove(viewport, {140, 100});
        const auto isAreaLights = [](const PlannedStage& stage) {
            return stage.kind == StageKind::areaLights;
        };
        QTRY_VERIFY(std::ranges::any_of(viewport->progress().statistics.leftOut, isAreaLights));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, {140, 100});
        QVERIFY(d.rests());
        QVERIFY(viewport->progress().statistics.leftOut.empty());
        QVERIFY(difference(whole, d.picture()) > 0);
    }

    void theTimeForMovingPicturesIsRemembered() {
        WindowDriver d;
        QCOMPARE(d->study<EffectsPanel>()->movingTime()->value(), 400);
        QCOMPARE(d->viewport()->movingSeconds(), 0.4);
        d->study<EffectsPanel>()->movingTime()->setValue(350);
        QCOMPARE(d->viewport()->movingSeconds(), 0.35);
        d.restart();
        QCOMPARE(d->study<EffectsPanel>()->movingTime()->value(), 350);
        QCOMPARE(d->viewport()->movingSeconds(), 0.35);
    }

    void anEmptyWindowHasNoRows() {
        WindowDriver d;
        d->docks()->find("effects")->raise();
        WindowDriver::trigger(d->actions()->newFile);
        d->viewport()->clear();
        for (std::size_t i = 0; i < stageKindCount; ++i)
            QVERIFY(row(d, static_cast<StageKind>(i))->isHidden());
    }
};

QTEST_MAIN(EffectsPanelTest)
#include "effects_panel_test.moc"
