// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/animation/camera_pose.h"
#include "core/animation/timeline.h"
#include "core/language/parse.h"

namespace isoscope {

/// A timeline together with the numbers of the scene that it moves.
class Animation {
  public:
    Animation() = default;
    /// `parameters` are those of a parse of the text, as sliderNames() names them.
    Animation(Timeline timeline, const std::vector<SceneParameter>& parameters);

    /// As it was handed in.
    const Timeline& timeline() const { return timeline_; }
    /// The numbers that have keys, as indexes of `parameters` with their values at a frame; whole where the
    /// parameter is.
    std::vector<std::pair<std::size_t, double>> values(double frame) const;
    /// Whether the parameter has a key at the frame: its value is what a person chose, to the last digit.
    bool hasKey(std::size_t parameter, int frame) const;
    /// Whether any camera track has keys.
    bool movesCamera() const;
    /// The camera of the text as its keys have it; numbers without keys are those of `base`. `base` itself
    /// without such keys.
    Camera camera(const Camera& base, double frame) const;
    /// Names of tracks of which the scene has no number that could be moved.
    const std::vector<std::string>& missing() const { return missing_; }

  private:
    struct Moved {
        std::size_t parameter = 0;
        std::size_t track = 0;
        bool integral = false;
    };

    Timeline timeline_;
    std::vector<Moved> moved_;
    std::vector<std::string> missing_;
};

/// The text with other numbers in the places of some of its parameters, which are given by their indexes.
std::string textWithValues(std::string text, const std::vector<SceneParameter>& parameters,
                           const std::vector<std::pair<std::size_t, double>>& values);

/// Identify warnings about a timeline: keys for a number that the text does not have, and a comment that
/// begins as one of a timeline and is none.
constexpr const char* unknownKeysId = "unknown-keys";
constexpr const char* brokenTimelineId = "broken-timeline";

/// Adds these warnings, with their lines, to what was found in a text.
void addTimelineWarnings(ParseResult& parsed);

/// Reads a text at the moment that `options.clock` is: its timeline moves numbers and camera. One without a
/// timeline is read as by readScene(). Diagnostics are those of addTimelineWarnings(), too.
ParseResult readAtClock(std::string text, ParseOptions options);
/// The same for a file; one that cannot be read is a diagnostic.
ParseResult readFileAtClock(const std::filesystem::path& file, ParseOptions options);

/// Whether another clock or frame number may make another scene of the texts: one of their words is `clock`,
/// `frame_number` or the like, outside of comments and strings.
bool asksForClock(const SourceLibrary& sources);

}  // namespace isoscope
