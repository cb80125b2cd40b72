// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/interior_list.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What changes for a ray that goes through a surface.
struct Crossing {
    InteriorList beyond;           ///< what it is in then
    bool leaves = false;           ///< the inside behind the surface is where it comes from
    double before = 1, after = 1;  ///< ior on either side

    /// How much slower light is on the far side.
    double ratio() const { return after / before; }
};

/// For a ray in `inside` at a surface with the material. What a ray is in that has entered several is the one
/// entered last.
inline Crossing crossingAt(const Scene& scene, const InteriorList& inside, const Material& material) {
    const auto ior = [&](const InteriorList& list) {
        return list.empty() ? 1 : scene.interiors[static_cast<std::size_t>(list.innermost())].ior;
    };
    Crossing crossing{inside};
    if (material.interior != noInterior) {
        crossing.leaves = inside.has(material.interior);
        if (crossing.leaves)
            crossing.beyond.leave(material.interior);
        else
            crossing.beyond.enter(material.interior);
    }
    crossing.before = ior(inside);
    crossing.after = ior(crossing.beyond);
    return crossing;
}

}  // namespace isoscope
