// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "core/study/gradient/surface_verdict.h"

namespace isoscope {

/// What one statement's max_gradient is worth, for all isosurfaces that it makes: in a loop or macro many.
struct StatementVerdict {
    SourceRange range;                     ///< SceneIsosurface::range
    std::vector<std::size_t> isosurfaces;  ///< their numbers
    double setting = 0;                    ///< the least max_gradient in force
    /// Of the largest gradient of all of them: proven to be met, and proven not to be exceeded.
    double lower = 0, upper = 0;
    /// That of the worst; nothing while one that may be worse is being proven.
    std::optional<GradientVerdict> verdict;
    /// The least max_gradient that is proven to be enough for all; nothing without one.
    std::optional<double> needed;
    bool counted = false;        ///< whether pixels of the view were counted, or need not be
    std::uint64_t mistakes = 0;  ///< pixels of the view that POV-Ray gets wrong
    /// How many times as long as with `needed` POV-Ray takes for the view, for the worst of them.
    std::optional<double> waste;

    /// Whether writing `needed` mends something.
    bool mendable() const;
};

/// In the order of the isosurfaces. `verdicts` are of isosurfaces of `scene`.
std::vector<StatementVerdict> statementVerdicts(const std::vector<SurfaceVerdict>& verdicts,
                                                const Scene& scene);

}  // namespace isoscope
