// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/solid_lanes.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/rays/solid_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shapes/patches/unit_normal-inl.h"
#include "core/shapes/rays/centered_ray.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Lanes = hn::Mask<Doubles>;

const double infinity = std::numeric_limits<double>::infinity();

HWY_INLINE Triple along(const Triple& origin, Vector t, const Triple& direction) {
    return plus(origin, times(direction, t));
}
HWY_INLINE Vector bit(Lanes which) { return hn::IfThenElseZero(which, constant(1)); }

/// The rays of a batch, a vector at a time, and what is known of them.
class Vectors {
  public:
    explicit Vectors(const SolidQuestion& question)
        : question_(question),
          origins_(question.rays.origins()),
          directions_(question.rays.directions()),
          hits_(question.hits.columns()),
          nearest_(constant(question.nearest)),
          known_(nearest_) {}

    /// Calls meet(first ray) for each vector.
    template <class Meet>
    void each(Meet meet) {
        for (first_ = 0; first_ < question_.rays.size(); first_ += hn::Lanes(Doubles())) {
            known_ = hn::LoadU(Doubles(), hits_.t + first_);
            meet(load(origins_, first_), load(directions_, first_));
        }
    }

    Lanes present() const {
        return hn::FirstN(Doubles(), std::min(question_.rays.size() - first_, hn::Lanes(Doubles())));
    }
    /// Whether a hit there counts.
    Lanes counts(Vector t) const { return hn::And(hn::Ge(t, nearest_), hn::Le(t, known_)); }
    Vector nearest() const { return nearest_; }
    bool wantsNormals() const { return question_.normals; }

    /// Takes those of the hits that come before what is known; `normal(lanes)` is called when wanted.
    template <class Normal>
    void take(Vector t, Lanes met, Normal normal) {
        const Doubles d;
        const Lanes found = hn::And(hn::And(met, present()), hn::Lt(t, known_));
        if (hn::AllFalse(d, found)) return;
        hn::StoreU(hn::IfThenElse(found, t, known_), d, hits_.t + first_);
        if (question_.normals)
            store(choose(found, normal(found), load(hits_.normal, first_)), hits_.normal, first_);
        forEach(found, [&](std::size_t i) {
            hits_.kinds[i] = HitKind::crossing;
            hits_.materials[i] = noMaterial;
        });
    }

    /// Calls visit(number of the ray) for each of the lanes.
    template <class Visit>
    void forEach(Lanes which, Visit visit) const {
        forEachLane(which, [&](std::size_t lane) { visit(first_ + lane); });
    }

  private:
    const SolidQuestion& question_;
    std::array<const double*, 3> origins_, directions_;
    HitBatch::Columns hits_;
    Vector nearest_, known_;
    std::size_t first_ = 0;
};

void meetPlane(const glm::dvec3& normal, double distance, double horizon, const SolidQuestion& question) {
    const Triple across = constant(normal);
    Vectors rays(question);
    rays.each([&](const Triple& origin, const Triple& direction) {
        const Vector approach = dot(across, direction);
        const Vector t = hn::Div(hn::Sub(constant(distance), dot(across, origin)), approach);
        const Vector away = hn::Mul(t, hn::Sqrt(dot(direction, direction)));
        const Lanes met = hn::And(hn::Ne(approach, constant(0)), hn::Le(away, constant(horizon)));
        rays.take(t, hn::And(met, rays.counts(t)), [&](Lanes) { return across; });
    });
}

/// The part of lines in a sphere.
struct Chords {
    Triple across, along;  ///< from the center to the middle, and from there to the end
    Vector in, out;
    Lanes cut;

