// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_parser.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <QTest>
#include <set>

#include "core/language/parse.h"
#include "core/text/number_format.h"
#include "test_folders.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::complaints, test::has, test::problems;

namespace {

std::string textOf(const ParseResult& parsed, const SourceRange& range) {
    return std::string(parsed.sources->slice(range));
}

bool inside(const ShapePointer& shape, double x, double y, double z) {
    TraceContext context;
    return shape->contains({x, y, z}, context);
}

Color colorOf(const Material& material) { return std::get<SolidPigment>(material.pigment).color; }

const char* const ball = "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } ";

}  // namespace

class SceneParserTest : public QObject {
    Q_OBJECT

  private slots:
    /// A bug once: the box of one isosurface and the sphere of the next made one group of sliders.
    void slidersKnowTheirStatement() {
        const ParseResult parsed = parseScene(R"(#include "functions.inc"
#declare R = 0.5;
isosurface { function { f_torus(x, y, z, 0.8, 0.2) + f_torus(x, y, z, 0.7, f_sphere(x, y, z, 0.4)) }
  contained_by { box { -1, 1 } } max_gradient 2 }
isosurface { function { x } contained_by { sphere { 0, 1.3 } } max_gradient 3 })");
        std::map<std::pair<std::string, int>, std::string> numbers;
        for (const SceneParameter& p : parsed.scene->parameters)
            numbers[{p.group, p.statement}] += p.name + '=' + std::to_string(std::lround(10 * p.value)) + ' ';
        std::multiset<std::string> lists;
        for (const auto& [where, list] : numbers) lists.insert(where.first + ": " + list);
        const std::multiset<std::string> expected{"#declare: R=5 ",
                                                  "contained_by: center=0 radius=13 ",
                                                  "contained_by: first corner=-10 second corner=10 ",
                                                  "f_sphere: Radius=4 ",
                                                  "f_torus: Major Radius=7 Minor Radius=2 ",
                                                  "f_torus: Major Radius=8 Minor Radius=2 ",
                                                  "isosurface: max_gradient=20 threshold=0 accuracy=0 ",
                                                  "isosurface: max_gradient=30 threshold=0 accuracy=0 "};
        QVERIFY2(lists == expected,
                 std::accumulate(lists.begin(), lists.end(), std::string(),
                                 [](std::string a, const std::string& b) { return a + b + '\n'; })
                     .c_str());
    }

    void readsACompleteScene() {
        const ParseResult parsed = parseScene(R"(#version 3.7;
global_settings { assumed_gamma 1.8 max_trace_level 7 noise_generator 2 number_of_waves 5 ambient_light rgb 2 }
camera { location <0, 0, -10> look_at 0 angle 40 right x*2 up y }
light_source { <1, 2, 3>, rgb <1, 0.5, 0.25> shadowless }
light_source { <1, 2, 3> color rgb 1 spotlight point_at <0, 1, 0> radius 10 falloff 20 tightness 2 fade_distance 3 fade_power 2 }
background { color rgb <0.1, 0.2, 0.3> }
sphere { <1, 0, 0>, 2 pigment { rgb <1, 0, 0> } finish { ambient 0.3 diffuse 0.7 phong 0.8 phong_size 60 specular 0.1 roughness 0.01 metallic } no_shadow }
box { -1, <1, 2, 3> pigment { rgb 0.5 } no_image no_reflection }
plane { y, -1 pigment { rgb 0 } }
)");
        QVERIFY2(parsed.diagnostics.empty(), problems(parsed).c_str());
        const Scene& scene = *parsed.scene;
        QCOMPARE(scene.settings.assumedGamma, 1.8);
        QCOMPARE(scene.settings.maxTraceLevel, 7);
        QCOMPARE(scene.settings.numberOfWaves, 5);
        QCOMPARE(scene.settings.ambientLight.red, 2.0);
        QCOMPARE(scene.camera.location.z, -10.0);
        QCOMPARE(scene.lights.size(), std::size_t(2));
        QVERIFY(scene.lights[0].shadowless);
        QCOMPARE(scene.lights[0].color.green, 0.5);
        QCOMPARE(scene.lights[0].line, 4);
        QVERIFY(scene.lights[1].kind == LightKind::spotlight);
        QCOMPARE(scene.lights[1].pointAt.y, 1.0);
        QCOMPARE(scene.lights[1].falloff, 20.0);
        QCOMPARE(scene.lights[1].fadePower, 2.0);
        QCOMPARE(scene.background.blue, 0.3);
        QCOMPARE(scene.objects.size(), std::size_t(3));
        QVERIFY(!scene.objects[0].castsShadow && scene.objects[0].visible);
        QVERIFY(!scene.objects[1].visible && !scene.objects[1].reflected);
        const Finish& finish = scene.materials.at(std::size_t(scene.objects[0].material)).finish;
        QCOMPARE(finish.ambient.green, 0.3);
        QCOMPARE(finish.diffuse, 0.7);
        QCOMPARE(finish.phongSize, 60.0);
        QCOMPARE(finish.metallic, 1.0);
        QVERIFY(inside(scene.objects[2].shape, 5, -1.5, 5) && !inside(scene.objects[2].shape, 5, -0.5, 5));
    }

