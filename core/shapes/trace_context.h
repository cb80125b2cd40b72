// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "core/roots/verdict.h"

namespace isoscope {

/// State that one shape wants to keep between rays of one thread (evaluator scratch, running max_gradient).
class ShapeState {
  public:
    virtual ~ShapeState() = default;
    /// Forgets what was learnt from rays, but not what only saves time (TraceContext::restart).
    virtual void restart() {}
};

/// A hit of a part of a CSG shape, while it is not known whether it bounds the whole.
struct PartHit {
    double t;
    std::uint32_t hit;   ///< its number in the list of hits
    std::uint32_t part;  ///< the number of the part
    bool visible = false;
};

/// Which root finder looks for isosurfaces.
enum class RootFinder { lipschitz, certified };

/// What the tracing of one thread needs and changes: the scene's parameter values, counters, and the private
/// state of shapes. One per thread and picture; what is kept from ray to ray (docs/povray/solver.md) begins
/// anew with each context, and with restart(). Not to be used any more when its shapes are gone.
class TraceContext {
  public:
    TraceContext() = default;
    explicit TraceContext(std::shared_ptr<const std::vector<double>> parameterTable, RootFinder finder)
        : rootFinder(finder), parameters_(std::move(parameterTable)) {}

    /// Forgets what was learnt from rays and counts anew, for the next block of the same picture; the shapes
    /// keep their evaluators and their memory.
    void restart() {
        rays = evaluations = 0;
        shadowRay = false;
        nearLimit = 0;
        for (auto& [owner, state] : states_) state->restart();
    }

    /// Values of the scene's parameter slots; fixed for the life of the context.
    std::span<const double> parameters() const {
        return parameters_ ? std::span<const double>(*parameters_) : std::span<const double>();
    }

    RootFinder rootFinder = RootFinder::lipschitz;
    std::uint64_t rays = 0;         ///< rays handed to shapes
    std::uint64_t evaluations = 0;  ///< point evaluations of isosurface functions
    /// The rays at hand only ask whether anything is in between: isosurfaces save themselves the normals.
    bool shadowRay = false;
    double nearLimit = 0;  ///< Shape::nearest leaves out hits with smaller t
    /// POV-Ray's memory of the last ray that missed (LipschitzRootFinder), which loses further pixels when
    /// max_gradient is too small. POV-Ray has one memory for all isosurfaces: where several are met by the
    /// same rays it has hardly any effect, so rendering should leave it on for scenes with one isosurface
    /// only.
    bool missMemory = true;
    /// For each Ray::sample the worst verdict of the isosurfaces that the ray was sent through, which must
    /// begin as certifiedMiss. Only certified root finders tell, and not about shadow rays. May be empty.
    std::span<Verdict> verdicts;
    /// When requested, searches end at once with nothing found. Rendering should set it: one ray can take
    /// many thousand evaluations.
    std::stop_token stop;

    /// Which part each hit is on, for the CSG shapes at hand, the outer ones first; a stack, empty between
    /// queries.
    std::vector<PartHit> partHits;

    /// The state of `owner`, made by `make` at the first call.
    template <class State, class Make>
    State& state(const void* owner, Make make) {
        std::unique_ptr<ShapeState>& slot = states_[owner];
        if (!slot) slot = make();
        return static_cast<State&>(*slot);
    }

    /// The state of `owner`, or null when it has none yet.
    const ShapeState* find(const void* owner) const {
        const auto found = states_.find(owner);
        return found == states_.end() ? nullptr : found->second.get();
    }

    /// Calls visit(owner, state) for each state kept.
    template <class Visit>
    void forEachState(Visit visit) const {
        for (const auto& [owner, state] : states_) visit(owner, *state);
    }

  private:
    std::shared_ptr<const std::vector<double>> parameters_;
    std::unordered_map<const void*, std::unique_ptr<ShapeState>> states_;
};

}  // namespace isoscope
