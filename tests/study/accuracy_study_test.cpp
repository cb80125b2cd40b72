// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/accuracy_study.h"

#include <algorithm>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

AccuracyStudyRequest torusStudy(StudiedSetting setting, std::vector<double> values) {
    AccuracyStudyRequest request;
    request.view = studyScene(
        "isosurface { function { f_torus(x,y,z,0.8,0.25) } contained_by { box { -1.1, 1.1 } } max_gradient 1 "
        "}\n",
        64, 48);
    request.setting = setting;
    request.values = std::move(values);
    return request;
}

std::vector<AccuracyPoint> measure(AccuracyStudyRequest request) {
    AccuracyStudy study(std::move(request));
    std::vector<AccuracyPoint> points;
    while (const auto point = study.next()) points.push_back(*point);
    return points;
}

}  // namespace

class AccuracyStudyTest : public QObject {
    Q_OBJECT

  private slots:
    void finerAccuracyIsDearerAndMoreExact() {
        const auto points = measure(torusStudy(StudiedSetting::accuracy, {1e-2, 1e-5, 1e-8}));
        QCOMPARE(points.size(), std::size_t(6));
        for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
            std::vector<AccuracyPoint> own;
            std::copy_if(points.begin(), points.end(), std::back_inserter(own),
                         [&](const AccuracyPoint& point) { return point.finder == finder; });
            QCOMPARE(own.size(), std::size_t(3));
            for (std::size_t k = 0; k < 3; ++k) {
                QVERIFY(own[k].worstError <= own[k].setting * 1.001 && own[k].meanError <= own[k].worstError);
                QCOMPARE(own[k].lost + own[k].gained + own[k].wrongPlace, std::uint64_t(0));
                QVERIFY(own[k].cpuSeconds > 0 && own[k].evaluationsPerPixel > 0);
                QVERIFY(k == 0 || own[k].evaluations > own[k - 1].evaluations);
            }
        }
        // POV-Ray's method only halves its way to the accuracy.
        QVERIFY(points[0].worstError > 1e-4 && points[4].worstError < 1e-8 * 1.001);
    }

    void aLowMaxGradientLosesPixelsWithOneFinderAlone() {
        const auto points = measure(torusStudy(StudiedSetting::maxGradient, {0.1, 1, 10}));
        QCOMPARE(points.size(), std::size_t(6));
        QVERIFY(points[0].lost + points[0].wrongPlace > 50 && points[0].changed > 50);
        for (std::size_t k = 1; k < 6; ++k) QCOMPARE(points[k].lost + points[k].wrongPlace, std::uint64_t(0));
        QVERIFY(points[4].evaluations > 4 * points[2].evaluations);
        QCOMPARE(points[5].evaluations, points[3].evaluations);
    }

    void valuesComeCoarseFirst() {
        const std::vector<double> values = studyValues(1e-1, 1e-9, 9);
        QCOMPARE(values.size(), std::size_t(9));
        QCOMPARE(values[0], 1e-1);
        QCOMPARE(values[1], 1e-9);
        QVERIFY(std::abs(values[2] / 1e-5 - 1) < 1e-9);
        std::vector<double> sorted = values;
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t k = 1; k < 9; ++k) QVERIFY(std::abs(sorted[k] / sorted[k - 1] - 10) < 1e-9);
        QCOMPARE(studyValues(2, 5, 1), std::vector<double>{2});
        QVERIFY(studyValues(0, 1, 5).empty() && studyValues(1, INFINITY, 5).empty() &&
                studyValues(1, 2, 0).empty());
        for (int count = 2; count < 40; ++count)
            QCOMPARE(studyValues(1, 2, count).size(), std::size_t(count));
    }

    void tellsHowFarItIsWithinOnePicture() {
        AccuracyStudy study(torusStudy(StudiedSetting::accuracy, {1e-3}));
        std::vector<double> shares;
        const ShareReport report = [&](double share) { shares.push_back(share); };
        QVERIFY(study.next({}, report).has_value());
        QVERIFY(study.next({}, report).has_value());
        // Nine pictures of 48 small tiles each.
        QCOMPARE(shares.size(), std::size_t(9 * 48));
        for (std::size_t k = 1; k < shares.size(); ++k) QVERIFY(shares[k] > shares[k - 1]);
        QCOMPARE(shares.back(), 1.0);
    }

    /// A picture that would take minutes ends with the stop request, and has told how far it was.
    void stopsWithinOnePicture() {
        AccuracyStudyRequest request = torusStudy(StudiedSetting::maxGradient, {1e9});
        request.view = studyScene(
            "isosurface { function { f_torus(x,y,z,0.8,0.25) + sum(i, 1, 20000, sin(i*x)*1e-9) } "
            "contained_by { "
            "box { -1.1, 1.1 } } max_gradient 1 }\n",
            400, 300);
        AccuracyStudy study(request);
        std::stop_source source;
        std::size_t reports = 0;
        const auto point = study.next(source.get_token(), [&](double share) {
            ++reports;
            QVERIFY(share > 0 && share < 0.1);
            source.request_stop();
        });
        QVERIFY(!point.has_value());
        QVERIFY(reports >= 1 && reports <= 130);
    }

    void stopsBetweenPoints() {
        AccuracyStudy study(torusStudy(StudiedSetting::accuracy, {1e-3, 1e-4}));
        QCOMPARE(study.size(), std::size_t(4));
        QVERIFY(study.next().has_value());
        std::stop_source source;
        source.request_stop();
        QVERIFY(!study.next(source.get_token()).has_value());
        QVERIFY(study.next().has_value());
        AccuracyStudy nothing{AccuracyStudyRequest{}};
        QVERIFY(!nothing.next().has_value());
    }
};

QTEST_APPLESS_MAIN(AccuracyStudyTest)
#include "accuracy_study_test.moc"
