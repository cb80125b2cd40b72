// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/study/rewrites/formula_rewrites.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"
#include "core/text/text_change.h"

namespace isoscope::cli {

namespace {

struct RewritesArguments {
    SceneArguments scene;
    int apply = 0;
    std::string output;
    WorkLimit work;
    OutputFiles outputs;
};

void print(const ParseResult& parsed, std::size_t number, const FormulaRewrite& rewrite) {
    const LineColumn place = (*parsed.sources)[0].position(rewrite.fix.range.begin);
    std::cout << csvLine({std::to_string(number), std::to_string(place.line), std::to_string(place.column),
                          std::string(name(rewrite.kind)), std::string(name(rewrite.proof)),
                          exactNumber(rewrite.largestDifference), std::to_string(rewrite.points),
                          shortestNumber(rewrite.nanoseconds[0]), shortestNumber(rewrite.nanoseconds[1]),
                          exactNumber(rewrite.off[0]), exactNumber(rewrite.off[1]),
                          std::string(parsed.sources->slice(rewrite.fix.range)), rewrite.fix.replacement,
                          describe(rewrite)});
}

ExitStatus tellRewrites(const RewritesArguments& arguments) {
    if ((arguments.apply > 0) != !arguments.output.empty())
        throw UsageError("--apply and --output go together");
    if (!arguments.outputs.mayWrite(arguments.output, OutputKind::scene, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::string& file = arguments.scene.file;
    const std::size_t count = parsed.scene->isosurfaces.size();
    if (count == 0) {
        std::cerr << file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    std::cout << csvLine({"number", "line", "column", "kind", "proof", "largest_difference", "points",
                          "povray_ns", "povray_ns_after", "off", "off_after", "text", "replacement",
                          "explanation"});
    const TimeLimit limit(arguments.work.seconds);
    std::vector<FormulaRewrite> all;
    ProgressLine progress(file);
    for (std::size_t i = 0; i < count; ++i) {
        const auto show = [&](double done) {
            progress.show((static_cast<double>(i) + done) / static_cast<double>(count));
        };
        const auto found = formulaRewrites(parsed, i, show, limit.token());
        for (const FormulaRewrite& one : found) {
            // Two isosurfaces may share a function.
            if (std::ranges::find(all, one.fix, &FormulaRewrite::fix) != all.end()) continue;
            all.push_back(one);
            print(parsed, all.size(), one);
        }
    }
    if (limit.over()) {
        arguments.work.error(file, "there may be more rewrites");
        return inputHasErrors;
    }
    if (arguments.apply == 0) return parsed.ok() ? done : inputHasErrors;
    if (static_cast<std::size_t>(arguments.apply) > all.size()) {
        std::cerr << file << ": error: there is no rewrite " << arguments.apply << '\n';
        return inputHasErrors;
    }
    const std::string text = rewritten(parsed, all[static_cast<std::size_t>(arguments.apply - 1)]);
    return writeOutput(arguments.output, text) && parsed.ok() ? done : inputHasErrors;
}

}  // namespace

void addRewritesCommand(CommandLine& line) {
    Command command =
        line.add("rewrites", "Quicker or more exact ways to write the formulas of isosurfaces, with proof");
    auto arguments = std::make_shared<RewritesArguments>();
    arguments->scene.addTo(command);
    constexpr int mostRewrites = 1'000'000;
    command.option("--apply", arguments->apply, "Write the scene with the rewrite of this number")
        .within(1, mostRewrites);
    command.option("-o,--output", arguments->output, "OUT.pov, for --apply");
    arguments->work.addTo(command);
    arguments->outputs.addTo(command);
    command.run([=] { return tellRewrites(*arguments); });
}

}  // namespace isoscope::cli
