// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/exchange/png.h"
#include "core/language/directives/written_files.h"
#include "core/language/reading_limits.h"
#include "core/render/render_image.h"
#include "core/study/gradient/hole_map.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct RenderArguments {
    SceneArguments scene;
    std::string output;
    std::string statistics;
    std::string holeMap;
    std::string solver = "lipschitz";
    int width = 800;
    int height = 600;
    int threads = 0;
    double pictureLimit = std::numeric_limits<double>::infinity();  ///< seconds
    bool antialias = false;
    OutputFiles outputs;
    bool allowWrites = false;
    std::vector<std::string> replaceable;  ///< of the files of `#write`
    int antialiasMethod = 0;
    Antialiasing antialiasing;
};

nlohmann::ordered_json toJson(const RenderStatistics& statistics, const ParseResult& parsed) {
    nlohmann::ordered_json json;
    json["render_cpu_seconds"] = statistics.cpuSeconds;
    json["parse_seconds"] = parsed.seconds;
    json["rays"] = statistics.rays;
    json["evaluations"] = statistics.evaluations;
    json["cut_samples"] = statistics.cutSamples;
    json["verdicts"] = nlohmann::ordered_json::object();
    for (const auto& [verdict, pixels] : statistics.verdicts) json["verdicts"][verdict] = pixels;
    json["stages"] = nlohmann::ordered_json::array();
    for (const StageReport& stage : statistics.stages)
        json["stages"].push_back({{"name", name(stage.kind)},
                                  {"reason", stage.reason},
                                  {"rays", stage.rays},
                                  {"evaluations", stage.evaluations},
                                  {"cpu_seconds", stage.cpuSeconds}});
    json["not_called_for"] = nlohmann::ordered_json::array();
    for (const PlannedStage& stage : statistics.notCalledFor)
        json["not_called_for"].push_back({{"name", name(stage.kind)}, {"reason", stage.reason}});
    json["left_out"] = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : parsed.diagnostics) {
        if (diagnostic.severity != Severity::leftOut) continue;
        const int line = (*parsed.sources)[diagnostic.range.file].position(diagnostic.range.begin).line;
        json["left_out"].push_back({{"line", line}, {"what", diagnostic.message}});
    }
    return json;
}

/// What POV-Ray would say about max_gradient at the end of the picture.
void printGradientWarnings(const RenderStatistics& statistics, const ParseResult& parsed) {
    for (std::size_t i = 0; i < statistics.gradients.size() && i < parsed.scene->isosurfaces.size(); ++i) {
        const std::string text = gradientWarning(statistics.gradients[i]);
        if (text.empty()) continue;
        Diagnostic warning{
            Severity::warning, "max-gradient", parsed.scene->isosurfaces[i].range, text, {}, {}};
        std::cerr << toString(warning, *parsed.sources) << '\n';
    }
}

/// The files of the scene's `#write`, beside it.
bool writeFiles(const RenderArguments& arguments, const ParseResult& parsed) {
    WrittenRecord record;
    const std::vector<RefusedFile> refused =
        writeBeside(arguments.scene.file, parsed.writtenFiles, record,
                    {arguments.replaceable.begin(), arguments.replaceable.end()});
    for (const RefusedFile& file : refused) std::cerr << file.name << ": error: " << file.reason << '\n';
    return refused.empty();
}

/// The picture of what POV-Ray's method loses, and the counts on standard error.
bool writeHoleMap(const std::string& file, const RenderRequest& request, int threads) {
    const HoleMap map = holeMap(request, threads);
    std::cerr << "holes: " << map.count(HolePixel::lost) << " lost, " << map.count(HolePixel::gained)
              << " gained, " << map.count(HolePixel::wrongPlace) << " at a wrong place\n";
    return writeOutput(file, encodePng(picture(map)));
}

bool mayWrite(const RenderArguments& arguments) {
    const OutputFiles& outputs = arguments.outputs;
    const std::string& scene = arguments.scene.file;
    return outputs.mayWrite(arguments.output, OutputKind::picture, scene) &&
           outputs.mayWrite(arguments.holeMap, OutputKind::picture, scene) &&
           outputs.mayWrite(arguments.statistics, OutputKind::statistics, scene);
}

