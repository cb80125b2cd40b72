// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <utility>
#include <vector>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/spread_points.h"

namespace isoscope {

/// What is in the container for all values of a piece of a parameter.
enum class SurfacePresence : std::uint8_t {
    surface,  ///< proven: the function goes through the threshold (or jumps over it) in the container
    outside,  ///< proven: all of the container is outside: nothing is seen
    inside,   ///< proven: all of the container is inside: only its wall is seen
    unknown,
};

/// For output: "surface", "outside", "inside", "unknown".
std::string_view name(SurfacePresence presence);

/// From `low` to `high`, both included.
struct PresencePiece {
    double low = 0;
    double high = 0;
    SurfacePresence presence = SurfacePresence::unknown;
};

/// What is known over a range of a parameter.
struct ParameterRange {
    std::vector<PresencePiece> pieces;  ///< ascending, without gaps, no two neighbours alike
    std::uint64_t boxes = 0;            ///< enclosures that this took

    /// Around all values that no enclosure excludes; nothing where all are excluded.
    std::optional<std::pair<double, double>> shown() const;
    /// Of shown(), by length, that is proven to have a surface; 0 without.
    double provenShare() const;
    /// What is known at a value; unknown outside of the pieces.
    SurfacePresence at(double value) const;
};

/// For which values there is any of several isosurfaces that have the same number: the ranges of each.
ParameterRange united(std::span<const ParameterRange> ranges);

/// When a search ends, at the latest.
struct RangeSettings {
    double resolution = 1.0 / 256;        ///< of the range: shorter pieces are not halved
    std::uint64_t boxLimit = 400'000;     ///< enclosures in all
    std::uint64_t boxesOfPiece = 16'000;  ///< enclosures for one piece of the parameter
};

/// Finds the values of one number for which an isosurface is in its container: of a parameter of its
/// function, or of its threshold. Pieces of the range are halved until the function's enclosure over the
/// container and the piece excludes the threshold, or two places have it on different sides for the whole
/// piece. What is proven holds for the function as IntervalEvaluator understands it. Not for several threads
/// at once.
class RangeStudy {
  public:
    /// What varies when it is no parameter.
    static constexpr int threshold = -1;

    /// `slot`: of the parameter that varies, or `threshold`. The others are those of `parameters`.
    RangeStudy(std::shared_ptr<const Isosurface> surface, std::span<const double> parameters, int slot,
               RangeSettings settings = {});

    /// From `low` to `high`, finite and in order, else nothing is known. A stop leaves what is not known
    /// unknown.
    ParameterRange run(double low, double high, std::stop_token stop = {});
    /// At these values alone, for numbers that are whole: one piece each, joined where they are alike.
    ParameterRange run(std::span<const double> values, std::stop_token stop = {});

  private:
    struct Extreme {
        double value = 0;
        glm::dvec3 place{0};
    };

    void look(double low, double high, double finest, ParameterRange& range, const std::stop_token& stop);
    SurfacePresence presenceOver(double low, double high, const std::stop_token& stop);
    bool signsDiffer(double low, double high);
    void sample(double value);
    void improve(Extreme& extreme, double sign);
    double signedValue(const glm::dvec3& place);
    Interval enclosure(const std::array<Interval, 3>& place, double low, double high);
    bool keepsSign(int sign, double low, double high, const std::stop_token& stop);

    std::shared_ptr<const Isosurface> surface_;
    std::vector<double> parameters_;
    int slot_;
    RangeSettings settings_;
    GradientDomain domain_;
    SpreadPoints points_;
    std::optional<IntervalEvaluator> intervals_;
    std::optional<PointEvaluator> values_;
    double level_ = 0;  ///< the threshold that values_ are compared with
    Extreme lowest_, highest_;
    std::uint64_t boxes_ = 0;
};

}  // namespace isoscope
