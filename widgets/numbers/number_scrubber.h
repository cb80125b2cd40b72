// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QObject>
#include <QTimer>

class QEvent;
class QMouseEvent;
class QPoint;
class QWheelEvent;

namespace isoscope {

struct NumberLiteral;
class SceneEditor;

/// Dragging a number of the text with Control or Alt, or Alt+wheel over it, changes it by steps of its last
/// digit; Shift makes the steps a tenth, the other of Control and Alt ten times as large. One drag, or one
/// run of the wheel, is one undo step. Many window managers keep Alt for themselves.
class NumberScrubber : public QObject {
    Q_OBJECT
  public:
    explicit NumberScrubber(SceneEditor* editor);

    /// Looks at an event of the editor's viewport; true when it was for the scrubber.
    bool handle(QEvent* event);
    bool isDragging() const { return dragging_; }
    /// Ends a drag and takes it back.
    void cancel();
    /// The number at the caret, unless it stands in a comment, a string or a name.
    std::optional<NumberLiteral> atCaret() const;
    /// Rewrites the number that begins at byte `begin` as `text`, which says `value`, and tells everybody.
    /// False when no number begins there.
    bool write(int begin, double value, const QByteArray& text);
    /// Moves the number at the caret by steps of its last digit; false when there is none. A run of them is
    /// one undo step.
    bool stepAtCaret(double steps);

  signals:
    /// A click with Control on a number, where the caret is now.
    void clicked();

  private:
    static constexpr int pixelsPerStep = 4;

    bool wheel(QWheelEvent* event);
    bool press(QMouseEvent* event);
    bool move(QMouseEvent* event);
    bool release();
    std::optional<NumberLiteral> numberUnder(const QPoint& position) const;
    /// The number that the byte belongs to, unless it stands in a comment, a string or a name.
    std::optional<NumberLiteral> numberOf(long position) const;
    /// Rewrites the number that begins at `begin_`.
    void set(double value, double resolution);
    void finish();

    SceneEditor* editor_;
    QTimer wheelEnd_;
    int begin_ = 0;          // of the number at hand, bytes
    double startValue_ = 0;  // of a drag
    double startStep_ = 1;
    int startX_ = 0;
    Qt::KeyboardModifier heldBy_ = Qt::AltModifier;  ///< the modifier that began the drag
    quint64 startSerial_ = 0;                        ///< of the history
    bool moved_ = false;                             ///< the drag went somewhere, if only back
    int wheelRest_ = 0;                              // eighths of a degree that make no whole step yet
    bool dragging_ = false;
};

}  // namespace isoscope
