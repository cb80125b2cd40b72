// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_survey.h"

#include <QTest>

#include "core/study/gradient/gradient_verdict.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

GradientSurveyRequest requestOf(const std::string& text, std::size_t isosurface = 0) {
    GradientSurveyRequest request;
    request.view = studyScene(text);
    request.isosurface = isosurface;
    return request;
}

const std::string sphere =
    "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } scale 0.5 translate 0.2*x "
    "}\n";

}  // namespace

class GradientSurveyTest : public QObject {
    Q_OBJECT

  private slots:
    void aSphereWithoutSetting() {
        std::vector<GradientSurvey> reports;
        surveyGradient(requestOf(sphere), [&](const GradientSurvey& survey) { reports.push_back(survey); });
        QVERIFY(reports.size() >= 2 && reports.back().finished && !reports.front().finished);
        const GradientSurvey& last = reports.back();
        QCOMPARE(last.setting, 1.1);
        QVERIFY(last.holes.mistakes() > 50);
        // On the unit sphere the gradient has the length 2, whatever the transformations.
        QVERIFY(std::abs(last.onSurface - 2) < 0.01 && std::abs(glm::length(last.steepestPoint) - 1) < 0.01);
        QVERIFY(last.alongRays > 0.5 && last.alongRays <= 2.4);
        QCOMPARE(suggestedGradient(last.bracket), 2.4);
        QVERIFY(last.enoughForView && *last.enoughForView > 1.1 && *last.enoughForView <= 2.4);
    }

    void whatIsEnoughLosesNothing() {
        double enough = 0;
        surveyGradient(requestOf(sphere),
                       [&](const GradientSurvey& survey) { enough = survey.enoughForView.value_or(0); });
        std::string tuned = sphere;
        tuned.insert(tuned.find(" scale"), " max_gradient " + std::to_string(enough));
        QCOMPARE(holeMap(studyScene(tuned)).mistakes(), std::uint64_t(0));
    }

    void eachIsosurfaceIsSurveyedByItself() {
        const std::string other =
            "isosurface { function { 3*y } contained_by { box { 1, 2 } } max_gradient 3 }\n";
        GradientSurvey last;
        surveyGradient(requestOf(sphere + other, 1), [&](const GradientSurvey& survey) { last = survey; });
        QCOMPARE(last.setting, 3.0);
        QCOMPARE(suggestedGradient(last.bracket), 3.0);
    }

    void nothingIsReportedWithoutSurfaceOrAfterAStop() {
        int reports = 0;
        const auto count = [&](const GradientSurvey&) { ++reports; };
        surveyGradient(requestOf("sphere { 0, 1 }"), count);
        surveyGradient(GradientSurveyRequest{}, count);
        std::stop_source source;
        source.request_stop();
        surveyGradient(requestOf(sphere), count, source.get_token());
        QCOMPARE(reports, 0);
    }
};

QTEST_APPLESS_MAIN(GradientSurveyTest)
#include "gradient_survey_test.moc"
