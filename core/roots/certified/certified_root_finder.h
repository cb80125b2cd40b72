// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/roots/certified/bundle_march.h"
#include "core/roots/certified/sheet_roots.h"
#include "core/roots/cells/cell_march.h"
#include "core/roots/certified/general_search.h"
#include "core/roots/certified/newton_polish.h"
#include "core/roots/certified/march_kernel.h"
#include "core/roots/certified/root_polish.h"
#include "core/roots/certified/general_search_lanes.h"
#include "core/roots/cells/slab_search.h"
#include "core/roots/certified/tangent_polish.h"
#include "core/roots/column_table.h"
#include "core/roots/first_roots.h"
#include "core/roots/line_root_finder.h"
#include "core/roots/lipschitz/lipschitz_root_finder.h"

namespace isoscope {

class GlobalSimplification;
class PreparedFunction;

/// Finds isosurfaces without a bound on the gradient and without holes. Bundles of neighbouring lines pass
/// empty space together, functions with many choices in cells; what is left of each line is marched with
/// affine forms, 64 lines at a time. GeneralSearch takes the lines that none of these settles. Of first
/// roots, lines of which too little can be proven (SearchAllowance) are POV-Ray's, by max_gradient, with the
/// verdict budgetExceeded; so are all roots and normals of functions that look up what has no bounds for
/// parts of space, with the verdict notCertified. Else max_gradient and `evaluate` are not used;
/// RootRequest::missMemory has no effect. Crossings are polished by point evaluations far below the accuracy.
///
/// The same list of lines gets the same answers to the last bit. Neighbours of a line in lists of 16 and more
/// can move its roots by what the polish leaves open, and decide whether a jump is met as a gap: they pass
/// empty space together (BundleMarch, CellMarch, SlabSearch).
///
/// Walls: closed containers (not `open`) show the wall where the line enters inside the solid, unless the
/// line starts in the container, and the wall where it leaves inside the solid.
class CertifiedRootFinder : public LineRootFinder {
  public:
    /// `settings` are made usable() first.
    CertifiedRootFinder(std::shared_ptr<const PreparedFunction> function, const RootSettings& settings,
                        std::uint32_t budget = GeneralSearch::defaultBudget);
    /// The function is prepared for this finder alone.
    CertifiedRootFinder(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                        const RootSettings& settings, std::uint32_t budget = GeneralSearch::defaultBudget);
    // The searches refer to the evaluators.
    CertifiedRootFinder(const CertifiedRootFinder&) = delete;
    CertifiedRootFinder& operator=(const CertifiedRootFinder&) = delete;

    void find(std::span<const LineQuery> queries, const RootRequest& request,
              std::span<RootList> roots) override;
    /// Answers as find() would, for many lines side by side (MarchKernel). Normals at jumps are POV-Ray's
    /// (povrayNormals), not those of normals().
    void findFirst(const LineColumns& lines, const RootRequest& request, FirstRoots& roots) override;
    /// Gradients by forward-mode differentiation; where they vanish, central differences over the accuracy.
    void normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) override;
    double value(const glm::dvec3& point) override { return points_.evaluate(point.x, point.y, point.z); }
    RootFinderReport report() const override;
    void restart() override {
        sheets_.restart();
        march_.restart();
        paidCells_ = vainCells_ = 0;
    }
    std::span<const Verdict> verdicts() const override { return verdicts_; }

    /// From now on find() tells poles among the roots of lists of less than 16 lines, where the sign changes
    /// through infinity; they are no surface. Only before the first search: enclosures are then of the
    /// function itself, not of one with the same sign.
    void listPoles() {
        keepValues();
        lanes_.listPoles();
    }
    /// From now on find() tells `recorder`, which must live as long, how it searches lists of less than 16
    /// lines. Only before the first search, as listPoles().
    void recordInto(ProofRecorder& recorder) {
        keepValues();
        lanes_.recordInto(&recorder);
    }

  private:
    /// What is known of the function where a line leaves its interval.
    enum class EndSign : std::uint8_t { unknown, inside, outside };

