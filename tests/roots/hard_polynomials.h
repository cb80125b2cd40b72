// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/csv_table.h"

namespace isoscope::test {

inline std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

struct Interval {
    double low = 0, high = 0;
    bool holds(double t) const { return t >= low && t <= high; }
};

/// One row of hard/polynomials.csv: where roots are, may be, and must be.
struct HardPolynomial {
    std::vector<double> coefficients;
    double low = 0, high = 0;
    std::vector<Interval> roots, may;
    std::vector<std::pair<std::size_t, std::size_t>> must;  // first and last index into roots

    HardPolynomial(const CsvTable& table, std::size_t row) {
        for (const std::string& text : split(table.field(row, "coefficients"), ';'))
            coefficients.push_back(std::strtod(text.c_str(), nullptr));
        low = table.number(row, "lo");
        high = table.number(row, "hi");
        for (const std::string& text : split(table.field(row, "all_roots"), ';')) {
            const std::vector<std::string> parts = split(text, ':');
            roots.push_back({std::stod(parts[3]), std::stod(parts[4])});
        }
        for (const std::string& text : split(table.field(row, "must"), ';')) {
            const std::vector<std::string> ends = split(text, '-');
            must.emplace_back(std::stoul(ends.front()) - 1, std::stoul(ends.back()) - 1);
        }
        for (const std::string& text : split(table.field(row, "may"), ';')) {
            const std::size_t dots = text.find("..");
            may.push_back({std::stod(text.substr(0, dots)), std::stod(text.substr(dots + 2))});
        }
    }

    std::string mistakeIn(const std::vector<double>& found) const {
        for (const double t : found) {
            const auto holds = [&](const Interval& interval) { return interval.holds(t); };
            if (std::none_of(roots.begin(), roots.end(), holds) &&
                std::none_of(may.begin(), may.end(), holds))
                return "false root " + std::to_string(t);
        }
        for (const auto& [first, last] : must) {
            std::size_t count = 0;
            for (const double t : found) {
                bool inCluster = false;
                for (std::size_t k = first; k <= last; ++k) inCluster = inCluster || roots[k].holds(t);
                count += inCluster;
            }
            if (count % 2 == 0) return "missed root " + std::to_string(first + 1);
        }
        return {};
    }
};

}  // namespace isoscope::test
