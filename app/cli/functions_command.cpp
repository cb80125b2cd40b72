// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "core/function/builtins/builtin.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

std::size_t largestParameterCount() {
    std::size_t largest = 0;
    for (const Builtin& builtin : builtins()) largest = std::max(largest, builtin.parameters.size());
    return largest;
}

void printCsv() {
    const std::size_t columns = largestParameterCount();
    std::vector<std::string> header{"name", "id", "param_count"};
    for (std::size_t k = 0; k < columns; ++k)
        for (const char* what : {"name", "default", "min", "max"})
            header.push_back("P" + std::to_string(k) + "_" + what);
    header.insert(header.end(), {"threshold", "container", "max_gradient", "invert", "kind", "formula"});
    std::cout << csvLine(header);
    for (const Builtin& builtin : builtins()) {
        std::vector<std::string> fields{builtin.name, builtin.id < 0 ? "" : std::to_string(builtin.id),
                                        std::to_string(builtin.parameters.size())};
        for (const BuiltinParameter& parameter : builtin.parameters)
            fields.insert(fields.end(),
                          {parameter.name, shortestNumber(parameter.defaultValue),
                           shortestNumber(parameter.minimum), shortestNumber(parameter.maximum)});
        fields.resize(3 + 4 * columns);
        fields.insert(fields.end(), {shortestNumber(builtin.threshold), builtin.container,
                                     shortestNumber(builtin.maxGradient), builtin.invert ? "1" : "0",
                                     builtin.kind, builtin.formula});
        std::cout << csvLine(fields);
    }
}

void printList() {
    for (const Builtin& builtin : builtins()) {
        std::cout << std::left << std::setw(26) << (builtin.name.empty() ? "(unnamed)" : builtin.name)
                  << std::right << std::setw(3) << (builtin.id < 0 ? "-" : std::to_string(builtin.id)) << "  "
                  << builtin.formula << '\n';
        for (std::size_t k = 0; k < builtin.parameters.size(); ++k) {
            const BuiltinParameter& parameter = builtin.parameters[k];
            std::cout << "      P" << k << "  " << std::left << std::setw(24) << parameter.name << std::right
                      << " " << shortestNumber(parameter.defaultValue) << "  ["
                      << shortestNumber(parameter.minimum) << " .. " << shortestNumber(parameter.maximum)
                      << "]\n";
        }
    }
}

}  // namespace

void addFunctionsCommand(CommandLine& line) {
    Command command = line.add("functions", "Every built-in with its parameters, defaults and ranges");
    auto csv = std::make_shared<bool>(false);
    command.flag("--csv", *csv, "As CSV");
    command.run([=] {
        *csv ? printCsv() : printList();
        return done;
    });
}

}  // namespace isoscope::cli
