// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/key_track.h"

#include <algorithm>

namespace isoscope {

namespace {

/// The slope of the easing `curve` at a key, by frame: none at the ends of the track and where the values
/// turn back, else a harmonic mean of those to both neighbours.
double slopeAt(const std::vector<Key>& keys, std::size_t index) {
    if (index == 0 || index + 1 >= keys.size()) return 0;
    const auto slope = [&](std::size_t i) {
        return (keys[i + 1].value - keys[i].value) / (double(keys[i + 1].frame) - keys[i].frame);
    };
    const double before = slope(index - 1), behind = slope(index);
    if (!(before * behind > 0)) return 0;
    const double left = double(keys[index].frame) - keys[index - 1].frame;
    const double right = double(keys[index + 1].frame) - keys[index].frame;
    const double weight = (left + 2 * right) / (3 * (left + right));
    return before * behind / (weight * behind + (1 - weight) * before);
}

auto firstNotBefore(const std::vector<Key>& keys, int frame) {
    return std::lower_bound(keys.begin(), keys.end(), frame,
                            [](const Key& key, int wanted) { return key.frame < wanted; });
}

}  // namespace

std::string_view easingWord(Easing easing) {
    switch (easing) {
        case Easing::smooth: return "smooth";
        case Easing::linear: return "linear";
        case Easing::slowStart: return "slow-start";
        case Easing::slowEnd: return "slow-end";
        case Easing::curve: return "curve";
        case Easing::hold: return "hold";
    }
    return "smooth";
}

std::optional<Easing> easingOf(std::string_view word) {
    for (const Easing easing : allEasings)
        if (easingWord(easing) == word) return easing;
    return std::nullopt;
}

KeyWay KeyTrack::way(std::size_t index) const {
    const Key &from = keys[index], &to = keys[index + 1];
    const double a = from.value, d = to.value - from.value;
    switch (from.easing) {
        case Easing::smooth: return {{a, 0, 3 * d, -2 * d}};
        case Easing::linear: return {{a, d, 0, 0}};
        case Easing::slowStart: return {{a, 0, d, 0}};
        case Easing::slowEnd: return {{a, 2 * d, -d, 0}};
        case Easing::hold: return {{a, 0, 0, 0}};
        case Easing::curve: break;
    }
    const double length = double(to.frame) - from.frame;
    const double begin = length * slopeAt(keys, index), end = length * slopeAt(keys, index + 1);
    return {{a, begin, 3 * d - 2 * begin - end, begin + end - 2 * d}};
}

double KeyTrack::value(double frame) const {
    if (keys.empty()) return 0;
    if (!(frame > keys.front().frame)) return keys.front().value;
    if (frame >= keys.back().frame) return keys.back().value;
    const auto next = std::upper_bound(keys.begin(), keys.end(), frame,
                                       [](double wanted, const Key& key) { return wanted < key.frame; });
    const auto index = static_cast<std::size_t>(next - keys.begin()) - 1;
    return way(index).at((frame - keys[index].frame) / (double(next->frame) - keys[index].frame));
}

const Key* KeyTrack::at(int frame) const {
    const auto key = firstNotBefore(keys, frame);
    return key != keys.end() && key->frame == frame ? &*key : nullptr;
}

void KeyTrack::put(const Key& key) {
    remove(key.frame);
    keys.insert(firstNotBefore(keys, key.frame), key);
}

bool KeyTrack::remove(int frame) {
    return std::erase_if(keys, [frame](const Key& key) { return key.frame == frame; }) > 0;
}

}  // namespace isoscope
