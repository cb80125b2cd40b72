// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/crackle_candidates.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <vector>

#include "core/numeric/crackle.h"

namespace isoscope {

namespace {

/// A cube with a reach of up to half the edge of a level's lattice lies in the cube of that level whose share
/// of space has its center.
constexpr int finestLevel = static_cast<int>(crackleEdges.size());
constexpr std::size_t cacheSize = 4096;
/// Covers the 1e-10 by which crackle displaces its cells, and roundings.
constexpr double slack = 1e-9;
/// Distances are computed with far less of an error.
constexpr double distanceSlack = 1e-9;

using Cell = std::array<std::int64_t, 3>;

/// Of the lattice of a level from 1 on.
constexpr double edgeOf(std::size_t level) { return crackleEdges[level - 1]; }

/// floor() of what is far from the limits of an int.
std::int32_t floored(double value) {
    const auto whole = static_cast<std::int32_t>(value);
    return whole - (whole > value);
}

struct Place {
    std::array<std::int32_t, 3> at{};
    std::int32_t level = 0;
    std::int32_t order = 0;
    double metric = 0;

    friend bool operator==(const Place& a, const Place& b) {
        return a.at[0] == b.at[0] && a.at[1] == b.at[1] && a.at[2] == b.at[2] && a.level == b.level &&
               a.order == b.order && a.metric == b.metric;
    }

    double edge() const { return edgeOf(static_cast<std::size_t>(level)); }
    double low(std::size_t axis) const { return (at[axis] - 0.5) * edge(); }
    double high(std::size_t axis) const { return (at[axis] + 1.5) * edge(); }
    Place parent() const { return {{at[0] >> 1, at[1] >> 1, at[2] >> 1}, level - 1, order, metric}; }
    std::size_t hash() const {
        std::uint64_t mixed = static_cast<std::uint64_t>(order);
        for (const std::int32_t k : at) mixed = (mixed + static_cast<std::uint32_t>(k)) * 0x9E3779B97F4A7C15u;
        return static_cast<std::size_t>(mixed >> 40) % cacheSize;
    }
};

/// What is known of a place.
struct Entry {
    bool usable = false;
    CrackleCandidates found;
};

/// Keeps of the cells' points those that may count at a place.
class Selection {
  public:
    explicit Selection(const Place& place) : place_(place) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low_[axis] = place.low(axis);
            high_[axis] = place.high(axis);
        }
        cells_ = crackleCells(low_, high_);
    }

    /// Of all cells: those that the place meets first, for they tell how far the others may be.
    void addFromCells() {
        std::array<AxisViews, 3> views;
        for (std::size_t axis = 0; axis < 3; ++axis) views[axis] = look(axis);
        for (const bool met : {true, false}) {
            const double furthest = met ? HUGE_VAL : limit();
            const auto isOut = [&](double gap) { return !met && gap > furthest; };
            for (const AxisView& x : views[0]) {
                if ((met && x.gap > 0) || isOut(size({x.gap, 0, 0}))) continue;
                for (const AxisView& y : views[1]) {
                    if ((met && y.gap > 0) || x.near + y.near > 1 || isOut(size({x.gap, y.gap, 0}))) continue;
                    for (const AxisView& z : views[2]) {
                        if (met != (x.gap == 0 && y.gap == 0 && z.gap == 0)) continue;
                        if (x.near + y.near + z.near > 1 || isOut(size({x.gap, y.gap, z.gap}))) continue;
                        add(cracklePoint(x.cell, y.cell, z.cell), x.far + y.far + z.far <= 1);
                    }
                }
            }
            measure();
        }
    }

    /// Of the candidates of a place around this one.
    void addFrom(const CrackleCandidates& known) {
        for (std::size_t i = 0; i < known.count; ++i) {
            const std::array<double, 3> point{known.x[i], known.y[i], known.z[i]};
            const CrackleSight sight =
                i < known.always ? CrackleSight{true, true} : crackleSight(point, cells_);
            if (sight.ever) add(point, sight.always);
        }
        measure();
    }

    void finish(Entry& entry) {
        CrackleCandidates& found = entry.found;
        found.count = 0;
        entry.usable = write(true, found);
        found.always = found.count;
        entry.usable =
            entry.usable && found.always >= static_cast<std::size_t>(place_.order) && write(false, found);
    }

