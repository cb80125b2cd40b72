// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_editor.h"

#include <Qsci/qscicommandset.h>

#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QSignalBlocker>
#include <QToolTip>

#include "widgets/editor/diagnostic_marks.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/editor_grounds.h"
#include "widgets/editor/editor_keys.h"
#include "widgets/editor/line_editing.h"
#include "widgets/editor/scene_completion.h"
#include "widgets/editor/scene_lexer.h"
#include "widgets/editor/scene_words.h"
#include "widgets/editor/text_search.h"
#include "widgets/interface_style.h"
#include "widgets/numbers/number_marks.h"
#include "widgets/numbers/number_scrubber.h"
#include "widgets/numbers/undo_group.h"

namespace isoscope {
namespace {

constexpr int lineNumberMargin = 0;
constexpr int indentColumns = 2;

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

}  // namespace

SceneEditor::SceneEditor(QWidget* parent) : QsciScintilla(parent) {
    setUtf8(true);
    setEolMode(EolUnix);
    lexer_ = std::make_unique<SceneLexer>();
    setLexer(lexer_.get());
    setUpMargins();
    setUpEditing();
    setUpCompletion();
    diagnosticMarks_ = std::make_unique<DiagnosticMarks>(this);
    verdictMarks_ = std::make_unique<VerdictMarks>(this);
    numberMarks_ = std::make_unique<NumberMarks>(this);
    undoGroup_ = std::make_unique<UndoGroup>(this);
    history_ = std::make_unique<EditHistory>(this);
    connect(history_.get(), &EditHistory::adding, undoGroup_.get(), &UndoGroup::settle);
    connect(history_.get(), &EditHistory::modifiedChanged, this, &SceneEditor::modifiedChanged);
    scrubber_ = std::make_unique<NumberScrubber>(this);
    connectSignals();
    applyTheme(Look::light);
    setAccessibleName(tr("Scene text"));
    setAccessibleDescription(tr(
        "The scene in POV-Ray's language. Ctrl with the up and down keys changes the number at the caret."));
    // Tool tips of the editor depend on the place; this one is for where there is nothing to say.
    setToolTip(tr("The scene's text. Drag a number with Ctrl to change it."));
}

SceneEditor::~SceneEditor() {
    // The lexer goes first otherwise, and the base class would still colour with it.
    setLexer(nullptr);
}

void SceneEditor::setUpMargins() {
    setMarginType(lineNumberMargin, NumberMargin);
    setMarginType(DiagnosticMarks::margin, SymbolMargin);
    setMarginWidth(DiagnosticMarks::margin, 16);
    setMarginMarkerMask(DiagnosticMarks::margin, 0xf | VerdictMarks::mask());
    setMarginWidth(2, 0);
    constexpr long gap = 4;  // between margin and text
    SendScintilla(SCI_SETMARGINLEFT, 0UL, gap);
}

void SceneEditor::setUpEditing() {
    setAutoIndent(false);  // see indentNewLine(): the built-in one needs the colours of text just typed
    setIndentationsUseTabs(false);
    setIndentationWidth(indentColumns);
    setTabWidth(indentColumns);
    setTabIndents(true);
    setBackspaceUnindents(true);
    setBraceMatching(SloppyBraceMatch);
    setCaretLineVisible(true);
    setCaretWidth(2);
    setScrollWidth(1);
    setScrollWidthTracking(true);
    setWrapMode(WrapNone);
    // Only what editorKeys() says: Scintilla cuts lines, swaps them and changes their case by keys that are
    // the window's.
    standardCommands()->clearKeys();
    standardCommands()->clearAlternateKeys();
    SendScintilla(SCI_CLEARALLCMDKEYS);
}

void SceneEditor::setUpCompletion() {
    completion_ = new SceneCompletion(lexer_.get());
    setAutoCompletionSource(AcsAPIs);
    setAutoCompletionThreshold(2);
    setAutoCompletionCaseSensitivity(true);
    setAutoCompletionReplaceWord(false);
    setCallTipsStyle(CallTipsNoContext);
    setCallTipsVisible(1);
}

void SceneEditor::connectSignals() {
    connect(this, &QsciScintillaBase::SCN_MODIFIED, this,
            [this](int position, int type, const char*, int length) { onModified(position, type, length); });
    connect(this, &QsciScintillaBase::SCN_CHARADDED, this, &SceneEditor::onCharacterAdded);
    connect(this, &QsciScintilla::cursorPositionChanged, this, &SceneEditor::onCaretMoved);
    // What is offered belongs to the word at the caret.
    connect(this, &QsciScintilla::selectionChanged, this, [this] {
        if (hasSelectedText() && isListActive()) cancelList();
    });
    connect(this, &QsciScintilla::linesChanged, this, &SceneEditor::updateLineNumberWidth);
    connect(this, &QsciScintillaBase::SCN_ZOOM, this, &SceneEditor::updateLineNumberWidth);
}

void SceneEditor::setWordWrap(bool on) {
    setWrapMode(on ? WrapWhitespace : WrapNone);
    // Rows that go on are seen to do so: they begin deeper than their line, and bear a mark.
    setWrapVisualFlags(WrapFlagByText);
    setWrapIndentMode(WrapIndentIndented);
}

bool SceneEditor::setSceneText(const QString& text, const EditJournal* past) {
    const QByteArray present = text.toUtf8();
    const auto first = past ? past->textAfter(0, present) : std::nullopt;
    const QByteArray bytes = first.value_or(present);
    undoGroup_->settle();
    rewriting_ = true;
    QSignalBlocker quiet(history_.get());  // the new text is no change of the old one
    setReadOnly(false);
    setDiagnostics({}, {});
    markNumbers({});
    SendScintilla(SCI_SETUNDOCOLLECTION, static_cast<unsigned long>(0));
    SendScintilla(SCI_CLEARALL);
    // Not setText(): it ends at the first NUL.
    SendScintilla(SCI_ADDTEXT, static_cast<unsigned long>(bytes.size()), bytes.constData());
    SendScintilla(SCI_SETUNDOCOLLECTION, static_cast<unsigned long>(1));
    SendScintilla(SCI_EMPTYUNDOBUFFER);
    SendScintilla(SCI_SETSAVEPOINT);
    history_->reset();
    if (first) history_->replay(*past);
    quiet.unblock();
    history_->tellLoaded();
    SendScintilla(SCI_GOTOPOS, static_cast<unsigned long>(0));
    rewriting_ = false;
    updateLineNumberWidth();
    emit textLoaded();
    return !past || first;
}

QString SceneEditor::sceneText() const {
    const std::string text = utf8();
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

std::string SceneEditor::utf8() const {
    const auto length = static_cast<std::size_t>(SendScintilla(SCI_GETLENGTH));
    const void* text = SendScintillaPtrResult(SCI_GETCHARACTERPOINTER);
    return std::string(static_cast<const char*>(text), length);
}

void SceneEditor::setDiagnostics(const Diagnostics& diagnostics, const SourceLibrary& sources) {
    diagnosticMarks_->set(diagnostics, sources);
}

void SceneEditor::setVerdicts(const std::vector<VerdictMarks::Mark>& marks) { verdictMarks_->set(marks); }

QString SceneEditor::verdictText(int line) const { return verdictMarks_->textOfLine(line); }

void SceneEditor::setNotation(Notation notation) { lexer_->setNotation(notation); }

Notation SceneEditor::notation() const { return lexer_->notation(); }

void SceneEditor::setNames(const QStringList& names) { completion_->setNames(names); }

void SceneEditor::markNumbers(const std::vector<SourceRange>& ranges) { numberMarks_->set(ranges); }

std::optional<SourceRange> SceneEditor::numberRange(int index) const { return numberMarks_->range(index); }

bool SceneEditor::replaceNumber(int index, const QString& text) {
    const auto range = numberRange(index);
    if (!range) return false;
    undoGroup_->change();
    return replaceRange(*range, text);
}

bool SceneEditor::insertNumber(int index, const QString& words, const QString& number) {
    const auto place = numberRange(index);
    if (!place || place->begin != place->end) return false;
    undoGroup_->change();
    if (!replaceRange(*place, words + number)) return false;
    const int begin = static_cast<int>(place->begin + words.toUtf8().size());
    numberMarks_->place(index, begin, begin + static_cast<int>(number.toUtf8().size()));
    return true;
}

bool SceneEditor::replaceRange(const SourceRange& range, const QString& text) {
    const std::string present = utf8();
    if (range.file != 0 || range.begin > range.end || range.end > present.size()) return false;
    const auto cutsCharacter = [&](std::uint32_t at) {
        return at < present.size() && isContinuation(present[at]);
    };
    if (cutsCharacter(range.begin) || cutsCharacter(range.end)) return false;
    rewrite(static_cast<int>(range.begin), static_cast<int>(range.end), text.toUtf8());
    return true;
}

void SceneEditor::rewrite(int begin, int end, const QByteArray& text) {
    QByteArray old(end - begin + 1, '\0');
    SendScintilla(SCI_GETTEXTRANGE, begin, end, old.data());
    old.chop(1);
    if (old == text) return;
    const int newEnd = begin + static_cast<int>(text.size());
    // Scintilla moves a caret inside the old text to its beginning; it should stay where it was as far as
    // there is text.
    const auto inside = [begin, end](long at) { return at > begin && at <= end; };
    const long anchor = SendScintilla(SCI_GETANCHOR), caret = SendScintilla(SCI_GETCURRENTPOS);
    rewriting_ = true;
    SendScintilla(SCI_SETTARGETRANGE, static_cast<unsigned long>(begin), end);
    SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(text.size()), text.constData());
    rewriting_ = false;
    numberMarks_->rewritten(begin, end, newEnd);
    const auto kept = [&](long at) { return at == end ? newEnd : std::min<long>(at, newEnd); };
    if (inside(anchor)) SendScintilla(SCI_SETSELECTIONNANCHOR, 0UL, kept(anchor));
    if (inside(caret)) SendScintilla(SCI_SETSELECTIONNCARET, 0UL, kept(caret));
    emit numberReplaced();
}

void SceneEditor::beginDrag() { undoGroup_->beginDrag(); }
void SceneEditor::endDrag() { undoGroup_->endDrag(); }
bool SceneEditor::isDragging() const { return undoGroup_->isDragging(); }

void SceneEditor::undo() {
    travel([this] {
        do {
            QsciScintilla::undo();
        } while (history_->undoGoesOn());
    });
}

void SceneEditor::redo() {
    travel([this] {
        do {
            QsciScintilla::redo();
        } while (history_->redoGoesOn());
    });
}

void SceneEditor::travel(const std::function<void()>& act) {
    if (undoGroup_->isDragging()) return;
    undoGroup_->settle();
    const quint64 before = revision_;
    const long line = SendScintilla(SCI_GETFIRSTVISIBLELINE), column = SendScintilla(SCI_GETXOFFSET);
    act();
    if (revision_ == before) {
        SendScintilla(SCI_SETFIRSTVISIBLELINE, line);
        SendScintilla(SCI_SETXOFFSET, column);
    }
    history_->tellMoved();
}

bool SceneEditor::isModified() const { return history_->isModified(); }

void SceneEditor::replaceText(const std::vector<SearchMatch>& matches) {
    undoGroup_->settle();
    SendScintilla(SCI_BEGINUNDOACTION);
    // From the end, so that the positions before stay right.
    for (auto match = matches.rbegin(); match != matches.rend(); ++match) {
        const QByteArray text = match->replacement.toUtf8();
        SendScintilla(SCI_SETTARGETRANGE, static_cast<unsigned long>(match->begin), match->end);
        SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(text.size()), text.constData());
    }
    SendScintilla(SCI_ENDUNDOACTION);
}

