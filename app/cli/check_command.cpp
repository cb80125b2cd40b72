// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command_support.h"
#include "app/cli/commands.h"

namespace isoscope::cli {

void addCheckCommand(CommandLine& line) {
    Command command = line.add("check", "Says what is wrong with a scene, and what is left out");
    auto arguments = std::make_shared<SceneArguments>();
    constexpr double secondsOfCheck = 20;
    arguments->timeLimit = secondsOfCheck;
    arguments->addTo(command);
    command.run([=] {
        const ParseResult parsed = loadScene(*arguments);
        printDiagnostics(parsed.diagnostics, *parsed.sources, false);
        return parsed.ok() ? done : inputHasErrors;
    });
}

}  // namespace isoscope::cli
