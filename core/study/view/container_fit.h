// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/scene/scene.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/study/view/isosurface_reach.h"
#include "core/text/text_change.h"

namespace isoscope {

/// Smaller containers that show the same of an isosurface, proven: POV-Ray looks for roots only inside, and
/// takes about as long as there is room. Their numbers are rounded outwards to about three digits, so that
/// they can stand in a text; sides of a box that cut the surface stay what they are.
struct ContainerFit {
    bool empty = false;  ///< there is nothing to be seen in the present container
    std::optional<ContainerBox> box;
    std::optional<ContainerSphere> sphere;

    /// The one with the least volume; nothing where none is smaller than the present one.
    std::optional<Container> best() const;
};

/// Enough boxes for balls, whose surface is as far from the middle all over.
constexpr ReachSettings containerReach{0.003, 60'000};

/// In the coordinates of the surface. A stop gives containers that are as true, and larger.
ContainerFit fitContainer(const std::shared_ptr<const Isosurface>& surface,
                          std::span<const double> parameters, const ReachSettings& settings = containerReach,
                          const std::stop_token& stop = {});

/// What gives isosurface `number` of the scene that container: another content between the braces of its
/// `contained_by { }`, or such an item behind its function where it has none. Nothing where the statement
/// does not stand in the user's own text (file 0), or makes several isosurfaces.
std::optional<TextChange> containerChange(const Scene& scene, const SourceLibrary& sources,
                                          std::size_t number, const Container& container);

/// The scene with that container for one of its isosurfaces; everything else is shared.
std::shared_ptr<const Scene> sceneWithContainer(const Scene& scene, const Isosurface& surface,
                                                const Container& container);

/// Of all of it, in cubic units of the coordinates of the surface.
double volumeOf(const Container& container);

/// As it stands between the braces of `contained_by { }`.
std::string containerText(const Container& container);

}  // namespace isoscope
