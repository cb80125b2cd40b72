// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"

namespace isoscope::cli {

void addCheckCommand(CLI::App& app, ExitStatus& status) {
    CLI::App* command = app.add_subcommand("check", "Says what is wrong with a scene, and what is left out");
    auto arguments = std::make_shared<SceneArguments>();
    arguments->addTo(*command);
    command->callback([=, &status] {
        const ParseResult parsed = loadScene(*arguments);
        printDiagnostics(parsed.diagnostics, *parsed.sources, false);
        status = parsed.ok() ? done : inputHasErrors;
    });
}

}  // namespace isoscope::cli
