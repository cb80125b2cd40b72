// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/table_row.h"
#include "app/cli/time_limit.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/roots/verdict.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct TraceArguments {
    SceneArguments scene;
    std::string rays;
    std::string object;
    std::string solver = "lipschitz";
    WorkLimit work{WorkLimit::ofPictures};
};

/// `kind` says what was met, or why that is not certain.
std::vector<std::string> fieldsOf(const NearestHit& nearest, const ScaledDirection& direction,
                                  Verdict verdict) {
    if (!nearest.found)
        return {"0", "", "", "", "", "", "", "", verdict <= Verdict::certifiedMiss ? "miss" : name(verdict)};
    const Hit& hit = nearest.hit;
    std::vector<std::string> fields{"1"};
    for (const double value : {direction.tableT(hit.t), hit.point.x, hit.point.y, hit.point.z, hit.normal.x,
                               hit.normal.y, hit.normal.z})
        fields.push_back(exactNumber(value));
    fields.emplace_back(verdict <= Verdict::gap ? name(hit.kind) : name(verdict));
    return fields;
}

/// The answer to a row that is no ray.
const std::vector<std::string> errorFields{"error", "", "", "", "", "", "", "", ""};

ExitStatus trace(const TraceArguments& arguments) {
    const std::optional<CsvTable> table = loadTable(arguments.rays, {"ox", "oy", "oz", "dx", "dy", "dz"});
    if (!table) return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const ShapePointer shape = shapeToTest(parsed, arguments.object);
    if (!shape) return inputHasErrors;

    std::vector<Ray> rays(table->rowCount());
    std::vector<ScaledDirection> directions(rays.size());
    std::vector<bool> malformed(rays.size());
    for (std::size_t number = 0; number < rays.size(); ++number) {
        TableRow row(arguments.rays, *table, number);
        rays[number].origin = row.point("ox", "oy", "oz");
        directions[number] = row.direction("dx", "dy", "dz");
        rays[number].direction = directions[number].scaled;
        rays[number].sample = static_cast<std::uint32_t>(number);
        malformed[number] = !row.ok();
        if (malformed[number]) rays[number].direction = {1, 0, 0};
    }
    std::vector<NearestHit> nearest(rays.size());
    TraceContext context(parsed.scene->parameterTable, rootFinder(arguments.solver));
    std::vector<Verdict> verdicts(rays.size(), Verdict::certifiedMiss);
    context.verdicts = verdicts;
    {
        const TimeLimit limit(arguments.work.seconds);
        const LoopStop loops(limit.token());
        context.stop = limit.token();
        shape->nearest(rays, context, nearest);
        if (limit.over()) {
            arguments.work.error(arguments.rays, "not all rays are traced, none is answered");
            return inputHasErrors;
        }
    }

    std::cout << csvLine({"hit", "t", "px", "py", "pz", "nx", "ny", "nz", "kind"});
    for (std::size_t row = 0; row < rays.size(); ++row)
        std::cout << csvLine(malformed[row] ? errorFields
                                            : fieldsOf(nearest[row], directions[row], verdicts[row]));
    const bool allUnderstood = std::find(malformed.begin(), malformed.end(), true) == malformed.end();
    return parsed.ok() && allUnderstood ? done : inputHasErrors;
}

}  // namespace

void addTraceCommand(CommandLine& line) {
    Command command = line.add("trace", "First hits of rays, from and to CSV");
    auto arguments = std::make_shared<TraceArguments>();
    arguments->scene.addTo(command);
    command.option("--rays", arguments->rays, "CSV with ox,oy,oz,dx,dy,dz").required();
    command.option("--object", arguments->object, "Declared object to test (default: the whole scene)");
    arguments->work.addTo(command, "Seconds to trace the rays");
    addSolverOption(command, arguments->solver);
    command.run([=] { return trace(*arguments); });
}

}  // namespace isoscope::cli
