// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// How edges are smoothed.
enum class SamplingMethod {
    box,        ///< every pixel is the mean of 3 x 3 samples
    adaptive,   ///< POV-Ray's method 1: a grid of samples where a pixel differs from a neighbour
    recursive,  ///< POV-Ray's method 2: a pixel is divided further where its corners differ
};

/// POV-Ray's options of anti-aliasing, with its defaults; the box has none.
struct Antialiasing {
    SamplingMethod method = SamplingMethod::box;
    double threshold = 0.3;  ///< the difference of two colours (sum of the channels) that calls for more: +A
    int depth = 3;           ///< samples on a side of the grid; divisions of a pixel: +R, 1 to 9
    double jitter = 1;       ///< how far the samples of a grid are moved at random: +J; 0 for not at all
    double gamma = 2.5;      ///< of the space in which colours are compared and averaged: Antialias_Gamma
};

}  // namespace isoscope
