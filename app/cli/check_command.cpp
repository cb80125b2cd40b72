// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"

namespace isoscope::cli {

void addCheckCommand(CommandLine& line) {
    Command command = line.add("check", "Says what is wrong with a scene, and what is left out");
    auto arguments = std::make_shared<SceneArguments>();
    arguments->addTo(command);
    command.run([=] {
        const ParseResult parsed = loadScene(*arguments);
        printDiagnostics(parsed.diagnostics, *parsed.sources, false);
        // Include files have none and declare; a scene without may be one that lost its text.
        if (parsed.ok() && parsed.scene->objects.empty() && !arguments->file.ends_with(".inc"))
            std::cerr << arguments->file << ": note: the scene has no object\n";
        return parsed.ok() ? done : inputHasErrors;
    });
}

}  // namespace isoscope::cli
