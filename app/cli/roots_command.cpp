// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <map>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/container_text.h"
#include "app/cli/output_files.h"
#include "app/cli/proof_table.h"
#include "app/cli/table_row.h"
#include "app/cli/time_limit.h"
#include "core/evaluate/tape/loop_stop.h"
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

CompiledField compile(const std::string& body, const std::stop_token& stop) {
    ParseOptions options;
    options.stop = stop;
    const ParsedFunction parsed = parseFunction(body, {}, options);
    if (!parsed.ok())
        return {nullptr, {}, parsed.diagnostics.empty() ? "no function" : parsed.diagnostics.front().message};
    return {Tape::compile(parsed.value.function), parsed.parameterTable, {}};
}

/// The part of the ray inside a container.
RayInterval clip(const Container& container, const Ray& ray) {
    const auto* box = std::get_if<ContainerBox>(&container);
    RayInterval inside = box ? boxInterval(ray, box->low, box->high).range
                             : sphereInterval(ray, std::get<ContainerSphere>(container).center,
                                              std::get<ContainerSphere>(container).radius)
                                   .range;
    inside.near = std::max(inside.near, 0.0);
    return inside;
}

/// `max_gradient_factor=k` of the column `settings`, or 1; a word that is not of this form is refused.
double gradientFactor(TableRow& row) {
    static const std::string key = "max_gradient_factor=";
    const std::string& settings = row.text("settings");
    if (!settings.starts_with(key)) return 1.0;
    char* end = nullptr;
    const double factor = leadingNumber(settings.c_str() + key.size(), &end);
    if (*end == '\0' && factor > 0 && std::isfinite(factor)) return factor;
    row.refuse("settings", "has no number above 0 behind `=`");
    return 1.0;
}

/// A line, and how roots are looked for on it.
struct LineTask {
    LineQuery query;
    ScaledDirection direction;
    RootSettings settings;
};

/// What a row asks for; row.ok() tells whether it makes sense.
LineTask readTask(TableRow& row) {
    LineTask task;
    task.query.origin = row.point("ox", "oy", "oz");
    task.direction = row.direction("dx", "dy", "dz");
    task.query.direction = task.direction.scaled;
    if (const std::optional<Container> container = readContainer(row.text("container"))) {
        const RayInterval inside = clip(*container, {task.query.origin, task.query.direction});
        task.query.near = inside.near;
        task.query.far = inside.far;
    } else {
        row.refuse("container", "is neither box{<,,>,<,,>} nor sphere{<,,>,radius above 0}");
    }
    RootSettings& settings = task.settings;
    settings.threshold = row.number("threshold", 0);
    settings.accuracy = row.positive("accuracy", 0.001);
    settings.open = true;
    settings.maxTrace = 10;
    settings.maxGradient = row.anyNumber("lipschitz", settings.maxGradient) * gradientFactor(row);
    return task;
}

const char* nameOf(RootKind kind) {
    switch (kind) {
        case RootKind::crossing: return "crossing";
        case RootKind::jump: return "jump";
        case RootKind::pole: return "pole";
        case RootKind::entryWall:
        case RootKind::exitWall: return "container";
    }
    return "";
}

struct RowAnswer {
    RootList roots;
    bool complete = true;
    std::string verdict;
    std::uint64_t evaluations = 0;
};

/// More events of a row are not listed.
constexpr std::size_t mostEvents = 100000;

/// Where the search goes on behind the tenth of ten events: before it, so that nothing is skipped.
double restart(const RootList& found, const LineQuery& query, double accuracy) {
    const double ninth = found[found.size() - 2].t, tenth = found.back().t;
    const double between = ninth + (tenth - ninth) / 2;
    if (ninth < between && between < tenth) return between;
    return std::nextafter(tenth + accuracy / glm::length(query.direction), query.far);
}

/// A finder of this kind; a certified one tells its steps to `recorder`, unless that is null.
std::unique_ptr<LineRootFinder> finderOf(const CompiledField& field, const RootSettings& settings,
                                         RootFinder solver, ProofRecorder* recorder) {
    if (solver != RootFinder::certified)
        return std::make_unique<LipschitzRootFinder>(
            std::make_unique<TapeField>(field.tape, field.parameters), settings);
    auto certified = std::make_unique<CertifiedRootFinder>(field.tape, field.parameters, settings);
    certified->listPoles();
    if (recorder != nullptr) certified->recordInto(*recorder);
    return certified;
}

