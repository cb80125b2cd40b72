// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Which of several equal workers this is.
struct WorkPart {
    int number = 1;  ///< from 1
    int count = 1;
};

/// Reads "3/16"; nothing where that is no part of so many.
std::optional<WorkPart> readWorkPart(std::string_view text);

/// The frames of an animation, numbered as POV-Ray does.
struct FrameSequence {
    int first = 0;
    int last = 0;           ///< >= first
    double firstClock = 0;  ///< of the first frame
    double finalClock = 1;  ///< of the last one
    std::string beginning;  ///< of the pictures' names: "frames/torus"

    /// The value of `clock`: even from the first frame to the last; firstClock where there is only one.
    double clock(int frame) const;
    /// "frames/torus007.png": as many digits as the last frame has.
    std::filesystem::path file(int frame) const;
    /// Every count-th frame, so that parts of an animation that becomes slower take about the same time. All
    /// parts together are all frames, each once.
    std::vector<int> framesOf(const WorkPart& part) const;
};

/// Whether a picture of this size stands at `file` that is not older than `scene`, nor of a time that is yet
/// to come: there is nothing to do.
bool isDrawn(const std::filesystem::path& file, int width, int height, const std::filesystem::path& scene);

}  // namespace isoscope