void SceneEditor::jumpTo(const SourceRange& range) {
    if (range.file != 0) return;
    const long length = SendScintilla(SCI_GETLENGTH);
    const long begin = std::min<long>(range.begin, length), end = std::clamp<long>(range.end, begin, length);
    const long line = SendScintilla(SCI_LINEFROMPOSITION, begin);
    const long top = SendScintilla(SCI_GETFIRSTVISIBLELINE), shown = SendScintilla(SCI_LINESONSCREEN);
    if (line < top || line >= top + shown)
        SendScintilla(SCI_SETFIRSTVISIBLELINE, std::max(0L, line - shown / 3));
    // The caret at the beginning: a long range must not scroll to its end.
    SendScintilla(SCI_SETSEL, static_cast<unsigned long>(end), begin);
    setFocus(Qt::OtherFocusReason);
}

void SceneEditor::toggleComment() {
    undoGroup_->settle();
    isoscope::toggleComment(this);
}

void SceneEditor::setModified(bool modified) {
    // A save in the middle of a group would make the group's end a part of the saved step.
    undoGroup_->settle();
    QsciScintilla::setModified(modified);
    history_->setModified(modified);
}

QString SceneEditor::wordAtCaret() const {
    const long caret = SendScintilla(SCI_GETCURRENTPOS);
    const long begin = SendScintilla(SCI_WORDSTARTPOSITION, static_cast<unsigned long>(caret), true);
    const long end = SendScintilla(SCI_WORDENDPOSITION, static_cast<unsigned long>(caret), true);
    return begin < end ? text(static_cast<int>(begin), static_cast<int>(end)) : QString();
}

