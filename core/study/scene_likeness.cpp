// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/scene_likeness.h"

#include <array>
#include <cmath>
#include <cstring>

#include "core/evaluate/batch_evaluator.h"

namespace isoscope {

namespace {

constexpr std::size_t pointCount = 64;

bool sameContainer(const Container& a, const Container& b) {
    if (a.index() != b.index()) return false;
    if (const auto* sphere = std::get_if<ContainerSphere>(&a)) {
        const auto& other = std::get<ContainerSphere>(b);
        return sphere->center == other.center && sphere->radius == other.radius;
    }
    const auto &box = std::get<ContainerBox>(a), &other = std::get<ContainerBox>(b);
    return box.low == other.low && box.high == other.high;
}

std::array<double, pointCount> valuesIn(const Scene& scene, const Isosurface& surface) {
    const Bounds bounds = surface.bounds();
    std::array<double, pointCount> x{}, y{}, z{}, values{};
    for (std::size_t i = 0; i < pointCount; ++i) {
        // Irrational steps: no point lies on a symmetry of the function, and none comes twice.
        const auto share = [i](double step) { return std::fmod(static_cast<double>(i + 1) * step, 1.0); };
        const glm::dvec3 p =
            bounds.low + (bounds.high - bounds.low) *
                             glm::dvec3(share(0.7548776662), share(0.5698402910), share(0.8191725134));
        x[i] = p.x, y[i] = p.y, z[i] = p.z;
    }
    BatchEvaluator(surface.tape(), *scene.parameterTable).evaluate(x, y, z, values);
    return values;
}

bool sameSettings(StudiedSetting setting, const IsosurfaceSettings& a, const IsosurfaceSettings& b) {
    const bool accuracy = setting == StudiedSetting::accuracy || a.accuracy == b.accuracy;
    const bool maxGradient = setting == StudiedSetting::maxGradient || a.maxGradient == b.maxGradient;
    return accuracy && maxGradient && a.threshold == b.threshold && a.open == b.open &&
           a.maxTrace == b.maxTrace && a.positivePolarity == b.positivePolarity && a.evaluate == b.evaluate &&
           sameContainer(a.container, b.container);
}

}  // namespace

bool sameButFor(StudiedSetting setting, const Scene& a, const Scene& b) {
    if (a.objects.size() != b.objects.size() || a.isosurfaces.size() != b.isosurfaces.size()) return false;
    for (std::size_t i = 0; i < a.isosurfaces.size(); ++i) {
        const auto &one = a.isosurfaces[i].shape, &other = b.isosurfaces[i].shape;
        if (!one || !other) return false;
        if (!sameSettings(setting, one->settings(), other->settings())) return false;
        if (a.isosurfaces[i].transform.forward() != b.isosurfaces[i].transform.forward()) return false;
        const auto left = valuesIn(a, *one), right = valuesIn(b, *other);
        // NaN is equal to itself here.
        if (std::memcmp(left.data(), right.data(), sizeof left) != 0) return false;
    }
    return true;
}

}  // namespace isoscope
