// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "core/study/range/scene_ranges.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

using Json = nlohmann::ordered_json;

struct RangeArguments {
    SceneArguments scene;
    std::size_t boxes = RangeSettings().boxLimit;
    WorkLimit work;
    bool json = false;
};

/// One number, with what is known of it.
struct StudiedRange {
    std::string line;  ///< of the isosurface
    const SceneParameter* parameter;
    ParameterRange range;
};

void printJson(const std::vector<StudiedRange>& all) {
    Json list = Json::array();
    for (const StudiedRange& studied : all) {
        Json json;
        json["line"] = studied.line;
        json["group"] = studied.parameter->group;
        json["name"] = studied.parameter->name;
        json["value"] = studied.parameter->value;
        json["minimum"] = studied.parameter->minimum;
        json["maximum"] = studied.parameter->maximum;
        const auto shown = studied.range.shown();
        json["from"] = shown ? Json(shown->first) : Json(nullptr);
        json["to"] = shown ? Json(shown->second) : Json(nullptr);
        json["proven_share"] = studied.range.provenShare();
        json["boxes"] = studied.range.boxes;
        json["pieces"] = Json::array();
        for (const PresencePiece& piece : studied.range.pieces)
            json["pieces"].push_back(
                {{"low", piece.low}, {"high", piece.high}, {"presence", name(piece.presence)}});
        list.push_back(std::move(json));
    }
    std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void printTable(const std::vector<StudiedRange>& all) {
    std::cout << csvLine(
        {"line", "group", "name", "value", "minimum", "maximum", "from", "to", "proven_share"});
    for (const StudiedRange& studied : all) {
        const auto shown = studied.range.shown();
        std::cout << csvLine({studied.line, studied.parameter->group, studied.parameter->name,
                              exactNumber(studied.parameter->value), exactNumber(studied.parameter->minimum),
                              exactNumber(studied.parameter->maximum), shown ? exactNumber(shown->first) : "",
                              shown ? exactNumber(shown->second) : "",
                              exactNumber(studied.range.provenShare())});
    }
}

ExitStatus studyRanges(const RangeArguments& arguments) {
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const Scene& scene = *parsed.scene;
    if (scene.isosurfaces.empty()) {
        std::cerr << arguments.scene.file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    RangeSettings settings;
    settings.boxLimit = arguments.boxes;
    const std::vector<RangeSubject> subjects = rangeSubjects(scene);
    std::vector<StudiedRange> all;
    const TimeLimit limit(arguments.work.seconds);
    ProgressLine progress(arguments.scene.file);
    for (const RangeSubject& subject : subjects) {
        const SourceRange& statement = scene.isosurfaces[subject.isosurface].range;
        const int line = (*parsed.sources)[statement.file].position(statement.begin).line;
        all.push_back({std::to_string(line), &scene.parameters[subject.parameter],
                       rangeOf(scene, subject, settings, limit.token())});
        progress.show(static_cast<double>(all.size()) / static_cast<double>(subjects.size()));
    }
    if (limit.over()) arguments.work.note(arguments.scene.file, "what is told is proven so far");
    arguments.json ? printJson(all) : printTable(all);
    return parsed.ok() ? done : inputHasErrors;
}

}  // namespace

void addRangesCommand(CommandLine& line) {
    Command command = line.add(
        "ranges", "For every number that a slider moves: the values for which there is a surface, proven");
    auto arguments = std::make_shared<RangeArguments>();
    arguments->scene.addTo(command);
    command.option("--boxes", arguments->boxes, "Enclosures for each number before giving up").showDefault();
    arguments->work.addTo(command);
    command.flag("--json", arguments->json, "One JSON array instead of CSV, with the pieces of each range");
    command.run([=] { return studyRanges(*arguments); });
}

}  // namespace isoscope::cli
