// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/heap_memory.h"

using namespace isoscope::cli;

int main(int argc, char** argv) {
    isoscope::prepareHeap();
    CommandLine line("Isoscope without a window: evaluates, traces, renders and checks isosurface scenes.",
                     "isoscope-cli", ISOSCOPE_VERSION);
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
    addContainerCommand(line);
    addThresholdsCommand(line);
    addCompareCommand(line);
    addRangesCommand(line);
    addSweepCommand(line);
    addSheetCommand(line);
    addReportCommand(line);
    addHealthCommand(line);
    addDerivativeCommand(line);
    addDifferenceCommand(line);
    addEvaluateAdviceCommand(line);
    ExitStatus status = inputHasErrors;
    try {
        status = line.run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
    }
    return finishStandardOutput() || status != done ? status : inputHasErrors;
}
