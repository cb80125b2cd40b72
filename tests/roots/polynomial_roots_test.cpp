// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial_roots.h"

#include <cmath>
#include <QRandomGenerator>
#include <QTest>
#include <sstream>

#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
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
struct HardCase {
    std::vector<double> coefficients;
    double low = 0, high = 0;
    std::vector<Interval> roots, may;
    std::vector<std::pair<std::size_t, std::size_t>> must;  // first and last index into roots

    HardCase(const test::CsvTable& table, std::size_t row) {
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

}  // namespace

class PolynomialRootsTest : public QObject {
    Q_OBJECT

  private slots:
    void hardCases() {
        const test::CsvTable table(test::dataFile("hard/polynomials.csv"));
        QVERIFY(table.rowCount() > 200);
        int failures = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const HardCase hard(table, row);
            const std::string mistake =
                hard.mistakeIn(polynomialRoots(hard.coefficients, hard.low, hard.high));
            if (mistake.empty()) continue;
            ++failures;
            qWarning("%s: %s", table.field(row, "case_id").c_str(), mistake.c_str());
        }
        QCOMPARE(failures, 0);
    }

    void closedFormsAgreeWhereTheyApply() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        for (int round = 0; round < 2000; ++round) {
            const int degree = 1 + random.bounded(4);
            std::vector<double> coefficients(degree + 1);
            for (double& c : coefficients) c = random.generateDouble() * 2 - 1;
            const auto wanted = polynomialRoots(coefficients, -100, 100);
            const auto method =
                degree <= 3 && random.bounded(2) ? PolynomialMethod::vieta : PolynomialMethod::ferrari;
            const auto got = polynomialRoots(coefficients, -100, 100, method);
            QCOMPARE(got.size(), wanted.size());
            for (std::size_t k = 0; k < got.size(); ++k)
                QVERIFY(std::abs(got[k] - wanted[k]) <= 1e-9 * std::max(1.0, std::abs(wanted[k])));
        }
    }

    void degenerateInput() {
        const double nothing[] = {0, 0, 0}, constant[] = {0, 3}, notFinite[] = {1, NAN}, line[] = {0, 2, -1};
        QVERIFY(polynomialRoots(nothing, -1, 1).empty());
        QVERIFY(polynomialRoots(constant, -1, 1).empty());
        QVERIFY(polynomialRoots(notFinite, -1, 1).empty());
        QVERIFY(polynomialRoots(line, 1, -1).empty());
        QVERIFY(polynomialRoots({}, -1, 1).empty());
        QCOMPARE(polynomialRoots(line, -1, 1), std::vector<double>{0.5});
    }
};

QTEST_APPLESS_MAIN(PolynomialRootsTest)
#include "polynomial_roots_test.moc"
