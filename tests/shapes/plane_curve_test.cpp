// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/plane_curve.h"

#include <algorithm>
#include <QTest>

using namespace isoscope;

class PlaneCurveTest : public QObject {
    Q_OBJECT

  private slots:
    /// Whichever way the pieces run: their ends on one level are known up to rounding only.
    void aLineThroughJointsCrossesOnce() {
        const std::vector<glm::dvec2> points{
            {0, 1},  {0.6, 1},   {1, 0.6},   {1, 0},  {1, 0},  {1, -0.6},   {0.6, -1},   {0, -1},
            {0, -1}, {-0.6, -1}, {-1, -0.6}, {-1, 0}, {-1, 0}, {-0.4, 0.2}, {-0.3, 0.8}, {0, 1}};
        for (const bool reversed : {false, true}) {
            std::vector<glm::dvec2> run(points);
            for (std::size_t i = 0; reversed && i < run.size(); i += 4)
                std::reverse(run.begin() + static_cast<std::ptrdiff_t>(i),
                             run.begin() + static_cast<std::ptrdiff_t>(i + 4));
            const Outline outline(curveThrough(SplineKind::bezier, run));
            QVERIFY(!outline.covers({-1.06, 0}));
            QVERIFY(!outline.covers({1.06, 0}));
            QVERIFY(outline.covers({-0.9, 0}));
            QVERIFY(outline.covers({0.9, 0}));
        }
    }
};

QTEST_APPLESS_MAIN(PlaneCurveTest)
#include "plane_curve_test.moc"
