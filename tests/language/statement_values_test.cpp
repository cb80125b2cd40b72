// SPDX-License-Identifier: GPL-3.0-or-later
// What the statements of textures and lights become: of each text, every member of the scene that is not what
// it is by default.
#include <map>
#include <QTest>

#include "core/language/parse.h"
#include "core/scene/surface_normal.h"
#include "tests/language/told_members.h"
#include "tests/support/problems.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string warpText(const PatternWarp& warp) {
    if (const auto* transform = std::get_if<TransformWarp>(&warp))
        return "(transform " + told(transform->inverse) + ")";
    if (const auto* turbulence = std::get_if<TurbulenceWarp>(&warp))
        return "(turbulence " + told(turbulence->amount) + ", " + told(turbulence->octaves) + " " +
               told(turbulence->lambda) + " " + told(turbulence->omega) + ")";
    if (const auto* repeat = std::get_if<RepeatWarp>(&warp))
        return "(repeat axis " + told(repeat->axis) + " " + told(repeat->width) + " offset " +
               told(repeat->offset) + " flip " + told(repeat->flip[0]) + " " + told(repeat->flip[1]) + " " +
               told(repeat->flip[2]) + ")";
    if (const auto* hole = std::get_if<BlackHoleWarp>(&warp))
        return "(black_hole " + told(hole->center) + ", " + told(hole->radius) + " " + told(hole->strength) +
               " " + told(hole->falloff) + " repeat " + told(hole->repeat) + " turbulence " +
               told(hole->turbulence) + (hole->inverse ? " inverse)" : ")");
    if (const auto* planar = std::get_if<PlanarWarp>(&warp))
        return "(planar " + told(planar->orientation) + " " + told(planar->distance) + ")";
    const auto& round = std::get<RoundWarp>(warp);
    return "(round " + told(static_cast<int>(round.kind)) + " " + told(round.orientation) + " " +
           told(round.distanceExponent) + " " + told(round.majorRadius) + ")";
}

const std::map<PatternKind, const char*> kindNames{{PatternKind::agate, "agate"},
                                                   {PatternKind::bozo, "bozo"},
                                                   {PatternKind::brick, "brick"},
                                                   {PatternKind::checker, "checker"},
                                                   {PatternKind::crackle, "crackle"},
                                                   {PatternKind::gradient, "gradient"},
                                                   {PatternKind::mandel, "mandel"},
                                                   {PatternKind::julia, "julia"},
                                                   {PatternKind::slope, "slope"},
                                                   {PatternKind::magnetMandel, "magnet mandel"},
                                                   {PatternKind::magnetJulia, "magnet julia"},
                                                   {PatternKind::quilted, "quilted"},
                                                   {PatternKind::spiral1, "spiral1"},
                                                   {PatternKind::spiral2, "spiral2"},
                                                   {PatternKind::aoi, "aoi"},
                                                   {PatternKind::function, "function"},
                                                   {PatternKind::wood, "wood"},
                                                   {PatternKind::granite, "granite"},
                                                   {PatternKind::marble, "marble"},
                                                   {PatternKind::radial, "radial"}};

