// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/study/gradient/gradient_survey.h"
#include "widgets/studies/study_panel.h"

class QLabel;

namespace isoscope {

class ChartSaver;
class ChartView;

/// The distribution of |grad f| over the container and over the surface, with lines at max_gradient and at
/// the proven bracket. Shows what the Gradient panel has surveyed; measures nothing itself.
class HistogramPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit HistogramPanel(QWidget* parent = nullptr);

    /// The survey of that isosurface; one without histogram shows that there is none yet.
    void show(const GradientSurvey& survey, std::size_t isosurface = 0);
    /// A line at |grad f| of a point of that isosurface's function.
    void showProbe(const ProbedPoint* point) override;
    ChartView* chart() const { return chart_; }
    QString text() const;
    ChartSaver* saver() const { return save_; }

  signals:

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void refresh();
    void describe(const GradientHistogram& histogram);

    GradientSurvey survey_;
    std::size_t isosurface_ = 0;
    ChartView* chart_;
    QLabel* text_;
    ChartSaver* save_;
};

}  // namespace isoscope
