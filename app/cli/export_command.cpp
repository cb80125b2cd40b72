// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/exchange/isosurface_export.h"
#include "core/exchange/pov_export.h"
#include "core/exchange/virtualight_export.h"
#include "core/exchange/virtualight_writer.h"

namespace isoscope::cli {

namespace {

struct ExportArguments {
    SceneArguments scene;
    std::string output;
    int width = 800;
    int height = 600;
    OutputFiles outputs;
};

ExitStatus exportFile(const ExportArguments& arguments) {
    const std::filesystem::path output = arguments.output;
    const std::string extension = output.extension().string();
    if (extension != ".pov" && extension != ".inc" && extension != ".vl") {
        std::cerr << "error: `" << arguments.output << "` should end in .pov, .inc or .vl\n";
        return wrongUsage;
    }
    if (!arguments.outputs.mayWrite(arguments.output, OutputKind::scene, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (!parsed.ok()) return inputHasErrors;

    const Scene& scene = *parsed.scene;
    const std::string text((*parsed.sources)[0].text());
    const std::string stem = output.stem().string();
    if (parsed.notation == Notation::virtualight && extension != ".vl") {
        const VirtualightExport made = extension == ".pov" ? exportVirtualight(parsed, scene.camera, stem)
                                                           : virtualightObjects(parsed, stem);
        if (made.text.empty()) {
            std::cerr << arguments.scene.file << ": error: there is no object to export\n";
            return inputHasErrors;
        }
        for (const std::filesystem::path& image : made.imagesBeside(output))
            if (!arguments.outputs.mayWrite(image.string(), OutputKind::picture, arguments.scene.file))
                return inputHasErrors;
        const std::string problem = made.write(output);
        if (problem.empty()) return done;
        std::cerr << "error: " << problem << '\n';
        return inputHasErrors;
    }
    std::string exported;
    if (extension == ".pov") {
        exported = exportScene(scene, scene.camera, text, arguments.width, arguments.height);
    } else if (extension == ".vl") {
        exported = parsed.notation == Notation::virtualight ? text : virtualightText(scene);
    } else {
        for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i) {
            const IsosurfaceExport block = exportIsosurface(parsed, i);
            if (!block.problem.empty()) {
                std::cerr << arguments.scene.file << ": error: " << block.problem << '\n';
                return inputHasErrors;
            }
            exported += block.text;
        }
        if (exported.empty()) {
            std::cerr << arguments.scene.file << ": error: there is no isosurface to export\n";
            return inputHasErrors;
        }
    }
    return writeOutput(arguments.output, markedExport(exported)) ? done : inputHasErrors;
}

}  // namespace

void addExportCommand(CommandLine& line) {
    Command command = line.add("export", "Writes a scene or its isosurfaces for POV-Ray");
    auto arguments = std::make_shared<ExportArguments>();
    arguments->scene.addTo(command);
    command
        .option("-o,--output", arguments->output,
                "OUT.pov (whole scene), OUT.inc (isosurfaces, or the objects of a VirtuaLight text) or "
                "OUT.vl (objects)")
        .required();
    command.option("-W,--width", arguments->width, "image_width the scene is read with").showDefault();
    command.option("-H,--height", arguments->height, "image_height the scene is read with").showDefault();
    arguments->outputs.addTo(command);
    command.run([=] { return exportFile(*arguments); });
}

}  // namespace isoscope::cli
