// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/named_constants.h"

#include <chrono>
#include <numbers>
#include <unordered_map>

#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

Operand axis(std::size_t index, int count) {
    VectorValue vector;
    vector.count = count;
    vector.components[index] = 1;
    return Operand::of(vector);
}

double daysSince2000() {
    using namespace std::chrono;
    const auto start = sys_days{year{2000} / January / 1};
    return duration<double, days::period>(system_clock::now() - start).count();
}

double clockDelta(const ParseOptions& options) {
    // An animation's clock runs from 0 to 1 over its frames.
    const int frames = options.finalFrame - options.initialFrame;
    return options.clockOn && frames > 0 ? 1.0 / frames : 0;
}

using Constant = Operand (*)(const ParseContext&);

const std::unordered_map<std::string_view, Constant>& constants() {
    using C = const ParseContext&;
    static const std::unordered_map<std::string_view, Constant> table{
        {"x", [](C) { return axis(0, 3); }},
        {"y", [](C) { return axis(1, 3); }},
        {"z", [](C) { return axis(2, 3); }},
        {"u", [](C) { return axis(0, 2); }},
        {"v", [](C) { return axis(1, 2); }},
        {"t", [](C) { return axis(3, 4); }},
        {"pi", [](C) { return Operand::number(std::numbers::pi); }},
        {"tau", [](C) { return Operand::number(2 * std::numbers::pi); }},
        {"true", [](C) { return Operand::number(1); }},
        {"yes", [](C) { return Operand::number(1); }},
        {"on", [](C) { return Operand::number(1); }},
        {"false", [](C) { return Operand::number(0); }},
        {"no", [](C) { return Operand::number(0); }},
        {"off", [](C) { return Operand::number(0); }},
        {"clock", [](C c) { return Operand::number(c.options.clock); }},
        {"clock_on", [](C c) { return Operand::number(c.options.clockOn); }},
        {"clock_delta", [](C c) { return Operand::number(clockDelta(c.options)); }},
        {"initial_clock", [](C) { return Operand::number(0); }},
        {"final_clock", [](C c) { return Operand::number(c.options.clockOn); }},
        {"frame_number", [](C c) { return Operand::number(c.options.frameNumber); }},
        {"initial_frame",
         [](C c) { return Operand::number(c.options.clockOn ? c.options.initialFrame : 0); }},
        {"final_frame", [](C c) { return Operand::number(c.options.clockOn ? c.options.finalFrame : 0); }},
        {"image_width", [](C c) { return Operand::number(c.options.imageWidth); }},
        {"image_height", [](C c) { return Operand::number(c.options.imageHeight); }},
        {"version", [](C c) { return Operand::number(c.languageVersion / 100.0); }},
        {"now", [](C) { return Operand::number(daysSince2000()); }},
        {"input_file_name", [](C c) { return Operand::text(c.options.file.filename().string()); }},
    };
    return table;
}

}  // namespace

bool isPredeclared(std::string_view word, const ParseContext& context) {
    return isWordFor(WordUse::predeclared, word) && !context.replacedConstants.contains(word);
}

std::optional<Operand> namedConstant(std::string_view word, const ParseContext& context) {
    if (!isWordFor(WordUse::constant, word)) return std::nullopt;
    if (isWordFor(WordUse::predeclared, word) && !isPredeclared(word, context)) return std::nullopt;
    return constants().at(word)(context);
}

}  // namespace isoscope
