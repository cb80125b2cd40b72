// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/slope_evaluator.h"
#include "core/roots/certified/bundle_march.h"
#include "core/roots/certified/certain_starts.h"
#include "core/roots/column_table.h"
#include "core/roots/first_roots.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// A stretch where the function is certain to fall from positive to negative along every line of a bundle,
/// without turning: each of them has one root there.
struct MonotoneStretch {
    std::size_t first = 0, count = 0;  ///< lines
    double low = 0, high = -1;
    double least = 0;      ///< how steep it falls at least, by t
    double rounding = 0;   ///< of its computed values
    double tolerance = 0;  ///< by t
    glm::dvec3 origin{0}, direction{0};
    // The plane that touches the surface where the middle of the bundle meets it: gradient * x = offset.
    glm::dvec3 gradient{0};
    double offset = 0;
    // How the gradient changes with t on the middle line, and the product of that with the point of touch.
    glm::dvec3 slopeChange{0};
    double slopeChangeOffset = 0;

    /// Rows in a group, where stretches begin with whole vectors.
    std::size_t room() const { return (count + 7) / 8 * 8; }
    /// Sets origin and direction to those of a line in the middle of its lines.
    void aimAtMiddle(const LineColumns& lines);
};

/// Finds the first roots of bundles of lines that meet the surface in one sheet. A single enclosure of the
/// function and its slope shows that, for all lines of a bundle together; then each line has but to take
/// steps of Newton's, from planes that touch the surface in the middle of the bundle's parts. A root counts
/// when the function's value, as exact as it is known to be, and its least slope show that it is within the
/// accuracy, and its last step is as NewtonPolish asks for.
class SheetRoots {
  public:
    /// `function` is what the evaluators evaluate. The references must outlive it.
    SheetRoots(const std::shared_ptr<const PreparedFunction>& function, PointEvaluator& points,
               GradientEvaluator& gradients, const RootSettings& settings);

    /// Whether there is anything to be expected for this function.
    bool possible() const { return slopes_.has_value(); }

    /// Puts what it finds into roots.crossings, and notes in `starts` that nothing else is to be found on
    /// those lines. Others are left as they are. False where it finds nothing.
    bool run(const LineColumns& lines, std::span<const MarchedBundle> bundles, double sufficient,
             CertainStarts& starts, FirstRoots& roots);

    /// Whether it pays is found out anew.
    void restart() { tried_ = enclosed_ = 0; }

    /// Enclosures so far.
    std::uint64_t evaluations() const { return slopes_ ? slopes_->evaluations() : 0; }

    /// The columns of the lines at hand; `open` is 1 for those that are still to be settled.
    enum Column : std::size_t { t, x, y, z, slope, open, columnCount };
    /// Where the columns lie: the coordinates where the gradients are evaluated.
    using Group = std::array<double*, columnCount>;

  private:
    /// Pieces of this many lengths are tried for each bundle.
    static constexpr std::size_t lengths = 2;

    bool pays() const;
    void findSlabs(std::span<const MarchedBundle> bundles);
    void tryPiece(const MarchedBundle& bundle, std::size_t lane, const SlopeLanes& found);
    void touch(std::span<MonotoneStretch> stretches);
    bool divide(const LineColumns& lines);
    void touchParts(std::span<MonotoneStretch> parts);
    void settle(const LineColumns& lines, std::span<const MonotoneStretch> stretches, double sufficient,
                CertainStarts& starts, FirstRoots& roots);

    std::optional<SlopeEvaluator> slopes_;
    PointEvaluator& points_;
    GradientEvaluator& gradients_;
    const RootSettings& settings_;
    RayPieces pieces_;
    RaySpread spread_;
    std::vector<MonotoneStretch> stretches_, parts_;
    std::size_t tried_ = 0, enclosed_ = 0;  ///< bundles since the restart
    ColumnTable<columnCount> columns_;
    Group group_{};
    std::array<double, batchLanes> values_{};
};

}  // namespace isoscope
