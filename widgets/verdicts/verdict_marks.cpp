// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_marks.h"

#include <Qsci/qsciscintilla.h>

#include <algorithm>
#include <map>

#include "core/study/gradient/surface_verdict.h"
#include "widgets/verdicts/verdict_symbol.h"

namespace isoscope {

namespace {

constexpr int firstMarker = 8;  ///< behind those of diagnostics
constexpr int symbolSize = 14;
/// In the order of badness(): Scintilla draws higher numbers on top.
constexpr std::optional<GradientVerdict> verdicts[] = {
    GradientVerdict::right,     std::nullopt,           GradientVerdict::wasteful, GradientVerdict::unproven,
    GradientVerdict::unbounded, GradientVerdict::holes,
};

}  // namespace

int VerdictMarks::marker(std::optional<GradientVerdict> verdict) { return firstMarker + badness(verdict); }

int VerdictMarks::mask() {
    int mask = 0;
    for (const auto& verdict : verdicts) mask |= 1 << marker(verdict);
    return mask;
}

VerdictMarks::VerdictMarks(QsciScintilla* editor) : editor_(editor) { applyTheme(Look::light); }

void VerdictMarks::applyTheme(Look look) {
    for (const auto& verdict : verdicts)
        editor_->markerDefine(verdictSymbol(verdict, symbolSize, editor_->devicePixelRatioF(), look),
                              marker(verdict));
}

bool VerdictMarks::stand(const std::vector<Mark>& marks) const {
    return marks == given_ && std::ranges::all_of(marks_, [&](const Placed& placed) {
               return editor_->markerLine(placed.handle) == placed.mark.line;
           });
}

void VerdictMarks::set(const std::vector<Mark>& marks) {
    if (stand(marks)) return;
    given_ = marks;
    for (const auto& verdict : verdicts) editor_->markerDeleteAll(marker(verdict));
    marks_.clear();
    std::map<int, std::size_t> onLine;
    for (const Mark& mark : marks) {
        const auto [known, isNew] = onLine.try_emplace(mark.line, marks_.size());
        if (isNew) {
            marks_.push_back({mark, -1});
            continue;
        }
        Mark& shown = marks_[known->second].mark;
        shown.text += mark.text;
        if (badness(mark.verdict) > badness(shown.verdict)) shown.verdict = mark.verdict;
    }
    for (Placed& placed : marks_)
        placed.handle = editor_->markerAdd(placed.mark.line, marker(placed.mark.verdict));
    // Beside an empty text Scintilla paints no margin anew.
    editor_->viewport()->update();
}

QString VerdictMarks::textOfLine(int line) const {
    const auto found = std::ranges::find_if(marks_, [&](const Placed& placed) {
        return placed.handle >= 0 && editor_->markerLine(placed.handle) == line;
    });
    return found == marks_.end() ? QString() : found->mark.text;
}

}  // namespace isoscope
