// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/transparency.h"

#include <algorithm>

#include "core/texture/image_map.h"

namespace isoscope {

namespace {

bool hasClearSample(const ImageMap& image) {
    if (image.once) return true;
    return image.samples && std::any_of(image.samples->begin(), image.samples->end(),
                                        [](const ImageMap::Sample& s) { return s[3] != 0 || s[4] != 0; });
}

}  // namespace

bool mayLetLightThrough(const Pigment& pigment) {
    if (const auto* solid = std::get_if<SolidPigment>(&pigment))
        return solid->color.filter != 0 || solid->color.transmit != 0;
    const MappedPigment& mapped = *std::get<std::shared_ptr<const MappedPigment>>(pigment);
    if (mapped.image) return hasClearSample(*mapped.image);
    return std::any_of(mapped.entries.begin(), mapped.entries.end(),
                       [](const MappedPigment::Entry& entry) { return mayLetLightThrough(entry.pigment); });
}

bool mayLetLightThrough(const Material& material) {
    const bool top = material.map
                         ? std::any_of(material.map->entries.begin(), material.map->entries.end(),
                                       [](const auto& entry) { return mayLetLightThrough(entry.material); })
                         : mayLetLightThrough(material.pigment);
    return top && std::all_of(material.below.begin(), material.below.end(),
                              [](const Material& layer) { return mayLetLightThrough(layer); });
}

bool mayReflect(const Material& material) {
    const bool top = material.map ? std::any_of(material.map->entries.begin(), material.map->entries.end(),
                                                [](const auto& entry) { return mayReflect(entry.material); })
                                  : material.finish.reflects();
    return top || std::any_of(material.below.begin(), material.below.end(),
                              [](const Material& layer) { return mayReflect(layer); });
}

}  // namespace isoscope