    HWY_INLINE Chords(const glm::dvec3& center, double radius, const Triple& origin,
                      const Triple& direction) {
        const Vector squaredSpeed = dot(direction, direction);
        const Triple arm = minus(origin, constant(center));
        const Vector middle = hn::Div(hn::Neg(dot(arm, direction)), squaredSpeed);
        across = isoscope::HWY_NAMESPACE::along(arm, middle, direction);
        const Vector squaredChord =
            hn::Div(hn::Sub(constant(radius * radius), dot(across, across)), squaredSpeed);
        const Vector half = hn::Sqrt(squaredChord);
        along = times(direction, half);
        in = hn::Sub(middle, half);
        out = hn::Add(middle, half);
        cut = hn::And(hn::And(hn::Gt(squaredSpeed, constant(0)), hn::Gt(squaredChord, constant(0))),
                      hn::And(finite(middle), finite(half)));
    }
};

void meetSphere(const glm::dvec3& center, double radius, const SolidQuestion& question) {
    Vectors rays(question);
    rays.each([&](const Triple& origin, const Triple& direction) {
        const Chords chord(center, radius, origin, direction);
        const Lanes entering = hn::Ge(chord.in, rays.nearest());
        const Vector t = hn::IfThenElse(entering, chord.in, chord.out);
        rays.take(t, hn::And(chord.cut, rays.counts(t)), [&](Lanes found) {
            return unitNormals(
                choose(entering, minus(chord.across, chord.along), plus(chord.across, chord.along)), found);
        });
    });
}

/// Writes what lies in a convex solid, a vector at a time.
class Spans {
  public:
    Spans(const RayBatch& rays, SpanBatch& spans)
        : rays_(rays),
          origins_(rays.origins()),
          directions_(rays.directions()),
          in_(spans[SpanBatch::in]),
          out_(spans[SpanBatch::out]),
          doubt_(spans[SpanBatch::doubt]),
          inNormals_(spans.inNormals()),
          outNormals_(spans.outNormals()) {}

    template <class Find>
    void each(Find find) {
        for (first_ = 0; first_ < rays_.size(); first_ += hn::Lanes(Doubles()))
            find(load(origins_, first_), load(directions_, first_));
    }

    HWY_INLINE void set(Lanes met, Vector in, Vector out, Lanes doubt) {
        const Doubles d;
        hn::StoreU(hn::IfThenElse(met, in, constant(infinity)), d, in_ + first_);
        hn::StoreU(hn::IfThenElse(met, out, constant(-infinity)), d, out_ + first_);
        hn::StoreU(bit(doubt), d, doubt_ + first_);
    }
    HWY_INLINE void setNormals(const Triple& in, const Triple& out) {
        store(in, inNormals_, first_);
        store(out, outNormals_, first_);
    }

  private:
    const RayBatch& rays_;
    std::array<const double*, 3> origins_, directions_;
    double *in_, *out_, *doubt_;
    std::array<double*, 3> inNormals_, outNormals_;
    std::size_t first_ = 0;
};

void findSphereSpans(const glm::dvec3& center, double radius, const RayBatch& rays, SpanBatch& batch) {
    Spans spans(rays, batch);
    spans.each([&](const Triple& origin, const Triple& direction) {
        const Chords chord(center, radius, origin, direction);
        spans.set(chord.cut, chord.in, chord.out, hn::Lt(chord.in, chord.in));
        spans.setNormals(unitNormals(minus(chord.across, chord.along), chord.cut),
                         unitNormals(plus(chord.across, chord.along), chord.cut));
    });
}

/// A ray more level than this with a wall, and nearer to it, in units of the solid's size, may lie in it.
constexpr double levelSlope = 1e-7, levelDistance = 1e-6;

void findPlaneSpans(const glm::dvec3& normal, double distance, double horizon, const RayBatch& rays,
                    SpanBatch& batch) {
    const Triple across = constant(normal);
    Spans spans(rays, batch);
    spans.each([&](const Triple& origin, const Triple& direction) {
        const Vector approach = dot(across, direction), speed = hn::Sqrt(dot(direction, direction));
        const Vector t = hn::Div(hn::Sub(constant(distance), dot(across, origin)), approach);
        const Lanes entering = hn::Lt(approach, constant(0));
        const Lanes sure = hn::And(hn::Gt(hn::Abs(approach), hn::Mul(constant(1e-5), speed)),
                                   hn::Lt(hn::Mul(hn::Abs(t), speed), constant(0.5 * horizon)));
        spans.set(sure, hn::IfThenElse(entering, t, constant(-infinity)),
                  hn::IfThenElse(entering, constant(infinity), t), hn::Not(sure));
        spans.setNormals(across, across);
    });
}

