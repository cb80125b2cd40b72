// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qsci/qscilexercustom.h>

#include "widgets/editor/scene_scanner.h"
#include "widgets/look.h"

namespace isoscope {

/// Colours the scene language in a QScintilla editor; SceneStyle holds the style numbers.
class SceneLexer : public QsciLexerCustom {
    Q_OBJECT
  public:
    explicit SceneLexer(QObject* parent = nullptr);

    /// Which words are coloured as known.
    void setNotation(Notation notation);
    Notation notation() const { return notation_; }

    /// Colours, papers and fonts of all styles; every pair has a contrast of at least 4.5.
    void applyTheme(Look look);
    static QColor textColor(SceneStyle style, Look look);
    static QColor paperColor(Look look);

    const char* language() const override { return "POV-Ray"; }
    QString description(int style) const override;
    void styleText(int start, int end) override;
    /// Also #, so that directives complete as words.
    const char* wordCharacters() const override;
    const char* blockStart(int* style = nullptr) const override;
    const char* blockEnd(int* style = nullptr) const override;
    int braceStyle() const override { return static_cast<int>(SceneStyle::symbol); }

  private:
    Notation notation_ = Notation::povray;
};

/// The style of the byte at `position`, of an editor with a SceneLexer; colours the text up to there first.
SceneStyle styleAt(QsciScintilla* editor, long position);

}  // namespace isoscope
