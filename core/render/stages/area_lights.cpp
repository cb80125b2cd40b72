// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/area_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "core/render/effect_reasons.h"
#include "core/render/light/light_grid.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// Corners that differ by more than this, summed over the channels, are looked into.
constexpr double sameShade = 0.1;
/// So many lights of so many points are remembered at a time.
constexpr std::size_t memoryLimit = std::size_t{1} << 16;
constexpr std::int32_t unknown = -1;
/// Few enough for the processor's memory.
constexpr std::size_t cellsAtOnce = 512;

/// A part of the grid as one point sees it, its corner lights included.
struct Cell {
    std::uint32_t slot;  ///< which of the points at hand
    int left, top, right, bottom;
    int level;

    bool divisible() const { return right - left > 1 || bottom - top > 1; }
    std::array<std::array<int, 2>, 4> corners() const {
        return {{{left, top}, {right, top}, {left, bottom}, {right, bottom}}};
    }
};

double difference(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return d.x + d.y + d.z;
}

bool alike(const std::array<glm::dvec3, 4>& shades) {
    for (std::size_t i = 1; i < shades.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (difference(shades[i], shades[k]) > sameShade) return false;
    return true;
}

/// Halves that share the middle light, if there is one.
void divide(const Cell& cell, std::vector<Cell>& parts) {
    const int beforeX = (cell.left + cell.right) / 2, afterX = (cell.left + cell.right + 1) / 2;
    const int beforeY = (cell.top + cell.bottom) / 2, afterY = (cell.top + cell.bottom + 1) / 2;
    const int level = cell.level + 1;
    parts.push_back({cell.slot, cell.left, cell.top, beforeX, beforeY, level});
    parts.push_back({cell.slot, afterX, cell.top, cell.right, beforeY, level});
    parts.push_back({cell.slot, cell.left, afterY, beforeX, cell.bottom, level});
    parts.push_back({cell.slot, afterX, afterY, cell.right, cell.bottom, level});
}

}  // namespace

/// The scratch memory of one thread.
class AreaLightWork : public ShapeState {
  public:
    std::vector<std::uint32_t> points;                             ///< those at hand, one of each place
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members;  ///< points and the slots of their places
    std::unordered_map<std::uint32_t, std::uint32_t> slots;        ///< by sample, where it has several points
    std::vector<glm::dvec3> shades;                                ///< theirs: the mean over the grid so far
    std::vector<Cell> cells, parts;
    std::vector<std::int32_t> known;  ///< by slot, row and column: which of `asked`
    std::vector<glm::dvec3> asked;    ///< what arrives from each light that was asked
    SurfacePoints probe;              ///< those to be asked now

    /// Takes points that the light would brighten, from number `k` on, while there are fewer than `most`
    /// places. Returns the number behind the last.
    std::size_t take(const SurfacePoints& from, std::size_t k, std::size_t most);
    void begin(const LightArea& area);
    /// Asks for the light unless it was asked for already.
    void want(const LightSource& light, const SurfacePoints& from, const Cell& cell);
    std::array<glm::dvec3, 4> shadesOf(const Cell& cell, const LightArea& area) const;

  private:
    std::size_t place(const Cell& cell, const std::array<int, 2>& corner, const LightArea& area) const {
        return (cell.slot * static_cast<std::size_t>(area.rows) + static_cast<std::size_t>(corner[1])) *
                   static_cast<std::size_t>(area.columns) +
               static_cast<std::size_t>(corner[0]);
    }
};

std::size_t AreaLightWork::take(const SurfacePoints& from, std::size_t k, std::size_t most) {
    points.clear();
    members.clear();
    slots.clear();
    for (; k < from.size() && points.size() < most; ++k) {
        if (at(from.returned, k) == glm::dvec3(0)) continue;
        auto slot = static_cast<std::uint32_t>(points.size());
        // The parts of a texture lie in one place.
        if (from.weighted) slot = slots.emplace(from.samples[k], slot).first->second;
        if (slot == points.size()) points.push_back(static_cast<std::uint32_t>(k));
        members.emplace_back(static_cast<std::uint32_t>(k), slot);
    }
    return k;
}

void AreaLightWork::begin(const LightArea& area) {
    const std::size_t lights = static_cast<std::size_t>(area.columns) * static_cast<std::size_t>(area.rows);
    known.assign(points.size() * lights, unknown);
    shades.assign(points.size(), glm::dvec3(0));
    asked.clear();
    cells.clear();
    for (std::uint32_t slot = 0; slot < points.size(); ++slot)
        cells.push_back({slot, 0, 0, area.columns - 1, area.rows - 1, 0});
}

