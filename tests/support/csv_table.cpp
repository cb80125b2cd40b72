// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_folders.h"
#include "tests/support/csv_table.h"

#include <QFileInfo>
#include <QDebug>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope::test {

CsvTable::CsvTable(const QString& file) {
    if (auto table = read(file.toStdString()))
        isoscope::CsvTable::operator=(std::move(*table));
    else
        qWarning("cannot read %s", qPrintable(file));
}

double CsvTable::number(std::size_t row, const std::string& column) const {
    return isoscope::CsvTable::number(row, column, std::numeric_limits<double>::quiet_NaN());
}

QString dataFile(const QString& name) {
    const QString shared = QStringLiteral(ISOSCOPE_SOURCE_DIR "/../shared/") + name;
    return QFileInfo::exists(shared) ? shared : QStringLiteral(ISOSCOPE_TEST_DATA "/") + name;
}

bool hasSharedData() { return QFileInfo::exists(QStringLiteral(ISOSCOPE_SOURCE_DIR "/../shared/golden")); }

double goldenError(double got, double wanted) {
    if (std::isnan(got) || std::isnan(wanted))
        return std::isnan(got) == std::isnan(wanted) ? 0 : std::numeric_limits<double>::infinity();
    if (got == wanted) return 0;
    const double error = std::abs(got - wanted) / std::max(1.0, std::abs(wanted));
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

}  // namespace isoscope::test
