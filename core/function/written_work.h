// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace isoscope {

/// What an interpreter has to do for one value of a function as it is written, as POV-Ray does: what stands
/// there twice is done twice, constants that stand side by side are worked out beforehand. What functions of
/// the text do is there as often as they are called, and the body of a loop as often as it runs.
struct WrittenWork {
    /// Steps of a loop whose bounds depend on the place.
    static constexpr double unknownSteps = 10;

    double products = 0;
    double quotients = 0;
    double sums = 0;  ///< differences, signs, comparisons, `&` and `|`, too
    /// Of elementary and built-in functions, by name; `min` of three counts twice.
    std::map<std::string, double, std::less<>> calls;
    double declaredCalls = 0;  ///< of functions of the text
    double compiledCalls =
        0;  ///< of those made of a pigment, a pattern, a spline or a transform, not seen into

    /// Adds other work that is done so many times.
    void add(const WrittenWork& other, double times);
};

}  // namespace isoscope