/// The part of lines in a box, and the normals of the faces at its ends, when wanted.
struct Passages {
    Vector in, out;
    Triple inNormal, outNormal;
    Lanes passes, grazing;

    template <bool wantsNormals>
    HWY_INLINE static Passages of(const glm::dvec3& low, const glm::dvec3& high, const Triple& origin,
                                  const Triple& direction) {
        const Vector zero = constant(0), one = constant(1);
        const Triple lowest = constant(low), highest = constant(high), nowhere{zero, zero, zero};
        const Vector size = constant(levelDistance * (1 + glm::length(high - low)));
        const Vector slow = hn::Mul(constant(levelSlope), hn::Sqrt(dot(direction, direction)));
        Passages p{constant(-infinity), constant(infinity), nowhere, nowhere,
                   hn::Eq(zero, zero),  hn::Lt(zero, zero)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vector from = origin[axis], slope = direction[axis];
            const Lanes forwards = hn::Gt(slope, zero), level = hn::Eq(slope, zero);
            p.passes = hn::And(p.passes, hn::And(finite(from), finite(slope)));
            const Lanes beside = hn::Or(hn::Lt(from, lowest[axis]), hn::Gt(from, highest[axis]));
            p.passes = hn::AndNot(hn::And(level, beside), p.passes);
            const auto meet = [&](Vector wall) { return hn::Div(hn::Sub(wall, from), slope); };
            const Vector first = meet(hn::IfThenElse(forwards, lowest[axis], highest[axis]));
            const Vector last = meet(hn::IfThenElse(forwards, highest[axis], lowest[axis]));
            const Lanes later = hn::AndNot(level, hn::Gt(first, p.in));
            const Lanes earlier = hn::AndNot(level, hn::Lt(last, p.out));
            p.in = hn::IfThenElse(later, first, p.in);
            p.out = hn::IfThenElse(earlier, last, p.out);
            if constexpr (!wantsNormals) continue;
            const auto near = [&](Vector wall) { return hn::Lt(hn::Abs(hn::Sub(from, wall)), size); };
            p.grazing = hn::Or(p.grazing, hn::And(hn::Lt(hn::Abs(slope), slow),
                                                  hn::Or(near(lowest[axis]), near(highest[axis]))));
            const Vector side = hn::IfThenElse(forwards, one, hn::Neg(one));
            const Triple face{axis == 0 ? side : zero, axis == 1 ? side : zero, axis == 2 ? side : zero};
            p.inNormal = choose(later, minus(nowhere, face), p.inNormal);
            p.outNormal = choose(earlier, face, p.outNormal);
        }
        p.passes = hn::And(p.passes, hn::And(hn::And(finite(p.in), finite(p.out)), hn::Le(p.in, p.out)));
        return p;
    }
};

template <bool wantsNormals>
HWY_INLINE void meetBoxes(const glm::dvec3& low, const glm::dvec3& high, const SolidQuestion& question) {
    Vectors rays(question);
    rays.each([&](const Triple& origin, const Triple& direction) {
        const Passages passage = Passages::of<wantsNormals>(low, high, origin, direction);
        if (hn::AllFalse(Doubles(), passage.passes)) return;
        const Lanes entering = rays.counts(passage.in);
        const Vector t = hn::IfThenElse(entering, passage.in, passage.out);
        rays.take(t, hn::And(passage.passes, rays.counts(t)),
                  [&](Lanes) { return choose(entering, passage.inNormal, passage.outNormal); });
    });
}

void meetBox(const glm::dvec3& low, const glm::dvec3& high, const SolidQuestion& question) {
    if (question.normals)
        meetBoxes<true>(low, high, question);
    else
        meetBoxes<false>(low, high, question);
}

