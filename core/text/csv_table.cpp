// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/csv_table.h"

#include <fstream>
#include <limits>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

class CsvReader {
  public:
    struct Row {
        std::vector<std::string> fields;
        std::size_t line;
    };

    std::vector<Row> read(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            const bool doubled = i + 1 < text.size() && text[i + 1] == '"';
            if (quoted_ && text[i] == '"' && doubled)
                field_ += text[++i];
            else
                take(text[i]);
        }
        if (!field_.empty() || !row_.empty()) endRow();
        return std::move(rows_);
    }

    std::optional<std::size_t> unclosedQuote() const {
        return quoted_ ? std::optional(quoteLine_) : std::nullopt;
    }

  private:
    void take(char c) {
        if (c == '\n') ++line_;
        if (c == '"') {
            quoted_ = !quoted_;
            quoteLine_ = line_;
        } else if (quoted_) {
            field_ += c;
        } else if (c == ',') {
            endField();
        } else if (c == '\n') {
            endRow();
        } else if (c != '\r') {
            field_ += c;
        }
    }
    void endField() {
        row_.push_back(std::move(field_));
        field_.clear();
    }
    void endRow() {
        endField();
        rows_.push_back({std::move(row_), rowLine_});
        row_.clear();
        rowLine_ = line_;
    }

    std::vector<Row> rows_;
    std::vector<std::string> row_;
    std::string field_;
    bool quoted_ = false;
    std::size_t line_ = 1, rowLine_ = 1, quoteLine_ = 1;
};

}  // namespace

CsvTable CsvTable::parse(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
    CsvTable table;
    CsvReader reader;
    std::vector<CsvReader::Row> rows = reader.read(text);
    table.unclosedQuote_ = reader.unclosedQuote();
    for (CsvReader::Row& row : rows) {
        // A line without any text is the end of the file, not a row.
        const bool isHeader = &row == &rows.front();
        if (!isHeader && row.fields.size() == 1 && row.fields.front().empty()) continue;
        if (isHeader) {
            table.header_ = std::move(row.fields);
            continue;
        }
        table.lines_.push_back(row.line);
        table.rows_.push_back(std::move(row.fields));
    }
    for (std::size_t k = 0; k < table.header_.size(); ++k) table.columns_.emplace(table.header_[k], k);
    return table;
}

std::optional<CsvTable> CsvTable::read(const std::filesystem::path& file) {
    std::ifstream input(file, std::ios::binary);
    if (!input) return std::nullopt;
    // A pipe has no size, and a device no end.
    constexpr std::size_t sizeLimit = 256 * 1024 * 1024;
    std::string text, piece(64 * 1024, '\0');
    while (input.read(piece.data(), static_cast<std::streamsize>(piece.size())) || input.gcount() > 0) {
        text.append(piece, 0, static_cast<std::size_t>(input.gcount()));
        if (text.size() > sizeLimit) return std::nullopt;
    }
    if (input.bad()) return std::nullopt;
    return parse(text);
}

const std::string& CsvTable::field(std::size_t row, const std::string& column) const {
    static const std::string empty;
    const auto found = columns_.find(column);
    if (found == columns_.end() || found->second >= rows_[row].size()) return empty;
    return rows_[row][found->second];
}

double CsvTable::number(std::size_t row, const std::string& column, double missing) const {
    const std::string& text = field(row, column);
    if (text.empty()) return missing;
    char* end = nullptr;
    const double value = leadingNumber(text.c_str(), &end);
    return *end == '\0' ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string csvLine(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        if (&field != &fields.front()) line += ',';
        if (field.find_first_of(",\"\n\r") == std::string::npos) {
            line += field;
            continue;
        }
        line += '"';
        for (const char c : field) {
            if (c == '"') line += '"';
            line += c;
        }
        line += '"';
    }
    return line + '\n';
}

}  // namespace isoscope
