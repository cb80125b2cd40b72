// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "app/cli/studies/value_range.h"
#include "core/study/range/scene_ranges.h"
#include "core/study/sweep/parameter_sweep.h"

namespace isoscope::cli {

namespace {

using Json = nlohmann::ordered_json;

struct SweepArguments {
    SceneArguments scene;
    ValueRange range;
    int isosurface = 0;
    int width = 160;
    int height = 120;
    WorkLimit work{WorkLimit::ofPictures};
    bool json = false;
};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json jsonOf(const SweepPoint& point) {
    Json json{{"value", point.value}, {"known", point.known}};
    if (!point.known) return json;
    json["povray_evaluations"] = point.evaluationsPerPixel[0];
    json["certified_evaluations"] = point.evaluationsPerPixel[1];
    json["hit_share"] = point.hitShare;
    json["gradient_low"] = number(point.gradientLow);
    json["gradient_high"] = number(point.gradientHigh);
    json["pieces"] = point.solid.pieces;
    json["tunnels"] = point.solid.tunnels;
    json["hollows"] = point.solid.hollows;
    return json;
}

/// The first isosurface that the number has to do with, else the first of all.
std::size_t isosurfaceOf(const Scene& scene, std::size_t parameter) {
    for (const RangeSubject& subject : rangeSubjects(scene))
        if (subject.parameter == parameter) return subject.isosurface;
    return 0;
}

ExitStatus sweep(const SweepArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << arguments.scene.file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    const auto varied = arguments.range.find(parsed, arguments.scene.file);
    if (!varied) return inputHasErrors;
    SweepRequest request;
    request.view.width = arguments.width;
    request.view.height = arguments.height;
    request.width = arguments.width;
    request.ownCamera = true;
    request.values = varied->values;
    request.isosurface = arguments.isosurface > 0 ? static_cast<std::size_t>(arguments.isosurface - 1)
                                                  : isosurfaceOf(*parsed.scene, varied->parameter);
    request.sceneAt = [&](double value) {
        const NumberSetting setting{varied->parameter, value};
        return sceneWithNumbers(parsed, {&setting, 1});
    };
    const TimeLimit limit(arguments.work.seconds);
    ProgressLine progress(arguments.scene.file);
    ParameterSweep study(std::move(request));
    Json list = Json::array();
    if (!arguments.json) std::cout << sweepTableHeader();
    while (const std::optional<SweepPoint> point = study.next(limit.token())) {
        progress.show(static_cast<double>(study.done()) / static_cast<double>(study.size()));
        if (arguments.json)
            list.push_back(jsonOf(*point));
        else
            std::cout << sweepTableLine(*point) << std::flush;
    }
    if (arguments.json) std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    if (study.done() < study.size())
        arguments.work.error(arguments.scene.file, "the values that are left are not studied");
    return parsed.ok() && study.done() == study.size() ? done : inputHasErrors;
}

}  // namespace

void addSweepCommand(CommandLine& line) {
    Command command =
        line.add("sweep", "What values of a number cost and give: evaluations, gradient, pieces");
    auto arguments = std::make_shared<SweepArguments>();
    arguments->scene.addTo(command);
    arguments->range.addTo(command, "");
    constexpr int largestSide = 4096;
    command
        .option("--isosurface", arguments->isosurface,
                "Which one's gradient and pieces, from 1 (default: the first with the number)")
        .within(1, 1'000'000);
    command.option("-W,--width", arguments->width, "Width of the pictures that are counted")
        .within(1, largestSide)
        .showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    arguments->work.addTo(command);
    command.flag("--json", arguments->json, "One JSON array instead of CSV");
    command.run([=] { return sweep(*arguments); });
}

}  // namespace isoscope::cli
