// SPDX-License-Identifier: GPL-3.0-or-later
// Of ParameterSlider: range, step, scale and lock, and the menu that changes them.
#include <algorithm>
#include <cmath>
#include <QAction>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRandomGenerator>
#include <QSlider>
#include <QToolButton>

#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/slider_scale.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/band_slider.h"
#include "widgets/parameters/slider_note_popup.h"

namespace isoscope {
namespace {

SliderScale scaleFor(const SceneParameter& parameter) {
    using Kind = SliderScale::Kind;
    const Kind kind = parameter.integral      ? Kind::integral
                      : parameter.logarithmic ? Kind::logarithmic
                                              : Kind::linear;
    // Walls of a container are moved a little; they are never sent far away.
    constexpr double wallTravel = 2;
    if (parameter.role == ParameterRole::container && parameter.value != 0) {
        const double reach = wallTravel * std::abs(parameter.value);
        return SliderScale(std::max(parameter.minimum, -reach), std::min(parameter.maximum, reach), kind);
    }
    return SliderScale(parameter.minimum, parameter.maximum, kind);
}

}  // namespace

SliderScale ParameterSlider::proposedScale() const {
    using Kind = SliderScale::Kind;
    if (!note_) return scaleFor(parameter_);
    const Kind kind = note_->logarithmic    ? Kind::logarithmic
                      : parameter_.integral ? Kind::integral
                                            : Kind::linear;
    return SliderScale(note_->minimum, note_->maximum, kind, note_->step);
}

SliderNote ParameterSlider::note() const {
    if (note_) return *note_;
    SliderNote note;
    note.minimum = scale_->minimum();
    note.maximum = scale_->maximum();
    note.logarithmic = scale_->kind() == SliderScale::Kind::logarithmic;
    return note;
}

void ParameterSlider::setRange(double minimum, double maximum) {
    SliderNote wanted = note();
    wanted.minimum = minimum;
    wanted.maximum = maximum;
    if (wanted.step > maximum - minimum) wanted.step = 0;
    changeNote(wanted);
}

void ParameterSlider::changeNote(const std::optional<SliderNote>& note) {
    // The scale would mend bad ends; a person who types them should see that nothing happens.
    if (!slider_ || note == note_ || (note && !isUsable(*note))) return;
    stopPlaying();
    endChange();
    note_ = note;
    noteOfText_ = false;
    *scale_ = proposedScale();
    showNote();
    showValue();
    showTexts();
    emit noteChanged(note_);
}

void ParameterSlider::setLocked(bool locked) {
    SliderNote wanted = note();
    wanted.locked = locked;
    changeNote(wanted);
}

void ParameterSlider::showNote() {
    if (!slider_) return;
    lock_->setVisible(isLocked());
    playButton_->setVisible(playOffered_ && canPlay());
    slider_->setEnabled(!isLocked());
    box_->setEnabled(!isLocked());
    box_->setPlaces(decimals());
}

double ParameterSlider::randomValue() const {
    const double value = scale_->value(QRandomGenerator::global()->bounded(scale_->steps() + 1));
    return decimals() < 0 ? value : numberTextWith(value, decimals()).toDouble();
}

void ParameterSlider::randomise() {
    if (slider_) userSet(randomValue());
}

void ParameterSlider::contextMenuEvent(QContextMenuEvent* event) {
    if (!slider_) return;
    openMenu(event->globalPos());
}

void ParameterSlider::openMenu(const QPoint& place) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    menu->popup(place);
}

void ParameterSlider::fillMenu(QMenu& menu) {
    menu.setToolTipsVisible(true);
    const auto add = [&](const QString& text, const QString& help, auto act) {
        QAction* action = menu.addAction(text, this, act);
        action->setToolTip(help);
        return action;
    };
    add(tr("Back to %1").arg(numberText(initial_)), tr("The value that the text had when it was opened"),
        [this] { resetToInitial(); })
        ->setEnabled(!isLocked() && value_ != initial_);
    add(tr("Random value"), tr("Any value of the slider"), [this] { randomise(); })->setEnabled(!isLocked());
    QAction* lock = add(tr("Locked"), tr("The slider does not move, nor does a preset or Randomise move it"),
                        [this] { setLocked(!isLocked()); });
    lock->setCheckable(true);
    lock->setChecked(isLocked());
    if (playOffered_ && canPlay()) {
        QMenu* play = menu.addMenu(tr("Play"));
        play->setToolTipsVisible(true);
        fillPlayMenu(*play);
    }
    if (playOffered_)
        add(tr("Set key at this frame"), tr("The timeline keeps the present value, in a comment of the text"),
            [this] { emit keyRequested(); })
            ->setEnabled(!parameter_.implied);
    menu.addSeparator();
    add(tr("Range, step and scale…"),
        tr("How the slider moves; kept in the text, in a comment behind the number"), [this] { editNote(); });
    add(tr("Usual range"), tr("Takes the comment about the slider out of the text"), [this] {
        changeNote(std::nullopt);
    })->setEnabled(hasNote());
}

void ParameterSlider::editNote() {
    if (!slider_) return;
    auto* popup = new SliderNotePopup(note(), fullName(), this);
    connect(popup, &SliderNotePopup::chosen, this, [this](const SliderNote& note) { changeNote(note); });
    popup->showBelow(slider_);
}

void ParameterSlider::editEnd(QLabel* end) {
    auto* field = new QLineEdit(end->text(), this);
    field->setAccessibleName(end->accessibleName());
    field->setToolTip(tr("Enter sets the end, Escape leaves it"));
    const int width = fontMetrics().horizontalAdvance("-00000.000") + 12;
    const QRect place = QRect(end->mapTo(this, QPoint()), end->size());
    const int left = std::clamp(end == maximum_ ? place.right() - width : place.left(), 0,
                                std::max(0, this->width() - width));
    const int height = field->sizeHint().height();
    field->setGeometry(left,
                       std::clamp(place.center().y() - height / 2, 0, std::max(0, this->height() - height)),
                       width, height);
    field->selectAll();
    field->show();
    field->setFocus();
    auto* leave = new QAction(field);
    leave->setShortcut(Qt::Key_Escape);
    leave->setShortcutContext(Qt::WidgetShortcut);
    field->addAction(leave);
    connect(leave, &QAction::triggered, field, [this, field] {
        field->disconnect(this);
        field->deleteLater();
        slider_->setFocus();
    });
    connect(field, &QLineEdit::editingFinished, this, [this, field, end] {
        field->disconnect(this);
        bool ok = false;
        const double value = QLocale::c().toDouble(field->text(), &ok);
        if (ok) moveEnd(end, value);
        field->deleteLater();
        if (field->hasFocus()) slider_->setFocus();
    });
}

void ParameterSlider::moveEnd(QLabel* end, double value) {
    if (end == minimum_)
        setRange(value, maximum());
    else
        setRange(minimum(), value);
}

}  // namespace isoscope