std::string description(const Pattern& pattern) {
    const Pattern usual;
    Differences all;
    const auto name = kindNames.find(pattern.kind);
    all.put(name == kindNames.end() ? "kind " + told(static_cast<int>(pattern.kind)) : name->second);
    if (pattern.wave) all.put("wave " + told(static_cast<int>(*pattern.wave)));
    all.add("exponent of the wave", pattern.waveExponent, usual.waveExponent);
    all.add("frequency", pattern.frequency, usual.frequency);
    all.add("phase", pattern.phase, usual.phase);
    all.add("turbulence", pattern.turbulence, usual.turbulence);
    all.add("octaves", pattern.octaves, usual.octaves);
    all.add("lambda", pattern.lambda, usual.lambda);
    all.add("omega", pattern.omega, usual.omega);
    all.add("noise", pattern.noiseGenerator, usual.noiseGenerator);
    all.add("along", pattern.gradient, usual.gradient);
    all.add("agate turbulence", pattern.agateTurbulence, usual.agateTurbulence);
    all.add("brick", pattern.brickSize, usual.brickSize);
    all.add("mortar", pattern.mortar, usual.mortar);
    all.add("form", pattern.crackle.form, usual.crackle.form);
    all.add("metric", pattern.crackle.metric, usual.crackle.metric);
    all.add("offset", pattern.crackle.offset, usual.crackle.offset);
    all.add("solid", pattern.crackle.solid, usual.crackle.solid);
    all.add("iterations", pattern.iterations, usual.iterations);
    all.add("exterior", pattern.exterior, usual.exterior);
    all.add("interior", pattern.interior, usual.interior);
    all.add("exponent", pattern.exponent, usual.exponent);
    all.add("magnet", pattern.magnetType, usual.magnetType);
    all.add("point", pattern.juliaPoint, usual.juliaPoint);
    all.add("control0", pattern.control0, usual.control0);
    all.add("control1", pattern.control1, usual.control1);
    all.add("direction", pattern.slope.direction, usual.slope.direction);
    all.add("from", pattern.slope.slopes.low, usual.slope.slopes.low);
    all.add("to", pattern.slope.slopes.high, usual.slope.slopes.high);
    all.add("altitude", pattern.slope.altitude, usual.slope.altitude);
    all.add("altitude from", pattern.slope.altitudes.low, usual.slope.altitudes.low);
    all.add("altitude to", pattern.slope.altitudes.high, usual.slope.altitudes.high);
    all.add("arms", pattern.arms, usual.arms);
    for (const PatternWarp& warp : pattern.warps) all.put(warpText(warp));
    return all.text();
}

std::string description(const Pigment& pigment) {
    if (const auto* solid = std::get_if<SolidPigment>(&pigment))
        return solid->standsFor.empty() ? told(solid->color)
                                        : "for " + solid->standsFor + ": " + told(solid->color);
    const MappedPigment& mapped = *std::get<std::shared_ptr<const MappedPigment>>(pigment);
    std::string text = mapped.image ? "image" : description(mapped.pattern);
    if (mapped.kind != MapKind::blend) text += mapped.kind == MapKind::list ? " list" : " average";
    if (mapped.onSurface) text += " uv";
    for (const MappedPigment::Entry& entry : mapped.entries)
        text += " [" + told(entry.position) + " " + description(entry.pigment) + "]";
    for (const std::string& word : mapped.notSimulated) text += " without " + word;
    return text;
}

std::string description(const Finish& finish) {
    const Finish usual;
    Differences all;
    all.add("ambient", finish.ambient, usual.ambient);
    all.add("emission", finish.emission, usual.emission);
    all.add("diffuse", finish.diffuse, usual.diffuse);
    all.add("from behind", finish.diffuseBack, usual.diffuseBack);
    all.add("brilliance", finish.brilliance, usual.brilliance);
    all.add("phong", finish.phong, usual.phong);
    all.add("phong_size", finish.phongSize, usual.phongSize);
    all.add("specular", finish.specular, usual.specular);
    all.add("roughness", finish.roughness, usual.roughness);
    all.add("diffuse albedo", finish.diffuseAlbedo, usual.diffuseAlbedo);
    all.add("phong albedo", finish.phongAlbedo, usual.phongAlbedo);
    all.add("specular albedo", finish.specularAlbedo, usual.specularAlbedo);
    all.add("metallic", finish.metallic, usual.metallic);
    all.add("crand", finish.crand, usual.crand);
    all.add("least reflection", finish.reflectionMinimum, usual.reflectionMinimum);
    all.add("most reflection", finish.reflectionMaximum, usual.reflectionMaximum);
    all.add("falloff", finish.reflectionFalloff, usual.reflectionFalloff);
    all.add("fresnel", finish.reflectionFresnel, usual.reflectionFresnel);
    all.add("exponent", finish.reflectionExponent, usual.reflectionExponent);
    all.add("metallic reflection", finish.reflectionMetallic, usual.reflectionMetallic);
    all.add("conserves energy", finish.conserveEnergy, usual.conserveEnergy);
    all.add("irid", finish.irid, usual.irid);
    all.add("thickness", finish.iridThickness, usual.iridThickness);
    all.add("turbulence", finish.iridTurbulence, usual.iridTurbulence);
    for (const std::string& word : finish.notSimulated) all.put("without " + word);
    return all.text();
}

