// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QObject>
#include <utility>
#include <vector>

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
    };

    explicit EditHistory(QsciScintilla* editor);
    ~EditHistory() override;

    /// A step was done by the user. What had been taken back is gone, as with a change of the text.
    void add(Step step);
    /// A new document: nothing to take back, unmodified.
    void reset();

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
    void onModified(int type, int token);
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
};

}  // namespace isoscope