void findBoxSpans(const glm::dvec3& low, const glm::dvec3& high, const RayBatch& rays, SpanBatch& batch) {
    Spans spans(rays, batch);
    spans.each([&](const Triple& origin, const Triple& direction) {
        const Passages passage = Passages::of<true>(low, high, origin, direction);
        spans.set(passage.passes, passage.in, passage.out, passage.grazing);
        spans.setNormals(passage.inNormal, passage.outNormal);
    });
}

/// CenteredRay of several rays.
struct CenteredRays {
    Triple origin, direction;
    Vector middle, speed;
    Lanes usable;

    HWY_INLINE CenteredRays(const Triple& from, const Triple& towards, const glm::dvec3& center) {
        speed = hn::Sqrt(dot(towards, towards));
        direction = dividedBy(towards, speed);
        const Triple arm = minus(from, constant(center));
        middle = hn::Div(hn::Neg(dot(arm, direction)), speed);
        origin = plus(arm, times(direction, hn::Mul(middle, speed)));
        usable = hn::And(hn::And(hn::Gt(speed, constant(0)), finite(speed)),
                         hn::And(finite(middle), finite(dot(origin, origin))));
    }
    HWY_INLINE Vector toRay(Vector s) const { return hn::Add(middle, hn::Div(s, speed)); }
};

/// The rounded a b + c.
HWY_INLINE Vector fused(Vector a, Vector b, Vector c) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_NEON
    return hn::MulAdd(a, b, c);
#else
    const Doubles d;
    HWY_ALIGN double lanes[3][HWY_MAX_BYTES / sizeof(double)];
    hn::Store(a, d, lanes[0]);
    hn::Store(b, d, lanes[1]);
    hn::Store(c, d, lanes[2]);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i)
        lanes[0][i] = std::fma(lanes[0][i], lanes[1][i], lanes[2][i]);
    return hn::Load(d, lanes[0]);
#endif
}

/// The side of a cone along rays: at the distance s it is met where a s^2 + b s + c = 0.
struct Side {
    Vector height, climb;
    Triple across, sideways;
    Vector a, b, c;

    HWY_INLINE Side(const ConeForm& cone, const CenteredRays& line) {
        const Triple axis = constant(cone.axis);
        const Vector slope = constant(cone.slope);
        height = dot(line.origin, axis);
        climb = dot(line.direction, axis);
        across = minus(line.origin, times(axis, height));
        sideways = minus(line.direction, times(axis, climb));
        const Vector radius = hn::Add(constant(cone.middleRadius), hn::Mul(slope, height));
        const Vector growth = hn::Mul(slope, climb);
        a = hn::Sub(dot(sideways, sideways), hn::Mul(growth, growth));
        b = hn::Mul(constant(2), hn::Sub(dot(across, sideways), hn::Mul(growth, radius)));
        c = hn::Sub(dot(across, across), hn::Mul(radius, radius));
    }

    /// Where realRoots() solves it in the way of roots() below.
    HWY_INLINE Lanes ordinary() const {
        const Vector largest = hn::Max(hn::Abs(a), hn::Max(hn::Abs(b), hn::Abs(c)));
        return hn::And(hn::Ne(a, constant(0)),
                       hn::And(hn::Gt(largest, constant(1e-60)), hn::Lt(largest, constant(1e60))));
    }

    /// In rising order; NaN where there is none.
    HWY_INLINE void roots(Vector& low, Vector& high) const {
        const Vector half = hn::Mul(b, constant(0.5)), product = hn::Mul(a, c);
        const Vector rest = fused(hn::Neg(a), c, product);
        const Vector discriminant = hn::Add(fused(half, half, hn::Neg(product)), rest);
        const Vector q = hn::Neg(hn::Add(half, hn::CopySign(hn::Sqrt(discriminant), half)));
        const Vector one = hn::Div(q, a), other = hn::Div(c, q);
        // Twice the one where q = 0, which gives no other.
        const Vector second = hn::IfThenElse(hn::Eq(q, constant(0)), one, other);
        const Lanes swapped = hn::Lt(second, one);
        low = hn::IfThenElse(swapped, second, one);
        high = hn::IfThenElse(swapped, one, second);
    }
};

