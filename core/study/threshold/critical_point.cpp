// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/threshold/critical_point.h"

namespace isoscope {

std::string_view name(CriticalKind kind) {
    switch (kind) {
        case CriticalKind::minimum: return "minimum";
        case CriticalKind::saddle1: return "saddle-1";
        case CriticalKind::saddle2: return "saddle-2";
        case CriticalKind::maximum: return "maximum";
        case CriticalKind::saddle: return "saddle";
        case CriticalKind::unknown: break;
    }
    return "unknown";
}

std::string_view name(SuspicionReason reason) {
    switch (reason) {
        case SuspicionReason::none: break;
        case SuspicionReason::unfinished: return "unfinished";
        case SuspicionReason::wall: return "wall";
        case SuspicionReason::flat: return "flat";
        case SuspicionReason::degenerate: return "degenerate";
        case SuspicionReason::kink: return "kink";
        case SuspicionReason::steep: return "steep";
    }
    return "";
}

std::string_view meaning(CriticalKind kind, bool positivePolarity) {
    // Where the solid is above the threshold, the function upside down is what it is below.
    if (positivePolarity) {
        constexpr CriticalKind reversed[] = {CriticalKind::maximum, CriticalKind::saddle2,
                                             CriticalKind::saddle1, CriticalKind::minimum,
                                             CriticalKind::saddle,  CriticalKind::unknown};
        kind = reversed[static_cast<std::size_t>(kind)];
    }
    switch (kind) {
        case CriticalKind::minimum: return "a piece appears";
        case CriticalKind::saddle1: return "two pieces join or a tunnel opens";
        case CriticalKind::saddle2: return "a tunnel closes or a hollow is shut in";
        case CriticalKind::maximum: return "a hollow is filled";
        case CriticalKind::saddle: return "pieces join, or a tunnel opens or closes";
        case CriticalKind::unknown: break;
    }
    return "the solid may change its form";
}

}  // namespace isoscope
