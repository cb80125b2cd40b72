// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/study/accuracy/povray_time.h"
#include "core/study/accuracy/studied_setting.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

/// What one value of the setting takes and loses; the entries of arrays are by RootFinder. Everything but
/// `cpuSecondsPerPixel` is counted, hence the same on every run and machine.
struct CostPoint {
    double setting = 0;
    std::array<double, 2> evaluationsPerPixel{};
    std::array<double, 2> cpuSecondsPerPixel{};
    std::array<std::uint64_t, 2> lost{};  ///< pixels of it that miss the surface
};

/// What a CostSurvey measures: one setting of one isosurface in a view.
struct CostSurveyRequest {
    RenderRequest view;          ///< its size is the one that times are told for; its root finder is ignored
    std::size_t isosurface = 0;  ///< whose setting is varied; the others keep theirs
    StudiedSetting setting = StudiedSetting::accuracy;
    std::vector<double> values;  ///< in the order they are wanted
};

/// What sliders of a setting span at first: accuracy 1e-6 to 1, max_gradient 0.1 to 1000.
struct SurveyedRange {
    double low = 0;
    double high = 0;
};
/// The same for every scene: the ends of the slider before it is moved.
SurveyedRange surveyedRange(StudiedSetting setting);

/// Values for a survey from `low` to `high` (both positive and finite, else none): the ends, and the powers
/// of ten between them; where these are fewer than three, also their doubles and fives. Coarse first: the
/// ends, then what halves the gaps.
std::vector<double> surveyValues(double low, double high);

/// Counts in a small picture what the values of a setting cost and lose with both root finders, for a strip
/// under the slider. The picture's size follows from counts, too, so that the whole is the same on every run:
/// some seconds of one core for a slow scene, a tenth of one for a simple one. Single threaded.
class CostSurvey {
  public:
    explicit CostSurvey(CostSurveyRequest request);

    /// The next value; nothing when all are done, when there is nothing to measure, or on a stop request,
    /// which ends a picture in the making as well.
    std::optional<CostPoint> next(std::stop_token stop = {});
    bool complete() const { return !points_.empty() && points_.size() == request_.values.size(); }

    /// Of the small picture; 0 before the first point.
    int width() const { return small_.width; }
    int height() const { return small_.height; }
    /// What a picture by POV-Ray's method takes with the present settings; known with the first point.
    const PovrayCounts& povray() const { return povray_; }
    const std::vector<CostPoint>& points() const { return points_; }

    /// The value behind which a decade more costs time and changes no pixel, of POV-Ray's method: going from
    /// cheap to dear (accuracy downwards, max_gradient upwards), the first value from which on every studied
    /// value shows the same picture as the dearest one. A pixel is the same when it hits and misses alike,
    /// and its place lies no further off than the pixel is wide at the size of the request: less cannot be
    /// seen. Of the pixels that hit, one in 200 may differ, for rays along a rim turn over with every
    /// rounding. The views are compared, not timed, so the knee is the same on every run. Nothing before
    /// complete(), and where only the dearest value is like itself.
    std::optional<double> knee() const;

  private:
    bool prepare(std::stop_token stop);
    RenderRequest with(double value, RootFinder finder) const;
    double pixelWidth(const TracedPixel& pixel, std::size_t index) const;

    CostSurveyRequest request_;
    RenderRequest small_;
    TracedView truth_;
    PovrayCounts povray_;
    double tolerance_ = 0;
    std::vector<CostPoint> points_;
    std::vector<TracedView> views_;  ///< by POV-Ray's method, one for each point
};

/// The processor seconds of a whole picture by the certified root finder, of the size of the request: from
/// the counts of `point` and the mean time of an evaluation in all points, so that it does not jitter from
/// one to the next. Light is counted as for POV-Ray's method.
double certifiedSeconds(const CostPoint& point, const std::vector<CostPoint>& all, const PovrayCounts& povray,
                        double pixels);

}  // namespace isoscope
