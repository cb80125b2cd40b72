// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/study/threshold/threshold_survey.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QPushButton;
class QTreeWidget;

namespace isoscope {

class ChartSaver;
class ChartView;
class ProgressRow;
class SurfaceChooser;

/// Which thresholds give which surface: how often the function takes which value in the container, with lines
/// at the values at which pieces appear, join or get tunnels, and a list of these. The chart is a slider of
/// the threshold, whose handle sticks to the lines. The search for them begins when the panel is seen and
/// nothing moves, and holds for every threshold.
class ThresholdPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit ThresholdPanel(QWidget* parent = nullptr);
    ~ThresholdPanel() override;

    void setScene(std::shared_ptr<const Scene> scene) override;
    void setActive(bool active) override;
    void setResting(bool resting) override;
    /// A line at f of a point of this isosurface; the chart probes the places of its lines.
    void showProbe(const ProbedPoint* point) override;

    /// The isosurface that is looked at, by its number.
    std::size_t chosen() const;
    /// The same as part of the scene; null without one.
    const SceneIsosurface* subject() const;
    /// What is known by now; empty before the first report.
    const ThresholdSurvey& survey() const { return survey_; }
    /// What the chart marks and the list has as rows.
    const std::vector<ThresholdTick>& ticks() const { return ticks_; }
    /// A search is under way.
    bool searching() const { return searching_; }

    /// Parts, for tests; never null.
    ChartView* chart() const { return chart_; }
    QTreeWidget* list() const { return list_; }
    QPushButton* stopButton() const;
    QString text() const;

  signals:
    /// The user moves the threshold of the subject to this value ...
    void thresholdMoved(double value);
    /// ... and lets go.
    void thresholdSettled();
    /// A button asks to see this place, in the coordinates of the function.
    void placeRequested(const glm::dvec3& place);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    enum Column { value, happens, certainty, place, columnCount };

    QWidget* buildList();
    void endSearch();
    /// The search ends, and what it found is of no use any more.
    void forget();
    void beginIfWanted();
    void search();
    void receive(const ThresholdSurvey& survey, std::uint64_t generation);
    void refresh();
    void showChart();
    void showList();
    void describe();
    /// The mark that is near a threshold in the chart; null for none.
    const ThresholdTick* tickNear(double threshold) const;
    /// What a press at this threshold in the chart means: a mark that is near, else a round number.
    double settledValue(double threshold) const;
    const ThresholdTick* current() const;

    std::shared_ptr<const Scene> scene_;
    ThresholdSurvey survey_;
    std::vector<ThresholdTick> ticks_;
    SurfaceChooser* surfaces_;
    ChartView* chart_;
    QTreeWidget* list_;
    ProgressRow* row_;
    QPushButton *use_, *goThere_;
    ChartSaver* save_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool active_ = false;
    bool resting_ = false;
    bool searching_ = false;
    bool declined_ = false;  ///< the user has stopped it for this function
    LatestWorker worker_;    // last: its tasks refer to the panel
};

}  // namespace isoscope
