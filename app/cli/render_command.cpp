// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/exchange/picture_file.h"
#include "core/exchange/png.h"
#include "core/language/directives/written_files.h"
#include "core/render/render_image.h"
#include "core/study/gradient/hole_map.h"
#include "core/study/view/cost_map.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct RenderArguments {
    SceneArguments scene;
    std::string output;
    std::string statistics;
    std::string holeMap;
    std::string costMap;
    std::string solver = "lipschitz";
    int width = 800;
    int height = 600;
    int threads = 0;
    double pictureLimit = std::numeric_limits<double>::infinity();  ///< seconds
    int depth = 8;
    bool transparent = false;
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

bool writeStatistics(const std::string& file, const PictureFileResult& drawn, const ParseResult& parsed,
                     const std::optional<CostMap>& cost) {
    nlohmann::ordered_json json = toJson(drawn.statistics, parsed);
    if (cost) {
        json["cost"] = {{"evaluations", cost->evaluations()}, {"dearest_pixel", cost->dearest}};
        for (std::size_t i = 0; i < costCauseCount; ++i)
            json["cost"]["causes"][std::string(name(static_cast<CostCause>(i)))] = cost->totals[i];
    }
    return writeOutput(file, json.dump(2) + "\n");
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

/// Says that another picture than the scene's was not drawn in time.
void printCutOff(const std::string& file, double limit) {
    std::cerr << file << ": error: drawing was cut off after " << shortestNumber(limit)
              << " seconds, there is no picture (--picture-limit allows more)\n";
}

/// The picture of what POV-Ray's method loses, and the counts on standard error.
bool writeHoleMap(const RenderArguments& arguments, const RenderRequest& request) {
    const std::string& file = arguments.holeMap;
    const TimeLimit limit(arguments.pictureLimit);
    const HoleMap map = holeMap(request, arguments.threads, limit.token());
    if (!map.complete && limit.over()) return printCutOff(file, arguments.pictureLimit), false;
    std::cerr << "holes: " << map.count(HolePixel::lost) << " lost, " << map.count(HolePixel::gained)
              << " gained, " << map.count(HolePixel::wrongPlace) << " at a wrong place\n";
    return writeOutput(file, encodePng(picture(map)));
}

/// The picture of what each pixel takes, and the sums on standard error.
std::optional<CostMap> writeCostMap(const RenderArguments& arguments, const RenderRequest& request) {
    const std::string& file = arguments.costMap;
    const TimeLimit limit(arguments.pictureLimit);
    CostMap map = costMap(request, arguments.threads, limit.token());  // moved out, not copied
    if (!map.complete && limit.over()) return printCutOff(file, arguments.pictureLimit), std::nullopt;
    const std::uint64_t all = map.evaluations();
    std::cerr << "cost: " << all << " evaluations, at most " << map.dearest << " in a pixel\n";
    for (std::size_t i = 0; i < costCauseCount; ++i) {
        const double share = all > 0 ? static_cast<double>(map.totals[i]) / static_cast<double>(all) : 0;
        std::cerr << "cost: " << map.totals[i] << " (" << std::lround(100 * share) << " %) "
                  << name(static_cast<CostCause>(i)) << '\n';
    }
    if (!writeOutput(file, encodePng(picture(map)))) return {};
    return map;
}

/// PNG, unless the name ends like another format's.
PictureFormat formatOf(const RenderArguments& arguments) {
    return pictureFormat(arguments.output).value_or(PictureFormat::png);
}

RenderRequest requestOf(const RenderArguments& arguments, const ParseResult& parsed) {
    RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
    request.transparent = arguments.transparent;
    request.antialias = arguments.antialias || arguments.antialiasMethod > 0;
    request.antialiasing = arguments.antialiasing;
    if (arguments.antialiasMethod > 0)
        request.antialiasing.method =
            arguments.antialiasMethod == 1 ? SamplingMethod::adaptive : SamplingMethod::recursive;
    return request;
}

/// Draws the picture and tells what was not as it should be. Nothing when it cannot be written.
std::optional<PictureFileResult> drawPicture(const RenderArguments& arguments, const RenderRequest& request,
                                             const ParseResult& parsed) {
    const TimeLimit limit(arguments.pictureLimit);
    PictureFileOptions options;
    options.format = formatOf(arguments);
    options.bits = arguments.depth;
    options.threads = arguments.threads;
    options.keepStopped = true;
    PictureFileResult result;
    {
        ProgressLine progress("drawing");
        result = writePictureFile(arguments.output, request, options, limit.token(),
                                  [&](double share) { progress.show(share); });
    }
    if (!result.problem.empty()) {
        std::cerr << arguments.output << ": error: the file cannot be written: " << result.problem << '\n';
        return {};
    }
    if (result.stopped && !result.kept) {
        printCutOff(arguments.output, arguments.pictureLimit);
        return {};
    }
    if (result.stopped)
        std::cerr << arguments.scene.file << ": error: drawing was cut off after "
                  << shortestNumber(arguments.pictureLimit)
                  << " seconds, the rest of the picture is black (--picture-limit allows more)\n";
    printGradientWarnings(result.statistics, parsed);
    if (const std::string text = cutWarning(result.statistics); !text.empty())
        std::cerr << arguments.scene.file << ": warning: " << text << '\n';
    return result;
}

bool mayWrite(const RenderArguments& arguments) {
    const OutputFiles& outputs = arguments.outputs;
    const std::string& scene = arguments.scene.file;
    return outputs.mayWrite(arguments.output, OutputKind::picture, scene) &&
           outputs.mayWrite(arguments.holeMap, OutputKind::picture, scene) &&
           outputs.mayWrite(arguments.costMap, OutputKind::picture, scene) &&
           outputs.mayWrite(arguments.statistics, OutputKind::statistics, scene);
}

/// They are held in memory whole, some 50 bytes a pixel.
void checkMapSize(const RenderArguments& arguments) {
    constexpr std::int64_t mostPixels = std::int64_t{1} << 24;
    const bool maps = !arguments.holeMap.empty() || !arguments.costMap.empty();
    if (maps && std::int64_t{arguments.width} * arguments.height > mostPixels)
        throw UsageError("--hole-map and --cost-map are for pictures of at most 16777216 pixels");
}

ExitStatus render(const RenderArguments& arguments) {
    if (arguments.depth != 8 && arguments.depth != 16) throw UsageError("--depth is 8 or 16");
    if (arguments.depth != 8 && formatOf(arguments) != PictureFormat::png)
        throw UsageError("--depth is for PNG pictures; OpenEXR has its own");
    checkMapSize(arguments);
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

    const RenderRequest request = requestOf(arguments, parsed);
    const std::optional<PictureFileResult> drawn = drawPicture(arguments, request, parsed);
    if (!drawn) return inputHasErrors;
    if (!arguments.holeMap.empty() && !writeHoleMap(arguments, request)) return inputHasErrors;
    std::optional<CostMap> cost;
    if (!arguments.costMap.empty()) {
        cost = writeCostMap(arguments, request);
        if (!cost) return inputHasErrors;
    }
    if (!arguments.statistics.empty() && !writeStatistics(arguments.statistics, *drawn, parsed, cost))
        return inputHasErrors;
    return parsed.ok() && !drawn->stopped ? done : inputHasErrors;
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
    Command command = line.add("render", "Draws a scene into a PNG or OpenEXR file");
    auto arguments = std::make_shared<RenderArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = StripRenderer::longestSide;
    command
        .option("-o,--output", arguments->output,
                "OUT.png, or OUT.exr: OpenEXR with opacity, distance, normals and verdicts")
        .required();
    command.option("-W,--width", arguments->width, "Width in pixels").within(1, largestSide).showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    command.option("--depth", arguments->depth, "Bits of a channel of a PNG: 8 or 16").showDefault();
    command.flag("--transparent", arguments->transparent,
                 "Leave out background and sky where no object hides them");
    command.option("--threads", arguments->threads, "Number of threads; 0 means all cores").within(0, 1024);
    addAntialiasing(command, *arguments);
    command
        .option("--picture-limit", arguments->pictureLimit,
                "Seconds that each picture may take (default: any)")
        .positive();
    command.option("--statistics", arguments->statistics, "OUT.json: what the picture cost");
    command.option("--hole-map", arguments->holeMap, "OUT.png: pixels that POV-Ray's method gets wrong");
    command.option(
        "--cost-map", arguments->costMap,
        "OUT.png: what each pixel takes, by cause: blue empty space, grey the surface, red a steep "
        "field, yellow grazing rays, violet singularities");
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
