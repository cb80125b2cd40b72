// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/animation/timeline.h"
#include "core/language/parse.h"

namespace isoscope {

/// The scene of a text without errors for POV-Ray 3.7, as exportScene(), with names in the places of the
/// numbers that have keys: declarations at its beginning compute them from `clock`, and the camera follows;
/// of the comments of the timeline the line of the frames stays. Without keys it is exportScene(). Include
/// files stay where they are.
std::string animationScene(const ParseResult& parsed, const Timeline& timeline);

/// The `.ini` file by which POV-Ray draws all frames of `scene`, a file name, in this size.
std::string animationSettings(const Timeline& timeline, const std::string& scene, int width, int height);

/// What `ffmpeg` is given to make the film `film` of the pictures of `frames`, which all are there; `film` is
/// replaced.
std::vector<std::string> filmArguments(const FrameSequence& frames, double rate, const std::string& film);

}  // namespace isoscope
