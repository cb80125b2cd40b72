// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/illuminating_areas.h"

#include "core/render/light/light_grid.h"

namespace isoscope {

namespace {

constexpr int mostLights = 1024;

bool illuminatesFromArea(const LightSource& light) {
    return light.area && light.area->illumination && !light.area->orient &&
           light.area->columns * light.area->rows <= mostLights;
}

}  // namespace

std::vector<LightSource> illuminatingLights(const LightSource& light) {
    std::vector<LightSource> lights;
    if (!illuminatesFromArea(light)) return lights;
    LightSource even = light;
    even.area->jitter = false;
    const LightGrid grid(even, light.location);
    const int columns = light.area->columns, rows = light.area->rows;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            LightSource one = light;
            one.area.reset();
            one.location = grid.place(column, row);
            // What it points at is as far beside.
            one.pointAt = light.pointAt + (one.location - light.location);
            one.color = light.color * (1.0 / (columns * rows));
            lights.push_back(std::move(one));
        }
    return lights;
}

}  // namespace isoscope
