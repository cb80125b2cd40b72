// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/animation/key_track.h"
#include "core/exchange/frame_sequence.h"
#include "core/language/sliders/comment_line.h"
#include "core/language/sliders/text_edit.h"

namespace isoscope {

/// Frames per second, and a timeline that says nothing else.
constexpr double usualFrameRate = 30;
constexpr int usualLastFrame = 119;
/// A clock that is so near to a frame's, in frames, is that frame's: POV-Ray keeps clock in single precision,
/// and a value that is held until a key must not miss the key's own frame.
constexpr double wholeFrameTolerance = 0.01;
constexpr int mostFrames = 9'999'999;  ///< highest number of a frame

/// What a text says about its animation, in comments that POV-Ray skips:
///
///     // timeline: frames 0 to 119, clock 0 to 1, 30 per second
///     // keys "R": 0 = 0.5, 60 = 0.8 hold, 119 = 0.5
struct Timeline {
    FrameSequence frames{0, usualLastFrame, 0, 1, {}};  ///< numbers and clock of the frames
    double rate = usualFrameRate;                       ///< frames per second, > 0
    std::vector<KeyTrack> tracks;                       ///< each with a name of its own, and keys
    bool stated = false;                                ///< the text has the line of the frames

    /// Whether the text speaks of an animation at all.
    bool any() const { return stated || !tracks.empty(); }
    /// The track of this name; null where there is none.
    const KeyTrack* track(std::string_view name) const;
    /// Puts a key into the track of this name, which is made where there is none.
    void putKey(std::string_view name, const Key& key);
    /// Takes the key away, and the track with its last one; false where there is none.
    bool removeKey(std::string_view name, int frame);
    /// Takes a key to another frame, in the place of one that is there; false where there is none at `from`.
    bool moveKey(std::string_view name, int from, int to);
    /// The way behind the key at `frame`; false where there is none.
    bool setEasing(std::string_view name, int frame, Easing easing);
    /// The frame of a value of `clock`, also between two frames and beyond the ends; a whole number where it
    /// is one to wholeFrameTolerance.
    double frameAt(double clock) const;
    bool operator==(const Timeline& other) const;
};

/// The timeline of a text. Lines that are not of these forms are comments like any other; of two lines for
/// one number the first counts.
Timeline timelineOf(std::string_view text);

/// The lines of a text that begin as timelineOf() reads them, `// keys "` or `// timeline:`, and go on
/// otherwise: they count as other comments.
std::vector<TextLine> brokenTimelineLines(std::string_view text);

/// The changes that make timelineOf(text) equal to `wanted`, from the end of the text to its beginning, so
/// that each can be made after the one before it. Other lines stay as they are.
std::vector<TextEdit> timelineEdits(std::string_view text, const Timeline& wanted);

}  // namespace isoscope
