// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/study/accuracy/studied_setting.h"
#include "core/study/gradient/hole_map.h"

namespace isoscope {

/// What one value of the setting costs and gives with one root finder.
struct AccuracyPoint {
    RootFinder finder = RootFinder::lipschitz;
    double setting = 0;
    double cpuSeconds = 0;  ///< median of the runs, all threads
    std::uint64_t evaluations = 0;
    double evaluationsPerPixel = 0;
    std::uint64_t lost = 0;  ///< pixels missed
    std::uint64_t gained = 0;
    std::uint64_t wrongPlace = 0;
    double worstError = 0;  ///< in t, over the pixels that hit the right sheet
    double meanError = 0;
    std::uint64_t changed =
        0;  ///< pixels that differ from the picture with the present settings (what is hit)
};

/// What an AccuracyStudy measures, and how.
struct AccuracyStudyRequest {
    RenderRequest view;  ///< its root finder is ignored
    StudiedSetting setting = StudiedSetting::accuracy;
    std::vector<double> values;  ///< of the setting, in the order they are wanted
    int runs = 3;                ///< timings per point; the median counts
    int threads = 1;             ///< 0 means all cores
};

/// `count` values from `from` to `to`, evenly spread in the logarithm, both ends included; coarse first: ends
/// and middle, then what lies between. Empty for bounds that are not positive and finite.
std::vector<double> studyValues(double from, double to, int count);

/// Measures accuracy against cost. The truth is the certified root finder at an accuracy of `truthAccuracy`
/// times the size of the container, which is a few rounding errors of t.
class AccuracyStudy {
  public:
    static constexpr double truthAccuracy = 1e-13;

    explicit AccuracyStudy(AccuracyStudyRequest request);

    /// Points to measure in all: two root finders for each value.
    std::size_t size() const { return 2 * request_.values.size(); }
    /// The next point; nothing when all are done, or on a stop request, which ends a picture in the making as
    /// well. `report` is told the share of the whole study, also while one picture takes long.
    std::optional<AccuracyPoint> next(std::stop_token stop = {}, const ShareReport& report = {});

  private:
    bool prepare(std::stop_token stop, const ShareReport& report);
    /// Traces the `picture`-th picture of the study.
    TracedView trace(const RenderRequest& request, std::size_t picture, std::stop_token stop,
                     const ShareReport& report) const;
    std::size_t pictures() const;
    RenderRequest with(double value, RootFinder finder) const;
    void judge(const TracedView& view, AccuracyPoint& point) const;

    AccuracyStudyRequest request_;
    TracedView truth_;
    TracedView present_[2];
    std::size_t done_ = 0;
    double tolerance_ = 0;
};

}  // namespace isoscope
