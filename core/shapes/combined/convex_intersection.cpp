// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/convex_intersection.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/combined/convex_intersection.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/shapes/composition.h"
#include "core/shapes/patches/unit_normal-inl.h"
#include "core/shapes/rays/nested_memory.h"
#include "core/shapes/rays/placed_lanes.h"

#ifndef ISOSCOPE_SHAPES_CONVEX_INTERSECTION_ONCE
#define ISOSCOPE_SHAPES_CONVEX_INTERSECTION_ONCE
namespace isoscope {

/// One part, for the rays of a batch.
struct PartSpans {
    const double *in, *out, *doubt;
    std::array<const double*, 3> inNormal, outNormal;
    const glm::dmat4* backward;  ///< null: where it was made
    bool inverse;
    MaterialId material;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Lanes = hn::Mask<Doubles>;

const double infinity = std::numeric_limits<double>::infinity();
/// Ends this near to each other, in units of the size of their coordinates, are left to the search one by
/// one, and so are pieces this short: there solids take points very near to their border for outside ones.
constexpr double nearEnds = 1e-6, shortPiece = 1e-3;

/// The pieces of all parts for a vector of rays.
class Pieces {
  public:
    HWY_INLINE Pieces(std::span<const PartSpans> parts, std::size_t first) : parts_(parts) {
        const Doubles d;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            in_[i] = hn::LoadU(d, parts[i].in + first);
            out_[i] = hn::LoadU(d, parts[i].out + first);
        }
    }

    HWY_INLINE Vector in(std::size_t part) const { return in_[part]; }
    HWY_INLINE Vector out(std::size_t part) const { return out_[part]; }
    HWY_INLINE Lanes met(std::size_t part) const { return hn::Le(in_[part], out_[part]); }

    /// Whether the place t is inside of all parts but one.
    HWY_INLINE Lanes insideOthers(std::size_t but, Vector t) const {
        Lanes inside = hn::Eq(t, t);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (i == but) continue;
            const Lanes between = hn::And(hn::Lt(in_[i], t), hn::Lt(t, out_[i]));
            inside = parts_[i].inverse ? hn::AndNot(between, inside) : hn::And(between, inside);
        }
        return inside;
    }

    /// Where ends lie together, closer than `nearby`, or a piece is shorter than `shortest`.
    HWY_INLINE Lanes unclear(Vector nearby, Vector shortest) const {
        Lanes result = hn::Lt(nearby, nearby);
        const auto close = [&](Vector a, Vector b) {
            // The difference of two infinities is not close.
            result = hn::Or(result, hn::Lt(hn::Abs(hn::Sub(a, b)), nearby));
        };
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Vector length = hn::Sub(out_[i], in_[i]);
            result = hn::Or(result, hn::And(met(i), hn::Lt(length, shortest)));
            for (std::size_t k = 0; k < i; ++k) {
                close(in_[i], in_[k]);
                close(in_[i], out_[k]);
                close(out_[i], in_[k]);
                close(out_[i], out_[k]);
            }
        }
        return result;
    }

  private:
    std::span<const PartSpans> parts_;
    Vector in_[ConvexIntersection::partLimit], out_[ConvexIntersection::partLimit];
};

/// The nearest border of each ray.
struct Border {
    Vector t, part, leaving;
};

HWY_INLINE Border nearestBorder(const Pieces& pieces, std::size_t parts, Vector nearest) {
    const Vector zero = constant(0);
    Border best{constant(infinity), zero, zero};
    for (std::size_t i = 0; i < parts; ++i) {
        for (const bool leaving : {false, true}) {
            const Vector t = leaving ? pieces.out(i) : pieces.in(i);
            const Lanes better = hn::And(hn::And(pieces.met(i), hn::Ge(t, nearest)),
                                         hn::And(hn::Lt(t, best.t), pieces.insideOthers(i, t)));
            best.t = hn::IfThenElse(better, t, best.t);
            best.part = hn::IfThenElse(better, constant(static_cast<double>(i)), best.part);
            best.leaving = hn::IfThenElse(better, constant(leaving ? 1 : 0), best.leaving);
        }
    }
    return best;
}

HWY_INLINE Triple normalOf(const PartSpans& part, Lanes leaving, Lanes wanted, std::size_t first) {
    Triple normal = choose(leaving, load(part.outNormal, first), load(part.inNormal, first));
    if (part.inverse) normal = {hn::Neg(normal.x), hn::Neg(normal.y), hn::Neg(normal.z)};
    if (part.backward == nullptr) return normal;
    const auto row = [&](int c) { return dot(constant(glm::dvec3((*part.backward)[c])), normal); };
    return unitNormals({row(0), row(1), row(2)}, wanted);
}

/// How large coordinates are about the first place where a ray meets anything.
HWY_INLINE Vector sizeThere(const RayBatch& rays, const Pieces& pieces, std::size_t parts, Vector nearest,
                            std::size_t first) {
    Vector t = constant(infinity);
    for (std::size_t i = 0; i < parts; ++i)
        for (const Vector& end : {pieces.in(i), pieces.out(i)})
            t = hn::IfThenElse(hn::Ge(end, nearest), hn::Min(t, end), t);
    t = hn::IfThenElse(finite(t), t, nearest);
    const Triple place = plus(load(rays.origins(), first), times(load(rays.directions(), first), t));
    return hn::Max(hn::Max(constant(1), hn::Abs(place.x)), hn::Max(hn::Abs(place.y), hn::Abs(place.z)));
}

