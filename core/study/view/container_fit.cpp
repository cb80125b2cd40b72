// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/container_fit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/study/accuracy/scene_variant.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// A container counts as smaller from here on.
constexpr double smallerShare = 0.95;

glm::dvec3 axis(int k, double sign) {
    glm::dvec3 direction{0};
    direction[k] = sign;
    return direction;
}

/// Numbers with so many digits that they tell a three hundredth of `extent`.
class Rounding {
  public:
    explicit Rounding(double extent)
        : decimals_(std::clamp(static_cast<int>(std::ceil(-std::log10(extent / 300))), 0, 15)),
          unit_(std::pow(10.0, -decimals_)) {}

    /// At least `value`, as a decimal is read back.
    double up(double value) const {
        double steps = std::ceil(value / unit_);
        while (decimal(steps) < value) ++steps;
        return decimal(steps);
    }
    double down(double value) const { return 0 - up(-value); }
    double nearest(double value) const { return decimal(std::round(value / unit_)); }

  private:
    double decimal(double steps) const {
        const std::string text = fixedNumber(steps * unit_, decimals_);
        double value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    }

    int decimals_;
    double unit_;
};

bool encloses(const Container& outer, const ContainerBox& inner) {
    if (const auto* box = std::get_if<ContainerBox>(&outer))
        return glm::all(glm::lessThanEqual(box->low, inner.low)) &&
               glm::all(glm::lessThanEqual(inner.high, box->high));
    const auto& sphere = std::get<ContainerSphere>(outer);
    const glm::dvec3 corner =
        glm::max(glm::abs(inner.low - sphere.center), glm::abs(inner.high - sphere.center));
    return glm::length(corner) <= std::abs(sphere.radius);
}

bool encloses(const Container& outer, const ContainerSphere& inner) {
    if (const auto* box = std::get_if<ContainerBox>(&outer))
        return glm::all(glm::lessThanEqual(box->low, inner.center - inner.radius)) &&
               glm::all(glm::lessThanEqual(inner.center + inner.radius, box->high));
    const auto& sphere = std::get<ContainerSphere>(outer);
    return glm::distance(sphere.center, inner.center) + inner.radius <= std::abs(sphere.radius);
}

/// Whether a point of which no coordinate goes beyond `box`, and which is no farther from the sphere's center
/// than its radius, is in the container.
bool holdsReach(const Container& container, IsosurfaceReach& reach, const std::stop_token& stop) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container))
        return reach.around(sphere->center, stop) <= std::abs(sphere->radius);
    const auto& box = std::get<ContainerBox>(container);
    for (int k = 0; k < 3; ++k)
        if (!(reach.along(axis(k, 1), stop) <= box.high[k] && -reach.along(axis(k, -1), stop) >= box.low[k]))
            return false;
    return true;
}

/// What a fit of one surface asks for.
class Fitting {
  public:
    Fitting(const std::shared_ptr<const Isosurface>& surface, std::span<const double> parameters,
            const ReachSettings& settings, std::stop_token stop)
        : surface_(*surface),
          parameters_(parameters),
          settings_(settings),
          stop_(std::move(stop)),
          reach_(surface, parameters, settings) {}

    ContainerFit fit() {
        glm::dvec3 low, high;
        for (int k = 0; k < 3; ++k) {
            high[k] = reach_.along(axis(k, 1), stop_);
            low[k] = -reach_.along(axis(k, -1), stop_);
        }
        ContainerFit result;
        result.empty = !glm::all(glm::lessThanEqual(low, high));
        const glm::dvec3 size = high - low;
        const double extent = std::max({size.x, size.y, size.z});
        if (result.empty || !std::isfinite(extent) || !(extent > 0)) return result;
        const Rounding rounding(extent);
        offer(boxAround(low, high, rounding), result.box);
        glm::dvec3 middle;
        for (int k = 0; k < 3; ++k) middle[k] = rounding.nearest(0.5 * low[k] + 0.5 * high[k]);
        offer(sphereAround(middle, rounding), result.sphere);
        if (const auto* present = std::get_if<ContainerSphere>(&container()))
            offer(sphereAround(present->center, rounding), result.sphere);
        return result;
    }

  private:
    const Container& container() const { return surface_.settings().container; }

    ContainerBox boxAround(const glm::dvec3& low, const glm::dvec3& high, const Rounding& rounding) const {
        ContainerBox box;
        const auto* present = std::get_if<ContainerBox>(&container());
        for (int k = 0; k < 3; ++k) {
            box.low[k] = rounding.down(low[k]);
            box.high[k] = rounding.up(high[k]);
            if (present == nullptr) continue;
            box.low[k] = std::max(box.low[k], present->low[k]);
            box.high[k] = std::min(box.high[k], present->high[k]);
        }
        return box;
    }
    ContainerSphere sphereAround(const glm::dvec3& center, const Rounding& rounding) {
        ContainerSphere sphere{center, rounding.up(reach_.around(center, stop_))};
        const auto* present = std::get_if<ContainerSphere>(&container());
        if (present != nullptr && present->center == center)
            sphere.radius = std::min(sphere.radius, std::abs(present->radius));
        return sphere;
    }

