// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/formula_offer.h"

#include <algorithm>
#include <QMetaObject>

#include "app/desktop/editing/quick_fixer.h"
#include "core/language/functions/bare_formula.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

namespace isoscope {

namespace {

bool isBlank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// The first formula of the user's own text.
const Diagnostic* formulaOf(const ParseResult& result) {
    const auto found =
        std::find_if(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& one) { return one.id == "bare-formula" && one.range.file == 0; });
    return found == result.diagnostics.end() ? nullptr : &*found;
}

/// What the formula at `range` is to be replaced by. Without a replacement where nothing can be made of it.
QuickFix fixFor(const ParseResult& result, const SourceRange& range, const std::stop_token& stop) {
    const std::string_view text = (*result.sources)[0].text();
    const auto isNumber = [&result](std::string_view name) {
        const Value* value = result.symbols->find(name);
        return value && std::holds_alternative<NumberValue>(value->data);
    };
    QuickFix fix{FormulaOffer::tr("Make It an Isosurface").toStdString(), range, {}};
    const std::optional<BareFormula> formula = readBareFormula(text, range.begin, isNumber);
    if (!formula) return fix;
    const FormulaIsosurface surface = formulaIsosurface(*formula, *result.symbols, stop);
    const bool alone = isBlank(text.substr(0, range.begin)) && isBlank(text.substr(range.end));
    fix.replacement = alone ? surface.scene : surface.statement;
    // The line that the formula was in has its end already.
    if (range.end < text.size() && fix.replacement.ends_with('\n')) fix.replacement.pop_back();
    return fix;
}

}  // namespace

FormulaOffer::FormulaOffer(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connect(parts_.session, &SceneSession::parsed, this, [this](const auto& result, quint64 revision) {
        if (revision == parts_.editor->revision()) consider(result);
    });
}

void FormulaOffer::consider(const std::shared_ptr<const ParseResult>& result) {
    const Diagnostic* formula = result->notation == Notation::povray ? formulaOf(*result) : nullptr;
    if (!formula) return withdraw();
    std::string text((*result->sources)[0].text());
    if (text == considered_) return;
    considered_ = std::move(text);
    const SourceRange range = formula->range;
    worker_.submit([this, result, range](std::stop_token stop) {
        const QuickFix fix = fixFor(*result, range, stop);
        QMetaObject::invokeMethod(this, [this, result, fix] {
            if (!fix.replacement.empty() && parts_.session->result() == result) offer(fix);
        });
    });
}

void FormulaOffer::offer(const QuickFix& fix) {
    shown_ = tr("A formula shows nothing by itself. As an isosurface it can be seen.");
    parts_.notices->ask(shown_, {{QString::fromStdString(fix.title),
                                  tr("Replace the formula by its isosurface; Undo brings it back"),
                                  [this, fix] { parts_.fixer->apply({fix}); }},
                                 {tr("Not Now"), tr("Leave the text as it is"), {}}});
}

void FormulaOffer::withdraw() {
    considered_.clear();
    if (!shown_.isEmpty() && parts_.notices->text() == shown_) parts_.notices->hide();
    shown_.clear();
}

}  // namespace isoscope
