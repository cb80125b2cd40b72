// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <map>
#include <string>
#include <vector>

namespace isoscope::test {

/// A CSV file with a header line, fields by column name. Quoted fields may hold commas, quotes and line breaks.
class CsvTable {
  public:
    /// Fails the running test (by an empty table) when the file cannot be read.
    explicit CsvTable(const QString& file);

    std::size_t rowCount() const { return rows_.size(); }
    /// "" for a missing column.
    const std::string& field(std::size_t row, const std::string& column) const;
    /// NaN for "nan" and for empty fields; "inf" and "-inf" are understood.
    double number(std::size_t row, const std::string& column) const;

  private:
    std::map<std::string, std::size_t> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// Where a data file is: the full one of the folder `shared` beside the project when that is there, else the
/// project's own (thinned) copy under tests/data. `name` is like "golden/functions.csv".
QString dataFile(const QString& name);

/// Whether the full data beside the project are there.
bool hasSharedData();

/// |got - wanted| / max(1, |wanted|); 0 when both are NaN or the same infinity, infinite when only one is.
double goldenError(double got, double wanted);

}  // namespace isoscope::test
