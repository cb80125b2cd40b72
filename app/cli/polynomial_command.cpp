// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <sstream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "core/roots/polynomial/polynomial_roots.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// Numbers separated by `;`; what is no number is NaN, which has no roots.
std::vector<double> numbers(const std::string& text) {
    std::vector<double> values;
    std::istringstream list(text);
    for (std::string part; std::getline(list, part, ';');) {
        char* end = nullptr;
        const double value = std::strtod(part.c_str(), &end);
        values.push_back(*end == '\0' && !part.empty() ? value : std::nan(""));
    }
    return values;
}

ExitStatus findRoots(const std::string& file, PolynomialMethod method) {
    const std::optional<CsvTable> table = loadTable(file, {"case_id", "coefficients", "lo", "hi"});
    if (!table) return inputHasErrors;
    std::cout << csvLine({"case_id", "roots"});
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        const std::vector<double> coefficients = numbers(table->field(row, "coefficients"));
        std::string roots;
        for (const double root : polynomialRoots(coefficients, table->number(row, "lo", std::nan("")),
                                                 table->number(row, "hi", std::nan("")), method))
            roots += (roots.empty() ? "" : ";") + exactNumber(root);
        std::cout << csvLine({table->field(row, "case_id"), roots});
    }
    return done;
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
    command.option("--method", *method, "sturm (any degree), ferrari (up to 4) or vieta (the same)")
        .oneOf({"sturm", "ferrari", "vieta"});
    command.run([=] { return findRoots(*table, methodOf(*method)); });
}

}  // namespace isoscope::cli
