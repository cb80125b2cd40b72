// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "core/exchange/formulas/difference_text.h"

namespace isoscope::cli {

namespace {

struct DifferenceArguments {
    SceneArguments scene;
    std::string other;
    int isosurface = 1;
};

/// The isosurface of that number; null, with a message on standard error, without one.
const Isosurface* chosen(const ParseResult& parsed, const std::string& file, int number) {
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const auto& all = parsed.scene->isosurfaces;
    if (static_cast<std::size_t>(number) <= all.size())
        return all[static_cast<std::size_t>(number - 1)].shape.get();
    std::cerr << file << ": error: there is no isosurface " << number << '\n';
    return nullptr;
}

ExitStatus writeDifference(const DifferenceArguments& arguments) {
    SceneArguments second = arguments.scene;
    second.file = arguments.other;
    const ParseResult a = loadScene(arguments.scene), b = loadScene(second);
    const Isosurface *first = chosen(a, arguments.scene.file, arguments.isosurface),
                     *other = chosen(b, arguments.other, arguments.isosurface);
    if (!first || !other) return inputHasErrors;
    const DifferenceText difference =
        differenceText(*first, *a.scene->parameterTable, *other, *b.scene->parameterTable);
    if (difference.text.empty()) {
        std::cerr << arguments.scene.file << ": error: " << difference.problem << '\n';
        return inputHasErrors;
    }
    std::cout << difference.text;
    return a.ok() && b.ok() ? done : inputHasErrors;
}

}  // namespace

void addDifferenceCommand(CommandLine& line) {
    Command command =
        line.add("difference", "The isosurface that is 0 where the functions of two scenes agree");
    auto arguments = std::make_shared<DifferenceArguments>();
    arguments->scene.addTo(command);
    command.option("--with", arguments->other, "OTHER.pov: the scene whose function is taken away")
        .required();
    command.option("--isosurface", arguments->isosurface, "Which one of both scenes, from 1")
        .within(1, 1'000'000)
        .showDefault();
    command.run([=] { return writeDifference(*arguments); });
}

}  // namespace isoscope::cli
