// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"
#include "widgets/section/section_field.h"

namespace isoscope {

/// A plane across the container of an isosurface, in the coordinates of its function.
struct SectionRequest {
    std::shared_ptr<const Isosurface> surface;
    std::shared_ptr<const std::vector<double>> parameterTable;
    SectionPlane plane;
    int resolution = 256;  ///< samples along the longer side, at least 2
    SectionQuantity quantity = SectionQuantity::value;
};

/// Samples the plane. Empty without a surface, for a container that is not finite, and when stopped.
SectionField sampleSection(const SectionRequest& request, std::stop_token stop = {});

}  // namespace isoscope