std::string description(const SurfaceNormal& normal) {
    const SurfaceNormal usual;
    Differences all;
    all.put("kind " + told(static_cast<int>(normal.kind)) + " of " + description(normal.pattern));
    all.add("flat", normal.flat, usual.flat);
    all.add("amount", normal.amount, usual.amount);
    all.add("accuracy", normal.accuracy, usual.accuracy);
    all.add("scaled", normal.scaled, usual.scaled);
    all.add("uv", normal.onSurface, usual.onSurface);
    if (normal.image) all.put("image");
    for (const SlopeEntry& entry : normal.slopes)
        all.put("[" + told(entry.position) + " " + told(entry.height) + " " + told(entry.slope) + "]");
    if (normal.mapKind != MapKind::blend) all.put(normal.mapKind == MapKind::list ? "list" : "average");
    for (const SurfaceNormal::Entry& entry : normal.entries)
        all.put("[" + told(entry.position) + " " + (entry.normal ? description(*entry.normal) : "none") +
                "]");
    return all.text();
}

std::string description(const LightSource& light) {
    const LightSource usual;
    Differences all;
    all.put("kind " + told(static_cast<int>(light.kind)));
    all.add("at", light.location, usual.location);
    all.add("color", light.color, usual.color);
    all.add("to", light.pointAt, usual.pointAt);
    all.add("radius", light.radius, usual.radius);
    all.add("falloff", light.falloff, usual.falloff);
    all.add("tightness", light.tightness, usual.tightness);
    all.add("fade_distance", light.fadeDistance, usual.fadeDistance);
    all.add("fade_power", light.fadePower, usual.fadePower);
    all.add("shadowless", light.shadowless, usual.shadowless);
    all.add("dimmed", light.mediaAttenuation, usual.mediaAttenuation);
    all.add("scattered", light.mediaInteraction, usual.mediaInteraction);
    if (light.area) {
        const LightArea& area = *light.area;
        all.put("area " + told(area.edge) + ", " + told(area.otherEdge) + ", " + told(area.columns) + " " +
                told(area.rows));
        all.add("adaptive", area.adaptive, LightArea().adaptive);
        all.add("jitter", area.jitter, false);
        all.add("circular", area.circular, false);
        all.add("orient", area.orient, false);
        all.add("illumination", area.illumination, false);
    }
    if (light.projectedThrough) all.put("projected");
    all.put("line " + told(light.line));
    return all.text();
}

const Material& materialOf(const ParseResult& parsed) {
    return parsed.scene->materials.at(static_cast<std::size_t>(parsed.scene->objects.at(0).material));
}

}  // namespace

class StatementValuesTest : public QObject {
    Q_OBJECT

