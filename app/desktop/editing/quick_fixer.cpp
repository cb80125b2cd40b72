// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/quick_fixer.h"

#include <algorithm>

#include "widgets/document/scene_session.h"
#include "widgets/editor/code_words.h"
#include "widgets/editor/scene_editor.h"

namespace isoscope {

QuickFixer::QuickFixer(SceneEditor* editor, SceneSession* session, QObject* parent)
    : QObject(parent), editor_(editor) {
    connect(session, &SceneSession::parsed, this, [this](const auto& result, quint64 revision) {
        if (revision == editor_->revision()) shown_ = result;
    });
}

void QuickFixer::apply(std::vector<QuickFix> fixes) {
    if (!shown_ || shown_->sources->size() == 0 || fixes.empty()) return;
    const std::string present = editor_->utf8();
    std::erase_if(fixes, [&](QuickFix& fix) {
        const auto place = followed(fix.range, (*shown_->sources)[0].text(), present);
        if (place) fix.range = *place;
        return !place;
    });
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const QuickFix& a, const QuickFix& b) { return a.range.begin < b.range.begin; });
    const auto overlaps = [](const QuickFix& a, const QuickFix& b) { return b.range.begin < a.range.end; };
    fixes.erase(std::unique(fixes.begin(), fixes.end(), overlaps), fixes.end());
    if (fixes.empty()) {
        emit said(tr("The text has changed there."));
        return;
    }
    editor_->beginDrag();
    // From the end, so that the places before stay right.
    for (auto fix = fixes.rbegin(); fix != fixes.rend(); ++fix)
        editor_->replaceRange(fix->range, QString::fromStdString(fix->replacement));
    editor_->endDrag();
    emit said(fixes.size() == 1 ? withQuotedCode(fixes.front().title) + tr(": done.")
                                : tr("%1 changes made.").arg(fixes.size()));
}

std::optional<SourceRange> followed(const SourceRange& range, std::string_view before,
                                    std::string_view after) {
    if (range.file != 0 || range.begin > range.end || range.end > before.size()) return std::nullopt;
    const std::size_t shorter = std::min(before.size(), after.size());
    const auto same =
        std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(shorter), after.begin());
    const auto head = static_cast<std::size_t>(same.first - before.begin());
    if (range.end <= head) return range;
    std::size_t tail = 0;
    while (tail < shorter - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    if (range.begin < before.size() - tail) return std::nullopt;
    const auto moved = [&](std::uint32_t at) {
        return static_cast<std::uint32_t>(at + after.size() - before.size());
    };
    return SourceRange{0, moved(range.begin), moved(range.end)};
}

}  // namespace isoscope
