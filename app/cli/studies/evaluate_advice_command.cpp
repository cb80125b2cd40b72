// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/study/gradient/evaluate_advice.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct AdviceArguments {
    SceneArguments scene;
    int width = 320;
    int height = 240;
    WorkLimit work;
};

void print(const std::string& line, const BoundTrial& trial, std::uint64_t pixels, bool best) {
    std::vector<std::string> row{line};
    for (std::size_t k = 0; k < 3; ++k)
        row.push_back(trial.evaluate ? shortestNumber((*trial.evaluate)[k]) : "");
    row.insert(row.end(), {shortestNumber(trial.maxGradient), exactNumber(trial.evaluationsPerPixel),
                           std::to_string(trial.mistakes), std::to_string(pixels), best ? "1" : "0"});
    std::cout << csvLine(row);
}

ExitStatus advise(const AdviceArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::string& file = arguments.scene.file;
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    const RenderRequest view = pictureOf(parsed, arguments.width, arguments.height, "lipschitz");
    const TimeLimit limit(arguments.work.seconds);
    std::cout << csvLine({"line", "p0", "p1", "p2", "max_gradient", "evaluations_per_pixel", "wrong_pixels",
                          "of_pixels", "best"});
    for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
        const SourceRange& range = parsed.scene->isosurfaces[i].range;
        const std::string line = std::to_string((*parsed.sources)[range.file].position(range.begin).line);
        ProgressLine progress(file + ":" + line);
        const EvaluateAdvice advice =
            adviseEvaluate(view, i, 0, limit.token(), [&](double done) { progress.show(done); });
        const BoundTrial* best = advice.best();
        if (advice.fixed.maxGradient > 0) print(line, advice.fixed, advice.pixels, !best);
        for (const BoundTrial& trial : advice.trials) print(line, trial, advice.pixels, &trial == best);
        if (!limit.over()) continue;
        arguments.work.error(file + ":" + line, "more was to be tried");
        return inputHasErrors;
    }
    return parsed.ok() ? done : inputHasErrors;
}

}  // namespace

void addEvaluateAdviceCommand(CommandLine& line) {
    Command command = line.add(
        "evaluate-advice", "Which numbers of `evaluate` pay, beside the proven max_gradient, in this view");
    auto arguments = std::make_shared<AdviceArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = 4096;
    command.option("-W,--width", arguments->width, "Width of the picture that is meant")
        .within(1, largestSide)
        .showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    arguments->work.addTo(command);
    command.run([=] { return advise(*arguments); });
}

}  // namespace isoscope::cli
