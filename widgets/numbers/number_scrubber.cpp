// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_scrubber.h"

#include <cmath>
#include <QMouseEvent>
#include <QWheelEvent>

#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/editor/scene_lexer.h"
#include "widgets/numbers/number_literal.h"
#include "widgets/numbers/number_marks.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/undo_group.h"

namespace isoscope {
namespace {

using Sci = QsciScintillaBase;

double stepFactor(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ShiftModifier) return 0.1;
    if (modifiers & (Qt::ControlModifier | Qt::AltModifier)) return 10;
    return 1;
}

/// With all the places of the resolution ("0.50"), because the next step is one in the last place.
QByteArray scrubbedText(double value, double resolution) {
    const int decimals = static_cast<int>(std::lround(-std::log10(resolution)));
    constexpr int mostPlaces = 6;
    if (decimals <= 0 || decimals > mostPlaces) return numberText(value).toLatin1();
    return QByteArray::number(value, 'f', decimals);
}

}  // namespace

NumberScrubber::NumberScrubber(SceneEditor* editor) : editor_(editor) {
    wheelEnd_.setSingleShot(true);
    wheelEnd_.setInterval(UndoGroup::pause);
    connect(&wheelEnd_, &QTimer::timeout, this, &NumberScrubber::finish);
}

bool NumberScrubber::handle(QEvent* event) {
    switch (event->type()) {
        case QEvent::Wheel: return wheel(static_cast<QWheelEvent*>(event));
        case QEvent::MouseButtonPress: return press(static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove: return move(static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease: return release();
        default: return false;
    }
}

bool NumberScrubber::wheel(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::AltModifier) || dragging_) return false;
    const auto number = numberUnder(event->position().toPoint());
    if (!number) return false;
    // With Alt held some platforms report the wheel as a horizontal one.
    const QPoint angle = event->angleDelta();
    wheelRest_ += angle.y() != 0 ? angle.y() : angle.x();
    const int steps = wheelRest_ / 120;
    wheelRest_ -= steps * 120;
    event->accept();
    if (steps == 0) return true;
    const double step = number->step() * stepFactor(event->modifiers() & ~Qt::AltModifier);
    begin_ = number->begin;
    editor_->undoGroup_->change();
    set(number->value + steps * step, step);
    wheelEnd_.start();
    return true;
}

bool NumberScrubber::press(QMouseEvent* event) {
    constexpr Qt::KeyboardModifiers ours = Qt::ControlModifier | Qt::AltModifier;
    if (event->button() != Qt::LeftButton || !(event->modifiers() & ours)) return false;
    const auto number = numberUnder(event->position().toPoint());
    if (!number) return false;
    dragging_ = true;
    moved_ = false;
    heldBy_ = event->modifiers() & Qt::ControlModifier ? Qt::ControlModifier : Qt::AltModifier;
    begin_ = number->begin;
    startValue_ = number->value;
    startStep_ = number->step();
    startX_ = event->position().toPoint().x();
    editor_->beginDrag();
    startSerial_ = editor_->history()->serial();
    editor_->viewport()->setCursor(Qt::SizeHorCursor);
    return true;
}

bool NumberScrubber::move(QMouseEvent* event) {
    if (!dragging_) return false;
    // The release may have been delivered to another program.
    if (!(event->buttons() & Qt::LeftButton)) {
        release();
        return false;
    }
    const int steps = (event->position().toPoint().x() - startX_) / pixelsPerStep;
    if (steps == 0 && !moved_) return true;
    moved_ = true;
    const double step = startStep_ * stepFactor(event->modifiers() & ~heldBy_);
    set(startValue_ + steps * step, step);
    return true;
}

bool NumberScrubber::release() {
    if (!dragging_) return false;
    dragging_ = false;
    editor_->endDrag();
    editor_->viewport()->setCursor(Qt::IBeamCursor);
    finish();
    if (!moved_ && heldBy_ == Qt::ControlModifier) {
        editor_->SendScintilla(Sci::SCI_GOTOPOS, static_cast<unsigned long>(begin_));
        emit clicked();
    }
    return true;
}

void NumberScrubber::cancel() {
    if (!dragging_) return;
    moved_ = true;  // no click either
    release();
    if (editor_->history()->serial() != startSerial_) editor_->undo();
}

std::optional<NumberLiteral> NumberScrubber::atCaret() const {
    return numberOf(editor_->SendScintilla(Sci::SCI_GETCURRENTPOS));
}

bool NumberScrubber::stepAtCaret(double steps) {
    const auto number = atCaret();
    if (!number || dragging_) return false;
    const double amount = std::abs(steps), step = number->step() * (amount < 1 ? amount : 1);
    begin_ = number->begin;
    editor_->undoGroup_->change();
    set(number->value + steps * number->step(), step);
    wheelEnd_.start();
    return true;
}

std::optional<NumberLiteral> NumberScrubber::numberUnder(const QPoint& position) const {
    const long at = editor_->SendScintilla(Sci::SCI_POSITIONFROMPOINTCLOSE,
                                           static_cast<unsigned long>(position.x()), position.y());
    return at < 0 ? std::nullopt : numberOf(at);
}

std::optional<NumberLiteral> NumberScrubber::numberOf(long position) const {
    const auto number = numberAt(editor_->utf8(), static_cast<int>(position));
    if (!number || styleAt(editor_, number->end - 1) != SceneStyle::number) return std::nullopt;
    return number;
}

void NumberScrubber::set(double value, double resolution) {
    const double rounded = roundToResolution(value, resolution);
    if (std::isfinite(rounded)) write(begin_, rounded, scrubbedText(rounded, resolution));
}

bool NumberScrubber::write(int begin, double value, const QByteArray& text) {
    const std::string before = editor_->utf8();
    // An edit from elsewhere in mid-drag may have moved the number: then there is none here any more.
    auto number = numberAt(before, begin);
    // Two numbers that touch, as in "1.5.5".
    if (number && number->begin != begin) number = numberAt(before, begin + 1);
    if (!number || number->begin != begin) return false;
    const int index = editor_->numberMarks_->indexOf(number->begin, number->end);
    editor_->rewrite(number->begin, number->end, text);
    emit editor_->numberScrubbed(index, value);
    return true;
}

void NumberScrubber::finish() {
    wheelEnd_.stop();
    wheelRest_ = 0;
    emit editor_->scrubFinished();
}

}  // namespace isoscope
