// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/exchange/png.h"
#include "core/exchange/povray_process.h"
#include "core/study/view/povray_comparison.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct CompareArguments {
    SceneArguments scene;
    std::string difference;
    std::string povray;
    int width = 320;
    int height = 240;
    int threads = 0;
    WorkLimit work{WorkLimit::ofPictures};
    OutputFiles outputs;
};

/// The file's text as it is, with the values of the command line.
PovrayOrder orderOf(const CompareArguments& arguments) {
    PovrayOrder order;
    std::ifstream input(arguments.scene.file, std::ios::binary);
    order.text.assign(std::istreambuf_iterator<char>(input), {});
    order.width = arguments.width;
    order.height = arguments.height;
    std::error_code failed;
    order.folder = std::filesystem::absolute(arguments.scene.file, failed).parent_path();
    for (const std::string& declaration : arguments.scene.declarations)
        order.options.push_back("Declare=" + declaration);
    if (arguments.scene.clock) order.options.push_back("+K" + exactNumber(*arguments.scene.clock));
    return order;
}

void print(const PovrayComparison& comparison) {
    std::cout << csvLine({"cause", "pixels", "share"});
    const auto row = [&](const std::string& what, std::uint64_t pixels) {
        const double share = static_cast<double>(pixels) / static_cast<double>(comparison.causes.size());
        std::cout << csvLine({what, std::to_string(pixels), exactNumber(share)});
    };
    row("all", comparison.causes.size());
    row("differing", comparison.differing());
    for (std::size_t cause = 1; cause < differenceCauseCount; ++cause)
        row(name(static_cast<DifferenceCause>(cause)), comparison.counts[cause]);
}

ExitStatus compare(const CompareArguments& arguments) {
    for (const std::string& file : {arguments.difference, arguments.povray})
        if (!arguments.outputs.mayWrite(file, OutputKind::picture, arguments.scene.file))
            return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (!parsed.ok()) return inputHasErrors;
    if (parsed.notation != Notation::povray) {
        std::cerr << arguments.scene.file << ": error: POV-Ray reads its own language only\n";
        return inputHasErrors;
    }
    if (const std::string reason = whyNotForPovray(parsed.writtenFiles); !reason.empty()) {
        std::cerr << arguments.scene.file << ": error: " << reason << "; it is not given to POV-Ray\n";
        return inputHasErrors;
    }
    const TimeLimit limit(arguments.work.seconds);
    PovrayPicture povray;
    {
        ProgressLine progress("POV-Ray draws");
        povray =
            drawWithPovray(orderOf(arguments), limit.token(), [&](double share) { progress.show(share); });
    }
    if (povray.stopped) {
        arguments.work.error(arguments.scene.file, "POV-Ray has not drawn its picture");
        return inputHasErrors;
    }
    if (povray.image.pixels.empty()) {
        std::cerr << arguments.scene.file << ": error: " << povray.problem << '\n';
        return inputHasErrors;
    }
    const bool leavesOut =
        std::any_of(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                    [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::leftOut; });
    ProgressLine progress("comparing");
    const PovrayComparison comparison = compareWithPovray(
        pictureOf(parsed, arguments.width, arguments.height, "certified"), povray.image, leavesOut,
        arguments.threads, limit.token(), [&](double share) { progress.show(share); });
    if (limit.over()) {
        arguments.work.error(arguments.scene.file, "the pictures are not compared");
        return inputHasErrors;
    }
    if (!comparison.complete) {
        std::cerr << arguments.scene.file << ": error: the pictures cannot be compared\n";
        return inputHasErrors;
    }
    print(comparison);
    if (!arguments.difference.empty() && !writeOutput(arguments.difference, encodePng(picture(comparison))))
        return inputHasErrors;
    if (!arguments.povray.empty() && !writeOutput(arguments.povray, encodePng(povray.image)))
        return inputHasErrors;
    return done;
}

}  // namespace

void addCompareCommand(CommandLine& line) {
    Command command =
        line.add("compare", "Has the installed POV-Ray draw a scene and tells where and why it differs");
    auto arguments = std::make_shared<CompareArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = 4096;
    command.option("-o,--output", arguments->difference, "OUT.png: what differs, in the colour of its cause");
    command.option("--povray-picture", arguments->povray, "OUT.png: POV-Ray's own picture");
    command.option("-W,--width", arguments->width, "Width in pixels").within(1, largestSide).showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    command.option("--threads", arguments->threads, "Number of threads; 0 means all cores").within(0, 1024);
    arguments->work.addTo(command);
    arguments->outputs.addTo(command);
    command.run([=] { return compare(*arguments); });
}

}  // namespace isoscope::cli
