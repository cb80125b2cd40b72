// SPDX-License-Identifier: GPL-3.0-or-later
#include <ctime>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/container_text.h"
#include "app/cli/gradient_report.h"
#include "core/render/render_image.h"
#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/view/isosurfaces_of.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct GradientArguments {
    SceneArguments scene;
    std::string object;
    std::string table;
    GradientStudySettings settings;
    bool check = false;
    bool json = false;
};

StudiedGradient study(const std::shared_ptr<const Tape>& tape, std::span<const double> parameters,
                      const Container& container, const GradientStudySettings& settings) {
    const std::clock_t begin = std::clock();
    GradientStudy study(tape, parameters, container, settings);
    StudiedGradient result;
    result.bracket = study.run();
    result.sampled = study.sampled();
    result.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return result;
}

std::unique_ptr<GradientReport> reportFor(const GradientArguments& arguments) {
    return arguments.json ? GradientReport::json() : GradientReport::csv();
}

/// What is proven beside infinite gradients, one sentence; empty when nothing is.
std::string besideText(const GradientBracket& bracket) {
    if (!bracket.beside || !std::isfinite(bracket.beside->upper)) return {};
    const GradientBeside& beside = *bracket.beside;
    const std::string most = "no gradient exceeds " + shortestNumber(beside.suggested()) + ".";
    if (!(beside.share > 0)) return "Beside jumps " + most;
    return "Farther than " + shortestNumber(beside.reach) + " from such places " + most;
}

/// Of a function without a setting: how the study ended.
std::string verdictOf(const GradientBracket& bracket) {
    std::string verdict(name(bracket.state));
    if (bracket.singularity) verdict += "-" + std::string(name(bracket.singularity->kind));
    return verdict;
}

ExitStatus studyTable(const GradientArguments& arguments) {
    const std::optional<CsvTable> table = loadTable(arguments.table, {"function", "container"});
    if (!table) return inputHasErrors;
    ExitStatus status = done;
    const auto report = reportFor(arguments);
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        ParseOptions options;
        options.restrictedReading = true;
        const ParsedFunction parsed =
            parseFunction(table->field(row, "function"), table->field(row, "prelude"), options);
        const std::optional<Container> container = readContainer(table->field(row, "container"));
        StudiedGradient studied;
        if (!parsed.ok() || !container) {
            studied.problem = parsed.diagnostics.empty() ? "neither box{<,,>,<,,>} nor sphere{<,,>,}"
                                                         : parsed.diagnostics.front().message;
            studied.verdict = "error";
            std::cerr << arguments.table << ": error: row " << row + 1 << ": " << studied.problem << '\n';
            status = inputHasErrors;
        } else {
            studied = study(Tape::compile(parsed.value.function), parsed.parameterTable, *container,
                            arguments.settings);
            studied.verdict = verdictOf(studied.bracket);
        }
        report->add(studied);
    }
    report->finish();
    return status;
}

struct Subject {
    std::shared_ptr<const Isosurface> surface;
    double alongRays = 0;  ///< steepest slope that the rays of the picture met
};

/// The isosurfaces that the scene shows, with what a small picture sees of them; or those of one declared
/// object.
std::vector<Subject> subjects(const ParseResult& parsed, const std::string& object) {
    std::vector<Subject> all;
    if (!object.empty()) {
        for (const auto& surface : isosurfacesOf(declaredShape(parsed, object))) all.push_back({surface, 0});
        return all;
    }
    RenderRequest request;
    request.scene = parsed.scene;
    request.camera = parsed.scene->camera;
    request.width = 160;
    request.height = 120;
    RenderStatistics statistics;
    renderImage(request, 0, &statistics);
    for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
        const double steepest = i < statistics.gradients.size() ? statistics.gradients[i].steepest : 0;
        all.push_back({parsed.scene->isosurfaces[i].shape, steepest});
    }
    return all;
}

ExitStatus studyScene(const GradientArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::vector<Subject> found = subjects(parsed, arguments.object);
    if (found.empty()) {
        std::cerr << arguments.scene.file << ": error: there is no isosurface"
                  << (arguments.object.empty() ? "" : " called `" + arguments.object + "`") << '\n';
        return inputHasErrors;
    }
    bool holes = false;
    const auto report = reportFor(arguments);
    for (const Subject& subject : found) {
        const IsosurfaceSettings& settings = subject.surface->settings();
        StudiedGradient studied = study(subject.surface->tape(), *parsed.scene->parameterTable,
                                        settings.container, arguments.settings);
        if (arguments.object.empty()) studied.sampled = subject.alongRays;
        const GradientVerdict verdict =
            judgeGradient(subject.surface->rootSettings().maxGradient, studied.bracket, subject.alongRays);
        holes = holes || verdict == GradientVerdict::holes;
        studied.setting = subject.surface->rootSettings().maxGradient;
        studied.verdict = name(verdict);
        report->add(studied);
        if (studied.bracket.singularity)
            std::cerr << arguments.scene.file << ": note: " << advice(studied.bracket.singularity->kind)
                      << '\n';
        if (const std::string beside = besideText(studied.bracket); !beside.empty())
            std::cerr << arguments.scene.file << ": note: " << beside << '\n';
    }
    report->finish();
    if (!parsed.ok()) return inputHasErrors;
    return arguments.check && holes ? inputHasErrors : done;
}

}  // namespace

void addGradientCommand(CommandLine& line) {
    Command command = line.add("gradient", "Proven bounds of the largest gradient, for max_gradient");
    auto arguments = std::make_shared<GradientArguments>();
    arguments->scene.addTo(command);
    const Option scene = command.find("scene").required(false);
    command.option("--object", arguments->object, "Declared object to look at instead of the scene")
        .needs(scene);
    command.option("--table", arguments->table, "CSV with function,container[,prelude]").excludes(scene);
    command.option("--width", arguments->settings.relativeWidth, "Relative width of the bracket to stop at")
        .within(1e-9, 1e9)
        .showDefault();
    command.option("--boxes", arguments->settings.boxLimit, "Boxes to look at before giving up")
        .showDefault();
    command.flag("--json", arguments->json, "One JSON array instead of CSV, with states and singularities");
    command.flag("--check", arguments->check, "Exit with status 1 when a max_gradient is too low");
    command.run([=] {
        if (arguments->table.empty() == arguments->scene.file.empty())
            throw UsageError("exactly one of SCENE and --table is required");
        return arguments->table.empty() ? studyScene(*arguments) : studyTable(*arguments);
    });
}

}  // namespace isoscope::cli
