// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/heap_memory.h"

using namespace isoscope::cli;

namespace {

std::string manual(const CommandLine& line) {
    return line.manual(
        "draw, measure and check isosurface scenes without a window",
        {{"EXIT STATUS",
          "",
          {{"0", "The command did what it was asked to do."},
           {"1", "The input has errors; standard error says which."},
           {"2", "The arguments are wrong."}}},
         {"FILES",
          "Tables are CSV with a header row. Include files are looked for beside the scene, and "
          "then among those that the program brings along; other folders have to be allowed.",
          {}},
         {"SEE ALSO", "isoscope(1), povray(1)", {}}});
}

void addCommands(CommandLine& line) {
    addEvaluateCommand(line);
    addTraceCommand(line);
    addInsideCommand(line);
    addRenderCommand(line);
    addFramesCommand(line);
    addCheckCommand(line);
    addExportCommand(line);
    addMeshCommand(line);
    addRootsCommand(line);
    addPolynomialCommand(line);
    addFunctionsCommand(line);
    addGradientCommand(line);
    addAccuracyCommand(line);
    addPredictCommand(line);
    addContainerCommand(line);
    addThresholdsCommand(line);
    addCompareCommand(line);
    addRangesCommand(line);
    addSweepCommand(line);
    addSheetCommand(line);
    addReportCommand(line);
    addHealthCommand(line);
    addRewritesCommand(line);
    addDerivativeCommand(line);
    addDifferenceCommand(line);
    addEvaluateAdviceCommand(line);
}

ExitStatus run(int argc, char** argv) {
    CommandLine line("Isoscope without a window: evaluates, traces, renders and checks isosurface scenes.",
                     "isoscope-cli", ISOSCOPE_VERSION);
    addCommands(line);
    if (argc != 2 || std::string_view(argv[1]) != "--manual") return line.run(argc, argv);
    std::cout << manual(line);
    return done;
}

}  // namespace

int main(int argc, char** argv) {
    isoscope::prepareHeap();
    ExitStatus status = inputHasErrors;
    try {
        status = run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "error: there is not enough memory\n";
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
    }
    return finishStandardOutput() || status != done ? status : inputHasErrors;
}
