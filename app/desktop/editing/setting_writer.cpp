// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/setting_writer.h"

#include <algorithm>
#include <utility>

#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {

SettingWriter::SettingWriter(SceneEditor* editor, SceneSession* session, QObject* parent)
    : QObject(parent), editor_(editor), session_(session) {
    connect(session, &SceneSession::parsed, this, [this](const auto&, quint64 revision) {
        if (waiting_ && revision == editor_->revision()) std::exchange(waiting_, nullptr)();
    });
}

void SettingWriter::setMaxGradient(std::size_t isosurface, double value) {
    whenParsed([this, isosurface, value] {
        std::vector<TextChange> changes;
        if (auto change = settingChange(*session_->result(), isosurface, ParameterRole::maxGradient, value))
            changes.push_back(std::move(*change));
        write(changes, ParameterRole::maxGradient, value);
    });
}

void SettingWriter::setMaxGradients(const std::map<std::size_t, double>& values) {
    if (values.size() == 1) return setMaxGradient(values.begin()->first, values.begin()->second);
    whenParsed([this, values] {
        // From the last to the first, so that each leaves the places of the others alone.
        std::map<std::uint32_t, std::pair<double, TextChange>, std::greater<>> changes;
        for (const auto& [isosurface, value] : values) {
            auto change = settingChange(*session_->result(), isosurface, ParameterRole::maxGradient, value);
            if (!change) continue;
            const auto known = changes.find(change->range.begin);
            if (known == changes.end() || known->second.first < value)
                changes[change->range.begin] = {value, std::move(*change)};
        }
        editor_->beginDrag();
        for (const auto& [place, change] : changes)
            editor_->replaceRange(change.second.range, QString::fromStdString(change.second.text));
        editor_->endDrag();
        emit said(tr("%1 values of max_gradient are changed.").arg(changes.size()));
    });
}

void SettingWriter::setForAll(ParameterRole role, double value) {
    whenParsed([this, role, value] { write(settingChanges(*session_->result(), role, value), role, value); });
}

void SettingWriter::setEvaluate(std::size_t isosurface, const std::array<double, 3>& numbers) {
    whenParsed([this, isosurface, numbers] {
        const ParseResult& parsed = *session_->result();
        const auto evaluate = evaluateChange(parsed, isosurface, numbers);
        auto gradient = settingChange(parsed, isosurface, ParameterRole::maxGradient, numbers[0]);
        if (!evaluate || !gradient) {
            emit said(tr("The isosurface does not stand in the text itself; it is not changed."));
            return;
        }
        std::vector<TextChange> changes{*evaluate, std::move(*gradient)};
        // The last place first, so that the other one stays right; at the same place one after the other.
        std::ranges::stable_sort(changes, std::greater<>(),
                                 [](const TextChange& change) { return change.range.begin; });
        editor_->beginDrag();
        for (const TextChange& change : changes)
            editor_->replaceRange(change.range, QString::fromStdString(change.text));
        editor_->endDrag();
        emit said(tr("The isosurface has evaluate now."));
    });
}

void SettingWriter::whenParsed(std::function<void()> write) {
    if (session_->result() && session_->resultRevision() == editor_->revision()) return write();
    waiting_ = std::move(write);
    session_->setText(editor_->utf8(), editor_->revision(), SceneSession::When::now);
}

void SettingWriter::write(const std::vector<TextChange>& changes, ParameterRole role, double value) {
    const QString name =
        role == ParameterRole::accuracy ? QStringLiteral("accuracy") : QStringLiteral("max_gradient");
    if (changes.empty()) {
        emit said(tr("The isosurface does not stand in the text itself; its %1 is not changed.").arg(name));
        return;
    }
    editor_->beginDrag();
    bool written = true;
    for (const TextChange& change : changes)
        written = editor_->replaceRange(change.range, QString::fromStdString(change.text)) && written;
    editor_->endDrag();
    if (written) emit said(tr("%1 is %2 now.").arg(name, numberText(value)));
}

}  // namespace isoscope
