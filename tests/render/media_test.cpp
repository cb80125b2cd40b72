// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/scene/medium.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::costOf, test::find, test::requestFor;

namespace {

const std::string view = "camera { orthographic location -5*z right 0.1*x up 0.1*y } ";

/// A box around the origin, of length 2 along the line of sight, filled with media.
std::string filled(const std::string& media, const std::string& modifiers = "hollow") {
    return "box { -1, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { " + media + " } " +
           modifiers + " }";
}

/// The middle of the picture of a scene in the colours of the scene.
std::array<float, 3> seen(const std::string& text, int side = 8) {
    const ParseResult parsed = parseScene("global_settings { assumed_gamma 1 }" + view + text);
    RenderRequest request = requestFor(parsed);
    request.width = request.height = side;
    const Image image = renderImage(request, 1);
    const auto& pixel = image.pixels[static_cast<std::size_t>(side / 2 * side + side / 2)];
    return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace

class MediaTest : public QObject {
    Q_OBJECT

  private slots:
    void takeAndGiveLightAlongTheWay_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        const auto row = [](const std::string& text, double value) {
            QTest::newRow(text.c_str()) << QString::fromStdString(text) << value;
        };
        const std::string white = "background { rgb 1 }";
        row(white + filled("media { absorption 0.5 }"), std::exp(-1.0));
        row(white + filled("media { absorption 0.2 } media { absorption 0.3 }"), std::exp(-1.0));
        row(white + "light_source { 9, 0 }" + filled("media { scattering { 1, 1 extinction 0.25 } }"),
            std::exp(-0.5));
        row(white + filled("media { absorption 0.25 density { rgb 2 } density { rgb 0.5 } }"),
            std::exp(-0.5));
        row(filled("media { emission 0.1 }"), 0.2);
        row(filled("media { emission 0.1 }", "hollow scale 2"), 0.4);
        // Solid objects, and those within them, are not filled.
        row(filled("media { emission 0.1 }", ""), 0);
        row("sphere { 0, 3 pigment { rgbt 1 } }" + filled("media { emission 0.1 }"), 0);
        // Ten samples make six parts, dimmed by those before them.
        double sum = 0;
        for (int k = 0; k < 6; ++k) sum += 0.2 / 3 * std::exp(-1.5 * k / 3);
        row(filled("media { emission 0.2 absorption 1.5 }"), sum);
        // The other methods dim each part by half of itself as well.
        sum = 0;
        for (int k = 0; k < 6; ++k) sum += 0.2 / 3 * std::exp(-1.5 * (k + 0.5) / 3);
        row(filled("media { emission 0.2 absorption 1.5 method 2 intervals 2 samples 3 }"), sum);
        // Of several the first says how.
        row(filled("media { emission 0.2 absorption 1.5 method 2 intervals 2 samples 3 } media { method 3 }"),
            sum);
        // Density 1 in the further half; the last seventh is not looked at.
        row(filled("media { emission 0.3 aa_threshold 9 density { function { select(z, 0, 1) } } }"),
            0.3 / 3 * (2.0 / 3 + 2));
    }
    void takeAndGiveLightAlongTheWay() {
        QFETCH(QString, text);
        QFETCH(double, value);
        const auto pixel = seen(text.toStdString());
        for (const float channel : pixel)
            QVERIFY2(std::abs(channel - value) < 1e-6,
                     qPrintable(QString("%1, not %2").arg(channel).arg(value)));
    }

    void lightTurnsAsInPovray_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("cosine");
        QTest::addColumn<double>("value");
        const auto rows = [](int kind, double behind, double aside, double ahead) {
            QTest::addRow("%d behind", kind) << kind << -1.0 << behind;
            QTest::addRow("%d aside", kind) << kind << 0.0 << aside;
            QTest::addRow("%d ahead", kind) << kind << 1.0 << ahead;
        };
        rows(1, 1, 1, 1);
        rows(2, 0.577, 0.597, 5.766);
        rows(3, 0.496, 0.496, 25.28);
        rows(4, 1.599, 0.799, 1.599);
        rows(5, 0.414, 0.800, 2.653);
    }
    /// Read off POV-Ray's pictures of media between the eye and a light.
    void lightTurnsAsInPovray() {
        QFETCH(int, kind);
        QFETCH(double, cosine);
        QFETCH(double, value);
        Medium medium;
        medium.kind = static_cast<ScatteringKind>(kind);
        medium.eccentricity = 0.3;
        QVERIFY(std::abs(phaseFunction(medium, cosine) / value - 1) < 2e-3);
    }

    void onlyLightsWithShadowsAreScattered() {
        const std::string haze = filled("media { scattering { 1, 0.05 extinction 0 } }");
        const auto by = [&](const std::string& items) {
            return seen("light_source { 1000*x, 1 " + items + " }" + haze)[0];
        };
        QVERIFY(std::abs(by("") - 0.1F) < 1e-6F);
        QCOMPARE(by("shadowless"), 0.0F);
        QCOMPARE(by("media_interaction off"), 0.0F);
        const RenderStatistics cost = costOf(view + "light_source { 1000*x, 1 } plane { z, -8 }" + haze);
        QVERIFY(find(cost, StageKind::shadows)->rays > std::uint64_t{13 * 160 * 120 / 2});
    }

