// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_histogram.h"

#include <cmath>
#include <numeric>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

GradientHistogram histogram(const std::string& settings) {
    return gradientHistogram(*studyScene("isosurface { " + settings + " }\n").scene, 0);
}

double sum(const std::vector<double>& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

/// Share of the bins that end at or below `limit`.
double below(const GradientHistogram& h, const std::vector<double>& shares, double limit) {
    double share = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) share += h.edges[k + 1] <= limit ? shares[k] : 0;
    return share;
}

}  // namespace

class GradientHistogramTest : public QObject {
    Q_OBJECT

  private slots:
    void aSphereIsAsItMustBe() {
        // |grad| = 2 r: the share of the ball of radius 1.2 with 2 r < g is (g / 2.4)^3.
        const GradientHistogram h =
            histogram("function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } }");
        QVERIFY(!h.empty());
        QVERIFY(std::abs(sum(h.container) - 1) < 1e-9 && std::abs(sum(h.surface) - 1) < 1e-9);
        for (const double limit : {0.8, 1.2, 1.8, 2.2}) {
            // The last edge at or below the limit.
            double edge = 0;
            for (const double e : h.edges)
                if (e <= limit) edge = e;
            QVERIFY(std::abs(below(h, h.container, limit) - std::pow(edge / 2.4, 3)) < 0.02);
        }
        QVERIFY(std::abs(h.edges.back() - 2.4) < 0.05);
        // On the surface it is 2 everywhere: one bin, or two beside each other.
        for (std::size_t k = 0; k < h.surface.size(); ++k)
            if (h.surface[k] > 0) QVERIFY(h.edges[k] < 2.0001 && h.edges[k + 1] > 1.9999);
        // 6000 lines through a ball of radius 1.2 sqrt(3): one in 4.32 meets the unit sphere, twice.
        QVERIFY(std::abs(static_cast<double>(h.surfaceSamples) - 12000 / 4.32) < 200);
        QCOMPARE(h.infinite, std::uint64_t(0));
    }

    void theSurfaceIsSampledEvenlyByArea() {
        // The cylinder's wall (gradient 2) and the slab's faces (gradient 1), of areas 2 pi 0.5 0.8 and 2 pi
        // 0.25.
        const GradientHistogram h = histogram(
            "function { max(2*(sqrt(x*x + y*y) - 0.5), abs(z) - 0.4) } contained_by { box { -1, 1 } }");
        const double faces = below(h, h.surface, 1.4);
        QVERIFY2(std::abs(faces - 0.25 / (0.25 + 0.4)) < 0.03, qPrintable(QString::number(faces)));
    }

    void anEvenSlopeIsOneBin() {
        const GradientHistogram h = histogram("function { 3*x } contained_by { box { -1, 1 } }");
        std::size_t used = 0;
        for (const double share : h.container) used += share > 0;
        QVERIFY(used >= 1 && used <= 2);
        QVERIFY(h.edges.front() < 3 && h.edges.back() > 3);
    }

    void whatHasNoGradientGivesNone() {
        QVERIFY(histogram("function { 1 } contained_by { box { -1, 1 } }").empty());
        QVERIFY(histogram("function { sqrt(-1 - x*x) } contained_by { box { -1, 1 } }").empty());
        QVERIFY(gradientHistogram(Scene{}, 0).empty());
        std::stop_source stop;
        stop.request_stop();
        const auto scene = studyScene("isosurface { function { x } }\n").scene;
        QVERIFY(gradientHistogram(*scene, 0, stop.get_token()).empty());
    }

    void withoutSurfaceItsSharesAreZero() {
        const GradientHistogram h = histogram("function { x + 9 } contained_by { box { -1, 1 } }");
        QVERIFY(!h.empty());
        QCOMPARE(h.surfaceSamples, std::uint64_t(0));
        QCOMPARE(sum(h.surface), 0.0);
    }
};

QTEST_APPLESS_MAIN(GradientHistogramTest)
#include "gradient_histogram_test.moc"
