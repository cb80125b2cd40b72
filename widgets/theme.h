// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QString>

#include "widgets/look.h"

namespace isoscope {

/// The choice of colours; system follows the desktop.
enum class Theme { system, light, dark, highContrast };

/// Gives the whole program InterfaceStyle, the palette and the icons of a theme; may be called again at any
/// time. Widgets with colours of their own follow QEvent::PaletteChange.
void applyTheme(Theme theme);

/// What `theme` looks like; `system` asks what the desktop's own palette was when the program started.
Look lookOf(Theme theme);

/// The palette of a look, disabled colours included; changes nothing.
QPalette themePalette(Look look);

/// Names for the settings file: "system", "light", "dark", "high-contrast". Anything else reads as system.
QString themeName(Theme theme);
Theme themeFromName(const QString& name);

}  // namespace isoscope
