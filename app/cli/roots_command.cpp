// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <map>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/container_text.h"
#include "core/roots/certified/certified_root_finder.h"
#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "core/roots/lipschitz/tape_field.h"
#include "core/shapes/rays/line_interval.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// A function compiled for all rows that share its text.
struct CompiledField {
    std::shared_ptr<const Tape> tape;
    std::vector<double> parameters;
    std::string error;
};

CompiledField compile(const std::string& body) {
    const ParsedFunction parsed = parseFunction(body);
    if (!parsed.ok())
        return {nullptr, {}, parsed.diagnostics.empty() ? "no function" : parsed.diagnostics.front().message};
    return {Tape::compile(parsed.value.function), parsed.parameterTable, {}};
}

/// The part of the ray inside a container; empty where the text is none that readContainer() knows.
RayInterval clip(const std::string& text, const Ray& ray) {
    const std::optional<Container> container = readContainer(text);
    if (!container) return {1, 0};
    const auto* box = std::get_if<ContainerBox>(&*container);
    RayInterval inside = box ? boxInterval(ray, box->low, box->high).range
                             : sphereInterval(ray, std::get<ContainerSphere>(*container).center,
                                              std::get<ContainerSphere>(*container).radius)
                                   .range;
    inside.near = std::max(inside.near, 0.0);
    return inside;
}

/// `max_gradient_factor=k` of the column `settings`, or 1.
double gradientFactor(const std::string& settings) {
    static const std::string key = "max_gradient_factor=";
    return settings.starts_with(key) ? std::strtod(settings.c_str() + key.size(), nullptr) : 1.0;
}

const char* nameOf(RootKind kind) {
    switch (kind) {
        case RootKind::crossing: return "crossing";
        case RootKind::jump: return "jump";
        case RootKind::pole: return "pole";
        case RootKind::gap: return "gap";
        case RootKind::entryWall:
        case RootKind::exitWall: return "container";
    }
    return "";
}

struct RowAnswer {
    RootList roots;
    std::string verdict;
    std::uint64_t evaluations = 0;
};

/// All events of one row. A finder lists at most ten; the search goes on behind the tenth.
RowAnswer findRoots(const CsvTable& table, std::size_t row, const CompiledField& field, RootFinder solver) {
    const auto number = [&](const char* column, double missing) {
        return table.number(row, column, missing);
    };
    LineQuery query;
    query.origin = {number("ox", 0), number("oy", 0), number("oz", 0)};
    query.direction = {number("dx", 0), number("dy", 0), number("dz", 0)};
    const RayInterval inside = clip(table.field(row, "container"), {query.origin, query.direction});
    query.near = inside.near;
    query.far = inside.far;

    RootSettings settings;
    settings.threshold = number("threshold", 0);
    settings.accuracy = number("accuracy", 0.001);
    settings.open = true;
    settings.maxTrace = 10;
    settings.maxGradient =
        number("lipschitz", settings.maxGradient) * gradientFactor(table.field(row, "settings"));

    RowAnswer answer;
    std::unique_ptr<LineRootFinder> finder;
    if (solver == RootFinder::certified)
        finder = std::make_unique<CertifiedRootFinder>(field.tape, field.parameters, settings);
    else
        finder = std::make_unique<LipschitzRootFinder>(
            std::make_unique<TapeField>(field.tape, field.parameters), settings);
    constexpr std::size_t eventLimit = 1000;
    while (answer.roots.size() < eventLimit) {
        RootList found;
        finder->find(std::span(&query, 1), {}, {&found, 1});
        if (!finder->verdicts().empty() && answer.verdict.empty())
            answer.verdict = name(finder->verdicts().front());
        answer.roots.insert(answer.roots.end(), found.begin(), found.end());
        if (found.size() < static_cast<std::size_t>(settings.maxTrace)) break;
        query.near =
            std::nextafter(found.back().t + settings.accuracy / glm::length(query.direction), query.far);
    }
    answer.evaluations = finder->report().evaluations;
    return answer;
}

std::vector<std::string> fieldsOf(const std::string& id, const RowAnswer& answer, double tMin) {
    std::string first = "miss", events;
    std::string kind = answer.verdict.empty() ? "miss" : answer.verdict;
    for (const Root& root : answer.roots) {
        // A gap among the roots has opposite signs on its two sides: a crossing that rounding hides.
        const bool isSurface = root.kind != RootKind::pole;
        if (first == "miss" && isSurface && root.t >= tMin) {
            first = exactNumber(root.t);
            if (answer.verdict.empty()) kind = nameOf(root.kind);
        }
        events += (events.empty() ? "" : ";") + exactNumber(root.t) + ":" + nameOf(root.kind);
    }
    return {id, first, kind, events, std::to_string(answer.evaluations)};
}

ExitStatus listRoots(const std::string& file, const std::string& solver) {
    const std::optional<CsvTable> table = loadTable(
        file, {"case_id", "function", "threshold", "container", "ox", "oy", "oz", "dx", "dy", "dz"});
    if (!table) return inputHasErrors;
    std::map<std::string, CompiledField> fields;
    ExitStatus status = done;
    std::cout << csvLine({"case_id", "t", "kind", "roots", "evaluations"});
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        const std::string& body = table->field(row, "function");
        const std::string& id = table->field(row, "case_id");
        const auto [field, isNew] = fields.try_emplace(body);
        if (isNew) field->second = compile(body);
        if (!field->second.tape) {
            std::cerr << file << ": error: " << id << ": " << field->second.error << '\n';
            std::cout << csvLine({id, "error", "", "", "0"});
            status = inputHasErrors;
            continue;
        }
        const RowAnswer answer = findRoots(*table, row, field->second, rootFinder(solver));
        std::cout << csvLine(fieldsOf(id, answer, table->number(row, "t_min", 0)));
    }
    return status;
}

}  // namespace

void addRootsCommand(CommandLine& line) {
    Command command = line.add("roots", "Every crossing, jump and pole along rays, from and to CSV");
    auto table = std::make_shared<std::string>();
    auto solver = std::make_shared<std::string>("certified");
    command.option("--table", *table, "CSV with case_id,function,threshold,container,ox,oy,oz,dx,dy,dz")
        .required();
    addSolverOption(command, *solver);
    command.run([=] { return listRoots(*table, *solver); });
}

}  // namespace isoscope::cli
