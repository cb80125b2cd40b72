// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace isoscope::cli {

/// What the program hands to the shell.
enum ExitStatus { done = 0, inputHasErrors = 1, wrongUsage = 2 };

/// Each adds one subcommand to `app`; when it is called, it leaves its outcome in `status`.
void addEvaluateCommand(CLI::App& app, ExitStatus& status);
void addTraceCommand(CLI::App& app, ExitStatus& status);
void addInsideCommand(CLI::App& app, ExitStatus& status);
void addRenderCommand(CLI::App& app, ExitStatus& status);
void addCheckCommand(CLI::App& app, ExitStatus& status);
void addExportCommand(CLI::App& app, ExitStatus& status);
void addRootsCommand(CLI::App& app, ExitStatus& status);
void addPolynomialCommand(CLI::App& app, ExitStatus& status);
void addFunctionsCommand(CLI::App& app, ExitStatus& status);
void addGradientCommand(CLI::App& app, ExitStatus& status);
void addAccuracyCommand(CLI::App& app, ExitStatus& status);

}  // namespace isoscope::cli
