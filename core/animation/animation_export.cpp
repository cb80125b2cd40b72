// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/animation_export.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "core/animation/animation.h"
#include "core/exchange/output_guard.h"
#include "core/exchange/pov_export.h"
#include "core/exchange/statement_scanner.h"
#include "core/language/sliders/comment_line.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// A number as a part of an expression.
std::string term(double value) {
    const std::string text = shortestNumber(value);
    return std::signbit(value) ? '(' + text + ')' : text;
}

std::string vectorOf(const glm::dvec3& v) {
    return '<' + shortestNumber(v.x) + ", " + shortestNumber(v.y) + ", " + shortestNumber(v.z) + '>';
}

/// Names that the text does not use, made of what is to be named.
class KeyNames {
  public:
    explicit KeyNames(std::set<std::string> used) : used_(std::move(used)) {}

    std::string nameFor(const std::string& what) {
        std::string name = "Key";
        for (const char c : what)
            if (std::isalnum(static_cast<unsigned char>(c)))
                name += c;
            else if (name.back() != '_')
                name += '_';
        if (name == "Key") name += '_';
        std::string wanted = name;
        for (int i = 2; !used_.insert(wanted).second; ++i) wanted = name + '_' + std::to_string(i);
        return wanted;
    }

  private:
    std::set<std::string> used_;
};

/// Writes the declarations of an animation.
class Declarations {
  public:
    Declarations(const Timeline& timeline, KeyNames& names)
        : names_(names),
          frame_(names.nameFor("_Frame")),
          way_(names.nameFor("_Way")),
          text_("// Frame of the timeline, and its numbers there.\n") {
        const FrameSequence& frames = timeline.frames;
        const double range = frames.finalClock - frames.firstClock;
        const double count = range == 0 ? 0 : (double(frames.last) - frames.first) / range;
        declare(frame_,
                std::to_string(frames.first) + " + (clock - " + term(frames.firstClock) + ")*" + term(count));
        // As Timeline::frameAt() rounds.
        text_ += "#if (abs(" + frame_ + " - floor(" + frame_ + " + 0.5)) < " +
                 shortestNumber(wholeFrameTolerance) + ")\n    ";
        declare(frame_, "floor(" + frame_ + " + 0.5)");
        text_ += "#end\n";
    }

    /// The name of the track's value.
    std::string add(const KeyTrack& track, bool integral) {
        const std::string name = names_.nameFor("_" + track.name);
        const std::vector<Key>& keys = track.keys;
        text_ += "// " + track.name + '\n';
        declare(name, shortestNumber(keys.front().value));
        for (std::size_t i = 0; i < keys.size(); ++i) {
            text_ += "#if (" + frame_ + " >= " + std::to_string(keys[i].frame) + ")\n    ";
            if (i + 1 == keys.size()) {
                declare(name, shortestNumber(keys[i].value));
            } else {
                declare(way_, "(" + frame_ + " - " + std::to_string(keys[i].frame) + ")/" +
                                  std::to_string(keys[i + 1].frame - keys[i].frame));
                const KeyWay way = track.way(i);
                text_ += "    ";
                declare(name, term(way.c[0]) + " + " + way_ + "*(" + term(way.c[1]) + " + " + way_ + "*(" +
                                  term(way.c[2]) + " + " + way_ + "*" + term(way.c[3]) + "))");
            }
            text_ += "#end\n";
        }
        if (integral) declare(name, "floor(" + name + " + 0.5)");
        return name;
    }

    const std::string& text() const { return text_; }

  private:
    void declare(const std::string& name, const std::string& value) {
        text_ += "#declare " + name + " = " + value + ";\n";
    }

    KeyNames& names_;
    std::string frame_, way_;
    std::string text_;
};

bool movesWhole(const std::string& block) {
    const std::set<std::string> words = identifiersIn(block);
    for (const char* word : {"translate", "rotate", "scale", "matrix", "transform"})
        if (words.contains(word)) return true;
    return false;
}

/// The camera block with the items that keys move behind all others, which they overrule.
std::string movedBlock(std::string block, const Timeline& timeline, const Camera& base,
                       Declarations& declarations) {
    if (movesWhole(block) || block.empty() || block.back() != '}') block = cameraBlock(base);
    block.pop_back();
    const auto fixed = poseNumbers(poseOf(base, base.lookAt));
    std::array<std::string, cameraTrackCount> numbers;
    bool turns = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const KeyTrack* track = timeline.track(cameraTrackNames()[i]);
        numbers[i] = track ? declarations.add(*track, false) : term(fixed[i]);
        if (track && i + 1 == numbers.size()) turns = true;
    }
    const auto& [azimuth, elevation, distance, x, y, z, angle] = numbers;
    const PoseAxes axes = poseAxes(base);
    const std::string target = "<" + x + ", " + y + ", " + z + ">";
    const std::string around = "cos(radians(" + azimuth + "))*" + vectorOf(axes.front) + " + sin(radians(" +
                               azimuth + "))*" + vectorOf(axes.side);
    block += "\n    location " + target + " + " + distance + "*(cos(radians(" + elevation + "))*(" + around +
             ") + sin(radians(" + elevation + "))*" + vectorOf(axes.sky) + ")\n";
    if (turns) block += "    angle " + angle + '\n';
    return block + "    look_at " + target + "\n}";
}

