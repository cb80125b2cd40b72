// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <QTest>

#include "core/language/parse.h"
#include "core/text/number_format.h"
#include "tests/support/problems.h"

namespace isoscope::test {

inline std::string told(bool value) { return value ? "yes" : "no"; }
inline std::string told(int value) { return std::to_string(value); }
/// Without what is left of rounding.
inline std::string told(double value) { return shortestNumber(std::round(value * 1e12) / 1e12 + 0.0); }
inline std::string told(const Color& c) {
    std::string text = told(c.red) + " " + told(c.green) + " " + told(c.blue);
    if (c.filter != 0) text += " filter " + told(c.filter);
    if (c.transmit != 0) text += " transmit " + told(c.transmit);
    return text;
}
template <std::size_t Count>
std::string told(const std::array<double, Count>& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : " ") + told(number);
    return text;
}
inline std::string told(const glm::dvec3& v) { return told(std::array{v.x, v.y, v.z}); }
inline std::string told(const FractalColoring& coloring) {
    return told(coloring.type) + " " + told(coloring.factor);
}

/// Lists members that differ: "name value, name value".
class Differences {
  public:
    template <class Value>
    void add(const char* name, const Value& value, const Value& usual) {
        if (told(value) != told(usual)) put(std::string(name) + " " + told(value));
    }
    template <class Value>
    void add(const char* name, const std::optional<Value>& value, const std::optional<Value>&) {
        if (value) put(std::string(name) + " " + told(*value));
    }
    void put(const std::string& what) { text_ += (text_.empty() ? "" : ", ") + what; }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Errors and warnings of a text, one line each; none for what is only left out.
inline std::string complaintsOf(const ParseResult& parsed) {
    std::string all;
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        if (diagnostic.severity == Severity::error || diagnostic.severity == Severity::warning)
            all += diagnostic.message + "\n";
    return all;
}

/// Of a table of texts and of what is told of them.
inline void columns() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("wanted");
}

inline void row(const char* text, const char* wanted) {
    QTest::newRow(text) << QString(text) << QString(wanted);
}

/// Compares what a function tells of the first scene of the row.
template <class Tell>
void check(const char* before, const char* behind, Tell tell) {
    QFETCH(QString, text);
    QFETCH(QString, wanted);
    const ParseResult parsed = parseScene(before + text.toStdString() + behind);
    QVERIFY2(complaintsOf(parsed).empty(), problems(parsed).c_str());
    QCOMPARE(QString::fromStdString(tell(parsed)), wanted);
}

}  // namespace isoscope::test
