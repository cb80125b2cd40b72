// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/exchange/frame_sequence.h"
#include "core/exchange/png.h"
#include "core/render/render_image.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct FramesArguments {
    SceneArguments scene;
    FrameSequence frames;
    std::string part = "1/1";
    std::string solver = "lipschitz";
    int width = 800;
    int height = 600;
    int threads = 0;
    bool antialias = false;
    OutputFiles outputs;
};

/// The frame as a picture; false, with messages on standard error, where the text has errors for its clock or
/// the file cannot be written. Then no picture is left of it, so that the next call tries again.
bool drawFrame(const FramesArguments& arguments, int frame, const std::string& file) {
    SceneArguments scene = arguments.scene;
    scene.frame = frame;
    scene.finalFrame = arguments.frames.last;
    scene.clock = arguments.frames.clock(frame);
    const ParseResult parsed = loadScene(scene, arguments.width, arguments.height);
    if (!parsed.ok()) {
        printDiagnostics(parsed.diagnostics, *parsed.sources, true);
        return false;
    }
    RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
    request.antialias = arguments.antialias;
    const Image image = renderImage(request, arguments.threads);
    return writeOutput(file, encodePng(image, arguments.threads));
}

ExitStatus drawFrames(FramesArguments arguments) {
    namespace fs = std::filesystem;
    const std::optional<WorkPart> part = readWorkPart(arguments.part);
    if (!part) throw UsageError("--part: `" + arguments.part + "` is not of the form K/N with K from 1 to N");
    if (arguments.frames.last < arguments.frames.first)
        throw UsageError("--last must not be less than --first");
    const fs::path scene = arguments.scene.file;
    if (arguments.frames.beginning.empty()) arguments.frames.beginning = scene.stem().string();
    if (const fs::path folder = fs::path(arguments.frames.beginning).parent_path(); !folder.empty()) {
        std::error_code failed;
        fs::create_directories(folder, failed);
        if (failed) {
            std::cerr << folder.string() << ": error: the folder cannot be made: " << failed.message()
                      << '\n';
            return inputHasErrors;
        }
    }
    if (!fs::exists(scene)) {
        std::cerr << arguments.scene.file << ": error: the file cannot be read\n";
        return inputHasErrors;
    }
    std::cout << csvLine({"frame", "clock", "file", "state", "seconds"});
    ExitStatus status = done;
    for (const int frame : arguments.frames.framesOf(*part)) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point begin = Clock::now();
        const std::string file = arguments.frames.file(frame).string();
        std::string state = "kept";
        if (arguments.outputs.force || !isDrawn(file, arguments.width, arguments.height, scene)) {
            const bool drawn = arguments.outputs.mayWrite(file, OutputKind::picture, arguments.scene.file) &&
                               drawFrame(arguments, frame, file);
            state = drawn ? "drawn" : "error";
            if (!drawn) status = inputHasErrors;
        }
        const std::chrono::duration<double> took = Clock::now() - begin;
        std::cout << csvLine({std::to_string(frame), exactNumber(arguments.frames.clock(frame)), file, state,
                              fixedNumber(took.count(), 3)})
                  << std::flush;
    }
    return status;
}

}  // namespace

void addFramesCommand(CommandLine& line) {
    Command command = line.add("frames", "Draws the frames of an animation into numbered PNG files");
    auto arguments = std::make_shared<FramesArguments>();
    arguments->scene.addTo(command, SceneArguments::Moment::ofCommand);
    constexpr int largestSide = 16384, largestFrame = 9'999'999;
    FrameSequence& frames = arguments->frames;
    command.option("--first", frames.first, "Number of the first frame").within(0, largestFrame).required();
    command.option("--last", frames.last, "Number of the last frame").within(0, largestFrame).required();
    command.option("--first-clock", frames.firstClock, "Value of clock in the first frame").showDefault();
    command.option("--last-clock", frames.finalClock, "Value of clock in the last frame").showDefault();
    command.option("--part", arguments->part,
                   "K/N: only every N-th frame, from the K-th on, for one of N calls at a time");
    command.option("-o,--output", frames.beginning,
                   "How the names of the pictures begin, folder included (default: as the scene's)");
    command.option("-W,--width", arguments->width, "Width in pixels").within(1, largestSide).showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    command.option("--threads", arguments->threads, "Number of threads; 0 means all cores").within(0, 1024);
    command.flag("--antialias", arguments->antialias, "Smooth edges: nine samples a pixel");
    arguments->outputs.addTo(command);
    addSolverOption(command, arguments->solver);
    command.run([=] { return drawFrames(*arguments); });
}

}  // namespace isoscope::cli
