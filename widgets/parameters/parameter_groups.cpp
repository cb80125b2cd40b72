// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_groups.h"

#include "core/language/sliders/slider_names.h"

namespace isoscope {

std::vector<ParameterPlace> parameterPlaces(const std::vector<SceneParameter>& parameters) {
    const std::vector<SliderName> names = sliderNames(parameters);
    std::vector<ParameterPlace> places;
    places.reserve(parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        ParameterPlace place;
        place.group = QString::fromStdString(parameters[i].group);
        place.call = names[i].call;
        place.key = QString("%1\n%2\n%3\n%4")
                        .arg(place.group)
                        .arg(place.call)
                        .arg(QString::fromStdString(parameters[i].name))
                        .arg(names[i].again);
        place.presetName = QString::fromStdString(names[i].name);
        places.push_back(std::move(place));
    }
    return places;
}

}  // namespace isoscope
