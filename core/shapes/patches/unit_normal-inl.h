// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. unitNormal() of several normals in vector registers.
#if defined(ISOSCOPE_SHAPES_UNIT_NORMAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_SHAPES_UNIT_NORMAL_INL
#undef ISOSCOPE_SHAPES_UNIT_NORMAL_INL
#else
#define ISOSCOPE_SHAPES_UNIT_NORMAL_INL
#endif

#include "core/shapes/patches/vector_triple-inl.h"
#include "core/shapes/rays/hit_list.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

HWY_INLINE Triple dividedBy(const Triple& a, Vector k) {
    return {hn::Div(a.x, k), hn::Div(a.y, k), hn::Div(a.z, k)};
}

/// To the bit what unitNormal() answers, in the `wanted` lanes.
HWY_INLINE Triple unitNormals(const Triple& normal, hn::Mask<Doubles> wanted) {
    const Doubles d;
    const Vector square = dot(normal, normal);
    const auto ordinary = hn::And(hn::Gt(square, constant(1e-200)), hn::Lt(square, constant(1e200)));
    Triple result = dividedBy(normal, hn::Sqrt(square));
    if (HWY_LIKELY(hn::AllFalse(d, hn::AndNot(ordinary, wanted)))) return result;
    HWY_ALIGN double lanes[3][HWY_MAX_BYTES / sizeof(double)];
    double* columns[3] = {lanes[0], lanes[1], lanes[2]};
    store(normal, columns, 0);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        const glm::dvec3 unit = unitNormal({lanes[0][i], lanes[1][i], lanes[2][i]});
        for (std::size_t c = 0; c < 3; ++c) lanes[c][i] = unit[static_cast<int>(c)];
    }
    return load(columns, 0);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
