// SPDX-License-Identifier: GPL-3.0-or-later
// What the statements of a scene beside textures and lights become: of each text, every member that is not
// what it is by default.
#include "tests/language/told_members.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string description(const GlobalSettings& settings) {
    const GlobalSettings usual;
    Differences all;
    all.add("gamma", settings.assumedGamma, usual.assumedGamma);
    all.add("noise", settings.noiseGenerator, usual.noiseGenerator);
    all.add("levels", settings.maxTraceLevel, usual.maxTraceLevel);
    all.add("bailout", settings.adcBailout, usual.adcBailout);
    all.add("waves", settings.numberOfWaves, usual.numberOfWaves);
    all.add("ambient", settings.ambientLight, usual.ambientLight);
    all.add("irid", settings.iridWavelength, usual.iridWavelength);
    return all.text();
}

std::string description(const Fog& fog) {
    const Fog usual;
    Differences all;
    all.add("ground", fog.ground, usual.ground);
    all.add("distance", fog.distance, usual.distance);
    all.add("color", fog.color, usual.color);
    all.add("up", fog.up, usual.up);
    all.add("offset", fog.offset, usual.offset);
    all.add("altitude", fog.altitude, usual.altitude);
    all.add("turbulence", fog.turbulence, usual.turbulence);
    all.add("depth", fog.turbulenceDepth, usual.turbulenceDepth);
    all.add("octaves", fog.octaves, usual.octaves);
    all.add("omega", fog.omega, usual.omega);
    all.add("lambda", fog.lambda, usual.lambda);
    all.put("line " + told(fog.line));
    return all.text();
}

std::string description(const Rainbow& rainbow) {
    const Rainbow usual;
    Differences all;
    all.add("direction", rainbow.direction, usual.direction);
    all.add("up", rainbow.up, usual.up);
    all.add("angle", rainbow.angle, usual.angle);
    all.add("width", rainbow.width, usual.width);
    all.add("distance", rainbow.distance, usual.distance);
    all.add("jitter", rainbow.jitter, usual.jitter);
    all.add("arc", rainbow.arcAngle, usual.arcAngle);
    all.add("falloff", rainbow.falloffAngle, usual.falloffAngle);
    const auto* colors = std::get_if<std::shared_ptr<const MappedPigment>>(&rainbow.colors.pigment);
    all.put(told(colors ? static_cast<int>((*colors)->entries.size()) : 1) + " colors");
    all.put("line " + told(rainbow.line));
    return all.text();
}

std::string description(const Medium& medium) {
    const Medium usual;
    Differences all;
    all.add("absorption", medium.absorption, usual.absorption);
    all.add("emission", medium.emission, usual.emission);
    all.add("scattering", medium.scattering, usual.scattering);
    all.add("kind", static_cast<int>(medium.kind), static_cast<int>(usual.kind));
    all.add("eccentricity", medium.eccentricity, usual.eccentricity);
    all.add("extinction", medium.extinction, usual.extinction);
    all.add("adaptive", medium.adaptive, usual.adaptive);
    all.add("intervals", medium.intervals, usual.intervals);
    all.add("samples", medium.samples, usual.samples);
    all.add("level", medium.refinements, usual.refinements);
    all.add("threshold", medium.threshold, usual.threshold);
    for (std::size_t k = 0; k < medium.layers(); ++k)
        all.put(std::holds_alternative<SolidPigment>((*medium.densities)[k].pigment) ? "even density"
                                                                                     : "density");
    all.put("line " + told(medium.line));
    return all.text();
}

std::string description(const Interior& interior) {
    const Interior usual;
    Differences all;
    all.add("ior", interior.ior, usual.ior);
    all.add("caustics", interior.caustics, usual.caustics);
    all.add("dispersion", interior.dispersion, usual.dispersion);
    all.add("samples", interior.dispersionSamples, usual.dispersionSamples);
    all.add("distance", interior.fadeDistance, usual.fadeDistance);
    all.add("power", interior.fadePower, usual.fadePower);
    all.add("color", interior.fadeColor, usual.fadeColor);
    all.add("hollow", interior.hollow, usual.hollow);
    for (const auto& medium : interior.media) all.put("media " + description(*medium));
    return all.text();
}

