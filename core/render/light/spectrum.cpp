// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {

namespace {

constexpr std::size_t steps = 40;

/// What of white lies behind place k / steps.
const std::array<glm::dvec3, steps + 1> behind{
    {{0.9938, 1.0000, 0.9962}, {0.9896, 1.0000, 0.9805}, {0.9833, 1.0000, 0.9551}, {0.9758, 1.0000, 0.9210},
     {0.9680, 1.0000, 0.8790}, {0.9612, 1.0000, 0.8298}, {0.9563, 1.0000, 0.7752}, {0.9543, 1.0000, 0.7159},
     {0.9543, 1.0000, 0.6530}, {0.9543, 1.0000, 0.5875}, {0.9543, 1.0000, 0.5208}, {0.9543, 1.0000, 0.4537},
     {0.9543, 1.0000, 0.3872}, {0.9543, 1.0000, 0.3227}, {0.9543, 0.9912, 0.2611}, {0.9543, 0.9704, 0.2034},
     {0.9543, 0.9388, 0.1506}, {0.9543, 0.8969, 0.1043}, {0.9543, 0.8469, 0.0652}, {0.9543, 0.7900, 0.0341},
     {0.9543, 0.7276, 0.0122}, {0.9543, 0.6606, 0.0013}, {0.9530, 0.5906, 0.0000}, {0.9416, 0.5190, 0.0000},
     {0.9167, 0.4470, 0.0000}, {0.8791, 0.3761, 0.0000}, {0.8315, 0.3075, 0.0000}, {0.7755, 0.2425, 0.0000},
     {0.7124, 0.1822, 0.0000}, {0.6436, 0.1287, 0.0000}, {0.5712, 0.0827, 0.0000}, {0.4967, 0.0455, 0.0000},
     {0.4216, 0.0183, 0.0000}, {0.3479, 0.0034, 0.0000}, {0.2768, 0.0000, 0.0000}, {0.2101, 0.0000, 0.0000},
     {0.1493, 0.0000, 0.0000}, {0.0966, 0.0000, 0.0000}, {0.0531, 0.0000, 0.0000}, {0.0204, 0.0000, 0.0000},
     {0.0000, 0.0000, 0.0000}}};

glm::dvec3 lightBehind(double place) {
    const double at = std::clamp(place, 0.0, 1.0) * steps;
    const auto k = std::min(static_cast<std::size_t>(at), steps - 1);
    const double part = at - static_cast<double>(k);
    return (1 - part) * behind[k] + part * behind[k + 1];
}

}  // namespace

glm::dvec3 spectralColor(double from, double to) { return lightBehind(from) - lightBehind(to); }

double spectralIor(double ior, double dispersion, double place) {
    return dispersion > 0 ? ior * std::pow(dispersion, 0.5 - place) : ior;
}

}  // namespace isoscope