QString SceneEditor::lineBeforeCaret() const {
    const long caret = SendScintilla(SCI_GETCURRENTPOS);
    const long begin = SendScintilla(SCI_POSITIONFROMLINE, SendScintilla(SCI_LINEFROMPOSITION, caret));
    return begin < caret ? text(static_cast<int>(begin), static_cast<int>(caret)) : QString();
}

void SceneEditor::resetZoom() { zoomTo(0); }

void SceneEditor::applyTheme(Look look) {
    look_ = look;
    lexer_->applyTheme(look);
    diagnosticMarks_->applyTheme(look);
    verdictMarks_->applyTheme(look);
    numberMarks_->applyTheme(look);
    const EditorGrounds& grounds = editorGrounds(look);
    const QColor text = SceneLexer::textColor(SceneStyle::plain, look);
    const QColor soft = SceneLexer::textColor(SceneStyle::comment, look);
    setPaper(SceneLexer::paperColor(look));
    setColor(text);
    setCaretForegroundColor(text);
    setCaretLineBackgroundColor(grounds.caretLine);
    setSelectionBackgroundColor(grounds.selection);
    // The colours of words are for black, not for what is selected.
    look == Look::highContrast ? setSelectionForegroundColor(text) : resetSelectionForegroundColor();
    setMarginsBackgroundColor(grounds.margin);
    setMarginsForegroundColor(soft);
    setWhitespaceForegroundColor(soft);  // the mark of rows that go on, too
    setMarginsFont(fixedFont());
    setMatchedBraceBackgroundColor(grounds.brace);
    setMatchedBraceForegroundColor(text);
    setUnmatchedBraceBackgroundColor(grounds.loneBrace);
    setUnmatchedBraceForegroundColor(text);
    setCallTipsBackgroundColor(grounds.callTip);
    setCallTipsForegroundColor(text);
    setCallTipsHighlightColor(SceneLexer::textColor(SceneStyle::keyword, look));
    updateLineNumberWidth();
}

