// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/varied_number.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "core/exchange/read_scene.h"
#include "core/text/number_format.h"
#include "core/text/text_change.h"

namespace isoscope {

namespace {

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

int lineOf(const ParseResult& parsed, const SceneParameter& parameter) {
    return (*parsed.sources)[parameter.range.file].position(parameter.range.begin).line;
}

bool canVary(const SceneParameter& parameter) { return parameter.range.file == 0 && !parameter.expression; }

}  // namespace

FoundNumber findNumber(const ParseResult& parsed, std::string_view name, int line) {
    const std::string wanted = lowered(name);
    std::vector<std::size_t> found;
    const std::vector<SceneParameter>& parameters = parsed.scene->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const SceneParameter& one = parameters[i];
        if (!canVary(one) || (line > 0 && lineOf(parsed, one) != line)) continue;
        if (lowered(one.name) == wanted || lowered(one.group + ' ' + one.name) == wanted) found.push_back(i);
    }
    if (found.size() == 1) return {found.front(), {}};
    if (found.empty()) {
        std::string known;
        for (const SceneParameter& one : parameters)
            if (canVary(one) && known.size() < 200)
                known += (known.empty() ? "" : ", ") +
                         (one.group == "#declare" ? one.name : one.group + ' ' + one.name);
        return {{},
                "no number is called `" + std::string(name) + "`" +
                    (known.empty() ? "" : "; there are: " + known)};
    }
    std::string lines;
    for (const std::size_t i : found)
        lines += (lines.empty() ? "" : ", ") + std::to_string(lineOf(parsed, parameters[i]));
    return {{}, "several numbers are called `" + std::string(name) + "`, in the lines " + lines};
}

std::shared_ptr<const Scene> sceneWithNumbers(const ParseResult& parsed,
                                              std::span<const NumberSetting> values) {
    const std::vector<SceneParameter>& parameters = parsed.scene->parameters;
    const bool allSlots = std::ranges::all_of(values, [&](const NumberSetting& setting) {
        const int slot = parameters[setting.parameter].slot;
        return slot >= 0 && static_cast<std::size_t>(slot) < parsed.scene->parameterTable->size();
    });
    if (allSlots) {
        auto table = std::make_shared<std::vector<double>>(*parsed.scene->parameterTable);
        auto scene = std::make_shared<Scene>(*parsed.scene);
        for (const NumberSetting& setting : values)
            (*table)[static_cast<std::size_t>(parameters[setting.parameter].slot)] = setting.value;
        scene->parameterTable = std::move(table);
        return scene;
    }
    std::vector<TextChange> changes;
    for (const NumberSetting& setting : values) {
        const SceneParameter& one = parameters[setting.parameter];
        const std::string number = shortestNumber(setting.value);
        changes.push_back({one.range, one.implied ? "\n  " + one.name + ' ' + number + ' ' : number});
    }
    const ParseResult changed = readScene(changedText(std::string((*parsed.sources)[0].text()), changes),
                                          withoutStop(parsed.options));
    return changed.ok() ? changed.scene : nullptr;
}

}  // namespace isoscope
