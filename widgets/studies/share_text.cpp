// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/share_text.h"

#include <algorithm>

namespace isoscope {

QString formatShare(std::uint64_t part, std::uint64_t whole) {
    if (whole == 0) return {};
    part = std::min(part, whole);
    if (part == 0) return QStringLiteral("0 %");
    if (part == whole) return QStringLiteral("100 %");
    const double percent = 100 * (static_cast<double>(part) / static_cast<double>(whole));
    // What is left is computed by itself: beside 100 it would drown in rounding.
    const double rest = 100 * (static_cast<double>(whole - part) / static_cast<double>(whole));
    const double smaller = std::min(percent, rest);
    int decimals = 1;
    for (double unit = 0.1; smaller < unit / 2; unit /= 10) ++decimals;
    QString text = QString::number(percent, 'f', decimals);
    // Half a unit is rounded away from the middle.
    if (text.toDouble() == 0 || text.toDouble() == 100) text = QString::number(percent, 'f', decimals + 1);
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith('.')) text.chop(1);
    return text + QStringLiteral(" %");
}

QString formatCount(std::uint64_t count) {
    constexpr QChar narrowSpace(0x202f);
    QString text = QString::number(count);
    for (qsizetype at = text.size() - 3; at > 0; at -= 3) text.insert(at, narrowSpace);
    return text;
}

}  // namespace isoscope
