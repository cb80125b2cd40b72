// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/time_limit.h"
#include "app/cli/studies/value_range.h"
#include "core/exchange/png.h"
#include "core/exchange/sheets/small_multiples.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct SheetArguments {
    SceneArguments scene;
    ValueRange first, second;
    std::string output;
    std::string solver = "certified";
    int width = 240;
    int height = 180;
    int columns = 0;
    bool antialias = false;
    WorkLimit work{WorkLimit::ofPictures};
    OutputFiles outputs;
};

RenderRequest pictureToDraw(const ParseResult& parsed, const SheetArguments& arguments) {
    RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
    request.antialias = arguments.antialias;
    return request;
}

ExitStatus drawSheet(const SheetArguments& arguments) {
    if (!arguments.outputs.mayWrite(arguments.output, OutputKind::picture, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene, arguments.width, arguments.height);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const auto first = arguments.first.find(parsed, arguments.scene.file);
    if (!first) return inputHasErrors;
    std::optional<ValueRange::Found> second;
    if (!arguments.second.name.empty()) {
        second = arguments.second.find(parsed, arguments.scene.file);
        if (!second) return inputHasErrors;
        if (second->parameter == first->parameter)
            throw UsageError("--second names the same number as --parameter");
    }
    const auto varied = [](const ValueRange::Found& found) {
        return VariedNumber{found.parameter, found.values};
    };
    SmallMultiples pictures(parsed, pictureToDraw(parsed, arguments), true, varied(*first),
                            second ? std::optional(varied(*second)) : std::nullopt, arguments.columns);
    if (pictures.tooLarge()) throw UsageError("the sheet would have more than 100 million pixels");
    const TimeLimit limit(arguments.work.seconds);
    ProgressLine progress(arguments.scene.file);
    std::cout << csvLine(second ? std::vector<std::string>{"row", "column", "value", "second", "drawn"}
                                : std::vector<std::string>{"row", "column", "value", "drawn"});
    for (std::size_t i = 0; i < pictures.cells().size(); ++i) {
        const SmallMultiples::Cell& cell = pictures.cells()[i];
        const bool drawn = pictures.draw(i, limit.token());
        std::vector<std::string> row{std::to_string(cell.row), std::to_string(cell.column)};
        for (const NumberSetting& number : cell.numbers) row.push_back(exactNumber(number.value));
        row.push_back(drawn ? "1" : "0");
        std::cout << csvLine(row) << std::flush;
        progress.show((static_cast<double>(i) + 1) / static_cast<double>(pictures.cells().size()));
    }
    if (limit.over()) arguments.work.error(arguments.scene.file, "pictures are missing from the sheet");
    return writeOutput(arguments.output, encodePng(pictures.sheet().image(), 0)) && parsed.ok() &&
                   !limit.over()
               ? done
               : inputHasErrors;
}

}  // namespace

void addSheetCommand(CommandLine& line) {
    Command command = line.add("sheet", "Small pictures for values of one number, or of two, as one picture");
    auto arguments = std::make_shared<SheetArguments>();
    arguments->scene.addTo(command);
    command.option("-o,--output", arguments->output, "OUT.png").required();
    arguments->first.addTo(command, "");
    arguments->second.addTo(command, "second");
    constexpr int largestSide = 4096, mostColumns = 1000;
    command.option("--columns", arguments->columns, "Pictures in a row, for one number")
        .within(1, mostColumns);
    command.option("-W,--width", arguments->width, "Width of each picture")
        .within(8, largestSide)
        .showDefault();
    command.option("-H,--height", arguments->height, "Height of each picture")
        .within(8, largestSide)
        .showDefault();
    command.flag("--antialias", arguments->antialias, "Smooth edges: nine samples a pixel");
    addSolverOption(command, arguments->solver);
    arguments->work.addTo(command);
    arguments->outputs.addTo(command);
    command.run([=] { return drawSheet(*arguments); });
}

}  // namespace isoscope::cli
