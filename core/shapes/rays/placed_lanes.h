// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// `to` becomes the rays as Transform::toObject sees them, in vectors, to the bit.
void moveToObject(const Transform& transform, const RayBatch& rays, RayBatch& to);

/// The normals of hits that come before `before`, which goes on for LineColumns::padding entries behind the
/// last, become those in outer coordinates: unitNormal() of Transform::normal, to the bit.
void turnNormals(const Transform& transform, const double* before, HitBatch& hits);

}  // namespace isoscope
