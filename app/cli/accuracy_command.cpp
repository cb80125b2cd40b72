// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/log_chart.h"
#include "app/cli/output_files.h"
#include "app/cli/time_limit.h"
#include "core/exchange/png.h"
#include "core/study/accuracy/accuracy_plan.h"
#include "core/study/accuracy/accuracy_table.h"
#include "core/study/accuracy/cost_survey.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct AccuracyArguments {
    SceneArguments scene;
    double from = 0;
    double to = 0;
    int count = 9;
    int runs = 3;
    int width = 160;
    int height = 120;
    bool maxGradient = false;
    bool knee = false;
    std::string plot;
    WorkLimit work{WorkLimit::ofPictures};
    OutputFiles outputs;
};

/// Seconds over the setting, one line a root finder.
bool writeChart(const std::string& file, std::vector<AccuracyPoint> points) {
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.setting < b.setting; });
    std::vector<ChartLine> lines(2);
    lines[0].color = {0.8f, 0.25f, 0.02f};
    lines[1].color = {0.02f, 0.2f, 0.7f};
    for (const AccuracyPoint& point : points)
        lines[static_cast<std::size_t>(point.finder)].points.push_back({point.setting, point.cpuSeconds});
    return writeOutput(file, encodePng(drawLogChart(lines, 640, 420)));
}

/// The knee for each isosurface, and what POV-Ray will need for the whole picture, with the counts behind it.
/// Fewer lines after a stop.
void printKnees(RenderRequest view, const AccuracyArguments& arguments, StudiedSetting setting,
                const std::stop_token& stop) {
    std::cout << csvLine({"line",
                          setting == StudiedSetting::accuracy ? "accuracy" : "max_gradient",
                          "knee",
                          "lost",
                          "of_pixels",
                          "povray_seconds",
                          "error",
                          "rays_per_pixel",
                          "hits_per_pixel",
                          "evaluations_per_pixel",
                          "primary_evaluations_per_pixel",
                          "shadow_evaluations_per_pixel",
                          "repeated_evaluations_per_pixel",
                          "products",
                          "sums",
                          "native_steps",
                          "calls",
                          "declared_calls",
                          "pattern_calls",
                          "pigment_calls",
                          "quotients",
                          "waves",
                          "powers",
                          "noises",
                          "vector_noises",
                          "cells",
                          "timed_calls",
                          "slowness"});
    for (std::size_t i = 0; i < view.scene->isosurfaces.size(); ++i) {
        const SceneIsosurface& isosurface = view.scene->isosurfaces[i];
        if (!isosurface.shape) continue;
        const RootSettings& settings = isosurface.shape->rootSettings();
        const double present = setting == StudiedSetting::accuracy ? settings.accuracy : settings.maxGradient;
        const SurveyedRange usual = surveyedRange(setting);
        const double from = arguments.from > 0 ? arguments.from : usual.low,
                     to = arguments.to > 0 ? arguments.to : std::max(usual.high, 2 * present);
        CostSurvey survey({view, i, setting, surveyValues(std::min(from, to), std::max(from, to))});
        std::uint64_t lost = 0;
        while (const std::optional<CostPoint> point = survey.next(stop))
            if (point->setting >= present) lost = point->lost[0];
        if (stop.stop_requested()) return;
        const PovrayCounts& counts = survey.povray();
        const double pixels = static_cast<double>(view.width) * view.height;
        const double counted = std::max<double>(1, static_cast<double>(counts.pixels));
        const std::optional<double> knee = survey.knee();
        std::vector<std::string> fields{std::to_string(isosurface.number), exactNumber(present),
                                        knee ? exactNumber(*knee) : "", std::to_string(lost),
                                        std::to_string(survey.width() * survey.height())};
        for (const double number : {povraySeconds(counts, pixels),
                                    povrayTimeError,
                                    static_cast<double>(counts.rays) / counted,
                                    static_cast<double>(counts.hits) / counted,
                                    static_cast<double>(counts.evaluations) / counted,
                                    static_cast<double>(counts.primaryEvaluations) / counted,
                                    static_cast<double>(counts.shadowEvaluations) / counted,
                                    counts.repeatedEvaluations / counted,
                                    counts.work.products,
                                    counts.work.sums,
                                    counts.work.nativeSteps,
                                    counts.work.calls,
                                    counts.work.declaredCalls,
                                    counts.work.patternCalls,
                                    counts.work.pigmentCalls,
                                    counts.work.quotients,
                                    counts.work.waves,
                                    counts.work.powers,
                                    counts.work.noises,
                                    counts.work.vectorNoises,
                                    counts.work.cells,
                                    counts.work.timedCalls,
                                    machineSlowness()})
            fields.push_back(exactNumber(number));
        std::cout << csvLine(fields) << std::flush;
    }
}

