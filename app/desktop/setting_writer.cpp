// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/setting_writer.h"

#include <utility>

#include "widgets/number_text.h"
#include "widgets/scene_editor.h"
#include "widgets/scene_session.h"
#include "widgets/setting_text.h"

namespace isoscope {

SettingWriter::SettingWriter(SceneEditor* editor, SceneSession* session, QObject* parent)
    : QObject(parent), editor_(editor), session_(session) {
    connect(session, &SceneSession::parsed, this, [this](const auto&, quint64 revision) {
        if (waiting_ && revision == editor_->revision()) std::exchange(waiting_, nullptr)();
    });
}

void SettingWriter::setMaxGradient(std::size_t isosurface, double value) {
    if (session_->result() && session_->resultRevision() == editor_->revision()) {
        writeMaxGradient(isosurface, value);
        return;
    }
    waiting_ = [this, isosurface, value] { writeMaxGradient(isosurface, value); };
    session_->setText(editor_->utf8(), editor_->revision(), SceneSession::When::now);
}

void SettingWriter::writeMaxGradient(std::size_t isosurface, double value) {
    const auto change = maxGradientChange(*session_->result(), isosurface, value);
    if (!change) {
        emit said(tr("This isosurface does not stand in the text itself; its max_gradient is not changed."));
        return;
    }
    if (editor_->replaceRange(change->range, change->text))
        emit said(tr("max_gradient is %1 now.").arg(numberText(value)));
}

}  // namespace isoscope
