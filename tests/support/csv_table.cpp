// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/csv_table.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace isoscope::test {

namespace {

std::vector<std::vector<std::string>> parseCsv(const QByteArray& text) {
    std::vector<std::vector<std::string>> rows(1);
    std::string field;
    bool quoted = false;
    const auto endField = [&] {
        rows.back().push_back(field);
        field.clear();
    };
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '"' && i + 1 < text.size() && text[i + 1] == '"') field += text[++i];
            else if (c == '"') quoted = false;
            else field += c;
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            endField();
        } else if (c == '\n') {
            endField();
            rows.emplace_back();
        } else if (c != '\r') {
            field += c;
        }
    }
    if (!field.empty()) endField();
    if (rows.back().empty()) rows.pop_back();
    return rows;
}

}  // namespace

CsvTable::CsvTable(const QString& file) {
    QFile input(file);
    if (!input.open(QIODevice::ReadOnly)) {
        qWarning("cannot read %s", qPrintable(file));
        return;
    }
    rows_ = parseCsv(input.readAll());
    if (rows_.empty()) return;
    for (std::size_t k = 0; k < rows_.front().size(); ++k) columns_[rows_.front()[k]] = k;
    rows_.erase(rows_.begin());
}

const std::string& CsvTable::field(std::size_t row, const std::string& column) const {
    static const std::string empty;
    const auto found = columns_.find(column);
    if (found == columns_.end() || found->second >= rows_[row].size()) return empty;
    return rows_[row][found->second];
}

double CsvTable::number(std::size_t row, const std::string& column) const {
    const std::string& text = field(row, column);
    return text.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(text.c_str(), nullptr);
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
    return std::abs(got - wanted) / std::max(1.0, std::abs(wanted));
}

}  // namespace isoscope::test