void SceneEditor::onModified(int position, int type, int length) {
    constexpr int textChange = SC_MOD_INSERTTEXT | SC_MOD_DELETETEXT;
    if ((type & textChange) == 0) return;
    ++revision_;
    if (rewriting_) return;
    if (type & SC_MOD_INSERTTEXT) numberMarks_->inserted(position, length);
    if (type & SC_MOD_DELETETEXT) {
        numberMarks_->removed(position, length);
        // Scintilla ends a call tip by keys alone, not where its call is undone, cut or replaced.
        if (isCallTipActive() && position < SendScintilla(SCI_CALLTIPPOSSTART))
            SendScintilla(SCI_CALLTIPCANCEL);
    }
    emit textEdited();
}

void SceneEditor::onCharacterAdded(int character) {
    if (character == '\n') indentNewLine(this);
    if (character == '}') alignClosingBrace(this);
    listWalked_ = false;
    // While a call tip is up Scintilla starts no completion by itself.
    if (!isCallTipActive() || isListActive()) return;
    const bool wordCharacter =
        character < 0x80 && (std::isalnum(character) || character == '_' || character == '#');
    if (!wordCharacter) return;
    const long caret = SendScintilla(SCI_GETCURRENTPOS);
    if (caret - SendScintilla(SCI_WORDSTARTPOSITION, static_cast<unsigned long>(caret), 1L) >=
        autoCompletionThreshold())
        autoCompleteFromAPIs();
}

