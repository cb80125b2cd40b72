// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/roots/certified/march_lanes.h"

namespace isoscope {

/// Steps of the march along functions that jump. A piece that is undecided because it may hold a jump is
/// enclosed once more for each side of it (CaseLanes), on the part of the piece where that side may be; a
/// part that remains undecided, by the next jump, and so on. Where all parts are on one side of the
/// threshold, there is no root; else the piece is free up to the first part that is not, and where the parts
/// before it and behind it are on opposite sides, and meet within 1/64 of the resolution, the function jumps
/// through the threshold there (MarchEvent::jump). Parts shorter than 32 units of t, the grain of
/// GeneralSearch, are not enclosed: where two jumps are at one place, as the steps of a brick and of its row
/// are, they hold what neither side has. Where they are, no sign is known. Where the parts tell nothing, the
/// piece ends where the first jump may be, so that a jump costs a few steps and no bisection.
class CaseMarch {
  public:
    /// Enclosures by cases of one piece; of the shortest pieces, which cannot be cut, it may have more.
    static constexpr std::size_t mostParts = 16, mostPartsAtLast = 64;
    /// Sides that a part may be told.
    static constexpr std::size_t mostSides = 8;

    /// Begins another list of lines: whether cases pay is found out anew.
    void reset() { tried_ = decided_ = 0; }

    /// As isoscope::march(), given `forms` to enclose the function by.
    bool step(AffineEvaluator& forms, RayPieces& pieces, MarchLanes& lanes, const SignRule& rule,
              std::size_t count, MarchEvent* events);

    /// The forms of the last step, and, lane by lane, whether a form is none of the function's but stands for
    /// the sign that the cases tell: valid until the next step.
    AffineLanes forms() const { return {forms_[0].data(), forms_[1].data(), forms_[2].data()}; }
    std::array<std::uint8_t, batchLanes> byCases() const;

  private:
    /// A lane whose piece is undecided, and where its first jump may be.
    struct Undecided {
        std::size_t lane;
        double start, length;
        double first, last;
        std::size_t partsLeft;
        int sign;             ///< of the function at the start; 0 where that is not certain
        double limit;         ///< parts that begin beyond tell nothing
        int partSign = 0;     ///< of the parts so far
        bool differ = false;  ///< whether one of them has another sign, or is undecided
        bool vain = false;    ///< whether one that begins where the piece does is undecided
        // What the parts tell.
        double free = 0;       ///< up to here the sign is `sign`
        double behind = 0;     ///< from here on it is the other one, or is not known
        bool crosses = false;  ///< whether it is the other one
    };

    /// A part of an undecided piece, and the sides that it is on.
    struct Part {
        std::size_t owner;  ///< entry of undecided_
        double start, length;
        std::size_t sideCount = 0;
        std::array<std::pair<std::uint32_t, double>, mostSides> sides;
    };

    /// A part that is not divided any further, and the sign of the function all along; 0 if undecided.
    struct Leaf {
        std::size_t owner;
        double start, end;
        int sign;
        bool isShort = false;  ///< shorter than the grain: the sign is not known
    };

    void collect(const RayPieces& pieces, const MarchLanes& lanes, const SignRule& rule, std::size_t count);
    void tryCases(AffineEvaluator& forms, const RayPieces& pieces, const MarchLanes& lanes,
                  const SignRule& rule);
    void runParts(AffineEvaluator& forms, std::span<const Part> parts, const RayPieces& pieces,
                  const MarchLanes& lanes, const SignRule& rule);
    void divide(const Part& part, std::size_t lane);
    void addLeaf(const Part& part, int sign, double reach);
    void addShort(const Part& part);
    void join();
    static void join(Undecided& at, std::span<const Leaf> leaves);
    static bool helps(const Undecided& at, double resolution);
    static MarchEvent proceed(const Undecided& at, RayPieces& pieces, MarchLanes& lanes);
    static void shorten(const Undecided& at, RayPieces& pieces, MarchLanes& lanes);

    /// Where many parts decide few pieces, none but the shortest are divided any more.
    bool pays() const { return tried_ < 1024 || 12 * decided_ > tried_; }

    std::array<MarchLanes::Lanes, 3> forms_;
    CaseLanes cases_;
    std::vector<Undecided> undecided_;
    std::vector<Part> parts_, dividedParts_;
    std::vector<Leaf> leaves_;
    RayPieces partPieces_;
    std::uint64_t tried_ = 0;    ///< parts of this list
    std::uint64_t decided_ = 0;  ///< pieces of this list that parts told something of
};

}  // namespace isoscope
