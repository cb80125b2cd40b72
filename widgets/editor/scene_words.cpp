// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_words.h"

#include <QMap>

#include "core/function/builtins/builtin.h"
#include "core/language/tokens/keywords.h"
#include "core/virtualight/vocabulary.h"
#include "widgets/functions/function_snippet.h"

namespace isoscope {
namespace {

const char directiveWords[] =
    "#break #case #debug #declare #default #else #elseif #end #error #fclose #fopen #for #if #ifdef #ifndef "
    "#include #local #macro #range #read #render #statistics #switch #undef #version #warning #while #write";

/// Functions of the language itself; the numbered ones come from builtins().
const char* const languageFunctions[] = {"abs(A)",
                                         "acos(A)",
                                         "acosh(A)",
                                         "asc(S)",
                                         "asin(A)",
                                         "asinh(A)",
                                         "atan(A)",
                                         "atan2(A, B)",
                                         "atanh(A)",
                                         "ceil(A)",
                                         "chr(A)",
                                         "concat(S1, S2)",
                                         "cos(A)",
                                         "cosh(A)",
                                         "defined(NAME)",
                                         "degrees(A)",
                                         "dimensions(ARRAY)",
                                         "dimension_size(ARRAY, N)",
                                         "div(A, B)",
                                         "exp(A)",
                                         "floor(A)",
                                         "inside(OBJECT, V)",
                                         "int(A)",
                                         "ln(A)",
                                         "log(A)",
                                         "max(A, B)",
                                         "min(A, B)",
                                         "mod(A, B)",
                                         "pow(A, B)",
                                         "prod(I, A, B, F)",
                                         "radians(A)",
                                         "rand(S)",
                                         "seed(A)",
                                         "select(A, B, C)",
                                         "sin(A)",
                                         "sinh(A)",
                                         "sqr(A)",
                                         "sqrt(A)",
                                         "str(A, L, P)",
                                         "strcmp(S1, S2)",
                                         "strlen(S)",
                                         "strlwr(S)",
                                         "strupr(S)",
                                         "substr(S, P, L)",
                                         "sum(I, A, B, F)",
                                         "tan(A)",
                                         "tanh(A)",
                                         "trace(OBJECT, V, V)",
                                         "val(S)",
                                         "vaxis_rotate(V1, V2, A)",
                                         "vcross(V1, V2)",
                                         "vdot(V1, V2)",
                                         "vlength(V)",
                                         "vnormalize(V)",
                                         "vrotate(V, V)",
                                         "vstr(N, V, S, L, P)",
                                         "vturbulence(L, O, N, V)"};

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
        for (const std::string_view word : keywords()) kinds[bytes(word)] = WordKind::keyword;
        for (const QByteArray& word : QByteArray(directiveWords).split(' ')) {
            kinds[word] = WordKind::directive;
            // Reserved, but nothing without the hash.
            kinds.remove(word.mid(1));
        }
        for (const QString tip : languageFunctions) addFunction(tip.section('(', 0, 0), tip);
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
    static const Words povray(Notation::povray), virtualight(Notation::virtualight);
    return notation == Notation::virtualight ? virtualight : povray;
}

}  // namespace

WordKind wordKind(const QByteArray& word, Notation notation) {
    return words(notation).kinds.value(word, WordKind::unknown);
}

const QStringList& sceneWords(Notation notation) { return words(notation).sorted; }

QString callTip(const QString& word, Notation notation) { return words(notation).tips.value(word); }

}  // namespace isoscope
