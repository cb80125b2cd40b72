// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// How a value goes from one key to the next.
enum class Easing {
    smooth,     ///< slow at both keys
    linear,     ///< evenly
    slowStart,  ///< gathers speed
    slowEnd,    ///< loses speed
    curve,      ///< through the keys without rest, and never beyond the values of two neighbours
    hold,       ///< stays, and jumps at the next key
};

/// In the order in which menus offer them.
constexpr Easing allEasings[] = {Easing::smooth,  Easing::linear, Easing::slowStart,
                                 Easing::slowEnd, Easing::curve,  Easing::hold};

/// The word of an easing in texts, "slow-start", and back; nothing for another word.
std::string_view easingWord(Easing easing);
std::optional<Easing> easingOf(std::string_view word);

/// A value at a frame, and the way from there to the next key.
struct Key {
    int frame = 0;
    double value = 0;
    Easing easing = Easing::smooth;
    bool operator==(const Key&) const = default;
};

/// The way between two keys: c[0] + c[1] u + c[2] u^2 + c[3] u^3, with u from 0 at the first to 1 at the
/// second.
struct KeyWay {
    double c[4] = {0, 0, 0, 0};
    /// The value at u.
    double at(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
};

/// The keys of one number. Before the first key and behind the last one the value stays.
struct KeyTrack {
    std::string name;       ///< of a slider, or one of cameraTrackNames()
    std::vector<Key> keys;  ///< by their frames, each with one of its own
    bool operator==(const KeyTrack&) const = default;

    /// The way behind key `index`, which is not the last one. The easing `curve` has the slopes of Fritsch
    /// and Butland (SIAM J. Sci. Stat. Comput. 5, 1984), which keep a curve between its keys monotone.
    KeyWay way(std::size_t index) const;
    /// The value at a frame, also between two; exactly that of a key at its frame. 0 without keys.
    double value(double frame) const;
    /// The key of this frame; null where there is none.
    const Key* at(int frame) const;
    /// Puts a key in, in the place of the one that has its frame.
    void put(const Key& key);
    /// Takes the key of this frame away; false where there is none.
    bool remove(int frame);
};

}  // namespace isoscope
