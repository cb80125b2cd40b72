// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/parameter_collector.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/language/expressions/slider_range.h"

namespace isoscope {

namespace {

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Parameters that count something or switch it: whole numbers only.
bool countsOrSwitches(const Builtin& builtin, int index) {
    const std::string& name = builtin.parameters[static_cast<std::size_t>(index)].name;
    const auto has = [&](const char* part) { return name.find(part) != std::string::npos; };
    return has("Octaves") || has("Switch") || has("Number of") || has("Generator");
}

SliderRange rangeFor(ParameterRole role, double value) {
    switch (role) {
        case ParameterRole::accuracy: return {1e-6, 1};
        case ParameterRole::maxGradient: return {0.1, 1000};
        default: return symmetricRangeAround(value);
    }
}

}  // namespace

std::optional<double> literalValue(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    double sign = 1;
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
        if (text.front() == '-') sign = -1;
        text.remove_prefix(1);
        while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    }
    if (text.empty() || !(std::isdigit(static_cast<unsigned char>(text.front())) || text.front() == '.'))
        return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return sign * value;
}

ParameterCollector::Added ParameterCollector::add(SceneParameter parameter) {
    parameter.statement = context_.statement;
    const auto index = static_cast<int>(context_.parameters.size());
    const auto [known, isNew] = context_.parameterAt.try_emplace(parameter.range.begin, index);
    if (!isNew) return {context_.parameters[static_cast<std::size_t>(known->second)], false};
    if (std::isfinite(parameter.value)) {
        parameter.minimum = std::min(parameter.minimum, parameter.value);
        parameter.maximum = std::max(parameter.maximum, parameter.value);
    }
    context_.parameters.push_back(std::move(parameter));
    return {context_.parameters.back(), true};
}

int ParameterCollector::addArgument(const Builtin& builtin, int index, double value,
                                    const SourceRange& range) {
    if (!fromUser(range) || !std::isfinite(value)) return -1;
    const BuiltinParameter& facts = builtin.parameters[static_cast<std::size_t>(index)];
    SceneParameter parameter;
    parameter.role = ParameterRole::argument;
    parameter.name = facts.name;
    parameter.group = builtin.name;
    parameter.value = value;
    parameter.minimum = facts.minimum;
    parameter.maximum = facts.maximum;
    parameter.integral = countsOrSwitches(builtin, index) && value == std::floor(value);
    parameter.range = range;
    const auto [added, isNew] = add(std::move(parameter));
    if (isStructural(builtin, index)) {
        // A macro may use the literal for another built-in too, where it has a slot; moving it now needs a
        // parse.
        added.slot = -1;
    } else if (isNew) {
        added.slot = static_cast<int>(context_.parameterTable.size());
        context_.parameterTable.push_back(value);
    }
    return added.slot;
}

void ParameterCollector::addArgumentExpression(const Builtin& builtin, int index, const SourceRange& range) {
    if (!fromUser(range)) return;
    const BuiltinParameter& facts = builtin.parameters[static_cast<std::size_t>(index)];
    SceneParameter parameter;
    parameter.role = ParameterRole::argument;
    parameter.name = facts.name;
    parameter.group = builtin.name;
    parameter.value = facts.defaultValue;
    parameter.minimum = facts.minimum;
    parameter.maximum = facts.maximum;
    parameter.range = range;
    parameter.expression = true;
    parameter.text = std::string(context_.sources.slice(range));
    add(std::move(parameter));
}

SceneParameter ParameterCollector::setting(ParameterRole role, const std::string& name, double value,
                                           const SourceRange& range) {
    SceneParameter parameter;
    parameter.role = role;
    parameter.name = name;
    parameter.group = "isosurface";
    parameter.value = value;
    const SliderRange slider = rangeFor(role, value);
    parameter.minimum = slider.minimum;
    parameter.maximum = slider.maximum;
    parameter.logarithmic = role == ParameterRole::accuracy || role == ParameterRole::maxGradient;
    parameter.range = range;
    return parameter;
}

void ParameterCollector::addSetting(ParameterRole role, const std::string& name, double value,
                                    const SourceRange& range) {
    if (!fromUser(range)) return;
    SceneParameter parameter = setting(role, name, value, range);
    const std::string_view text = context_.sources.slice(range);
    parameter.expression = !literalValue(text);
    if (parameter.expression) parameter.text = std::string(text);
    add(std::move(parameter));
}

void ParameterCollector::addImpliedSetting(ParameterRole role, const std::string& name, double value,
                                           const SourceRange& place) {
    // A second reading in a loop is the same setting.
    if (place.file != 0 || !context_.impliedAt.emplace(role, place.end).second) return;
    SceneParameter parameter = setting(role, name, value, {0, place.end, place.end});
    parameter.implied = true;
    parameter.statement = context_.statement;
    context_.parameters.push_back(std::move(parameter));
}

void ParameterCollector::addLiteral(const Label& label, const std::string& name, const SourceRange& range) {
    std::string_view text = context_.sources.slice(range);
    SourceRange trimmed = range;
    while (trimmed.begin < trimmed.end && isBlank(text.front())) text.remove_prefix(1), ++trimmed.begin;
    while (trimmed.begin < trimmed.end && isBlank(text.back())) text.remove_suffix(1), --trimmed.end;
    if (const std::optional<double> value = literalValue(text)) {
        SceneParameter parameter;
        parameter.role = label.role;
        parameter.name = name;
        parameter.group = label.group;
        parameter.value = *value;
        const SliderRange slider = symmetricRangeAround(*value);
        parameter.minimum = name.ends_with("radius") ? 0 : slider.minimum;
        parameter.maximum = slider.maximum;
        parameter.range = trimmed;
        add(std::move(parameter));
    }
}

void ParameterCollector::addLiterals(const Label& label, const SourceRange& range) {
    if (!fromUser(range)) return;
    const std::string_view text = context_.sources.slice(range);
    if (text.empty() || text.front() != '<') return addLiteral(label, label.name, range);
    const auto commas = std::count(text.begin(), text.end(), ',');
    if (text.back() != '>' || commas < 1 || commas > 3 || std::count(text.begin(), text.end(), '<') != 1)
        return;
    std::size_t begin = 1;
    for (const char* axis : {" x", " y", " z", " w"}) {
        const std::size_t end = std::min(text.find(',', begin), text.size() - 1);
        addLiteral(label, label.name + axis,
                   {0, range.begin + static_cast<std::uint32_t>(begin),
                    range.begin + static_cast<std::uint32_t>(end)});
        if (end + 1 >= text.size()) break;
        begin = end + 1;
    }
}

void ParameterCollector::addContainerNumbers(const std::string& name, const SourceRange& range) {
    addLiterals({ParameterRole::container, "contained_by", name}, range);
}

void ParameterCollector::addShapeNumbers(const std::string& shape, const std::string& name,
                                         const SourceRange& range) {
    addLiterals({ParameterRole::other, shape, name}, range);
}

void ParameterCollector::addShapeCount(const std::string& shape, const std::string& name, int least, int most,
                                       const SourceRange& range) {
    if (!fromUser(range)) return;
    const std::optional<double> value = literalValue(context_.sources.slice(range));
    if (!value) return;
    SceneParameter parameter;
    parameter.role = ParameterRole::other;
    parameter.name = name;
    parameter.group = shape;
    parameter.value = *value;
    parameter.integral = true;
    parameter.minimum = least;
    parameter.maximum = std::clamp(std::ceil(symmetricRangeAround(*value).maximum),
                                   static_cast<double>(least), static_cast<double>(most));
    parameter.range = range;
    add(std::move(parameter));
}

}  // namespace isoscope
