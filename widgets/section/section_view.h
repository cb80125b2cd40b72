// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <glm/vec3.hpp>
#include <optional>
#include <QColor>

#include "widgets/click_detector.h"
#include "widgets/section/section_field.h"
#include "widgets/section/section_line.h"
#include "widgets/section/vtk_panel.h"

namespace isoscope {

/// Draws a SectionField: its quantity as colours with a colour bar, the threshold as a line, the
/// container as an outline (paler outside), places where f is undefined hatched. Drag moves the plane's
/// image, the wheel zooms; with the line tool on, a drag draws a line instead.
class SectionView : public VtkPanel {
    Q_OBJECT
  public:
    explicit SectionView(QWidget* parent = nullptr);
    ~SectionView() override;

    /// An empty field shows nothing. The view is kept while plane and container stay the same.
    void show(SectionField field);
    const SectionField& field() const { return field_; }
    /// Thin lines of equal height between the colours.
    void setLinesShown(bool shown);
    /// The value, or slope, that has the full colour, and by whose parts lines are drawn; 0 for one that
    /// suits the field: nine tenths of its values, or distances, lie within, slopes are measured by
    /// max_gradient.
    void setBand(double band);
    bool linesShown() const { return linesShown_; }
    /// The line tool; a line outlives its being switched off.
    void setLineTool(bool on);
    bool lineTool() const { return lineTool_.on(); }
    void setLine(std::optional<SectionLine> line);
    const std::optional<SectionLine>& line() const { return lineTool_.line(); }
    /// Marks a place of the line by its share of the way; nothing removes the mark.
    void markLine(std::optional<double> share);
    /// Marks the foot of a place, in the coordinates of the function, with words beside it: how far away the
    /// place is, when the plane does not pass through it.
    struct MarkedPlace {
        glm::dvec3 place{0};
        QString label;
        QColor color;

        bool operator==(const MarkedPlace&) const = default;
    };
    /// Replaces the mark; without a place there is none. It stays when another field is shown.
    void markPlace(std::optional<MarkedPlace> mark);
    const std::optional<MarkedPlace>& markedPlace() const { return marked_; }
    /// Where the mark is; nothing without one.
    std::optional<QPointF> markPixel() const;
    /// Shows the foot of the probed place, in the coordinates of the function, as a cross: pale where the
    /// plane does not pass through the place. Nothing for none; what is drawn by VTK stays as it is.
    void showProbe(std::optional<glm::dvec3> place);
    /// Whether mouse or keys are at a place of the view.
    bool hovering() const { return hover_.has_value(); }
    /// Where the cross is; nothing without one, or while mouse or keys are in the view themselves.
    std::optional<QPointF> probePixel() const;
    /// Says again what is under the mouse, after the field has changed.
    void tellHover();
    /// Shows the whole container.
    void resetView();

    /// The edge of the largest square that a view of this size can show beside its numbers.
    static double squareIn(const QSize& size);
    /// A round distance of the numbers along a side of this extent: small sections, too, have a few of them.
    static double tickStep(double extent, double pixels);

  signals:
    /// The mouse is over (horizontal, vertical) of the plane; `index` is that of the nearest sample.
    void hovered(double horizontal, double vertical, std::size_t index);
    void hoverEnded();
    /// The user drew or moved the line.
    void lineChanged();

  protected:
    bool hasContent() const override { return !field_.empty(); }
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    /// Arrow keys move the crosshair, with Shift by less; Escape ends it.
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Pipeline;

    void makePipeline();
    void applyColors();
    void updateImage();
    void updateContour();
    void updateLines();
    double reach() const;
    void updateScale();
    void drawCrosshair();
    void drawMark();
    void drawProbe();
    void drawFocus();
    /// How far a place is from the plane, along its normal.
    double awayFrom(const glm::dvec3& place) const;
    void endHover();
    void updateOutline();
    void drawScales();
    /// Width of the part left of the colour bar, in pixels.
    void placeBar();
    double planeWidth() const;
    QPointF toPlane(const QPointF& pixel) const;
    QPointF toPixel(const QPointF& place) const;
    SectionLineTool::Maps lineMaps() const;
    void showCursor(const QPointF& pixel);

    std::unique_ptr<Pipeline> pipeline_;  ///< null before the first field
    SectionField field_;
    std::optional<QPointF> hover_;  ///< in pixels
    SectionLineTool lineTool_;
    ClickDetector clicks_;
    std::optional<double> lineMark_;
    std::optional<MarkedPlace> marked_;
    std::optional<glm::dvec3> probe_;
    bool linesShown_ = false;
    double band_ = 0;  ///< as set
    bool viewTouched_ = false;
};

}  // namespace isoscope
