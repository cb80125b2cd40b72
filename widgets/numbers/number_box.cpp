// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <QBoxLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QWheelEvent>

#include "widgets/numbers/number_text.h"

namespace isoscope {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    // Any number; not from the least to the largest, which the base class would write out and read again.
    setRange(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    // The base class rounds to this many places; the text decides how many there are.
    setDecimals(323);
    setAccelerated(true);
}

NumberBox* NumberBox::addTo(QBoxLayout* row, const QString& label, const QString& name,
                            const QString& widest) {
    auto* words = new QLabel(label);
    auto* box = new NumberBox;
    box->setAccessibleName(name);
    box->setToolTip(name);
    box->setMaximumWidth(words->fontMetrics().horizontalAdvance(widest));
    words->setBuddy(box);
    row->addWidget(words);
    row->addWidget(box);
    return box;
}

QString NumberBox::textFromValue(double value) const {
    constexpr double largest = std::numeric_limits<double>::max();
    return numberTextWith(std::clamp(value, -largest, largest), places_);
}

double NumberBox::valueFromText(const QString& text) const {
    bool ok = false;
    const double value = QLocale::c().toDouble(text.trimmed(), &ok);
    return ok && std::isfinite(value) ? value : this->value();
}

QValidator::State NumberBox::validate(QString& text, int&) const {
    static const QRegularExpression whole(R"(^\s*[-+]?\d+\s*$)");
    static const QRegularExpression number(R"(^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\s*$)");
    static const QRegularExpression begun(R"(^\s*[-+]?\d*\.?\d*([eE][-+]?\d*)?\s*$)");
    if ((integral_ ? whole : number).match(text).hasMatch()) {
        const double value = QLocale::c().toDouble(text.trimmed());
        const bool within = std::isfinite(value) && value >= minimum() && value <= maximum();
        return within ? QValidator::Acceptable : QValidator::Intermediate;
    }
    return begun.match(text).hasMatch() && !(integral_ && text.contains('.')) ? QValidator::Intermediate
                                                                              : QValidator::Invalid;
}

void NumberBox::stepBy(int steps) {
    const double step = integral_ ? 1 : resolution_;
    setValue(roundToResolution(value() + steps * step, step));
    selectAll();
}

void NumberBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus()) return QDoubleSpinBox::wheelEvent(event);
    event->ignore();
}

}  // namespace isoscope
