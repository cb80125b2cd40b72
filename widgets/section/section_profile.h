// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QWidget>

#include "widgets/latest_worker.h"
#include "widgets/section/line_sampler.h"
#include "widgets/section/section_field.h"

class QLabel;

namespace isoscope {

class ChartView;

/// The function, its slope or the distance to its surface along a line: a chart over the distance from the
/// line's beginning, sampled in the background.
class SectionProfile : public QWidget {
    Q_OBJECT
  public:
    explicit SectionProfile(QWidget* parent = nullptr);
    ~SectionProfile() override;

    /// Without surface, or with equal ends, there is nothing to show.
    void setLine(const LineRequest& request, SectionQuantity quantity);
    const LineSamples& samples() const { return samples_; }
    ChartView* chart() const { return chart_; }
    /// Shows where on the line the probed place, in the coordinates of the function, has its foot.
    void showProbe(const std::optional<glm::dvec3>& place);
    bool upToDate() const { return pending_ == 0; }

  signals:
    /// The mouse is over this share of the way.
    void hovered(double share);
    void hoverEnded();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void refresh();
    void describe(std::optional<double> share);

    void placeCursor();

    LineSamples samples_;
    std::optional<glm::dvec3> probe_;
    SectionQuantity quantity_ = SectionQuantity::value;
    ChartView* chart_;
    QLabel* readout_;
    std::uint64_t generation_ = 0;
    int pending_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the widget
};

}  // namespace isoscope
