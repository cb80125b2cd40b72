// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string_view>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/table_row.h"
#include "app/cli/time_limit.h"
#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// Rows that share a function, and the function.
struct FunctionRows {
    ParsedFunction parsed;
    std::vector<std::size_t> rows;
};

/// A prelude that is only a head such as `function(a, b)` names the parameters; every other one is scene
/// text.
std::vector<std::string> parameterNames(const std::string& prelude) {
    constexpr std::string_view blanks = " \t\r\n", separators = " \t\r\n,", keyword = "function";
    std::string_view rest = prelude;
    const auto skipBlanks = [&] {
        rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    };
    skipBlanks();
    if (!rest.starts_with(keyword)) return {};
    rest.remove_prefix(keyword.size());
    skipBlanks();
    const std::size_t close = rest.find(')');
    if (!rest.starts_with('(') || close == std::string_view::npos) return {};
    const std::string_view list = rest.substr(1, close - 1);
    rest.remove_prefix(close + 1);
    skipBlanks();
    if (!rest.empty() || list.find('(') != std::string_view::npos) return {};
    std::vector<std::string> names;
    for (std::size_t at = list.find_first_not_of(separators); at != std::string_view::npos;) {
        const std::size_t end = std::min(list.find_first_of(separators, at), list.size());
        names.emplace_back(list.substr(at, end - at));
        at = list.find_first_not_of(separators, end);
    }
    return names;
}

/// The generator of noise that a row states, 2 where it states none.
int noiseGenerator(TableRow& row) {
    const double stated = row.number("noise_generator", 2);
    if (stated == 1 || stated == 2 || stated == 3) return static_cast<int>(stated);
    if (row.ok()) row.refuse("noise_generator", "is not 1, 2 or 3");
    return 2;
}

/// Notes whether the function reads its first, second or third argument.
void noteArguments(const Function& function, std::array<bool, 3>& used) {
    for (NodeId id = 0; id < function.graph->size(); ++id) {
        const Node& node = (*function.graph)[id];
        if (node.operation == Operation::variable && node.index < used.size()) used[node.index] = true;
        if (node.operation == Operation::sum || node.operation == Operation::product)
            noteArguments(function.graph->loopBody(node.index), used);
    }
}

/// Whether the cells of a row are numbers, and there are those that its function reads; says what is wrong.
bool checkCells(TableRow& row, const ParsedFunction& parsed) {
    constexpr std::array columns{"x", "y", "z"};
    std::array<bool, 3> used{};
    if (parsed.ok()) noteArguments(parsed.value.function, used);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (used[k] && row.text(columns[k]).empty())
            row.refuse(columns[k], "is empty, but the expression reads it");
        row.anyNumber(columns[k], 0);
    }
    for (const char* reach : {"rx", "ry", "rz"}) row.anyNumber(reach, 0);
    return row.ok();
}

ParsedFunction parseRow(const CsvTable& table, std::size_t row, int generator, const std::stop_token& stop) {
    ParseOptions options;
    options.stop = stop;
    // There is no picture: the smallest one stands in for it.
    options.restrictedReading = true;
    options.imageWidth = options.imageHeight = 1;
    options.noiseGenerator = generator;
    const std::string& prelude = table.field(row, "prelude");
    std::vector<std::string> names = parameterNames(prelude);
    const bool isHead = !names.empty();
    return parseFunction(table.field(row, "expression"), isHead ? std::string() : prelude, options,
                         std::move(names));
}

std::string firstError(const ParsedFunction& parsed) {
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        if (diagnostic.severity == Severity::error) return diagnostic.message;
    return parsed.diagnostics.empty() ? "the expression gives no number" : parsed.diagnostics.front().message;
}

/// Rows that are evaluated between two looks at the clock.
constexpr std::size_t slice = 64;

