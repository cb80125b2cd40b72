// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <QElapsedTimer>
#include <QWidget>

#include "core/render/progressive/progressive_renderer.h"
#include "widgets/studies/study_panel.h"

class QLabel;
class QSpinBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace isoscope {

/// What the picture in the viewport is made of: every stage of drawing, why it runs and what it has cost, and
/// struck out those that the scene does not call for. Effects can be left out of the viewport, never of an
/// exported picture.
class EffectsPanel : public StudyPanel {
    Q_OBJECT
  public:
    /// The columns of the table; columnCount is their number.
    enum Column { mark, effect, rays, evaluations, milliseconds, reason, columnCount };

    explicit EffectsPanel(QWidget* parent = nullptr);

    /// The stages of the latest picture. While a picture is in the making, shown at most once per
    /// timing::busyMarkDelay; nothing is drawn while the panel is hidden.
    void show(const RenderProgress& progress);
    /// Of a moving picture; 0 for no limit. Emits no signal.
    void setMovingSeconds(double seconds);

    /// The table of stages and the box of milliseconds; never null.
    QTreeWidget* table() const { return table_; }
    QSpinBox* movingTime() const { return movingTime_; }
    /// Its row; null for none.
    QTreeWidgetItem* row(StageKind kind) const { return rows_[static_cast<std::size_t>(kind)]; }
    const StageSet& leftOut() const { return leftOut_; }

    /// What the line below the table says: roots, misses and time of all rays.
    QString summary() const;

  signals:
    /// What the user wants left out.
    void leftOutChanged(const isoscope::StageSet& leftOut);
    void movingSecondsChanged(double seconds);

  protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void buildTable();
    void outlineMarks();
    void refresh();
    /// What the scene does not call for stands below the rest.
    void sortRows();
    void showStage(const StageReport& report);
    /// One that did not run.
    void showIdle(const PlannedStage& stage, bool calledFor);
    void noteSwitch(QTreeWidgetItem* item, int column);

    QTreeWidget* table_;
    QLabel* sum_;
    QSpinBox* movingTime_;
    std::array<QTreeWidgetItem*, stageKindCount> rows_{};
    RenderProgress progress_;
    QElapsedTimer shown_;
    StageSet leftOut_;
};

}  // namespace isoscope
