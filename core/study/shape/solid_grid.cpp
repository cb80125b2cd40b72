// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/shape/solid_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Corners of a cell by their bits: 1 right, 2 up, 4 behind.
constexpr int corners = 8;

/// What the simplices that begin at the first corner of a cell add to Euler's characteristic, by the bits of
/// the corners that are inside: chains of corners, each of which has all bits of the one before and more.
constexpr std::array<std::int8_t, 256> characteristics() {
    std::array<std::int8_t, 256> table{};
    for (int mask = 0; mask < 256; ++mask) {
        if (!(mask & 1)) continue;
        int sum = 1;
        const auto in = [&](int corner) { return (mask >> corner & 1) != 0; };
        const auto above = [](int larger, int smaller) {
            return larger != smaller && (larger & smaller) == smaller;
        };
        for (int a = 1; a < corners; ++a) {
            if (!in(a)) continue;
            --sum;
            for (int b = 1; b < corners; ++b) {
                if (!in(b) || !above(b, a)) continue;
                ++sum;
                for (int c = 1; c < corners; ++c)
                    if (in(c) && above(c, b)) --sum;
            }
        }
        table[static_cast<std::size_t>(mask)] = static_cast<std::int8_t>(sum);
    }
    return table;
}

/// The grid with points outside around it, one layer in front and two behind, for the last one begins no
/// cells; and groups of points that hang together.
class Groups {
  public:
    explicit Groups(const glm::ivec3& size) : size_(size), inside_(count(), 0), parents_(count()) {
        std::iota(parents_.begin(), parents_.end(), 0u);
    }

    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(x);
    }
    void setInside(int x, int y, int z) { inside_[index(x, y, z)] = 1; }

    SolidCount solid() {
        static constexpr auto table = characteristics();
        std::int64_t characteristic = 0;
        for (int z = 0; z + 1 < size_.z; ++z)
            for (int y = 0; y + 1 < size_.y; ++y)
                for (int x = 0; x + 1 < size_.x; ++x) characteristic += table[joinCell(x, y, z)];
        SolidCount solid;
        for (std::size_t i = 0; i < parents_.size(); ++i) {
            if (of(static_cast<std::uint32_t>(i)) != i) continue;
            ++(inside_[i] ? solid.pieces : solid.hollows);
        }
        --solid.hollows;
        solid.tunnels = solid.pieces + solid.hollows - characteristic;
        solid.known = true;
        return solid;
    }

  private:
    std::size_t count() const {
        return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
               static_cast<std::size_t>(size_.z);
    }
    std::uint32_t of(std::uint32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    /// Joins the first corner of a cell with those that are on its side; the bits of those inside.
    std::size_t joinCell(int x, int y, int z) {
        const std::size_t first = index(x, y, z);
        std::size_t mask = 0;
        for (int corner = 0; corner < corners; ++corner) {
            const std::size_t other = index(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1));
            if (inside_[other]) mask |= std::size_t{1} << corner;
            if (inside_[other] != inside_[first]) continue;
            const std::uint32_t a = of(static_cast<std::uint32_t>(first)),
                                b = of(static_cast<std::uint32_t>(other));
            parents_[std::max(a, b)] = std::min(a, b);
        }
        return mask;
    }

    glm::ivec3 size_;
    std::vector<char> inside_;
    std::vector<std::uint32_t> parents_;
};

}  // namespace

SolidGrid::SolidGrid(const Isosurface& surface, std::span<const double> parameters, int cells,
                     std::stop_token stop) {
    const GradientDomain domain(surface.settings().container);
    if (domain.empty()) return;
    const LoopStop loops(stop);
    low_ = domain.box().low;
    high_ = domain.box().high;
    const glm::dvec3 extent = high_ - low_;
    const double cell = domain.box().width() / std::clamp(cells, 2, mostCells);
    for (int k = 0; k < 3; ++k)
        cells_[k] = cell > 0 ? std::clamp(static_cast<int>(std::lround(extent[k] / cell)), 2, mostCells) : 2;
    values_.assign(static_cast<std::size_t>(cells_.x + 1) * static_cast<std::size_t>(cells_.y + 1) *
                       static_cast<std::size_t>(cells_.z + 1),
                   infinity);
    PointEvaluator evaluator(surface.prepared(parameters));
    const double sign = surface.settings().positivePolarity ? -1 : 1;
    const auto row = static_cast<std::size_t>(cells_.x + 1);
    std::vector<double> x(row), y(row), z(row), out(row);
    for (int i = 0; i <= cells_.x; ++i) x[static_cast<std::size_t>(i)] = place({i, 0, 0}).x;
    for (int k = 0; k <= cells_.z; ++k)
        for (int j = 0; j <= cells_.y; ++j) {
            if (stop.stop_requested()) return;
            const glm::dvec3 at = place({0, j, k});
            std::ranges::fill(y, at.y);
            std::ranges::fill(z, at.z);
            evaluator.evaluate(x, y, z, out);
            for (int i = 0; i <= cells_.x; ++i) {
                const double value = sign * (out[static_cast<std::size_t>(i)] - surface.settings().threshold);
                if (domain.isBall() && !domain.contains({x[static_cast<std::size_t>(i)], at.y, at.z}))
                    continue;
                if (!std::isnan(value)) values_[indexOf({i, j, k})] = value;
            }
        }
    known_ = !stop.stop_requested();
}

glm::dvec3 SolidGrid::place(const glm::ivec3& point) const {
    glm::dvec3 at;
    for (int k = 0; k < 3; ++k) {
        const double share = static_cast<double>(point[k]) / cells_[k];
        at[k] = low_[k] * (1 - share) + high_[k] * share;
    }
    return at;
}

SolidCount SolidGrid::count() const {
    if (!known_) return {};
    Groups groups(cells_ + 4);
    for (int k = 0; k <= cells_.z; ++k)
        for (int j = 0; j <= cells_.y; ++j)
            for (int i = 0; i <= cells_.x; ++i)
                if (inside({i, j, k})) groups.setInside(i + 1, j + 1, k + 1);
    return groups.solid();
}

}  // namespace isoscope
