// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/statement_verdict.h"

#include <algorithm>
#include <map>

namespace isoscope {

namespace {

void addTo(StatementVerdict& statement, const SurfaceVerdict& one) {
    const bool first = statement.isosurfaces.empty();
    statement.isosurfaces.push_back(one.isosurface);
    const auto verdict = one.verdict();
    if (first || badness(verdict) > badness(statement.verdict)) statement.verdict = verdict;
    const auto needed = one.suggested();
    if (first)
        statement.needed = needed;
    else if (!needed || !statement.needed)
        statement.needed.reset();
    else
        statement.needed = std::max(*statement.needed, *needed);
    statement.setting = first ? one.setting : std::min(statement.setting, one.setting);
    statement.lower = first ? one.bracket.lower : std::max(statement.lower, one.bracket.lower);
    statement.upper = first ? one.bracket.upper : std::max(statement.upper, one.bracket.upper);
    const bool counted = one.effects.has_value() || verdict == GradientVerdict::right;
    statement.counted = counted && (first || statement.counted);
    if (one.effects) statement.mistakes += one.effects->mistakes;
    if (one.waste) statement.waste = std::max(statement.waste.value_or(0), *one.waste);
}

}  // namespace

bool StatementVerdict::mendable() const {
    const bool bad = verdict == GradientVerdict::holes || verdict == GradientVerdict::wasteful ||
                     verdict == GradientVerdict::unproven;
    return bad && needed && *needed != setting;
}

std::vector<StatementVerdict> statementVerdicts(const std::vector<SurfaceVerdict>& verdicts,
                                                const Scene& scene) {
    std::vector<StatementVerdict> statements;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    for (const SurfaceVerdict& one : verdicts) {
        if (one.isosurface >= scene.isosurfaces.size()) continue;
        const SourceRange& range = scene.isosurfaces[one.isosurface].range;
        const auto [entry, isNew] = known.try_emplace({range.file, range.begin}, statements.size());
        if (isNew) statements.emplace_back().range = range;
        addTo(statements[entry->second], one);
    }
    return statements;
}

}  // namespace isoscope
