// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/default_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// Horizontal field of view of the camera that is added.
constexpr double angle = 40;
/// How much farther away than needed it stands, so that nothing touches the edge.
constexpr double margin = 1.1;

Bounds finiteBounds(const Scene& scene) {
    Bounds all;
    bool any = false;
    for (const SceneObject& object : scene.objects) {
        const Bounds bounds = object.shape->bounds();
        if (!bounds.finite()) continue;
        all = any ? unite(all, bounds) : bounds;
        any = true;
    }
    return any ? all : Bounds{glm::dvec3(-1), glm::dvec3(1)};
}

Camera viewOf(const Bounds& bounds, double aspect) {
    const glm::dvec3 center = 0.5 * (bounds.low + bounds.high);
    const double radius = std::max(0.5 * glm::length(bounds.high - bounds.low), 1e-3);
    // The smaller of the two fields of view must hold the whole sphere.
    const double half = angle / 2 * std::numbers::pi / 180;
    const double smaller = aspect > 1 ? std::atan(std::tan(half) / aspect) : half;
    Camera camera;
    camera.right = {aspect, 0, 0};
    camera.location =
        center + glm::normalize(glm::dvec3(0.8, 0.6, -1)) * (margin * radius / std::sin(smaller));
    return camera.withAngle(angle).lookingAt(center);
}

std::string vectorText(const glm::dvec3& v) {
    return "<" + fixedNumber(v.x, 2) + ", " + fixedNumber(v.y, 2) + ", " + fixedNumber(v.z, 2) + ">";
}

/// The camera of viewOf() as a statement.
std::string cameraText(const Camera& camera) {
    return "\ncamera {\n  location " + vectorText(camera.location) +
           "\n  right x*image_width/image_height\n  look_at " + vectorText(camera.lookAt) + "\n  angle " +
           std::to_string(static_cast<int>(angle)) + "\n}\n";
}

/// From this much ambient light on a surface is meant to be seen by it alone.
constexpr double brightAmbient = 0.5;

/// Whether something is to be seen without any light.
bool shines(const Scene& scene) {
    const auto largest = [](const Color& c) { return std::max({c.red, c.green, c.blue}); };
    return std::any_of(scene.materials.begin(), scene.materials.end(), [&](const Material& material) {
        return largest(material.finish.emission) > 0 || largest(material.finish.ambient) >= brightAmbient;
    });
}

}  // namespace

void addDefaultView(SceneDraft& draft, ParseContext& context) {
    Scene& scene = draft.scene;
    const auto note = [&](const char* id, const char* message, QuickFix fix) {
        if (!scene.objects.empty())
            context.report({Severity::note, id, {}, message, {}, {}, {std::move(fix)}});
    };
    // Statements are added behind everything else.
    const auto end =
        static_cast<std::uint32_t>(context.sources.size() ? context.sources[0].text().size() : 0);
    const SourceRange behind{0, end, end};
    if (!draft.hasCamera) {
        const ParseOptions& options = context.options;
        const bool sized = options.imageWidth > 0 && options.imageHeight > 0;
        scene.camera =
            viewOf(finiteBounds(scene), sized ? double(options.imageWidth) / options.imageHeight : 4.0 / 3);
        note("no-camera", "The text has no camera; one that sees all objects is added.",
             {"Add a Camera", behind, cameraText(scene.camera)});
    }
    if (scene.lights.empty() && !shines(scene)) {
        LightSource light;
        light.location = scene.camera.location;
        scene.lights.push_back(light);
        note("no-light",
             "The text has no light: POV-Ray shows it black. Here a light at the camera is added.",
             {"Add a Light", behind, "\nlight_source { " + vectorText(light.location) + " rgb 1 }\n"});
    }
}

}  // namespace isoscope
