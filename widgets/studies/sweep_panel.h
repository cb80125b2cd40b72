// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <QString>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/sweep/parameter_sweep.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace isoscope {

class ChartSaver;
class ChartView;
class NumberBox;

/// What the values of a number cost and give: evaluations, gradient, pieces, tunnels and hollows over the
/// value, in two charts that grow while it is measured. A measurement begins by itself as soon as the panel
/// is seen and all rests, and ends when something else than the number changes; a click writes a value.
class SweepPanel : public StudyPanel {
    Q_OBJECT
  public:
    /// What gives the scenes of a sweep, from any thread.
    struct Source {
        SceneAt sceneAt;       ///< empty where there is none
        std::string identity;  ///< of all that the scenes have in common: the text without the number
    };
    /// Asked for the number that stands at a place of the text.
    using Reader = std::function<Source(const SourceRange& number)>;

    explicit SweepPanel(QWidget* parent = nullptr);
    ~SweepPanel() override;

    /// Where scenes come from; without one there is nothing to measure.
    void setReader(Reader reader) { reader_ = std::move(reader); }
    void setScene(std::shared_ptr<const Scene> scene) override;
    void setView(const Camera& camera, QSize size) override;
    void setActive(bool active) override;
    void setResting(bool resting) override;

    /// Starts a measurement from the first value; one that runs ends.
    void measure();
    void stop();
    bool measuring() const { return measuring_; }
    /// In ascending order of the values.
    const std::vector<SweepPoint>& points() const { return points_; }
    /// What was measured holds for the present text and view.
    bool fresh() const;

    /// Parts, for tests; never null.
    QComboBox* numbers() const { return numbers_; }
    ChartView* costChart() const { return cost_; }
    ChartView* formChart() const { return form_; }
    QComboBox* quantity() const { return quantity_; }
    QPushButton* startButton() const { return start_; }
    QString text() const;

  signals:
    /// A click asks for this value of the number.
    void valueRequested(const isoscope::SceneParameter& number, double value);
    /// A measurement is complete.
    void measured();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void buildControls();
    QHBoxLayout* buildCharts();
    void listNumbers();
    void takeEnds();
    const SceneParameter* number() const;
    void beginIfWanted();
    void receive(const SweepPoint& point, std::uint64_t generation);
    void finish(std::uint64_t generation);
    void refresh();
    void showChart(ChartView* view, bool cost);
    void describe();

    Reader reader_;
    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    std::vector<SceneParameter> listed_;  ///< by the entries of numbers_
    std::vector<SweepPoint> points_;
    std::string identity_;  ///< of what was measured, with
    Camera measuredCamera_;
    QString measuredName_;
    bool measuredByRatio_ = false;
    std::size_t wanted_ = 0;
    QComboBox *numbers_, *quantity_;
    NumberBox *from_, *to_;
    QSpinBox* steps_;
    QPushButton* start_;
    QProgressBar* progress_;
    QLabel* note_;
    ChartSaver* save_;
    ChartView *cost_, *form_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool measuring_ = false;
    bool active_ = false;
    bool resting_ = false;
    bool declined_ = false;  ///< the user has stopped it
    LatestWorker worker_;    // last: its tasks refer to the panel
};

}  // namespace isoscope
