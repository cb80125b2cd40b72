// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QPointF>
#include <QWidget>
#include <stop_token>

#include "core/study/gradient/hole_map.h"
#include "core/study/view/ray_profile.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QCheckBox;
class QLabel;

namespace isoscope {

class ChartSaver;
class ChartView;
class SurfaceChooser;

/// An isosurface along the ray of one pixel: f - threshold between the walls of the container, the samples of
/// POV-Ray's method with the cones that max_gradient allows, the intervals that it dismisses (wrongly, in
/// red), and what is certain. The picture that explains a hole.
class RayPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit RayPanel(QWidget* parent = nullptr);
    ~RayPanel() override;

    void setScene(std::shared_ptr<const Scene> scene) override;
    /// Computes only while active: a dock says when it is on screen. What was missed is made up for.
    void setActive(bool active) override;
    void setView(const Camera& camera, QSize size) override;
    void showProbe(const ProbedPoint* point) override;
    /// The pixel, by its shares of width and height; nothing for none.
    void setPixel(std::optional<QPointF> place);
    const std::optional<QPointF>& pixel() const { return pixel_; }
    /// What the hole map of the viewport says about that pixel, if there is one.
    void setPictured(std::optional<HolePixel> kind);

    /// The latest profile; empty without a pixel or before the first one is computed.
    const RayProfile& profile() const { return profile_; }
    /// What is shown holds; behind another tab it may not.
    bool upToDate() const { return pending_ == 0 && !missed_; }
    ChartView* chart() const { return chart_; }
    /// What the panel says about the ray.
    QString explanation() const;

  signals:

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Found {
        RayProfile profile;
        Ray ray;
        std::size_t isosurface = 0;
    };

    void buildControls();
    void measure();
    void receive(Found found);
    void setRange(double low, double high);
    void refresh();
    void addCurves(struct Chart& chart) const;
    void addPovray(struct Chart& chart) const;
    void addEnclosures(struct Chart& chart) const;
    void describe();
    void describeHover(QPointF values);

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    std::optional<QPointF> pixel_;
    std::optional<HolePixel> pictured_;
    RayProfile profile_;
    Ray ray_;  ///< of the profile, in the world
    std::size_t isosurface_ = 0;
    double low_ = 0, high_ = 1;  ///< of the ray, as shown
    SurfaceChooser* surfaces_;
    QCheckBox *cones_, *enclosures_;
    QLabel *explanation_, *readout_;
    ChartView* chart_;
    ChartSaver* save_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    int pending_ = 0;
    bool active_ = false;
    bool missed_ = false;  ///< something to measure, for when it becomes active
    LatestWorker worker_;  // last: its tasks refer to the panel
};

}  // namespace isoscope
