// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The chosen lanes of a vector, closed up.
#if defined(ISOSCOPE_EVALUATE_COMPRESS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_COMPRESS_INL
#undef ISOSCOPE_EVALUATE_COMPRESS_INL
#else
#define ISOSCOPE_EVALUATE_COMPRESS_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2
/// For each mask of four lanes, the halves of lanes that are chosen, closed up.
struct ChosenHalves {
    alignas(32) std::array<std::array<std::int32_t, 8>, 16> of{};

    constexpr ChosenHalves() {
        for (std::size_t mask = 0; mask < of.size(); ++mask) {
            std::size_t kept = 0;
            for (std::int32_t half = 0; half < 8; ++half)
                if (((mask >> (half / 2)) & 1u) != 0) of[mask][kept++] = half;
        }
    }
};
inline constexpr ChosenHalves chosenHalves;
#endif

/// The lanes of `mask` go to `to` and behind; up to a whole vector is overwritten. Highway 1.0.3 looks this up
/// in a table that GCC copies to the stack every time, which takes longer than a step of a march.
template <class Tag, class Value = hwy::HWY_NAMESPACE::Vec<Tag>>
HWY_INLINE void appendLanes(Tag tag, Value value, hwy::HWY_NAMESPACE::Mask<Tag> mask, double* to) {
#if HWY_TARGET <= HWY_AVX3
    if constexpr (hwy::HWY_NAMESPACE::MaxLanes(Tag()) == 8) {
        _mm512_storeu_pd(to, _mm512_maskz_compress_pd(mask.raw, value.raw));
        return;
    }
#elif HWY_TARGET == HWY_AVX2
    if constexpr (hwy::HWY_NAMESPACE::MaxLanes(Tag()) == 4) {
        const auto chosen = static_cast<std::size_t>(_mm256_movemask_pd(mask.raw));
        const __m256i halves =
            _mm256_load_si256(reinterpret_cast<const __m256i*>(chosenHalves.of[chosen].data()));
        const __m256 closed = _mm256_permutevar8x32_ps(_mm256_castpd_ps(value.raw), halves);
        _mm256_storeu_pd(to, _mm256_castps_pd(closed));
        return;
    }
#endif
    hwy::HWY_NAMESPACE::StoreU(hwy::HWY_NAMESPACE::Compress(value, mask), tag, to);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
