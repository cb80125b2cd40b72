// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/camera_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "core/exchange/pov_export.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {

namespace {

/// Digits kept behind the distance of the view: far below a pixel.
constexpr double relativeResolution = 1e-5;
/// Two views that agree to this look the same.
constexpr double sameViewTolerance = 1e-6;

struct Word {
    std::string_view text;
    std::size_t begin = 0;
    std::size_t end = 0;
};

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The words of a block outside of comments; empty when it holds strings or directives, which could mean
/// anything.
std::optional<std::vector<Word>> wordsOf(std::string_view text) {
    std::vector<Word> words;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t close = text.find("*/", i + 2);
            if (close == std::string_view::npos) return std::nullopt;
            i = close + 2;
        } else if (text[i] == '#' || text[i] == '"') {
            return std::nullopt;
        } else if (isWordCharacter(text[i])) {
            const std::size_t begin = i;
            while (i < text.size() && isWordCharacter(text[i])) ++i;
            words.push_back({text.substr(begin, i - begin), begin, i});
        } else {
            ++i;
        }
    }
    return words;
}

bool isItem(std::string_view word) {
    static constexpr std::array items{"location", "look_at", "right",       "up",          "direction",
                                      "sky",      "angle",   "perspective", "orthographic"};
    return std::find(items.begin(), items.end(), word) != items.end();
}

/// Words that move the whole camera, or start from another: location and look_at are not the view's then.
bool isTransformation(std::string_view word) {
    static constexpr std::array words{"translate", "rotate", "scale", "matrix", "transform"};
    return std::find(words.begin(), words.end(), word) != words.end();
}

struct Place {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Where the value of the only `name` stands: from its first character to the last before the next item,
/// comment or brace.
std::optional<Place> valueOf(std::string_view block, const std::vector<Word>& words, std::string_view name) {
    std::optional<Place> place;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].text != name) continue;
        if (place) return std::nullopt;
        std::size_t end = block.rfind('}');
        for (std::size_t k = i + 1; k < words.size(); ++k)
            if (isItem(words[k].text)) {
                end = words[k].begin;
                break;
            }
        std::size_t begin = words[i].end;
        const std::string_view value = block.substr(begin, end - begin);
        end = begin + std::min({value.size(), value.find("//"), value.find("/*")});
        while (begin < end && std::isspace(static_cast<unsigned char>(block[begin]))) ++begin;
        while (end > begin && std::isspace(static_cast<unsigned char>(block[end - 1]))) --end;
        if (begin == end) return std::nullopt;
        place = Place{begin, end};
    }
    return place;
}

std::string vectorText(const glm::dvec3& v, double resolution) {
    std::string text = "<";
    for (int i = 0; i < 3; ++i) text += (i ? ", " : "") + numberText(v[i], resolution).toStdString();
    return text + ">";
}

bool near(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) <= sameViewTolerance * std::max(1.0, glm::length(a));
}

bool sameView(const Camera& a, const Camera& b) {
    return a.kind == b.kind && near(a.location, b.location) && near(a.direction, b.direction) &&
           near(a.right, b.right) && near(a.up, b.up);
}

}  // namespace

std::string cameraText(std::string_view block, const Camera& written, const Camera& view) {
    Camera moved = written;
    moved.location = view.location;
    const auto words = wordsOf(block);
    const bool plain =
        words && view.kind == CameraKind::perspective && block.find('}') != std::string_view::npos &&
        std::none_of(words->begin(), words->end(), [](const Word& w) { return isTransformation(w.text); });
    if (!plain || !sameView(moved.lookingAt(view.lookAt), view)) return cameraBlock(view);
    const auto location = valueOf(block, *words, "location");
    const auto lookAt = valueOf(block, *words, "look_at");
    if (!location || !lookAt) return cameraBlock(view);

    const double resolution = glm::length(view.lookAt - view.location) * relativeResolution;
    std::string text(block);
    const auto replace = [&](const Place& place, const glm::dvec3& value) {
        text.replace(place.begin, place.end - place.begin, vectorText(value, resolution));
    };
    // The later one first, so that the other's place stays valid.
    if (location->begin < lookAt->begin) {
        replace(*lookAt, view.lookAt);
        replace(*location, view.location);
    } else {
        replace(*location, view.location);
        replace(*lookAt, view.lookAt);
    }
    return text;
}

}  // namespace isoscope
