// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_completion.h"

#include <algorithm>
#include <array>

#include <QGuiApplication>
#include <QScreen>

#include "widgets/editor/scene_lexer.h"
#include "widgets/editor/scene_words.h"

namespace isoscope {

SceneCompletion::SceneCompletion(SceneLexer* lexer) : QsciAbstractAPIs(lexer) {}

void SceneCompletion::updateAutoCompletionList(const QStringList& context, QStringList& list) {
    const QString prefix = context.isEmpty() ? QString() : context.last();
    if (prefix.isEmpty() || inProse() || !wordOnScreen(prefix)) return;
    for (const QStringList& words : {sceneWords(notation()), names_})
        for (const QString& word : words)
            if (word.startsWith(prefix)) list << word;
    list.removeDuplicates();
    // The word as it stands is no suggestion.
    if (list.size() == 1 && list.first() == prefix) list.clear();
}

QStringList SceneCompletion::callTips(const QStringList& context, int, QsciScintilla::CallTipsStyle,
                                      QList<int>& shifts) {
    QString name;
    for (const QString& word : context)
        if (!word.isEmpty()) name = word;
    const QString tip = callTip(name, notation());
    if (tip.isEmpty() || inProse()) return {};
    shifts << 0;
    return {tip};
}

Notation SceneCompletion::notation() const {
    const auto* scene = qobject_cast<const SceneLexer*>(lexer());
    return scene ? scene->notation() : Notation::povray;
}

bool SceneCompletion::wordOnScreen(const QString& prefix) const {
    QsciScintilla* editor = lexer()->editor();
    if (!editor) return false;
    const long caret = editor->SendScintilla(QsciScintillaBase::SCI_GETCURRENTPOS);
    const long start = std::max(0L, caret - static_cast<long>(prefix.toUtf8().size()));
    const std::array ends{start, caret};
    return std::all_of(ends.begin(), ends.end(), [editor](long position) {
        const QPoint place(
            static_cast<int>(editor->SendScintilla(QsciScintillaBase::SCI_POINTXFROMPOSITION, 0UL, position)),
            static_cast<int>(
                editor->SendScintilla(QsciScintillaBase::SCI_POINTYFROMPOSITION, 0UL, position)));
        return QGuiApplication::screenAt(editor->viewport()->mapToGlobal(place)) &&
               QGuiApplication::screenAt(editor->mapToGlobal(place));
    });
}

bool SceneCompletion::inProse() const {
    QsciScintilla* editor = lexer()->editor();
    if (!editor) return false;
    const long caret = editor->SendScintilla(QsciScintillaBase::SCI_GETCURRENTPOS);
    if (caret == 0) return false;
    const SceneStyle style = styleAt(editor, caret - 1);
    return style == SceneStyle::comment || style == SceneStyle::string;
}

}  // namespace isoscope
