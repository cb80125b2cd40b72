// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QPalette;

namespace isoscope {

/// For which ground drawings choose colours of their own. In high contrast every text and every line that
/// tells something has at least `highContrastRatio` to its ground, which is black.
enum class Look { light, dark, highContrast };

/// The ratio that WCAG 2.1 asks of text at its strictest level (success criterion 1.4.6).
constexpr double highContrastRatio = 7;

/// The look of a widget with this palette.
Look lookOf(const QPalette& palette);

/// The colour of a drawing: `light` on a light ground, `dark` on a dark one, and in high contrast `dark` made
/// lighter until it is legible there. Alpha is 255.
QColor lookColor(Look look, QRgb light, QRgb dark);

/// The contrast ratio of two opaque colours as WCAG 2.1 defines it, from 1 to 21.
double contrastRatio(const QColor& a, const QColor& b);

/// `color` mixed with white or black, whichever differs more from `ground`, no more than it needs to have
/// `ratio` to `ground`; white or black itself where nothing in between has it.
QColor legible(const QColor& color, const QColor& ground, double ratio);

}  // namespace isoscope