std::string description(const SceneObject& object) {
    const SceneObject usual;
    Differences all;
    all.add("shadow", object.castsShadow, usual.castsShadow);
    all.add("visible", object.visible, usual.visible);
    all.add("reflected", object.reflected, usual.reflected);
    all.add("hollow", object.hollow, usual.hollow);
    all.add("both sides", object.doubleIlluminate, usual.doubleIlluminate);
    all.add("transparent", object.transparent, usual.transparent);
    all.add("bends", object.bendsLight, usual.bendsLight);
    all.add("mirrors", object.reflective, usual.reflective);
    all.put(object.name + " in line " + told(object.line));
    return all.text();
}

std::string description(const Camera& camera) {
    const Camera usual;
    Differences all;
    all.add("kind", static_cast<int>(camera.kind), static_cast<int>(usual.kind));
    all.add("at", camera.location, usual.location);
    all.add("along", camera.direction, usual.direction);
    all.add("right", camera.right, usual.right);
    all.add("up", camera.up, usual.up);
    all.add("sky", camera.sky, usual.sky);
    all.add("angle", camera.angle, usual.angle);
    all.add("vertical", camera.verticalAngle, usual.verticalAngle);
    all.add("aperture", camera.blur.aperture, usual.blur.aperture);
    all.add("samples", camera.blur.samples, usual.blur.samples);
    all.add("focus", camera.blur.focalPoint, usual.blur.focalPoint);
    all.add("confidence", camera.blur.confidence, usual.blur.confidence);
    all.add("variance", camera.blur.variance, usual.blur.variance);
    if (!camera.normalText.empty()) all.put(camera.normalText);
    return all.text();
}

}  // namespace

class SceneValuesTest : public QObject {
    Q_OBJECT

  private slots:
    void settings_data() {
        columns();
        row("assumed_gamma 2.2", "gamma 2.2");
        row("assumed_gamma srgb", "gamma 0");
        row("noise_generator 1", "noise 1");
        row("noise_generator 3.5", "noise 3");
        row("max_trace_level 12", "levels 12");
        row("max_trace_level 0", "levels 1");
        row("max_trace_level 1000", "levels 256");
        row("number_of_waves 20", "waves 20");
        row("number_of_waves 0", "waves 1");
        row("number_of_waves 5000", "waves 1000");
        row("adc_bailout 0.25", "bailout 0.25");
        row("adc_bailout -1", "bailout 0");
        row("ambient_light rgb <0.5, 0.25, 0>", "ambient 0.5 0.25 0");
        row("irid_wavelength rgb <0.5, 0.25, 0>", "irid 0.5 0.25 0");
        row("hf_gray_16 max_trace_level 7", "levels 7");
        row("hf_gray_16 on max_trace_level 7", "levels 7");
        row("max_intersections 64 mm_per_unit 10 max_trace_level 7", "levels 7");
        row("charset utf8 max_trace_level 7", "levels 7");
        row("radiosity { count 10 } max_trace_level 7", "levels 7");
        row("photons { count 10 } max_trace_level 7", "levels 7");
        row("subsurface { samples 2, 3 } max_trace_level 7", "levels 7");
        row("radiosity max_trace_level 7", "levels 7");
    }
    void settings() {
        check("global_settings { ", " }",
              [](const ParseResult& parsed) { return description(parsed.scene->settings); });
    }

    void fogs_data() {
        columns();
        row("fog { distance 10 color rgb 0.5 }", "distance 10, color 0.5 0.5 0.5, line 1");
        row("fog { distance 10 rgb <1, 0.5, 0.25> }", "distance 10, color 1 0.5 0.25, line 1");
        row("fog { fog_type 2 distance 10 fog_offset 1 fog_alt 2 color rgbft <1, 1, 1, 0.5, 0.25> }",
            "ground yes, distance 10, color 1 1 1 filter 0.5 transmit 0.25, offset 1, altitude 2, line 1");
        row("fog { fog_type 1 distance 10 }", "distance 10, line 1");
        row("fog { fog_type 2 up <0, 0, 1> distance 10 }", "ground yes, distance 10, up 0 0 1, line 1");
        row("fog { up y distance 10 rotate 90*x }", "distance 10, up 0 0 1, line 1");
        row("fog { distance 10 turbulence 0.5 turb_depth 0.25 octaves 4 omega 0.75 lambda 3 }",
            "distance 10, turbulence 0.5 0.5 0.5, depth 0.25, octaves 4, omega 0.75, lambda 3, line 1");
        row("fog { distance 10 turbulence <1, 2, 3> octaves 0 }",
            "distance 10, turbulence 1 2 3, octaves 1, line 1");
        row("fog { distance 10 octaves 20 colour rgb 0.25 }",
            "distance 10, color 0.25 0.25 0.25, octaves 10, line 1");
        row("fog { distance 10 octaves 10 }", "distance 10, octaves 10, line 1");
        row("fog { distance 10 octaves 1 }", "distance 10, octaves 1, line 1");
        row("\n#declare F = fog { distance 10 fog_type 2 }\n\nfog { F fog_alt 3 }",
            "ground yes, distance 10, altitude 3, line 4");
    }
    void fogs() {
        check("", "", [](const ParseResult& parsed) { return description(parsed.scene->fogs.at(0)); });
    }