    void keepValues() {
        forms_.keepValues();
        keepsValues_ = true;
    }
    void prepare(std::span<const LineQuery> queries);
    void finish(std::span<const LineQuery> queries, const RootRequest& request, std::span<RootList> roots);
    /// First roots of so many lines make a picture: what can hardly be proven is left to POV-Ray's method.
    static bool isPicture(std::size_t lines, const RootRequest& request);
    /// To find that out costs as much as the search of a few lines.
    bool cellsMayPay() const { return paidCells_ > 0 || vainCells_ == 0; }
    bool findByCells(const LineColumns& lines, const RootRequest& request, FirstRoots& roots);
    void findPlain(const LineColumns& lines, const RootRequest& request, FirstRoots& roots);
    void noteWalls(const LineColumns& lines);
    void findRest(const LineColumns& lines, std::span<const MarchKernel::Line> searched,
                  std::span<const NewtonPolish::Unsettled> unsettled, const RootRequest& request,
                  FirstRoots& roots);
    void takeRest(double sufficient, FirstRoots& roots);
    void setJumpNormals(const LineColumns& lines, FirstRoots& roots);

    void addEntryWalls(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                       const RootRequest& request, std::span<RootList> roots,
                       const SimplifiedTape* tape = nullptr);
    void addExitWalls(std::span<const LineQuery> queries, const RootRequest& request,
                      std::span<RootList> roots);
    void findUncertain(std::span<const LineQuery> queries, const RootRequest& request,
                       std::span<RootList> roots);
    void search(std::span<const LineQuery> queries, const RootRequest& request, std::span<RootList> roots);
    void searchSlabs(std::span<const LineQuery> queries, std::size_t batch, const RootRequest& request,
                     std::span<RootList> roots);
    void marchBundles(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                      const RootRequest& request);
    void searchWhole(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                     const RootRequest& request, std::span<RootList> roots);
    void searchLines(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                     const RootRequest& request, std::span<RootList> roots);
    SearchAllowance allowanceOf(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                                const RootRequest& request);
    LipschitzRootFinder& povray();
    std::uint64_t priceByPovray(std::span<const LineQuery> queries, const RootRequest& request);
    void searchByPovray(std::span<const LineQuery> queries, const RootRequest& request,
                        std::span<RootList> roots);
    void retire(std::size_t line, const GeneralSearch& search, double endSign, std::span<RootList> roots);
    void miss(std::size_t line, double sign);
    void noteEnd(std::size_t line, double sign);
    void setGradients(std::span<const glm::dvec3> points);
    void setDifferences(std::span<const glm::dvec3> points, std::span<const std::size_t> which,
                        double outward, std::span<glm::dvec3> out);

    RootSettings settings_;
    std::shared_ptr<const PreparedFunction> function_;
    std::shared_ptr<const GlobalSimplification> global_;
    AffineEvaluator forms_;
    PointEvaluator points_;
    GradientEvaluator gradients_;
    std::uint64_t searches_ = 0;
    std::uint64_t exhausted_ = 0;
    std::vector<Verdict> verdicts_;
    std::vector<EndSign> ends_;
    std::vector<std::uint8_t> wanted_;  ///< lines that can have roots and are not settled by their entry wall
    BundleMarch bundles_;
    CertainStarts starts_;  ///< of each line
    ColumnTable<3> jumps_;  ///< places and lines of the roots that are jumps
    std::vector<RoughRoot> pending_;
    RootPolish polish_;
    std::vector<std::size_t> asked_;
    bool keepsValues_ = false;           ///< lists of a few lines are by the function itself
    bool isPicture_ = false;             ///< the list at hand
    std::vector<std::size_t> unproven_;  ///< lines that are left to POV-Ray's method
    std::uint64_t povrayValues_ = 0;
    std::unique_ptr<LipschitzRootFinder> povray_;     ///< made when it is needed
    std::array<ValueAndGradient, batchLanes> found_;  ///< at the points of a batch
    std::vector<std::size_t> flat_;                   ///< points without a gradient
    GeneralSearchLanes lanes_;
    LazyUnionParts parts_;
    PartTapes partTapes_;
    SlabSearch slabs_;

    MarchKernel march_;
    NewtonPolish newton_;
    std::optional<TaylorEvaluator> tangents_;  ///< where an enclosure costs so much that they pay
    CellMarch cells_;
    std::size_t paidCells_ = 0, vainCells_ = 0;  ///< batches of lines since the restart
    SheetRoots sheets_;
    std::vector<MarchedBundle> marched_;
    /// Lines that are left to the general search, those that are to be polished only behind the others.
    struct Rest {
        std::vector<std::size_t> lines;
        std::vector<LineQuery> queries;
        std::vector<RootList> roots;
    } rest_;
    std::vector<Verdict> firstVerdicts_;
};

}  // namespace isoscope
