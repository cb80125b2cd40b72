// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <QTimer>
#include <QWidget>
#include <stop_token>
#include <vector>

#include "core/study/accuracy/accuracy_study.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace isoscope {

class ChartSaver;
class ChartView;

/// What accuracy, or max_gradient, costs and loses in the present view, with both root finders: two charts
/// that grow while they are measured. A measurement begins by itself as soon as the panel is seen and all
/// rests, and ends when something moves; what was measured for another scene or view is drawn pale and said
/// to be old.
class AccuracyPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit AccuracyPanel(QWidget* parent = nullptr);
    ~AccuracyPanel() override;

    void setScene(std::shared_ptr<const Scene> scene) override;
    void setView(const Camera& camera, QSize size) override;
    /// Shows the points measured for this setting, if any.
    void setStudied(StudiedSetting setting);
    StudiedSetting studied() const;

    /// Nothing moves: what is not known is measured while the panel is seen. Anything that moves ends a
    /// measurement.
    void setResting(bool resting) override;
    /// Its tab was chosen, or another one.
    void setActive(bool active) override;
    /// Starts a measurement of studied() in the background, from the first point; one that runs ends. Nothing
    /// without an isosurface.
    void measure();
    /// How much of the measurement is done, from 0 to 1.
    double share() const { return share_->load(); }
    /// Ends a measurement; points found so far stay, results still under way are dropped.
    void stop();
    bool measuring() const { return measuring_; }
    /// Of the setting that is shown, in the order they were measured.
    const std::vector<AccuracyPoint>& points() const { return study().points; }
    /// What was measured holds for the present scene and view.
    bool fresh() const;

    /// The charts, and the button that starts and stops; never null.
    ChartView* costChart() const { return cost_; }
    ChartView* lossChart() const { return loss_; }
    QPushButton* startButton() const { return start_; }
    /// Comma separated values, as the command `accuracy` prints them.
    QString table() const;
    ChartSaver* saver() const { return save_; }

  signals:
    /// A click on a chart asks for this value of the setting in the text.
    void settingRequested(isoscope::StudiedSetting setting, double value);
    /// A measurement is complete.
    void measured();

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    struct Study {
        std::vector<AccuracyPoint> points;
        std::shared_ptr<const Scene> scene;  ///< that it was measured for
        Camera camera;
        QSize size;    ///< of the view
        QSize pixels;  ///< of the pictures that were timed
        std::size_t wanted = 0;
    };

    void buildControls();
    QWidget* chartColumn(QComboBox* quantity, ChartView* chart);
    Study& study() { return studies_[static_cast<std::size_t>(studied())]; }
    const Study& study() const { return studies_[static_cast<std::size_t>(studied())]; }
    void startPlanned(const AccuracyStudyRequest& request, std::uint64_t generation);
    void receive(const AccuracyPoint& point, std::uint64_t generation);
    void showProgress();
    void finish(std::uint64_t generation);
    void sceneOrViewChanged();
    void beginIfWanted();
    void refresh();
    void showChart(ChartView* chart, const QComboBox* shown) const;
    void describe();
    void describeHover(double value);
    void request(double value);
    /// The value to write for a click: a measured one when it is near, else a round one.
    double settledValue(double value) const;

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    Study studies_[2];
    QComboBox *studied_, *costQuantity_, *lossQuantity_;
    QPushButton* start_;
    QProgressBar* progress_;
    QTimer progressTimer_;
    std::shared_ptr<std::atomic<double>> share_ = std::make_shared<std::atomic<double>>(0);
    QLabel* note_;
    ChartSaver* save_;
    QWidget* charts_;
    ChartView *cost_, *loss_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    StudiedSetting measuredSetting_ = StudiedSetting::accuracy;
    bool measuring_ = false;
    bool resting_ = false;
    bool declined_ = false;  ///< the user has stopped it for this scene and view
    LatestWorker worker_;    // last: its tasks refer to the panel
};

}  // namespace isoscope
