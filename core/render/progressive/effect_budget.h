// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/render/render_statistics.h"

namespace isoscope {

/// Decides which effects a picture does without while it moves, so that it is drawn within a time: the most
/// expensive first, judged by the last picture of the scene at rest.
class EffectBudget {
  public:
    /// Time for one picture on the clock; 0, or anything not positive, leaves nothing out.
    void setSeconds(double seconds) { seconds_ = seconds; }
    double seconds() const { return seconds_; }

    /// A picture at rest took so long on the clock, and so much work.
    void note(double seconds, const RenderStatistics& statistics);
    /// Forgets the last picture; to be called when another scene comes.
    void forget();

    /// What a moving picture does without, and how long it will take then.
    struct Decision {
        StageSet leftOut;      ///< of a moving picture
        double seconds = 0.2;  ///< that a picture without them will take on the clock
    };
    /// Leaves nothing out as long as no picture is known.
    Decision decide() const;

  private:
    /// Without such small ones a picture is hardly faster, but looks different.
    static constexpr double smallestShare = 0.05;

    double seconds_ = 0;
    double wholeSeconds_ = Decision{}.seconds;
    std::array<double, stageKindCount> shares_{};  ///< of the time, by StageKind
};

}  // namespace isoscope
