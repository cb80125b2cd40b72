// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QObject>
#include <QTimer>
#include <set>
#include <vector>

#include "core/language/parse.h"
#include "core/study/gradient/surface_verdict.h"

class QDockWidget;

namespace isoscope {

class GradientPanel;
class ProblemsPanel;
class RepairPanel;
class SceneEditor;
class SceneSession;
class SectionPanel;
class VerdictBadge;
class VerdictStudy;
class Viewport;

/// Shows what VerdictStudy finds out where it is seen: in the status line, beside the lines of the text,
/// among the problems, and as marks in the picture and the cross-section. Holds the study while something
/// moves, so that it takes nothing from the pictures.
class VerdictController : public QObject {
    Q_OBJECT
  public:
    /// Where verdicts are shown; the controller owns none of them.
    struct Parts {
        Viewport* viewport;
        SceneEditor* editor;
        SceneSession* session;
        ProblemsPanel* problems;
        GradientPanel* gradient;
        RepairPanel* repair;
        SectionPanel* section;
        QDockWidget* gradientDock;
        VerdictBadge* badge;
    };
    VerdictController(const Parts& parts, QObject* parent);

    /// Null for a new document.
    void setScene(const std::shared_ptr<const Scene>& scene);
    VerdictStudy* study() const { return study_; }
    /// Shows isosurface number `isosurface` in the panel “Gradient”.
    void openPanel(std::size_t isosurface);
    /// Brings the place, in the coordinates of that isosurface's function, to the middle of the picture.
    void goTo(std::size_t isosurface, const glm::dvec3& place);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void hold();
    void followView();
    void adopt(const std::shared_ptr<const ParseResult>& result, quint64 revision);
    void show();
    void showInText();
    void listFindings(const Diagnostics& findings);
    std::set<const SurfaceVerdict*> alarms() const;
    void showPlaces();
    void showNothingToSay();
    /// Whether the verdicts are about the statements of the text as it was parsed last.
    bool fitsText() const;

    Parts parts_;
    VerdictStudy* study_;
    std::shared_ptr<const ParseResult> result_;    ///< of the editor's text; null while that is newer
    std::vector<int> lines_;                       ///< of the isosurfaces of result_
    Diagnostics listed_;                           ///< among the problems, and
    std::shared_ptr<const ParseResult> listedOf_;  ///< of which text
    std::vector<std::size_t> marked_;              ///< whose steepest places are marked in the picture
    std::optional<std::size_t> pressed_;           ///< the mark under a press
    QTimer resumeTimer_, patienceTimer_;
};

/// Brings a place of an isosurface, in the coordinates of its function, to the middle of the picture.
void showPlace(Viewport* viewport, const SceneIsosurface& isosurface, const glm::dvec3& place);

/// `camera` without turning, moved to where it has `place` in the middle and shows `reach` around it.
Camera cameraTowards(const Camera& camera, const glm::dvec3& place, double reach);

}  // namespace isoscope
