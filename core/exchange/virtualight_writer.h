// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace isoscope {

/// The objects of a scene in VirtuaLight's notation, in world coordinates: spheres, boxes, cones, tori,
/// discs, superellipsoids, planes, quadrics and polynomials up to order 21, blobs, isosurfaces whose function
/// it can say, and set operations of them. A comment names each object that has no equivalent, for its shape
/// or because it is sheared; camera, lights and textures are left out, for docs/povray/virtualight.md does
/// not cover them.
std::string virtualightText(const Scene& scene);

}  // namespace isoscope
