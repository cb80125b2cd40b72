// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <Qt>

class QPainter;
class QRect;

namespace isoscope {

/// Writes a text over a picture, wrapped and on a dark ground of its own, for the picture has any colour. It
/// stands in `area`, a little away from its edges, where `alignment` says.
void paintMessage(QPainter& painter, const QRect& area, Qt::Alignment alignment, const QString& text);

}  // namespace isoscope
