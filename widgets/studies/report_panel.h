// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/study/health/function_health.h"
#include "core/study/rewrites/formula_rewrites.h"
#include "core/study/shape/shape_report.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QPlainTextEdit;
class QPushButton;
class QTreeWidget;

namespace isoscope {

class ProgressRow;
class SurfaceChooser;

/// What an isosurface is like as a whole: a text of sentences about pieces, extent, volume, area, walls and
/// symmetry, each with its proof or error, and a list of the places where the function is not healthy, with
/// what would mend them. All is found while the panel is seen and nothing moves, and holds until the
/// isosurface changes.
class ReportPanel : public StudyPanel {
    Q_OBJECT
  public:
    /// Gives the text as it was read last; null while the text is newer.
    using Reader = std::function<std::shared_ptr<const ParseResult>()>;

    explicit ReportPanel(QWidget* parent = nullptr);
    ~ReportPanel() override;

    /// Without a reader nothing is rewritten.
    void setReader(Reader reader) { reader_ = std::move(reader); }
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
    QPushButton* rewriteButton() const { return rewrite_; }

  signals:
    /// A row or its button asks to see this place, in the coordinates of the function.
    void placeRequested(const glm::dvec3& place);
    /// The text is to be changed so.
    void fixRequested(const QuickFix& fix);

  private:
    enum Column { kind, distance, certainty, place, remedy, columnCount };

    QWidget* buildHealth();
    std::size_t chosen() const;
    void stopWork(bool forget);
    void beginIfWanted();
    void work();
    void searchRewrites();
    template <class Action>
    void tell(std::uint64_t generation, Action action);
    void refresh();
    void showHealth();
    const HealthFinding* current() const;
    /// What would mend the finding; null when nothing is known to, or the text has changed since.
    const FormulaRewrite* rewriteFor(const HealthFinding& finding) const;
    bool wantsRewrites() const;
    void rewriteCurrent();

    std::shared_ptr<const Scene> scene_;
    ShapeReport report_;
    FunctionHealth health_;
    Reader reader_;
    std::shared_ptr<const ParseResult> rewritesOf_;  ///< the text that they are about
    std::vector<FormulaRewrite> rewrites_;
    SurfaceChooser* surfaces_;
    QPlainTextEdit* text_;
    QTreeWidget* list_;
    ProgressRow* row_;
    QPushButton *goThere_, *rewrite_;
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
