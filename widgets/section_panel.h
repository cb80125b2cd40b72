// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QTimer>
#include <QWidget>

#include "core/scene/scene.h"
#include "widgets/latest_worker.h"
#include "widgets/section_sampler.h"

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace isoscope {

class SectionView;

/// The cross-section of an isosurface's function with its controls: which surface, which axis, where. The
/// plane is sampled in a worker thread, coarsely at once and finely when the scene has come to rest; sizes
/// and positions are in the coordinates of the function.
class SectionPanel : public QWidget {
    Q_OBJECT
  public:
    explicit SectionPanel(QWidget* parent = nullptr);
    ~SectionPanel() override;

    void setScene(std::shared_ptr<const Scene> scene);
    /// 0 x, 1 y, 2 z.
    void setAxis(int axis);
    void setPosition(double position);
    void setQuantity(SectionQuantity quantity);
    SectionQuantity quantity() const;
    int axis() const { return axis_; }
    double position() const;
    SectionView* view() const { return view_; }
    /// Nothing is being sampled or waits to be drawn.
    bool upToDate() const { return pending_ == 0; }

  signals:
    /// A field was sampled and handed to the view.
    void sampled(double milliseconds);

  protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void buildControls();
    void colorAxes();
    void fillSurfaces();
    void adoptContainer();
    void sample(int resolution);
    void receive(SectionField field);
    void describe(double horizontal, double vertical, std::size_t index);
    void describePlane();
    std::shared_ptr<const Isosurface> surface() const;

    std::shared_ptr<const Scene> scene_;
    SectionView* view_;
    QComboBox* surfaces_;
    QComboBox* quantity_;
    QToolButton* lines_;
    QButtonGroup* axes_;
    QSlider* slider_;
    QDoubleSpinBox* spin_;
    QLabel* readout_;
    QTimer refineTimer_;
    int axis_ = 2;
    double low_ = -1, high_ = 1;
    std::uint64_t generation_ = 0;
    int pending_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the panel
};

}  // namespace isoscope
