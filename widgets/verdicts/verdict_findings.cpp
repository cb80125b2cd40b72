// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_findings.h"

#include <algorithm>
#include <map>
#include <tuple>

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

/// Where each max_gradient of a text stands; there may be tens of thousands.
class GradientPlaces {
  public:
    explicit GradientPlaces(const Scene& scene) : scene_(scene) {
        for (const SceneParameter& parameter : scene.parameters)
            if (parameter.role == ParameterRole::maxGradient && !parameter.implied)
                settings_.push_back(parameter.range);
        std::sort(settings_.begin(), settings_.end(), isBefore);
    }

    /// The setting in the statement of an isosurface, else the statement's first word.
    SourceRange of(std::size_t isosurface) const {
        const SourceRange& statement = scene_.isosurfaces[isosurface].range;
        const auto found = std::lower_bound(settings_.begin(), settings_.end(), statement, isBefore);
        if (found != settings_.end() && found->file == statement.file && found->end <= statement.end)
            return *found;
        constexpr std::uint32_t wordLength = sizeof "isosurface" - 1;
        return {statement.file, statement.begin, std::min(statement.end, statement.begin + wordLength)};
    }

  private:
    static bool isBefore(const SourceRange& a, const SourceRange& b) {
        return std::tie(a.file, a.begin) < std::tie(b.file, b.begin);
    }

    const Scene& scene_;
    std::vector<SourceRange> settings_;
};

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
    const GradientPlaces places(*parsed.scene);
    for (const SurfaceVerdict& one : verdicts) {
        if (auto stale = noteFinding(one, parsed)) findings.push_back(std::move(*stale));
        const auto verdict = one.verdict();
        if (!isWorthALine(verdict)) continue;
        Diagnostic finding;
        finding.severity = *verdict == GradientVerdict::holes ? Severity::warning : Severity::note;
        finding.id = idOf(*verdict);
        finding.range = places.of(one.isosurface);
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
    const GradientPlaces places(*parsed.scene);
    for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
        const SourceRange place = places.of(i);
        const bool own = place.file == 0 && parsed.sources->size() > 0;
        lines.push_back(own ? (*parsed.sources)[0].position(place.begin).line : 0);
    }
    return lines;
}

}  // namespace isoscope