  private:
    /// A cell along one axis. The 81 cells that a point looks at are two away along one axis at most.
    struct AxisView {
        std::int64_t cell = 0;
        double gap = 0;  ///< from the place; 0 where they meet
        int near = 0;    ///< 1 if it is two away from the nearest cell of the place
        int far = 0;     ///< 1 if it is two away from the furthest one, 2 if further
    };
    /// A place is no wider than two cells.
    struct AxisViews {
        std::array<AxisView, 7> views;
        std::size_t count = 0;

        const AxisView* begin() const { return views.data(); }
        const AxisView* end() const { return views.data() + count; }
    };

    AxisViews look(std::size_t axis) const {
        AxisViews seen;
        const std::int64_t first = cells_.first[axis], last = cells_.last[axis];
        for (std::int64_t cell = first - 2; cell <= last + 2; ++cell) {
            const auto low = static_cast<double>(cell);
            const std::int64_t near = std::max({std::int64_t{0}, first - cell, cell - last});
            const std::int64_t far = std::max(last - cell, cell - first);
            seen.views[seen.count++] = {cell, std::max({0.0, low_[axis] - (low + 1), low - high_[axis]}),
                                        near == 2 ? 1 : 0,
                                        far > 2    ? 2
                                        : far == 2 ? 1
                                                   : 0};
        }
        return seen;
    }

    /// Grows with the norm, and is cheaper.
    double size(const std::array<double, 3>& d) const {
        if (place_.metric == 2) return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        return crackleNorm(d[0], d[1], d[2], place_.metric);
    }
    /// `always` if all points of the place look at it; some do.
    void add(const std::array<double, 3>& point, bool always) {
        for (std::size_t axis = 0; axis < 3; ++axis) points_[axis][count_] = point[axis];
        always_[count_++] = always;
    }
    /// How near to points of the place, and how far, those are that were added since the last call.
    void measure() {
        const std::size_t first = measured_;
        measured_ = count_;
        // A loop of its own, of vector instructions: with size() in it crackle takes 2.6 % more time.
        if (place_.metric == 2) {
            for (std::size_t i = first; i < count_; ++i) {
                double least = 0, furthest = 0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double below = low_[axis] - points_[axis][i];
                    const double above = points_[axis][i] - high_[axis];
                    const double gap = std::max(0.0, std::max(below, above)), span = std::max(-below, -above);
                    least += gap * gap;
                    furthest += span * span;
                }
                least_[i] = least;
                furthest_[i] = furthest;
            }
        } else {
            for (std::size_t i = first; i < count_; ++i) {
                std::array<double, 3> gap, span;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double below = low_[axis] - points_[axis][i];
                    const double above = points_[axis][i] - high_[axis];
                    gap[axis] = std::max({0.0, below, above});
                    span[axis] = std::max(-below, -above);
                }
                least_[i] = size(gap);
                furthest_[i] = size(span);
            }
        }
        for (std::size_t i = first; i < count_; ++i)
            if (always_[i]) noteFurthest(furthest_[i]);
    }
    double limit() const {
        return nearest_[static_cast<std::size_t>(place_.order - 1)] * (1 + distanceSlack) + distanceSlack;
    }
    void noteFurthest(double distance) {
        if (!(distance < nearest_[2])) return;
        nearest_[2] = distance;
        if (nearest_[2] < nearest_[1]) std::swap(nearest_[2], nearest_[1]);
        if (nearest_[1] < nearest_[0]) std::swap(nearest_[1], nearest_[0]);
    }
    /// Of those that are looked at always, or of the others. Returns whether there is room.
    bool write(bool always, CrackleCandidates& found) const {
        const double furthest = limit();
        for (std::size_t i = 0; i < count_; ++i) {
            if (always_[i] != always || least_[i] > furthest) continue;
            if (found.count == CrackleCandidates::most) return false;
            found.x[found.count] = points_[0][i];
            found.y[found.count] = points_[1][i];
            found.z[found.count++] = points_[2][i];
        }
        return true;
    }

    Place place_;
    CrackleCells cells_;
    std::array<double, 3> low_, high_;
    /// Of the points: as many as there are views of three axes.
    static constexpr std::size_t most = 7 * 7 * 7;
    std::array<std::array<double, most>, 3> points_;
    std::array<double, most> least_, furthest_;  ///< sizes of the ways to points of the place
    std::array<bool, most> always_;              ///< whether all points of the place look at it
    std::size_t count_ = 0, measured_ = 0;
    std::array<double, 3> nearest_{HUGE_VAL, HUGE_VAL, HUGE_VAL};
};

