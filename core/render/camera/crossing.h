// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/light_path.h"
#include "core/render/light/spectrum.h"
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

/// For a ray of this path at a surface with the material. What a ray is in that has entered several is the
/// one entered last.
inline Crossing crossingAt(const Scene& scene, const LightPath& path, const Material& material) {
    const auto ior = [&](const InteriorList& list) {
        if (list.empty()) return 1.0;
        const Interior& interior = scene.interiors[static_cast<std::size_t>(list.innermost())];
        return path.dispersed ? spectralIor(interior.ior, interior.dispersion, path.spectralPlace)
                              : interior.ior;
    };
    const InteriorList& inside = path.inside;
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
