// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QPixmap>
#include <QWidget>

#include "widgets/studies/cost_plot.h"

namespace isoscope {

class SliderScale;

/// Under the slider of accuracy or max_gradient: what each of its values costs and loses. Two curves are the
/// time of a picture, POV-Ray's in orange and ours in blue; a row of red for each below them is the share of
/// pixels that are lost; a triangle marks the knee, behind which more time changes no pixel, and the ground
/// behind it is shaded; a line is the present value. What was measured for another scene or view is pale, and
/// what is not known is not drawn.
///
/// A click, or the arrow keys, which go from one measured value to the next, choose a value; Return chooses
/// the knee.
class CostStrip : public QWidget {
    Q_OBJECT
  public:
    explicit CostStrip(QWidget* parent = nullptr);
    ~CostStrip() override;

    /// The slider's scale, and how far its handle's middle stays from the ends of the widget.
    void setScale(const SliderScale& scale, int margin);
    /// The present value of the setting.
    void setValue(double value);
    /// "isosurface accuracy", for assistive programs.
    void setSubject(const QString& name);

    /// Shows what is known by now. An older plot stays, pale, until this one is complete.
    void setPlot(CostPlot plot);
    /// What is shown belongs to another scene or view.
    void setOld();
    /// Shows nothing any more but that the setting is not measured: nothing in the picture has it.
    void clear();
    const CostPlot& plot() const { return plot_; }
    /// Complete and of the present scene and view.
    bool fresh() const { return plot_.complete; }
    /// Whether something is or will be known: false once clear() said that there is nothing.
    bool measurable() const { return measurable_; }
    bool hasOld() const { return !old_.marks.empty(); }

    /// One line about the present value: POV-Ray's time with its error, pixels lost. Empty while unknown.
    QString summary() const;
    /// What a value costs and loses, all of it; empty while unknown.
    QString detail(double value) const;
    /// Where a value lies, in widget coordinates.
    double positionOf(double value) const;
    /// What a click at `x` chooses: a measured value or the knee where it is near, else a round one.
    double valueAt(double x) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    /// The user chose a value of the setting, by mouse or keys; the strip shows it once setValue() is called.
    void chosen(double value);
    /// summary() may say something else: plot, value or age changed.
    void summaryChanged();
    /// It was painted without being fresh.
    void exposed();

  protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    /// What stays while the value and the mouse move: the frame and the plots.
    void paintGround(QPainter& painter) const;
    /// ground_, painted anew where it was given up.
    const QPixmap& ground();
    /// Gives ground_ up: what it shows has changed.
    void repaintGround();
    void paintPlot(QPainter& painter, const CostPlot& plot, bool pale) const;
    void paintKnee(QPainter& painter, const CostPlot& plot, bool pale) const;
    void paintPresent(QPainter& painter) const;
    QRectF curveArea() const;
    /// The limits of the curves' logarithmic axis: both plots', so that the pale one does not jump.
    std::array<double, 2> timeRange() const;
    double heightOf(double seconds) const;
    const CostPlot& shown() const { return plot_.marks.size() > 1 ? plot_ : old_; }
    void told();

    std::unique_ptr<SliderScale> scale_;
    int margin_ = 0;
    double value_ = 0;
    QString subject_;
    CostPlot plot_, old_;
    bool measurable_ = true;  ///< a plot is there or will come
    double hover_ = -1;       ///< where the mouse is, or below 0
    QPixmap ground_;          ///< null, or what paintGround() paints
};

/// "0.4 s", "41 s", "3 min", "2 h": two digits at most.
QString roughTime(double seconds);

}  // namespace isoscope
