// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "widgets/section_field.h"
#include "widgets/vtk_panel.h"

namespace isoscope {

/// Draws a SectionField: f - threshold as diverging colours with a colour bar, the threshold as a line, the
/// container as an outline (paler outside), places where f is undefined hatched. Drag moves the plane's
/// image, the wheel zooms.
class SectionView : public VtkPanel {
    Q_OBJECT
  public:
    explicit SectionView(QWidget* parent = nullptr);
    ~SectionView() override;

    /// An empty field shows nothing. The view is kept while plane and container stay the same.
    void show(SectionField field);
    const SectionField& field() const { return field_; }
    /// Shows the whole container.
    void resetView();

  signals:
    /// The mouse is over (horizontal, vertical) of the plane, where f - threshold is `value`.
    void hovered(double horizontal, double vertical, double value);
    void hoverEnded();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Pipeline;

    void applyColors();
    void updateImage();
    void updateContour();
    void updateOutline();
    void drawScales();
    /// Width of the part left of the colour bar, in pixels.
    double planeWidth() const;
    QPointF toPlane(const QPointF& pixel) const;

    std::unique_ptr<Pipeline> pipeline_;
    SectionField field_;
    bool viewTouched_ = false;
};

}  // namespace isoscope
