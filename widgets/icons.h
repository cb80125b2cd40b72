// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace isoscope {

/// Makes QIcon::fromTheme find Breeze (light or dark) on every platform plug-in, `offscreen` included. Icons
/// that were handed out before follow at once. Call it before the first icon and on every change of theme.
void useIconTheme(bool dark);

/// The icon of the theme ("document-open"), else the style's own for that name; null where neither has one,
/// for which buttons show their text. One drawing serves all sizes: themes have another one, in colours,
/// where a scaled interface asks for more pixels.
QIcon themeIcon(const QString& name);

}  // namespace isoscope
