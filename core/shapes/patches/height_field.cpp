// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/height_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/image/brightness.h"
#include "core/shapes/patches/triangle_hit.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

/// Room for rounding when squares are chosen, in squares.
constexpr double room = 1e-7;
/// How far a hit may seem to lie below the height of its triangle.
constexpr double rounding = 1e-12;
/// Heights are 16-bit numbers in POV-Ray, and the largest of them, 65535, falls short of 1 by one step.
constexpr double heightSteps = 65536;

}  // namespace

HeightGrid heightGrid(const Raster& raster) {
    HeightGrid grid;
    grid.columns = raster.width;
    grid.rows = raster.height;
    for (int y = raster.height - 1; y >= 0; --y)
        for (int x = 0; x < raster.width; ++x) {
            if (raster.indexed) {
                grid.heights.push_back(256 * raster.at(x, y) / heightSteps);
            } else if (raster.channels == 1) {
                // POV-Ray computes in single precision, and cuts off.
                const float scale = 65535.0F / static_cast<float>(raster.largest);
                grid.heights.push_back(std::floor(scale * raster.at(x, y)) / heightSteps);
            } else if (raster.largest > 255) {
                const auto part = [&](int channel) {
                    return static_cast<float>(raster.at(x, y, channel)) / static_cast<float>(raster.largest);
                };
                const float brightness = isoscope::brightness<float>(part(0), part(1), part(2));
                grid.heights.push_back(std::floor(65535.0 * static_cast<double>(brightness)) / heightSteps);
            } else {
                const auto byte = [&](int channel) {
                    return raster.at(x, y, channel) * 255 / raster.largest;
                };
                grid.heights.push_back((256.0 * byte(0) + byte(1)) / heightSteps);
            }
        }
    return grid;
}

/// A ray with what all squares need of it.
class HeightField::Walk {
  public:
    explicit Walk(const Ray& along) : ray(along), line(along) {}

    const Ray& ray;
    TriangleLine line;
};

HeightField::HeightField(HeightGrid grid, double waterLevel, bool smooth)
    : shared_(std::make_shared<const HeightGrid>(std::move(grid))),
      grid_(*shared_),
      waterLevel_(waterLevel),
      smooth_(smooth) {
    const auto [low, high] = std::minmax_element(grid_.heights.begin(), grid_.heights.end());
    bounds_ = {{0, std::max(*low, waterLevel_), 0}, {1, std::max(*high, waterLevel_), 1}};
}

ShapePointer HeightField::awareOf(const Transform& place) const {
    if (!smooth_ || place.identity()) return nullptr;
    auto copy = std::make_shared<HeightField>(*this);
    copy->place_ = place;
    return copy;
}

glm::dvec3 HeightField::pointAt(int column, int row) const {
    return {static_cast<double>(column) / (grid_.columns - 1), grid_.at(column, row),
            static_cast<double>(row) / (grid_.rows - 1)};
}

void HeightField::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                            HitList& hits) const {
    ++context.rays;
    const std::size_t first = hits.size();
    trace(ray, interval, hits, [] { return false; });
    sortHits(hits, first);
}

void HeightField::nearest(std::span<const Ray> rays, TraceContext& context,
                          std::span<NearestHit> nearest) const {
    context.rays += rays.size();
    traceOneByOne(rays, context.nearLimit, nearest, [&](const Ray& ray, RayInterval interval, HitList& hits) {
        trace(ray, interval, hits, [] { return true; });
    });
}

template <class Enough>
void HeightField::trace(const Ray& ray, RayInterval interval, HitList& hits, Enough enough) const {
    // Flat fields would have no room to be met in.
    Bounds grown = bounds_;
    grown.low -= glm::dvec3(1e-9);
    grown.high += glm::dvec3(1e-9);
    const RayInterval inside = grown.clip(ray);
    const double near = std::max(inside.near, interval.near), far = std::min(inside.far, interval.far);
    if (!(near <= far) || !std::isfinite(far)) return;
    const Walk walk(ray);
    const int lastColumn = grid_.columns - 2, lastRow = grid_.rows - 2;
    // Column by column; in each the squares between the rows where the ray enters and leaves it.
    const double x = ray.origin.x * (grid_.columns - 1), dx = ray.direction.x * (grid_.columns - 1);
    const double z = ray.origin.z * (grid_.rows - 1), dz = ray.direction.z * (grid_.rows - 1);
    const auto cell = [](double a, int last) {
        return static_cast<int>(std::clamp(std::floor(a), 0.0, 1.0 * last));
    };
    const double xNear = x + near * dx, xFar = x + far * dx;
    const int from = cell(std::min(xNear, xFar) - room, lastColumn),
              to = cell(std::max(xNear, xFar) + room, lastColumn);
    for (int k = 0; k <= to - from; ++k) {
        const int column = dx < 0 ? to - k : from + k;
        double enter = near, leave = far;
        if (dx != 0) {
            const double one = (column - room - x) / dx, other = (column + 1 + room - x) / dx;
            enter = std::max(enter, std::min(one, other));
            leave = std::min(leave, std::max(one, other));
        }
        if (!(enter <= leave)) continue;
        const double zEnter = z + enter * dz, zLeave = z + leave * dz;
        const int first = cell(std::min(zEnter, zLeave) - room, lastRow);
        const int last = cell(std::max(zEnter, zLeave) + room, lastRow);
        const double yEnter = ray.origin.y + enter * ray.direction.y;
        const double yLeave = ray.origin.y + leave * ray.direction.y;
        const double slack = 1e-9 * (1 + std::max(std::abs(yEnter), std::abs(yLeave)));
        const double lowest = std::min(yEnter, yLeave) - slack, highest = std::max(yEnter, yLeave) + slack;
        for (int j = 0; j <= last - first; ++j) {
            const int row = dz < 0 ? last - j : first + j;
            if (mayReach(column, row, lowest, highest) && meetCell(walk, column, row, interval, hits) &&
                enough())
                return;
        }
    }
}

