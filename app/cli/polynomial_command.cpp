// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <sstream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/table_row.h"
#include "core/roots/polynomial/polynomial_roots.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// The time grows with the cube of the degree; POV-Ray knows 35.
constexpr std::size_t mostCoefficients = 101;

/// Numbers separated by `;`, one at least; what is no finite number is refused.
std::vector<double> coefficients(TableRow& row) {
    std::vector<double> values;
    std::istringstream list(row.text("coefficients"));
    for (std::string part; std::getline(list, part, ';');) {
        char* end = nullptr;
        const double value = leadingNumber(part.c_str(), &end);
        if (end == part.c_str() || *end != '\0' || !std::isfinite(value)) {
            row.refuse("coefficients", "has a part that is no finite number");
            return {};
        }
        values.push_back(value);
    }
    if (values.size() > mostCoefficients) {
        row.refuse("coefficients", "has " + std::to_string(values.size()) + " numbers; " +
                                       std::to_string(mostCoefficients) + " are read");
        return {};
    }
    if (values.empty()) row.refuse("coefficients", "is empty, where numbers separated by `;` are needed");
    return values;
}

ExitStatus findRoots(const std::string& file, PolynomialMethod method) {
    const std::optional<CsvTable> table = loadTable(file, {"case_id", "coefficients", "lo", "hi"});
    if (!table) return inputHasErrors;
    ExitStatus status = done;
    std::cout << csvLine({"case_id", "roots"});
    for (std::size_t number = 0; number < table->rowCount(); ++number) {
        TableRow row(file, *table, number);
        const std::vector<double> terms = coefficients(row);
        const double low = row.number("lo"), high = row.number("hi");
        if (!row.ok()) {
            std::cout << csvLine({row.text("case_id"), "error"});
            status = inputHasErrors;
            continue;
        }
        std::string roots;
        for (const double root : polynomialRoots(terms, low, high, method))
            roots += (roots.empty() ? "" : ";") + exactNumber(root);
        std::cout << csvLine({row.text("case_id"), roots});
    }
    return status;
}

PolynomialMethod methodOf(const std::string& name) {
    return name == "ferrari" ? PolynomialMethod::ferrari
           : name == "vieta" ? PolynomialMethod::vieta
                             : PolynomialMethod::sturm;
}

}  // namespace

void addPolynomialCommand(CommandLine& line) {
    Command command = line.add("polynomial", "Real roots of polynomials, from and to CSV");
    auto table = std::make_shared<std::string>();
    auto method = std::make_shared<std::string>("sturm");
    command.option("--table", *table, "CSV with case_id,coefficients,lo,hi").required();
    command.option("--method", *method, "sturm (any degree up to 100), ferrari (up to 4) or vieta (the same)")
        .oneOf({"sturm", "ferrari", "vieta"});
    command.run([=] { return findRoots(*table, methodOf(*method)); });
}

}  // namespace isoscope::cli
