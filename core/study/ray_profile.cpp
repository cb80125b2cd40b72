// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/ray_profile.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>

#include "core/roots/certified_root_finder.h"
#include "core/roots/lipschitz_root_finder.h"
#include "core/roots/tape_field.h"
#include "core/shapes/line_interval.h"

namespace isoscope {

namespace {

/// Notes where a root finder looks.
class RecordingField : public FieldFunction {
  public:
    RecordingField(std::unique_ptr<FieldFunction> field, const LineQuery& line, const RootSettings& settings,
                   std::vector<ProfilePoint>& visited)
        : field_(std::move(field)), line_(line), settings_(settings), visited_(visited) {}

    void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) override {
        field_->values(x, y, z, out);
        const double square = glm::dot(line_.direction, line_.direction);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const glm::dvec3 way = glm::dvec3(x[i], y[i], z[i]) - line_.origin;
            visited_.push_back({glm::dot(way, line_.direction) / square, settings_.signedValue(out[i])});
        }
    }

  private:
    std::unique_ptr<FieldFunction> field_;
    LineQuery line_;
    const RootSettings& settings_;
    std::vector<ProfilePoint>& visited_;
};

LineInterval insideOf(const Container& container, const Ray& ray) {
    if (const auto* box = std::get_if<ContainerBox>(&container)) return boxInterval(ray, box->low, box->high);
    const auto& sphere = std::get<ContainerSphere>(container);
    return sphereInterval(ray, sphere.center, sphere.radius);
}

std::vector<ProfilePoint> curveOf(TapeField& field, const LineQuery& line, const RootSettings& settings,
                                  int count) {
    std::vector<double> x, y, z, values(static_cast<std::size_t>(count));
    std::vector<ProfilePoint> curve;
    for (int k = 0; k < count; ++k) {
        const double t = line.near + (line.far - line.near) * k / (count - 1);
        const glm::dvec3 p = line.origin + t * line.direction;
        x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
        curve.push_back({t, 0});
    }
    field.values(x, y, z, values);
    for (std::size_t k = 0; k < curve.size(); ++k) curve[k].value = settings.signedValue(values[k]);
    return curve;
}

}  // namespace

RayProfile profileOf(const Scene& scene, std::size_t isosurface, const Ray& worldRay, int curvePoints) {
    RayProfile profile;
    if (isosurface >= scene.isosurfaces.size() || !scene.isosurfaces[isosurface].shape) return profile;
    const SceneIsosurface& placed = scene.isosurfaces[isosurface];
    const Isosurface& surface = *placed.shape;
    const RootSettings& settings = surface.rootSettings();
    const Ray ray = placed.transform.toObject(worldRay);
    profile.maxGradient = settings.maxGradient * glm::length(ray.direction);
    const LineInterval inside = insideOf(surface.settings().container, ray);
    const double near = std::max(0.0, inside.range.near);
    if (!(near < inside.range.far)) return profile;
    profile.meetsContainer = true;
    profile.near = near;
    profile.far = inside.range.far;
    const LineQuery line{ray.origin, ray.direction, profile.near, profile.far};
    const auto field = [&] { return std::make_unique<TapeField>(surface.tape(), *scene.parameterTable); };
    profile.curve = curveOf(*field(), line, settings, std::max(2, curvePoints));

    LipschitzRootFinder povray(std::make_unique<RecordingField>(field(), line, settings, profile.visited),
                               settings);
    povray.find(std::span(&line, 1), {}, std::span(&profile.povrayRoots, 1));
    CertifiedRootFinder certified(surface.tape(), *scene.parameterTable, settings);
    certified.find(std::span(&line, 1), {}, std::span(&profile.certifiedRoots, 1));
    return profile;
}

}  // namespace isoscope
