// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/scene/color.h"
#include "core/scene/interior.h"
#include "core/scene/material.h"

namespace isoscope {

/// How scattered light depends on the angle of its turn, numbered as POV-Ray's scattering types.
enum class ScatteringKind { isotropic = 1, haze, murk, rayleigh, henyeyGreenstein };

/// What fills space, of an object or of the whole scene, and glows, swallows and scatters light: POV-Ray's
/// `media`. Colours are by unit of length.
struct Medium {
    Color absorption{}, emission{}, scattering{};
    ScatteringKind kind = ScatteringKind::isotropic;
    double eccentricity = 0;  ///< of ScatteringKind::henyeyGreenstein, between -1 and 1
    double extinction = 1;    ///< how much of what it scatters is taken from the light that goes through
    /// Factors of all three from place to place: only their pigments count, without filter and transmit. Null
    /// or some of them; media that were one before they were moved share them.
    std::shared_ptr<const std::vector<Material>> densities;
    Transform transform;  ///< what has moved the medium with its objects

    // How it is sampled, within the limits below; of several media on a way the first decides.
    bool adaptive = true;    ///< POV-Ray's method 3
    int intervals = 1;       ///< equal parts of a way
    int samples = 10;        ///< in each
    int refinements = 3;     ///< `aa_level`: how often a part may be halved
    double threshold = 0.1;  ///< `aa_threshold`: it is where the light differs by more
    static constexpr int samplesLimit = 1000, intervalsLimit = 100, refinementsLimit = 6;
    static constexpr int allSamplesLimit = 2000;  ///< of all intervals

    int line = 0;  ///< of the statement, for the plan's reasons

    /// How many densities there are.
    std::size_t layers() const { return densities ? densities->size() : 0; }
    /// Whether lights count.
    bool scatters() const { return scattering.red != 0 || scattering.green != 0 || scattering.blue != 0; }
};

/// Media that may fill one space together.
constexpr std::size_t mediaLimit = 10;

/// How many times as much light as by isotropic scattering goes on at an angle, given the cosine of that
/// between the direction of sight and the direction to the light (docs/povray/media.md, 3). Not finite
/// straight ahead where the eccentricity is 1.
double phaseFunction(const Medium& medium, double cosine);

/// The interior moved along with its object: its densities are.
Interior moved(Interior interior, const Transform& transform);

}  // namespace isoscope
