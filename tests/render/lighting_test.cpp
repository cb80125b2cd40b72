// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/support/lighting_case.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::LightingCase;

namespace {

/// Of 255. POV-Ray keeps colours in single precision, which may turn a rounding.
constexpr int allowedDifference = 1;

LightSource lightAt(const glm::dvec3& location, const Color& color = {1, 1, 1}) {
    LightSource light;
    light.location = location;
    light.color = color;
    return light;
}

LightSource lamp(LightKind kind) {
    LightSource light = lightAt({3, 5, -4});
    light.kind = kind;
    return light;
}

std::vector<LightingCase> finishCases() {
    std::vector<LightingCase> cases;
    const auto add = [&](const char* name, auto change) {
        LightingCase item;
        item.name = name;
        item.lights = {lightAt({3, 5, -4})};
        change(item);
        cases.push_back(item);
    };
    add("plain", [](LightingCase&) {});
    add("brilliance", [](LightingCase& c) { c.finish.brilliance = 3.5; });
    add("brilliance below one", [](LightingCase& c) { c.finish.brilliance = 0.3; });
    add("phong", [](LightingCase& c) { c.finish.phong = 0.7, c.finish.phongSize = 12; });
    add("sharp phong", [](LightingCase& c) { c.finish.phong = 0.7, c.finish.phongSize = 90; });
    add("metallic phong",
        [](LightingCase& c) { c.finish.phong = 0.7, c.finish.phongSize = 3, c.finish.metallic = 1; });
    add("specular", [](LightingCase& c) { c.finish.specular = 0.6, c.finish.roughness = 0.1; });
    add("broad specular", [](LightingCase& c) { c.finish.specular = 0.6, c.finish.roughness = 1; });
    add("roughness of 0", [](LightingCase& c) { c.finish.specular = 0.2, c.finish.roughness = 0; });
    add("negative roughness", [](LightingCase& c) { c.finish.specular = 0.02, c.finish.roughness = -0.5; });
    add("metallic specular",
        [](LightingCase& c) { c.finish.specular = 0.6, c.finish.roughness = 0.5, c.finish.metallic = 0.7; });
    add("light from behind", [](LightingCase& c) {
        c.lights = {lightAt({1, 2, 6})};
        c.finish.specular = 0.6, c.finish.roughness = 0.5, c.finish.metallic = 1, c.finish.phong = 0.5;
    });
    add("diffuse back", [](LightingCase& c) { c.finish.diffuseBack = 0.4, c.lights[0].shadowless = true; });
    add("ambient and emission", [](LightingCase& c) {
        c.finish.ambient = {0.3, 0.1, 0.2};
        c.finish.emission = {0.1, 0.0, 0.4};
        c.ambientLight = {0.5, 1, 2};
    });
    return cases;
}

std::vector<LightingCase> lightCases() {
    std::vector<LightingCase> cases;
    const auto add = [&](const char* name, std::vector<LightSource> lights, auto change) {
        LightingCase item;
        item.name = name;
        item.lights = std::move(lights);
        item.box = true;
        change(item);
        cases.push_back(item);
    };
    const auto nothing = [](LightingCase&) {};
    const std::vector<LightSource> two{lightAt({3, 5, -4}, {0.9, 0.7, 0.5}),
                                       lightAt({-4, 3, -2}, {0.2, 0.3, 0.6})};
    add("two coloured lights, shadows of a box", two, nothing);
    add("no_shadow box", two, [](LightingCase& c) { c.boxCasts = false; });
    add("one shadowless light", two, [](LightingCase& c) { c.lights[0].shadowless = true; });
    add("shadowless lights make no highlights", two, [](LightingCase& c) {
        c.lights[0].shadowless = true;
        c.finish.phong = 0.8, c.finish.specular = 0.6;
    });
    add("no light at all", {}, nothing);

    const auto spot = [](double radius, double falloff, double tightness) {
        return [=](LightingCase& c) {
            c.lights[0].radius = radius;
            c.lights[0].falloff = falloff;
            c.lights[0].tightness = tightness;
        };
    };
    add("spotlight", {lamp(LightKind::spotlight)}, spot(8, 16, 0));
    add("tight spotlight", {lamp(LightKind::spotlight)}, spot(8, 16, 20));
    add("spotlight with falloff below radius", {lamp(LightKind::spotlight)}, spot(8, 5, 0));
    add("wide spotlight", {lamp(LightKind::spotlight)}, spot(70, 130, 1));
    add("cylinder with falloff below radius", {lamp(LightKind::cylinder)}, spot(0.9, 0.4, 0));
    add("tight cylinder with falloff below radius", {lamp(LightKind::cylinder)}, spot(0.9, 0.4, 2));
    add("spotlight of radius 0", {lamp(LightKind::spotlight)}, spot(0, 20, 10));
    add("cylinder", {lamp(LightKind::cylinder)}, spot(0.8, 1.6, 0));
    add("tight cylinder", {lamp(LightKind::cylinder)}, spot(0.8, 1.6, 3));
    add("parallel", {lamp(LightKind::parallel)}, nothing);
    add("parallel from a near plane", {lamp(LightKind::parallel)}, [](LightingCase& c) {
        c.lights[0].location = {0.3, 0.5, -0.4};
    });
    const auto fade = [](double distance, double power) {
        return [=](LightingCase& c) {
            c.lights[0] = lightAt({1, 2, -2}, {2, 2, 2});
            c.lights[0].fadeDistance = distance;
            c.lights[0].fadePower = power;
        };
    };
    add("fading", {lightAt({})}, fade(1.5, 2));
    add("fading fast", {lightAt({})}, fade(2.5, 5));
    add("fading without distance", {lightAt({})}, fade(0, 2));
    add("parallel fading", {lamp(LightKind::parallel)},
        [](LightingCase& c) { c.lights[0].fadeDistance = 4, c.lights[0].fadePower = 2; });
    // It was dark there.
    for (const double power : {0.5, 1.0, 2.0, 3.0})
        add("behind a parallel light that fades", {lamp(LightKind::parallel)}, [=](LightingCase& c) {
            c.name += ", " + std::to_string(power);
            c.lights[0].location = {0.3, 0.5, -0.4};
            c.lights[0].fadeDistance = 0.7, c.lights[0].fadePower = power;
        });
    return cases;
}

std::vector<LightingCase> gammaCases() {
    std::vector<LightingCase> cases;
    for (double gamma : {1.0, 1.8, 2.2, srgbGamma}) {
        LightingCase item;
        item.name = "assumed_gamma " + std::to_string(gamma);
        item.assumedGamma = gamma;
        item.lights = {lightAt({3, 5, -4}, {1.5, 1.2, 1})};
        item.finish.phong = 0.5;
        cases.push_back(item);
    }
    return cases;
}

void compare(const LightingCase& item) {
    if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
    test::PovrayRun run;
    run.width = 96;
    run.height = 72;
    const Image theirs = test::povrayPicture(test::povrayText(item), run);
    QVERIFY2(!theirs.pixels.empty(), test::povrayText(item).c_str());
    const Image ours = renderImage(test::requestFor(test::sceneOf(item), run.width, run.height));
    const test::PictureDifference difference = test::comparePictures(ours, theirs);
    if (difference.largest > allowedDifference)
        test::keepPictures(QString::fromStdString("lighting " + item.name), ours, theirs);
    QVERIFY2(
        difference.largest <= allowedDifference,
        qPrintable(
            QString("differs by %1, within 8: %2").arg(difference.largest).arg(difference.shareWithin8)));
}

void addRows(const std::vector<LightingCase>& cases) {
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < cases.size(); ++i)
        QTest::newRow(cases[i].name.c_str()) << static_cast<int>(i);
}

}  // namespace

class LightingTest : public QObject {
    Q_OBJECT

  private slots:
    void finishesAgreeWithPovray_data() { addRows(finishCases()); }
    void finishesAgreeWithPovray() {
        QFETCH(int, number);
        compare(finishCases()[static_cast<std::size_t>(number)]);
    }

    void lightsAgreeWithPovray_data() { addRows(lightCases()); }
    void lightsAgreeWithPovray() {
        QFETCH(int, number);
        compare(lightCases()[static_cast<std::size_t>(number)]);
    }

    void gammasAgreeWithPovray_data() { addRows(gammaCases()); }
    void gammasAgreeWithPovray() {
        QFETCH(int, number);
        compare(gammaCases()[static_cast<std::size_t>(number)]);
    }
};

QTEST_GUILESS_MAIN(LightingTest)
#include "lighting_test.moc"
