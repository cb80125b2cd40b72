// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_text.h"

#include <cmath>
#include <QLocale>

namespace isoscope {
namespace {

/// "1e-06" as the shorter "1e-6".
QString shortExponent(QString text) {
    const qsizetype e = text.indexOf('e');
    if (e < 0) return text;
    return text.left(e) + 'e' + QString::number(text.mid(e + 1).toInt());
}

}  // namespace

double roundToResolution(double value, double resolution) {
    if (!std::isfinite(value) || !(resolution > 0) || !std::isfinite(resolution)) return value;
    // The small number keeps 0.001 from needing four decimals because its logarithm is not exact.
    const double decimals = std::ceil(-std::log10(resolution) - 1e-9);
    if (decimals > 300) return value;
    // By way of text: 0.35 is then the very double that reading "0.35" gives.
    if (decimals >= 0) return QString::number(value, 'f', static_cast<int>(decimals)).toDouble();
    const double unit = std::pow(10.0, -decimals);
    return std::round(value / unit) * unit;
}

QString numberText(double value, double resolution) {
    return numberText(roundToResolution(value, resolution));
}

QString numberText(double value) {
    if (!std::isfinite(value) || value == 0) return QStringLiteral("0");
    const QString plain = QString::number(value, 'f', QLocale::FloatingPointShortest);
    const QString exponent = shortExponent(QString::number(value, 'e', QLocale::FloatingPointShortest));
    // Zeros that must be counted to be read; thousands are still easy.
    const bool unusual = std::abs(value) < 1e-3 || std::abs(value) >= 1e7;
    constexpr int worthIt = 2;  // characters that an exponent must save
    return unusual && plain.size() > exponent.size() + worthIt ? exponent : plain;
}

QString numberTextWith(double value, int decimals) {
    if (decimals < 0 || !std::isfinite(value)) return numberText(value);
    const QString text = QString::number(value, 'f', decimals);
    return text.toDouble() == 0 && text.startsWith('-') ? text.mid(1) : text;
}

}  // namespace isoscope
