// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/shape/shape_measures.h"

namespace isoscope {

namespace {

using Excerpt = IntervalGradientEvaluator::Excerpt;

/// A block of cells of a grid.
struct Block {
    glm::ivec3 low{0}, high{0};                   ///< points; the block is between them
    std::shared_ptr<const Excerpt> excerpt = {};  ///< what matters of the function there; null for all

    std::uint64_t cells() const {
        const glm::ivec3 size = high - low;
        return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) *
               static_cast<std::uint64_t>(size.z);
    }
};

/// The least product of two numbers of the range, rounded downwards.
double leastProduct(const SlopeRange& a) {
    if (a.low > 0 || a.high < 0) return lowered(a.gap() * a.gap());
    return lowered(a.low * a.high);
}

class Check {
  public:
    Check(const Isosurface& surface, std::span<const double> parameters, const SolidGrid& grid)
        : surface_(surface),
          grid_(grid),
          domain_(surface.settings().container),
          intervals_(*surface.prepared(parameters)) {
        const glm::dvec3 extent = grid.high() - grid.low();
        for (int k = 0; k < 3; ++k) cell_[k] = extent[k] / grid.cells()[k];
    }

    CellCheck run(const std::stop_token& stop) {
        CellCheck check;
        std::vector<Block> blocks{{glm::ivec3(0), grid_.cells()}};
        check.cells = blocks.front().cells();
        while (!blocks.empty()) {
            const Block block = blocks.back();
            blocks.pop_back();
            if (stop.stop_requested()) {
                check.open += block.cells();
                continue;
            }
            if (keeps(block)) continue;
            if (block.cells() == 1)
                ++check.open;
            else
                halve(block, intervals_.excerpt(block.excerpt), blocks);
        }
        return check;
    }

  private:
    bool keeps(const Block& block) {
        const GradientBox box{grid_.place(block.low), grid_.place(block.high)};
        if (domain_.misses(box)) return true;
        const IntervalGradient& all = intervals_.evaluate(box.intervals(), block.excerpt);
        if (LoopStop::requested()) return false;
        if (all.value.empty()) return true;
        const double threshold = surface_.settings().threshold;
        if (all.value.low > threshold || all.value.high < threshold) return true;
        if (!all.bounded() || all.value.maybeUndefined || all.wrap != 0) return false;
        // With cells for units of length.
        double product = 0;
        for (int k = 0; k < 3; ++k)
            product = lowered(product + lowered(cell_[k] * cell_[k] *
                                                leastProduct(all.slope[static_cast<std::size_t>(k)])));
        return product > 0;
    }

    static void halve(const Block& block, std::shared_ptr<const Excerpt> excerpt,
                      std::vector<Block>& blocks) {
        const glm::ivec3 size = block.high - block.low;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (size[k] > size[axis]) axis = k;
        Block first = block, second = block;
        first.excerpt = second.excerpt = std::move(excerpt);
        first.high[axis] = second.low[axis] = block.low[axis] + size[axis] / 2;
        blocks.push_back(first);
        blocks.push_back(second);
    }

    const Isosurface& surface_;
    const SolidGrid& grid_;
    GradientDomain domain_;
    IntervalGradientEvaluator intervals_;
    glm::dvec3 cell_{0};
};

}  // namespace

CellCheck checkCells(const Isosurface& surface, std::span<const double> parameters, const SolidGrid& grid,
                     std::stop_token stop) {
    if (!grid.known()) return {};
    const LoopStop loops(stop);
    return Check(surface, parameters, grid).run(stop);
}

}  // namespace isoscope
