// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_groups.h"

#include <map>
#include <set>

#include "core/language/sliders/value_preset.h"

namespace isoscope {

std::vector<ParameterPlace> parameterPlaces(const std::vector<SceneParameter>& parameters) {
    std::map<std::string, std::map<int, int>> calls;
    std::map<QString, int> seen;
    std::set<std::string> declared;
    int declarations = 0;
    std::vector<ParameterPlace> places;
    places.reserve(parameters.size());
    for (const SceneParameter& parameter : parameters) {
        auto& known = calls[parameter.group];
        ParameterPlace place;
        place.group = QString::fromStdString(parameter.group);
        int statement = parameter.statement;
        if (parameter.group == "#declare") {
            // A name that is declared again would stand twice under one heading.
            if (!declared.insert(parameter.name).second) {
                declared = {parameter.name};
                ++declarations;
            }
            statement = declarations;
        }
        place.call = known.try_emplace(statement, static_cast<int>(known.size())).first->second;
        const QString name = QString("%1\n%2\n%3")
                                 .arg(place.group)
                                 .arg(place.call)
                                 .arg(QString::fromStdString(parameter.name));
        const int again = seen[name]++;
        place.key = QString("%1\n%2").arg(name).arg(again);
        const QString own = QString::fromStdString(parameter.name);
        const QString call = place.call > 0 ? QString(" (%1)").arg(place.call + 1) : QString();
        place.presetName = parameter.group == "#declare" ? own + call : place.group + call + ' ' + own;
        if (again > 0) place.presetName += QString(" #%1").arg(again + 1);
        place.presetName = QString::fromStdString(presetWord(place.presetName.toStdString()));
        places.push_back(std::move(place));
    }
    return places;
}

}  // namespace isoscope
