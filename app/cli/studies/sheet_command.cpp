// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/studies/value_range.h"
#include "core/exchange/picture_sheet.h"
#include "core/exchange/png.h"
#include "core/render/render_image.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

constexpr double mostPixels = 100e6;

struct SheetArguments {
    SceneArguments scene;
    ValueRange first, second;
    std::string output;
    std::string solver = "certified";
    int width = 240;
    int height = 180;
    int columns = 0;
    bool antialias = false;
    OutputFiles outputs;
};

/// One picture of the sheet.
struct Cell {
    std::vector<NumberSetting> numbers;
    std::string label;
};

std::string rounded(double value) {
    char text[32];
    constexpr int digits = 4;
    const auto written =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, digits);
    return std::string(std::begin(text), written.ptr);
}

/// With two numbers the first goes across, the second down.
std::vector<Cell> cellsOf(const ValueRange::Found& first, const std::optional<ValueRange::Found>& second) {
    std::vector<Cell> cells;
    if (!second) {
        for (const double value : first.values) cells.push_back({{{first.parameter, value}}, rounded(value)});
        return cells;
    }
    for (const double down : second->values)
        for (const double across : first.values)
            cells.push_back({{{first.parameter, across}, {second->parameter, down}},
                             rounded(across) + ", " + rounded(down)});
    return cells;
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
    const std::vector<Cell> cells = cellsOf(*first, second);
    const int count = static_cast<int>(cells.size());
    const int square = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    const int columns = second                  ? static_cast<int>(first->values.size())
                        : arguments.columns > 0 ? std::min(arguments.columns, count)
                                                : square;
    const int rows = (count + columns - 1) / columns;
    if (PictureSheet::pixels(columns, rows, arguments.width, arguments.height) > mostPixels)
        throw UsageError("the sheet would have more than 100 million pixels");
    PictureSheet sheet(columns, rows, arguments.width, arguments.height);
    ProgressLine progress(arguments.scene.file);
    std::cout << csvLine(second ? std::vector<std::string>{"row", "column", "value", "second", "drawn"}
                                : std::vector<std::string>{"row", "column", "value", "drawn"});
    for (int i = 0; i < count; ++i) {
        const Cell& cell = cells[static_cast<std::size_t>(i)];
        const auto scene = sceneWithNumbers(parsed, cell.numbers);
        Image picture;
        if (scene) {
            RenderRequest request = pictureOf(parsed, arguments.width, arguments.height, arguments.solver);
            request.scene = scene;
            request.camera = scene->camera;
            request.antialias = arguments.antialias;
            picture = renderImage(request);
        }
        sheet.put(i % columns, i / columns, picture, cell.label);
        std::vector<std::string> row{std::to_string(i / columns), std::to_string(i % columns)};
        for (const NumberSetting& number : cell.numbers) row.push_back(exactNumber(number.value));
        row.push_back(scene ? "1" : "0");
        std::cout << csvLine(row) << std::flush;
        progress.show((i + 1.0) / count);
    }
    return writeOutput(arguments.output, encodePng(sheet.image(), 0)) && parsed.ok() ? done : inputHasErrors;
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
    arguments->outputs.addTo(command);
    command.run([=] { return drawSheet(*arguments); });
}

}  // namespace isoscope::cli
