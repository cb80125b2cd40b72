// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// All effects, a row each, in the order in which they run, and in which panels and statistics show them.
/// Each has its description, `effects::KIND`, where it is drawn (effect_description.h).
#define ISOSCOPE_EFFECTS(row)                                                                              \
    row(primaryRays) row(background) row(sky) row(surround) row(textures) row(directLight) row(projection) \
        row(shadows) row(clearShadows) row(areaLights) row(grain) row(rainbow) row(media) row(fog)         \
            row(transparency) row(refraction) row(reflection) row(focalBlur) row(cameraNormal)

namespace isoscope {

/// One kind of effect that a picture can need; RenderPlan says which a scene calls for.
enum class StageKind {
#define ISOSCOPE_ROW(kind) kind,
    ISOSCOPE_EFFECTS(ISOSCOPE_ROW)
#undef ISOSCOPE_ROW
};

/// How many there are.
constexpr std::size_t stageKindCount = 0
#define ISOSCOPE_ROW(kind) +1
    ISOSCOPE_EFFECTS(ISOSCOPE_ROW);
#undef ISOSCOPE_ROW

}  // namespace isoscope