    void remembersWhereTheCameraStands() {
        const ParseResult parsed = parseScene("sphere { 0, 1 }\ncamera { location -5*z\n look_at 0 }\n");
        QVERIFY(parsed.scene->cameraRange.has_value());
        QCOMPARE(textOf(parsed, *parsed.scene->cameraRange),
                 std::string("camera { location -5*z\n look_at 0 }"));
    }

    void readsEveryItemOfAnIsosurface() {
        const ParseResult parsed = parseScene(
            "isosurface { function { x + y } contained_by { box { <-1, -2, -3>, <3, 2, 1> } } threshold 0.25 "
            "accuracy 0.0001 max_gradient 3.5 evaluate 1, 1.5, 0.7 open max_trace 4 pigment { rgb 1 } }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const IsosurfaceSettings& settings = parsed.scene->isosurfaces.at(0).shape->settings();
        QCOMPARE(settings.threshold, 0.25);
        QCOMPARE(settings.accuracy, 0.0001);
        QCOMPARE(settings.maxGradient, 3.5);
        QVERIFY(settings.open);
        QCOMPARE(settings.maxTrace, 4);
        QCOMPARE((*settings.evaluate)[1], 1.5);
        const auto& box = std::get<ContainerBox>(settings.container);
        QVERIFY(box.low == glm::dvec3(-1, -2, -3) && box.high == glm::dvec3(3, 2, 1));
        const SceneIsosurface& place = parsed.scene->isosurfaces[0];
        QCOMPARE(place.functionText, std::string(" x + y "));
        QCOMPARE(textOf(parsed, place.functionRange), std::string(" x + y "));
        QVERIFY(textOf(parsed, place.range).starts_with("isosurface {"));
        QVERIFY(textOf(parsed, place.range).ends_with("pigment { rgb 1 } }"));
    }

    void theDefaultsOfAnIsosurface() {
        const ParseResult parsed = parseScene("isosurface { function { x } all_intersections }");
        const IsosurfaceSettings& settings = parsed.scene->isosurfaces.at(0).shape->settings();
        QCOMPARE(settings.threshold, 0.0);
        QCOMPARE(settings.accuracy, 0.001);
        QCOMPARE(settings.maxGradient, 1.1);
        QCOMPARE(settings.maxTrace, 10);
        QVERIFY(!settings.open && !settings.evaluate);
        QVERIFY(std::get<ContainerBox>(settings.container).low == glm::dvec3(-1));
    }

    void theNumbersOfAnIsosurfaceAreSliders() {
        const ParseResult parsed = parseScene(
            "isosurface { function { x } contained_by { sphere { <0.5, -1, 0>, 1.2 } } threshold -0.5 "
            "accuracy 0.01 "
            "max_gradient 2*3 }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        std::vector<std::string> found;
        for (const SceneParameter& p : parsed.scene->parameters) {
            QVERIFY(p.minimum <= p.value && p.value <= p.maximum);
            QCOMPARE(p.slot, -1);
            found.push_back(p.name + "=" + textOf(parsed, p.range) + (p.logarithmic ? " log" : "") +
                            (p.expression ? " expression" : ""));
        }
        QCOMPARE(found, (std::vector<std::string>{"center x=0.5", "center y=-1", "center z=0", "radius=1.2",
                                                  "threshold=-0.5", "accuracy=0.01 log",
                                                  "max_gradient=2*3 log expression"}));
    }

    /// The counter of csg.pov's loop was the second slider of the window.
    void whereALoopBeginsToCountIsNoSlider() {
        const ParseResult parsed = parseScene(
            "#declare R = 0.5; #declare I = 0; #declare J = R; #declare N = 3;\n"
            "#macro Twice(A) #local R = A; #local R = R + A; R #end\n"
            "#while (I < N) sphere { I*x, R } #declare I = I + 1; #declare J = J + Twice(R); #end\n"
            "#declare N = 4; sphere { J, N }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        std::vector<std::string> found;
        for (const SceneParameter& p : parsed.scene->parameters)
            if (p.role == ParameterRole::declared) found.push_back(p.name + "=" + shortestNumber(p.value));
        QCOMPARE(found, (std::vector<std::string>{"R=0.5", "N=3", "N=4"}));
    }

    void settingsThatAreLeftOutAreOfferedOnce() {
        const ParseResult parsed = parseScene(
            "#for (I, 1, 3) isosurface { function { x - I } accuracy 0.01 translate x } #end\n"
            "isosurface { function { y } contained_by { sphere { 0, 1 } } threshold 1 accuracy 1 "
            "max_gradient 1 }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        std::vector<std::string> found;
        for (const SceneParameter& p : parsed.scene->parameters) {
            if (!p.implied) continue;
            QCOMPARE(p.range.begin, p.range.end);
            const SourceRange before{0, p.range.begin - 4, p.range.begin};
            found.push_back(p.name + "=" + std::to_string(p.value) + " behind " + textOf(parsed, before));
        }
        QCOMPARE(found, (std::vector<std::string>{"threshold=0.000000 behind 0.01",
                                                  "max_gradient=1.100000 behind 0.01"}));
    }

    void findsIsosurfacesDeepInCsg() {
        const ParseResult parsed =
            parseScene(std::string("union { intersection { ") + ball +
                       "translate x } box { -2, 2 } scale 2 } ovus { 1, 0.2 } rotate 90*z }");
        QCOMPARE(complaints(parsed),
                 (std::vector<std::string>{"`ovus` is not drawn yet. [ovus { 1, 0.2 }]"}));
        QVERIFY(parsed.ok());
        const SceneIsosurface& place = parsed.scene->isosurfaces.at(0);
        // The centre moves to x, then to 2x, then is turned to 2y.
        const glm::dvec3 center = place.transform.point({0, 0, 0});
        QVERIFY(glm::length(center - glm::dvec3(0, 2, 0)) < 1e-12);
        QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
        QVERIFY(inside(parsed.scene->objects[0].shape, 0, 2, 0));
        QVERIFY(!inside(parsed.scene->objects[0].shape, 0, -2, 0));
    }

    void readsReflections() {
        const auto finishOf = [](const std::string& text) {
            const ParseResult parsed = parseScene("sphere { 0, 1 finish { " + text + " } }");
            return parsed.scene->materials.at(std::size_t(parsed.scene->objects.at(0).material)).finish;
        };
        QVERIFY(!finishOf("").reflects());
        const Finish plain = finishOf("reflection rgb <0.1, 0.2, 0.3>");
        QVERIFY(plain.reflects());
        QVERIFY(plain.reflectionMinimum == plain.reflectionMaximum);
        // One colour in a block counts for every angle, too.
        const Finish single = finishOf("reflection { 0.4 exponent 2 }");
        QVERIFY(single.reflectionMinimum == single.reflectionMaximum);
        QCOMPARE(single.reflectionExponent, 2.0);
        const Finish both =
            finishOf("reflection { 0.1, 0.8 fresnel falloff 3 metallic 0.5 } conserve_energy");
        QCOMPARE(both.reflectionMinimum.green, 0.1);
        QCOMPARE(both.reflectionMaximum.green, 0.8);
        QVERIFY(both.reflectionFresnel && both.conserveEnergy);
        QCOMPARE(both.reflectionFalloff, 3.0);
        QCOMPARE(both.reflectionMetallic, 0.5);
        QCOMPARE(finishOf("reflection 1 reflection_exponent 3").reflectionExponent, 3.0);
    }

    void interiorsGoToTheObjectsTheyAreSaidOf() {
        const ParseResult parsed = parseScene(R"(
#declare Glass = material { texture { pigment { rgbt 1 } } interior { ior 1.5 fade_distance 2 fade_power 3 } }
#declare Water = interior { ior 1.33 }
sphere { 0, 1 material { Glass } }
sphere { x*3, 1 pigment { rgbt 1 } interior { Water } hollow }
sphere { x*6, 1 pigment { rgb 1 } }
intersection { sphere { x*9, 1 interior { ior 1.2 } } box { 8, 10 } pigment { rgbt 1 } interior { ior 1.7 } }
)");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY(complaints(parsed).empty());
        const Scene& scene = *parsed.scene;
        const auto interiorOf = [&](std::size_t object) {
            return scene.interiors.at(std::size_t(scene.objects.at(object).interior));
        };
        QCOMPARE(interiorOf(0).ior, 1.5);
        QCOMPARE(interiorOf(0).fadePower, 3.0);
        QCOMPARE(interiorOf(1).ior, 1.33);
        QVERIFY(interiorOf(1).hollow && !interiorOf(0).hollow);
        QVERIFY(scene.objects[0].transparent && scene.objects[0].bendsLight && !scene.objects[2].transparent);
        QCOMPARE(scene.objects[2].interior, noInterior);
        // Both its own and that of a part.
        QCOMPARE(interiorOf(3).ior, 1.7);
        QCOMPARE(std::count_if(scene.materials.begin(), scene.materials.end(),
                               [&](const Material& material) {
                                   return material.interior != noInterior &&
                                          scene.interiors[std::size_t(material.interior)].ior == 1.2;
                               }),
                 1);
    }

    void readsFogs() {
        const ParseResult parsed = parseScene(
            "\nfog { fog_type 2 distance 10 color rgbt <1, 0.5, 0.2, 0.1> fog_offset 1 fog_alt 2 up x rotate "
            "z*90\n"
            "turbulence <1, 2, 3> turb_depth 0.3 octaves 4 omega 0.6 lambda 2.5 }\n"
            "#declare Haze = fog { distance 7 rgb 1 } fog { Haze }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QCOMPARE(parsed.scene->fogs.size(), std::size_t{2});
        const Fog& fog = parsed.scene->fogs[0];
        QVERIFY(fog.ground);
        QCOMPARE(fog.line, 2);
        QCOMPARE(fog.distance, 10.0);
        QCOMPARE(fog.color.transmit, 0.1);
        QCOMPARE(fog.offset, 1.0);
        QCOMPARE(fog.altitude, 2.0);
        QVERIFY(glm::length(fog.up - glm::dvec3(0, 1, 0)) < 1e-12);
        QVERIFY(fog.turbulence == glm::dvec3(1, 2, 3));
        QCOMPARE(fog.octaves, 4);
        QCOMPARE(parsed.scene->fogs[1].distance, 7.0);
    }

    void warnsWhenTheFunctionIsNotFirst() {
        const ParseResult parsed = parseScene("isosurface { threshold 1 function { x } }");
        QVERIFY(parsed.ok());
        QVERIFY(has(parsed, Severity::warning, "function-not-first"));
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
    }

    void clippingByADeclaredName() {
        const ParseResult parsed = parseScene(
            "#declare A = sphere { 0, 1 }\n#declare B = box { -2, <2, 0, 2> }\nobject { A clipped_by { B } "
            "}");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY(inside(parsed.scene->objects.at(0).shape, 0, -0.5, 0));
        QVERIFY(!inside(parsed.scene->objects.at(0).shape, 0, 0.5, 0));
    }

    void reportsSeveralMistakesOfOneText() {
        const ParseResult parsed =
            parseScene(std::string("sphere { 0, 1 pigmint { rgb 1 } }\n") +
                       "isosurface { function { x + } }\n" + "lightsource { 1, 1 }\n" + ball + "}");
        QVERIFY(!parsed.ok());
        const std::vector<std::string> all = complaints(parsed);
        QVERIFY(std::find(all.begin(), all.end(), "`pigmint` is not understood in `sphere`. [pigmint]") !=
                all.end());
        QVERIFY(std::find(all.begin(), all.end(),
                          "Expected a number, a name, a call or `(` here, but found `}`. [}]") != all.end());
        QVERIFY(
            std::find(all.begin(), all.end(),
                      "Expected a statement such as `isosurface`, but found `lightsource`. [lightsource]") !=
            all.end());
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
    }

    void suggestsTheStatementThatWasMeant() {
        const ParseResult parsed = parseScene("isosurfase { function { x } }");
        QCOMPARE(parsed.diagnostics.front().hint, std::string("did you mean `isosurface`?"));
    }

    void declaredThingsAreUsedByName() {
        const ParseResult parsed = parseScene(R"(
#version 3.7;
#declare P = pigment { rgb <1, 0, 0> }
#declare F = finish { ambient 0.4 }
#declare T = texture { pigment { P } finish { F phong 0.5 } }
#declare Move = transform { translate <3, 0, 0> }
#declare Thing = sphere { 0, 1 texture { T } }
#declare L = light_source { <1, 2, 3>, rgb 0.5 }
#declare C = camera { location <0, 0, -7> look_at 0 }
camera { C }
light_source { L translate y }
object { Thing transform { Move } }
object { Thing transform Move scale 2 pigment { rgb <0, 1, 0> } }
)");
        QVERIFY2(parsed.diagnostics.empty(), problems(parsed).c_str());
        const Scene& scene = *parsed.scene;
        QCOMPARE(scene.camera.location.z, -7.0);
        QCOMPARE(scene.lights.at(0).location.y, 3.0);
        QVERIFY(inside(scene.objects.at(0).shape, 3.9, 0, 0));
        QVERIFY(inside(scene.objects.at(1).shape, 7.9, 0, 0));
        const Material& first = scene.materials.at(std::size_t(scene.objects[0].material));
        const Material& second = scene.materials.at(std::size_t(scene.objects[1].material));
        QCOMPARE(colorOf(first).red, 1.0);
        QCOMPARE(first.finish.ambient.red, 0.4);
        QCOMPARE(first.finish.phong, 0.5);
        QCOMPARE(colorOf(second).green, 1.0);
        QCOMPARE(second.finish.phong, 0.5);
    }

    void defaultsHoldForWhatFollows() {
        const ParseResult parsed = parseScene(
            "sphere { 0, 1 }\n#default { pigment { rgb 0.5 } finish { ambient 0.9 } }\nsphere { 0, 1 } "
            "sphere { 0, 1 pigment { rgb <1, 0, 0> } }");
        const Scene& scene = *parsed.scene;
        const auto material = [&](std::size_t k) {
            return scene.materials.at(std::size_t(scene.objects.at(k).material));
        };
        QCOMPARE(colorOf(material(0)).red, 0.0);
        QCOMPARE(material(0).finish.ambient.red, 0.1);
        QCOMPARE(colorOf(material(1)).red, 0.5);
        QCOMPARE(material(2).finish.ambient.red, 0.9);
    }

    void partsKeepTheirTextures() {
        const ParseResult parsed = parseScene(
            "intersection { sphere { 0, 1 pigment { rgb <1, 0, 0> } } box { -2, <2, 0, 2> } pigment { rgb "
            "<0, 1, 0> } }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const auto seenFrom = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
            TraceContext context;
            HitList hits;
            const SceneObject& object = parsed.scene->objects.at(0);
            object.shape->intersect({origin, direction}, {}, context, hits);
            const MaterialId id = hits.at(0).material == noMaterial ? object.material : hits.at(0).material;
            return colorOf(parsed.scene->materials.at(std::size_t(id)));
        };
        QCOMPARE(seenFrom({0.1, -5, 0.1}, {0, 1, 0}).red, 1.0);
        QCOMPARE(seenFrom({0.1, 5, 0.1}, {0, -1, 0}).green, 1.0);
    }

    void clippingMovesWithTheObject() {
        const ParseResult parsed =
            parseScene("sphere { 0, 1 clipped_by { box { -2, <2, 0, 2> } } translate <0, 10, 0> inverse }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        TraceContext context;
        HitList hits;
        parsed.scene->objects.at(0).shape->intersect({{0.1, 20, 0.1}, {0, -1, 0}}, {}, context, hits);
        QCOMPARE(hits.size(), std::size_t(1));
        QVERIFY(hits[0].point.y < 9.2);
    }

    void versionDecidesTheGamma() {
        QCOMPARE(parseScene("#version 3.7;").scene->settings.assumedGamma, 1.0);
        QCOMPARE(parseScene("#version 3.6;").scene->settings.assumedGamma, srgbGamma);
        QCOMPARE(
            parseScene("#version 3.6; global_settings { assumed_gamma 2.2 }").scene->settings.assumedGamma,
            2.2);
    }

    void aBareIsosurfaceGetsViewAndLight() {
        const ParseResult parsed = parseScene(std::string(ball) + "translate <10, 0, 0> }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY(has(parsed, Severity::note, "no-camera"));
        QVERIFY(has(parsed, Severity::note, "no-light"));
        const Camera& camera = parsed.scene->camera;
        QVERIFY(glm::length(camera.lookAt - glm::dvec3(10, 0, 0)) < 1e-9);
        const glm::dvec3 towards = glm::normalize(glm::dvec3(10, 0, 0) - camera.location);
        QVERIFY(glm::length(camera.ray(0, 0).direction - towards) < 1e-9);
        QCOMPARE(parsed.scene->lights.size(), std::size_t(1));
        QVERIFY(parsed.scene->lights[0].location == camera.location);
    }

    void normalsMayHaveACommaBeforeTheirAmount() {
        ParseOptions options;
        options.file = ISOSCOPE_TEST_DATA "/texture/scene.pov";
        const ParseResult parsed = parseScene(
            "sphere { 0, 1 normal { gradient x, 0.6 scale 2 } } sphere { 0, 1 normal { mandel 20, 0.6 } }"
            "sphere { 0, 1 normal { density_file df3 \"density.df3\", 2.6 interpolate 1 scale 2 } }",
            options);
        QVERIFY2(parsed.ok() && !has(parsed, Severity::leftOut, "left-out"), problems(parsed).c_str());
        QCOMPARE(parsed.scene->materials.at(1).normal->amount, 0.6);
        QCOMPARE(parsed.scene->materials.at(3).normal->amount, 2.6);
    }

    void whatShinesByItselfGetsNoLight() {
        for (const char* finish : {"ambient 1", "emission 0.2", "ambient rgb <0, 0, 0.6>"}) {
            const ParseResult parsed = parseScene(std::string("sphere { 0, 1 finish { ") + finish + " } }");
            QVERIFY(parsed.scene->lights.empty());
            QVERIFY(!has(parsed, Severity::note, "no-light"));
        }
        QCOMPARE(parseScene("sphere { 0, 1 finish { ambient 0.3 } }").scene->lights.size(), std::size_t(1));
    }

    void aDeclaredObjectAloneIsShown() {
        const ParseResult parsed =
            parseScene("#declare A = sphere { 0, 1 }\n#declare Shape = box { 0, 1 }\n");
        QVERIFY(parsed.ok());
        QVERIFY(has(parsed, Severity::note, "declared-only"));
        QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
        QCOMPARE(parsed.scene->objects[0].name, std::string("box"));
    }

    void declaredShapesAreFound() {
        const ParseResult parsed =
            parseScene("#declare Shape = sphere { 0, 1 translate 3*x }\n#declare N = 1;");
        const ShapePointer shape = declaredShape(parsed, "Shape");
        QVERIFY(shape != nullptr);
        QVERIFY(inside(shape, 3.5, 0, 0));
        QVERIFY(declaredShape(parsed, "N") == nullptr);
        QVERIFY(declaredShape(parsed, "Nothing") == nullptr);
    }

    void aLaterNoiseGeneratorHoldsForAllFunctions() {
        const std::string text =
            "#include \"functions.inc\"\nisosurface { function { f_noise3d(x,y,z) - 0.5 } }\n";
        const auto graphSize = [](const ParseResult& parsed) {
            return parsed.scene->isosurfaces.at(0).shape->settings().function.graph;
        };
        const ParseResult before = parseScene("global_settings { noise_generator 3 }\n" + text);
        const ParseResult after = parseScene(text + "global_settings { noise_generator 3 }\n");
        const ParseResult without = parseScene(text);
        const auto nodes = [&](const ParseResult& parsed) {
            const auto graph = graphSize(parsed);
            std::vector<Node> all;
            for (NodeId id = 0; id < graph->size(); ++id) all.push_back((*graph)[id]);
            return all;
        };
        QVERIFY(nodes(before) == nodes(after));
        QVERIFY(!(nodes(before) == nodes(without)));
    }

    /// What is not simulated may be declared; its block is passed over, and what follows is read.
    void blocksThatAreNotSimulatedMayBeDeclared() {
        for (const char* word : {"radiosity", "material_map"}) {
            const ParseResult parsed = parseScene("#declare M = " + std::string(word) +
                                                  " { scattering { 1, 1 } intervals 3 }\nsphere { 0, 1 }\n");
            QVERIFY2(parsed.ok(), problems(parsed).c_str());
            QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
            QVERIFY(parsed.symbols->find("M") != nullptr);
        }
    }

    /// Behind a wrong number of arguments reading goes on after them.
    void wrongArgumentsAreOneMistake() {
        for (const char* call : {"atan2(1)", "sin(1, 2, 3)", "select(1)", "max()", "sin(1, (2), sin(3))"}) {
            const ParseResult parsed =
                parseScene("#declare A = " + std::string(call) + " + 1;\n#declare B = 2;\nsphere { 0, B }");
            QVERIFY2(complaints(parsed).size() == 1, problems(parsed).c_str());
            QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
        }
    }

    void unclosedDirectivesAreShownWhereTheyBegin() {
        for (const char* begin :
             {"for (I, 1, 3)", "while (1 > 2)", "if (1)", "ifdef (A)", "switch (1) #case (1)"}) {
            const ParseResult parsed =
                parseScene("sphere { 0, 1 }\n #" + std::string(begin) + " box { 0, 1 }");
            const std::string word = std::string(begin).substr(0, std::string(begin).find(' '));
            const auto said = std::ranges::find(parsed.diagnostics, "unclosed-directive", &Diagnostic::id);
            QVERIFY2(said != parsed.diagnostics.end(), begin);
            QCOMPARE(textOf(parsed, said->range), "#" + word);
            QVERIFY(said->message.starts_with("`#" + word + "` is never closed"));
        }
    }

    void aPigmentThatTheTextEndsInIsTold() {
        const ParseResult parsed = parseScene("sphere { 0, 1 pigment { rgb 1");
        QVERIFY2(problems(parsed).find("Expected `}` to close `pigment`, but the text ends here.") !=
                     std::string::npos,
                 problems(parsed).c_str());
    }

    /// Behind a mistake in a map its block is passed over.
    void aMistakeInAMapIsOne() {
        for (const char* map : {"texture_map { [0 pigment { rgb 1 }] wibble [1 pigment { rgb 0 }] }",
                                "pigment { gradient x pigment_map { [0 rgb 1] wibble [1 rgb 0] } }",
                                "normal { gradient x normal_map { [0 bumps 1] wibble [1 dents 1] } }",
                                "normal { gradient x slope_map { [0 <0, 1>] wibble [1 <1, 1>] } }",
                                "pigment { gradient x color_map { [0 rgb 1] wibble [1 rgb 0] } }"}) {
            const ParseResult parsed =
                parseScene("sphere { 0, 1 texture { " + std::string(map[0] == 't' ? "gradient x " : "") +
                           map + " } }\nbox { -1, 1 }");
            const auto errors = std::ranges::count_if(
                parsed.diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
            QVERIFY2(errors == 1, problems(parsed).c_str());
            QCOMPARE(parsed.scene->objects.size(), std::size_t(2));
        }
    }

    void doublingObjectsEndInAMessage() {
        std::string text = "#declare A0 = sphere { 0, 1 }\n";
        for (int k = 1; k < 60; ++k) {
            const std::string before = "object { A" + std::to_string(k - 1) + " } ";
            text += "#declare A" + std::to_string(k) + " = union { " + before + before + "}\n";
        }
        const ParseResult parsed = parseScene(text + "object { A59 }");
        QVERIFY(!parsed.ok());
        QVERIFY(parsed.seconds < 10);
        std::string clips = "#declare A0 = sphere { 0, 1 }\n";
        for (int k = 1; k < 60; ++k) {
            const std::string before = "clipped_by { A" + std::to_string(k - 1) + " } ";
            clips += "#declare A" + std::to_string(k) + " = sphere { 0, 1 " + before + before + "}\n";
        }
        QVERIFY(!parseScene(clips + "object { A59 }").ok());
    }

    void unbalancedBraces() {
        for (const char* text :
             {"sphere { 0, 1", "}}}} sphere { 0, 1 }", "union { sphere { 0, 1 }",
              "isosurface { function { x + (y }", "camera { location", "#declare T = texture { pigment {",
              "global_settings { assumed_gamma 1", "light_source { 1, 1", "{ { {"}) {
            const ParseResult parsed = parseScene(text);
            QVERIFY2(!parsed.ok(), text);
            QVERIFY(parsed.diagnostics.front().range.file == 0);
        }
    }

    void deepNestingEndsInAMessage() {
        for (const char* piece :
             {"union { ", "texture { pigment_map { [0 ", "object { ", "intersection { object { ",
              "#declare A = union { ", "material { texture { "}) {
            std::string text;
            for (int k = 0; k < 20'000; ++k) text += piece;
            const ParseResult parsed = parseScene(text);
            QVERIFY2(!parsed.ok(), piece);
        }
    }

    void filesThatCannotBeRead() {
        const ParseResult parsed = parseSceneFile("/nonexistent/scene.pov");
        QVERIFY(!parsed.ok());
        QVERIFY(parsed.scene && parsed.sources && parsed.symbols);
        QVERIFY(!parseSceneFile("/").ok());
    }
};

QTEST_APPLESS_MAIN(SceneParserTest)
#include "scene_parser_test.moc"
