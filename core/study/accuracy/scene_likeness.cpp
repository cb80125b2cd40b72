// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/scene_likeness.h"

#include "core/study/gradient/function_likeness.h"

namespace isoscope {

namespace {

bool sameSettings(StudiedSetting setting, const IsosurfaceSettings& a, const IsosurfaceSettings& b) {
    const bool accuracy = setting == StudiedSetting::accuracy || a.accuracy == b.accuracy;
    const bool maxGradient = setting == StudiedSetting::maxGradient || a.maxGradient == b.maxGradient;
    return accuracy && maxGradient && a.threshold == b.threshold && a.open == b.open &&
           a.maxTrace == b.maxTrace && a.positivePolarity == b.positivePolarity && a.evaluate == b.evaluate &&
           sameContainer(a.container, b.container);
}

}  // namespace

bool sameButFor(StudiedSetting setting, const Scene& a, const Scene& b) {
    if (a.objects.size() != b.objects.size() || a.isosurfaces.size() != b.isosurfaces.size()) return false;
    for (std::size_t i = 0; i < a.isosurfaces.size(); ++i) {
        const auto &one = a.isosurfaces[i].shape, &other = b.isosurfaces[i].shape;
        if (!one || !other) return false;
        if (!sameSettings(setting, one->settings(), other->settings())) return false;
        if (a.isosurfaces[i].transform.forward() != b.isosurfaces[i].transform.forward()) return false;
        if (!sameFunction(*one->tape(), *a.parameterTable, *other->tape(), *b.parameterTable)) return false;
    }
    return true;
}

}  // namespace isoscope
