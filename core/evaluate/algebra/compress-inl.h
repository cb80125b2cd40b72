// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The chosen lanes of a vector, closed up.
#if defined(ISOSCOPE_EVALUATE_COMPRESS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_COMPRESS_INL
#undef ISOSCOPE_EVALUATE_COMPRESS_INL
#else
#define ISOSCOPE_EVALUATE_COMPRESS_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// The lanes of `mask` go to `to` and behind; up to a whole vector is overwritten.
template <class Tag, class Value = hwy::HWY_NAMESPACE::Vec<Tag>>
HWY_INLINE void appendLanes(Tag tag, Value value, hwy::HWY_NAMESPACE::Mask<Tag> mask, double* to) {
#if HWY_TARGET <= HWY_AVX3
    // Highway 1.0.3 looks this up in a table that GCC copies to the stack every time.
    if constexpr (hwy::HWY_NAMESPACE::MaxLanes(Tag()) == 8) {
        _mm512_storeu_pd(to, _mm512_maskz_compress_pd(mask.raw, value.raw));
        return;
    }
#endif
    hwy::HWY_NAMESPACE::StoreU(hwy::HWY_NAMESPACE::Compress(value, mask), tag, to);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
