// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/proof_note.h"

#include <charconv>
#include <cmath>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

constexpr std::string_view opening = "/* Proven by Isoscope ";
constexpr std::string_view boundKey = "gradient at most ", accuracyKey = "accuracy ";
/// Bounds are proven anew with other rounding.
constexpr double slack = 1e-9;

std::string vectorText(const glm::dvec3& v) {
    return "<" + shortestNumber(v.x) + ", " + shortestNumber(v.y) + ", " + shortestNumber(v.z) + ">";
}

/// The word or number behind `key`, up to a blank, a comma or a semicolon.
std::string_view behind(std::string_view note, std::string_view key) {
    const std::size_t begin = note.find(key);
    if (begin == std::string_view::npos) return {};
    const std::string_view rest = note.substr(begin + key.size());
    return rest.substr(0, rest.find_first_of(" ,;\n\r"));
}

std::optional<double> numberBehind(std::string_view note, std::string_view key) {
    const std::string_view word = behind(note, key);
    double value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size()) return {};
    return value;
}

}  // namespace

std::string proofNote(const GradientBracket& bracket, double accuracy, const Camera& view,
                      std::string_view version) {
    if (!std::isfinite(bracket.upper) || bracket.seams) return {};
    return std::string(opening) + std::string(version) + ", checked again when it opens this text:\n   " +
           std::string(boundKey) + exactNumber(bracket.upper) + ", " + exactNumber(bracket.lower) +
           " is met at " + vectorText(bracket.place) +
           ";\n   method: enclosures of the gradient over boxes of the container; " +
           std::string(accuracyKey) + shortestNumber(accuracy) + ";\n   view: location " +
           vectorText(view.location) + ", look_at " + vectorText(view.lookAt) + " */\n";
}

std::optional<ProofNote> noteBefore(std::string_view text, const SourceRange& statement) {
    if (statement.file != 0 || statement.begin > text.size()) return {};
    const std::string_view before = text.substr(0, statement.begin);
    const std::size_t last = before.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos || last == 0 || before.substr(last - 1, 2) != "*/") return {};
    const std::size_t begin = before.rfind("/*", last - 1);
    if (begin == std::string_view::npos || before.substr(begin, opening.size()) != opening) return {};
    const std::string_view note = before.substr(begin, last + 1 - begin);
    ProofNote answer;
    answer.range = {0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(last + 1)};
    answer.version = behind(note, opening);
    const auto bound = numberBehind(note, boundKey), accuracy = numberBehind(note, accuracyKey);
    if (!bound || !accuracy || !(*bound >= 0)) return {};
    answer.bound = *bound;
    answer.accuracy = *accuracy;
    return answer;
}

NoteState checkNote(const ProofNote& note, const GradientBracket& bracket, double accuracy) {
    if (bracket.lower > note.bound * (1 + slack) || accuracy != note.accuracy) return NoteState::broken;
    // What was proven before is, with as much work.
    return bracket.upper <= note.bound * (1 + slack) && !bracket.seams ? NoteState::holds : NoteState::open;
}

std::string brokenNoteText(const ProofNote& note, const GradientBracket& bracket, double accuracy) {
    if (accuracy != note.accuracy)
        return "The comment is about accuracy " + shortestNumber(note.accuracy) + ", but " +
               shortestNumber(accuracy) + " is in force";
    return "The comment says that no gradient is longer than " + shortestNumber(note.bound) + ", but " +
           shortestNumber(bracket.lower) + " is met at " + vectorText(bracket.place);
}

}  // namespace isoscope
