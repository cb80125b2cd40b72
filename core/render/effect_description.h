// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "core/render/effect_list.h"

namespace isoscope {

struct PictureParts;
struct RenderRequest;
struct Scene;

/// Whether a scene calls for an effect, and why or why not ("there is no fog").
struct EffectReason {
    bool needed;
    std::string words;
};

/// All that the renderer has to know of an effect. It stands in the source that draws it.
struct EffectDescription {
    const char* name;  ///< "direct light": as panels and statistics call it
    /// Looks at the scene alone.
    EffectReason (*reasonFor)(const Scene& scene);
    /// Adds what draws the effect, after those before it in the list; called only where the plan has it. Null
    /// where another effect draws this one.
    void (*build)(PictureParts& parts) = nullptr;
    /// Takes the effect out of a request whose plan does not have it; null where that has nothing of it.
    void (*takeOut)(RenderRequest& request) = nullptr;
    bool canBeLeftOut = true;      ///< false for what makes it a picture at all
    const char* leftOutNote = "";  ///< what follows its reason, where a picture without it may surprise
};

/// The description of each effect, under the name of its StageKind.
namespace effects {
#define ISOSCOPE_ROW(kind) extern const EffectDescription kind;
ISOSCOPE_EFFECTS(ISOSCOPE_ROW)
#undef ISOSCOPE_ROW
}  // namespace effects

/// All of them, by StageKind.
constexpr std::array<const EffectDescription*, stageKindCount> effectDescriptions{
#define ISOSCOPE_ROW(kind) &effects::kind,
    ISOSCOPE_EFFECTS(ISOSCOPE_ROW)
#undef ISOSCOPE_ROW
};
/// That of one kind.
inline const EffectDescription& descriptionOf(StageKind kind) {
    return *effectDescriptions[static_cast<std::size_t>(kind)];
}

}  // namespace isoscope
