// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/table_row.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// Without the blanks at both ends.
std::string trimmed(const std::string& text) {
    constexpr const char* blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string::npos ? std::string()
                                      : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// As it stands in a message: its beginning on one line.
std::string shown(const std::string& cell) {
    constexpr std::size_t limit = 40;
    std::string text = cell.substr(0, limit);
    if (cell.size() > limit) text.append("...");
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    return '`' + text + '`';
}

}  // namespace

TableRow::TableRow(const std::string& file, const CsvTable& table, std::size_t row)
    : file_(file), table_(table), row_(row) {
    const std::vector<std::string>& cells = table.row(row);
    const std::size_t expected = std::min(table.header().size(), cells.size());
    if (std::any_of(cells.begin() + static_cast<std::ptrdiff_t>(expected), cells.end(),
                    [](const std::string& cell) { return !cell.empty(); }))
        say("has " + std::to_string(cells.size()) + " cells, more than the header's " +
            std::to_string(expected) + "; a cell with a comma is quoted");
}

double TableRow::number(const std::string& column) {
    if (!trimmed(text(column)).empty()) return readNumber(column, 0, true);
    refuse(column, "is empty, where a number is needed");
    return 0;
}

double TableRow::number(const std::string& column, double missing) {
    return readNumber(column, missing, true);
}

double TableRow::positive(const std::string& column, double missing) {
    const bool wasOk = ok_;
    const double value = readNumber(column, missing, true);
    if (value > 0 || ok_ != wasOk) return value;
    refuse(column, "is not above 0");
    return missing;
}

double TableRow::anyNumber(const std::string& column, double missing) {
    return readNumber(column, missing, false);
}

glm::dvec3 TableRow::point(const std::string& x, const std::string& y, const std::string& z) {
    const double first = number(x), second = number(y);
    return {first, second, number(z)};
}

ScaledDirection TableRow::direction(const std::string& x, const std::string& y, const std::string& z) {
    const bool wasOk = ok_;
    ok_ = true;
    const glm::dvec3 direction = point(x, y, z);
    if (ok_ && direction == glm::dvec3(0))
        say("columns `" + x + "`, `" + y + "`, `" + z + "`: a direction of length 0");
    ok_ = ok_ && wasOk;
    // Far from where squares, and their squares, leave the doubles.
    constexpr int moderate = 200;
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    if (std::abs(exponent) <= moderate) return {direction, 0};
    const auto scaled = [=](double component) { return std::scalbn(component, -exponent); };
    return {{scaled(direction.x), scaled(direction.y), scaled(direction.z)}, exponent};
}

void TableRow::refuse(const std::string& column, const std::string& problem) {
    const std::string& cell = text(column);
    say("column `" + column + "`: " + (cell.empty() ? "the cell" : shown(cell)) + ' ' + problem);
}

void TableRow::say(const std::string& problem) {
    ok_ = false;
    std::cerr << place() << ": error: row " << row_ + 1 << ": " << problem << '\n';
}

double TableRow::readNumber(const std::string& column, double missing, bool finite) {
    const std::string cell = trimmed(text(column));
    if (cell.empty()) return missing;
    char* end = nullptr;
    const double value = leadingNumber(cell.c_str(), &end);
    if (end != cell.c_str() + cell.size()) {
        refuse(column, "is no number");
        return missing;
    }
    if (!finite || std::isfinite(value)) return value;
    refuse(column, "is no finite number");
    return missing;
}

}  // namespace isoscope::cli
