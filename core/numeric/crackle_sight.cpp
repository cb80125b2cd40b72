// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/crackle_sight.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/numeric/crackle.h"

namespace isoscope {

namespace {

/// Covers the 1e-10 by which crackle displaces its cells, and roundings.
constexpr double slack = 1e-9;
constexpr int deepest = 6;

using Cell = std::array<std::int64_t, 3>;

struct Key {
    Cell cell{};
    double metric = 0;
    int order = 0;

    friend bool operator==(const Key&, const Key&) = default;
};

struct Known {
    Key key;
    bool filled = false;
    bool seesEnough = false;
};

/// The points of a cell and its 26 neighbours, which are seen from all of the cell.
class Neighbourhood {
  public:
    explicit Neighbourhood(const Key& key) : key_(key) {
        std::size_t count = 0;
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k)
                    points_[count++] = cracklePoint(key.cell[0] + i, key.cell[1] + j, key.cell[2] + k);
        // What is not looked at is two cells away along two axes, or three along one.
        limit_ = std::pow(2, 1 / key.metric) * (1 - 4 * slack);
    }

    /// Whether the nearest ones are nearer than anything out of sight, all over a cube in the cell, with its
    /// lower corner `low` from that of the cell.
    bool suffices(const std::array<double, 3>& low, double edge, int depth) const {
        int near = 0;
        for (const auto& point : points_) near += furthest(point, low, edge) < limit_ ? 1 : 0;
        if (near >= key_.order) return true;
        if (depth == deepest) return false;
        const double half = edge / 2;
        for (int part = 0; part < 8; ++part) {
            const std::array<double, 3> corner{low[0] + half * (part & 1), low[1] + half * (part >> 1 & 1),
                                               low[2] + half * (part >> 2)};
            if (!suffices(corner, half, depth + 1)) return false;
        }
        return true;
    }

  private:
    double furthest(const std::array<double, 3>& point, const std::array<double, 3>& low, double edge) const {
        std::array<double, 3> way;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double at = point[axis] - static_cast<double>(key_.cell[axis]);
            way[axis] = std::max(at - low[axis], low[axis] + edge - at) + slack;
        }
        return crackleNorm(way[0], way[1], way[2], key_.metric);
    }

    Key key_;
    std::array<std::array<double, 3>, 27> points_;
    double limit_;
};

bool seesEnough(const Key& key) {
    constexpr std::size_t cacheSize = 8192;
    static thread_local const auto cache = std::make_unique<std::vector<Known>>(cacheSize);
    std::uint64_t mixed = static_cast<std::uint64_t>(key.order);
    for (const std::int64_t k : key.cell)
        mixed = (mixed + static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15u;
    Known& known = (*cache)[static_cast<std::size_t>(mixed >> 40) % cacheSize];
    if (!(known.filled && known.key == key))
        known = {key, true, Neighbourhood(key).suffices({0, 0, 0}, 1, 0)};
    return known.seesEnough;
}

}  // namespace

bool crackleSeesEnough(const CrackleCells& cells, double metric, int order) {
    if (!(metric >= 1) || !(metric <= greatestCrackleMetric)) return false;
    std::int64_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(std::abs(static_cast<double>(cells.first[axis])) <= crackleExtent)) return false;
        const std::int64_t along = cells.last[axis] - cells.first[axis] + 1;
        if (along > mostCrackleCells) return false;
        count *= along;
        if (count > mostCrackleCells) return false;
    }
    for (std::int64_t i = cells.first[0]; i <= cells.last[0]; ++i)
        for (std::int64_t j = cells.first[1]; j <= cells.last[1]; ++j)
            for (std::int64_t k = cells.first[2]; k <= cells.last[2]; ++k)
                if (!seesEnough({{i, j, k}, metric, order})) return false;
    return true;
}

}  // namespace isoscope
