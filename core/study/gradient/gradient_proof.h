// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "core/study/gradient/gradient_study.h"

namespace isoscope {

/// A GradientStudy that several threads may push forward and look at, in slices short enough to give way
/// between them. What it knows never gets worse.
class GradientProof {
  public:
    GradientProof(std::shared_ptr<const Tape> tape, std::shared_ptr<const std::vector<double>> parameters,
                  const Container& container, GradientStudySettings settings = {});

    /// Whether it is about this function with these numbers in this container.
    bool isAbout(const Tape& tape, std::span<const double> parameters, const Container& container) const;

    /// Works on about `boxes` further boxes, after the thread that is at it, if any. A stop ends it within
    /// milliseconds, a pause with the box at hand. After either the next call goes on. Returns whether there
    /// is more to do.
    bool advance(std::uint64_t boxes, std::stop_token stop = {}, std::stop_token pause = {});
    GradientBracket bracket() const;
    bool settled() const { return bracket().settled(); }

    /// Frees the memory of an unsettled study, which may be a hundred megabytes; the bracket stays, and the
    /// next advance() begins anew.
    void suspend();

  private:
    void adopt(const GradientBracket& found);

    std::shared_ptr<const Tape> tape_;
    std::shared_ptr<const std::vector<double>> parameters_;
    Container container_;
    GradientStudySettings settings_;
    std::mutex workMutex_;
    std::unique_ptr<GradientStudy> study_;  ///< null before and after the work
    mutable std::mutex bracketMutex_;
    GradientBracket bracket_;
};

}  // namespace isoscope
