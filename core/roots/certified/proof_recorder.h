// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/roots/certified/general_search.h"
#include "core/roots/certified/march_lanes.h"

namespace isoscope {

/// By which rule a certified search passes a part of a line, or finds a root there. Signs are those of
/// RootSettings::signedValue(): negative inside.
enum class ProofRule : std::uint8_t {
    form,       ///< one sign all along, by the form of a piece that holds the part
    cases,      ///< the same, by forms on the sides of jumps (CaseMarch)
    undefined,  ///< no value all along
    passed,     ///< too short to be looked at further: nothing is known
    sampled,    ///< the budget was spent: looked at in some points alone
    // Roots, as in RootKind: the sign is `sign` at the beginning of the part and the other one at its end.
    // Where `sign` is 0, computed values alone say so.
    crossing,
    jump,
    pole,
};

/// The word for a rule: static text.
const char* name(ProofRule rule);

/// What a certified search has shown of the part [from, to] of a line.
struct ProofStep {
    ProofRule rule = ProofRule::form;
    double from = 0, to = 0;
    int sign = 0;  ///< -1, 1; 0 where none is known
    // Of the rule `form`: f, the threshold not taken off, lies in center + slope s + [-error, error] for t
    // from `start` (s = -1) to start + length (s = 1). Else 0.
    double start = 0, length = 0;
    double center = 0, slope = 0, error = 0;
};

/// Writes down the steps of GeneralSearchLanes, which do the same with it and without. Those of one line are
/// in the order in which they were taken; of several lines they are mixed.
class ProofRecorder {
  public:
    /// All steps since the last clear().
    const std::vector<ProofStep>& steps() const { return steps_; }
    void clear() { steps_.clear(); }

    /// Before a step: where the first `count` lanes are.
    void begin(const RayPieces& pieces, std::size_t count);
    /// What march() has made of these lanes by `forms`. `byCases[lane]` says that the form of a lane only
    /// stands for what CaseMarch knows.
    void noteMarch(const RayPieces& pieces, const MarchLanes& lanes, const AffineLanes& forms,
                   std::span<const std::uint8_t> byCases, std::span<const MarchEvent> events);
    /// What GeneralSearch::handle() has made of the event of a lane, where `search` had `rootsBefore` roots.
    void noteHandled(const GeneralSearch& search, const GeneralSearch::Lane& lane, MarchEvent event,
                     std::size_t rootsBefore);

  private:
    void addClear(std::size_t lane, double from, double to, double sign);
    void addRoots(std::size_t lane, const MarchLanes& lanes, double start, MarchEvent event,
                  std::span<const BracketedRoot> roots);

    std::vector<ProofStep> steps_;
    // Of the step at hand, lane by lane.
    MarchLanes::Lanes start_{}, length_{}, end_{};  ///< of the pieces before it
    MarchLanes::Lanes center_{}, slope_{}, error_{};
    MarchLanes::Lanes sign_{}, signPlace_{}, watched_{};  ///< before the event is handled
    MarchLanes::Lanes settled_{};                         ///< what the march has settled ends here
    std::array<std::uint8_t, batchLanes> byCases_{};
};

}  // namespace isoscope
