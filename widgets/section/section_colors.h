// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <QPalette>

namespace isoscope {

/// The colours of a cross-section: blue where f is below the threshold, orange above, the window's own tone
/// between. The pair is told apart with every common kind of colour blindness.
class SectionColors {
  public:
    using Rgb = std::array<std::uint8_t, 3>;
    static constexpr int steps = 256;

    explicit SectionColors(const QPalette& palette);

    /// `value` from -1 (inside) to 1 (outside); beyond is clamped. NaN gives the hatch's ground.
    Rgb color(double value) const;
    /// The same outside the container: mixed with the background.
    Rgb faded(const Rgb& color) const;
    /// Hatched at pixel (column, row).
    Rgb undefined(int column, int row) const;

    Rgb background{}, line{}, outline{}, text{};

  private:
    std::array<Rgb, steps> table_{};
    /// What each level of each channel fades to: a section has hundreds of thousands of them.
    std::array<std::array<std::uint8_t, 256>, 3> faded_{};
    Rgb hatch_{}, ground_{};
};

}  // namespace isoscope
