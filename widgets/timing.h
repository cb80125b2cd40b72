// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope::timing {

// Milliseconds of the desktop program, in one place because they are tuned against each other.

/// Pause after the last key before the text is read again.
constexpr int typingPause = 200;
/// How often finished tiles are fetched while a picture is in the making, its first pass and its end apart,
/// which are fetched at once: one frame of a 60 Hz screen.
constexpr int drainInterval = 16;
/// A picture that takes no longer than this shows no busy mark, which would only flicker.
constexpr int busyMarkDelay = 100;
/// Work that takes no longer than this shows no progress.
constexpr int progressDelay = 500;
/// How often progress is told.
constexpr int progressInterval = 100;
/// How long the mouse rests in an orbit, or the wheel stands still, before full resolution is asked for.
constexpr int settlePause = 150;
/// How long a finished picture rests before it is drawn again with smooth edges.
constexpr int softenPause = 250;
/// VTK panels draw at most once in this time, and smoothly once nothing changed for `settlePause`.
constexpr int panelInterval = 16;
/// The panels show a changed scene after its picture, but no later than this.
constexpr int panelPatience = 100;
/// How often the panels show a scene while a slider plays.
constexpr int playedPanelInterval = 250;
/// After a resize: the old picture is stretched until the new size has lasted this long.
constexpr int resizePause = 60;
/// How long a message stays in the status line.
constexpr int messageDuration = 6000;

}  // namespace isoscope::timing