void joinParts(const RayBatch& rays, std::span<const PartSpans> parts, double nearLimit, bool normals,
               HitBatch::Columns hits, std::vector<std::uint32_t>& doubtful) {
    const Doubles d;
    const Vector nearest = constant(nearLimit);
    for (std::size_t first = 0; first < rays.size(); first += hn::Lanes(d)) {
        const Lanes present = hn::FirstN(d, std::min(rays.size() - first, hn::Lanes(d)));
        const Pieces pieces(parts, first);
        const Triple direction = load(rays.directions(), first);
        const Vector size = hn::Div(sizeThere(rays, pieces, parts.size(), nearest, first),
                                    hn::Sqrt(dot(direction, direction)));
        const Vector nearby = hn::Mul(constant(nearEnds), size);
        Lanes doubt = pieces.unclear(nearby, hn::Mul(constant(shortPiece), size));
        doubt = hn::Or(doubt, hn::Not(hn::And(hn::Gt(nearby, hn::Zero(d)), finite(nearby))));
        for (const PartSpans& part : parts)
            doubt = hn::Or(doubt, hn::Ne(hn::LoadU(d, part.doubt + first), hn::Zero(d)));
        forEachLane(hn::And(present, doubt),
                    [&](std::size_t lane) { doubtful.push_back(static_cast<std::uint32_t>(first + lane)); });
        const Border border = nearestBorder(pieces, parts.size(), nearest);
        const Vector known = hn::LoadU(d, hits.t + first);
        const Lanes found = hn::And(hn::AndNot(doubt, present), hn::Lt(border.t, known));
        if (hn::AllFalse(d, found)) continue;
        hn::StoreU(hn::IfThenElse(found, border.t, known), d, hits.t + first);
        const Lanes leaving = hn::Ne(border.leaving, hn::Zero(d));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Lanes own = hn::And(found, hn::Eq(border.part, constant(static_cast<double>(i))));
            if (hn::AllFalse(d, own)) continue;
            if (normals)
                store(choose(own, normalOf(parts[i], leaving, own, first), load(hits.normal, first)),
                      hits.normal, first);
            forEachLane(own, [&](std::size_t lane) {
                hits.kinds[first + lane] = HitKind::crossing;
                hits.materials[first + lane] = parts[i].material;
            });
        }
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(joinParts);

namespace {

struct PartMemory {
    RayBatch moved;
    std::array<SpanBatch, ConvexIntersection::partLimit> spans;
};

}  // namespace

std::optional<ConvexIntersection> ConvexIntersection::of(std::span<const ShapePointer> parts) {
    ConvexIntersection result;
    for (const ShapePointer& part : parts)
        if (!result.add(part, Transform(), false, noMaterial)) return {};
    if (result.parts_.size() < 2) return {};
    return result;
}

bool ConvexIntersection::add(const ShapePointer& shape, const Transform& around, bool inverse,
                             MaterialId material) {
    using enum Composition::Kind;
    const Composition made = shape->composition();
    if (!made.limits.empty()) return false;
    switch (made.kind) {
        case primitive: break;
        case wrapped:
            return add(made.parts.front(), made.transform ? made.transform->then(around) : around, inverse,
                       made.material == noMaterial ? material : made.material);
        case complement: return add(made.parts.front(), around, !inverse, material);
        case union_:
        case merge: return false;
        case intersection:
            return !inverse && !made.parts.empty() &&
                   std::all_of(made.parts.begin(), made.parts.end(),
                               [&](const ShapePointer& part) { return add(part, around, false, material); });
    }
    const ConvexSolid* solid = shape->convexSolid();
    if (solid == nullptr || parts_.size() == partLimit) return false;
    parts_.push_back({shape, solid, around, !around.identity(), inverse, material});
    return true;
}

void ConvexIntersection::nearest(const RayBatch& rays, TraceContext& context, HitBatch& hits,
                                 std::vector<std::uint32_t>& doubtful) const {
    doubtful.clear();
    context.rays += rays.size() * parts_.size();
    const NestedMemory<PartMemory> memory(context);
    std::array<PartSpans, partLimit> found;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        SpanBatch& spans = memory->spans[i];
        if (part.moved) moveToObject(part.transform, rays, memory->moved);
        part.solid->spans(part.moved ? memory->moved : rays, spans);
        const auto in = spans.inNormals(), out = spans.outNormals();
        found[i] = {spans[SpanBatch::in],
                    spans[SpanBatch::out],
                    spans[SpanBatch::doubt],
                    {in[0], in[1], in[2]},
                    {out[0], out[1], out[2]},
                    part.moved ? &part.transform.backward() : nullptr,
                    part.inverse,
                    part.material};
    }
    HWY_DYNAMIC_DISPATCH(joinParts)
    (rays, std::span(found).first(parts_.size()), context.nearLimit, !context.shadowRay, hits.columns(),
     doubtful);
}

}  // namespace isoscope
#endif
