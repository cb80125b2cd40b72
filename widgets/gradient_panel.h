// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QTimer>
#include <QWidget>
#include <stop_token>

#include "core/study/gradient_survey.h"
#include "widgets/latest_worker.h"

class QLabel;
class QPushButton;

namespace isoscope {

class SurfaceChooser;

/// What max_gradient should be: the steepest slope that the rays of the view meet, the largest gradient on
/// the surface, a proven bracket of the largest in the container, and the holes that the present setting
/// makes. Works in the background while it is active and starts again with every scene or view.
class GradientPanel : public QWidget {
    Q_OBJECT
  public:
    explicit GradientPanel(QWidget* parent = nullptr);
    ~GradientPanel() override;

    void setScene(std::shared_ptr<const Scene> scene);
    /// Measures only while active: a dock says when it is on screen (behind another tab it counts as
    /// visible).
    void setActive(bool active);
    bool isActive() const { return active_; }
    /// The view that holes are counted in.
    void setView(const Camera& camera, QSize size);

    const GradientSurvey& survey() const { return survey_; }
    /// Nothing is being measured.
    bool upToDate() const { return !measuring_; }
    QPushButton* useSuggested() const { return useSuggested_; }
    QPushButton* useEnough() const { return useEnough_; }
    /// What the panel says about holes.
    QString holesText() const;

  signals:
    /// A button asks for this max_gradient in the text.
    void settingRequested(std::size_t isosurface, double maxGradient);
    /// More is known than before, or nothing any more.
    void reported(const isoscope::GradientSurvey& survey);
    /// A measurement is complete.
    void surveyed();

  private:
    QLabel* addRow(const QString& title, const QString& toolTip, QPushButton* button = nullptr);
    void buildRows();
    void restart();
    void measure();
    void receive(GradientSurvey survey);
    void show(const GradientSurvey& survey);
    void showBracket(const GradientSurvey& survey);
    void clear();
    std::size_t index() const;

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    GradientSurvey survey_;
    SurfaceChooser* surfaces_;
    QLabel *setting_, *alongRays_, *onSurface_, *bracket_, *suggested_, *enough_, *holes_, *note_;
    QPushButton *useSuggested_, *useEnough_;
    QTimer restartTimer_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool active_ = false;
    bool measuring_ = false;
    LatestWorker worker_;  // last: its tasks refer to the panel
};

}  // namespace isoscope
