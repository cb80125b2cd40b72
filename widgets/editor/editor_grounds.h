// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "widgets/look.h"

namespace isoscope {

/// What lies behind parts of a text, beside its paper.
struct EditorGrounds {
    QColor caretLine, selection, margin;
    QColor brace;      ///< of a pair
    QColor loneBrace;  ///< without the other one
    QColor callTip;
};

/// Those of a look; on each of them the letters that it bears are legible.
const EditorGrounds& editorGrounds(Look look);

}  // namespace isoscope
