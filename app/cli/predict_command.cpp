// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iostream>
#include <thread>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/time_limit.h"
#include "core/render/render_image.h"
#include "core/study/accuracy/picture_time.h"
#include "core/study/accuracy/povray_time.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct PredictArguments {
    SceneArguments scene;
    std::string solver = "certified";
    int width = 1600;
    int height = 1200;
    int threads = 0;
    bool antialias = false;
    bool check = false;
    WorkLimit work;
};

/// Counts for POV-Ray are taken in a picture of this width.
constexpr int countedWidth = 120;

ExitStatus predict(const PredictArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (parsed.scene->objects.empty()) {
        std::cerr << arguments.scene.file << ": error: the scene has no object\n";
        return inputHasErrors;
    }
    RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
    request.antialias = arguments.antialias;
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const int threads = arguments.threads > 0 ? arguments.threads : cores;
    const double pixels = static_cast<double>(request.width) * request.height;
    std::cout << csvLine({"program", "processor_seconds", "error", "seconds", "threads", "squares", "sampled",
                          "measured_processor_seconds", "off"});
    TimeLimit limit(arguments.work.seconds);
    const PictureTime own = predictPictureTime(request, {}, limit.token());
    if (own.sampled == 0 && limit.over()) {
        arguments.work.error(arguments.scene.file, "not one square of the picture is drawn");
        return inputHasErrors;
    }
    std::vector<std::string> fields{"isoscope",
                                    exactNumber(own.cpuSeconds),
                                    exactNumber(own.error),
                                    exactNumber(own.secondsWith(std::min(threads, cores))),
                                    std::to_string(threads),
                                    std::to_string(own.squares),
                                    std::to_string(own.sampled),
                                    "",
                                    ""};
    if (arguments.check) {
        RenderStatistics statistics;
        renderImage(request, 1, &statistics);
        fields[7] = exactNumber(statistics.cpuSeconds);
        fields[8] = exactNumber(own.cpuSeconds / statistics.cpuSeconds - 1);
        limit.restart();  // the picture takes what it takes
    }
    std::cout << csvLine(fields) << std::flush;
    const PovrayCounts counts = countForPovray(request, std::min(request.width, countedWidth), limit.token());
    if (!counts.complete) {
        arguments.work.error(arguments.scene.file, "POV-Ray's time is not known");
        return inputHasErrors;
    }
    const double povray = povraySeconds(counts, pixels);
    std::cout << csvLine({"povray", exactNumber(povray), exactNumber(povrayTimeError),
                          exactNumber(povray / std::min(threads, cores)), std::to_string(threads), "", "", "",
                          ""});
    return parsed.ok() ? done : inputHasErrors;
}

}  // namespace

void addPredictCommand(CommandLine& line) {
    Command command = line.add("predict", "How long a picture will take, here and in POV-Ray");
    auto arguments = std::make_shared<PredictArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = StripRenderer::longestSide;
    command.option("-W,--width", arguments->width, "Width in pixels").within(1, largestSide).showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    command.flag("--antialias", arguments->antialias,
                 "With smooth edges, nine samples a pixel; POV-Ray's time is told without");
    command.option("--threads", arguments->threads, "Number of threads; 0 means all cores").within(0, 1024);
    command.flag("--check", arguments->check,
                 "Draw the picture as well, with one thread, and tell how far off the prediction is");
    arguments->work.addTo(command, "Seconds to work on the predictions");
    addSolverOption(command, arguments->solver);
    command.run([=] { return predict(*arguments); });
}

}  // namespace isoscope::cli