/// All events of one row, or some of them after a stop. A finder lists at most ten at a time.
RowAnswer findRoots(const LineTask& task, const CompiledField& field, RootFinder solver,
                    ProofRecorder* recorder, const std::stop_token& stop) {
    const LoopStop loops(stop);
    LineQuery query = task.query;
    const RootSettings& settings = task.settings;
    RowAnswer answer;
    const std::unique_ptr<LineRootFinder> finder = finderOf(field, settings, solver, recorder);
    std::optional<Verdict> worst;
    while (true) {
        RootList found;
        RootRequest request;
        request.stop = stop;
        finder->find(std::span(&query, 1), request, {&found, 1});
        if (stop.stop_requested()) return answer;
        if (!finder->verdicts().empty()) {
            // That of the first root, unless what is behind it is worse.
            const Verdict verdict = finder->verdicts().front();
            if (!worst || verdict >= Verdict::gap) worst = std::max(verdict, worst.value_or(verdict));
            answer.verdict = name(*worst);
        }
        const bool more = found.size() == static_cast<std::size_t>(settings.maxTrace);
        if (more) {
            query.near = restart(found, query, settings.accuracy);
            if (query.near < found.back().t) found.pop_back();
        }
        answer.roots.insert(answer.roots.end(), found.begin(), found.end());
        answer.complete = answer.roots.size() < mostEvents;
        if (!more || !answer.complete) break;
    }
    answer.evaluations = finder->report().evaluations;
    return answer;
}

std::vector<std::string> fieldsOf(const std::string& id, const RowAnswer& answer,
                                  const ScaledDirection& direction, double tMin) {
    std::string first = "miss", events;
    std::string kind = answer.verdict.empty() ? "miss" : answer.verdict;
    for (const Root& root : answer.roots) {
        const bool isSurface = root.kind != RootKind::pole;
        const double t = direction.tableT(root.t);
        if (first == "miss" && isSurface && t >= tMin) {
            first = exactNumber(t);
            if (answer.verdict.empty()) kind = nameOf(root.kind);
        }
        events += (events.empty() ? "" : ";") + exactNumber(t) + ":" + nameOf(root.kind);
    }
    return {id, first, kind, events, std::to_string(answer.evaluations)};
}

struct RootsArguments {
    std::string table;
    std::string solver = "certified";
    std::string proof;
    WorkLimit work;
    OutputFiles outputs;
};

ExitStatus listRoots(const RootsArguments& arguments) {
    const std::string& file = arguments.table;
    const RootFinder solver = rootFinder(arguments.solver);
    const bool proves = !arguments.proof.empty();
    if (proves && solver != RootFinder::certified)
        throw UsageError("--proof goes with --solver certified: POV-Ray's method proves nothing");
    const std::optional<CsvTable> table = loadTable(
        file, {"case_id", "function", "threshold", "container", "ox", "oy", "oz", "dx", "dy", "dz"});
    if (!table || !arguments.outputs.mayWrite(arguments.proof, OutputKind::proof, file))
        return inputHasErrors;
    ProofTable proof;
    ProofRecorder recorder;
    std::map<std::string, CompiledField> fields;
    ExitStatus status = done;
    TimeLimit limit(arguments.work.seconds);
    std::cout << csvLine({"case_id", "t", "kind", "roots", "evaluations"});
    for (std::size_t number = 0; number < table->rowCount(); ++number) {
        TableRow row(file, *table, number);
        limit.restart();
        const auto [entry, isNew] = fields.try_emplace(row.text("function"));
        CompiledField& field = entry->second;
        if (isNew) field = compile(row.text("function"), limit.token());
        if (isNew && limit.over()) arguments.work.error(row.place(), "the function is not read");
        if (!field.tape) row.refuse("function", "is no function: " + field.error);
        const LineTask task = readTask(row);
        const double tMin = row.number("t_min", 0);
        const std::string& id = row.text("case_id");
        if (!row.ok()) {
            std::cout << csvLine({id, "error", "", "", "0"});
            status = inputHasErrors;
            continue;
        }
        recorder.clear();
        const RowAnswer answer = findRoots(task, field, solver, proves ? &recorder : nullptr, limit.token());
        if (limit.over()) {
            arguments.work.error(row.place(), "there is no answer");
            std::cout << csvLine({id, "error", "", "", "0"});
            status = inputHasErrors;
            continue;
        }
        std::cout << csvLine(fieldsOf(id, answer, task.direction, tMin));
        if (proves) proof.add(id, task.direction, recorder.steps());
        if (answer.complete) continue;
        row.refuse("function", "has more than " + std::to_string(mostEvents) +
                                   " events on the line; the rest is not listed");
        status = inputHasErrors;
    }
    if (proves && !writeOutput(arguments.proof, proof.text())) return inputHasErrors;
    return status;
}

}  // namespace

void addRootsCommand(CommandLine& line) {
    Command command = line.add("roots", "Every crossing, jump and pole along rays, from and to CSV");
    auto arguments = std::make_shared<RootsArguments>();
    command
        .option("--table", arguments->table,
                "CSV with case_id,function,threshold,container,ox,oy,oz,dx,dy,dz")
        .required();
    addSolverOption(command, arguments->solver);
    command.option("--proof", arguments->proof,
                   "CSV for the steps by which each part of each ray was passed, or a root found there");
    arguments->work.addTo(command, "Seconds to work on each row");
    arguments->outputs.addTo(command);
    command.run([=] { return listRoots(*arguments); });
}

}  // namespace isoscope::cli