/// One of the two flat ends of a closed cone.
struct Cap {
    Vector t;
    Lanes met;

    HWY_INLINE Cap(const ConeForm& cone, double end, const CenteredRays& line, const Side& side) {
        const double radius = end < 0 ? cone.baseRadius : cone.capRadius;
        const Vector s = hn::Div(hn::Sub(constant(end), side.height), side.climb);
        const Triple arm =
            minus(along(line.origin, s, line.direction), times(constant(cone.axis), constant(end)));
        t = line.toRay(s);
        met = hn::And(hn::Ne(side.climb, constant(0)), hn::Le(dot(arm, arm), constant(radius * radius)));
        if (!(radius > 0)) met = hn::Lt(t, t);
    }
};

/// Whether the side is met at distance s: a cone goes on behind its ends.
HWY_INLINE Lanes onSide(const ConeForm& cone, const Side& side, Vector s) {
    const Vector at = hn::Add(side.height, hn::Mul(s, side.climb));
    return hn::And(hn::Le(hn::Abs(s), constant(2 * farthestDistance)),
                   hn::Le(hn::Abs(at), constant(cone.half)));
}

HWY_INLINE Triple sideNormals(const ConeForm& cone, const Side& side, Vector s, Lanes wanted) {
    const Vector slope = constant(cone.slope);
    const Vector at = hn::Add(side.height, hn::Mul(s, side.climb));
    const Vector radius = hn::Add(constant(cone.middleRadius), hn::Mul(slope, at));
    return unitNormals(
        minus(along(side.across, s, side.sideways), times(constant(cone.axis), hn::Mul(slope, radius))),
        wanted);
}

void meetCone(const ConeForm& cone, const SolidQuestion& question, std::vector<std::uint32_t>& doubtful) {
    Vectors rays(question);
    const Triple axis = constant(cone.axis);
    rays.each([&](const Triple& from, const Triple& towards) {
        const CenteredRays line(from, towards, cone.center);
        const Lanes usable = hn::And(line.usable, rays.present());
        const Side side(cone, line);
        const Lanes certain = hn::And(usable, side.ordinary());
        rays.forEach(hn::AndNot(certain, usable),
                     [&](std::size_t i) { doubtful.push_back(static_cast<std::uint32_t>(i)); });
        Vector low, high;
        side.roots(low, high);
        const auto counts = [&](Vector s) {
            return hn::And(onSide(cone, side, s), rays.counts(line.toRay(s)));
        };
        const Lanes first = counts(low), onEither = hn::Or(first, counts(high));
        const Vector place = hn::IfThenElse(first, low, high);
        Vector t = hn::IfThenElse(onEither, line.toRay(place), constant(infinity));
        Vector end = hn::Zero(Doubles());  // -1 and 1 on the caps
        for (const double sign : {-1.0, 1.0}) {
            if (cone.open) continue;
            const Cap cap(cone, sign * cone.half, line, side);
            const Lanes here = hn::And(hn::And(cap.met, rays.counts(cap.t)), hn::Lt(cap.t, t));
            t = hn::IfThenElse(here, cap.t, t);
            end = hn::IfThenElse(here, constant(sign), end);
        }
        rays.take(t, hn::And(certain, rays.counts(t)), [&](Lanes found) {
            const Lanes onCap = hn::Ne(end, constant(0));
            return choose(onCap, times(axis, end), sideNormals(cone, side, place, hn::AndNot(onCap, found)));
        });
    });
}

