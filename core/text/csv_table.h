// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Comma separated values with a header line, fields by column name. Quoted fields may hold commas, doubled
/// quotes and line breaks. Rows shorter than the header read as if filled up with empty fields.
class CsvTable {
  public:
    /// The first line is the header. Carriage returns, lines without any text and a byte order mark are left
    /// out; never fails.
    static CsvTable parse(std::string_view text);
    /// Empty when the file cannot be read or has more than 256 MB.
    static std::optional<CsvTable> read(const std::filesystem::path& file);

    /// Column names in the order of the file; of two equal ones field() finds the first.
    const std::vector<std::string>& header() const { return header_; }
    /// Rows without the header, numbered from 0.
    std::size_t rowCount() const { return rows_.size(); }
    /// Whether the header names it, upper and lower case told apart.
    bool hasColumn(const std::string& column) const { return columns_.contains(column); }

    /// "" for a missing column.
    const std::string& field(std::size_t row, const std::string& column) const;
    /// The fields of a row as they were read, perhaps fewer or more than the header has.
    const std::vector<std::string>& row(std::size_t row) const { return rows_[row]; }
    /// The line of the text, from 1, in which the row begins.
    std::size_t line(std::size_t row) const { return lines_[row]; }
    /// The line with the quote that is never closed, which makes all behind it one field; empty for none.
    std::optional<std::size_t> unclosedQuote() const { return unclosedQuote_; }
    /// `missing` for an empty field or a missing column; NaN for what is no number. Understands inf, nan and
    /// hexadecimal floats.
    double number(std::size_t row, const std::string& column, double missing) const;

  private:
    std::vector<std::string> header_;
    std::map<std::string, std::size_t> columns_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> lines_;
    std::optional<std::size_t> unclosedQuote_;
};

/// One line of CSV, fields quoted where needed, line break included.
std::string csvLine(const std::vector<std::string>& fields);

}  // namespace isoscope