bool HeightField::mayReach(int column, int row, double low, double high) const {
    const double a = grid_.at(column, row), b = grid_.at(column + 1, row), c = grid_.at(column, row + 1),
                 d = grid_.at(column + 1, row + 1);
    return !(std::max({a, b, c, d}) < low || std::min({a, b, c, d}) > high);
}

bool HeightField::meetCell(const Walk& walk, int column, int row, RayInterval interval, HitList& hits) const {
    const std::array<glm::dvec3, 4> p{pointAt(column, row), pointAt(column + 1, row),
                                      pointAt(column, row + 1), pointAt(column + 1, row + 1)};
    const std::size_t before = hits.size();
    constexpr std::array<std::array<std::size_t, 3>, 2> triangles{{{0, 2, 1}, {3, 1, 2}}};
    for (const auto& [a, b, c] : triangles) {
        const auto met = walk.line.meet(p[a], p[b], p[c]);
        if (!met || !(interval.near <= met->t && met->t <= interval.far)) continue;
        const glm::dvec3 at = walk.ray.at(met->t);
        if (at.y < waterLevel_ - rounding) continue;
        glm::dvec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
        if (smooth_) normal = smoothNormalAt(at, column, row);
        hits.push_back({met->t, at, unitNormal(normal)});
    }
    return hits.size() > before;
}

glm::dvec3 HeightField::smoothNormal(int column, int row) const {
    // As POV-Ray does: with squares of size 1 and heights in steps, and with 16 bits for each component.
    // Heights are thousands of steps, so that little is left of the upright component; its pictures show
    // that.
    const double height = grid_.at(column, row);
    glm::dvec3 sum(0);
    for (const int x : {-1, 1})
        for (const int z : {-1, 1}) {
            if (column + x < 0 || column + x >= grid_.columns || row + z < 0 || row + z >= grid_.rows)
                continue;
            sum += unitNormal({-x * (grid_.at(column + x, row) - height) * heightSteps, 1,
                               -z * (grid_.at(column, row + z) - height) * heightSteps});
        }
    const glm::dvec3 stored = glm::trunc(unitNormal(sum) * 32767.0);
    return unitNormal(place_.normal(stored * glm::dvec3(grid_.columns - 1, heightSteps, grid_.rows - 1)));
}

glm::dvec3 HeightField::smoothNormalAt(const glm::dvec3& point, int column, int row) const {
    const double u = point.x * (grid_.columns - 1) - column, v = point.z * (grid_.rows - 1) - row;
    const glm::dvec3 front = (1 - u) * smoothNormal(column, row) + u * smoothNormal(column + 1, row);
    const glm::dvec3 back = (1 - u) * smoothNormal(column, row + 1) + u * smoothNormal(column + 1, row + 1);
    return place_.inverse().normal((1 - v) * front + v * back);
}

bool HeightField::contains(const glm::dvec3& point, TraceContext&) const {
    if (!(point.x >= 0 && point.x <= 1 && point.z >= 0 && point.z <= 1)) return false;
    const double x = point.x * (grid_.columns - 1), z = point.z * (grid_.rows - 1);
    const int column = std::min(static_cast<int>(x), grid_.columns - 2),
              row = std::min(static_cast<int>(z), grid_.rows - 2);
    const double u = x - column, v = z - row;
    const double a = grid_.at(column, row), b = grid_.at(column + 1, row), c = grid_.at(column, row + 1),
                 d = grid_.at(column + 1, row + 1);
    const double height =
        u + v <= 1 ? a + u * (b - a) + v * (c - a) : d + (1 - u) * (c - d) + (1 - v) * (b - d);
    return point.y < std::max(height, waterLevel_);
}

}  // namespace isoscope
