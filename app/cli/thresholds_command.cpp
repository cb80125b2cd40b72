// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/study/threshold/critical_study.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ThresholdArguments {
    SceneArguments scene;
    CriticalStudySettings settings;
    WorkLimit work;
    bool json = false;
};

/// One isosurface of the scene, with what is known of it.
struct StudiedThresholds {
    std::string line;
    const RootSettings* settings;
    CriticalPoints critical;
};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json place(const glm::dvec3& p) { return Json::array({number(p.x), number(p.y), number(p.z)}); }

Json jsonOf(const CriticalPoint& point, bool positivePolarity) {
    Json json;
    json["value"] = number(point.value);
    json["low"] = number(point.values.low);
    json["high"] = number(point.values.high);
    json["place"] = place(point.place);
    json["box"] = {{"low", place(point.box.low)}, {"high", place(point.box.high)}};
    json["kind"] = name(point.kind);
    json["proven"] = point.proven();
    if (!point.proven()) json["reason"] = name(point.reason);
    json["meaning"] = meaning(point.kind, positivePolarity);
    return json;
}

void printJson(const std::vector<StudiedThresholds>& all) {
    Json list = Json::array();
    for (const StudiedThresholds& studied : all) {
        Json json;
        json["line"] = studied.line;
        json["threshold"] = number(studied.settings->threshold);
        json["finished"] = studied.critical.finished;
        json["left"] = number(studied.critical.share);
        json["boxes"] = studied.critical.boxes;
        json["jumps"] = studied.critical.jumps;
        json["points"] = Json::array();
        for (const CriticalPoint& point : studied.critical.points)
            json["points"].push_back(jsonOf(point, studied.settings->positivePolarity));
        list.push_back(std::move(json));
    }
    std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void printTable(const std::vector<StudiedThresholds>& all) {
    std::cout << csvLine({"line", "value", "low", "high", "x", "y", "z", "kind", "certainty", "meaning"});
    for (const StudiedThresholds& studied : all)
        for (const CriticalPoint& point : studied.critical.points) {
            const std::string certainty =
                point.proven() ? "proven" : "suspected-" + std::string(name(point.reason));
            std::cout << csvLine({studied.line, exactNumber(point.value), exactNumber(point.values.low),
                                  exactNumber(point.values.high), exactNumber(point.place.x),
                                  exactNumber(point.place.y), exactNumber(point.place.z),
                                  std::string(name(point.kind)), certainty,
                                  std::string(meaning(point.kind, studied.settings->positivePolarity))});
        }
}

ExitStatus studyThresholds(const ThresholdArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::string& file = arguments.scene.file;
    if (parsed.scene->isosurfaces.empty()) {
        std::cerr << file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    const TimeLimit limit(arguments.work.seconds);
    // Values of what is suspected are looked for until a little later.
    const TimeLimit telling(arguments.work.seconds + 0.5);
    std::vector<StudiedThresholds> all;
    for (const SceneIsosurface& isosurface : parsed.scene->isosurfaces) {
        const Isosurface& surface = *isosurface.shape;
        const SourceText& text = (*parsed.sources)[isosurface.range.file];
        StudiedThresholds studied{
            std::to_string(text.position(isosurface.range.begin).line), &surface.rootSettings(), {}};
        ProgressLine progress(file + ":" + studied.line);
        CriticalStudy study(surface.prepared(*parsed.scene->parameterTable), surface.settings().container,
                            arguments.settings);
        constexpr std::uint64_t slice = 256;  // between two lines of progress
        while (!limit.over() && study.step(slice, limit.token())) progress.show(study.progress());
        studied.critical = study.points(telling.token());
        const std::string place = file + ":" + studied.line;
        constexpr std::string_view more = "what is suspected as unfinished may hold more points";
        if (!studied.critical.finished && limit.over())
            arguments.work.note(place, more);
        else if (!studied.critical.finished)
            std::cerr << place << ": note: --boxes ended the search; " << more << '\n';
        if (studied.critical.jumps)
            std::cerr << file << ":" << studied.line
                      << ": note: the function may jump, where surfaces change without a critical point\n";
        all.push_back(std::move(studied));
    }
    arguments.json ? printJson(all) : printTable(all);
    return parsed.ok() ? done : inputHasErrors;
}

}  // namespace

void addThresholdsCommand(CommandLine& line) {
    Command command = line.add(
        "thresholds", "The thresholds at which isosurfaces change their form: critical points, proven");
    auto arguments = std::make_shared<ThresholdArguments>();
    arguments->scene.addTo(command);
    command.option("--boxes", arguments->settings.boxLimit, "Boxes to look at before giving up")
        .showDefault();
    arguments->work.addTo(command);
    command.flag("--json", arguments->json, "One JSON array instead of CSV, with boxes around the points");
    command.run([=] { return studyThresholds(*arguments); });
}

}  // namespace isoscope::cli