    /// Takes a candidate that is smaller than the present container and than what was found before.
    template <class Shape>
    void offer(const Shape& candidate, std::optional<Shape>& found) {
        const double volume = volumeOf(candidate);
        const double most = found ? volumeOf(*found) : smallerShare * volumeOf(container());
        if (!(volume < most) || stop_.stop_requested()) return;
        if (encloses(container(), candidate) || showsTheSame(candidate)) found = candidate;
    }
    /// Whether nothing is seen in the candidate that the present container leaves out.
    bool showsTheSame(const Container& candidate) const {
        IsosurfaceSettings settings = surface_.settings();
        settings.container = candidate;
        IsosurfaceReach reach(std::make_shared<const Isosurface>(std::move(settings)), parameters_,
                              settings_);
        return holdsReach(container(), reach, stop_) && !stop_.stop_requested();
    }

    const Isosurface& surface_;
    std::span<const double> parameters_;
    ReachSettings settings_;
    std::stop_token stop_;
    IsosurfaceReach reach_;
};

std::string vectorText(const glm::dvec3& v) {
    return "<" + shortestNumber(v.x) + ", " + shortestNumber(v.y) + ", " + shortestNumber(v.z) + ">";
}

}  // namespace

std::optional<Container> ContainerFit::best() const {
    if (box && (!sphere || volumeOf(*box) <= volumeOf(*sphere))) return *box;
    if (sphere) return *sphere;
    return {};
}

ContainerFit fitContainer(const std::shared_ptr<const Isosurface>& surface,
                          std::span<const double> parameters, const ReachSettings& settings,
                          const std::stop_token& stop) {
    ContainerFit fit = Fitting(surface, parameters, settings, stop).fit();
    const auto takeSmaller = [](auto& known, const auto& finer) {
        if (finer && (!known || volumeOf(*finer) < volumeOf(*known))) known = finer;
    };
    // Reaches are proven to a part of the container: in a much smaller one they are closer.
    double before = volumeOf(surface->settings().container);
    for (int round = 0; round < 2 && !stop.stop_requested(); ++round) {
        const std::optional<Container> best = fit.best();
        if (!best || volumeOf(*best) > 0.5 * before) break;
        before = volumeOf(*best);
        IsosurfaceSettings smaller = surface->settings();
        smaller.container = *best;
        const ContainerFit finer =
            Fitting(std::make_shared<const Isosurface>(std::move(smaller)), parameters, settings, stop).fit();
        takeSmaller(fit.box, finer.box);
        takeSmaller(fit.sphere, finer.sphere);
    }
    return fit;
}

std::optional<TextChange> containerChange(const Scene& scene, const SourceLibrary& sources,
                                          std::size_t number, const Container& container) {
    if (number >= scene.isosurfaces.size()) return {};
    const SceneIsosurface& statement = scene.isosurfaces[number];
    if (statement.range.file != 0 || statement.range.begin >= statement.range.end) return {};
    for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i)
        if (i != number && scene.isosurfaces[i].range.begin == statement.range.begin) return {};
    const auto inside = [&](const SourceRange& range) {
        return range.file == 0 && statement.range.begin < range.begin && range.begin < range.end &&
               range.end < statement.range.end;
    };
    if (inside(statement.containerRange))
        return TextChange{statement.containerRange, " " + containerText(container) + " "};
    const SourceRange& function = statement.functionRange;
    const bool hasNone = statement.containerRange == SourceRange{};
    if (!hasNone || !inside(function) || sources.slice({0, function.end, function.end + 1}) != "}") return {};
    return TextChange{{0, function.end + 1, function.end + 1},
                      "\n  contained_by { " + containerText(container) + " }"};
}

std::shared_ptr<const Scene> sceneWithContainer(const Scene& scene, const Isosurface& surface,
                                                const Container& container) {
    return sceneVariant(scene, [&](const Isosurface& original, IsosurfaceSettings& settings) {
        if (&original == &surface) settings.container = container;
    });
}

double volumeOf(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container))
        return 4 * std::numbers::pi / 3 * std::pow(std::abs(sphere->radius), 3);
    const auto& box = std::get<ContainerBox>(container);
    const glm::dvec3 size = glm::abs(box.high - box.low);
    return size.x * size.y * size.z;
}

std::string containerText(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container))
        return "sphere { " + vectorText(sphere->center) + ", " + shortestNumber(sphere->radius) + " }";
    const auto& box = std::get<ContainerBox>(container);
    return "box { " + vectorText(box.low) + ", " + vectorText(box.high) + " }";
}

}  // namespace isoscope
