// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/own_colors.h"

#include <initializer_list>

namespace isoscope {

namespace {

struct Stop {
    double position, red, green, blue;
};

std::vector<MappedPigment::Entry> entriesOf(std::initializer_list<Stop> stops) {
    std::vector<MappedPigment::Entry> entries;
    for (const Stop& stop : stops)
        entries.push_back({stop.position, SolidPigment{{stop.red, stop.green, stop.blue}, {}}});
    return entries;
}

}  // namespace

std::vector<MappedPigment::Entry> ownColors(PatternKind kind) {
    switch (kind) {
        case PatternKind::agate:
            return entriesOf({{0, 1, 1, 1},
                              {0.5, 0.95, 0.75, 0.5},
                              {0.5, 0.9, 0.7, 0.5},
                              {0.6, 0.9, 0.7, 0.4},
                              {0.6, 1, 0.7, 0.4},
                              {1, 0.6, 0.3, 0}});
        case PatternKind::bozo:
            return entriesOf({{0.4, 1, 1, 1},
                              {0.4, 0, 1, 0},
                              {0.6, 0, 1, 0},
                              {0.6, 0, 0, 1},
                              {0.8, 0, 0, 1},
                              {0.8, 1, 0, 0},
                              {1, 1, 0, 0}});
        case PatternKind::mandel:
            return entriesOf({{0, 0, 0, 0},
                              {0.001, 0, 0, 0},
                              {0.001, 0, 1, 1},
                              {0.012, 1, 1, 0},
                              {0.015, 1, 0, 1},
                              {0.1, 0, 1, 1},
                              {1, 0, 1, 1}});
        case PatternKind::marble:
            return entriesOf({{0, 0.9, 0.8, 0.8}, {0.9, 0.9, 0.08, 0.08}, {0.9, 0, 0, 0}, {1, 0, 0, 0}});
        case PatternKind::radial:
            return entriesOf({{0, 0, 1, 1}, {1.0 / 3, 1, 1, 0}, {2.0 / 3, 1, 0, 1}, {1, 0, 1, 1}});
        case PatternKind::wood:
            return entriesOf({{0.6, 0.666, 0.312, 0.2}, {0.6, 0.4, 0.1333, 0.066}, {1, 0.4, 0.1333, 0.066}});
        case PatternKind::brick: return entriesOf({{0, 0.5, 0.5, 0.5}, {1, 0.6, 0.15, 0.15}});
        case PatternKind::checker: return entriesOf({{0, 0, 0, 1}, {1, 0, 1, 0}});
        case PatternKind::cubic:
        case PatternKind::triangular:
            return entriesOf(
                {{0, 1, 0, 0}, {1, 0, 1, 0}, {2, 0, 0, 1}, {3, 1, 1, 0}, {4, 0, 1, 1}, {5, 1, 0, 1}});
        case PatternKind::hexagon: return entriesOf({{0, 0, 0, 1}, {1, 0, 1, 0}, {2, 1, 0, 0}});
        case PatternKind::square: return entriesOf({{0, 1, 0, 0}, {1, 0, 1, 0}, {2, 0, 0, 1}, {3, 1, 1, 0}});
        default: return entriesOf({{0, 0, 0, 0}, {1, 1, 1, 1}});
    }
}

}  // namespace isoscope