  private slots:
    void pigments_data() {
        columns();
        row("agate agate_turb 0.5", "agate, agate turbulence 0.5");
        row("bozo turbulence 0.3 octaves 4 lambda 2.5 omega 0.4",
            "bozo, turbulence 0.3 0.3 0.3, octaves 4, lambda 2.5, omega 0.4");
        row("bozo turbulence <0.1, 0.2, 0.3> octaves 20", "bozo, turbulence 0.1 0.2 0.3, octaves 10");
        row("bozo octaves 0 noise_generator 3", "bozo, octaves 1, noise 3");
        row("bozo frequency 3 phase 0.25 noise_generator 3", "bozo, frequency 3, phase 0.25, noise 3");
        row("bozo ramp_wave", "bozo, wave 0");
        row("bozo triangle_wave", "bozo, wave 1");
        row("bozo sine_wave", "bozo, wave 2");
        row("bozo scallop_wave", "bozo, wave 3");
        row("bozo cubic_wave", "bozo, wave 4");
        row("bozo poly_wave", "bozo, wave 5");
        row("bozo poly_wave 3", "bozo, wave 5, exponent of the wave 3");
        row("brick color rgb 1 color rgb 0 brick_size <1, 2, 3> mortar 0.1",
            "brick, brick 1 2 3, mortar 0.1 list [0 1 1 1] [1 0 0 0]");
        row("checker color rgb 1, color rgb 0.5", "checker list [0 1 1 1] [1 0.5 0.5 0.5]");
        row("crackle form <1, 0.5, 0> metric 3 offset 0.2", "crackle, form 1 0.5 0, metric 3, offset 0.2");
        row("crackle solid", "crackle, solid yes");
        row("gradient <1, 2, 3>", "gradient, along 1 2 3");
        row("gradient y color_map { [0 rgb 0] [0.4 color rgb <1, 0.5, 0>] [1 rgbft <0, 0, 1, 0.25, 0.5>] }",
            "gradient, along 0 1 0 [0 0 0 0] [0.4 1 0.5 0] [1 0 0 1 filter 0.25 transmit 0.5]");
        row("gradient y color_map { [0, 0.5 color rgb 1 color rgb 0] [0.5, 1 color rgb 0 color rgb 1] }",
            "gradient, along 0 1 0 [0 1 1 1] [0.5 0 0 0] [0.5 0 0 0] [1 1 1 1]");
        row("gradient y pigment_map { [0.25 rgb 1] [0.75 granite scale 2] }",
            "gradient, along 0 1 0 [0.25 1 1 1] [0.75 granite, (transform 0.5 0 0 0 0.5 0 0 0 0.5 0 0 0)]");
        row("average pigment_map { [1 rgb 1] [3 rgb 0.5] }", "0.625 0.625 0.625");
        row("mandel 12", "mandel, iterations 12");
        row("mandel 12 exponent 3 exterior 2, 0.5 interior 4, 2.5",
            "mandel, iterations 12, exterior 2 0.5, interior 4 2.5, exponent 3");
        row("julia <0.3, 0.4>, 30", "julia, iterations 30, point 0.3 0.4");
        row("magnet 2 mandel 15", "magnet mandel, iterations 15, magnet 2");
        row("magnet 1 julia <0.1, 0.2>, 20 exterior 0, 3",
            "magnet julia, iterations 20, exterior 0 3, point 0.1 0.2");
        row("quilted control0 0.25 control1 0.75", "quilted, control0 0.25, control1 0.75");
        row("spiral1 3", "spiral1, arms 3");
        row("spiral2 20000", "spiral2, arms 10000");
        row("slope <1, 2, 3>", "slope, direction 1 2 3");
        row("slope { <0, 1, 0>, 0.2, 0.8 }", "slope, from 0.2, to 0.8");
        row("slope { y, 0.2 altitude <0, 0, 1>, -2, 3 }",
            "slope, from 0.2, altitude 0 0 1, altitude from -2, altitude to 3");
        row("aoi", "aoi");
        row("function { x*y }", "function");
        row("wood translate <1, 2, 3>", "wood, (transform 1 0 0 0 1 0 0 0 1 -1 -2 -3)");
        row("wood scale 2", "wood, (transform 0.5 0 0 0 0.5 0 0 0 0.5 0 0 0)");
        row("wood rotate 90*z", "wood, (transform 0 -1 0 1 0 0 0 0 1 0 0 0)");
        row("wood warp { turbulence <1, 2, 3> octaves 3 lambda 1.5 omega 0.75 }",
            "wood, (turbulence 1 2 3, 3 1.5 0.75)");
        row("wood warp { repeat 2*y offset <1, 0, 0.5> flip <1, 0, 1> }",
            "wood, (repeat axis 1 2 offset 1 0 0.5 flip yes no yes)");
        row("wood warp { repeat <0, 0, 3> }", "wood, (repeat axis 2 3 offset 0 0 0 flip no no no)");
        row("wood warp { black_hole <1, 2, 3>, 0.5 strength 2 falloff 3 inverse }",
            "wood, (black_hole 1 2 3, 0.5 2 3 repeat 0 0 0 turbulence 0 0 0 inverse)");
        row("wood warp { black_hole 0, 1 turbulence x inverse repeat <4, 0, 5> falloff 1 }",
            "wood, (black_hole 1 0 1, 1 1 1 repeat 4 0 5 turbulence 1 0 0 inverse)");
        row("wood warp { planar y, 0.5 }", "wood, (planar 0 1 0 0.5)");
        row("wood warp { planar }", "wood, (planar 0 0 1 0)");
        row("wood warp { spherical }", "wood, (round 0 0 0 1 0 1)");
        row("wood warp { cylindrical orientation y dist_exp 1 }", "wood, (round 1 0 1 0 1 1)");
        row("wood warp { toroidal orientation x dist_exp 2 major_radius 3 }", "wood, (round 2 1 0 0 2 3)");
        row("rgb <0.1, 0.2, 0.3>", "0.1 0.2 0.3");
        row("rgbf <0.1, 0.2, 0.3, 0.4>", "0.1 0.2 0.3 filter 0.4");
        row("rgbt <0.1, 0.2, 0.3, 0.4>", "0.1 0.2 0.3 transmit 0.4");
        row("red 0.5 green 0.25 filter 0.125", "0.5 0.25 0 filter 0.125");
        row("uv_mapping marble", "marble uv");
        row("uv_mapping radial", "radial uv");
        row("granite quick_color rgb 1", "granite");
        row("object { sphere { 0, 1 } color rgb 1 color rgb 0.5 }",
            "function, frequency 0 list [0 1 1 1] [1 0.5 0.5 0.5]");
        row("pigment_pattern { gradient x } color_map { [0 rgb 0] [1 rgb 1] }",
            "function [0 0 0 0] [1 1 1 1]");
    }
    void pigments() {
        check("sphere { 0, 1 pigment { ", " } }",
              [](const ParseResult& parsed) { return description(materialOf(parsed).pigment); });
    }

