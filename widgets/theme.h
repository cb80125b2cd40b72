// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QString>

namespace isoscope {

/// The choice of colours; system follows the desktop.
enum class Theme { system, light, dark };

/// Gives the whole program the Fusion style, the palette and the icons of a theme; may be called again at any
/// time. Widgets with colours of their own follow QEvent::PaletteChange.
void applyTheme(Theme theme);

/// Whether `theme` is dark; `system` asks what the desktop's own palette was when the program started.
bool isDark(Theme theme);

/// The palette of a theme, disabled colours included; changes nothing.
QPalette themePalette(bool dark);

/// Names for the settings file: "system", "light", "dark". Anything else reads as system.
QString themeName(Theme theme);
Theme themeFromName(const QString& name);

}  // namespace isoscope
