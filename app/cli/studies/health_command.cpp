// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/study/health/function_health.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

using Json = nlohmann::ordered_json;

struct HealthArguments {
    SceneArguments scene;
    std::size_t boxes = HealthSettings().boxLimit;
    WorkLimit work;
    bool json = false;
};

/// Of the time for looking for places; what is left is for finding out about them.
constexpr double shareOfSearch = 0.75;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json place(const glm::dvec3& p) { return Json::array({number(p.x), number(p.y), number(p.z)}); }

Json jsonOf(const FunctionHealth& health, const std::string& line) {
    Json json{{"line", line}, {"known", health.known}, {"finished", health.finished}};
    json["resolution"] = number(health.resolution);
    json["findings"] = Json::array();
    for (const HealthFinding& one : health.findings)
        json["findings"].push_back(
            {{"kind", name(one.ailment)},
             {"place", place(one.place)},
             {"region", {{"low", place(one.region.low)}, {"high", place(one.region.high)}}},
             {"confirmed", one.confirmed},
             {"size", number(one.size)},
             {"distance", number(one.distance)},
             {"consequence", consequence(one.ailment)}});
    return json;
}

void printTable(const FunctionHealth& health, const std::string& line) {
    for (const HealthFinding& one : health.findings)
        std::cout << csvLine({line, std::string(name(one.ailment)), exactNumber(one.place.x),
                              exactNumber(one.place.y), exactNumber(one.place.z), exactNumber(one.distance),
                              exactNumber(one.size), one.confirmed ? "met" : "suspected",
                              std::string(consequence(one.ailment))});
}

ExitStatus tellHealth(const HealthArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::string& file = arguments.scene.file;
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    HealthSettings settings;
    settings.boxLimit = arguments.boxes;
    const TimeLimit limit(arguments.work.seconds), search(arguments.work.seconds * shareOfSearch);
    ExitStatus status = parsed.ok() ? done : inputHasErrors;
    Json list = Json::array();
    if (!arguments.json)
        std::cout << csvLine({"line", "kind", "x", "y", "z", "distance", "size", "certainty", "consequence"});
    for (const SceneIsosurface& isosurface : parsed.scene->isosurfaces) {
        const std::string line =
            std::to_string((*parsed.sources)[isosurface.range.file].position(isosurface.range.begin).line);
        ProgressLine progress(file + ":" + line);
        const FunctionHealth health = functionHealth(
            *isosurface.shape, *parsed.scene->parameterTable, settings,
            [&](double done) { progress.show(done); }, limit.token(), search.token());
        if (limit.over()) {
            arguments.work.error(file + ":" + line,
                                 "nothing is known of this function, and of any behind it");
            status = inputHasErrors;
            break;
        }
        if (search.over() && !health.finished) {
            arguments.work.note(file + ":" + line, "there may be more than is told");
        } else if (!health.finished) {
            std::cerr << file << ":" << line << ": note: the search ended early, there may be more\n";
        }
        if (arguments.json)
            list.push_back(jsonOf(health, line));
        else
            printTable(health, line);
    }
    if (arguments.json) std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return status;
}

}  // namespace

void addHealthCommand(CommandLine& line) {
    Command command = line.add(
        "health", "Where functions are undefined or infinite, jump, lose digits or have kinks, and how near");
    auto arguments = std::make_shared<HealthArguments>();
    arguments->scene.addTo(command);
    command.option("--boxes", arguments->boxes, "Boxes to look at before giving up").showDefault();
    arguments->work.addTo(command);
    command.flag("--json", arguments->json, "One JSON array instead of CSV, with the regions");
    command.run([=] { return tellHealth(*arguments); });
}

}  // namespace isoscope::cli
