// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_binding.h"

#include <algorithm>

#include "widgets/document/scene_session.h"
#include "widgets/document/text_feed.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/slider_player.h"

namespace isoscope {
namespace {

/// Of texts with a value that plays: places in them are not those of the editor's text, which has no such
/// one.
constexpr quint64 playedRevision = ~quint64(0);

}  // namespace

ParameterBinding::ParameterBinding(SceneEditor* editor, ParameterPanel* panel, SceneSession* session,
                                   TextFeed* feed, QObject* parent)
    : QObject(parent), editor_(editor), panel_(panel), session_(session), feed_(feed) {
    connect(editor, &SceneEditor::numberScrubbed, this, &ParameterBinding::scrub);
    connect(panel, &ParameterPanel::dragStarted, editor, &SceneEditor::beginDrag);
    connect(panel, &ParameterPanel::dragFinished, editor, &SceneEditor::endDrag);
    connect(panel, &ParameterPanel::valueChanged, this, &ParameterBinding::move);
    connect(panel, &ParameterPanel::valuesChosen, this, &ParameterBinding::moveAll);
    connect(panel, &ParameterPanel::noteChanged, this, &ParameterBinding::writeNote);
    connect(panel, &ParameterPanel::replaceExpressionRequested, this, &ParameterBinding::replaceExpression);
    connect(panel->player(), &SliderPlayer::played, this, [this](int index, double value) {
        showPlayed({{index, value}}, false);
    });
    connect(this, &ParameterBinding::playedInVain, panel->player(), &SliderPlayer::pictureFinished);
    connect(panel->player(), &SliderPlayer::finished, this, &ParameterBinding::finishPlay);
    // Within a change of the text nothing else may change it.
    connect(editor, &SceneEditor::textEdited, panel->player(), &SliderPlayer::stop, Qt::QueuedConnection);
    connect(session, &SceneSession::parsed, this, &ParameterBinding::adopt);
}

void ParameterBinding::clear() {
    owner_.reset();
    parameters_.clear();
    panel_->clear();
}

void ParameterBinding::adopt(const std::shared_ptr<const ParseResult>& result, quint64 revision) {
    // With errors it gives no picture to wait for.
    if (revision == playedRevision && !result->ok()) emit playedInVain();
    // A result for an older text has its places wrong; a newer one will follow.
    if (revision != editor_->revision()) return;
    owner_ = result;
    parameters_.clear();
    std::vector<SourceRange> ranges;
    for (const SceneParameter& parameter : result->scene->parameters) {
        if (parameter.range.file != 0) continue;
        parameters_.push_back(parameter);
        ranges.push_back(parameter.range);
    }
    editor_->markNumbers(ranges);
    panel_->setParameters(parameters_, result->sources.get());
}

void ParameterBinding::move(int index, double value) {
    if (!isIndex(index)) return;
    feed_->setPaused(true);
    const QString text = panel_->textFor(index, value);
    const bool written = write(index, text);
    feed_->setPaused(false);
    if (written) submit(index, text.toDouble());
}

void ParameterBinding::showPlayed(const Values& values, bool parse) {
    Values moves;
    std::vector<std::pair<SourceRange, std::string>> numbers;
    for (const auto& [index, value] : values) {
        const std::optional<SourceRange> range =
            isIndex(index) ? editor_->numberRange(index) : std::optional<SourceRange>();
        if (!range) continue;
        const QString number = panel_->textFor(index, value);
        moves.emplace_back(parameters_[static_cast<std::size_t>(index)].slot, number.toDouble());
        numbers.emplace_back(*range, number.toStdString());
    }
    if (!parse && (moves.empty() || session_->setParameters(owner_.get(), moves))) return;
    // The last one first, so that the places of the others stay valid.
    std::sort(numbers.begin(), numbers.end(),
              [](const auto& a, const auto& b) { return a.first.begin > b.first.begin; });
    std::string text = editor_->utf8();
    for (const auto& [range, number] : numbers) text.replace(range.begin, range.end - range.begin, number);
    session_->setText(std::move(text), playedRevision, SceneSession::When::now);
}

void ParameterBinding::keepPlayed(const Values& values) {
    values.empty() ? feed_->submit(SceneSession::When::now) : moveAll(values);
}

void ParameterBinding::finishPlay(int index, double value) {
    editor_->beginDrag();
    move(index, value);
    editor_->endDrag();
}

void ParameterBinding::moveAll(const std::vector<std::pair<int, double>>& values) {
    feed_->setPaused(true);
    editor_->beginDrag();
    bool written = false;
    for (const auto& [index, value] : values) {
        if (!isIndex(index)) continue;
        const QString text = panel_->textFor(index, value);
        if (!write(index, text)) continue;
        written = true;
        parameters_[static_cast<std::size_t>(index)].value = text.toDouble();
        panel_->setValue(index, text.toDouble());
    }
    editor_->endDrag();
    feed_->setPaused(false);
    if (written) feed_->submit(SceneSession::When::now);
}

void ParameterBinding::writeNote(int index, const std::optional<SliderNote>& note) {
    const std::optional<SourceRange> number = editor_->numberRange(index);
    if (!isIndex(index) || !number) return;
    const bool inText = number->begin < number->end;
    const auto edit = inText ? sliderNoteEdit(editor_->utf8(), number->end, note) : std::nullopt;
    if (!edit) {
        if (note)
            emit said(
                tr("Kept until the file is closed: the text can only keep it for the last number of a line"));
        return;
    }
    changeComment(*edit);
}

void ParameterBinding::changeComments(const std::vector<TextEdit>& edits) {
    feed_->setPaused(true);
    editor_->beginDrag();
    bool written = false;
    for (const TextEdit& edit : edits)
        written =
            editor_->replaceRange({0, edit.begin, edit.end}, QString::fromStdString(edit.text)) || written;
    editor_->endDrag();
    feed_->setPaused(false);
    // A comment changes nothing but places.
    if (written) session_->followParameter(editor_->utf8(), editor_->revision());
}

bool ParameterBinding::write(int index, const QString& text) {
    SceneParameter& parameter = parameters_[static_cast<std::size_t>(index)];
    if (!parameter.implied) return editor_->replaceNumber(index, text);
    const QString words = QStringLiteral("\n  %1 ").arg(QString::fromStdString(parameter.name));
    if (!editor_->insertNumber(index, words, text)) return false;
    parameter.implied = false;
    return true;
}

void ParameterBinding::scrub(int index, double value) {
    feed_->passRewriting();
    if (isIndex(index)) {
        panel_->setValue(index, value);
        submit(index, value);
    } else {
        feed_->submit(SceneSession::When::now);
    }
}

void ParameterBinding::submit(int index, double value) {
    SceneParameter& parameter = parameters_[static_cast<std::size_t>(index)];
    parameter.value = value;
    if (session_->setParameter(owner_.get(), parameter.slot, value))
        session_->followParameter(editor_->utf8(), editor_->revision());
    else
        feed_->submit(SceneSession::When::now);
}

void ParameterBinding::replaceExpression(int index) {
    if (!isIndex(index)) return;
    editor_->replaceNumber(index, panel_->textFor(index, parameters_[static_cast<std::size_t>(index)].value));
}

}  // namespace isoscope
