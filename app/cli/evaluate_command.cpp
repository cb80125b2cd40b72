// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <regex>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "core/evaluate/batch_evaluator.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// Rows that share a function, and the function.
struct FunctionRows {
    ParsedFunction parsed;
    std::vector<std::size_t> rows;
};

/// A prelude that is only a head such as `function(a, b)` names the parameters; every other one is scene text.
std::vector<std::string> parameterNames(const std::string& prelude) {
    static const std::regex head(R"(\s*function\s*\(([^()]*)\)\s*)");
    std::smatch match;
    if (!std::regex_match(prelude, match, head)) return {};
    std::vector<std::string> names;
    const std::string list = match[1];
    static const std::regex word(R"([^\s,]+)");
    for (std::sregex_iterator it(list.begin(), list.end(), word), end; it != end; ++it) names.push_back(it->str());
    return names;
}

ParsedFunction parseRow(const CsvTable& table, std::size_t row) {
    ParseOptions options;
    // There is no picture: the smallest one stands in for it.
    options.imageWidth = options.imageHeight = 1;
    options.noiseGenerator = static_cast<int>(table.number(row, "noise_generator", 2));
    const std::string& prelude = table.field(row, "prelude");
    std::vector<std::string> names = parameterNames(prelude);
    const bool isHead = !names.empty();
    return parseFunction(table.field(row, "expression"), isHead ? std::string() : prelude, options, std::move(names));
}

std::string firstError(const ParsedFunction& parsed) {
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        if (diagnostic.severity == Severity::error) return diagnostic.message;
    return parsed.diagnostics.empty() ? "the expression gives no number" : parsed.diagnostics.front().message;
}

std::vector<double> evaluateRows(const FunctionRows& group, const CsvTable& table, bool reference) {
    const std::size_t count = group.rows.size();
    std::vector<std::vector<double>> arguments(3, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        arguments[0][i] = table.number(group.rows[i], "x", 0);
        arguments[1][i] = table.number(group.rows[i], "y", 0);
        arguments[2][i] = table.number(group.rows[i], "z", 0);
    }
    const Function& function = group.parsed.value.function;
    arguments.resize(std::max<std::size_t>(3, function.argumentCount), std::vector<double>(count, 0.0));
    std::vector<double> values(count);
    if (reference) {
        ReferenceEvaluator evaluator(function);
        std::vector<double> point(arguments.size());
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < point.size(); ++k) point[k] = arguments[k][i];
            values[i] = evaluator.evaluate(point, group.parsed.parameterTable);
        }
        return values;
    }
    BatchEvaluator evaluator(Tape::compile(function), group.parsed.parameterTable);
    std::vector<const double*> pointers;
    for (const auto& column : arguments) pointers.push_back(column.data());
    evaluator.evaluate(pointers, count, values);
    return values;
}

ExitStatus evaluateTable(const std::string& file, const std::string& evaluatorName) {
    const std::optional<CsvTable> table = loadTable(file, {"expression", "x", "y", "z"});
    if (!table) return inputHasErrors;

    // Parsing is dearer than evaluating; rows with the same text share it.
    std::map<std::vector<std::string>, FunctionRows> groups;
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        const std::vector<std::string> key{table->field(row, "expression"), table->field(row, "prelude"),
                                           table->field(row, "noise_generator")};
        auto [group, isNew] = groups.try_emplace(key);
        if (isNew) group->second.parsed = parseRow(*table, row);
        group->second.rows.push_back(row);
    }

    std::vector<std::string> values(table->rowCount()), errors(table->rowCount());
    for (const auto& [key, group] : groups) {
        if (!group.parsed.ok()) {
            for (const std::size_t row : group.rows) errors[row] = firstError(group.parsed);
            continue;
        }
        const std::vector<double> results = evaluateRows(group, *table, evaluatorName == "reference");
        for (std::size_t i = 0; i < group.rows.size(); ++i) values[group.rows[i]] = exactNumber(results[i]);
    }

    std::vector<std::string> header = table->header();
    header.insert(header.end(), {"value", "error"});
    std::cout << csvLine(header);
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        std::vector<std::string> fields = table->row(row);
        fields.resize(table->header().size());
        fields.insert(fields.end(), {values[row], errors[row]});
        std::cout << csvLine(fields);
    }
    return done;
}

}  // namespace

void addEvaluateCommand(CLI::App& app, ExitStatus& status) {
    CLI::App* command = app.add_subcommand("evaluate", "Values of functions at points, from and to CSV");
    auto table = std::make_shared<std::string>();
    auto evaluator = std::make_shared<std::string>("batch");
    command->add_option("--table", *table, "CSV with expression,x,y,z[,prelude][,noise_generator]")->required();
    command->add_option("--evaluator", *evaluator, "Which evaluator answers")
        ->check(CLI::IsMember({"reference", "batch"}))
        ->capture_default_str();
    command->callback([=, &status] { status = evaluateTable(*table, *evaluator); });
}

}  // namespace isoscope::cli