    /// Measured on POV-Ray's pictures: the mean of the types, whatever the media scatter.
    void mediaTogetherTurnLightByTheMeanOfTheirTypes() {
        const auto by = [](const std::string& media) {
            return seen("light_source { 1000*x, 1 }" + filled(media))[0];
        };
        const std::string four = "media { scattering { 4, 0.02 extinction 0 } }";
        const std::string one = "media { scattering { 1, 0.05 extinction 0 } }";
        QVERIFY(std::abs(by(one + four) - 0.12596F) < 2e-5F);
        QVERIFY(std::abs(by(four + one) - 0.12596F) < 2e-5F);
        QVERIFY(std::abs(by(four) - 0.03197F) < 2e-5F);
        QVERIFY(std::abs(by(four + "media { absorption 0 }") - 0.03599F) < 2e-5F);
    }

    void lightsOfAGroupReachItsMedia() {
        const std::string light = "light_source { 1000*x, 1 }";
        const std::string haze = filled("media { scattering { 1, 0.05 extinction 0 } }");
        QVERIFY(seen("light_group { " + light + haze + "}")[0] > 0.09F);
        QCOMPARE(seen("light_group { " + light + "sphere { 9, 1 } }" + haze)[0], 0.0F);
        QCOMPARE(seen(light + "light_group { light_source { y, 0 } " + haze + "}")[0], 0.0F);
        QVERIFY(seen(light + "light_group { light_source { y, 0 } " + haze + " global_lights }")[0] > 0.09F);
    }

    /// Samples go where the light is.
    void beamsDivideTheWay() {
        const std::string beam =
            "light_source { -50*x, 1 cylinder point_at 0 radius 0.5 falloff 0.5 tightness 0 }";
        const std::string haze = filled("media { scattering { 1, 0.1 extinction 0 } samples 1 method 2 }");
        QVERIFY(std::abs(seen(beam + haze)[0] - 0.1F) < 1e-4F);
        QVERIFY(std::abs(seen("light_source { -50*x, 0 }" + beam + haze)[0] - 0.2F) < 1e-6F);
    }

    /// Ways to lights were looked at from where none of their light is seen.
    void onlyWhatIsLitAsksWhatMediaLeave() {
        const auto values = [](const std::string& items) {
            return find(costOf("camera { location <0, 1, -5> look_at 0 } plane { y, -1 pigment { rgb 1 } }"
                               "media { absorption 0.1 density { bozo } } light_source { <0, -9, 0>, 1 "
                               "media_interaction off " +
                               items + " }"),
                        StageKind::media)
                ->evaluations;
        };
        QVERIFY(values("") > 0);
        QCOMPARE(values("media_attenuation on"), values(""));
    }

    void scenesWithoutMediaPayForNone() {
        const RenderStatistics cost =
            costOf("sphere { 5*z, 1 hollow interior { ior 1.5 } } light_source { 0, 1 }");
        QVERIFY(!find(cost, StageKind::media));
    }

    void tellTheirLine() {
        QCOMPARE(find(costOf("sphere { 5*z, 1 }\nmedia { absorption 0.1 }"), StageKind::media)->reason,
                 std::string("media at line 2 fill all space"));
        QCOMPARE(find(costOf("\n\n" + filled("media { absorption 0.1 }")), StageKind::media)->reason,
                 std::string("media at line 3 fill an object"));
    }

    void canBeLeftOut() {
        const std::string scene =
            "light_source { <5, 9, -5>, 1 } plane { y, -2 pigment { checker rgb 0 rgb 1 } }";
        RenderRequest without =
            requestFor(parseScene(scene + filled("media { scattering { 1, 1 } }", "hollow translate 5*z")));
        const RenderRequest plain = requestFor(parseScene(scene + filled("", "hollow translate 5*z")));
        QVERIFY(renderImage(without, 1).pixels != renderImage(plain, 1).pixels);
        without.leftOut.set(StageKind::media, true);
        QVERIFY(renderImage(without, 1).pixels == renderImage(plain, 1).pixels);
    }

    void doNotDependOnTheThreads() {
        const ParseResult parsed =
            parseScene("light_source { <5, 9, -5>, 1 } plane { y, -2 pigment { checker rgb 0 rgb 1 } }" +
                       filled("media { scattering { 2, 1 } density { granite } }", "hollow translate 5*z"));
        QVERIFY(renderImage(requestFor(parsed), 1).pixels == renderImage(requestFor(parsed), 3).pixels);
    }

    /// More samples than memory would hold are taken in groups, and the numbers have limits.
    void manySamplesEnd() {
        const auto pixel =
            seen(filled("media { emission 0.1 samples 1e9 intervals 1e9 aa_level 1e9 aa_threshold 1e-9 "
                        "density { granite } }"),
                 1);
        QVERIFY(pixel[0] > 0 && pixel[0] < 0.2F);
    }
};

QTEST_APPLESS_MAIN(MediaTest)
#include "media_test.moc"
