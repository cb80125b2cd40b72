// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <QPointF>
#include <QRectF>

class QPainter;

namespace isoscope {

/// A line in a cross-section, in the plane's coordinates.
struct SectionLine {
    QPointF from, to;

    friend bool operator==(const SectionLine&, const SectionLine&) = default;
};

/// Draws a line in a cross-section with the mouse: a drag from end to end, an end elsewhere, or the whole
/// line along. Knows nothing of the view but how its pixels and the plane's coordinates belong together.
class SectionLineTool {
  public:
    /// What a press takes hold of: an end, or the line as a whole.
    enum class Grip { none, from, to, whole };
    /// How the view maps pixels to the plane's coordinates and back.
    struct Maps {
        /// Inverse to each other; neither may be empty.
        std::function<QPointF(const QPointF&)> toPixel, toPlane;
        QRectF limits;  ///< of the plane: no end leaves it
    };

    /// Whether the tool is switched on, and the line it has, if any; switching it off keeps the line.
    void setOn(bool on) { on_ = on; }
    bool on() const { return on_; }
    void setLine(std::optional<SectionLine> line) { line_ = line; }
    const std::optional<SectionLine>& line() const { return line_; }

    /// What a press at `pixel` would take hold of.
    Grip gripAt(const QPointF& pixel, const Maps& maps) const;
    void press(const QPointF& pixel, const Maps& maps);
    bool dragging() const { return grip_ != Grip::none; }
    /// Whether the line has changed.
    bool drag(const QPointF& pixel, const Maps& maps);
    /// A press without a drag leaves the line as it was.
    void release();

    /// `share` of the way from end to end is marked.
    void paint(QPainter& painter, const Maps& maps, std::optional<double> share) const;

  private:
    bool on_ = false;
    std::optional<SectionLine> line_, before_;
    Grip grip_ = Grip::none;
    QPointF last_;
};

}  // namespace isoscope