    void media_data() {
        columns();
        row("media { emission rgb 0.5 absorption rgb <0.25, 1, 0> }",
            "absorption 0.25 1 0, emission 0.5 0.5 0.5, line 1");
        row("media { emission absorption rgb 1 }", "absorption 1 1 1, line 1");
        row("\nmedia { scattering { 5, rgb 1 eccentricity 0.5 extinction 0.25 } }",
            "scattering 1 1 1, kind 5, eccentricity 0.5, extinction 0.25, line 2");
        row("media { scattering { 7 rgb 1 } }", "scattering 1 1 1, line 1");
        row("media { method 2 intervals 4 samples 3 6 confidence 0.9 variance 0.1 ratio 0.5 jitter 0.1 }",
            "adaptive no, intervals 4, samples 3, line 1");
        row("media { aa_level 2 aa_threshold 0.25 samples 20, 20 collect off }",
            "samples 20, level 2, threshold 0.25, line 1");
        row("media { samples 1e9 intervals 1e9 aa_level 1e9 }", "intervals 2, samples 1000, level 6, line 1");
        row("media { density { rgb 0.5 } density { spherical density_map { [0 rgb 0] [1 granite] } } rotate "
            "x }",
            "even density, density, line 1");
        row("media { density { checker density { rgb 0 } density { bozo } } }", "density, line 1");
        row("#declare D = density { bozo } media { density { D scale 2 } }", "density, line 1");
        row("#declare M = media { emission rgb 1 samples 4 }\nmedia { M samples 5 }",
            "emission 1 1 1, samples 5, line 2");
    }
    void media() {
        check("", "", [](const ParseResult& parsed) { return description(*parsed.scene->atmosphere.at(0)); });
    }

    void rainbows_data() {
        columns();
        row("rainbow { direction z angle 42 width 5 distance 100 color_map { [0 rgb 0] [1 rgb 1] } }",
            "angle 42, width 5, distance 100, arc 360, falloff 360, 2 colors, line 1");
        row("rainbow { direction <1, 2, 3> up z angle 42 width 5 distance 100 jitter 0.5 arc_angle 120 "
            "falloff_angle 60 color_map { [0 rgb 0] [0.5 rgb 1] [1 rgb 1] } }",
            "direction 1 2 3, up 0 0 1, angle 42, width 5, distance 100, jitter 0.5, arc 120, falloff 60, 3 "
            "colors, line 1");
        row("\nrainbow { direction z angle 42 width 5 distance 100 colour_map { [0 rgb 0] [1 rgb 1] } }",
            "angle 42, width 5, distance 100, arc 360, falloff 360, 2 colors, line 2");
        row("#declare R = rainbow { direction z angle 42 width 5 distance 100 color_map { [0 rgb 0] [1 rgb "
            "1] } "
            "}\nrainbow { R angle 30 }",
            "angle 30, width 5, distance 100, arc 360, falloff 360, 2 colors, line 2");
    }
    void rainbows() {
        check("", "", [](const ParseResult& parsed) { return description(parsed.scene->rainbows.at(0)); });
    }

