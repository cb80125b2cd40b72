// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/hit_batch.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/rays/hit_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

static_assert(sizeof(HitKind) == 1);

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;

void takeAll(const HitBatch::Found& found, HitKind kind, const HitBatch::Columns& hits) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t i = 0; i < found.count; i += lanes) {
        const auto t = hn::LoadU(d, found.t + i);
        const auto sooner = hn::Lt(t, hn::LoadU(d, hits.t + i));
        const auto taken = hn::And(hn::FirstN(d, found.count - i), sooner);
        const std::size_t count = hn::CountTrue(d, taken);
        if (count == 0) continue;
        hn::BlendedStore(t, taken, d, hits.t + i);
        for (std::size_t c = 0; c < 3; ++c)
            hn::BlendedStore(hn::LoadU(d, found.normal[c] + i), taken, d, hits.normal[c] + i);
        if (count == lanes) {
            const hn::Rebind<MaterialId, Doubles> materials;
            hn::StoreU(hn::Set(materials, noMaterial), materials, hits.materials + i);
            const hn::Rebind<std::uint8_t, Doubles> kinds;
            hn::StoreU(hn::Set(kinds, static_cast<std::uint8_t>(kind)), kinds,
                       reinterpret_cast<std::uint8_t*>(hits.kinds + i));
            continue;
        }
        HWY_ALIGN double flags[HWY_MAX_BYTES / sizeof(double)];
        hn::Store(hn::IfThenElseZero(taken, hn::Set(d, 1)), d, flags);
        for (std::size_t k = 0; k < lanes; ++k) {
            if (flags[k] == 0) continue;
            hits.kinds[i + k] = kind;
            hits.materials[i + k] = noMaterial;
        }
    }
}

void claimAll(MaterialId material, std::size_t count, MaterialId* materials) {
    const hn::ScalableTag<MaterialId> d;
    const auto none = hn::Set(d, noMaterial), claimed = hn::Set(d, material);
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto before = hn::LoadU(d, materials + i);
        hn::StoreU(hn::IfThenElse(hn::Eq(before, none), claimed, before), d, materials + i);
    }
    for (; i < count; ++i)
        if (materials[i] == noMaterial) materials[i] = material;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(takeAll);
HWY_EXPORT(claimAll);

void HitBatch::take(const Found& found, HitKind kind) {
    HWY_DYNAMIC_DISPATCH(takeAll)(found, kind, columns());
}

bool HitBatch::takeWhole(Table& found, HitKind kind) {
    if (!untouched_ || found.size() != size()) return false;
    std::swap(columns_, found);
    std::fill_n(kinds_.begin(), size(), kind);
    std::fill_n(materials_.begin(), size(), noMaterial);
    untouched_ = false;
    return true;
}

void HitBatch::setMaterial(MaterialId material) {
    HWY_DYNAMIC_DISPATCH(claimAll)(material, size(), materials_.data());
}

}  // namespace isoscope
#endif
