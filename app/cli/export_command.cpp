// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/time_limit.h"
#include "core/animation/animation.h"
#include "core/animation/animation_export.h"
#include "core/exchange/isosurface_export.h"
#include "core/exchange/pov_export.h"
#include "core/exchange/virtualight_export.h"
#include "core/exchange/virtualight_writer.h"
#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/proof_note.h"

namespace isoscope::cli {

namespace {

struct ExportArguments {
    SceneArguments scene;
    std::string output;
    int width = 800;
    int height = 600;
    bool animation = false;
    bool note = false;
    WorkLimit work;
    OutputFiles outputs;
};

/// The scene whose numbers follow `clock`, and the settings that make POV-Ray draw all frames, beside it.
ExitStatus exportAnimation(const ExportArguments& arguments) {
    std::filesystem::path settings = arguments.output;
    settings.replace_extension(".ini");
    if (!arguments.outputs.mayWrite(arguments.output, OutputKind::scene, arguments.scene.file) ||
        !arguments.outputs.mayWrite(settings.string(), OutputKind::renderSettings, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (!parsed.ok()) return inputHasErrors;
    if (parsed.notation != Notation::povray) {
        std::cerr << arguments.scene.file << ": error: VirtuaLight's texts have no clock\n";
        return inputHasErrors;
    }
    const Timeline timeline = timelineOf((*parsed.sources)[0].text());
    const Animation animation(timeline, parsed.scene->parameters);
    for (const std::string& name : animation.missing())
        std::cerr << arguments.scene.file << ": warning: no number of the text is called `" << name << "`\n";
    const std::string scene = std::filesystem::path(arguments.output).filename().string();
    const bool written =
        writeOutput(arguments.output, markedExport(animationScene(parsed, timeline))) &&
        writeOutput(settings.string(), animationSettings(timeline, scene, arguments.width, arguments.height));
    return written ? done : inputHasErrors;
}

/// What is proven of an isosurface until the stop, as a comment.
std::string noteOf(const ParseResult& parsed, std::size_t isosurface, const std::stop_token& stop) {
    const Isosurface& surface = *parsed.scene->isosurfaces[isosurface].shape;
    GradientStudy study(surface.prepared(*parsed.scene->parameterTable), surface.settings().container);
    return proofNote(study.run(stop), surface.rootSettings().accuracy, parsed.scene->camera,
                     ISOSCOPE_VERSION);
}

ExitStatus exportFile(const ExportArguments& arguments) {
    const std::filesystem::path output = arguments.output;
    const std::string extension = output.extension().string();
    if (extension != ".pov" && extension != ".inc" && extension != ".vl") {
        std::cerr << "error: `" << arguments.output << "` should end in .pov, .inc or .vl\n";
        return wrongUsage;
    }
    if (arguments.animation) {
        if (extension != ".pov") throw UsageError("--animation: the output should end in .pov");
        return exportAnimation(arguments);
    }
    if (arguments.note && extension != ".inc") throw UsageError("--note: the output should end in .inc");
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
        const TimeLimit limit(arguments.work.seconds);
        for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i) {
            const IsosurfaceExport block = exportIsosurface(parsed, i);
            if (!block.problem.empty()) {
                std::cerr << arguments.scene.file << ": error: " << block.problem << '\n';
                return inputHasErrors;
            }
            exported +=
                arguments.note ? withNote(block.text, noteOf(parsed, i, limit.token()), parsed) : block.text;
        }
        if (arguments.note && limit.over())
            arguments.work.note(arguments.scene.file, "the comments say what is proven so far");
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
    command.flag("--animation", arguments->animation,
                 "OUT.pov with numbers that follow clock as the timeline has them, and its OUT.ini");
    command.flag(
        "--note", arguments->note,
        "OUT.inc: a comment in front of each isosurface with proven bound, method, view and version");
    arguments->work.addTo(command, "Seconds to prove what --note tells");
    arguments->outputs.addTo(command);
    command.run([=] { return exportFile(*arguments); });
}

}  // namespace isoscope::cli
