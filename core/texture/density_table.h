// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/function/point_table.h"

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
    /// Between voxels: that of the point alone, 2 by 2 by 2, or 4 by 4 by 4 of them (which may leave 0 to 1).
    enum class Interpolation { none, linear, cubic };

    DensityTable(std::shared_ptr<const DensityVolume> volume, Interpolation interpolation)
        : volume_(std::move(volume)), interpolation_(interpolation) {}

    double value(const std::array<double, 3>& point) const override;
    double low() const override { return interpolation_ == Interpolation::cubic ? -1 : 0; }
    double high() const override { return interpolation_ == Interpolation::cubic ? 2 : 1; }

  private:
    double sample(std::array<int, 3> index) const;
    double nearest(const std::array<double, 3>& point) const;
    double interpolated(const std::array<double, 3>& point, int first, int last) const;

    std::shared_ptr<const DensityVolume> volume_;
    Interpolation interpolation_;
};

}  // namespace isoscope
