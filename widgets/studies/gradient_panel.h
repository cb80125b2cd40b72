// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QTimer>
#include <QWidget>
#include <stop_token>

#include "core/study/gradient/gradient_proofs.h"
#include "core/study/gradient/gradient_survey.h"
#include "core/study/gradient/surface_verdict.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QBoxLayout;
class QGridLayout;
class QLabel;
class QPushButton;

namespace isoscope {

class SurfaceChooser;

/// What max_gradient should be: the steepest slope that the rays of the view meet, the largest gradient on
/// the surface, a proven bracket of the largest in the container, and the holes that the present setting
/// makes. Works in the background while it is active. Another view makes it count pixels again, an edit
/// elsewhere in the text too, but what is proven of a function stays known, and shown.
class GradientPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit GradientPanel(QWidget* parent = nullptr);
    ~GradientPanel() override;

    /// Where proofs are shared with others; without, the panel makes its own for every survey.
    void setProofs(std::shared_ptr<GradientProofs> proofs) { proofs_ = std::move(proofs); }
    void setScene(std::shared_ptr<const Scene> scene) override;
    /// Shows another isosurface.
    void choose(std::size_t isosurface);
    std::size_t chosen() const;
    /// Measures only while active: a dock says when it is on screen (behind another tab it counts as
    /// visible).
    void setWanted(bool wanted);
    bool isActive() const { return active_; }
    void endWork() override;
    void showProbe(const ProbedPoint* point) override;
    /// The view that holes are counted in.
    void setView(const Camera& camera, QSize size) override;

    /// What is known by now of the chosen isosurface; empty before the first report.
    const GradientSurvey& survey() const { return survey_; }
    /// Nothing is being measured.
    bool upToDate() const { return !measuring_; }
    QPushButton* useSuggested() const { return useSuggested_; }
    QPushButton* useEnough() const { return useEnough_; }
    QPushButton* goThere() const { return goThere_; }
    /// What the panel says about holes.
    QString holesText() const;
    QString suggestedText() const;
    /// What the panel says about the probed point.
    QString probeText() const;
    /// The sentence above the numbers.
    QString headline() const;

  signals:
    /// A button asks for this max_gradient in the text.
    void settingRequested(std::size_t isosurface, double maxGradient);
    /// A button asks to see this place, in the coordinates of the function.
    void placeRequested(std::size_t isosurface, const glm::dvec3& place);
    /// Another isosurface was chosen.
    void chosenChanged();
    /// More is known than before, or nothing any more.
    void reported(const isoscope::GradientSurvey& survey);
    /// A measurement is complete.
    void surveyed();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QLabel* addRow(const QString& title, const QString& toolTip, QPushButton* button = nullptr);
    QPushButton* addButton(const QString& text, const QString& toolTip, const QString& name);
    void buildRows();
    /// Writes a row, for the eye and for screen readers.
    void say(QLabel* row, const QString& value);
    /// Nothing of what is shown holds any more.
    void forget();
    /// The same, but for what does not depend on the view.
    void forgetView();
    void restart();
    void measure();
    void receive(GradientSurvey survey);
    void show();
    void showBracket();
    SurfaceVerdict verdict() const;

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    std::shared_ptr<GradientProofs> proofs_;
    GradientSurvey survey_;
    SurfaceChooser* surfaces_;
    QBoxLayout* grids_;
    QGridLayout *measured_, *useful_;
    QLabel *headline_, *setting_, *alongRays_, *onSurface_, *bracket_, *suggested_, *enough_, *holes_,
        *probe_, *note_;
    QPushButton *useSuggested_, *useEnough_, *goThere_;
    QTimer restartTimer_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool active_ = false;
    bool measuring_ = false;
    bool complete_ = false;  ///< survey_ is all there is to say of the present scene and view
    LatestWorker worker_;    // last: its tasks refer to the panel
};

}  // namespace isoscope
