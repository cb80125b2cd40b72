// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qsci/qsciscintilla.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/language/parse.h"
#include "core/text/diagnostic.h"
#include "core/text/source_text.h"
#include "widgets/look.h"
#include "widgets/verdicts/verdict_marks.h"

namespace isoscope {

class DiagnosticMarks;
class EditHistory;
class EditJournal;
class NumberMarks;
class NumberScrubber;
class SceneCompletion;
class SceneLexer;
struct SearchMatch;
class UndoGroup;

/// The editor of the scene text. Positions are byte offsets into the UTF-8 text, the same as in SourceRange;
/// nothing here uses QScintilla's line indexes. Ranges handed in belong to file 0 and to the text at hand: a
/// result of an older text is to be dropped by comparing revision(). Keys: editorKeys(), and text; undo,
/// clipboard and all else are commands of the window.
class SceneEditor : public QsciScintilla {
    Q_OBJECT
  public:
    explicit SceneEditor(QWidget* parent = nullptr);
    ~SceneEditor() override;

    /// A new document: history empty, unmodified, caret at the start. Any text survives, NUL characters too.
    /// Emits textLoaded(). With a journal, whose present text this is, the history is that one instead, and
    /// the text modified or not as there; one that does not lead to the text is left out, and false returned.
    bool setSceneText(const QString& text, const EditJournal* past = nullptr);
    QString sceneText() const;
    /// The text as the parser wants it.
    std::string utf8() const;
    /// Grows with every change of the text, whoever makes it.
    quint64 revision() const { return revision_; }

    /// Squiggles, gutter markers and tooltips for the diagnostics of file 0; replaces the earlier ones.
    void setDiagnostics(const Diagnostics& diagnostics, const SourceLibrary& sources);
    /// Signs in the margin beside the lines of isosurfaces, with tooltips; replaces the earlier ones.
    void setVerdicts(const std::vector<VerdictMarks::Mark>& marks);
    /// What the sign beside a line, from 0, says; empty without one.
    QString verdictText(int line) const;
    /// Whether lines that are too long go on in the next row.
    void setWordWrap(bool on);
    /// Whose words are coloured and offered.
    void setNotation(Notation notation);
    Notation notation() const;
    /// Declared names, offered by the completion besides keywords and built-ins.
    void setNames(const QStringList& names);

    /// Marks the numbers that sliders are bound to. They are followed through later edits until the next
    /// call.
    void markNumbers(const std::vector<SourceRange>& ranges);
    /// Where marked number `index` is now; empty once an edit has touched it or for a bad index.
    std::optional<SourceRange> numberRange(int index) const;
    /// Rewrites marked number `index`, caret, selection and scroll kept. Within beginDrag()/endDrag(), or
    /// within 400 ms of the last call, it belongs to the same undo step. False when the number is no longer
    /// there.
    bool replaceNumber(int index, const QString& text);
    /// The same for a number whose marked place is empty: writes `words` and the number there, and marks the
    /// number. False when the place is gone, or not empty.
    bool insertNumber(int index, const QString& words, const QString& number);
    /// Rewrites any range of the present text the same way (outside a drag an undo step of its own); false
    /// when it lies outside the text or cuts a character.
    bool replaceRange(const SourceRange& range, const QString& text);

    /// Everything between belongs to one undo step; an empty drag leaves none. Undo waits until the end.
    /// Nesting is allowed.
    void beginDrag();
    void endDrag();
    bool isDragging() const;

    /// Puts each match's replacement in its place: one undo step of the user's. The matches are of the
    /// present text, in order.
    void replaceText(const std::vector<SearchMatch>& matches);
    /// The word that the caret is in or beside; empty where there is none.
    QString wordAtCaret() const;
    /// The line of the caret, up to it.
    QString lineBeforeCaret() const;
    /// Selects the range and scrolls it into view; takes the focus. Ranges of other files are ignored.
    void jumpTo(const SourceRange& range);

    /// Undo and redo of the text, and of what others enter into the same history.
    EditHistory* history() const { return history_.get(); }
    /// Whether the text differs from the one last saved; what stands beside the text in the history does not
    /// count. Use it, and modifiedChanged(), in place of what QScintilla says.
    bool isModified() const;

    /// Changes the number under the mouse or at the caret.
    NumberScrubber* scrubber() const { return scrubber_.get(); }

    /// Colours of text, margins, marks, caret and pop-ups.
    void applyTheme(Look look);
    Look look() const { return look_; }

  public slots:
    void undo() override;
    void redo() override;
    void setModified(bool modified) override;
    /// Puts `//` before the selected lines, or takes it away when all of them have it.
    void toggleComment();
    void resetZoom();

  signals:
    /// isModified() has changed. Also emitted, with false, for each new document.
    void modifiedChanged(bool modified);
    /// The user changed the text: by typing, undo, paste, snippets. Emitted from within the change; slots
    /// must not change it.
    void textEdited();
    /// replaceNumber(), replaceRange() or a scrub changed it; the caller knows what.
    void numberReplaced();
    /// setSceneText() did.
    void textLoaded();
    /// Alt+wheel or Alt+drag changed a number in the text: marked number `index`, or -1 for one without a
    /// slider.
    void numberScrubbed(int index, double value);
    /// A scrub ended: a full parse is due.
    void scrubFinished();
    /// The keyboard focus left the editor.
    void focusLost();
    /// Caret position, counted from 1, in characters.
    void caretMoved(int line, int column);

  protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void inputMethodEvent(QInputMethodEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void changeEvent(QEvent* event) override;
    /// Files are opened by the window, text is dropped into the editor.
    bool canInsertFromMimeData(const QMimeData* source) const override;

  private:
    friend class NumberScrubber;

    /// Undo or redo, by `act`; a step beside the text leaves it where it was scrolled to.
    void travel(const std::function<void()>& act);
    void setUpMargins();
    void setUpEditing();
    void setUpCompletion();
    void connectSignals();
    void onModified(int position, int type, int length);
    void onCharacterAdded(int character);
    void noteCompletionKey(const QKeyEvent* event);
    void onCaretMoved();
    void updateLineNumberWidth();
    void rewrite(int begin, int end, const QByteArray& text);
    bool showToolTip(const QPoint& position);

    std::unique_ptr<SceneLexer> lexer_;
    std::unique_ptr<DiagnosticMarks> diagnosticMarks_;
    std::unique_ptr<VerdictMarks> verdictMarks_;
    std::unique_ptr<NumberMarks> numberMarks_;
    std::unique_ptr<NumberScrubber> scrubber_;
    std::unique_ptr<UndoGroup> undoGroup_;
    std::unique_ptr<EditHistory> history_;
    SceneCompletion* completion_ = nullptr;  // owned by the lexer
    quint64 revision_ = 0;
    bool rewriting_ = false;
    bool listWalked_ = false;  ///< the user chose in the completion list
    Look look_ = Look::light;
};

}  // namespace isoscope
