// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/editor_grounds.h"

namespace isoscope {

const EditorGrounds& editorGrounds(Look look) {
    static const EditorGrounds light{QColor(QRgb(0xf2f5fa)), QColor(QRgb(0xbfd7fb)), QColor(QRgb(0xf2f3f5)),
                                     QColor(QRgb(0xd5e3f7)), QColor(QRgb(0xfbd9d9)), QColor(QRgb(0xffffff))};
    static const EditorGrounds dark{QColor(QRgb(0x282c33)), QColor(QRgb(0x2f4f80)), QColor(QRgb(0x25282d)),
                                    QColor(QRgb(0x3d4a5e)), QColor(QRgb(0x5a2a2e)), QColor(QRgb(0x353940))};
    // The brace of a pair and the lone one bear white.
    static const EditorGrounds highContrast{QColor(QRgb(0x1a1a1a)), QColor(QRgb(0x1030ff)),
                                            QColor(QRgb(0x000000)), QColor(QRgb(0x1030ff)),
                                            QColor(QRgb(0xa00000)), QColor(QRgb(0x000000))};
    switch (look) {
        case Look::dark: return dark;
        case Look::highContrast: return highContrast;
        default: return light;
    }
}

}  // namespace isoscope
