// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/time_limit.h"
#include "core/study/accuracy/povray_time.h"
#include "core/study/view/container_fit.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct ContainerArguments {
    SceneArguments scene;
    int width = 320;
    int height = 240;
    std::string changedScene;
    WorkLimit work;
    OutputFiles outputs;
};

/// As a cell of the table; empty after a stop.
std::string povraySecondsOf(const RenderRequest& view, const std::stop_token& stop) {
    const PovrayCounts counts = countForPovray(view, std::min(view.width, 160), stop);
    if (!counts.complete) return {};
    return shortestNumber(povraySeconds(counts, static_cast<double>(view.width) * view.height));
}

ExitStatus fitContainers(const ContainerArguments& arguments) {
    if (!arguments.outputs.mayWrite(arguments.changedScene, OutputKind::scene, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << arguments.scene.file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    const RenderRequest view = pictureOf(parsed, arguments.width, arguments.height, "lipschitz");
    const TimeLimit limit(arguments.work.seconds);
    const std::string present = povraySecondsOf(view, limit.token());
    std::vector<TextChange> changes;
    std::cout << csvLine(
        {"line", "container", "fitted", "volume_share", "povray_seconds", "fitted_povray_seconds"});
    for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
        const SceneIsosurface& isosurface = parsed.scene->isosurfaces[i];
        const SourceText& text = (*parsed.sources)[isosurface.range.file];
        const Container& container = isosurface.shape->settings().container;
        const ContainerFit fit =
            fitContainer(isosurface.shape, *parsed.scene->parameterTable, containerReach, limit.token());
        std::vector<std::string> row{std::to_string(text.position(isosurface.range.begin).line),
                                     containerText(container)};
        if (const std::optional<Container> best = fit.best()) {
            RenderRequest fitted = view;
            fitted.scene = sceneWithContainer(*view.scene, *isosurface.shape, *best);
            row.insert(row.end(),
                       {containerText(*best), shortestNumber(volumeOf(*best) / volumeOf(container)), present,
                        povraySecondsOf(fitted, limit.token())});
            if (auto change = containerChange(*parsed.scene, *parsed.sources, i, *best))
                changes.push_back(std::move(*change));
        } else {
            row.insert(row.end(), {fit.empty ? "empty" : "", "", present, ""});
        }
        std::cout << csvLine(row) << std::flush;
    }
    if (limit.over()) arguments.work.note(arguments.scene.file, "there may be smaller containers");
    if (arguments.changedScene.empty()) return parsed.ok() ? done : inputHasErrors;
    const std::string text((*parsed.sources)[0].text());
    return writeOutput(arguments.changedScene, changedText(text, std::move(changes))) && parsed.ok()
               ? done
               : inputHasErrors;
}

}  // namespace

void addContainerCommand(CommandLine& line) {
    Command command =
        line.add("container", "The smallest containers that show the same, proven, and what they save");
    auto arguments = std::make_shared<ContainerArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = 16384;
    command.option("-W,--width", arguments->width, "Of the picture whose time by POV-Ray is predicted")
        .within(1, largestSide)
        .showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    arguments->work.addTo(command);
    command.option("--write", arguments->changedScene, "OUT.pov: the scene with these containers");
    arguments->outputs.addTo(command);
    command.run([=] { return fitContainers(*arguments); });
}

}  // namespace isoscope::cli
