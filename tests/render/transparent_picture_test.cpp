// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numeric>
#include <QTest>

#include "core/render/render_image.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int width = 96, height = 72;

const char* const frame = R"(
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.4, 0.6> }
camera { location <0, 0, -4> look_at 0 angle 40 }
light_source { <-3, 5, -6> rgb 1 }
)";
const char* const ball =
    "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } "
    "max_gradient 4 pigment { rgb <0.9, 0.5, 0.1> } }";

RenderRequest requestFor(const std::string& objects) {
    RenderRequest request = test::requestFor(parseScene(frame + objects), width, height);
    request.rootFinder = RootFinder::certified;
    return request;
}

/// The largest distance between an ordinary picture and a transparent one laid over the background.
float farthestFromOverlaid(RenderRequest request) {
    const std::array<float, 3> background{0.2f, 0.4f, 0.6f};
    request.transparent = false;
    const Image usual = renderImage(request, 2);
    request.transparent = true;
    const Image clear = renderImage(request, 2);
    if (clear.opacity.size() != usual.pixels.size() || !usual.opacity.empty()) return HUGE_VALF;
    float farthest = 0;
    for (std::size_t i = 0; i < usual.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            farthest = std::max(
                farthest,
                std::abs(clear.pixels[i][c] + (1 - clear.opacity[i]) * background[c] - usual.pixels[i][c]));
    return farthest;
}

/// Of the ball, in pixels: its outline is a circle.
double outlineArea() {
    const double radius = std::tan(std::asin(0.25)) / std::tan(20 * M_PI / 180) * width / 2;
    return M_PI * radius * radius;
}

struct Coverage {
    int clear = 0, partly = 0, opaque = 0;
};

Coverage coverageOf(const Image& image) {
    Coverage coverage;
    for (const float opacity : image.opacity)
        ++(opacity == 0 ? coverage.clear : opacity == 1 ? coverage.opaque : coverage.partly);
    return coverage;
}

}  // namespace

class TransparentPictureTest : public QObject {
    Q_OBJECT

  private slots:
    void onlyObjectsAreOpaque() {
        RenderRequest request = requestFor(ball);
        request.transparent = true;
        const Image image = renderImage(request, 2);
        const Coverage coverage = coverageOf(image);
        QCOMPARE(coverage.partly, 0);
        QVERIFY2(std::abs(coverage.opaque - outlineArea()) < 0.02 * outlineArea(),
                 qPrintable(QString::number(coverage.opaque)));
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            if (image.opacity[i] == 0) QVERIFY((image.pixels[i] == std::array<float, 3>{}));
    }

    void overTheBackgroundItIsTheUsualPicture_data() {
        QTest::addColumn<QString>("objects");
        QTest::addColumn<bool>("smooth");
        const QString glass =
            "sphere { <0.6, 0, -1>, 0.6 texture { pigment { rgbf <0.8, 0.9, 1, 0.7> } finish { "
            "reflection 0.3 } } interior { ior 1.3 } }";
        for (const bool smooth : {false, true}) {
            const char* const how = smooth ? ", smooth" : "";
            QTest::addRow("ball%s", how) << QString(ball) << smooth;
            QTest::addRow("nothing%s", how) << QString() << smooth;
            QTest::addRow("glass%s", how) << ball + glass << smooth;
            QTest::addRow("mirror%s", how)
                << QString("sphere { 0, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }") << smooth;
            QTest::addRow("fog%s", how)
                << ball + QString("fog { distance 9 color rgb <0.7, 0.7, 0.8> }") << smooth;
        }
    }
    /// Colours are what the objects add to what is behind: exact for edges, glass and fog. Light that glass
    /// tints is one number of opacity, so that coloured glass is off by its tint.
    void overTheBackgroundItIsTheUsualPicture() {
        QFETCH(QString, objects);
        QFETCH(bool, smooth);
        RenderRequest request = requestFor(objects.toStdString());
        request.antialias = smooth;
        const float allowed = objects.contains("rgbf") ? 0.05f : 1e-5f;
        const float farthest = farthestFromOverlaid(request);
        QVERIFY2(farthest < allowed, qPrintable(QString::number(farthest)));
    }

    void edgesAreSmoothByEveryMethod() {
        RenderRequest request = requestFor(ball);
        request.transparent = true;
        request.antialias = true;
        for (const SamplingMethod method :
             {SamplingMethod::box, SamplingMethod::adaptive, SamplingMethod::recursive}) {
            request.antialiasing.method = method;
            const Image image = renderImage(request, 2);
            const Coverage coverage = coverageOf(image);
            QVERIFY2(coverage.partly > 120 && coverage.partly < 300,
                     qPrintable(QString::number(coverage.partly)));
            const double covered = std::accumulate(image.opacity.begin(), image.opacity.end(), 0.0);
            QVERIFY2(std::abs(covered - outlineArea()) < 0.01 * outlineArea(),
                     qPrintable(QString::number(covered)));
            // Nowhere is a pixel brighter than what hides the background.
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                QVERIFY(image.pixels[i][0] <= image.opacity[i] + 1e-5f);
        }
    }

    void blurReachesOverTheEdge() {
        RenderRequest request = requestFor(ball);
        request.transparent = true;
        request.camera.blur.aperture = 0.4;
        request.camera.blur.samples = 24;
        request.camera.blur.focalPoint = {0, 0, 3};
        auto scene = std::make_shared<Scene>(*request.scene);
        scene->camera = request.camera;
        request.scene = scene;
        const Coverage coverage = coverageOf(renderImage(request, 2));
        QVERIFY2(coverage.partly > 250 && coverage.opaque > 100,
                 qPrintable(QString::number(coverage.partly)));
    }

    /// What a mirror shows is part of the mirror.
    void mirrorsShowTheSky() {
        RenderRequest request = requestFor(
            "sphere { 0, 1 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }"
            "sky_sphere { pigment { rgb <0.1, 0.2, 0.9> } }");
        request.transparent = true;
        const Image image = renderImage(request, 2);
        const std::size_t middle = static_cast<std::size_t>(height / 2 * width + width / 2);
        QCOMPARE(image.opacity[middle], 1.0f);
        QVERIFY(image.pixels[middle][2] > 0.8f);
        QCOMPARE(image.opacity.front(), 0.0f);
        QCOMPARE(image.pixels.front()[2], 0.0f);
    }

    void threadsDoNotChangeIt() {
        RenderRequest request = requestFor(ball);
        request.transparent = true;
        request.antialias = true;
        const Image one = renderImage(request, 1), many = renderImage(request, 5);
        QVERIFY(one.pixels == many.pixels && one.opacity == many.opacity);
    }
};

QTEST_APPLESS_MAIN(TransparentPictureTest)
#include "transparent_picture_test.moc"