void SceneEditor::onCaretMoved() {
    const long caret = SendScintilla(SCI_GETCURRENTPOS);
    const long line = SendScintilla(SCI_LINEFROMPOSITION, caret);
    const long start = SendScintilla(SCI_POSITIONFROMLINE, line);
    emit caretMoved(
        static_cast<int>(line) + 1,
        static_cast<int>(SendScintilla(SCI_COUNTCHARACTERS, static_cast<unsigned long>(start), caret)) + 1);
}

void SceneEditor::updateLineNumberWidth() {
    const int digits = std::max(3, static_cast<int>(QString::number(lines()).size()));
    setMarginWidth(lineNumberMargin, QString(digits + 1, '9'));
}

bool SceneEditor::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && editorCommand(*static_cast<QKeyEvent*>(event)).key) {
        event->accept();
        return true;
    }
    return QsciScintilla::event(event);
}

bool SceneEditor::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (!showToolTip(help->pos())) QToolTip::hideText();
        return true;
    }
    if (scrubber_ && scrubber_->handle(event)) return true;
    return QsciScintilla::viewportEvent(event);
}

bool SceneEditor::showToolTip(const QPoint& position) {
    const int marginEnd = marginWidth(lineNumberMargin) + marginWidth(DiagnosticMarks::margin);
    const long near =
        SendScintilla(SCI_POSITIONFROMPOINT, static_cast<unsigned long>(position.x()), position.y());
    QString text;
    if (position.x() < marginEnd) {
        const int line = static_cast<int>(SendScintilla(SCI_LINEFROMPOSITION, near));
        text = diagnosticMarks_->textOfLine(line) + verdictMarks_->textOfLine(line);
    } else {
        const long at =
            SendScintilla(SCI_POSITIONFROMPOINTCLOSE, static_cast<unsigned long>(position.x()), position.y());
        if (at < 0) return false;
        text = diagnosticMarks_->textAt(at);
        const SceneStyle style = styleAt(this, at);
        if (text.isEmpty() && style == SceneStyle::function)
            text = isoscope::callTip(wordAtPoint(position), lexer_->notation()).toHtmlEscaped();
        if (text.isEmpty() && style == SceneStyle::number)
            text = tr("Drag with Ctrl changes the number, a click with Ctrl opens a slider for it");
    }
    if (text.isEmpty()) return false;
    QToolTip::showText(viewport()->mapToGlobal(position), text, viewport());
    return true;
}

void SceneEditor::noteCompletionKey(const QKeyEvent* event) {
    if (!isListActive()) return;
    const int key = event->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown)
        listWalked_ = true;
    // Who types a word and Enter wants a new line, not the list's first idea.
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !listWalked_) cancelList();
}

void SceneEditor::keyPressEvent(QKeyEvent* event) {
    if (scrubber_->isDragging() && event->key() == Qt::Key_Escape) return scrubber_->cancel();
    const EditorCommand command = editorCommand(*event);
    // A run of number steps goes on, also while Ctrl is pressed for the next one.
    const bool modifier = event->key() >= Qt::Key_Shift && event->key() <= Qt::Key_Alt;
    if (!modifier && (!command.key || command.key->numberStep == 0)) undoGroup_->settle();
    noteCompletionKey(event);
    if (command.key) {
        event->accept();
        if (command.message != 0)
            SendScintilla(static_cast<unsigned int>(command.message));
        else
            scrubber_->stepAtCaret(command.key->numberStep);
    } else if (typesText(*event)) {
        QsciScintilla::keyPressEvent(event);
    } else {
        event->ignore();
    }
}

void SceneEditor::focusOutEvent(QFocusEvent* event) {
    QsciScintilla::focusOutEvent(event);
    emit focusLost();
}

void SceneEditor::inputMethodEvent(QInputMethodEvent* event) {
    undoGroup_->settle();
    QsciScintilla::inputMethodEvent(event);
}

void SceneEditor::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QsciScintilla::wheelEvent(event);
    if (event->angleDelta().y() > 0) zoomIn();
    if (event->angleDelta().y() < 0) zoomOut();
    event->accept();
}

void SceneEditor::changeEvent(QEvent* event) {
    QsciScintilla::changeEvent(event);
    // The lexer is gone while the base class is built.
    const bool letters = event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
    if (lexer_ && letters) applyTheme(look_);
}

bool SceneEditor::canInsertFromMimeData(const QMimeData* source) const {
    return !source->hasUrls() && QsciScintilla::canInsertFromMimeData(source);
}

}  // namespace isoscope
