// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/slider_names.h"

#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/language/sliders/value_preset.h"

namespace isoscope {

std::vector<SliderName> sliderNames(const std::vector<SceneParameter>& parameters) {
    std::map<std::string, std::map<int, int>> calls;
    std::map<std::tuple<std::string, int, std::string>, int> seen;
    std::set<std::string> declared;
    int declarations = 0;
    std::vector<SliderName> names;
    names.reserve(parameters.size());
    for (const SceneParameter& parameter : parameters) {
        auto& known = calls[parameter.group];
        const bool declares = parameter.group == "#declare";
        int statement = parameter.statement;
        if (declares) {
            // A name that is declared again would stand twice under one heading.
            if (!declared.insert(parameter.name).second) {
                declared = {parameter.name};
                ++declarations;
            }
            statement = declarations;
        }
        SliderName one;
        one.call = known.try_emplace(statement, static_cast<int>(known.size())).first->second;
        one.again = seen[{parameter.group, one.call, parameter.name}]++;
        const std::string call = one.call > 0 ? " (" + std::to_string(one.call + 1) + ")" : "";
        std::string name = declares ? parameter.name + call : parameter.group + call + ' ' + parameter.name;
        if (one.again > 0) name += " #" + std::to_string(one.again + 1);
        one.name = presetWord(name);
        names.push_back(std::move(one));
    }
    return names;
}

}  // namespace isoscope
