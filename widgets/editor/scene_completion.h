// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qsci/qsciabstractapis.h>

#include <QStringList>

#include "core/language/parse.h"

namespace isoscope {

class SceneLexer;

/// What the editor offers while typing: keywords, functions and the names that the text declares; the
/// parameters of a function in a call tip. Live, without a prepared database.
class SceneCompletion : public QsciAbstractAPIs {
    Q_OBJECT
  public:
    /// Owned by the lexer.
    explicit SceneCompletion(SceneLexer* lexer);

    /// The names that the text declares; they replace those of the parse before.
    void setNames(const QStringList& names) { names_ = names; }

    void updateAutoCompletionList(const QStringList& context, QStringList& list) override;
    QStringList callTips(const QStringList& context, int commas, QsciScintilla::CallTipsStyle style,
                         QList<int>& shifts) override;

  private:
    bool inProse() const;
    Notation notation() const;
    /// Whether both ends of the word at the caret lie on a screen. QScintilla asks the screen under the
    /// word's start for its size and crashes where there is none: in a window pulled partly off the screen,
    /// or at its left edge when the text is scrolled sideways.
    bool wordOnScreen(const QString& prefix) const;

    QStringList names_;
};

}  // namespace isoscope
