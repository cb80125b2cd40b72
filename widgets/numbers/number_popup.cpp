// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_popup.h"

#include <QKeyEvent>
#include <QSlider>
#include <QVBoxLayout>

#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_literal.h"
#include "widgets/numbers/number_scrubber.h"
#include "widgets/numbers/number_text.h"
#include "widgets/parameters/parameter_slider.h"

namespace isoscope {

NumberPopup::NumberPopup(SceneEditor* editor, int begin, const SceneParameter& number)
    : QFrame(editor, Qt::Popup), editor_(editor), begin_(begin), before_(editor->utf8()) {
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameStyle(QFrame::StyledPanel | QFrame::Raised);
    setAccessibleName(tr("Slider for the number at the caret"));
    setToolTip(tr("Enter keeps the number, Esc brings the first one back"));
    slider_ = new ParameterSlider(number, this);
    if (const auto end = numberEnd()) slider_->setParameter(number, sliderNoteBehind(before_, *end));
    constexpr int width = 340, margin = 8;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addWidget(slider_);
    setMinimumWidth(width);
    connect(slider_, &ParameterSlider::dragStarted, editor, &SceneEditor::beginDrag);
    connect(slider_, &ParameterSlider::dragFinished, editor, &SceneEditor::endDrag);
    connect(slider_, &ParameterSlider::valueChanged, this, [this](double value) {
        editor_->scrubber()->write(begin_, value, numberTextWith(value, slider_->decimals()).toLatin1());
    });
    connect(slider_, &ParameterSlider::noteChanged, this, &NumberPopup::writeNote);
    if (auto* handle = slider_->findChild<QSlider*>()) setFocusProxy(handle);
}

std::optional<std::size_t> NumberPopup::numberEnd() const {
    const std::string text = editor_->utf8();
    auto number = numberAt(text, begin_);
    // Two numbers that touch, as in "1.5.5".
    if (number && number->begin != begin_) number = numberAt(text, begin_ + 1);
    return number && number->begin == begin_ ? std::optional(static_cast<std::size_t>(number->end))
                                             : std::nullopt;
}

void NumberPopup::writeNote(const std::optional<SliderNote>& note) {
    const auto end = numberEnd();
    const auto edit = end ? sliderNoteEdit(editor_->utf8(), *end, note) : std::nullopt;
    if (!edit) return;
    editor_->beginDrag();
    editor_->replaceRange({0, edit->begin, edit->end}, QString::fromStdString(edit->text));
    editor_->endDrag();
}

void NumberPopup::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape: restore(); [[fallthrough]];
        case Qt::Key_Return:
        case Qt::Key_Enter: close(); break;
        default: QFrame::keyPressEvent(event);
    }
}

void NumberPopup::hideEvent(QHideEvent* event) {
    slider_->settle();
    QFrame::hideEvent(event);
}

void NumberPopup::restore() {
    slider_->settle();
    // One step for each drag.
    while (editor_->isUndoAvailable() && editor_->utf8() != before_) editor_->undo();
}

}  // namespace isoscope
