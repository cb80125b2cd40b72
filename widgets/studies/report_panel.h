// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stop_token>

#include "core/study/health/function_health.h"
#include "core/study/shape/shape_report.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace isoscope {

class SurfaceChooser;

/// What an isosurface is like as a whole: a text of sentences about pieces, extent, volume, area, walls and
/// symmetry, each with its proof or error, and a list of the places where the function is not healthy. Both
/// are found while the panel is seen and nothing moves, and hold until the isosurface changes.
class ReportPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit ReportPanel(QWidget* parent = nullptr);
    ~ReportPanel() override;

    void setScene(std::shared_ptr<const Scene> scene) override;
    void setActive(bool active) override;
    void setResting(bool resting) override;

    /// The isosurface that is looked at, as part of the scene; null without one.
    const SceneIsosurface* subject() const;
    /// What is known by now.
    const ShapeReport& report() const { return report_; }
    const FunctionHealth& health() const { return health_; }
    bool working() const { return working_; }
    /// Parts, for tests; never null.
    QPlainTextEdit* text() const { return text_; }
    QTreeWidget* list() const { return list_; }
    QPushButton* goThere() const { return goThere_; }

  signals:
    /// A row or its button asks to see this place, in the coordinates of the function.
    void placeRequested(const glm::dvec3& place);

  private:
    enum Column { kind, distance, certainty, place, columnCount };

    QWidget* buildHealth();
    std::size_t chosen() const;
    void endWork(bool forget);
    void beginIfWanted();
    void work();
    template <class Action>
    void tell(std::uint64_t generation, Action action);
    void showProgress(double done);
    void refresh();
    void showHealth();
    const HealthFinding* current() const;

    std::shared_ptr<const Scene> scene_;
    ShapeReport report_;
    FunctionHealth health_;
    SurfaceChooser* surfaces_;
    QPlainTextEdit* text_;
    QTreeWidget* list_;
    QLabel* note_;
    QProgressBar* progress_;
    QPushButton *stopButton_, *goThere_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool active_ = false;
    bool resting_ = false;
    bool working_ = false;
    bool complete_ = false;
    bool declined_ = false;  ///< the user has stopped it for this isosurface
    LatestWorker worker_;    // last: its tasks refer to the panel
};

}  // namespace isoscope