void findConeSpans(const ConeForm& cone, const RayBatch& rays, SpanBatch& batch) {
    Spans spans(rays, batch);
    const Triple axis = constant(cone.axis);
    const Vector near = constant(levelDistance * (1 + cone.half));
    spans.each([&](const Triple& from, const Triple& towards) {
        const CenteredRays line(from, towards, cone.center);
        const Side side(cone, line);
        Vector in = constant(infinity), out = constant(-infinity), count = hn::Zero(Doubles());
        Triple inNormal = axis, outNormal = axis;
        const auto add = [&](Vector t, Lanes met, const Triple& normal) {
            const Lanes earlier = hn::And(met, hn::Lt(t, in)), later = hn::And(met, hn::Gt(t, out));
            in = hn::IfThenElse(earlier, t, in);
            out = hn::IfThenElse(later, t, out);
            inNormal = choose(earlier, normal, inNormal);
            outNormal = choose(later, normal, outNormal);
            count = hn::Add(count, bit(met));
        };
        Vector low, high;
        side.roots(low, high);
        for (const Vector& s : {low, high}) {
            const Lanes met = onSide(cone, side, s);
            add(line.toRay(s), met, sideNormals(cone, side, s, met));
        }
        for (const double sign : {-1.0, 1.0}) {
            const Cap cap(cone, sign * cone.half, line, side);
            add(cap.t, cap.met, times(axis, constant(sign)));
        }
        const Lanes met = hn::And(line.usable, hn::Eq(count, constant(2)));
        const Lanes missed = hn::Or(hn::Not(line.usable), hn::Eq(count, constant(0)));
        const Lanes level =
            hn::And(hn::Lt(hn::Abs(side.climb), constant(levelSlope)),
                    hn::Lt(hn::Abs(hn::Sub(hn::Abs(side.height), constant(cone.half))), near));
        const Lanes strange = hn::And(line.usable, hn::Not(side.ordinary()));
        spans.set(met, in, out, hn::Or(hn::Or(level, strange), hn::Not(hn::Or(met, missed))));
        spans.setNormals(inNormal, outNormal);
    });
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(meetPlane);
HWY_EXPORT(meetSphere);
HWY_EXPORT(meetBox);
HWY_EXPORT(meetCone);
HWY_EXPORT(findPlaneSpans);
HWY_EXPORT(findSphereSpans);
HWY_EXPORT(findBoxSpans);
HWY_EXPORT(findConeSpans);

void meetPlane(const glm::dvec3& normal, double distance, double horizon, const SolidQuestion& question) {
    HWY_DYNAMIC_DISPATCH(meetPlane)(normal, distance, horizon, question);
}

void meetSphere(const glm::dvec3& center, double radius, const SolidQuestion& question) {
    HWY_DYNAMIC_DISPATCH(meetSphere)(center, radius, question);
}

void meetBox(const glm::dvec3& low, const glm::dvec3& high, const SolidQuestion& question) {
    HWY_DYNAMIC_DISPATCH(meetBox)(low, high, question);
}

void meetCone(const ConeForm& cone, const SolidQuestion& question, std::vector<std::uint32_t>& doubtful) {
    doubtful.clear();
    HWY_DYNAMIC_DISPATCH(meetCone)(cone, question, doubtful);
}

void findPlaneSpans(const glm::dvec3& normal, double distance, double horizon, const RayBatch& rays,
                    SpanBatch& spans) {
    spans.setSize(rays.size());
    HWY_DYNAMIC_DISPATCH(findPlaneSpans)(normal, distance, horizon, rays, spans);
}

void findSphereSpans(const glm::dvec3& center, double radius, const RayBatch& rays, SpanBatch& spans) {
    spans.setSize(rays.size());
    HWY_DYNAMIC_DISPATCH(findSphereSpans)(center, radius, rays, spans);
}

void findBoxSpans(const glm::dvec3& low, const glm::dvec3& high, const RayBatch& rays, SpanBatch& spans) {
    spans.setSize(rays.size());
    HWY_DYNAMIC_DISPATCH(findBoxSpans)(low, high, rays, spans);
}

void findConeSpans(const ConeForm& cone, const RayBatch& rays, SpanBatch& spans) {
    spans.setSize(rays.size());
    HWY_DYNAMIC_DISPATCH(findConeSpans)(cone, rays, spans);
}

}  // namespace isoscope
#endif