/// Where declarations may stand: behind the line of `#version`, unless something before it needs them.
std::size_t placeOfDeclarations(const std::string& text, std::size_t firstUse) {
    for (const ScenePiece& piece : scanPieces(text)) {
        if (piece.directive != "version") continue;
        const std::size_t end = text.find('\n', piece.end);
        const std::size_t behind = end == std::string::npos ? text.size() : end + 1;
        return behind <= firstUse ? behind : 0;
    }
    return 0;
}

}  // namespace

std::string animationScene(const ParseResult& parsed, const Timeline& timeline) {
    const Scene& scene = *parsed.scene;
    const std::string own((*parsed.sources)[0].text());
    std::string text =
        exportScene(scene, scene.camera, own, parsed.options.imageWidth, parsed.options.imageHeight);
    const Animation animation(timeline, scene.parameters);
    const auto values = animation.values(timeline.frames.first);
    if (values.empty() && !animation.movesCamera()) return text;
    // exportScene() may have put a line in front of the text.
    const std::size_t shift = text.find(own);
    KeyNames names(identifiersIn(text));
    Declarations declarations(timeline, names);
    std::vector<TextEdit> edits;
    const std::vector<std::string>& missing = animation.missing();
    std::size_t number = 0;
    for (const KeyTrack& track : timeline.tracks) {
        if (isCameraTrack(track.name) ||
            std::find(missing.begin(), missing.end(), track.name) != missing.end())
            continue;
        const SceneParameter& parameter = scene.parameters[values[number++].first];
        edits.push_back(editOf(parameter.range.begin + shift, parameter.range.end + shift,
                               declarations.add(track, parameter.integral)));
    }
    if (animation.movesCamera()) {
        const auto& range = scene.cameraRange;
        const bool placed = range && range->file == 0;
        const std::string block =
            placed ? own.substr(range->begin, range->end - range->begin) : cameraBlock(scene.camera);
        const std::size_t begin = placed ? range->begin + shift : text.find(block, shift + own.size());
        edits.push_back(
            editOf(begin, begin + block.size(), movedBlock(block, timeline, scene.camera, declarations)));
    }
    std::sort(edits.begin(), edits.end(),
              [](const TextEdit& a, const TextEdit& b) { return a.begin > b.begin; });
    const std::size_t place = placeOfDeclarations(text, edits.back().begin);
    const auto apply = [&text](const std::vector<TextEdit>& all) {
        for (const TextEdit& edit : all) text.replace(edit.begin, edit.end - edit.begin, edit.text);
    };
    apply(edits);
    text.insert(place, declarations.text());
    // The keys are in the numbers now.
    Timeline framesAlone = timelineOf(text);
    framesAlone.tracks.clear();
    apply(timelineEdits(text, framesAlone));
    return text;
}

std::string animationSettings(const Timeline& timeline, const std::string& scene, int width, int height) {
    const FrameSequence& frames = timeline.frames;
    return std::string(renderSettingsMark) +
           ": POV-Ray draws all frames when it is given this file.\nInput_File_Name=\"" + scene +
           "\"\nInitial_Frame=" + std::to_string(frames.first) +
           "\nFinal_Frame=" + std::to_string(frames.last) +
           "\nInitial_Clock=" + shortestNumber(frames.firstClock) +
           "\nFinal_Clock=" + shortestNumber(frames.finalClock) + "\nWidth=" + std::to_string(width) +
           "\nHeight=" + std::to_string(height) + '\n';
}

std::vector<std::string> filmArguments(const FrameSequence& frames, double rate, const std::string& film) {
    // A percent sign of the names is no place of the number.
    std::string pattern;
    for (const char c : frames.beginning) pattern += c == '%' ? "%%" : std::string(1, c);
    const std::size_t digits = std::to_string(frames.last).size();
    pattern += "%0" + std::to_string(digits) + "d.png";
    return {"-y", "-loglevel", "error", "-progress", "pipe:1", "-framerate", shortestNumber(rate),
            "-start_number", std::to_string(frames.first), "-i", pattern, "-frames:v",
            std::to_string(frames.last - frames.first + 1),
            // Common players want even sizes and this form of colours.
            "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", film};
}

}  // namespace isoscope
