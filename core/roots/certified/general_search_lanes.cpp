// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/general_search_lanes.h"

#include <algorithm>
#include <utility>

#include "core/roots/certified/points_on_line.h"

namespace isoscope {

bool GeneralSearchLanes::add(std::size_t line, const LineQuery& query, double sufficient,
                             const CertainStart& start) {
    const std::size_t lane = active_;
    GeneralSearch& search = searches_[lane];
    const bool limited = allowance_.isLimited();
    const std::uint32_t first = limited ? allowance_.firstPortion(tools_.forms.evaluations()) : tools_.budget;
    search.begin(query, tools_.settings, sufficient, tools_.forms.certain(), at(lane),
                 std::min(first, tools_.budget), !limited);
    if (search.done()) return false;
    search.goTo(start, at(lane));
    lineOf_[lane] = line;
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        pieces_.origin[axis][lane] = query.origin[k];
        pieces_.direction[axis][lane] = query.direction[k];
    }
    ++active_;
    ++alive_;
    return true;
}

void GeneralSearchLanes::limitTo(double end) {
    active_ = alive_;
    for (std::size_t lane = active_; lane-- > 0;) {
        searches_[lane].limitTo(end, at(lane));
        if (searches_[lane].waits(at(lane))) rest(lane);
    }
}

/// Lanes at the end of their portion get another one, as long as there is any and their budget is not spent.
void GeneralSearchLanes::takePortions() {
    if (!allowance_.has(tools_.forms.evaluations())) return;
    for (std::size_t lane = 0; lane < active_; ++lane) {
        double& budget = lanes_.budget[lane];
        if (lanes_.evaluations[lane] + 1 >= budget)
            budget = std::min(budget + SearchAllowance::portion, static_cast<double>(tools_.budget));
    }
}

bool GeneralSearchLanes::march(const SimplifiedTape* simplifiedTape) {
    const SignRule rule{tools_.settings.threshold, tools_.settings.positivePolarity};
    if (recorder_ != nullptr) recorder_->begin(pieces_, active_);
    if (simplifiedTape == nullptr && tools_.forms.canJump()) {
        const bool any = caseMarch_.step(tools_.forms, pieces_, lanes_, rule, active_, events_.data());
        if (recorder_ != nullptr) noteMarch(caseMarch_.forms(), caseMarch_.byCases());
        return any;
    }
    const AffineLanes forms = simplifiedTape != nullptr
                                  ? tools_.forms.evaluate(pieces_, active_, *simplifiedTape)
                                  : tools_.forms.evaluate(pieces_, active_);
    const bool any = isoscope::march(pieces_, lanes_, forms, rule, active_, events_.data());
    if (recorder_ != nullptr) noteMarch(forms, {});
    return any;
}

void GeneralSearchLanes::noteMarch(const AffineLanes& forms, std::span<const std::uint8_t> byCases) {
    recorder_->noteMarch(pieces_, lanes_, forms, byCases, std::span(events_).first(active_));
}

void GeneralSearchLanes::handle(std::size_t lane, const LineQuery& query) {
    GeneralSearch& search = searches_[lane];
    PointsOnLine line(tools_.points, tools_.settings, query);
    const std::size_t rootsBefore = search.roots().size();
    search.handle(events_[lane], at(lane), line);
    if (recorder_ != nullptr) recorder_->noteHandled(search, at(lane), events_[lane], rootsBefore);
}

double GeneralSearchLanes::endSign(std::size_t lane) const {
    return lanes_.signPlace[lane] == lanes_.far[lane] ? lanes_.sign[lane] : 0;
}

void GeneralSearchLanes::remove(std::size_t lane) {
    move(--active_, lane);
    move(--alive_, active_);
}

void GeneralSearchLanes::rest(std::size_t lane) { swap(lane, --active_); }

void GeneralSearchLanes::move(std::size_t from, std::size_t to) {
    if (from == to) return;
    std::swap(searches_[from], searches_[to]);  // keeps the memory of both
    lineOf_[to] = lineOf_[from];
    events_[to] = events_[from];
    pieces_.copyLane(from, to);
    lanes_.copyLane(from, to);
}

void GeneralSearchLanes::swap(std::size_t a, std::size_t b) {
    if (a == b) return;
    std::swap(searches_[a], searches_[b]);
    std::swap(lineOf_[a], lineOf_[b]);
    std::swap(events_[a], events_[b]);
    pieces_.swapLanes(a, b);
    lanes_.swapLanes(a, b);
}

}  // namespace isoscope