    void finishes_data() {
        columns();
        row("ambient 0.3 emission <0.1, 0.2, 0.3>", "ambient 0.3 0.3 0.3, emission 0.1 0.2 0.3");
        row("ambient rgb <1, 0.5, 0.25>", "ambient 1 0.5 0.25");
        row("diffuse 0.7, 0.2", "diffuse 0.7, from behind 0.2");
        row("diffuse albedo 0.5", "diffuse 0.5");
        row("brilliance 2 phong 0.5 phong_size 80", "brilliance 2, phong 0.5, phong_size 80");
        row("phong albedo 0.5", "phong 10.25");
        row("specular albedo 0.5 roughness 0.01", "specular 6.375, roughness 0.01");
        row("specular 0.25 crand 0.1", "specular 0.25, crand 0.1");
        row("metallic", "metallic 1");
        row("metallic 0.5", "metallic 0.5");
        row("conserve_energy", "conserves energy yes");
        row("conserve_energy off", "");
        row("reflection 0.5", "least reflection 0.5 0.5 0.5, most reflection 0.5 0.5 0.5");
        row("reflection rgb <0.1, 0.2, 0.3>", "least reflection 0.1 0.2 0.3, most reflection 0.1 0.2 0.3");
        row("reflection { 0.5 }", "least reflection 0.5 0.5 0.5, most reflection 0.5 0.5 0.5");
        row("reflection { 0.1, 0.9 falloff 2 exponent 3 metallic }",
            "least reflection 0.1 0.1 0.1, most reflection 0.9 0.9 0.9, falloff 2, exponent 3, metallic "
            "reflection 1");
        row("reflection { 0.9 fresnel metallic 0.25 }",
            "least reflection 0.9 0.9 0.9, most reflection 0.9 0.9 0.9, fresnel yes, metallic reflection "
            "0.25");
        row("reflection { 0.9 fresnel off }", "least reflection 0.9 0.9 0.9, most reflection 0.9 0.9 0.9");
        row("reflection { 0.9 falloff 3 fresnel on } reflection 0.25",
            "least reflection 0.25 0.25 0.25, most reflection 0.25 0.25 0.25");
        row("reflection { falloff 2 }", "falloff 2");
        // As in POV-Ray, where nothing is written it is 0.
        row("reflection 0.5 reflection", "");
        row("ambient emission phong 0.3", "ambient 0 0 0, phong 0.3");
        row("reflection_exponent 2", "exponent 2");
        row("irid { 0.25 thickness 0.5 }", "irid 0.25, thickness 0.5");
        row("irid { 0.25 thickness 0.5 turbulence 0 }", "irid 0.25, thickness 0.5");
        row("irid { 0.25 turbulence 0.5 } phong 0.3", "phong 0.3, irid 0.25, turbulence 0.5");
        row("irid { 0.25 turbulence <0.5, 1, 2> }", "irid 0.25, turbulence 0.5");
        row("subsurface { translucency 0.5 } phong 0.3", "phong 0.3, without subsurface");
        row("ior 1.5 phong 0.3", "phong 0.3, without ior");
        row("use_alpha on phong 0.3", "phong 0.3, without use_alpha");
        row("use_alpha phong 0.3", "phong 0.3, without use_alpha");
        row("ior 1.5 use_alpha ior 2 phong 0.3", "phong 0.3, without ior, without use_alpha");
    }
    void finishes() {
        check("sphere { 0, 1 finish { ", " } }",
              [](const ParseResult& parsed) { return description(materialOf(parsed).finish); });
    }

