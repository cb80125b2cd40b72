// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Three coordinates (or colours) of several points in vector registers.
#if defined(ISOSCOPE_SHAPES_VECTOR_TRIPLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_SHAPES_VECTOR_TRIPLE_INL
#undef ISOSCOPE_SHAPES_VECTOR_TRIPLE_INL
#else
#define ISOSCOPE_SHAPES_VECTOR_TRIPLE_INL
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "core/evaluate/algebra/sleef-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

struct Triple {
    Vector x, y, z;

    HWY_INLINE Vector operator[](std::size_t c) const { return c == 0 ? x : c == 1 ? y : z; }
};

HWY_INLINE Vector constant(double value) { return hn::Set(Doubles(), value); }
HWY_INLINE Triple constant(const glm::dvec3& v) { return {constant(v.x), constant(v.y), constant(v.z)}; }

/// From and to three columns of numbers, entry k on.
template <class Columns>
HWY_INLINE Triple load(const Columns& from, std::size_t k) {
    return {hn::LoadU(Doubles(), &from[0][k]), hn::LoadU(Doubles(), &from[1][k]),
            hn::LoadU(Doubles(), &from[2][k])};
}
template <class Columns>
HWY_INLINE void store(const Triple& a, Columns& to, std::size_t k) {
    hn::StoreU(a.x, Doubles(), &to[0][k]);
    hn::StoreU(a.y, Doubles(), &to[1][k]);
    hn::StoreU(a.z, Doubles(), &to[2][k]);
}

HWY_INLINE Triple plus(const Triple& a, const Triple& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Triple minus(const Triple& a, const Triple& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Triple times(const Triple& a, const Triple& b) {
    return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE Triple times(const Triple& a, Vector k) {
    return {hn::Mul(a.x, k), hn::Mul(a.y, k), hn::Mul(a.z, k)};
}
HWY_INLINE Vector dot(const Triple& a, const Triple& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Triple choose(hn::Mask<Doubles> which, const Triple& yes, const Triple& no) {
    return {hn::IfThenElse(which, yes.x, no.x), hn::IfThenElse(which, yes.y, no.y),
            hn::IfThenElse(which, yes.z, no.z)};
}

/// Calls visit(number of the lane) for each lane of `which`, rising.
template <class Visit>
HWY_INLINE void forEachLane(hn::Mask<Doubles> which, Visit visit) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Doubles(), which, bits);
    for (unsigned rest = bits[0], lane = 0; rest != 0; rest >>= 1, ++lane)
        if ((rest & 1u) != 0) visit(std::size_t{lane});
}

/// Whether a number is neither infinite nor NaN.
HWY_INLINE hn::Mask<Doubles> finite(Vector a) {
    return hn::Lt(hn::Abs(a), constant(std::numeric_limits<double>::infinity()));
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
