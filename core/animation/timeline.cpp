// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/timeline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "core/language/sliders/value_preset.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::optional<int> takeFrame(std::string_view& text) {
    const std::optional<double> number = takeNumber(text);
    if (!number || *number != std::floor(*number) || *number < 0 || *number > mostFrames) return std::nullopt;
    return static_cast<int>(*number);
}

/// `frames 0 to 119, clock 0 to 1, 30 per second`, the last two as they please.
std::optional<Timeline> readFrames(std::string_view line) {
    if (!take(line, "//") || !take(line, "timeline:") || !take(line, "frames")) return std::nullopt;
    Timeline timeline;
    timeline.stated = true;
    FrameSequence& frames = timeline.frames;
    const auto first = takeFrame(line);
    if (!first || !take(line, "to")) return std::nullopt;
    const auto last = takeFrame(line);
    if (!last || *last < *first) return std::nullopt;
    frames.first = *first;
    frames.last = *last;
    while (take(line, ",")) {
        if (take(line, "clock")) {
            const auto begin = takeNumber(line);
            if (!begin || !take(line, "to")) return std::nullopt;
            const auto end = takeNumber(line);
            if (!end) return std::nullopt;
            frames.firstClock = *begin;
            frames.finalClock = *end;
        } else {
            const auto rate = takeNumber(line);
            if (!rate || !(*rate > 0) || !take(line, "per second")) return std::nullopt;
            timeline.rate = *rate;
        }
    }
    return trimmed(line).empty() ? std::optional(timeline) : std::nullopt;
}

/// `60 = 0.8 hold`.
std::optional<Key> readKey(std::string_view text) {
    const auto frame = takeFrame(text);
    if (!frame || !take(text, "=")) return std::nullopt;
    const auto value = takeNumber(text);
    if (!value) return std::nullopt;
    const std::string_view word = trimmed(text);
    const auto easing = word.empty() ? Easing::smooth : easingOf(word);
    if (!easing) return std::nullopt;
    return Key{*frame, *value, *easing};
}

std::optional<KeyTrack> readKeys(std::string_view line) {
    if (!take(line, "//") || !take(line, "keys") || !take(line, "\"")) return std::nullopt;
    const std::size_t quote = line.find('"');
    if (quote == std::string_view::npos) return std::nullopt;
    KeyTrack track{std::string(line.substr(0, quote)), {}};
    line.remove_prefix(quote + 1);
    if (!take(line, ":")) return std::nullopt;
    for (bool more = true; more;) {
        const std::size_t comma = std::min(line.find(','), line.size());
        const auto key = readKey(line.substr(0, comma));
        if (!key) return std::nullopt;
        track.keys.push_back(*key);
        more = comma < line.size();
        if (more) line.remove_prefix(comma + 1);
    }
    // Of two keys at one frame the first counts.
    std::stable_sort(track.keys.begin(), track.keys.end(),
                     [](const Key& a, const Key& b) { return a.frame < b.frame; });
    track.keys.erase(std::unique(track.keys.begin(), track.keys.end(),
                                 [](const Key& a, const Key& b) { return a.frame == b.frame; }),
                     track.keys.end());
    return track;
}

std::string framesLine(const Timeline& timeline) {
    const FrameSequence& frames = timeline.frames;
    return "// timeline: frames " + std::to_string(frames.first) + " to " + std::to_string(frames.last) +
           ", clock " + shortestNumber(frames.firstClock) + " to " + shortestNumber(frames.finalClock) +
           ", " + shortestNumber(timeline.rate) + " per second";
}

std::string keysLine(const KeyTrack& track) {
    std::string line = "// keys \"" + presetWord(track.name) + "\":";
    const char* between = " ";
    for (const Key& key : track.keys) {
        line += between + std::to_string(key.frame) + " = " + shortestNumber(key.value);
        if (key.easing != Easing::smooth) line += ' ' + std::string(easingWord(key.easing));
        between = ", ";
    }
    return line;
}

/// A line that speaks of the animation.
struct AnimationLine {
    TextLine line;
    std::optional<Timeline> frames;
    std::optional<KeyTrack> track;  ///< else it is the line of the frames
};

std::vector<AnimationLine> animationLines(std::string_view text) {
    std::vector<AnimationLine> found;
    std::set<std::string> named;
    bool stated = false;
    for (const TextLine& line : linesOf(text)) {
        const std::string_view words = text.substr(line.begin, line.end - line.begin);
        if (auto track = readKeys(words)) {
            if (named.insert(track->name).second) found.push_back({line, std::nullopt, std::move(track)});
        } else if (auto frames = readFrames(words); frames && !stated) {
            stated = true;
            found.push_back({line, std::move(frames), std::nullopt});
        }
    }
    return found;
}

