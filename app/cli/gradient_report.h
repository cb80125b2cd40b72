// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/study/gradient/gradient_bracket.h"

namespace isoscope::cli {

/// What `gradient` says about one isosurface or row.
struct StudiedGradient {
    GradientBracket bracket;
    double sampled = 0;
    double seconds = 0;             ///< on the clock
    std::optional<double> setting;  ///< max_gradient in force, for isosurfaces
    std::string place;              ///< of an isosurface: file:line
    std::string verdict;
    std::string problem;  ///< why nothing was studied; empty when it was
};

/// Writes the answers to standard output: CSV line by line, or one JSON array at the end.
class GradientReport {
  public:
    virtual ~GradientReport() = default;
    /// Reports the next isosurface or row; one with a problem has no numbers.
    virtual void add(const StudiedGradient& studied) = 0;
    /// No more follow.
    virtual void finish() = 0;

    /// Prints the header at once; a row that has a problem gets nan.
    /// `withPlaces` adds the columns place and max_gradient.
    static std::unique_ptr<GradientReport> csv(bool withPlaces = false);
    /// Numbers that are not finite are null: `state` and `singularity` say what is the matter.
    static std::unique_ptr<GradientReport> json();
};

}  // namespace isoscope::cli
