// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/slider_note_popup.h"

#include <cmath>
#include <QCheckBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScreen>

#include "widgets/numbers/number_text.h"
#include "widgets/interface_language.h"

namespace isoscope {

SliderNotePopup::SliderNotePopup(const SliderNote& note, const QString& subject, QWidget* parent)
    : QFrame(parent, Qt::Popup), note_(note) {
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameStyle(QFrame::StyledPanel | QFrame::Raised);
    setAccessibleName(tr("Range, step and scale of %1").arg(subject));
    setToolTip(tr("Enter sets the values, Esc leaves them as they are"));
    auto* form = new QFormLayout(this);
    minimum_ = addField(form, tr("&From"), numberText(note.minimum), tr("Lower end of the slider"), subject);
    maximum_ = addField(form, tr("&To"), numberText(note.maximum), tr("Upper end of the slider"), subject);
    step_ = addField(form, tr("&Step"), note.step > 0 ? numberText(note.step) : QString(),
                     tr("How far apart values are; empty: as fine as the slider is"), subject);
    step_->setPlaceholderText(tr("fine"));
    decimals_ =
        addField(form, tr("&Decimals"), note.decimals >= 0 ? QString::number(note.decimals) : QString(),
                 tr("Digits behind the point that are written; empty: as many as needed"), subject);
    decimals_->setPlaceholderText(tr("as needed"));
    logarithmic_ = new QCheckBox(tr("&Logarithmic"), this);
    logarithmic_->setChecked(note.logarithmic);
    logarithmic_->setToolTip(tr("Equal ways multiply the number; the lower end must be above 0"));
    form->addRow(logarithmic_);
    problem_ = new QLabel(this);
    problem_->setWordWrap(true);
    problem_->hide();
    form->addRow(problem_);
    auto* set = new QPushButton(tr("Set"), this);
    set->setToolTip(tr("Writes the values into the text, in a comment behind the number"));
    set->setAutoDefault(false);
    connect(set, &QPushButton::clicked, this, &SliderNotePopup::choose);
    form->addRow(set);
}

QLineEdit* SliderNotePopup::addField(QFormLayout* form, const QString& label, const QString& text,
                                     const QString& help, const QString& subject) {
    auto* field = new QLineEdit(text, this);
    field->setToolTip(help);
    field->setAccessibleName(tr("%1 of %2").arg(withoutAccessKey(label), subject));
    field->setMinimumWidth(fontMetrics().horizontalAdvance("-00000.00000"));
    form->addRow(label, field);
    return field;
}

void SliderNotePopup::showBelow(const QWidget* widget) {
    adjustSize();
    const QRect room = widget->screen()->availableGeometry();
    const QPoint below = widget->mapToGlobal(QPoint(0, widget->height()));
    const QPoint above = widget->mapToGlobal(QPoint(0, -height()));
    const QPoint place = below.y() + height() > room.bottom() ? above : below;
    move(std::max(room.left(), std::min(place.x(), room.right() - width())), std::max(room.top(), place.y()));
    show();
    minimum_->setFocus(Qt::PopupFocusReason);
    minimum_->selectAll();
}

QString SliderNotePopup::read(SliderNote& note) const {
    const auto number = [](const QLineEdit* field, double& value) {
        bool ok = false;
        value = QLocale::c().toDouble(field->text().trimmed(), &ok);
        return ok && std::isfinite(value);
    };
    note.logarithmic = logarithmic_->isChecked();
    note.step = 0;
    note.decimals = -1;
    if (!number(minimum_, note.minimum) || !number(maximum_, note.maximum))
        return tr("From and To must be numbers.");
    if (note.minimum >= note.maximum) return tr("From must be less than To.");
    if (note.logarithmic && note.minimum <= 0) return tr("A logarithmic slider must begin above 0.");
    if (!step_->text().trimmed().isEmpty() &&
        !(number(step_, note.step) && note.step > 0 && note.step <= note.maximum - note.minimum))
        return tr("The step must be above 0 and fit between From and To.");
    bool whole = true;
    const QString decimals = decimals_->text().trimmed();
    if (!decimals.isEmpty()) note.decimals = decimals.toInt(&whole);
    if (!whole || (!decimals.isEmpty() && note.decimals < 0) || note.decimals > mostDecimals)
        return tr("Decimals must be a whole number from 0 to %1.").arg(mostDecimals);
    return {};
}

void SliderNotePopup::choose() {
    SliderNote note = note_;
    const QString problem = read(note);
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
    if (!problem.isEmpty()) {
        adjustSize();
        const int last = screen()->availableGeometry().bottom() - height();
        if (y() > last) move(x(), last);
        return;
    }
    emit chosen(note);
    close();
}

void SliderNotePopup::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape: close(); break;
        case Qt::Key_Return:
        case Qt::Key_Enter: choose(); break;
        default: QFrame::keyPressEvent(event);
    }
}

}  // namespace isoscope
