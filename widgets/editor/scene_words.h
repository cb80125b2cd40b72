// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QHash>
#include <QStringList>

#include "core/language/parse.h"

namespace isoscope {

/// What a word of the scene language, or of VirtuaLight's, is, for colours and completion. Not the parser's
/// judgement: words that the program leaves out belong to the language all the same.
enum class WordKind { directive, keyword, function, unknown };

/// "#declare" with its hash, "isosurface", "f_torus"; unknown for names of the user's.
WordKind wordKind(const QByteArray& word, Notation notation = Notation::povray);

/// All directives, keywords and functions, sorted.
const QStringList& sceneWords(Notation notation = Notation::povray);

/// How a function is called: "sin(A)", "f_torus(x, y, z, Major Radius, Minor Radius)"; empty for other words.
QString callTip(const QString& word, Notation notation = Notation::povray);

}  // namespace isoscope