bool sameFrames(const Timeline& a, const Timeline& b) {
    return a.frames.first == b.frames.first && a.frames.last == b.frames.last &&
           a.frames.firstClock == b.frames.firstClock && a.frames.finalClock == b.frames.finalClock &&
           a.rate == b.rate && a.stated == b.stated;
}

}  // namespace

const KeyTrack* Timeline::track(std::string_view name) const {
    const auto found = std::find_if(tracks.begin(), tracks.end(),
                                    [name](const KeyTrack& track) { return track.name == name; });
    return found == tracks.end() ? nullptr : &*found;
}

void Timeline::putKey(std::string_view name, const Key& key) {
    auto found = std::find_if(tracks.begin(), tracks.end(),
                              [name](const KeyTrack& track) { return track.name == name; });
    if (found == tracks.end()) found = tracks.insert(found, {std::string(name), {}});
    found->put(key);
}

bool Timeline::removeKey(std::string_view name, int frame) {
    const auto found = std::find_if(tracks.begin(), tracks.end(),
                                    [name](const KeyTrack& track) { return track.name == name; });
    if (found == tracks.end() || !found->remove(frame)) return false;
    if (found->keys.empty()) tracks.erase(found);
    return true;
}

bool Timeline::moveKey(std::string_view name, int from, int to) {
    const KeyTrack* found = track(name);
    const Key* key = found ? found->at(from) : nullptr;
    if (!key) return false;
    Key moved = *key;
    moved.frame = to;
    removeKey(name, from);
    putKey(name, moved);
    return true;
}

bool Timeline::setEasing(std::string_view name, int frame, Easing easing) {
    const KeyTrack* found = track(name);
    const Key* key = found ? found->at(frame) : nullptr;
    if (!key) return false;
    putKey(name, {frame, key->value, easing});
    return true;
}

double Timeline::frameAt(double clock) const {
    const double range = frames.finalClock - frames.firstClock;
    if (range == 0 || frames.last <= frames.first) return frames.first;
    const double frame =
        frames.first + (clock - frames.firstClock) / range * (double(frames.last) - frames.first);
    const double whole = std::round(frame);
    return std::abs(frame - whole) < wholeFrameTolerance ? whole : frame;
}

bool Timeline::operator==(const Timeline& other) const {
    return sameFrames(*this, other) && tracks == other.tracks;
}

Timeline timelineOf(std::string_view text) {
    Timeline timeline;
    std::vector<KeyTrack> tracks;
    for (AnimationLine& line : animationLines(text)) {
        if (line.track)
            tracks.push_back(std::move(*line.track));
        else
            timeline = std::move(*line.frames);
    }
    timeline.tracks = std::move(tracks);
    return timeline;
}

std::vector<TextLine> brokenTimelineLines(std::string_view text) {
    std::vector<TextLine> broken;
    for (const TextLine& line : linesOf(text)) {
        const std::string_view words = text.substr(line.begin, line.end - line.begin);
        std::string_view rest = words;
        if (!take(rest, "//")) continue;
        std::string_view keys = rest;
        if ((take(rest, "timeline:") && !readFrames(words)) ||
            (take(keys, "keys") && take(keys, "\"") && !readKeys(words)))
            broken.push_back(line);
    }
    return broken;
}

std::vector<TextEdit> timelineEdits(std::string_view text, const Timeline& wanted) {
    const std::vector<AnimationLine> lines = animationLines(text);
    std::vector<TextEdit> edits;
    std::set<std::string_view> present;
    bool stated = false;
    for (const auto& [line, frames, track] : lines) {
        const KeyTrack* now = track ? wanted.track(track->name) : nullptr;
        if (track) present.insert(track->name);
        stated = stated || frames;
        if (track ? !now : !wanted.stated)
            edits.push_back(editOf(line.begin, line.next, {}));
        else if (track ? *now != *track : !sameFrames(*frames, wanted))
            edits.push_back(editOf(line.begin, line.end, track ? keysLine(*now) : framesLine(wanted)));
    }
    std::vector<std::string> added;
    if (wanted.stated && !stated) added.push_back(framesLine(wanted));
    for (const KeyTrack& track : wanted.tracks)
        if (!track.keys.empty() && !present.contains(track.name)) added.push_back(keysLine(track));
    if (!added.empty()) {
        const std::string lineBreak = text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
        std::string block;
        for (const std::string& line : added) block += (block.empty() ? "" : lineBreak) + line;
        edits.push_back(lineInserted(text, lines.empty() ? text.size() : lines.back().line.next, block));
    }
    std::reverse(edits.begin(), edits.end());
    return edits;
}

}  // namespace isoscope
