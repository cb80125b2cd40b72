// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/hit_batch.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/hit_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef ISOSCOPE_SHAPES_HIT_BATCH_ONCE
#define ISOSCOPE_SHAPES_HIT_BATCH_ONCE
namespace isoscope {

/// The columns of a HitBatch, from some ray on.
struct HitRows {
    std::array<double*, HitBatch::columnCount> columns;
    HitKind* kinds;
    MaterialId* materials;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;

void takeAll(const HitBatch::Found& found, double nearest, HitKind kind, const HitRows& rows) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const auto least = hn::Set(d, nearest);
    for (std::size_t i = 0; i < found.count; i += lanes) {
        const auto t = hn::LoadU(d, found.t + i);
        const auto sooner = hn::Lt(t, hn::LoadU(d, rows.columns[HitBatch::t] + i));
        const auto taken = hn::And(hn::FirstN(d, found.count - i), hn::And(sooner, hn::Ge(t, least)));
        const std::size_t count = hn::CountTrue(d, taken);
        if (count == 0) continue;
        hn::BlendedStore(t, taken, d, rows.columns[HitBatch::t] + i);
        for (std::size_t c = 0; c < 3; ++c)
            hn::BlendedStore(hn::LoadU(d, found.normal[c] + i), taken, d,
                             rows.columns[HitBatch::normalX + c] + i);
        HWY_ALIGN double flags[HWY_MAX_BYTES / sizeof(double)];
        if (count < lanes) hn::Store(hn::IfThenElseZero(taken, hn::Set(d, 1)), d, flags);
        for (std::size_t k = 0; k < lanes; ++k) {
            if (count < lanes && flags[k] == 0) continue;
            rows.kinds[i + k] = kind;
            rows.materials[i + k] = noMaterial;
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

void HitBatch::take(const Found& found, double nearest, HitKind kind) {
    const HitRows rows{{columns_[t], columns_[normalX], columns_[normalY], columns_[normalZ]},
                       kinds_.data(),
                       materials_.data()};
    HWY_DYNAMIC_DISPATCH(takeAll)(found, nearest, kind, rows);
}

void HitBatch::claim(MaterialId material) {
    HWY_DYNAMIC_DISPATCH(claimAll)(material, size(), materials_.data());
}

}  // namespace isoscope
#endif
