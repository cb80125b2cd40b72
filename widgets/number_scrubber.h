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

/// Alt+wheel, or dragging with Alt, over a number of the text changes it by steps of its last digit; Shift
/// makes the steps a tenth, Control ten times as large. One drag, or one run of the wheel, is one undo step.
class NumberScrubber : public QObject {
    Q_OBJECT
  public:
    explicit NumberScrubber(SceneEditor* editor);

    /// Looks at an event of the editor's viewport; true when it was for the scrubber.
    bool handle(QEvent* event);
    bool isDragging() const { return dragging_; }

  private:
    static constexpr int pixelsPerStep = 4;

    bool wheel(QWheelEvent* event);
    bool press(QMouseEvent* event);
    bool move(QMouseEvent* event);
    bool release();
    std::optional<NumberLiteral> numberUnder(const QPoint& position) const;
    /// Rewrites the number that begins at `begin_`.
    void set(double value, double resolution);
    void finish();

    SceneEditor* editor_;
    QTimer wheelEnd_;
    int begin_ = 0;          // of the number at hand, bytes
    double startValue_ = 0;  // of a drag
    double startStep_ = 1;
    int startX_ = 0;
    int wheelRest_ = 0;  // eighths of a degree that make no whole step yet
    bool dragging_ = false;
};

}  // namespace isoscope
