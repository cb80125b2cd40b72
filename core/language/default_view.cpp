// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/default_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

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
    const auto note = [&](const char* id, const char* message) {
        if (!scene.objects.empty()) context.report({Severity::note, id, {}, message, {}, {}});
    };
    if (!draft.hasCamera) {
        const ParseOptions& options = context.options;
        const bool sized = options.imageWidth > 0 && options.imageHeight > 0;
        scene.camera =
            viewOf(finiteBounds(scene), sized ? double(options.imageWidth) / options.imageHeight : 4.0 / 3);
        note("no-camera", "The text has no camera; one that sees all objects is added.");
    }
    if (scene.lights.empty() && !shines(scene)) {
        LightSource light;
        light.location = scene.camera.location;
        scene.lights.push_back(light);
        note("no-light", "The text has no light; one at the camera is added.");
    }
}

}  // namespace isoscope