/// Fewer values than rows where the time is over.
std::vector<double> evaluateRows(const FunctionRows& group, const CsvTable& table, bool reference,
                                 TimeLimit& limit) {
    const std::size_t count = group.rows.size();
    std::vector<std::vector<double>> arguments(3, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        arguments[0][i] = table.number(group.rows[i], "x", 0);
        arguments[1][i] = table.number(group.rows[i], "y", 0);
        arguments[2][i] = table.number(group.rows[i], "z", 0);
    }
    const Function& function = group.parsed.value.function;
    arguments.resize(static_cast<std::size_t>(std::max(3, function.argumentCount)),
                     std::vector<double>(count, 0.0));
    std::vector<double> values(count);
    ReferenceEvaluator exact(function);
    PointEvaluator batch(Tape::compile(function), group.parsed.parameterTable);
    std::vector<double> point(arguments.size());
    std::vector<const double*> pointers(arguments.size());
    for (std::size_t first = 0; first < count; first += slice) {
        limit.restart();
        const LoopStop loops(limit.token());
        const std::size_t end = std::min(count, first + slice);
        for (std::size_t i = first; reference && i < end; ++i) {
            for (std::size_t k = 0; k < point.size(); ++k) point[k] = arguments[k][i];
            values[i] = exact.evaluate(point, group.parsed.parameterTable);
        }
        if (!reference) {
            for (std::size_t k = 0; k < point.size(); ++k) pointers[k] = arguments[k].data() + first;
            batch.evaluate(pointers, end - first, std::span(values).subspan(first, end - first));
        }
        if (!limit.over()) continue;
        values.resize(first);
        break;
    }
    return values;
}

/// x, y, z of a row, and rx, ry, rz: half the widths of the box around them.
struct RowBox {
    std::array<double, 3> center, reach;

    RowBox(const CsvTable& table, std::size_t row)
        : center{table.number(row, "x", 0), table.number(row, "y", 0), table.number(row, "z", 0)},
          reach{std::abs(table.number(row, "rx", 0)), std::abs(table.number(row, "ry", 0)),
                std::abs(table.number(row, "rz", 0))} {}
};

/// lower and upper; NaN where the function has certainly no value.
using Bounds = std::array<double, 2>;

