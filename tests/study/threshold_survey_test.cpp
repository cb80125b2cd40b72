// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/threshold/threshold_survey.h"

#include <cmath>
#include <numeric>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Scene> sceneOf(const std::string& settings) {
    return studyScene("isosurface { " + settings + " }\n").scene;
}

ValueHistogram histogramOf(const std::string& settings) {
    const auto scene = sceneOf(settings);
    return valueHistogram(*scene->isosurfaces.at(0).shape, *scene->parameterTable);
}

}  // namespace

class ThresholdSurveyTest : public QObject {
    Q_OBJECT

  private slots:
    void anEvenSlopeFillsAllBinsAlike() {
        const ValueHistogram h = histogramOf("function { 3*x } contained_by { box { -1, 1 } }");
        QVERIFY(std::abs(h.edges.front() + 3) < 0.01 && std::abs(h.edges.back() - 3) < 0.01);
        for (const double share : h.shares) QVERIFY(std::abs(share * 60 - 1) < 0.1);
        QVERIFY(std::abs(std::accumulate(h.shares.begin(), h.shares.end(), 0.0) - 1) < 1e-9);
    }

    void rareValuesAreLeftOut() {
        const ValueHistogram h =
            histogramOf("function { 1/(x*x + y*y + z*z) } contained_by { box { -1, 1 } }");
        QVERIFY(h.edges.back() < 100);
        QVERIFY(std::accumulate(h.shares.begin(), h.shares.end(), 0.0) > 0.98);
    }

    void oneValueIsABinAndNoneAreNothing() {
        const ValueHistogram h = histogramOf("function { 2 } contained_by { box { -1, 1 } }");
        QVERIFY(h.edges.front() < 2 && h.edges.back() > 2);
        QVERIFY(histogramOf("function { sqrt(-1 - x*x) } contained_by { box { -1, 1 } }").empty());
        QVERIFY(histogramOf("function { x*1e308*10*y } contained_by { box { 1, 2 } }").empty());
        QVERIFY(!histogramOf("function { x*1e308 } contained_by { box { -1, 1 } }").empty());
    }

    void theReportsEndWithThePoints() {
        const auto scene =
            sceneOf("function { cos(pi*x) + cos(pi*y) + cos(pi*z) } contained_by { box { -1.4, 2.4 } }");
        std::vector<ThresholdSurvey> reports;
        surveyThresholds(*scene, 0, {}, [&](const ThresholdSurvey& survey) { reports.push_back(survey); });
        QVERIFY(reports.size() >= 2);
        QVERIFY(!reports.front().histogram.empty() && !reports.front().complete);
        QVERIFY(reports.back().complete && reports.back().progress == 1);
        const std::vector<ThresholdTick> ticks = thresholdTicks(reports.back().critical);
        QCOMPARE(ticks.size(), std::size_t(4));
        const std::size_t counts[] = {8, 24, 24, 8};
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(std::abs(ticks[i].value - (-3 + 2 * static_cast<double>(i))) < 1e-9 && ticks[i].proven());
            QCOMPARE(ticks[i].points.size(), counts[i]);
        }
    }

    void provenPointsComeFirstInATick() {
        CriticalPoints critical;
        CriticalPoint point;
        point.value = 1;
        point.reason = SuspicionReason::kink;
        critical.points.push_back(point);
        point.value = 1 + 1e-9;
        point.reason = SuspicionReason::none;
        critical.points.push_back(point);
        point.value = std::nan("");
        critical.points.push_back(point);
        const std::vector<ThresholdTick> ticks = thresholdTicks(critical);
        QCOMPARE(ticks.size(), std::size_t(1));
        QVERIFY(ticks[0].proven() && ticks[0].value == 1 + 1e-9 && ticks[0].points.size() == 2);
    }

    void whatIsStoppedOrMissingReportsNothing() {
        const auto scene = sceneOf("function { x } contained_by { box { -1, 1 } }");
        std::stop_source stop;
        stop.request_stop();
        int reports = 0;
        const auto count = [&](const ThresholdSurvey&) { ++reports; };
        surveyThresholds(*scene, 0, {}, count, stop.get_token());
        surveyThresholds(*scene, 7, {}, count);
        QCOMPARE(reports, 0);
    }
};

QTEST_GUILESS_MAIN(ThresholdSurveyTest)
#include "threshold_survey_test.moc"
