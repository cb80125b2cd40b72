// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/secondary_lines.h"

#include <algorithm>

namespace isoscope {

namespace {

/// Reversed lines from beyond the container begin so much of their way through it before its wall: a line
/// that begins in the container meets no wall there (CertifiedRootFinder).
constexpr double leadPart = 0.125;

}  // namespace

void SecondaryLines::reverse(const RayBatch& rays, const ContainerPassages& passages, double nearLimit,
                             const double* ends) {
    prepare(rays, true);
    endsAtWall_.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RayInterval passage = passages.range(i);
        const double from = std::max(passage.near, nearLimit), to = std::min(passage.far, ends[i]);
        const bool empty = !(from < to);
        const double lead = passage.far < ends[i] ? leadPart * (passage.far - passage.near) : 0;
        const double begin = empty ? 0 : to + lead;
        place(rays, i, begin);
        table_[near][i] = empty ? 1 : lead;
        table_[far][i] = empty ? 0 : begin - from;
        endsAtWall_[i] = passage.near >= nearLimit && passage.near > 0;
    }
}

void SecondaryLines::start(const RayBatch& rays, const ContainerPassages& passages, double nearLimit) {
    prepare(rays, false);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RayInterval passage = passages.range(i);
        // A line from outside keeps its way to the wall, which it may meet.
        const double begin = passage.near < nearLimit ? nearLimit : 0;
        place(rays, i, begin);
        table_[near][i] = std::max(passage.near - begin, 0.0);
        table_[far][i] = passage.far - begin;
    }
}

void SecondaryLines::prepare(const RayBatch& rays, bool reversed) {
    reversed_ = reversed;
    table_.reserve(rays.size());
    table_.setSize(rays.size());
}

void SecondaryLines::place(const RayBatch& rays, std::size_t i, double begin) {
    const auto origins = rays.origins(), directions = rays.directions();
    for (std::size_t c = 0; c < 3; ++c) {
        table_[originX + c][i] = origins[c][i] + begin * directions[c][i];
        table_[directionX + c][i] = reversed_ ? -directions[c][i] : directions[c][i];
    }
    table_[origin][i] = begin;
}

LineColumns SecondaryLines::columns() const {
    return {table_.size(),
            {table_[originX], table_[originY], table_[originZ]},
            {table_[directionX], table_[directionY], table_[directionZ]},
            table_[near],
            table_[far]};
}

}  // namespace isoscope
