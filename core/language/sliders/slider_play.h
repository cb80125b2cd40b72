// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// What a slider that plays does at the ends of its range.
enum class PlayMode { once, loop, pingPong };

/// How a slider moves by itself: by the clock, so that slow pictures make it no slower, only less smooth.
struct SliderPlay {
    PlayMode mode = PlayMode::pingPong;
    double seconds = 4;  ///< from one end to the other; > 0
};

/// Where a slider is that plays.
struct PlayPlace {
    double share = 0;    ///< of the way from the lower end to the upper one, 0 to 1
    bool ended = false;  ///< it has come to the end, and stays there
};

/// Where a slider is `elapsed` seconds after it began to play at `start`, a share as in PlayPlace. One that
/// is to go once and begins at the upper end begins at the lower one.
PlayPlace playPlace(const SliderPlay& play, double start, double elapsed);

}  // namespace isoscope
