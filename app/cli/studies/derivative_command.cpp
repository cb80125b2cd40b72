// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "core/exchange/formulas/derivative_text.h"

namespace isoscope::cli {

namespace {

struct DerivativeArguments {
    SceneArguments scene;
    std::string name = "f";
};

bool isName(const std::string& text) {
    const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
    return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
           std::ranges::all_of(text, fits);
}

ExitStatus writeDerivatives(const DerivativeArguments& arguments) {
    if (!isName(arguments.name)) throw UsageError("--name: `" + arguments.name + "` is no name");
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::string& file = arguments.scene.file;
    const auto& all = parsed.scene->isosurfaces;
    if (all.empty()) {
        std::cerr << file << ": error: there is no isosurface\n";
        return inputHasErrors;
    }
    bool written = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const int line = (*parsed.sources)[all[i].range.file].position(all[i].range.begin).line;
        const std::string name = all.size() == 1 ? arguments.name : arguments.name + std::to_string(i + 1);
        const DerivativeText text = derivativeText(*all[i].shape, *parsed.scene->parameterTable, name);
        if (text.declarations.empty()) {
            std::cerr << file << ':' << line << ": error: " << text.problem << '\n';
            written = false;
            continue;
        }
        std::cout << "// The isosurface in line " << line << ". " << name
                  << "_normalised has threshold 0, and a gradient of 1 on the surface.\n"
                  << text.declarations;
    }
    return parsed.ok() && written ? done : inputHasErrors;
}

}  // namespace

void addDerivativeCommand(CommandLine& line) {
    Command command =
        line.add("derivative", "The derivatives of functions as POV-Ray text, and a function of gradient 1");
    auto arguments = std::make_shared<DerivativeArguments>();
    arguments->scene.addTo(command);
    command.option("--name", arguments->name, "Begins the names of the functions").showDefault();
    command.run([=] { return writeDerivatives(*arguments); });
}

}  // namespace isoscope::cli
