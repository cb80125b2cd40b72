// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_lexer.h"

#include <Qsci/qsciscintilla.h>

#include <algorithm>
#include <array>

#include "widgets/interface_style.h"

namespace isoscope {

SceneLexer::SceneLexer(QObject* parent) : QsciLexerCustom(parent) { applyTheme(Look::light); }

void SceneLexer::setNotation(Notation notation) {
    if (notation == notation_) return;
    notation_ = notation;
    // Colours it anew, lazily.
    if (editor()) editor()->SendScintilla(QsciScintillaBase::SCI_STARTSTYLING, 0UL, 0L);
    if (editor()) editor()->SendScintilla(QsciScintillaBase::SCI_COLOURISE, 0UL, -1L);
}

QColor SceneLexer::textColor(SceneStyle style, Look look) {
    struct Pair {
        QRgb light, dark;
    };
    static constexpr std::array<Pair, static_cast<std::size_t>(SceneStyle::count)> colors = {{
        {0xff202226, 0xffe2e4e8},  // plain
        {0xff5f6772, 0xff8f98a5},  // comment
        {0xff0b6e32, 0xff8fce8f},  // string
        {0xff9a3d0c, 0xfff0aa6c},  // number
        {0xff8427a5, 0xffd49cf0},  // directive
        {0xff1d4fc4, 0xff7db6ff},  // keyword
        {0xff0b677a, 0xff5fd0d6},  // function
        {0xff3c4148, 0xffc3c8cf},  // symbol
    }};
    const Pair& pair = colors[static_cast<std::size_t>(style)];
    if (look == Look::highContrast && style == SceneStyle::plain) return Qt::white;
    return lookColor(look, pair.light, pair.dark);
}

QColor SceneLexer::paperColor(Look look) {
    if (look == Look::highContrast) return Qt::black;
    return look == Look::dark ? QColor(0x1e, 0x20, 0x24) : QColor(Qt::white);
}

void SceneLexer::applyTheme(Look look) {
    QFont font = fixedFont();
    const QColor paper = paperColor(look);
    setDefaultFont(font);
    setDefaultColor(textColor(SceneStyle::plain, look));
    setDefaultPaper(paper);
    for (int style = 0; style < static_cast<int>(SceneStyle::count); ++style) {
        const SceneStyle kind = static_cast<SceneStyle>(style);
        font.setBold(kind == SceneStyle::keyword || kind == SceneStyle::directive);
        font.setItalic(kind == SceneStyle::comment);
        setColor(textColor(kind, look), style);
        setPaper(paper, style);
        setFont(font, style);
    }
}

QString SceneLexer::description(int style) const {
    switch (static_cast<SceneStyle>(style)) {
        case SceneStyle::plain: return tr("Text");
        case SceneStyle::comment: return tr("Comment");
        case SceneStyle::string: return tr("String");
        case SceneStyle::number: return tr("Number");
        case SceneStyle::directive: return tr("Directive");
        case SceneStyle::keyword: return tr("Keyword");
        case SceneStyle::function: return tr("Function");
        case SceneStyle::symbol: return tr("Symbol");
        case SceneStyle::count: break;
    }
    return {};
}

void SceneLexer::styleText(int start, int end) {
    if (!editor() || end <= start) return;
    // Scintilla may ask for half a line, which would cut a word in two.
    const long lastLine = editor()->SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, end - 1);
    const long length = editor()->SendScintilla(QsciScintillaBase::SCI_GETLENGTH);
    const long lineEnd = editor()->SendScintilla(QsciScintillaBase::SCI_POSITIONFROMLINE, lastLine + 1);
    end = static_cast<int>(lineEnd < 0 ? length : std::min(lineEnd, length));
    // Not text(start, end): pieces are counted in bytes.
    QByteArray bytes(end - start + 1, '\0');
    editor()->SendScintilla(QsciScintillaBase::SCI_GETTEXTRANGE, start, end, bytes.data());
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(end - start));

    int line = static_cast<int>(editor()->SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, start));
    const int depth =
        line > 0 ? static_cast<int>(editor()->SendScintilla(QsciScintillaBase::SCI_GETLINESTATE, line - 1))
                 : 0;
    SceneScanner scanner(text, depth, notation_);
    // In one go: each call has Scintilla look through all lines of the document.
    QByteArray styles;
    styles.reserve(end - start);
    while (!scanner.atEnd()) {
        const std::size_t at = scanner.position();
        const SceneScanner::Piece piece = scanner.next();
        styles.append(piece.length, static_cast<char>(piece.style));
        if (text[at] == '\n')
            editor()->SendScintilla(QsciScintillaBase::SCI_SETLINESTATE, static_cast<unsigned long>(line++),
                                    scanner.depth());
    }
    startStyling(start);
    editor()->SendScintilla(QsciScintillaBase::SCI_SETSTYLINGEX, static_cast<unsigned long>(styles.size()),
                            styles.constData());
}

const char* SceneLexer::wordCharacters() const {
    return "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_#";
}

const char* SceneLexer::blockStart(int* style) const {
    if (style) *style = static_cast<int>(SceneStyle::symbol);
    return "{";
}

const char* SceneLexer::blockEnd(int* style) const {
    if (style) *style = static_cast<int>(SceneStyle::symbol);
    return "}";
}

SceneStyle styleAt(QsciScintilla* editor, long position) {
    const long styled = editor->SendScintilla(QsciScintillaBase::SCI_GETENDSTYLED);
    if (styled <= position)
        editor->SendScintilla(QsciScintillaBase::SCI_COLOURISE, static_cast<unsigned long>(styled),
                              position + 1);
    return static_cast<SceneStyle>(editor->SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT, position));
}

}  // namespace isoscope
