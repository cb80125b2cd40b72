// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_words.h"

#include <QMap>

#include "core/function/builtins/builtin.h"
#include "core/language/tokens/words.h"
#include "core/virtualight/vocabulary.h"
#include "widgets/functions/function_snippet.h"

namespace isoscope {
namespace {

struct Words {
    QHash<QByteArray, WordKind> kinds;
    QMap<QString, QString> tips;
    QStringList sorted;

    explicit Words(Notation notation) {
        if (notation == Notation::virtualight)
            addVirtualight();
        else
            addPovray();
        for (auto it = kinds.cbegin(); it != kinds.cend(); ++it) sorted << QString::fromLatin1(it.key());
        sorted.sort();
    }

    void addVirtualight() {
        using Kind = virtualight::VocabularyWord::Kind;
        for (const virtualight::VocabularyWord& word : virtualight::vocabulary()) {
            const bool statement = word.kind == Kind::statement;
            kinds[bytes(word.word)] = statement                     ? WordKind::directive
                                      : word.kind == Kind::function ? WordKind::function
                                                                    : WordKind::keyword;
            if (!word.call.empty())
                tips[QString::fromLatin1(bytes(word.word))] = QString::fromLatin1(bytes(word.call));
        }
    }

    void addPovray() {
        for (const Word& word : isoscope::words()) {
            const QByteArray text = bytes(word.text);
            if (word.is(WordUse::directive)) kinds['#' + text] = WordKind::directive;
            if (word.editorClass() == EditorClass::keyword) kinds[text] = WordKind::keyword;
            if (word.editorClass() == EditorClass::function)
                addFunction(QString::fromLatin1(text), QString::fromLatin1(bytes(word.call)));
        }
        for (const Builtin& builtin : builtins())
            if (!builtin.name.empty()) addFunction(QString::fromStdString(builtin.name), signature(builtin));
    }

    static QByteArray bytes(std::string_view word) {
        return {word.data(), static_cast<qsizetype>(word.size())};
    }

    void addFunction(const QString& name, const QString& tip) {
        kinds[name.toLatin1()] = WordKind::function;
        tips[name] = tip;
    }
};

const Words& words(Notation notation) {
    if (notation == Notation::virtualight) {
        static const Words virtualight(notation);
        return virtualight;
    }
    static const Words povray(notation);
    return povray;
}

}  // namespace

WordKind wordKind(const QByteArray& word, Notation notation) {
    return words(notation).kinds.value(word, WordKind::unknown);
}

const QStringList& sceneWords(Notation notation) { return words(notation).sorted; }

QString callTip(const QString& word, Notation notation) { return words(notation).tips.value(word); }

}  // namespace isoscope
