// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/heap_memory.h"

using namespace isoscope::cli;

int main(int argc, char** argv) {
    isoscope::prepareHeap();
    CLI::App app("Isoscope without a window: evaluates, traces, renders and checks isosurface scenes.",
                 "isoscope-cli");
    app.set_version_flag("--version", ISOSCOPE_VERSION);
    app.require_subcommand(1);
    ExitStatus status = done;
    addEvaluateCommand(app, status);
    addTraceCommand(app, status);
    addInsideCommand(app, status);
    addRenderCommand(app, status);
    addCheckCommand(app, status);
    addExportCommand(app, status);
    addRootsCommand(app, status);
    addPolynomialCommand(app, status);
    addFunctionsCommand(app, status);
    addGradientCommand(app, status);
    addAccuracyCommand(app, status);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        status = app.exit(error) == 0 ? done : wrongUsage;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        status = inputHasErrors;
    }
    return finishStandardOutput() || status != done ? status : inputHasErrors;
}
