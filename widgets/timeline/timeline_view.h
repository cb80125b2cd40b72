// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QWidget>
#include <vector>

#include "core/animation/timeline.h"
#include "widgets/timeline/timeline_row.h"

class QScrollBar;

namespace isoscope {

/// Frames from left to right, a row of keys for each number that has some, and a line at the present frame. A
/// drag anywhere moves that line, a drag of a key moves the key; arrows, Home and End go by frames and rows,
/// Delete asks to take away the key of the chosen row. It changes nothing itself.
class TimelineView : public QWidget {
    Q_OBJECT
  public:
    explicit TimelineView(QWidget* parent = nullptr);

    /// What is shown; the chosen row stays where it is still there.
    void setTimeline(const Timeline& timeline, const std::vector<std::string>& missing);
    /// The present frame; emits nothing.
    void setFrame(int frame);
    int frame() const { return frame_; }
    /// Is held by the mouse.
    bool isDragging() const { return dragging_; }

    /// From top to bottom.
    const std::vector<TimelineRow>& rows() const { return rows_; }
    /// The chosen row; null without rows.
    const TimelineRow* row() const;
    void chooseRow(int index);

    /// Where a frame and a row are drawn: the middle of a key.
    QPoint placeOf(int frame, int row) const;

    QSize sizeHint() const override;
    /// Rows that have no room are scrolled; the frames above them stay.
    QSize minimumSizeHint() const override;

  signals:
    /// The person goes to a frame ...
    void framePicked(int frame);
    /// ... and lets go.
    void frameReleased();
    void rowChosen();
    /// The keys of a row at `from` are to be at `to`.
    void keyMoved(int row, int from, int to);
    void removeRequested();
    /// A menu about the chosen row at the present frame.
    void menuRequested(QPoint place);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    /// A key by its row and frame.
    struct Place {
        int row = 0;
        int frame = 0;
    };

    int rulerHeight() const;
    int rowHeight() const;
    QRect band() const;
    double x(int frame) const;
    int frameAtX(double x) const;
    int rowAt(int y) const;
    std::optional<Place> keyAt(QPoint place) const;
    void pick(int frame);
    void placeScrollBar();
    void paintRuler(QPainter& painter) const;
    void paintRow(QPainter& painter, int index) const;
    void tellPlace();

    QScrollBar* scroll_;
    Timeline timeline_;
    std::vector<TimelineRow> rows_;
    int frame_ = 0;
    int chosen_ = 0;
    bool dragging_ = false;
    std::optional<Place> held_;  ///< the key that a drag moves
    int heldAt_ = 0;             ///< the frame that it is over
};

}  // namespace isoscope
