// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/hit.h"

namespace isoscope {

const char* name(HitKind kind) {
    switch (kind) {
        case HitKind::crossing: return "crossing";
        case HitKind::container: return "container";
        case HitKind::jump: return "jump";
        case HitKind::pole: return "pole";
    }
    return "unknown";
}

}  // namespace isoscope
