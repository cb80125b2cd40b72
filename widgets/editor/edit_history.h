// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <QObject>
#include <utility>
#include <vector>

#include "widgets/editor/edit_journal.h"

class QsciScintilla;

namespace isoscope {

/// The editor's undo history as a whole: Scintilla's steps of the text, and between them, in the order in
/// which they happened, steps of what stands beside the text, such as the view. Also knows whether the text
/// is the saved one; steps beside the text do not count for that.
class EditHistory : public QObject {
    Q_OBJECT
  public:
    /// What happens when a step beside the text is taken back or done again. Must not change the text.
    struct Step {
        /// Neither may be empty.
        std::function<void()> undo, redo;
        /// It came of the change before it: both are taken back and done again together.
        bool joined = false;
        /// For a history that is stored: who can make the step again, and of what; neither, and the step is
        /// not stored.
        QString kind = {};
        std::function<QByteArray()> record = {};
    };
    /// Makes a step of what another run has stored of it.
    using Reviver = std::function<Step(const QByteArray& record)>;

    explicit EditHistory(QsciScintilla* editor);
    ~EditHistory() override;

    /// A step was done by the user. What had been taken back is gone, as with a change of the text.
    void add(Step step);
    /// A new document: nothing to take back, unmodified.
    void reset();
    /// Steps of this kind can be stored.
    void setReviver(const QString& kind, Reviver reviver) { revivers_[kind] = std::move(reviver); }
    /// All steps, to be stored.
    EditJournal journal() const;
    /// Does the steps of another run again, and takes back those that were taken back there. The editor has
    /// the text before them, with an empty history; caret and signals are the caller's.
    void replay(const EditJournal& journal);
    /// The owner has loaded a text, with or without steps.
    void tellLoaded();

    /// Whether the present text differs from the one last saved; steps beside the text do not count.
    bool isModified() const { return textState_ != saved_; }
    /// The present text is the saved one, or is none that was ever saved.
    void setModified(bool modified);

    /// Grows with every change of the history and every move in it: what was added last is on top as long as
    /// this stays.
    quint64 serial() const { return serial_; }
    /// How many changes of the text lead from the first one to the present one.
    int textState() const { return textState_; }
    /// The present text came back by undo or redo.
    bool textCameBack() const { return cameBack_; }
    /// After an undo, or a redo: the step has another part.
    bool undoGoesOn() { return std::exchange(undoGoesOn_, false); }
    bool redoGoesOn() const;
    /// The owner of the editor has undone or redone.
    void tellMoved() { emit changed(); }

  signals:
    /// Before add(): an open group of changes is to be closed.
    void adding();
    /// There may be something else to undo or redo.
    void changed();
    void modifiedChanged(bool modified);
    /// The user changed the text that was in this state: the states after it are no longer to be had.
    void textEntered(int before);

  private:
    void onModified(int position, int type, const QByteArray& text, int token);
    void record(int position, int type, const QByteArray& text);
    void replayStep(const EditJournal::Step& step);
    void tellModified(bool before);

    QsciScintilla* editor_;
    struct Entry {
        Step step;
        int textState = 0;  ///< that it came behind
    };
    std::vector<Entry> steps_;
    std::size_t done_ = 0;  ///< of them; the others are taken back
    bool undoGoesOn_ = false;
    quint64 serial_ = 0;
    int textState_ = 0;
    int saved_ = 0;  ///< text state; negative when it is no longer to be had
    bool cameBack_ = false;
    bool replaying_ = false;  ///< steps beside the text are not to act
    EditJournal journal_;     ///< without the records of steps beside the text
    std::map<QString, Reviver> revivers_;
};

}  // namespace isoscope
