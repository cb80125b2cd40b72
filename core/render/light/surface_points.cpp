// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/surface_points.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/light/surface_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/evaluate/algebra/compress-inl.h"
#include "core/shapes/patches/vector_triple-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

/// Writes the lanes of `mask` to entry `k` and behind; what follows there is overwritten.
HWY_INLINE void append(const Triple& a, hn::Mask<Doubles> mask, SurfacePoints::Vectors& to, std::size_t k) {
    for (std::size_t c = 0; c < 3; ++c) appendLanes(Doubles(), a[c], mask, &to[c][k]);
}

/// As many numbers of four bytes as a vector has lanes.
template <class Number>
HWY_INLINE void copyVector(const Number* from, Number* to) {
    const hn::Rebind<Number, Doubles> d;
    hn::StoreU(hn::LoadU(d, from), d, to);
}

/// All rays that have met something; the lists have room for every ray. Returns how many.
std::size_t gatherAll(const RayBatch& rays, const HitBatch& hits, SurfacePoints& points) {
    const std::array<const double*, 3> origins = rays.origins(), directions = rays.directions();
    const std::array<const double*, 3> normals{hits[HitBatch::normalX], hits[HitBatch::normalY],
                                               hits[HitBatch::normalZ]};
    std::size_t count = 0;
    for (std::size_t i = 0; i < hits.size(); i += hn::Lanes(Doubles())) {
        const Vector t = hn::LoadU(Doubles(), hits[HitBatch::t] + i);
        const auto met =
            hn::And(hn::FirstN(Doubles(), hits.size() - i), hn::Lt(t, hn::Set(Doubles(), HitBatch::never)));
        if (hn::AllFalse(Doubles(), met)) continue;
        const Triple direction = load(directions, i);
        append(plus(load(origins, i), times(direction, t)), met, points.point, count);
        append(load(normals, i), met, points.normal, count);
        append(direction, met, points.view, count);
        if (hn::AllTrue(Doubles(), met)) {
            copyVector(rays.samples() + i, points.samples.data() + count);
            copyVector(hits.materials() + i, points.materials.data() + count);
            count += hn::Lanes(Doubles());
            continue;
        }
        std::size_t end = count;
        const std::size_t here = std::min(hn::Lanes(Doubles()), hits.size() - i);
        for (std::size_t k = i; k < i + here; ++k) {
            if (!hits.found(k)) continue;
            points.samples[end] = rays.samples()[k];
            points.materials[end++] = hits.material(k);
        }
        count = end;
    }
    return count;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(gatherAll);

void SurfacePoints::gather(const RayBatch& rays, const HitBatch& hits) {
    makeRoom(hits.size());
    samples.resize(hits.size());
    materials.resize(hits.size());
    const std::size_t count = HWY_DYNAMIC_DISPATCH(gatherAll)(rays, hits, *this);
    samples.resize(count);
    materials.resize(count);
}

void SurfacePoints::makeRoom(std::size_t points) {
    const std::size_t room = points + padding;
    for (Vectors* vectors : {&point, &normal, &view, &pigment, &shine, &toLight, &returned})
        for (Column& column : *vectors)
            if (column.size() < room) column.resize(room);
    for (Column& column : weight)
        if (weighted && column.size() < room) column.resize(room);
    for (Vectors* vectors : {&transmission, &tint, &straight})
        for (Column& column : *vectors)
            if (lookedUp && column.size() < room) column.resize(room);
    if (weighted && share.size() < room) share.resize(room);
    for (Column* column : {&distance, &strength})
        if (column->size() < room) column->resize(room);
}

}  // namespace isoscope
#endif