    void normals_data() {
        columns();
        row("bumps 0.3", "kind 1 of kind 4, amount 0.3");
        row("bumps", "kind 1 of kind 4");
        row("dents 0.3 scale 0.5", "kind 2 of kind 8, (transform 2 0 0 0 2 0 0 0 2 0 0 0), amount 0.3");
        row("quilted 0.25 control0 0.5", "kind 3 of quilted, control0 0.5, amount 0.25");
        row("ripples 0.3 frequency 2", "kind 4 of kind 18, frequency 2, amount 0.3");
        row("waves 0.3 phase 0.25", "kind 5 of kind 23, phase 0.25, amount 0.3");
        row("wrinkles 0.3 turbulence 0.2", "kind 6 of kind 25, turbulence 0.2 0.2 0.2, amount 0.3");
        row("granite 0.3 accuracy 0.01", "kind 0 of granite, amount 0.3, accuracy 0.01");
        row("granite 0.3 no_bump_scale", "kind 0 of granite, amount 0.3, scaled no");
        row("granite, 0.3", "kind 0 of granite, amount 0.3");
        row("agate 0.3 agate_turb 0.5", "kind 0 of agate, agate turbulence 0.5, amount 0.3");
        row("gradient x 0.7", "kind 0 of gradient, amount 0.7");
        row("gradient x, 0.7 slope_map { [0 <0, 1>] [0.5 <1, 1>] [1 <0.25, -1>] }",
            "kind 0 of gradient, amount 0.7, [0 0 1], [0.5 1 1], [1 0.25 -1]");
        row("gradient x normal_map { [0.25 bumps 0.1] [0.75 granite 0.2 scale 2] }",
            "kind 8 of gradient, [0.25 kind 1 of kind 4, amount 0.1], [0.75 kind 0 of granite, (transform "
            "0.5 0 0 0 0.5 0 0 0 0.5 0 0 0), amount 0.2]");
        row("average normal_map { [1 bumps 0.1] [3 dents 0.2] }",
            "kind 8 of bozo, average, [1 kind 1 of kind 4, amount 0.1], [3 kind 2 of kind 8, amount 0.2]");
        row("checker normal { bumps 0.1 } normal { dents 0.2 }",
            "kind 8 of checker, list, [0 kind 1 of kind 4, amount 0.1], [1 kind 2 of kind 8, amount 0.2]");
        row("brick normal { bumps 0.1 } normal { dents 0.2 } mortar 0.25",
            "kind 8 of brick, mortar 0.25, list, [0 kind 1 of kind 4, amount 0.1], [1 kind 2 of kind 8, "
            "amount 0.2]");
        row("uv_mapping granite 0.3", "kind 0 of granite, amount 0.3, uv yes");
        row("uv_mapping granite 0.3", "kind 0 of granite, amount 0.3, uv yes");
        row("function { x } 0.5", "kind 0 of function");
        row("crackle 0.3 form <0, 1, 0> metric 3", "kind 0 of crackle, form 0 1 0, metric 3, amount 0.3");
    }
    void normals() {
        check("sphere { 0, 1 normal { ", " } }", [](const ParseResult& parsed) {
            const auto& normal = materialOf(parsed).normal;
            return normal ? description(*normal) : std::string("none");
        });
    }

