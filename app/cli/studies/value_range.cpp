// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/studies/value_range.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/cli/command_line.h"
#include "core/study/sweep/parameter_sweep.h"

namespace isoscope::cli {

void ValueRange::addTo(Command& command, const std::string& prefix) {
    const bool first = prefix.empty();
    const std::string option = first ? "--parameter" : "--" + prefix;
    const std::string stem = first ? "--" : "--" + prefix + "-";
    const Option named = command.option(
        option, name, "The number's NAME: \"R\", \"threshold\", \"Minor Radius\", \"f_torus Minor Radius\"");
    const auto add = [&](Option added) {
        if (!first) added.needs(named);
        return added;
    };
    if (first) Option(named).required();
    constexpr int mostSteps = 1000;
    add(command.option(stem + "line", line, "Line of the number, where several are called so"))
        .within(1, 100'000'000);
    add(command.option(stem + "from", from, "First value (default: the lower end of its slider)"));
    add(command.option(stem + "to", to, "Last value (default: the upper end of its slider)"));
    add(command.option(stem + "steps", steps, "Number of values")).within(1, mostSteps).showDefault();
}

std::optional<ValueRange::Found> ValueRange::find(const ParseResult& parsed, const std::string& file) const {
    const FoundNumber found = findNumber(parsed, name, line);
    if (!found.parameter) {
        std::cerr << file << ": error: " << found.problem << '\n';
        return std::nullopt;
    }
    const SceneParameter& parameter = parsed.scene->parameters[*found.parameter];
    const double low = from.value_or(parameter.minimum), high = to.value_or(parameter.maximum);
    Found answer{*found.parameter, sweepValues(low, high, steps, parameter.logarithmic)};
    if (parameter.integral)
        for (double& value : answer.values) value = std::round(value);
    answer.values.erase(std::unique(answer.values.begin(), answer.values.end()), answer.values.end());
    if (answer.values.empty()) std::cerr << file << ": error: the ends of the range must be finite\n";
    return answer.values.empty() ? std::nullopt : std::optional(answer);
}

}  // namespace isoscope::cli
