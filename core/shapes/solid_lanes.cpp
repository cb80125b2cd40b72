// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solid_lanes.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/solid_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shapes/centered_ray.h"
#include "core/shapes/unit_normal-inl.h"

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
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(Doubles(), which, bits);
        for (unsigned rest = bits[0], lane = 0; rest != 0; rest >>= 1, ++lane)
            if ((rest & 1u) != 0) visit(first_ + lane);
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

void meetSphere(const glm::dvec3& center, double radius, const SolidQuestion& question) {
    Vectors rays(question);
    const Triple middleOfAll = constant(center);
    const Vector squaredRadius = constant(radius * radius);
    rays.each([&](const Triple& origin, const Triple& direction) {
        const Vector squaredSpeed = dot(direction, direction);
        const Triple arm = minus(origin, middleOfAll);
        const Vector middle = hn::Div(hn::Neg(dot(arm, direction)), squaredSpeed);
        const Triple across = along(arm, middle, direction);
        const Vector squaredChord = hn::Div(hn::Sub(squaredRadius, dot(across, across)), squaredSpeed);
        const Vector half = hn::Sqrt(squaredChord);
        const Lanes cut =
            hn::And(hn::And(hn::Gt(squaredSpeed, constant(0)), hn::Gt(squaredChord, constant(0))),
                    hn::And(finite(middle), finite(half)));
        const Vector in = hn::Sub(middle, half), out = hn::Add(middle, half);
        const Lanes entering = hn::Ge(in, rays.nearest());
        const Vector t = hn::IfThenElse(entering, in, out);
        rays.take(t, hn::And(cut, rays.counts(t)), [&](Lanes found) {
            const Triple way = times(direction, half);
            return unitNormals(choose(entering, minus(across, way), plus(across, way)), found);
        });
    });
}

/// Where a ray enters or leaves a box, and by which face.
struct Passage {
    Vector t;
    Triple normal;
};

void meetBox(const glm::dvec3& low, const glm::dvec3& high, const SolidQuestion& question) {
    Vectors rays(question);
    const Triple lowest = constant(low), highest = constant(high);
    const Vector zero = constant(0), one = constant(1);
    const bool wantsNormals = question.normals;
    rays.each([&](const Triple& origin, const Triple& direction) {
        const Doubles d;
        const Triple nowhere{zero, zero, zero};
        Passage in{constant(-infinity), nowhere}, out{constant(infinity), nowhere};
        Lanes passes = rays.present();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vector from = origin[axis], slope = direction[axis];
            const Lanes forwards = hn::Gt(slope, zero), level = hn::Eq(slope, zero);
            passes = hn::And(passes, hn::And(finite(from), finite(slope)));
            const Lanes beside = hn::Or(hn::Lt(from, lowest[axis]), hn::Gt(from, highest[axis]));
            passes = hn::AndNot(hn::And(level, beside), passes);
            const auto meet = [&](Vector wall) { return hn::Div(hn::Sub(wall, from), slope); };
            const Vector first = meet(hn::IfThenElse(forwards, lowest[axis], highest[axis]));
            const Vector last = meet(hn::IfThenElse(forwards, highest[axis], lowest[axis]));
            const Lanes later = hn::AndNot(level, hn::Gt(first, in.t));
            const Lanes earlier = hn::AndNot(level, hn::Lt(last, out.t));
            in.t = hn::IfThenElse(later, first, in.t);
            out.t = hn::IfThenElse(earlier, last, out.t);
            if (!wantsNormals) continue;
            const Vector side = hn::IfThenElse(forwards, one, hn::Neg(one));
            const Triple face{axis == 0 ? side : zero, axis == 1 ? side : zero, axis == 2 ? side : zero};
            in.normal = choose(later, minus(nowhere, face), in.normal);
            out.normal = choose(earlier, face, out.normal);
        }
        passes = hn::And(passes, hn::And(hn::And(finite(in.t), finite(out.t)), hn::Le(in.t, out.t)));
        if (hn::AllFalse(d, passes)) return;
        const Lanes entering = rays.counts(in.t);
        const Vector t = hn::IfThenElse(entering, in.t, out.t);
        rays.take(t, hn::And(passes, rays.counts(t)),
                  [&](Lanes) { return choose(entering, in.normal, out.normal); });
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

void meetCone(const ConeForm& cone, const SolidQuestion& question, std::vector<std::uint32_t>& doubtful) {
    Vectors rays(question);
    const Triple axis = constant(cone.axis);
    const Vector limit = constant(2 * farthestDistance), half = constant(cone.half);
    rays.each([&](const Triple& from, const Triple& towards) {
        const Doubles d;
        const CenteredRays line(from, towards, cone.center);
        const Lanes usable = hn::And(line.usable, rays.present());
        const Side side(cone, line);
        const Lanes certain = hn::And(usable, side.ordinary());
        rays.forEach(hn::AndNot(certain, usable),
                     [&](std::size_t i) { doubtful.push_back(static_cast<std::uint32_t>(i)); });
        Vector low, high;
        side.roots(low, high);
        const auto onSide = [&](Vector s) {
            const Vector at = hn::Add(side.height, hn::Mul(s, side.climb));
            return hn::And(hn::And(hn::Le(hn::Abs(s), limit), hn::Le(hn::Abs(at), half)),
                           rays.counts(line.toRay(s)));
        };
        const Lanes first = onSide(low);
        const Vector place = hn::IfThenElse(first, low, high);
        const Lanes sideMet = hn::Or(first, onSide(high));
        Vector t = hn::IfThenElse(sideMet, line.toRay(place), constant(infinity));
        Lanes met = sideMet, capMet = hn::Lt(axis.x, axis.x);
        Vector capSide = hn::Zero(d);
        for (const double end : {-cone.half, cone.half}) {
            const double radius = end < 0 ? cone.baseRadius : cone.capRadius;
            if (cone.open || !(radius > 0)) continue;
            const Vector s = hn::Div(hn::Sub(constant(end), side.height), side.climb);
            const Vector capT = line.toRay(s);
            const Triple arm = minus(along(line.origin, s, line.direction), times(axis, constant(end)));
            const Lanes here = hn::And(
                hn::And(hn::Ne(side.climb, constant(0)), hn::Le(dot(arm, arm), constant(radius * radius))),
                hn::And(rays.counts(capT), hn::Lt(capT, t)));
            t = hn::IfThenElse(here, capT, t);
            capSide = hn::IfThenElse(here, constant(end < 0 ? -1 : 1), capSide);
            capMet = hn::Or(capMet, here);
            met = hn::Or(met, here);
        }
        rays.take(t, hn::And(met, certain), [&](Lanes found) {
            const Vector at = hn::Add(side.height, hn::Mul(place, side.climb));
            const Vector radius = hn::Add(constant(cone.middleRadius), hn::Mul(constant(cone.slope), at));
            const Triple outwards = minus(along(side.across, place, side.sideways),
                                          times(axis, hn::Mul(constant(cone.slope), radius)));
            return choose(capMet, times(axis, capSide), unitNormals(outwards, hn::AndNot(capMet, found)));
        });
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

}  // namespace isoscope
#endif