    /// As in POV-Ray, the number behind the name takes the place of its own; it was an error here.
    void aNumberBehindTheNameOfANormalIsItsAmount() {
        for (const std::string text : {"normal { N 0.3 }", "normal { N, 0.3 scale 2 }"}) {
            const ParseResult parsed = parseScene(
                "#declare N = normal { bumps 0.5 }\nsphere { 0, 1 pigment { rgb 1 } " + text + " }");
            QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
            QCOMPARE(materialOf(parsed).normal->amount, 0.3);
            QVERIFY(materialOf(parsed).normal->kind == NormalKind::bumps);
        }
    }

    /// A texture begins with what was declared as a part of one.
    void texturesBeginWithDeclaredParts() {
        const ParseResult parsed = parseScene(
            "#declare P = pigment { rgb 0.25 } #declare N = normal { bumps 0.5 } #declare F = finish { phong "
            "0.5 }"
            "sphere { 0, 1 texture { P finish { F } normal { N } } } sphere { 3*x, 1 texture { F pigment { P "
            "} } }"
            "sphere { 6*x, 1 texture { N pigment { P } } }");
        QVERIFY(parsed.ok());
        const std::string finishes[] = {"phong 0.5", "phong 0.5", ""};
        const bool bumps[] = {true, false, true};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto id = static_cast<std::size_t>(parsed.scene->objects.at(i).material);
            const Material& material = parsed.scene->materials.at(id);
            QCOMPARE(description(material.pigment), std::string("0.25 0.25 0.25"));
            QCOMPARE(description(material.finish), finishes[i]);
            QCOMPARE(static_cast<bool>(material.normal), bumps[i]);
        }
    }

    /// The first is where the checker has 1.
    void tilesAreACheckerFromItsEnd() {
        const ParseResult parsed = parseScene(
            "sphere { 0, 1 texture { tiles { texture { pigment { rgb 0.25 } } tile2 texture { pigment { rgb "
            "0.75 } } } } }");
        QVERIFY2(complaintsOf(parsed).empty(), problems(parsed).c_str());
        const auto map = materialOf(parsed).map;
        QVERIFY(map && map->entries.size() == 2 && map->kind == MapKind::list);
        QCOMPARE(map->pattern.kind, PatternKind::checker);
        QCOMPARE(description(map->entries[0].material.pigment), std::string("0.75 0.75 0.75"));
        QCOMPARE(description(map->entries[1].material.pigment), std::string("0.25 0.25 0.25"));
    }

    void lights_data() {
        columns();
        row("light_source { <1, 2, 3>, rgb <0.5, 0.25, 1> }", "kind 0, at 1 2 3, color 0.5 0.25 1, line 1");
        row("light_source { <1, 2, 3> 0.5 }",
            "kind 0, at 1 2 3, color 0.5 0.5 0.5 filter 0.5 transmit 0.5, line 1");
        row("light_source { 0, 1 spotlight point_at <1, 2, 3> radius 10 falloff 20 tightness 5 }",
            "kind 1, color 1 1 1 filter 1 transmit 1, to 1 2 3, radius 10, falloff 20, tightness 5, line 1");
        row("light_source { 0, 1 cylinder point_at y radius 0.5 falloff 0.75 }",
            "kind 2, color 1 1 1 filter 1 transmit 1, to 0 1 0, radius 0.5, falloff 0.75, line 1");
        row("light_source { 0, 1 parallel point_at -y shadowless }",
            "kind 3, color 1 1 1 filter 1 transmit 1, to 0 -1 0, shadowless yes, line 1");
        row("light_source { 0, 1 fade_distance 3 fade_power 2 }",
            "kind 0, color 1 1 1 filter 1 transmit 1, fade_distance 3, fade_power 2, line 1");
        row("light_source { 0, 1 color rgb 0.25 }", "kind 0, color 0.25 0.25 0.25, line 1");
        row("light_source { 0, 1 parallel shadowless }",
            "kind 3, color 1 1 1 filter 1 transmit 1, shadowless yes, line 1");
        row("light_source { 0, 1 area_light 2*x, 3*y, 4, 5 }",
            "kind 0, color 1 1 1 filter 1 transmit 1, area 2 0 0, 0 3 0, 4 5, line 1");
        row("light_source { 0, 1 area_light 2*x 3*y 4 5 adaptive 2 jitter circular orient }",
            "kind 0, color 1 1 1 filter 1 transmit 1, area 2 0 0, 0 3 0, 4 5, adaptive 2, jitter yes, "
            "circular yes, orient yes, line 1");
        row("light_source { 0, 1 area_light x, y, 2.9, 1000 adaptive 200 jitter off circular on }",
            "kind 0, color 1 1 1 filter 1 transmit 1, area 1 0 0, 0 1 0, 2 1000, circular yes, line 1");
        row("light_source { 0, 1 area_light x, y, 2, 2 adaptive -3 area_illumination }",
            "kind 0, color 1 1 1 filter 1 transmit 1, area 1 0 0, 0 1 0, 2 2, adaptive 0, illumination yes, "
            "line 1");
        row("light_source { 0, 1 area_light x, y, 2, 2 adaptive 0.5 area_illumination off jitter 1 }",
            "kind 0, color 1 1 1 filter 1 transmit 1, area 1 0 0, 0 1 0, 2 2, adaptive 0, jitter yes, line "
            "1");
        row("light_source { 0, 1 adaptive 3 jitter }", "kind 0, color 1 1 1 filter 1 transmit 1, line 1");
        row("light_source { x, 1 spotlight point_at y area_light x, y, 2, 2 translate 2*z scale 2 }",
            "kind 1, at 2 0 4, color 1 1 1 filter 1 transmit 1, to 0 2 4, area 2 0 0, 0 2 0, 2 2, line 1");
        row("light_source { x, 1 area_light x, 2*y, 2, 2 rotate 90*z fade_power 2 }",
            "kind 0, at 0 1 0, color 1 1 1 filter 1 transmit 1, fade_power 2, area 0 1 0, -2 0 0, 2 2, line "
            "1");
        row("light_source { 0, 1 media_attenuation }",
            "kind 0, color 1 1 1 filter 1 transmit 1, dimmed yes, line 1");
        row("light_source { 0, 1 media_attenuation on media_interaction off fade_power 2 }",
            "kind 0, color 1 1 1 filter 1 transmit 1, fade_power 2, dimmed yes, scattered no, line 1");
        row("light_source { 0, 1 media_attenuation off }", "kind 0, color 1 1 1 filter 1 transmit 1, line 1");
        row("light_source { 0, 1 photons { reflection on } fade_power 2 }",
            "kind 0, color 1 1 1 filter 1 transmit 1, fade_power 2, line 1");
        row("\n\n#declare L = light_source { x, 0.5 shadowless }\nlight_source { L translate y }",
            "kind 0, at 1 1 0, color 0.5 0.5 0.5 filter 0.5 transmit 0.5, to 0 1 0, shadowless yes, line 4");
        row("light_source { 0, 1 projected_through { sphere { 0, 1 } } }",
            "kind 0, color 1 1 1 filter 1 transmit 1, projected, line 1");
        row("\nlight_source { x, 1 looks_like { sphere { 0, 1 } } translate y }",
            "kind 0, at 1 1 0, color 1 1 1 filter 1 transmit 1, to 0 1 0, line 2");
        row("\n\nlight_source { x, 1 }", "kind 0, at 1 0 0, color 1 1 1 filter 1 transmit 1, line 3");
    }
    void lights() {
        check("", "", [](const ParseResult& parsed) { return description(parsed.scene->lights.at(0)); });
    }

    /// Found by fuzzing: a #default within a texture freed the material that the texture goes on with.
    void defaultsWithinATextureLeaveItsOwnAlone() {
        std::string text =
            "#default { pigment { rgb <0.25, 0.5, 1> } }\n"
            "sphere { 0, 1 texture { hexagon texture { pigment { rgb x } }\n";
        for (int k = 0; k < 20; ++k) text += "#default { pigment { rgb y } }\n";
        const ParseResult parsed = parseScene(text + "} }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const Material& material =
            parsed.scene->materials.at(std::size_t(parsed.scene->objects.at(0).material));
        QVERIFY(material.map);
        QCOMPARE(material.map->entries.size(), std::size_t(3));
        QCOMPARE(std::get<SolidPigment>(material.map->entries[2].material.pigment).color.red, 0.25);
    }
};

QTEST_APPLESS_MAIN(StatementValuesTest)
#include "statement_values_test.moc"