ExitStatus studyAccuracy(const AccuracyArguments& arguments) {
    if (!arguments.outputs.mayWrite(arguments.plot, OutputKind::picture, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << arguments.scene.file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    AccuracyStudyRequest request;
    request.view.scene = parsed.scene;
    request.view.camera = parsed.scene->camera;
    request.view.width = arguments.width;
    request.view.height = arguments.height;
    request.setting = arguments.maxGradient ? StudiedSetting::maxGradient : StudiedSetting::accuracy;
    request.runs = arguments.runs;
    const TimeLimit limit(arguments.work.seconds);
    const auto finish = [&] {
        if (limit.over()) arguments.work.error(arguments.scene.file, "what is left is not studied");
        return parsed.ok() && !limit.over() ? done : inputHasErrors;
    };
    if (arguments.knee) {
        printKnees(request.view, arguments, request.setting, limit.token());
        return finish();
    }
    const SettingRange usual = studiedRange(*parsed.scene, request.setting, limit.token());
    const double from = arguments.from > 0 ? arguments.from : usual.from,
                 to = arguments.to > 0 ? arguments.to : usual.to;
    request.values = studyValues(from, to, arguments.count);

    std::cout << accuracyTableHeader(request.setting);
    AccuracyStudy study(std::move(request));
    std::vector<AccuracyPoint> points;
    while (const std::optional<AccuracyPoint> point = study.next(limit.token())) {
        points.push_back(*point);
        std::cout << accuracyTableLine(*point) << std::flush;
    }
    if (!arguments.plot.empty() && !writeChart(arguments.plot, points)) return inputHasErrors;
    return finish();
}

}  // namespace

void addAccuracyCommand(CommandLine& line) {
    Command command = line.add("accuracy", "What accuracy, or max_gradient, costs on this scene");
    auto arguments = std::make_shared<AccuracyArguments>();
    arguments->scene.addTo(command);
    constexpr int largestSide = 4096;
    command.option("--from", arguments->from, "First value (1e-1; a tenth of the proven gradient)")
        .positive();
    command.option("--to", arguments->to, "Last value (1e-9; ten times the proven gradient)").positive();
    command.option("--count", arguments->count, "Number of values").within(1, 1000).showDefault();
    command.option("--runs", arguments->runs, "Timings per value; the median counts")
        .within(1, 101)
        .showDefault();
    command.flag("--max-gradient", arguments->maxGradient, "Vary max_gradient instead of accuracy");
    command.flag("--knee", arguments->knee,
                 "Instead: the value behind which finer ones change no pixel, and POV-Ray's time");
    command.option("-W,--width", arguments->width, "Width in pixels").within(1, largestSide).showDefault();
    command.option("-H,--height", arguments->height, "Height in pixels").within(1, largestSide).showDefault();
    arguments->work.addTo(command);
    command.option("--plot", arguments->plot, "OUT.png: seconds over the value, logarithmic");
    arguments->outputs.addTo(command);
    command.run([=] { return studyAccuracy(*arguments); });
}

}  // namespace isoscope::cli