    void interiors_data() {
        columns();
        row("ior 1.5", "ior 1.5");
        row("ior 1.5 caustics 0.5 dispersion 1.25 dispersion_samples 9",
            "ior 1.5, caustics 0.5, dispersion 1.25, samples 9");
        row("dispersion_samples 1", "samples 2");
        row("dispersion_samples 2", "samples 2");
        row("dispersion_samples 100", "samples 100");
        row("dispersion_samples 500", "samples 100");
        row("fade_distance 2 fade_power 3 fade_color rgb <1, 0.5, 0.25>",
            "distance 2, power 3, color 1 0.5 0.25");
        row("fade_colour rgb 0.5", "color 0.5 0.5 0.5");
        row("media { scattering { 4, 0.5 } } ior 1.25",
            "ior 1.25, media scattering 0.5 0.5 0.5 filter 0.5 transmit 0.5, kind 4, line 1");
        row("media { intervals 3 } media { samples 5, 9 }",
            "media intervals 3, line 1, media samples 5, line 1");
    }
    void interiors() {
        check("sphere { 0, 1 interior { ", " } }", [](const ParseResult& parsed) {
            const InteriorId interior = parsed.scene->objects.at(0).interior;
            return description(parsed.scene->interiors.at(static_cast<std::size_t>(interior)));
        });
    }

    void objects_data() {
        columns();
        row("sphere { 0, 1 }", "sphere in line 1");
        row("\n\nsphere { 0, 1 no_shadow }", "shadow no, sphere in line 3");
        row("sphere { 0, 1 no_image }", "visible no, sphere in line 1");
        row("sphere { 0, 1 no_reflection }", "reflected no, sphere in line 1");
        row("sphere { 0, 1 hollow }", "hollow yes, sphere in line 1");
        row("sphere { 0, 1 hollow off }", "sphere in line 1");
        row("sphere { 0, 1 no_image off no_reflection off hollow on }", "hollow yes, sphere in line 1");
        row("sphere { 0, 1 double_illuminate }", "both sides yes, sphere in line 1");
        row("object { torus { 1, 0.2 } no_radiosity on sturm no_shadow }", "shadow no, torus in line 1");
        row("sphere { 0, 1 pigment { rgbt 0.5 } }", "transparent yes, sphere in line 1");
        row("sphere { 0, 1 pigment { rgbt 0.5 } interior { ior 1.5 } }",
            "transparent yes, bends yes, sphere in line 1");
        row("sphere { 0, 1 finish { reflection 0.5 } }", "mirrors yes, sphere in line 1");
        row("union { sphere { 0, 1 } box { 0, 1 } no_shadow }", "shadow no, sphere in line 1");
        row("union { sphere { 0, 1 no_image } no_shadow }", "shadow no, visible no, sphere in line 1");
        row("sphere { 0, 1 photons { target } no_shadow }", "shadow no, sphere in line 1");
        row("sphere { 0, 1 photons { target } radiosity { importance 1 } uv_vectors 0 no_shadow }",
            "shadow no, sphere in line 1");
        row("#declare S = sphere { 0, 1 no_image }\nobject { S no_shadow }",
            "shadow no, visible no, sphere in line 2");
        row("object { sphere { 0, 1 } hollow }", "hollow yes, sphere in line 1");
    }
    void objects() {
        check("", "", [](const ParseResult& parsed) { return description(parsed.scene->objects.at(0)); });
    }

    void materialsAreLitFromBothSidesAsTheirObjects() {
        const ParseResult parsed = parseScene(
            "sphere { 3, 1 } union { sphere { 0, 1 } box { 1, 2 pigment { rgb 1 } } double_illuminate }"
            "box { 3, 4 }");
        QCOMPARE(parsed.scene->objects.size(), std::size_t(4));
        for (const SceneObject& object : parsed.scene->objects)
            QCOMPARE(parsed.scene->materials.at(static_cast<std::size_t>(object.material)).doubleIlluminate,
                     object.doubleIlluminate);
        QVERIFY(parsed.scene->objects[1].doubleIlluminate && !parsed.scene->objects[3].doubleIlluminate);
    }

    /// Of a part without a texture a union says that it is there, and an intersection does not.
    void cutawayTexturesShowTheirParts_data() {
        QTest::addColumn<QString>("operation");
        QTest::addColumn<std::size_t>("shares");
        QTest::newRow("union") << "union" << std::size_t(2);
        QTest::newRow("merge") << "merge" << std::size_t(2);
        QTest::newRow("intersection") << "intersection" << std::size_t(1);
    }
    void cutawayTexturesShowTheirParts() {
        QFETCH(QString, operation);
        QFETCH(std::size_t, shares);
        const ParseResult parsed = parseScene(
            "difference { " + operation.toStdString() +
            " { box { -1, 1 pigment { rgb 1 } } sphere { 0, 1 } } sphere { 9, 1 } cutaway_textures }");
        const MaterialId own = parsed.scene->objects.at(0).material;
        const auto surface = parsed.scene->materials.at(static_cast<std::size_t>(own)).surface;
        QVERIFY(surface);
        QCOMPARE(surface->shape->textureShares({0.5, 0, 0}).size(), shares);
    }

