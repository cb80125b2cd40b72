// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/render/image.h"

namespace isoscope {

/// The program `povray` among the folders of PATH; none where it is not installed.
std::optional<std::filesystem::path> povrayProgram();

/// What POV-Ray is to draw.
struct PovrayOrder {
    std::string text;  ///< the scene
    int width = 0;
    int height = 0;
    std::filesystem::path folder;  ///< of the scene: its includes and images are found there; may be empty
    std::vector<std::string> options;  ///< further ones, "Declare=Size=2"
    /// After this time without a word, or work, it is taken for dead.
    std::chrono::milliseconds patience{30000};
};

/// What became of it.
struct PovrayPicture {
    Image image;          ///< without smooth edges; empty when there is none
    std::string problem;  ///< why: what POV-Ray said last, or that it is not installed
    bool stopped = false;
};

/// Why a scene with these `#write` files (ParseResult::writtenFiles) should not be given to POV-Ray: one of
/// them lies outside of the folder that it works in. Empty when all is well.
std::string whyNotForPovray(const std::map<std::string, std::string>& writtenFiles);

/// Has the installed POV-Ray draw a scene, and waits for it. It works in a temporary folder of its own, which
/// goes at the end with all that the scene writes there, and starts no programs. What it may read and write
/// elsewhere is what the system's povray.conf allows, which may be more than the rules given here: see
/// whyNotForPovray(). A stop ends it within a tenth of a second, and the end of this program ends it, too,
/// however that comes. `report` is told the share that is drawn, by the calling thread.
PovrayPicture drawWithPovray(const PovrayOrder& order, std::stop_token stop = {},
                             const std::function<void(double share)>& report = {});

}  // namespace isoscope
