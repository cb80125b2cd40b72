// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/exchange/read_scene.h"
#include "core/exchange/statement_scanner.h"
#include "core/language/sliders/slider_names.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// `parsed` with these values: by the parameter table where they have slots, else from a changed text.
ParseResult withValues(ParseResult parsed, const std::vector<std::pair<std::size_t, double>>& values) {
    if (values.empty()) return parsed;
    const std::vector<SceneParameter>& parameters = parsed.scene->parameters;
    const auto& table = parsed.scene->parameterTable;
    const auto hasSlot = [&](const auto& value) {
        const int slot = parameters[value.first].slot;
        return table && slot >= 0 && static_cast<std::size_t>(slot) < table->size();
    };
    if (!std::all_of(values.begin(), values.end(), hasSlot))
        return readScene(textWithValues(std::string((*parsed.sources)[0].text()), parameters, values),
                         parsed.options);
    auto moved = std::make_shared<std::vector<double>>(*table);
    for (const auto& [index, value] : values)
        (*moved)[static_cast<std::size_t>(parameters[index].slot)] = value;
    auto scene = std::make_shared<Scene>(*parsed.scene);
    scene->parameterTable = std::move(moved);
    parsed.scene = std::move(scene);
    return parsed;
}

SourceRange rangeOf(const TextLine& line) {
    return {0, static_cast<std::uint32_t>(line.begin), static_cast<std::uint32_t>(line.end)};
}

/// The line that has the keys of this name.
SourceRange rangeOfKeys(std::string_view text, const std::string& name) {
    for (const TextLine& line : linesOf(text)) {
        const Timeline one = timelineOf(text.substr(line.begin, line.end - line.begin));
        if (!one.tracks.empty() && one.tracks.front().name == name) return rangeOf(line);
    }
    return {};
}

ParseResult atClock(ParseResult parsed) {
    if (parsed.sources->size() == 0) return parsed;
    Timeline timeline = timelineOf((*parsed.sources)[0].text());
    const double frame = timeline.frameAt(parsed.options.clock);
    const Animation animation(std::move(timeline), parsed.scene->parameters);
    if (parsed.ok()) parsed = withValues(std::move(parsed), animation.values(frame));
    addTimelineWarnings(parsed);
    if (!parsed.ok() || !animation.movesCamera()) return parsed;
    auto scene = std::make_shared<Scene>(*parsed.scene);
    scene->camera = animation.camera(scene->camera, frame);
    parsed.scene = std::move(scene);
    return parsed;
}

constexpr std::array clockWords{"clock",       "clock_on",     "clock_delta",   "initial_clock",
                                "final_clock", "frame_number", "initial_frame", "final_frame"};

}  // namespace

Animation::Animation(Timeline timeline, const std::vector<SceneParameter>& parameters)
    : timeline_(std::move(timeline)) {
    std::map<std::string, std::size_t> indexes;
    // Those of include files have no sliders, and do not count among the calls.
    std::vector<SceneParameter> own;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < parameters.size() && !timeline_.tracks.empty(); ++i) {
        if (parameters[i].range.file != 0) continue;
        own.push_back(parameters[i]);
        places.push_back(i);
    }
    const std::vector<SliderName> names = sliderNames(own);
    for (std::size_t i = 0; i < own.size(); ++i)
        if (isNamedNumber(own[i])) indexes[names[i].name] = places[i];
    for (std::size_t i = 0; i < timeline_.tracks.size(); ++i) {
        const std::string& name = timeline_.tracks[i].name;
        if (isCameraTrack(name)) continue;
        if (const auto found = indexes.find(name); found != indexes.end())
            moved_.push_back({found->second, i, parameters[found->second].integral});
        else
            missing_.push_back(name);
    }
}

std::vector<std::pair<std::size_t, double>> Animation::values(double frame) const {
    std::vector<std::pair<std::size_t, double>> found;
    for (const Moved& one : moved_) {
        const double value = timeline_.tracks[one.track].value(frame);
        found.emplace_back(one.parameter, one.integral ? std::round(value) : value);
    }
    return found;
}

bool Animation::hasKey(std::size_t parameter, int frame) const {
    return std::any_of(moved_.begin(), moved_.end(), [&](const Moved& one) {
        return one.parameter == parameter && timeline_.tracks[one.track].at(frame);
    });
}

bool Animation::movesCamera() const {
    return std::any_of(timeline_.tracks.begin(), timeline_.tracks.end(),
                       [](const KeyTrack& track) { return isCameraTrack(track.name); });
}

Camera Animation::camera(const Camera& base, double frame) const {
    if (!movesCamera()) return base;
    auto numbers = poseNumbers(poseOf(base, base.lookAt));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (const KeyTrack* track = timeline_.track(cameraTrackNames()[i])) numbers[i] = track->value(frame);
    return posedCamera(base, poseOfNumbers(numbers));
}

std::string textWithValues(std::string text, const std::vector<SceneParameter>& parameters,
                           const std::vector<std::pair<std::size_t, double>>& values) {
    auto sorted = values;
    // The last one first, so that the places of the others stay valid.
    std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) {
        return parameters[a.first].range.begin > parameters[b.first].range.begin;
    });
    for (const auto& [index, value] : sorted) {
        const SourceRange& range = parameters[index].range;
        if (range.file == 0 && range.begin <= range.end && range.end <= text.size())
            text.replace(range.begin, range.end - range.begin, shortestNumber(value));
    }
    return text;
}

void addTimelineWarnings(ParseResult& parsed) {
    if (parsed.sources->size() == 0) return;
    const std::string_view text = (*parsed.sources)[0].text();
    const auto warn = [&](const char* id, const SourceRange& range, std::string message, const char* hint) {
        parsed.diagnostics.push_back({Severity::warning, id, range, std::move(message), hint, {}});
    };
    for (const TextLine& line : brokenTimelineLines(text))
        warn(brokenTimelineId, rangeOf(line),
             "This comment begins as a line of a timeline and is none; it is passed over",
             "Lines of a timeline are `// timeline: frames 0 to 119, clock 0 to 1, 30 per second` and "
             "`// keys \"R\": 0 = 0.5, 60 = 0.8 hold`");
    const Animation animation(timelineOf(text), parsed.scene->parameters);
    for (const std::string& name : animation.missing())
        warn(unknownKeysId, rangeOfKeys(text, name),
             "The timeline has keys for `" + name + "`, which no number of the text is called",
             "Give the keys the name of a number as the Parameters panel and its presets have it");
}

ParseResult readAtClock(std::string text, ParseOptions options) {
    return atClock(readScene(std::move(text), std::move(options)));
}

ParseResult readFileAtClock(const std::filesystem::path& file, ParseOptions options) {
    return atClock(readSceneFile(file, std::move(options)));
}

bool asksForClock(const SourceLibrary& sources) {
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        const std::string_view text = sources[i].text();
        const auto occurs = [text](std::string_view word) {
            return text.find(word) != std::string_view::npos;
        };
        // Most texts have none of the words, and need not be cut into theirs.
        if (std::none_of(clockWords.begin(), clockWords.end(), occurs)) continue;
        const std::set<std::string> words = identifiersIn(text);
        for (const char* word : clockWords)
            if (words.contains(word)) return true;
    }
    return false;
}

}  // namespace isoscope
