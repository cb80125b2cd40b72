// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_box.h"

#include <cmath>
#include <limits>
#include <QRegularExpression>
#include <QWheelEvent>

#include "widgets/numbers/number_text.h"

namespace isoscope {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    // The base class rounds to this many places; the text decides how many there are.
    setDecimals(323);
    setRange(-std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
    setAccelerated(true);
}

QString NumberBox::textFromValue(double value) const { return numberTextWith(value, places_); }

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
        return value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
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
