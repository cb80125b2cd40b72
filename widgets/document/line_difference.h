// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace isoscope {

/// A line of two texts laid over each other.
struct DifferenceLine {
    /// Which of the texts have the line.
    enum class Kind { both, onlyFirst, onlySecond };
    Kind kind;
    QString text;
    int first;   ///< its number in the first text, counted from 1; 0 when it is not there
    int second;  ///< the same
    bool operator==(const DifferenceLine&) const = default;
};

/// The lines of both texts in one sequence, with as few as possible that only one of them has (Myers, An
/// O(ND) Difference Algorithm, 1986). Where texts have more than 2 000 differing lines the differing part is
/// told as a whole.
std::vector<DifferenceLine> lineDifference(const QString& first, const QString& second);

}  // namespace isoscope
