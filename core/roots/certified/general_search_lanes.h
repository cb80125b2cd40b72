// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <utility>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/roots/certified/case_march.h"
#include "core/roots/certified/general_search.h"
#include "core/roots/certified/march_lanes.h"
#include "core/roots/certified/proof_recorder.h"
#include "core/roots/certified/search_allowance.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// What certified searches need of one isosurface. The references must outlive the searches.
struct SearchTools {
    const RootSettings& settings;
    AffineEvaluator& forms;
    PointEvaluator& points;
    std::uint32_t budget;
};

/// Up to batchLanes certified searches that advance together. Lanes [0, active()) run; behind them wait those
/// that have come to the limit (limitTo).
class GeneralSearchLanes {
  public:
    explicit GeneralSearchLanes(const SearchTools& tools) : tools_(tools) {}

    /// Drops all searches, without telling of them.
    void clear() {
        active_ = alive_ = 0;
        caseMarch_.reset();
    }
    /// From now on enclosures are taken from `allowance`: a line that gets no more, or has spent its budget,
    /// ends there, without being sampled where it is limited.
    void allow(SearchAllowance allowance) { allowance_ = std::move(allowance); }
    /// GeneralSearch::listPoles() for all searches.
    void listPoles() {
        for (GeneralSearch& search : searches_) search.listPoles();
    }
    /// From now on `recorder`, which must outlive the searches, is told all steps; null ends that.
    void recordInto(ProofRecorder* recorder) { recorder_ = recorder; }
    /// Searches that run, without those that wait at the limit.
    std::size_t active() const { return active_; }
    /// Whether no search runs or waits, and whether there is no room for another one.
    bool empty() const { return alive_ == 0; }
    bool full() const { return alive_ == batchLanes; }

    /// Begins the search along a line, where no lane waits. False when there is nothing to search.
    bool add(std::size_t line, const LineQuery& query, double sufficient, const CertainStart& start);

    /// Lets all lanes run again, up to `end` and no further for now.
    void limitTo(double end);
    /// While all lanes wait: those whose sign is certain, and is `sign`, pass over what is known to have that
    /// sign up to `end`. done() as for step().
    template <class Done>
    void skipTo(double end, double sign, Done done) {
        for (std::size_t lane = alive_; lane-- > 0;) {
            if (lanes_.sign[lane] != sign || lanes_.signPlace[lane] != pieces_.start[lane]) continue;
            if (!searches_[lane].skipTo(end, at(lane))) continue;
            done(lineOf_[lane], searches_[lane], sign);
            move(--alive_, lane);
        }
    }

    /// One step of the running lanes, with the whole tape or a shortened one that holds up to the limit.
    /// Calls done(line, search, end sign) for each search that is through: the end sign is that of the
    /// function where the line ends when it is certain, else 0. `queries` are those that lines are numbers
    /// of.
    template <class Done>
    void step(std::span<const LineQuery> queries, const SimplifiedTape* simplifiedTape, Done done) {
        if (allowance_.isLimited()) takePortions();
        if (!march(simplifiedTape)) return;
        for (std::size_t lane = active_; lane-- > 0;) {
            if (events_[lane] == MarchEvent::none) continue;
            GeneralSearch& search = searches_[lane];
            handle(lane, queries[lineOf_[lane]]);
            if (search.done()) {
                allowance_.note(search.verdict());
                done(lineOf_[lane], search, endSign(lane));
                remove(lane);
            } else if (search.waits(at(lane))) {
                rest(lane);
            }
        }
    }

  private:
    GeneralSearch::Lane at(std::size_t lane) { return {pieces_, lanes_, lane}; }
    void takePortions();
    bool march(const SimplifiedTape* simplifiedTape);
    void noteMarch(const AffineLanes& forms, std::span<const std::uint8_t> byCases);
    void handle(std::size_t lane, const LineQuery& query);
    double endSign(std::size_t lane) const;
    void remove(std::size_t lane);
    void rest(std::size_t lane);
    void swap(std::size_t a, std::size_t b);
    void move(std::size_t from, std::size_t to);

    SearchTools tools_;
    std::array<GeneralSearch, batchLanes> searches_;
    std::array<std::size_t, batchLanes> lineOf_{};
    std::array<MarchEvent, batchLanes> events_{};
    RayPieces pieces_;
    MarchLanes lanes_{};
    CaseMarch caseMarch_;
    SearchAllowance allowance_;
    ProofRecorder* recorder_ = nullptr;
    std::size_t active_ = 0;
    std::size_t alive_ = 0;
};

}  // namespace isoscope