void fillFromCells(const Place& place, Entry& entry) {
    Selection selection(place);
    selection.addFromCells();
    selection.finish(entry);
}

/// Candidates of places of one level, found by their hash. Entries are large and taken one after the other,
/// so that no more memory is touched than there are places.
class LevelCache {
  public:
    struct Found {
        Entry* entry;
        bool filled;  ///< otherwise the caller is to fill it
    };
    Found find(const Place& place) {
        if (keys_.empty()) keys_.resize(cacheSize);
        Key& key = keys_[place.hash()];
        const bool filled = key.entry && key.place == place;
        if (!key.entry) key.entry = &entries_.emplace_back();
        key.place = place;
        return {key.entry, filled};
    }

  private:
    struct Key {
        Place place;
        Entry* entry = nullptr;
    };

    std::vector<Key> keys_;
    std::deque<Entry> entries_;
};

class Cache {
  public:
    const CrackleCandidates* candidates(const Place& place) {
        if (!last_ || !(place == lastPlace_)) {
            last_ = &find(place);
            lastPlace_ = place;
        }
        return last_->usable ? &last_->found : nullptr;
    }

  private:
    const Entry& find(const Place& place) {
        const auto [entry, filled] = levels_[static_cast<std::size_t>(place.level - 1)].find(place);
        if (!filled) fill(place, *entry);
        return *entry;
    }
    void fill(const Place& place, Entry& entry) {
        if (place.level == 1) return fillFromCells(place, entry);
        const Entry& parent = find(place.parent());
        if (!parent.usable) return fillFromCells(place, entry);
        Selection selection(place);
        selection.addFrom(parent.found);
        selection.finish(entry);
    }

    /// In one list the fine places would push out the coarse ones, which cost most.
    std::array<LevelCache, finestLevel> levels_;
    Place lastPlace_;
    const Entry* last_ = nullptr;
};

}  // namespace

CrackleCells crackleCells(const std::array<double, 3>& low, const std::array<double, 3>& high) {
    CrackleCells cells{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cells.first[axis] = static_cast<std::int64_t>(std::floor(low[axis] - slack));
        cells.last[axis] = static_cast<std::int64_t>(std::floor(high[axis] + slack));
    }
    return cells;
}

CrackleSight crackleSight(const std::array<double, 3>& point, const CrackleCells& cells) {
    int nearCorners = 0, farCorners = 0;
    bool ever = true, always = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // The cell point is the lower corner of its cell and 32 bits of a fraction, exactly.
        const auto cell = static_cast<std::int64_t>(std::floor(point[axis]));
        const std::int64_t low = cell - cells.last[axis], high = cell - cells.first[axis];
        const std::int64_t far = std::max(std::abs(low), std::abs(high));
        const std::int64_t near = low <= 0 && high >= 0 ? 0 : std::min(std::abs(low), std::abs(high));
        ever = ever && near <= 2;
        always = always && far <= 2;
        nearCorners += near == 2;
        farCorners += far == 2;
    }
    return {ever && nearCorners <= 1, always && farCorners <= 1};
}

double crackleNorm(double x, double y, double z, double metric) {
    if (metric == 2) return std::sqrt(x * x + y * y + z * z);
    if (metric == 1) return x + y + z;
    return std::pow(std::pow(x, metric) + std::pow(y, metric) + std::pow(z, metric), 1 / metric);
}

const CrackleCandidates* crackleCandidates(const CrackleCube& cube, double metric, int order) {
    if (!(cube.reach <= longestCrackleReach) || !(metric >= 1 / greatestCrackleMetric) ||
        !(metric <= greatestCrackleMetric))
        return nullptr;
    // euclidean_crackle.cpp tells by the same rule which places look at the same list.
    std::size_t level = 1;
    while (level < finestLevel && cube.reach <= edgeOf(level + 1) / 2) ++level;
    Place place{{}, static_cast<std::int32_t>(level), order, metric};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(std::abs(cube.center[axis]) <= crackleExtent)) return nullptr;
        place.at[axis] = floored(cube.center[axis] / edgeOf(level));
    }
    static thread_local const std::unique_ptr<Cache> cache = std::make_unique<Cache>();
    return cache->candidates(place);
}

}  // namespace isoscope
