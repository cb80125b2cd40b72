// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/accuracy_plan.h"

#include <cmath>
#include <QTest>

#include "core/study/accuracy/accuracy_table.h"
#include "core/text/csv_table.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

class AccuracyPlanTest : public QObject {
    Q_OBJECT

  private slots:
    void rangesAreAroundWhatIsProven() {
        const auto scene =
            studyScene("isosurface { function { 3*x } max_gradient 50 }\nisosurface { function { y } }\n")
                .scene;
        const SettingRange accuracy = studiedRange(*scene, StudiedSetting::accuracy);
        QCOMPARE(accuracy.from, 1e-1);
        QCOMPARE(accuracy.to, 1e-9);
        const SettingRange gradient = studiedRange(*scene, StudiedSetting::maxGradient);
        QVERIFY(std::abs(gradient.from - 0.3) < 0.01 && std::abs(gradient.to - 30) < 1);
    }

    void withoutABoundTheSettingStandsIn() {
        const auto scene = studyScene("isosurface { function { 1/x - y } max_gradient 5 }\n").scene;
        const SettingRange range = studiedRange(*scene, StudiedSetting::maxGradient);
        QCOMPARE(range.from, 0.5);
        QCOMPARE(range.to, 50.0);
    }

    void thePictureFitsTheBudget() {
        const RenderRequest view =
            studyScene("isosurface { function { x*x + y*y + z*z - 1 } max_gradient 3 }\n", 800, 600);
        const auto rich = planAccuracyStudy(view, StudiedSetting::accuracy, 9, 1e6);
        const auto poor = planAccuracyStudy(view, StudiedSetting::accuracy, 9, 1e-6);
        QVERIFY(rich.view.width > poor.view.width);
        QCOMPARE(poor.view.width, 32);
        QCOMPARE(poor.view.height, 24);
        QCOMPARE(rich.view.width, 400);
        QCOMPARE(rich.values.size(), std::size_t(9));
        QVERIFY(rich.runs >= 3);
    }

    void aStoppedPlanHasNoValues() {
        std::stop_source stop;
        stop.request_stop();
        const auto plan = planAccuracyStudy(studyScene("isosurface { function { x } }\n"),
                                            StudiedSetting::accuracy, 9, 1, stop.get_token());
        QVERIFY(plan.values.empty());
        QVERIFY(planAccuracyStudy({}, StudiedSetting::accuracy, 9, 1).values.empty());
    }

    void theTableIsReadBack() {
        AccuracyPoint point;
        point.finder = RootFinder::certified;
        point.setting = 0.1;
        point.lost = 7;
        const CsvTable table =
            CsvTable::parse(accuracyTableHeader(StudiedSetting::maxGradient) + accuracyTableLine(point));
        QCOMPARE(table.rowCount(), std::size_t(1));
        QCOMPARE(table.number(0, "max_gradient", 0), 0.1);
        QCOMPARE(table.field(0, "missed"), std::string("7"));
        QCOMPARE(table.field(0, "solver"), std::string("certified"));
    }
};

QTEST_APPLESS_MAIN(AccuracyPlanTest)
#include "accuracy_plan_test.moc"
