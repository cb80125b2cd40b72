// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/text/csv_table.h"

namespace isoscope::test {

/// A data file that must be there: a missing one fails the running test (by an empty table and a message).
class CsvTable : public isoscope::CsvTable {
  public:
    explicit CsvTable(const QString& file);

    /// NaN for "nan" and for empty fields; "inf" and "-inf" are understood.
    double number(std::size_t row, const std::string& column) const;
};

/// Where a data file is: the full one of the folder `shared` beside the project when that is there, else the
/// project's own (thinned) copy under tests/data. `name` is like "golden/functions.csv".
QString dataFile(const QString& name);

/// Whether the full data beside the project are there.
bool hasSharedData();

/// |got - wanted| / max(1, |wanted|); 0 when both are NaN or the same infinity, infinite when only one is.
double goldenError(double got, double wanted);

}  // namespace isoscope::test
