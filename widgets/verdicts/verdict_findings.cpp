// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_findings.h"

#include <algorithm>
#include <map>

#include "core/study/gradient/proof_note.h"
#include "core/study/gradient/statement_verdict.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/setting_text.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

const char* idOf(GradientVerdict verdict) {
    switch (verdict) {
        case GradientVerdict::holes: return "max-gradient-too-low";
        case GradientVerdict::wasteful: return "max-gradient-too-high";
        case GradientVerdict::unbounded: return "gradient-unbounded";
        default: return "gradient-unproven";
    }
}

/// The setting in the text, else the first word of the statement.
SourceRange placeOf(const ParseResult& parsed, std::size_t isosurface) {
    const SourceRange& statement = parsed.scene->isosurfaces[isosurface].range;
    for (const SceneParameter& parameter : parsed.scene->parameters) {
        const SourceRange& range = parameter.range;
        if (parameter.role == ParameterRole::maxGradient && !parameter.implied &&
            range.file == statement.file && statement.begin <= range.begin && range.end <= statement.end)
            return range;
    }
    constexpr std::uint32_t wordLength = sizeof "isosurface" - 1;
    return {statement.file, statement.begin, std::min(statement.end, statement.begin + wordLength)};
}

/// Of a comment in front of the statement that is not true any more.
std::optional<Diagnostic> noteFinding(const SurfaceVerdict& verdict, const ParseResult& parsed) {
    const SceneIsosurface& statement = parsed.scene->isosurfaces[verdict.isosurface];
    if (!statement.shape || statement.range.file != 0 || parsed.sources->size() == 0) return {};
    const auto note = noteBefore((*parsed.sources)[0].text(), statement.range);
    const double accuracy = statement.shape->rootSettings().accuracy;
    if (!note || checkNote(*note, verdict.bracket, accuracy) != NoteState::broken) return {};
    Diagnostic finding;
    finding.severity = Severity::warning;
    finding.id = "proof-comment-broken";
    finding.range = note->range;
    finding.message = brokenNoteText(*note, verdict.bracket, accuracy);
    finding.fixes.push_back({"Remove the comment", note->range, {}});
    return finding;
}

bool isWorthALine(std::optional<GradientVerdict> verdict) {
    return verdict && *verdict != GradientVerdict::right;
}

}  // namespace

std::map<std::size_t, double> neededGradients(const std::vector<SurfaceVerdict>& verdicts,
                                              const ParseResult& parsed) {
    std::map<std::size_t, double> values;
    if (!parsed.scene) return values;
    std::map<std::size_t, const SurfaceVerdict*> byNumber;
    for (const SurfaceVerdict& one : verdicts) byNumber[one.isosurface] = &one;
    for (const StatementVerdict& statement : statementVerdicts(verdicts, *parsed.scene)) {
        if (!statement.needed) continue;
        for (const std::size_t i : statement.isosurfaces) {
            const auto verdict = byNumber[i]->verdict();
            const bool mendable = verdict == GradientVerdict::holes || verdict == GradientVerdict::wasteful ||
                                  verdict == GradientVerdict::unproven;
            if (mendable && *statement.needed != byNumber[i]->setting) values[i] = *statement.needed;
        }
    }
    return values;
}

Diagnostics verdictFindings(const std::vector<SurfaceVerdict>& verdicts, const ParseResult& parsed) {
    Diagnostics findings;
    if (!parsed.scene) return findings;
    const auto needed = neededGradients(verdicts, parsed);
    for (const SurfaceVerdict& one : verdicts) {
        if (auto stale = noteFinding(one, parsed)) findings.push_back(std::move(*stale));
        const auto verdict = one.verdict();
        if (!isWorthALine(verdict)) continue;
        Diagnostic finding;
        finding.severity = *verdict == GradientVerdict::holes ? Severity::warning : Severity::note;
        finding.id = idOf(*verdict);
        finding.range = placeOf(parsed, one.isosurface);
        finding.message = VerdictText::plain(one).toStdString();
        finding.hint = VerdictText::exact(one).toStdString();
        if (one.bracket.singularity) finding.hint += ' ' + std::string(advice(one.bracket.singularity->kind));
        if (const auto value = needed.find(one.isosurface); value != needed.end())
            if (const auto change =
                    settingChange(parsed, one.isosurface, ParameterRole::maxGradient, value->second))
                finding.fixes.push_back(
                    {"Use " + numberText(value->second).toStdString(), change->range, change->text});
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::vector<int> verdictLines(const ParseResult& parsed) {
    std::vector<int> lines;
    if (!parsed.scene || !parsed.sources) return lines;
    for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
        const SourceRange place = placeOf(parsed, i);
        const bool own = place.file == 0 && parsed.sources->size() > 0;
        lines.push_back(own ? (*parsed.sources)[0].position(place.begin).line : 0);
    }
    return lines;
}

}  // namespace isoscope
