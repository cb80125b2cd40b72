// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>

#include "core/scene/scene.h"
#include "core/study/gradient/gradient_proof.h"

namespace isoscope {

/// Proofs of max_gradient, made once for a function, its numbers and its container: other views, thresholds,
/// settings and edits elsewhere in the text find what is known already, and so does an undo. For several
/// threads at once.
class GradientProofs {
  public:
    /// How many are remembered; those asked for longest ago go first.
    static constexpr std::size_t capacity = 256;

    /// `settings` are those of every proof.
    explicit GradientProofs(GradientStudySettings settings = {}) : settings_(settings) {}

    /// The one about this isosurface, begun or not; null without such an isosurface.
    std::shared_ptr<GradientProof> proofOf(const Scene& scene, std::size_t isosurface);

    /// How many different proofs were asked for so far.
    std::uint64_t begun() const;

  private:
    GradientStudySettings settings_;
    mutable std::mutex mutex_;
    std::list<std::shared_ptr<GradientProof>> proofs_;  ///< the latest first
    std::uint64_t begun_ = 0;
};

}  // namespace isoscope
