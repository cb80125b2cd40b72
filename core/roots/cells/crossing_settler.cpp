// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/crossing_settler.h"

#include <array>

namespace isoscope {

std::span<const FirstRoots::Other> CrossingSettler::run(const LineColumns& lines,
                                                        std::span<const NewtonPolish::Unsettled> crossings,
                                                        const SimplifiedTape& tape) {
    rough_.clear();
    queries_.clear();
    lists_.clear();
    found_.clear();
    for (const NewtonPolish::Unsettled& crossing : crossings) {
        rough_.push_back({rough_.size(), 0, crossing.low, crossing.high, crossing.steepness, 1});
        queries_.push_back(lines[crossing.line]);
        lists_.push_back({{crossing.low + (crossing.high - crossing.low) / 2, RootKind::crossing}});
    }
    polish_.run(rough_, queries_, lists_, &tape);
    for (std::size_t k = 0; k < crossings.size(); ++k) {
        found_.push_back({crossings[k].line, lists_[k].front()});
        if (found_[k].root.kind == RootKind::crossing) findNormal(queries_[k], tape, found_[k]);
    }
    return found_;
}

void CrossingSettler::findNormal(const LineQuery& line, const SimplifiedTape& tape,
                                 FirstRoots::Other& found) {
    const glm::dvec3 place = line.origin + found.root.t * line.direction;
    std::array<ValueAndGradient, 1> at;
    gradients_.evaluate({&place.x, 1}, {&place.y, 1}, {&place.z, 1}, at, tape);
    const auto& [dx, dy, dz] = at[0].gradient;
    found.hasNormal = dx != 0 || dy != 0 || dz != 0;
    found.normal = (settings_.positivePolarity ? -1.0 : 1.0) * glm::dvec3(dx, dy, dz);
}

}  // namespace isoscope
