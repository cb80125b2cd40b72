// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/pov_export.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "core/exchange/statement_scanner.h"
#include "core/scene/camera_statement.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string vectorText(const glm::dvec3& v) {
    return "<" + shortestNumber(v.x) + ", " + shortestNumber(v.y) + ", " + shortestNumber(v.z) + ">";
}

bool near(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(a, b) <= 1e-12 * std::max(glm::length(a), glm::length(b));
}

/// A length without the last digits that turning the camera has frayed: 1.5, not 1.4999999999999998.
double plainLength(const glm::dvec3& v) {
    return leadingNumber(generalNumber(glm::length(v), 14).c_str(), nullptr);
}

/// The camera as look_at makes it from lengths alone; only some cameras can be written that way.
CameraStatement byLookAt(const Camera& camera) {
    const bool mirrored = glm::dot(glm::cross(camera.up, camera.direction), camera.right) < 0;
    CameraStatement statement;
    statement.kind = camera.kind;
    statement.location = camera.location;
    statement.direction = glm::dvec3(0, 0, plainLength(camera.direction));
    statement.right = glm::dvec3((mirrored ? -1 : 1) * plainLength(camera.right), 0, 0);
    statement.up = glm::dvec3(0, plainLength(camera.up), 0);
    statement.sky = camera.sky;
    statement.lookAt = camera.lookAt;
    return statement;
}

CameraStatement byAxes(const Camera& camera) {
    CameraStatement statement;
    statement.kind = camera.kind;
    statement.location = camera.location;
    statement.direction = camera.direction;
    statement.right = camera.right;
    statement.up = camera.up;
    statement.sky = camera.sky;
    return statement;
}

/// As the scene language says it.
const char* kindText(CameraKind kind) {
    static constexpr std::array texts{"perspective", "orthographic", "fisheye",   "ultra_wide_angle",
                                      "omnimax",     "panoramic",    "spherical", "cylinder 1",
                                      "cylinder 2",  "cylinder 3",   "cylinder 4"};
    return texts[static_cast<std::size_t>(kind)];
}

std::string anglesText(const Camera& camera) {
    const std::string horizontal = shortestNumber(camera.angle);
    return camera.kind == CameraKind::spherical ? horizontal + ", " + shortestNumber(camera.verticalAngle)
                                                : horizontal;
}

std::string blurText(const FocalBlur& blur) {
    return "    aperture " + shortestNumber(blur.aperture) + "\n    blur_samples " +
           std::to_string(blur.samples) + "\n    focal_point " + vectorText(blur.focalPoint) +
           "\n    confidence " + shortestNumber(blur.confidence) + "\n    variance " +
           shortestNumber(blur.variance) + "\n";
}

bool sameView(const Camera& a, const Camera& b) {
    return near(a.direction, b.direction) && near(a.right, b.right) && near(a.up, b.up);
}

bool hasVersion(const std::vector<ScenePiece>& pieces) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [](const ScenePiece& piece) { return piece.directive == "version"; });
}

void appendLine(std::string& text, const std::string& line) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    text += line;
    text += '\n';
}

/// The light that shows a text without lights; the parser gives it no line.
const LightSource* addedLight(const Scene& scene) {
    const bool added = scene.lights.size() == 1 && scene.lights.front().line == 0;
    return added ? &scene.lights.front() : nullptr;
}

}  // namespace

std::string cameraBlock(const Camera& camera) {
    const CameraStatement compact = byLookAt(camera);
    const CameraStatement statement = sameView(compact.camera(), camera) ? compact : byAxes(camera);
    std::string text = "camera {\n";
    // POV-Ray wants the kind first.
    if (camera.kind != CameraKind::perspective) text += std::string("    ") + kindText(camera.kind) + "\n";
    const auto item = [&](const char* word, const std::optional<glm::dvec3>& value) {
        if (value) text += std::string("    ") + word + " " + vectorText(*value) + "\n";
    };
    item("location", statement.location);
    item("direction", statement.direction);
    item("right", statement.right);
    item("up", statement.up);
    item("sky", statement.sky);
    item("look_at", statement.lookAt);
    if (!camera.flat()) text += "    angle " + anglesText(camera) + "\n";
    if (camera.blur.any()) text += blurText(camera.blur);
    if (camera.normal) text += "    " + camera.normalText + "\n";
    return text + "}";
}

std::string exportScene(const Scene& scene, const Camera& camera, const std::string& text, int, int) {
    std::string result = text;
    const std::optional<SourceRange>& place = scene.cameraRange;
    const bool placed = place && place->file == 0 && place->begin <= place->end && place->end <= text.size();
    if (placed && !(camera == scene.camera))
        result.replace(place->begin, place->end - place->begin, cameraBlock(camera));
    // POV-Ray takes the last camera, so that one in an include file is overruled.
    if (!placed) appendLine(result, cameraBlock(camera));
    if (const LightSource* light = addedLight(scene))
        appendLine(result, "light_source { " + vectorText(light->location) + ", rgb 1 }");
    if (!hasVersion(scanPieces(text))) result.insert(0, "#version 3.7;\n");
    return result;
}

}  // namespace isoscope
