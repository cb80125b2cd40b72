// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// A piece of a ray over which g = f - threshold (the other way round with positive polarity) lies between
/// two parallel lines: from lowAt... to highAt... at either end.
struct RayEnclosure {
    double begin = 0;
    double end = 0;
    double lowAtBegin = 0, highAtBegin = 0;
    double lowAtEnd = 0, highAtEnd = 0;

    /// The certain sign of g all over the piece: -1 or 1; 0 where it is not known.
    int sign() const;
};

/// Encloses g along the whole line with the affine forms of the certified root finder, in pieces that are
/// halved until the sign is certain, or their length is below the accuracy or a 4096th of the line; at most
/// `most` pieces. In order of t.
std::vector<RayEnclosure> encloseRay(const std::shared_ptr<const PreparedFunction>& function,
                                     const RootSettings& settings, const LineQuery& line,
                                     std::size_t most = 400);

}  // namespace isoscope
