// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/tape/tape_cost.h"
#include "core/roots/certified/bundle_lanes.h"
#include "core/roots/certified/certain_starts.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/certified/march_lanes.h"
#include "core/roots/line_query.h"

namespace isoscope {

/// How far a bundle of lines was followed: from its beginning to `start` the function is positive for
/// certain, and the bundle goes on.
struct MarchedBundle {
    LineBundle bundle;
    std::size_t first = 0, count = 0;  ///< its lines
    CertainStart start;
};

/// Marches along bundles of lines at once, with enclosures that hold for every line of a bundle: what lies
/// clear of the surface is passed at a sixteenth of the price, and for costly functions a good deal of the
/// rest at a fourth. Worth its while for lines whose neighbours in the list are neighbours in space, correct
/// for all.
class BundleMarch {
  public:
    static constexpr std::size_t bundleLines = 16;

    /// How values become signs, and how far a bundle is followed.
    struct Rules {
        SignRule sign;
        /// A march ends once the function is negative for certain: how far it stays so is not needed.
        bool insideEnds = false;
    };

    /// A march for functions of this cost.
    explicit BundleMarch(const TapeCost& cost) : cost_(cost) {}

    /// starts[offset + i] is set for queries[i] where wanted[i]; near must not be negative.
    void run(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted, const Rules& rules,
             AffineEvaluator& forms, CertainStarts& starts, std::size_t offset = 0);
    /// starts[i] is set for lines[i] where its interval is not empty; nothing must be known of them before.
    /// With `marched`, tells it the bundles that come to where the function may become negative.
    void run(const LineColumns& lines, const Rules& rules, AffineEvaluator& forms, CertainStarts& starts,
             std::vector<MarchedBundle>* marched = nullptr);
    /// After run(): goes on along narrower bundles of cheap functions, where no line has come to its end yet.
    void refine(const LineColumns& lines, AffineEvaluator& forms, CertainStarts& starts,
                std::vector<MarchedBundle>* marched);

  private:
    /// How bundles are followed.
    struct Level {
        std::size_t lines;    ///< of a bundle
        double budget;        ///< more enclosures are better spent on its lines
        double shortestPart;  ///< pieces are no shorter than this part of its length
    };

    /// `source` tells which lines are worth a bundle, and makes the bundles.
    template <class Source>
    void runWide(const Source& source, AffineEvaluator& forms, CertainStarts& starts);
    template <class Source>
    void runNarrow(const Source& source, AffineEvaluator& forms, CertainStarts& starts);
    template <class Source>
    void runLevel(const Level& level, const Source& source, AffineEvaluator& forms, CertainStarts& starts);
    void admit(const Level& level, std::size_t bundle, const CertainStart& known);
    void runBatch(AffineEvaluator& forms);
    void noteErrors(const AffineLanes& found);
    void settle(std::size_t lane, MarchEvent event);
    void move(std::size_t from, std::size_t to);

    void noteMarched(std::size_t bundles);

    TapeCost cost_;
    Rules rules_;
    RayPieces pieces_;
    RaySpread spread_;
    MarchLanes lanes_{};
    // Of the bundles at hand; bundleOf_ tells which of them is in a lane.
    BundleLanes bundles_;
    std::array<LineRange, batchLanes> lines_;
    std::array<CertainStart, batchLanes> results_;
    std::array<std::size_t, batchLanes> bundleOf_{};
    std::size_t active_ = 0;
    double usualError_ = 0;  ///< of the forms of the last step
    std::vector<MarchedBundle>* marched_ = nullptr;
};

}  // namespace isoscope
