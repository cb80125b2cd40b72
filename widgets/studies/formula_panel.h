// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/exchange/formulas/derivative_text.h"
#include "core/study/rewrites/formula_rewrites.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;

namespace isoscope {

class ProgressRow;
class SurfaceChooser;

/// The function of an isosurface written otherwise: a list of rewrites that pay, each with its proof, and its
/// derivatives with a function whose gradient is 1 on the surface, as POV-Ray's text. Both are found while
/// the panel is seen and nothing moves.
class FormulaPanel : public StudyPanel {
    Q_OBJECT
  public:
    /// Gives the text as it was read last; null while the text is newer.
    using Reader = std::function<std::shared_ptr<const ParseResult>()>;

    explicit FormulaPanel(QWidget* parent = nullptr);
    ~FormulaPanel() override;

    /// Where texts come from; without one there is nothing to find.
    void setReader(Reader reader) { reader_ = std::move(reader); }
    void setScene(std::shared_ptr<const Scene> scene) override;
    void setActive(bool active) override;
    void setResting(bool resting) override;

    /// What is known by now; empty while it is looked for.
    const std::vector<FormulaRewrite>& rewrites() const { return rewrites_; }
    const DerivativeText& derivatives() const { return derivatives_; }
    bool working() const { return working_; }
    bool complete() const { return complete_; }
    /// Parts, for tests; never null.
    QTreeWidget* list() const { return list_; }
    QPlainTextEdit* text() const { return text_; }
    QPushButton* rewriteButton() const { return rewrite_; }
    QPushButton* copyButton() const { return copy_; }
    QPushButton* insertButton() const { return insert_; }
    QLabel* note() const;

  signals:
    /// The text is to be changed so, as one step for undo.
    void fixRequested(const isoscope::QuickFix& fix);

  private:
    enum Column { change, gain, proof, columnCount };

    QWidget* buildRewrites();
    QWidget* buildDerivatives();
    std::size_t chosen() const;
    const SceneIsosurface* subject() const;
    void stopWork(bool forget);
    void beginIfWanted();
    void work();
    template <class Action>
    void tell(std::uint64_t generation, Action action);
    void refresh();
    void showRewrites();
    const FormulaRewrite* current() const;
    void insertDerivatives();

    Reader reader_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const ParseResult> parsed_;  ///< what the answers are about
    std::vector<FormulaRewrite> rewrites_;
    DerivativeText derivatives_;
    SurfaceChooser* surfaces_;
    QTreeWidget* list_;
    QPlainTextEdit* text_;
    ProgressRow* row_;
    QPushButton *rewrite_, *copy_, *insert_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool active_ = false;
    bool resting_ = false;
    bool working_ = false;
    bool complete_ = false;
    bool declined_ = false;  ///< the user has stopped it for this text
    LatestWorker worker_;    // last: its tasks refer to the panel
};

}  // namespace isoscope
