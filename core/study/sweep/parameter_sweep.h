// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/study/gradient/gradient_bracket.h"
#include "core/study/shape/solid_grid.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

/// The scene for a value of what is varied; null where there is none.
using SceneAt = std::function<std::shared_ptr<const Scene>(double value)>;

/// What a ParameterSweep measures.
struct SweepRequest {
    RenderRequest view;  ///< the camera, and the proportions of the picture
    SceneAt sceneAt;
    bool ownCamera = false;      ///< each scene is seen by its own camera instead
    std::size_t isosurface = 0;  ///< whose gradient and pieces are told
    std::vector<double> values;  ///< in the order they are wanted
    int width = 80;              ///< of the pictures whose evaluations are counted
    int cells = 48;              ///< of the grid in which pieces are counted
    std::uint64_t gradientBoxes = 20'000;
};

/// What one value costs and gives.
struct SweepPoint {
    double value = 0;
    bool known = false;  ///< there is a scene, with that isosurface; else nothing of the following
    /// Of the camera's rays, by RootFinder.
    std::array<double, 2> evaluationsPerPixel{};
    double hitShare = 0;  ///< of the pixels, that see something
    double gradientLow = 0;
    double gradientHigh = 0;  ///< proven: no gradient in the container is larger; may be infinite
    SolidCount solid;
};

/// `count` values from `from` to `to`, both included, evenly spread, in the logarithm where asked for and
/// both are positive. One value for a count of 1; none for ends that are not finite.
std::vector<double> sweepValues(double from, double to, int count, bool logarithmic = false);

/// Measures what a scene costs, how steep its function is and what it is made of, over values of one number.
/// All of it is counted, hence the same on every run and machine.
class ParameterSweep {
  public:
    explicit ParameterSweep(SweepRequest request) : request_(std::move(request)) {}

    /// The next value; nothing when all are done, or on a stop, which ends a picture in the making as well.
    std::optional<SweepPoint> next(std::stop_token stop = {}, int threads = 0);
    std::size_t done() const { return done_; }
    std::size_t size() const { return request_.values.size(); }

  private:
    SweepRequest request_;
    std::size_t done_ = 0;
};

/// For output, as comma separated values.
std::string sweepTableHeader();
std::string sweepTableLine(const SweepPoint& point);

}  // namespace isoscope