    /// Each shape has a material of its own then.
    void materialsKnowTheSurfaceTheyAreOn_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("count");
        const auto row = [](const char* text, int count) { QTest::newRow(text) << QString(text) << count; };
        row("sphere { 0, 1 pigment { checker } }", 0);
        row("sphere { 0, 1 texture { uv_mapping pigment { checker } } }", 1);
        row("difference { sphere { 0, 1 } box { 0, 1 } texture { uv_mapping pigment { checker } } }", 2);
    }
    void materialsKnowTheSurfaceTheyAreOn() {
        QFETCH(QString, text);
        QFETCH(int, count);
        const ParseResult parsed = parseScene(text.toStdString());
        QCOMPARE(std::ranges::count_if(parsed.scene->materials,
                                       [](const Material& material) { return bool(material.surface); }),
                 count);
    }

    void cameras_data() {
        columns();
        row("camera { location <1, 2, 3> direction 2*z right 2*x up 3*y }",
            "at 1 2 3, along 0 0 2, right 2 0 0, up 0 3 0");
        row("camera { location -3*z look_at 0 angle 60 }",
            "at 0 0 -3, along 0 0 1.151813787033, vertical 30");
        row("camera { orthographic location -3*z look_at 0 }", "kind 1, at 0 0 -3, right 3.99 0 0, up 0 3 0");
        row("camera { fisheye location -3*z angle 120 }", "kind 2, at 0 0 -3, angle 120, vertical 60");
        row("camera { ultra_wide_angle angle 120 }", "kind 3, angle 120, vertical 60");
        row("camera { omnimax }", "kind 4");
        row("camera { panoramic angle 120 }", "kind 5, angle 120, vertical 60");
        row("camera { spherical angle 120, 90 }", "kind 6, angle 120, vertical 90");
        row("camera { spherical angle 120 90 }", "kind 6, angle 120, vertical 90");
        row("camera { spherical angle 120 }", "kind 6, angle 120, vertical 60");
        row("camera { cylinder 1 angle 120 }", "kind 7, angle 120, vertical 60");
        row("camera { cylinder 2 }", "kind 8");
        row("camera { cylinder 3 }", "kind 9");
        row("camera { cylinder 4.9 }", "kind 10");
        row("camera { perspective sky z }", "sky 0 0 1");
        row("camera { aperture 0.5 focal_point <1, 2, 3> confidence 0.5 variance 0.25 blur_samples 20 }",
            "aperture 0.5, samples 20, focus 1 2 3, confidence 0.5, variance 0.25");
        row("camera { aperture 0.5 blur_samples 4, 20 }", "aperture 0.5, samples 20");
        row("camera { aperture 0.5 blur_samples 0.5 }", "aperture 0.5");
        row("camera { location x normal { bumps 0.1 } }", "at 1 0 0, normal { bumps 0.1 }");
        row("camera { location x translate y scale 2 }",
            "at 2 2 0, along 0 0 2, right 2.66 0 0, up 0 2 0, sky 0 2 0, focus 0 2 0");
        row("#declare C = camera { fisheye location x angle 100 }\ncamera { C translate y }",
            "kind 2, at 1 1 0, angle 100, vertical 50, focus 0 1 0");
        row("camera { location x bokeh { texture 1 } angle 60 }",
            "at 1 0 0, along 0 0 1.151813787033, vertical 30");
        row("camera { location x h_angle 3, 4 sky z }", "at 1 0 0, sky 0 0 1");
        row("camera { location x v_angle 3 sky z }", "at 1 0 0, sky 0 0 1");
    }
    void cameras() {
        check("", "", [](const ParseResult& parsed) { return description(parsed.scene->camera); });
    }
};

QTEST_APPLESS_MAIN(SceneValuesTest)
#include "scene_values_test.moc"
