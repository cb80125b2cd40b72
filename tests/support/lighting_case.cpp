// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/lighting_case.h"

#include <sstream>

#include "core/shapes/solids/box.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"

namespace isoscope::test {

namespace {

std::string text(const glm::dvec3& v) {
    std::ostringstream out;
    out.precision(17);
    out << '<' << v.x << ',' << v.y << ',' << v.z << '>';
    return out.str();
}

std::string text(const Color& c) { return "rgb " + text(glm::dvec3(c.red, c.green, c.blue)); }

std::string text(const Finish& f) {
    std::ostringstream out;
    out << "finish { ambient " << text(f.ambient) << " emission " << text(f.emission) << " diffuse "
        << f.diffuse << ',' << f.diffuseBack << " brilliance " << f.brilliance << " phong " << f.phong
        << " phong_size " << f.phongSize << " specular " << f.specular << " roughness " << f.roughness;
    if (f.metallic != 0) out << " metallic " << f.metallic;
    out << " }";
    return out.str();
}

std::string text(const LightSource& l) {
    std::ostringstream out;
    out << "light_source { " << text(l.location) << ", " << text(l.color);
    if (l.kind == LightKind::spotlight) out << " spotlight";
    if (l.kind == LightKind::cylinder) out << " cylinder";
    if (l.kind == LightKind::parallel) out << " parallel";
    if (l.kind != LightKind::point) out << " point_at " << text(l.pointAt);
    if (l.kind == LightKind::spotlight || l.kind == LightKind::cylinder)
        out << " radius " << l.radius << " falloff " << l.falloff << " tightness " << l.tightness;
    if (l.fadePower != 0) out << " fade_distance " << l.fadeDistance << " fade_power " << l.fadePower;
    if (l.shadowless) out << " shadowless";
    out << " }\n";
    return out.str();
}

}  // namespace

std::string povrayText(const LightingCase& item) {
    std::ostringstream out;
    out.precision(17);
    out << "#version 3.7;\nglobal_settings { ";
    if (item.assumedGamma == srgbGamma)
        out << "assumed_gamma srgb";
    else
        out << "assumed_gamma " << item.assumedGamma;
    out << " ambient_light " << text(item.ambientLight) << " }\n"
        << "camera { location <0,1,-4> right x*4/3 look_at 0 }\nbackground { rgb <0.1,0.3,0.6> }\n";
    for (const LightSource& light : item.lights) out << text(light);
    const std::string texture = " pigment { " + text(item.pigment) + " } " + text(item.finish) + " }\n";
    out << "sphere { 0, 1" << texture << "plane { y, -1" << texture;
    if (item.box) out << "box { <1.2,-1,-1>, <1.6,1,0>" << (item.boxCasts ? "" : " no_shadow") << texture;
    return out.str();
}

std::shared_ptr<const Scene> sceneOf(const LightingCase& item) {
    auto scene = std::make_shared<Scene>();
    scene->camera.location = {0, 1, -4};
    scene->camera.right = {4.0 / 3, 0, 0};
    scene->camera = scene->camera.lookingAt({0, 0, 0});
    scene->background = {0.1, 0.3, 0.6};
    scene->lights = item.lights;
    scene->settings.assumedGamma = item.assumedGamma;
    scene->settings.ambientLight = item.ambientLight;
    SolidPigment pigment;
    pigment.color = item.pigment;
    Material material;
    material.pigment = pigment;
    material.finish = item.finish;
    scene->materials.push_back(material);
    const auto add = [&](ShapePointer shape, bool casts) {
        SceneObject object;
        object.shape = std::move(shape);
        object.material = 0;
        object.castsShadow = casts;
        scene->objects.push_back(object);
    };
    add(std::make_shared<Sphere>(glm::dvec3(0), 1.0), true);
    add(std::make_shared<Plane>(glm::dvec3(0, 1, 0), -1.0), true);
    if (item.box) add(std::make_shared<Box>(glm::dvec3(1.2, -1, -1), glm::dvec3(1.6, 1, 0)), item.boxCasts);
    return scene;
}

}  // namespace isoscope::test
