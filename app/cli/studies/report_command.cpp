// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/study/shape/shape_report.h"

namespace isoscope::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ReportArguments {
    SceneArguments scene;
    int cells = 64;
    WorkLimit work;
    bool json = false;
};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json place(const glm::dvec3& p) { return Json::array({number(p.x), number(p.y), number(p.z)}); }

Json jsonOf(const ShapeReport& report, int line) {
    Json json{{"line", line}, {"known", report.known}};
    if (!report.known) return json;
    json["empty"] = report.empty;
    json["pieces"] = report.solid.pieces;
    json["tunnels"] = report.solid.tunnels;
    json["hollows"] = report.solid.hollows;
    json["cells"] = report.check.cells;
    json["open_cells"] = report.check.open;
    json["extent"] = {{"low", place(report.low)}, {"high", place(report.high)}};
    json["volume"] = {{"low", number(report.volume.low)}, {"high", number(report.volume.high)}};
    json["area"] = {{"value", number(report.area)}, {"error", number(report.areaError)}};
    json["thinnest_wall"] = {{"at_most", number(report.wall.thickness)},
                             {"place", place(report.wall.place)},
                             {"points", report.wall.measured}};
    json["accuracy"] = number(report.accuracy);
    json["symmetries"] = Json::array();
    for (const Symmetry& symmetry : report.symmetries)
        json["symmetries"].push_back({{"name", symmetry.name}, {"error", number(symmetry.error)}});
    json["text"] = Json::array();
    for (const ReportLine& one : linesOf(report))
        json["text"].push_back({{"topic", one.topic}, {"text", one.text}, {"proven", one.proven}});
    return json;
}

ExitStatus reportShapes(const ReportArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::string& file = arguments.scene.file;
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    const TimeLimit limit(arguments.work.seconds);
    ExitStatus status = parsed.ok() ? done : inputHasErrors;
    Json list = Json::array();
    for (const SceneIsosurface& isosurface : parsed.scene->isosurfaces) {
        const int line = (*parsed.sources)[isosurface.range.file].position(isosurface.range.begin).line;
        ShapeReport report;
        {
            ProgressLine progress(file + ":" + std::to_string(line));
            report = shapeReport(
                isosurface.shape, *parsed.scene->parameterTable, arguments.cells,
                [&](double done) { progress.show(done); }, limit.token());
        }
        if (limit.over() && !report.known) {
            arguments.work.error(file + ":" + std::to_string(line),
                                 "there is no report of this isosurface, and of any behind it");
            status = inputHasErrors;
            break;
        }
        if (arguments.json) {
            list.push_back(jsonOf(report, line));
            continue;
        }
        std::cout << "Isosurface in line " << line << '\n';
        for (const ReportLine& one : linesOf(report)) std::cout << one.topic << ": " << one.text << '\n';
        std::cout << std::flush;
    }
    if (arguments.json) std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return status;
}

}  // namespace

void addReportCommand(CommandLine& line) {
    Command command =
        line.add("report",
                 "Pieces, tunnels, extent, volume, area, thinnest wall and symmetry of isosurfaces, as text");
    auto arguments = std::make_shared<ReportArguments>();
    arguments->scene.addTo(command);
    command.option("--cells", arguments->cells, "Of the grid, along the container's longest side")
        .within(4, SolidGrid::mostCells)
        .showDefault();
    arguments->work.addTo(command);
    command.flag("--json", arguments->json, "One JSON array instead of text");
    command.run([=] { return reportShapes(*arguments); });
}

}  // namespace isoscope::cli
