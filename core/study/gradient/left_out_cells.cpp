// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/left_out_cells.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

namespace {

constexpr std::size_t mostCells = 64;
/// Ends of boxes are rounded: as a part of a cell.
constexpr double endRounding = 1e-9;

}  // namespace

LeftOutCells::LeftOutCells(const GradientBox& whole) : whole_(whole) {
    const double widest = whole.width() / static_cast<double>(mostCells);
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = whole.high[axis] - whole.low[axis];
        // Powers of two, so that cells are what halving gives.
        std::size_t& count = counts_[static_cast<std::size_t>(axis)];
        while (count < mostCells && extent > widest * static_cast<double>(count)) count *= 2;
        width_ = std::max(width_, extent / static_cast<double>(count));
    }
}

LeftOutCells::Range LeftOutCells::cells(int axis, double low, double high, bool ends) const {
    const std::size_t count = counts_[static_cast<std::size_t>(axis)];
    const double extent = whole_.high[axis] - whole_.low[axis];
    if (!(extent > 0)) return {0, 0};
    const double scale = static_cast<double>(count) / extent;
    double first = (low - whole_.low[axis]) * scale, last = (high - whole_.low[axis]) * scale;
    // What has no extent belongs to the cells on both its sides.
    const double inwards = ends || last - first < 4 * endRounding ? -endRounding : endRounding;
    first = std::floor(first + inwards);
    last = std::ceil(last - inwards) - 1;
    const double top = static_cast<double>(count - 1);
    return {static_cast<std::size_t>(std::clamp(first, 0.0, top)),
            static_cast<std::size_t>(std::clamp(last, 0.0, top))};
}

std::size_t LeftOutCells::indexOf(std::size_t x, std::size_t y, std::size_t z) const {
    return (x * counts_[1] + y) * counts_[2] + z;
}

void LeftOutCells::add(const GradientBox& box) {
    if (leftOut_.empty()) leftOut_.resize(counts_[0] * counts_[1] * counts_[2]);
    std::array<Range, 3> ranges{};
    for (int axis = 0; axis < 3; ++axis) {
        Range& range = ranges[static_cast<std::size_t>(axis)];
        range = cells(axis, box.low[axis], box.high[axis], true);
        range.first -= range.first > 0 ? 1 : 0;
        range.last = std::min(range.last + 1, counts_[static_cast<std::size_t>(axis)] - 1);
    }
    for (std::size_t x = ranges[0].first; x <= ranges[0].last; ++x)
        for (std::size_t y = ranges[1].first; y <= ranges[1].last; ++y)
            for (std::size_t z = ranges[2].first; z <= ranges[2].last; ++z) {
                auto cell = leftOut_[indexOf(x, y, z)];
                count_ += cell ? 0 : 1;
                cell = true;
            }
}

bool LeftOutCells::holds(const glm::dvec3& point) const {
    if (empty()) return false;
    std::array<Range, 3> ranges{};
    for (int axis = 0; axis < 3; ++axis)
        ranges[static_cast<std::size_t>(axis)] = cells(axis, point[axis], point[axis], true);
    for (std::size_t x = ranges[0].first; x <= ranges[0].last; ++x)
        for (std::size_t y = ranges[1].first; y <= ranges[1].last; ++y)
            for (std::size_t z = ranges[2].first; z <= ranges[2].last; ++z)
                if (leftOut_[indexOf(x, y, z)]) return true;
    return false;
}

bool LeftOutCells::holds(const GradientBox& box) const {
    if (empty()) return false;
    std::array<Range, 3> ranges{};
    for (int axis = 0; axis < 3; ++axis)
        ranges[static_cast<std::size_t>(axis)] = cells(axis, box.low[axis], box.high[axis], false);
    for (std::size_t x = ranges[0].first; x <= ranges[0].last; ++x)
        for (std::size_t y = ranges[1].first; y <= ranges[1].last; ++y)
            for (std::size_t z = ranges[2].first; z <= ranges[2].last; ++z)
                if (!leftOut_[indexOf(x, y, z)]) return false;
    return true;
}

double LeftOutCells::share() const {
    return empty() ? 0 : static_cast<double>(count_) / static_cast<double>(leftOut_.size());
}

}  // namespace isoscope
