// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/study/gradient/gradient_histogram.h"
#include "core/study/gradient/gradient_proof.h"
#include "core/study/gradient/hole_map.h"

namespace isoscope {

/// Everything known of one isosurface's gradient in one view.
struct GradientSurvey {
    double setting = 0;           ///< max_gradient in force
    double alongRays = 0;         ///< steepest slope that POV-Ray's method met along the rays of the view
    double onSurface = 0;         ///< largest |grad f| at the visible points of the surface
    glm::dvec3 steepestPoint{0};  ///< where that is, in the coordinates of the function
    GradientHistogram histogram;
    GradientBracket bracket;
    HoleMap holes;  ///< with the present settings
    /// The smallest of a few round values that makes no more mistakes in this view than a proven bound does;
    /// nothing while it is not known.
    std::optional<double> enoughForView;
    bool finished = false;
};

/// What surveyGradient() looks at, and with how much effort.
struct GradientSurveyRequest {
    RenderRequest view;  ///< small: it is traced about ten times; its root finder is ignored
    std::size_t isosurface = 0;
    GradientStudySettings settings;
    /// What is known already, and is to be known better; null: the survey makes a proof of its own.
    std::shared_ptr<GradientProof> proof;
    int threads = 1;  ///< 0 means all cores
};

/// Measures, quick things first, and reports after each; the last report is finished unless stopped. Nothing
/// is reported for a request without that isosurface.
void surveyGradient(const GradientSurveyRequest& request,
                    const std::function<void(const GradientSurvey&)>& report, std::stop_token stop = {});

}  // namespace isoscope