ExitStatus render(const RenderArguments& arguments) {
    if (!mayWrite(arguments)) return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    Diagnostics said = parsed.diagnostics;
    // With leave they are written, or named as refused.
    if (arguments.allowWrites)
        std::erase_if(said, [](const Diagnostic& one) { return one.id == "file-not-written"; });
    printDiagnostics(said, *parsed.sources, false);
    // Scenes with errors are drawn without what is wrong; an empty picture of no scene replaces none.
    if (std::any_of(said.begin(), said.end(),
                    [](const Diagnostic& one) { return one.id == "unreadable-file"; }))
        return inputHasErrors;
    if (parsed.ok() && parsed.scene->objects.empty())
        std::cerr << arguments.scene.file << ": note: the scene has no object\n";
    if (arguments.allowWrites && !writeFiles(arguments, parsed)) return inputHasErrors;

    RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
    request.antialias = arguments.antialias || arguments.antialiasMethod > 0;
    request.antialiasing = arguments.antialiasing;
    if (arguments.antialiasMethod > 0)
        request.antialiasing.method =
            arguments.antialiasMethod == 1 ? SamplingMethod::adaptive : SamplingMethod::recursive;
    RenderStatistics statistics;
    const ReadingLimits limits({}, arguments.pictureLimit, std::numeric_limits<std::size_t>::max());
    const Image image = renderImage(request, arguments.threads, &statistics, limits.token());
    const bool cut = limits.token().stop_requested();
    if (cut)
        std::cerr << arguments.scene.file << ": error: drawing was cut off after "
                  << shortestNumber(arguments.pictureLimit)
                  << " seconds, the rest of the picture is black (--picture-limit allows more)\n";
    printGradientWarnings(statistics, parsed);
    if (const std::string text = cutWarning(statistics); !text.empty())
        std::cerr << arguments.scene.file << ": warning: " << text << '\n';

    if (!writeOutput(arguments.output, encodePng(image, arguments.threads))) return inputHasErrors;
    if (!arguments.holeMap.empty() && !writeHoleMap(arguments.holeMap, request, arguments.threads))
        return inputHasErrors;
    if (!arguments.statistics.empty() &&
        !writeOutput(arguments.statistics, toJson(statistics, parsed).dump(2) + "\n"))
        return inputHasErrors;
    return parsed.ok() && !cut ? done : inputHasErrors;
}

void addAntialiasing(Command& command, RenderArguments& arguments) {
    Antialiasing& settings = arguments.antialiasing;
    command.flag("--antialias", arguments.antialias, "Smooth edges: nine samples a pixel");
    const Option method =
        command
            .option(
                "--antialias-method", arguments.antialiasMethod,
                "Smooth edges as POV-Ray does: 1 a grid of samples, 2 divided pixels, where colours differ")
            .within(1, 2);
    command.option("--antialias-threshold", settings.threshold, "The difference that counts (+A)")
        .within(0.0, 3.0)
        .needs(method)
        .showDefault();
    command.option("--antialias-depth", settings.depth, "How fine (+R)")
        .within(1, 9)
        .needs(method)
        .showDefault();
    command.option("--antialias-jitter", settings.jitter, "How much samples are moved at random (+J)")
        .within(0.0, 1.0)
        .needs(method)
        .showDefault();
}

}  // namespace

void addRenderCommand(CommandLine& line) {
    Command command = line.add("render", "Draws a scene into a PNG file");
    auto arguments = std::make_shared<RenderArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = 16384;
    command.option("-o,--output", arguments->output, "OUT.png").required();
    command.option("-W,--width", arguments->width, "Width in pixels").within(1, largestSide).showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    command.option("--threads", arguments->threads, "Number of threads; 0 means all cores").within(0, 1024);
    addAntialiasing(command, *arguments);
    command
        .option("--picture-limit", arguments->pictureLimit,
                "Seconds that the picture may take (default: any)")
        .positive();
    command.option("--statistics", arguments->statistics, "OUT.json: what the picture cost");
    command.option("--hole-map", arguments->holeMap, "OUT.png: pixels that POV-Ray's method gets wrong");
    command.flag("--allow-writes", arguments->allowWrites,
                 "Write the files of `#write`, in the folder of the scene only; of files that stand "
                 "there already only those that this scene wrote");
    command
        .option("--replace", arguments->replaceable,
                "NAME of a file that `#write` may replace although this scene did not write it "
                "(repeatable; with --allow-writes)")
        .oneValueEach();
    arguments->outputs.addTo(command);
    addSolverOption(command, arguments->solver);
    command.run([=] { return render(*arguments); });
}

}  // namespace isoscope::cli
