// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <QSize>
#include <stop_token>

#include "core/study/gradient/evaluate_advice.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace isoscope {

class SurfaceChooser;

/// Whether `evaluate` pays for an isosurface in this view: the proven max_gradient and proposals of P0, P1,
/// P2, each with its measured cost and the pixels that it gets wrong. Measured when asked for; one click
/// writes a proposal into the text.
class EvaluatePanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit EvaluatePanel(QWidget* parent = nullptr);
    ~EvaluatePanel() override;

    void setScene(std::shared_ptr<const Scene> scene) override;
    void setView(const Camera& camera, QSize size) override;
    void setActive(bool active) override;

    /// Starts a measurement; one that runs ends.
    void measure();
    bool measuring() const { return measuring_; }
    /// What is known; of an earlier scene or view where old() says so.
    const EvaluateAdvice& advice() const { return advice_; }
    bool old() const { return old_; }
    /// Parts, for tests; never null.
    QTreeWidget* list() const { return list_; }
    QPushButton* startButton() const { return start_; }
    QPushButton* writeButton() const { return write_; }
    QLabel* note() const { return note_; }

  signals:
    /// Isosurface number `isosurface` is to have `evaluate` with these numbers, and P0 as max_gradient.
    void evaluateRequested(std::size_t isosurface, const std::array<double, 3>& numbers);
    /// It is to have this max_gradient.
    void gradientRequested(std::size_t isosurface, double value);

  private:
    enum Column { setting, cost, wrong, columnCount };

    std::size_t chosen() const;
    bool hasSubject() const;
    void stop();
    void outdate();
    void finish(const EvaluateAdvice& advice, std::uint64_t generation);
    void refresh();
    void addRow(const BoundTrial& trial, bool best);
    const BoundTrial* current() const;

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{320, 240};
    EvaluateAdvice advice_;
    SurfaceChooser* surfaces_;
    QTreeWidget* list_;
    QLabel* note_;
    QProgressBar* progress_;
    QPushButton *start_, *write_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool measuring_ = false;
    bool old_ = false;
    LatestWorker worker_;  // last: its tasks refer to the panel
};

}  // namespace isoscope
