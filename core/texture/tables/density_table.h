// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/function/point_table.h"
#include "core/texture/tables/sample_bounds.h"

namespace isoscope {

/// The numbers of a DF3 file: width, height and depth as 16-bit numbers, then samples of 8, 16 or 32 bits,
/// all with the high byte first; x runs fastest.
struct DensityVolume {
    std::array<int, 3> size{};
    std::vector<float> samples;  ///< 0 to 1
};

/// Nothing, and the reason in `problem`, when the file cannot be read or is damaged.
std::shared_ptr<const DensityVolume> readDensityFile(const std::filesystem::path& file, std::string& problem);

/// A volume in the unit cube, 0 outside, as POV-Ray 3.7 looks it up (measured).
class DensityTable : public PointTable {
  public:
    /// Between voxels: that of the point alone, 2 by 2 by 2, or 4 by 4 by 4 of them (which may leave 0 to 1;
    /// what is less than 0 is 0).
    enum class Interpolation { none, linear, cubic };

    DensityTable(std::shared_ptr<const DensityVolume> volume, Interpolation interpolation)
        : volume_(std::move(volume)), interpolation_(interpolation) {}
    DensityTable(const DensityTable&) = delete;
    DensityTable& operator=(const DensityTable&) = delete;

    double value(const std::array<double, 3>& point) const override;
    double high() const override { return interpolation_ == Interpolation::cubic ? 2 : 1; }
    bool hasRanges() const override { return true; }
    Straightness straightness(const std::array<Interval, 3>& box, const std::array<double, 3>& slope,
                              const std::array<double, 3>& errors) const override;

  private:
    const SampleBounds& bounds() const;
    Interval rangeIn(const std::array<Interval, 3>& box) const override;
    std::size_t along(std::size_t axis, int index) const;
    double sample(const std::array<int, 3>& index) const;
    double nearest(const std::array<double, 3>& point) const;
    double interpolated(const std::array<double, 3>& point, int first, int last) const;

    std::shared_ptr<const DensityVolume> volume_;
    Interpolation interpolation_;
    mutable std::once_flag bounded_;
    mutable std::optional<SampleBounds> bounds_;  ///< made when they are asked for
};

}  // namespace isoscope
