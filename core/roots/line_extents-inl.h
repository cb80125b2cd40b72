// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Measures lines that are at hand in vector registers.
#if defined(ISOSCOPE_ROOTS_LINE_EXTENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_ROOTS_LINE_EXTENTS_INL
#undef ISOSCOPE_ROOTS_LINE_EXTENTS_INL
#else
#define ISOSCOPE_ROOTS_LINE_EXTENTS_INL
#endif

#include <hwy/highway.h>

#include "core/roots/line_columns.h"
#include "core/roots/line_extents.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Finds the extents of lines whose intervals are not empty, vector by vector.
class ExtentMeter {
    using Doubles = hwy::HWY_NAMESPACE::ScalableTag<double>;
    using Vector = hwy::HWY_NAMESPACE::Vec<Doubles>;
    using Mask = hwy::HWY_NAMESPACE::Mask<Doubles>;

  public:
    /// Of lines from number `first` on.
    HWY_INLINE ExtentMeter(const LineColumns& lines, std::size_t first) : lines_(lines), first_(first) {
        namespace hn = hwy::HWY_NAMESPACE;
        const Vector infinite = hn::Set(Doubles(), LineExtents::infinity);
        for (std::size_t c = 0; c < 4; ++c) low_[c] = infinite, high_[c] = hn::Neg(infinite);
        // All rays of a camera begin in one place.
        for (std::size_t c = 0; c < 3; ++c) place_[c] = hn::Set(Doubles(), lines.origin[c][first]);
        elsewhere_ = hn::Lt(infinite, infinite);
    }

    /// The lines from number `i` on, `present` of them, with these intervals.
    HWY_INLINE void add(std::size_t i, Vector near, Vector far, Mask present) {
        namespace hn = hwy::HWY_NAMESPACE;
        const Doubles d;
        const Mask wanted = hn::And(present, hn::Lt(near, far));
        const bool all = hn::AllTrue(d, wanted);
        if (!all && hn::AllFalse(d, wanted)) return;
        const Vector infinite = hn::Set(d, LineExtents::infinity), endless = hn::Neg(infinite);
        const auto take = [&](std::size_t c, Vector least, Vector most) HWY_ATTR {
            low_[c] = hn::Min(low_[c], all ? least : hn::IfThenElse(wanted, least, infinite));
            high_[c] = hn::Max(high_[c], all ? most : hn::IfThenElse(wanted, most, endless));
        };
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector direction = hn::LoadU(d, lines_.direction[c] + i);
            take(c, direction, direction);
            const Mask same = hn::Eq(hn::LoadU(d, lines_.origin[c] + i), place_[c]);
            elsewhere_ = hn::Or(elsewhere_, hn::AndNot(same, wanted));
        }
        take(3, near, far);
    }

    /// Of the `count` lines; their intervals are in the columns by now.
    HWY_INLINE void finish(std::size_t count, LineExtents& extents) const {
        namespace hn = hwy::HWY_NAMESPACE;
        // Directions, their negatives, near, -far.
        const Vector least[8] = {low_[0],           low_[1],           low_[2], hn::Neg(high_[0]),
                                 hn::Neg(high_[1]), hn::Neg(high_[2]), low_[3], hn::Neg(high_[3])};
        double found[8];
        leastOf(least, found);
        extents.lowDirection = {found[0], found[1], found[2]};
        extents.highDirection = {-found[3], -found[4], -found[5]};
        extents.near = found[6], extents.far = -found[7];
        if (!(extents.near < extents.far)) {
            extents = {};
            return;
        }
        if (hn::AllFalse(Doubles(), elsewhere_)) {
            const glm::dvec3 place(lines_.origin[0][first_], lines_.origin[1][first_],
                                   lines_.origin[2][first_]);
            extents.lowOrigin = extents.highOrigin = place;
            return;
        }
        measureOrigins(count, extents);
    }

  private:
    /// The smallest lanes of eight vectors, all of them together: one by one their lanes would be waited for.
    static HWY_INLINE void leastOf(const Vector (&columns)[8], double (&least)[8]) {
        namespace hn = hwy::HWY_NAMESPACE;
        [[maybe_unused]] const Doubles d;
#if HWY_TARGET == HWY_SCALAR
        for (std::size_t c = 0; c < 8; ++c) least[c] = hn::GetLane(columns[c]);
#else
        HWY_ALIGN double pairs[hn::MaxLanes(d)];
        for (std::size_t c = 0; c < 8; c += 2) {
            const Vector lower = hn::InterleaveLower(d, columns[c], columns[c + 1]);
            const Vector upper = hn::InterleaveUpper(d, columns[c], columns[c + 1]);
            hn::Store(hn::Min(lower, upper), d, pairs);
            least[c] = pairs[0], least[c + 1] = pairs[1];
            for (std::size_t k = 2; k < hn::Lanes(d); k += 2) {
                least[c] = pairs[k] < least[c] ? pairs[k] : least[c];
                least[c + 1] = pairs[k + 1] < least[c + 1] ? pairs[k + 1] : least[c + 1];
            }
        }
#endif
    }

    void measureOrigins(std::size_t count, LineExtents& extents) const {
        namespace hn = hwy::HWY_NAMESPACE;
        const Doubles d;
        const Vector infinite = hn::Set(d, LineExtents::infinity);
        Vector least[8];
        for (Vector& column : least) column = infinite;
        for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
            const std::size_t i = first_ + k;
            const Vector near = hn::LoadU(d, lines_.near + i), far = hn::LoadU(d, lines_.far + i);
            const Mask wanted = hn::And(hn::FirstN(d, count - k), hn::Lt(near, far));
            for (std::size_t c = 0; c < 3; ++c) {
                const Vector origin = hn::LoadU(d, lines_.origin[c] + i);
                least[c] = hn::Min(least[c], hn::IfThenElse(wanted, origin, infinite));
                least[3 + c] = hn::Min(least[3 + c], hn::IfThenElse(wanted, hn::Neg(origin), infinite));
            }
        }
        double found[8];
        leastOf(least, found);
        extents.lowOrigin = {found[0], found[1], found[2]};
        extents.highOrigin = {-found[3], -found[4], -found[5]};
    }

    const LineColumns& lines_;
    std::size_t first_;
    Vector low_[4], high_[4];  ///< of the directions, and of near and far
    Vector place_[3];
    Mask elsewhere_;
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
