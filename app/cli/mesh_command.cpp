// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/mesh/files/mesh_file.h"
#include "core/mesh/mesh_text.h"
#include "core/mesh/scene_mesh.h"

namespace isoscope::cli {

namespace {

using Json = nlohmann::ordered_json;

struct MeshArguments {
    SceneArguments scene;
    std::string output;
    std::string axes;
    int line = 0;
    bool plain = false;
    bool json = false;
    double megabytes = static_cast<double>(SceneMeshSettings().memory) / 1e6;
    SceneMeshSettings settings;
    WorkLimit work{std::numeric_limits<double>::infinity()};
    OutputFiles outputs;
};

Json jsonOf(const MeshReport& report) {
    const MeshForm& form = report.form;
    Json json;
    json["vertices"] = form.points;
    json["triangles"] = form.triangles;
    json["pieces"] = form.pieces;
    json["euler_characteristic"] = form.euler();
    json["genus"] = form.manifold() ? Json(form.genus()) : Json(nullptr);
    json["watertight"] = form.watertight();
    json["manifold"] = form.manifold();
    json["border_edges"] = form.borderEdges;
    json["cut_by_container"] = report.wallTriangles > 0 || form.borderEdges > 0;
    json["tolerance"] = report.tolerance;
    json["distance"] = report.distance;
    json["distance_samples"] = report.samples;
    json["cells"] = report.cells;
    json["cell_limit_reached"] = report.limited;
    json["doubtful_cells"] = report.doubtfulCells;
    json["widest_doubtful_cell"] = report.widestDoubtful;
    return json;
}

std::string lineOf(const ParseResult& parsed, const PlacedIsosurface& surface) {
    const SourceText& text = (*parsed.sources)[surface.range.file];
    return std::to_string(text.position(surface.range.begin).line);
}

/// What the arguments ask for; none, with a message on standard error, where that is not there.
std::vector<PlacedIsosurface> chosenSurfaces(const MeshArguments& arguments, const ParseResult& parsed) {
    std::vector<PlacedIsosurface> surfaces = placedIsosurfaces(*parsed.scene);
    if (arguments.line > 0)
        std::erase_if(surfaces, [&](const PlacedIsosurface& surface) {
            return lineOf(parsed, surface) != std::to_string(arguments.line);
        });
    if (surfaces.empty())
        std::cerr << arguments.scene.file << ": error: there is no isosurface"
                  << (arguments.line > 0 ? " on line " + std::to_string(arguments.line) : std::string())
                  << '\n';
    for (const PlacedIsosurface& surface : surfaces)
        if (surface.cut)
            std::cerr << arguments.scene.file << ':' << lineOf(parsed, surface)
                      << ": note: other shapes cut this isosurface; the mesh shows it whole\n";
    return surfaces;
}

MeshAxes axesOf(const std::string& word, MeshFormat format) {
    if (word == "povray") return MeshAxes::povray;
    if (word == "y-up") return MeshAxes::yUp;
    return word == "z-up" ? MeshAxes::zUp : usualAxes(format);
}

void print(const MeshArguments& arguments, const ParseResult& parsed,
           const std::vector<PlacedIsosurface>& surfaces, const SceneMesh& made) {
    if (!arguments.json) {
        std::cout << meshText(made.report);
        return;
    }
    Json json = jsonOf(made.report);
    json["isosurfaces"] = Json::array();
    for (std::size_t i = 0; i < made.parts.size(); ++i) {
        Json part;
        part["line"] = std::stoi(lineOf(parsed, surfaces[i]));
        part.update(jsonOf(made.parts[i]));
        json["isosurfaces"].push_back(std::move(part));
    }
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

ExitStatus mesh(const MeshArguments& arguments) {
    const std::optional<MeshFormat> format = meshFormat(arguments.output);
    if (!format) {
        std::cerr << "error: `" << arguments.output
                  << "` should end in .stl, .obj, .ply, .3mf, .glb or .inc\n";
        return wrongUsage;
    }
    if (!arguments.outputs.mayWrite(arguments.output, OutputKind::mesh, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (!parsed.ok()) return inputHasErrors;
    const std::vector<PlacedIsosurface> surfaces = chosenSurfaces(arguments, parsed);
    if (surfaces.empty()) return inputHasErrors;
    SceneMeshSettings settings = arguments.settings;
    settings.colors = !arguments.plain;
    settings.bytesOfTriangle = bytesOfTriangle(*format);
    settings.memory = static_cast<std::size_t>(1e6 * arguments.megabytes);
    const TimeLimit limit(arguments.work.seconds);
    SceneMesh made;
    {
        ProgressLine progress(arguments.scene.file);
        made = meshScene(
            *parsed.scene, surfaces, settings, [&](double done) { progress.show(done); }, limit.token());
    }
    if (limit.over()) {
        arguments.work.error(arguments.scene.file, "there is no mesh; a larger --tolerance may do");
        return inputHasErrors;
    }
    if (!made.problem.empty()) {
        std::cerr << arguments.scene.file << ": error: " << made.problem << '\n';
        return inputHasErrors;
    }
    const MeshFile file = meshFile(std::move(made.mesh), *format, axesOf(arguments.axes, *format));
    if (!file.problem.empty()) {
        std::cerr << arguments.output << ": error: " << file.problem << '\n';
        return inputHasErrors;
    }
    if (!writeOutput(arguments.output, file.content)) return inputHasErrors;
    print(arguments, parsed, surfaces, made);
    if (made.report.limited && !made.report.keepsTolerance())
        std::cerr << arguments.scene.file << ": note: --cells or --memory ended the search before the "
                  << "tolerance was kept; a larger --tolerance, or more of both, help\n";
    return done;
}

}  // namespace

void addMeshCommand(CommandLine& line) {
    Command command = line.add("mesh", "The isosurfaces as triangles: watertight, with the distance kept");
    auto arguments = std::make_shared<MeshArguments>();
    arguments->scene.addTo(command);
    command.option("-o,--output", arguments->output, "OUT.stl, .obj, .ply, .3mf, .glb or .inc (POV-Ray)")
        .required();
    command
        .option("--tolerance", arguments->settings.tolerance,
                "How far mesh and surface may be apart; else a 500th of the container's longest side")
        .positive();
    command.option("--cells", arguments->settings.cellLimit, "Boxes to look at before giving up")
        .showDefault();
    command
        .option("--memory", arguments->megabytes,
                "Megabytes that the meshes may take in all, about; boxes are not split beyond")
        .within(1.0, 1e6)
        .showDefault();
    command.option("--line", arguments->line, "Only isosurfaces whose statement begins on this line");
    command.option("--axes", arguments->axes, "povray, y-up or z-up; else as programs expect of the format")
        .oneOf({"povray", "y-up", "z-up"});
    command.flag("--plain", arguments->plain, "Without the colours of textures");
    command.option("--threads", arguments->settings.threads, "0: all").within(0, 256).showDefault();
    command.flag("--json", arguments->json, "A JSON object instead of sentences");
    command.option("--work-limit", arguments->work.seconds, "Seconds to work on the meshes (default: any)")
        .positive();
    arguments->outputs.addTo(command);
    command.run([=] { return mesh(*arguments); });
}

}  // namespace isoscope::cli