constexpr Bounds noValue{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
constexpr Bounds anyValue{-Interval::infinite, Interval::infinite};

Bounds intervalBounds(IntervalEvaluator& evaluator, const RowBox& box) {
    std::array<Interval, 3> arguments;
    for (std::size_t k = 0; k < 3; ++k)
        arguments[k] = box.reach[k] == 0
                           ? Interval::point(box.center[k])
                           : Interval::point(box.center[k]) + Interval{-box.reach[k], box.reach[k], false};
    const Interval range = evaluator.evaluate(arguments);
    return range.empty() ? noValue : Bounds{range.low, range.high};
}

/// The box as a bundle of rays of length 0.
Bounds affineBounds(AffineEvaluator& evaluator, const RowBox& box) {
    RayPieces pieces;
    RaySpread spread;
    for (std::size_t k = 0; k < 3; ++k) {
        pieces.origin[k].fill(box.center[k]);
        spread.origin[k].fill(box.reach[k]);
    }
    const AffineLanes lanes = evaluator.evaluate(pieces, 1, 0, &spread);
    const double center = lanes.center[0], error = lanes.error[0];
    if (error == -Interval::infinite) return noValue;
    if (!(error < Interval::infinite)) return anyValue;
    const double reach = (std::abs(lanes.slope[0]) + error) * (1 + 1e-15);
    return {std::nextafter(center - reach, -Interval::infinite),
            std::nextafter(center + reach, Interval::infinite)};
}

/// Fewer bounds than rows where the time is over.
std::vector<Bounds> encloseRows(const FunctionRows& group, const CsvTable& table, bool affine,
                                TimeLimit& limit) {
    const auto tape = Tape::compile(group.parsed.value.function);
    const auto& parameters = group.parsed.parameterTable;
    std::vector<Bounds> bounds;
    AffineEvaluator forms(tape, parameters);
    IntervalEvaluator intervals(tape, parameters);
    for (const std::size_t row : group.rows) {
        limit.restart();
        const LoopStop loops(limit.token());
        const RowBox box(table, row);
        const Bounds found = affine ? affineBounds(forms, box) : intervalBounds(intervals, box);
        if (limit.over()) break;
        bounds.push_back(found);
    }
    return bounds;
}

using Answers = std::vector<std::string>;

/// The new columns of the rows of a group, without the errors: `value`, or for enclosures `lower,upper`. Of
/// fewer rows where the time is over.
std::vector<Answers> answers(const FunctionRows& group, const CsvTable& table,
                             const std::string& evaluatorName, TimeLimit& limit) {
    std::vector<Answers> found;
    if (evaluatorName == "interval" || evaluatorName == "affine") {
        for (const auto& [lower, upper] : encloseRows(group, table, evaluatorName == "affine", limit))
            found.push_back({exactNumber(lower), exactNumber(upper)});
    } else {
        for (const double value : evaluateRows(group, table, evaluatorName == "reference", limit))
            found.push_back({exactNumber(value)});
    }
    return found;
}

std::vector<std::string> answerColumns(const std::string& evaluatorName) {
    if (evaluatorName == "interval" || evaluatorName == "affine") return {"lower", "upper"};
    return {"value"};
}

ExitStatus evaluateTable(const std::string& file, const std::string& evaluatorName, const WorkLimit& work) {
    const std::optional<CsvTable> table = loadTable(file, {"expression", "x", "y", "z"});
    if (!table) return inputHasErrors;

    // Parsing is dearer than evaluating; rows with the same text share it.
    std::map<std::vector<std::string>, FunctionRows> groups;
    std::vector<std::string> errors(table->rowCount());
    ExitStatus status = done;
    TimeLimit limit(work.seconds);
    for (std::size_t number = 0; number < table->rowCount(); ++number) {
        TableRow row(file, *table, number);
        const std::vector<std::string> key{row.text("expression"), row.text("prelude"),
                                           row.text("noise_generator")};
        auto [group, isNew] = groups.try_emplace(key);
        const int generator = noiseGenerator(row);
        limit.restart();
        if (isNew) group->second.parsed = parseRow(*table, number, generator, limit.token());
        if (isNew && limit.over()) work.error(row.place(), "the function is not read");
        if (checkCells(row, group->second.parsed)) {
            group->second.rows.push_back(number);
        } else {
            errors[number] = "the row is malformed";
            status = inputHasErrors;
        }
    }

    const std::vector<std::string> columns = answerColumns(evaluatorName);
    std::vector<Answers> values(table->rowCount(), Answers(columns.size()));
    for (const auto& [key, group] : groups) {
        if (!group.parsed.ok()) {
            for (const std::size_t row : group.rows) errors[row] = firstError(group.parsed);
            continue;
        }
        const std::vector<Answers> found = answers(group, *table, evaluatorName, limit);
        for (std::size_t i = 0; i < found.size(); ++i) values[group.rows[i]] = found[i];
        if (found.size() == group.rows.size()) continue;
        work.error(TableRow(file, *table, group.rows[found.size()]).place(),
                   "there is no answer, nor to any row behind it with this function");
        for (std::size_t i = found.size(); i < group.rows.size(); ++i)
            errors[group.rows[i]] = "the time is over";
        status = inputHasErrors;
    }

    std::vector<std::string> header = table->header();
    header.insert(header.end(), columns.begin(), columns.end());
    header.push_back("error");
    std::cout << csvLine(header);
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        std::vector<std::string> fields = table->row(row);
        fields.resize(table->header().size());
        fields.insert(fields.end(), values[row].begin(), values[row].end());
        fields.push_back(errors[row]);
        std::cout << csvLine(fields);
    }
    return status;
}

}  // namespace

void addEvaluateCommand(CommandLine& line) {
    Command command = line.add("evaluate", "Values of functions at points, from and to CSV");
    auto table = std::make_shared<std::string>();
    auto evaluator = std::make_shared<std::string>("batch");
    command
        .option("--table", *table,
                "CSV with expression,x,y,z[,prelude][,noise_generator][,rx,ry,rz: half a box]")
        .required();
    command.option("--evaluator", *evaluator, "Which evaluator answers")
        .oneOf({"reference", "batch", "interval", "affine"})
        .showDefault();
    auto work = std::make_shared<WorkLimit>();
    work->addTo(command, "Seconds to work on each row, or on 64 that share a function");
    command.run([=] { return evaluateTable(*table, *evaluator, *work); });
}

}  // namespace isoscope::cli
