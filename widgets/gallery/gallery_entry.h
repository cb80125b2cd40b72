// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/function/builtins/builtin.h"

namespace isoscope {

/// One scene of the gallery.
struct GalleryEntry {
    /// Where it comes from.
    enum class Kind { function, pattern, example, povray, own, lesson };

    Kind kind = Kind::example;
    QString title;
    QString sentence;                  ///< what it shows, in a line
    QString text;                      ///< the whole scene
    const Builtin* builtin = nullptr;  ///< of functions and patterns
    QString file;                      ///< of the person's own collection
    bool asPovray = false;             ///< it is about what POV-Ray loses
    bool composed = false;             ///< it has a view of its own; else it is fitted into the picture
};

}  // namespace isoscope
