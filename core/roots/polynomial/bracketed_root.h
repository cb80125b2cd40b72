// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace isoscope {

/// A place where f changes sign between a and b, where it has the values fa and fb of opposite signs, to
/// within a few units in the last place: secants (Illinois), and a halving in every fourth step, so that a
/// step of f takes some 200 values and no more.
template <class F>
double bracketedRoot(const F& f, double a, double b, double fa, double fb) {
    constexpr int stepLimit = 220;
    int side = 0;
    for (int step = 0; step < stepLimit; ++step) {
        double t = (a * fb - b * fa) / (fb - fa);
        if (!(t > a && t < b) || step % 4 == 3) t = a + (b - a) / 2;
        if (!(t > a && t < b)) return t;
        const double value = f(t);
        if (value == 0) return t;
        if ((value > 0) == (fa > 0)) {
            a = t;
            fa = value;
            if (side == -1) fb /= 2;
            side = -1;
        } else {
            b = t;
            fb = value;
            if (side == 1) fa /= 2;
            side = 1;
        }
        if (b - a <= 4e-16 * std::abs(t)) break;
    }
    return a + (b - a) / 2;
}

}  // namespace isoscope
