// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/taylor_evaluator.h"
#include "core/roots/certified/march_kernel.h"
#include "core/roots/first_roots.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// Finds the roots in brackets, with their normals, by one evaluation each: by the tangent in the middle, and
/// how far the function can be from it. All roots of a bracket are where tangent and rest can make 0; where
/// that is a small part of the accuracy, the root of the tangent is as good as the first of them.
class TangentPolish {
  public:
    /// How far a root may be from that of the tangent, in parts of the accuracy.
    static constexpr double leftover = 2e-4;
    /// How far the normal may turn between the middle and the root, by the same bounds, in radians.
    static constexpr double turn = 4e-3;

    /// The references must outlive the polish.
    TangentPolish(TaylorEvaluator& tangents, const RootSettings& settings)
        : tangents_(tangents), settings_(settings) {}

    /// Takes from found.brackets what settles, into roots.crossings, and what is narrower than the accuracy
    /// now, into found.crossings. The other brackets stay, and those with a root before `sufficient`. By
    /// `simplifiedTape`, if there is one, which has to hold everywhere.
    void run(MarchKernel::Results& found, double sufficient, const SimplifiedTape* simplifiedTape,
             FirstRoots& roots);

  private:
    TaylorEvaluator& tangents_;
    const RootSettings& settings_;
};

}  // namespace isoscope
