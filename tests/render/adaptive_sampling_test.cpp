// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/adaptive_sampling.h"

#include <QTest>
#include <cmath>

using namespace isoscope;

namespace {

/// A picture that is white left of an upright edge.
struct Edge {
    double x = 0;
    double bright = 1, dark = 0;
    double background = 0;  ///< that shows on the right
    std::size_t samples = 0;

    AdaptiveSampling::Shade shade() {
        return [this](std::span<const SampleBatch::PixelPosition> places, std::vector<glm::dvec4>& colors) {
            samples += places.size();
            colors.clear();
            for (const SampleBatch::PixelPosition& place : places)
                colors.emplace_back(glm::dvec3(place.x < x ? bright : dark), place.x < x ? 0 : background);
            return true;
        };
    }
};

std::vector<PixelIndex> pixelsOf(int left, int right, int height) {
    std::vector<PixelIndex> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = left; x < right; ++x) pixels.push_back({x, y});
    return pixels;
}

Antialiasing settings(SamplingMethod method, int depth, double jitter = 0) {
    Antialiasing result;
    result.method = method;
    result.depth = depth;
    result.jitter = jitter;
    return result;
}

/// The pixels 0 to 7 of a row, of an 8 x 4 picture.
std::vector<float> row(const Antialiasing& how, Edge& edge) {
    std::vector<LinearColor> colors(32);
    if (!AdaptiveSampling(how, 8, 4).draw(pixelsOf(0, 8, 4), edge.shade(), colors)) return {};
    std::vector<float> result;
    for (std::size_t x = 0; x < 8; ++x) result.push_back(colors[8 + x][0]);
    return result;
}

struct Case {
    SamplingMethod method;
    int depth;
    double edge;  ///< how far into pixel 4
    float color;  ///< of pixel 4
};

/// Measured with POV-Ray 3.7.0.10: +A0.1 -J, +AM1 or +AM2, +R of the depth.
const std::vector<Case> cases{
    {SamplingMethod::adaptive, 3, 0.05, 0.0F}, {SamplingMethod::adaptive, 3, 0.2, 0.3F},
    {SamplingMethod::adaptive, 3, 0.6, 0.7F},  {SamplingMethod::adaptive, 3, 0.9, 1.0F},
    {SamplingMethod::adaptive, 2, 0.3, 0.4F},  {SamplingMethod::adaptive, 2, 0.6, 0.6F},
    {SamplingMethod::recursive, 1, 0.4, 0.5F}, {SamplingMethod::recursive, 2, 0.4, 0.25F},
    {SamplingMethod::recursive, 2, 0.6, 0.75F}};

}  // namespace

class AdaptiveSamplingTest : public QObject {
    Q_OBJECT

  private slots:
    void edgesAreAsSmoothAsInPovray() {
        for (const Case& item : cases) {
            Edge edge{4 + item.edge};
            const std::vector<float> colors = row(settings(item.method, item.depth), edge);
            QCOMPARE(colors.size(), std::size_t{8});
            QCOMPARE(colors[3], 1.0F);
            QCOMPARE(colors[4], item.color);
            QCOMPARE(colors[5], 0.0F);
        }
    }

    void evenPicturesCostHardlyMore() {
        Edge even{100};
        row(settings(SamplingMethod::adaptive, 3), even);
        QCOMPARE(even.samples, std::size_t{8 * 4});
        even.samples = 0;
        row(settings(SamplingMethod::recursive, 3), even);
        QCOMPARE(even.samples, std::size_t{9 * 5});
        // Both pixels at the edge get their grid, in each of the four rows.
        Edge edge{4.3};
        row(settings(SamplingMethod::adaptive, 3), edge);
        QCOMPARE(edge.samples, std::size_t{8 * 4 + 4 * 2 * 9});
    }

    void colorsAreComparedAsTheyLook() {
        // Sum of the channels at gamma 2.5: 0.905, and 0.277 for brighter ones, as in POV-Ray.
        Antialiasing how = settings(SamplingMethod::adaptive, 2);
        Edge darkEdge{4.6, 0.05, 0};
        how.threshold = 0.9;
        QVERIFY(row(how, darkEdge)[4] < 0.05F);
        how.threshold = 0.91;
        QCOMPARE(row(how, darkEdge)[4], 0.05F);
        Edge brightEdge{4.6, 0.3, 0.2};
        how.threshold = 0.27;
        QVERIFY(row(how, brightEdge)[4] < 0.3F);
        how.threshold = 0.28;
        QCOMPARE(row(how, brightEdge)[4], 0.3F);
    }

    void tilesFitTogether() {
        for (const SamplingMethod method : {SamplingMethod::adaptive, SamplingMethod::recursive})
            for (const double jitter : {0.0, 1.0}) {
                const AdaptiveSampling sampling(settings(method, 3, jitter), 8, 4);
                Edge edge{4.02};
                std::vector<LinearColor> whole(32), left(16), right(16);
                QVERIFY(sampling.draw(pixelsOf(0, 8, 4), edge.shade(), whole));
                QVERIFY(sampling.draw(pixelsOf(0, 4, 4), edge.shade(), left));
                QVERIFY(sampling.draw(pixelsOf(4, 8, 4), edge.shade(), right));
                for (std::size_t y = 0; y < 4; ++y)
                    for (std::size_t x = 0; x < 8; ++x)
                        QVERIFY(whole[8 * y + x] == (x < 4 ? left[4 * y + x] : right[4 * y + x - 4]));
            }
    }

    void jitterMovesSamplesWithinTheirStep() {
        const auto inPlace = [](std::span<const SampleBatch::PixelPosition> places,
                                std::vector<glm::dvec4>& colors) {
            colors.clear();
            for (const SampleBatch::PixelPosition& place : places)
                colors.emplace_back(
                    glm::dvec3(place.x > -0.2 && place.x < 8.2 && place.y > -0.2 && place.y < 4.2
                                   ? std::fmod(17 * place.x, 1)
                                   : NAN),
                    0);
            return true;
        };
        std::vector<LinearColor> colors(32);
        QVERIFY(AdaptiveSampling(settings(SamplingMethod::adaptive, 3, 1), 8, 4)
                    .draw(pixelsOf(0, 8, 4), inPlace, colors));
        for (const LinearColor& color : colors) QVERIFY(color[0] > 0 && color[0] < 1);
    }

    /// A black surface on a black background that is seen through: the edge is as smooth as that of colours.
    void whatOfTheBackgroundIsSeenIsSmoothToo() {
        for (const Case& item : cases) {
            Edge edge{4 + item.edge, 0, 0, 1};
            std::vector<LinearColor> colors(32);
            std::vector<float> background(32);
            QVERIFY(AdaptiveSampling(settings(item.method, item.depth), 8, 4)
                        .draw(pixelsOf(0, 8, 4), edge.shade(), colors, background));
            QCOMPARE(background[8 + 3], 0.0F);
            QCOMPARE(background[8 + 4], 1.0F - item.color);
            QCOMPARE(background[8 + 5], 1.0F);
        }
    }

    void aStopIsPassedOn() {
        std::vector<LinearColor> colors(32);
        const auto stopped = [](std::span<const SampleBatch::PixelPosition>, std::vector<glm::dvec4>&) {
            return false;
        };
        for (const SamplingMethod method : {SamplingMethod::adaptive, SamplingMethod::recursive})
            QVERIFY(!AdaptiveSampling(settings(method, 3), 8, 4).draw(pixelsOf(0, 8, 4), stopped, colors));
    }
};

QTEST_APPLESS_MAIN(AdaptiveSamplingTest)
#include "adaptive_sampling_test.moc"
