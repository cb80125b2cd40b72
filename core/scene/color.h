// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// A colour of the scene, in the space that GlobalSettings::assumedGamma names, with POV-Ray's two kinds of
/// transparency: what `filter` lets through is tinted, what `transmit` lets through is not.
struct Color {
    double red = 0, green = 0, blue = 0, filter = 0, transmit = 0;

    friend bool operator==(const Color&, const Color&) = default;
};

inline Color operator+(const Color& a, const Color& b) {
    return {a.red + b.red, a.green + b.green, a.blue + b.blue, a.filter + b.filter, a.transmit + b.transmit};
}
inline Color operator*(const Color& a, double k) {
    return {a.red * k, a.green * k, a.blue * k, a.filter * k, a.transmit * k};
}

}  // namespace isoscope
