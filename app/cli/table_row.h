// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <string>

#include "core/text/csv_table.h"

namespace isoscope::cli {

/// The direction of a ray, scaled by a power of two where its square would be beyond doubles.
struct ScaledDirection {
    glm::dvec3 scaled{0};
    int exponent = 0;

    /// t along the direction of the table, for t along the scaled one.
    double tableT(double t) const { return std::scalbn(t, -exponent); }
};

/// One row of a table that a command answers: its cells as what they have to be. What is not so is told on
/// standard error with the line of the file, the number of the row and the column, and makes the row one that
/// has no answer but `error`.
class TableRow {
  public:
    /// Both must live as long as the row. A row with more cells than the header is malformed.
    TableRow(const std::string& file, const CsvTable& table, std::size_t row);

    /// Whether every cell that was asked for is what it has to be.
    bool ok() const { return ok_; }
    /// "FILE:LINE", for messages.
    std::string place() const { return file_ + ':' + std::to_string(table_.line(row_)); }
    /// The text of a cell, empty where there is none.
    const std::string& text(const std::string& column) const { return table_.field(row_, column); }

    /// A finite number; 0 and a message where the cell holds none.
    double number(const std::string& column);
    /// The same; `missing` where the cell is empty or the table has no such column.
    double number(const std::string& column, double missing);
    /// The same, above 0.
    double positive(const std::string& column, double missing);
    /// A number, infinite and NaN included; `missing` where there is no cell.
    double anyNumber(const std::string& column, double missing);
    /// Three finite numbers.
    glm::dvec3 point(const std::string& x, const std::string& y, const std::string& z);
    /// Three finite numbers that are not all 0.
    ScaledDirection direction(const std::string& x, const std::string& y, const std::string& z);

    /// Says what is wrong with a cell, in words that follow what it holds: "is no finite number".
    void refuse(const std::string& column, const std::string& problem);

  private:
    void say(const std::string& problem);
    double readNumber(const std::string& column, double missing, bool finite);

    const std::string& file_;
    const CsvTable& table_;
    std::size_t row_;
    bool ok_ = true;
};

}  // namespace isoscope::cli
