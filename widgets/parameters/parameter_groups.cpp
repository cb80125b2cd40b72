// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_groups.h"

#include <map>
#include <set>

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
        place.key = QString("%1\n%2").arg(name).arg(seen[name]++);
        places.push_back(std::move(place));
    }
    return places;
}

}  // namespace isoscope
