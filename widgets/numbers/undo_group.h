// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

class QsciScintilla;

namespace isoscope {

/// Makes many changes of the text one undo step: a drag, with a clear beginning and end, or changes that
/// follow one another within `pause` milliseconds (a slider moved by keyboard or wheel emits no end).
class UndoGroup : public QObject {
    Q_OBJECT
  public:
    explicit UndoGroup(QsciScintilla* editor);
    ~UndoGroup() override;

    static constexpr int pause = 400;

    /// Nested drags count as one.
    void beginDrag();
    void endDrag();
    bool isDragging() const { return drags_ > 0; }

    /// A change without a drag is about to come.
    void change();
    /// Ends a group of changes now; a drag goes on.
    void settle();

  private:
    void open();
    void close();

    QsciScintilla* editor_;
    QTimer timer_;
    int drags_ = 0;
    bool open_ = false;
};

}  // namespace isoscope
