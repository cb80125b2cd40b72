// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/animation/animation.h"
#include "core/exchange/frame_sequence.h"
#include "core/exchange/png.h"
#include "core/render/render_image.h"
#include "core/text/number_format.h"
#include "core/text/scene_file.h"

namespace isoscope::cli {

namespace {

struct FramesArguments {
    SceneArguments scene;
    FrameSequence frames;
    /// What the timeline of the text says where these are left out.
    std::optional<int> first, last;
    std::optional<double> firstClock, finalClock;
    std::string part = "1/1";
    std::string solver = "lipschitz";
    int width = 800;
    int height = 600;
    int threads = 0;
    bool antialias = false;
    OutputFiles outputs;
};

/// The frame as a picture, and warnings about its timeline, unless there were some already; false, with
/// messages on standard error, where the text has errors for its clock or the file cannot be written. Then no
/// picture is left of it, so that the next call tries again.
bool drawFrame(const FramesArguments& arguments, int frame, const std::string& file, bool& warned) {
    SceneArguments scene = arguments.scene;
    scene.frame = frame;
    scene.finalFrame = arguments.frames.last;
    scene.clock = arguments.frames.clock(frame);
    const ParseResult parsed = loadScene(scene, arguments.width, arguments.height);
    if (!parsed.ok()) {
        printDiagnostics(parsed.diagnostics, *parsed.sources, true);
        return false;
    }
    // What is true of all frames is said once.
    if (!std::exchange(warned, true))
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.id == unknownKeysId || diagnostic.id == brokenTimelineId)
                std::cerr << toString(diagnostic, *parsed.sources) << '\n';
    RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
    request.antialias = arguments.antialias;
    const Image image = renderImage(request, arguments.threads);
    return writeOutput(file, encodePng(image, arguments.threads));
}

/// Which frames they are: by the options, else by the timeline of the text.
void chooseFrames(FramesArguments& arguments, const Timeline& timeline) {
    if (!timeline.any() && (!arguments.first || !arguments.last))
        throw UsageError("--first and --last are needed: the scene has no timeline");
    FrameSequence& frames = arguments.frames;
    frames.first = arguments.first.value_or(timeline.frames.first);
    frames.last = arguments.last.value_or(timeline.frames.last);
    if (frames.last < frames.first) throw UsageError("--last must not be less than --first");
    // A part of the timeline keeps its clock.
    const bool within =
        timeline.any() && frames.first >= timeline.frames.first && frames.last <= timeline.frames.last;
    const auto clock = [&](int frame, double otherwise) {
        return within ? timeline.frames.clock(frame) : otherwise;
    };
    frames.firstClock = arguments.firstClock.value_or(clock(frames.first, 0));
    frames.finalClock = arguments.finalClock.value_or(clock(frames.last, 1));
}

ExitStatus drawFrames(FramesArguments arguments) {
    namespace fs = std::filesystem;
    const std::optional<WorkPart> part = readWorkPart(arguments.part);
    if (!part) throw UsageError("--part: `" + arguments.part + "` is not of the form K/N with K from 1 to N");
    const fs::path scene = arguments.scene.file;
    std::string problem;
    const std::optional<std::string> text = readSceneText(scene, problem);
    if (!text) {
        std::cerr << arguments.scene.file << ": error: " << problem << '\n';
        return inputHasErrors;
    }
    chooseFrames(arguments, timelineOf(*text));
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
    std::cout << csvLine({"frame", "clock", "file", "state", "seconds"});
    ExitStatus status = done;
    bool warned = false;
    for (const int frame : arguments.frames.framesOf(*part)) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point begin = Clock::now();
        const std::string file = arguments.frames.file(frame).string();
        std::string state = "kept";
        if (arguments.outputs.force || !isDrawn(file, arguments.width, arguments.height, scene)) {
            const bool drawn = arguments.outputs.mayWrite(file, OutputKind::picture, arguments.scene.file) &&
                               drawFrame(arguments, frame, file, warned);
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
    constexpr int largestSide = 16384;
    command.option("--first", arguments->first, "Number of the first frame (default: that of the timeline)")
        .within(0, mostFrames);
    command.option("--last", arguments->last, "Number of the last frame (default: that of the timeline)")
        .within(0, mostFrames);
    command.option("--first-clock", arguments->firstClock,
                   "Value of clock in the first frame (default: that of the timeline, else 0)");
    command.option("--last-clock", arguments->finalClock,
                   "Value of clock in the last frame (default: that of the timeline, else 1)");
    command.option("--part", arguments->part,
                   "K/N: only every N-th frame, from the K-th on, for one of N calls at a time");
    command.option("-o,--output", arguments->frames.beginning,
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
