// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace isoscope {

/// A `Builtin` as data of the program: the facts of spec/functions.csv, and the formula as one line of text.
/// In the formulas, limit(t) is t kept within +-10 and limit(t, L) within +-L; lathe(switch, offset, angle)
/// is (x, y) or the turned half-plane; r, rho, th, phi are the usual lengths and angles of the point p.
struct BuiltinFacts {
    /// As BuiltinParameter; one without a name ends the list.
    struct Parameter {
        const char* name = nullptr;
        double defaultValue = 0, minimum = 0, maximum = 0;
    };

    const char* name = "";
    int id = -1;
    Parameter parameters[10] = {};  ///< ends at the first without a name
    int pointArguments = 3;
    const char* formula = "";
    double threshold = 0;
    const char* container = "";
    double maxGradient = 1.1;
    bool invert = false;
    const char* kind = "builtin";

    /// What Showing says where the settings above would cut the surface off, hide it or lose parts of it;
    /// empty and 0: those above.
    struct Shown {
        const char* expression = "";
        const char* container = "";
        double maxGradient = 0;
        bool paints = false;
        double relief = 0;  ///< a ball, raised by so much for each unit of the function's value
        double scale = 1;   ///< of the coordinates in the function of a ball that is painted or raised
    };
    Shown shown = {};
};

/// Numbers 0 to 39 (f_algbr_cyl1 to f_lemniscate_of_gerono_2d), 40 to 78 (f_mesh1 to f_noise_generator), and
/// those without a number.
std::span<const BuiltinFacts> firstNumberedFacts();
std::span<const BuiltinFacts> lastNumberedFacts();
std::span<const BuiltinFacts> patternFacts();

}  // namespace isoscope