void AreaLightWork::want(const LightSource& light, const SurfacePoints& from, const Cell& cell) {
    const glm::dvec3 point = at(from.point, points[cell.slot]);
    const LightGrid grid(light, point);
    const bool parallel = light.kind == LightKind::parallel || light.kind == LightKind::cylinder;
    for (const std::array<int, 2>& corner : cell.corners()) {
        std::int32_t& index = known[place(cell, corner, *light.area)];
        if (index != unknown) continue;
        index = static_cast<std::int32_t>(asked.size() + probe.size());
        const std::size_t k = probe.size();
        probe.samples.push_back(from.samples[points[cell.slot]]);
        probe.materials.push_back(from.materials[points[cell.slot]]);
        const glm::dvec3 source = grid.place(corner[0], corner[1]);
        const glm::dvec3 arm = source - (parallel ? light.pointAt : point);
        const double length = glm::length(arm);
        const glm::dvec3 toLight = length > 0 ? arm / length : glm::dvec3(0);
        for (int c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            probe.point[channel][k] = point[c];
            probe.normal[channel][k] = from.normal[channel][points[cell.slot]];
            probe.view[channel][k] = from.view[channel][points[cell.slot]];
            probe.toLight[channel][k] = toLight[c];
            probe.returned[channel][k] = 1;
        }
        probe.distance[k] = parallel ? glm::dot(source - point, toLight) : length;
        probe.strength[k] = 1;
    }
}

std::array<glm::dvec3, 4> AreaLightWork::shadesOf(const Cell& cell, const LightArea& area) const {
    std::array<glm::dvec3, 4> found;
    const auto corners = cell.corners();
    for (std::size_t i = 0; i < corners.size(); ++i)
        found[i] = asked[static_cast<std::size_t>(known[place(cell, corners[i], area)])];
    return found;
}

AreaLights::AreaLights(const Scene& scene, std::unique_ptr<LightFilter> shadows)
    : scene_(scene), shadows_(std::move(shadows)) {}

void AreaLights::filter(TileScratch& work, SurfacePoints& points, std::size_t number) const {
    const LightSource& light = scene_.lights[number];
    if (!light.area) return shadows_->filter(work, points, number);
    if (light.shadowless && !light.projectedThrough) return;
    AreaLightWork& own =
        work.context.state<AreaLightWork>(this, [] { return std::make_unique<AreaLightWork>(); });
    const std::size_t lights =
        static_cast<std::size_t>(light.area->columns) * static_cast<std::size_t>(light.area->rows);
    const std::size_t most = std::max<std::size_t>(1, memoryLimit / lights);
    for (std::size_t k = 0; k < points.size();) {
        k = own.take(points, k, most);
        if (own.points.empty() || work.context.stop.stop_requested()) break;
        askAll(light, points, number, work, own);
        for (const auto& [point, slot] : own.members)
            for (int c = 0; c < 3; ++c)
                points.returned[static_cast<std::size_t>(c)][point] *= own.shades[slot][c];
    }
    work.charge(StageKind::areaLights);
}

void AreaLights::ask(std::size_t number, TileScratch& work, AreaLightWork& own) const {
    const std::uint64_t before = work.meter(StageKind::shadows).rays;
    work.charge(StageKind::areaLights);
    shadows_->filter(work, own.probe, number);
    std::uint64_t& rays = work.meter(StageKind::shadows).rays;
    work.meter(StageKind::areaLights).rays += rays - before;
    rays = before;
    for (std::size_t k = 0; k < own.probe.size(); ++k) own.asked.push_back(at(own.probe.returned, k));
}

void AreaLights::askAll(const LightSource& light, const SurfacePoints& points, std::size_t number,
                        TileScratch& work, AreaLightWork& own) const {
    own.begin(*light.area);
    while (!own.cells.empty()) {
        for (std::size_t first = 0; first < own.cells.size(); first += cellsAtOnce) {
            if (work.context.stop.stop_requested()) return;
            const std::size_t end = std::min(own.cells.size(), first + cellsAtOnce);
            own.probe.clear();
            own.probe.makeRoom(4 * (end - first));
            for (std::size_t i = first; i < end; ++i) own.want(light, points, own.cells[i]);
            ask(number, work, own);
        }
        own.parts.clear();
        for (const Cell& cell : own.cells) {
            const std::array<glm::dvec3, 4> shades = own.shadesOf(cell, *light.area);
            if (cell.divisible() && (cell.level < light.area->adaptive || !alike(shades)))
                divide(cell, own.parts);
            else
                own.shades[cell.slot] +=
                    std::ldexp(0.25, -2 * cell.level) * (shades[0] + shades[1] + shades[2] + shades[3]);
        }
        own.cells.swap(own.parts);
    }
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    const auto soft = [](const LightSource& light) {
        return light.area && (!light.shadowless || light.projectedThrough);
    };
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(), soft);
    if (light == scene.lights.end()) return {false, "no light that casts shadows has an area"};
    EffectReason shadows = effects::shadows.reasonFor(scene);
    if (!shadows.needed && !effects::clearShadows.reasonFor(scene).needed &&
        !effects::projection.reasonFor(scene).needed)
        return shadows;
    return {true, placeOf(*light) + " has " +
                      counted(static_cast<std::size_t>(light->area->columns) *
                                  static_cast<std::size_t>(light->area->rows),
                              "light")};
}

/// Each light of an area asks for all shadows.
void build(PictureParts& parts) {
    FilterChain& shadows = parts.lightFilters->shadows;
    if (shadows.empty()) return;
    auto points = std::make_unique<FilterChain>(std::exchange(shadows, {}));
    shadows.add(std::make_unique<AreaLights>(parts.scene(), std::move(points)));
}

}  // namespace

const EffectDescription effects::areaLights{.name = "area lights", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
