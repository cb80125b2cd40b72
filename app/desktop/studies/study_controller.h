// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QMap>
#include <QObject>

#include "core/scene/scene.h"

class QDockWidget;

namespace isoscope {

class AccuracyPanel;
class Actions;
class CostSurveyor;
class Docks;
class EffectsPanel;
class GradientPanel;
class HistogramPanel;
class ParameterPanel;
class ProblemsPanel;
class RayPanel;
class RestWatch;
class SceneEditor;
class SceneSession;
class SectionPanel;
class SettingWriter;
class StudyPanels;
class VerdictBadge;
class VerdictController;
class Viewport;

/// Connects the study tools: their commands with the viewport and the panels, the panels with the scene, the
/// view and the text.
class StudyController : public QObject {
    Q_OBJECT
  public:
    /// What the controller connects; it owns none of them.
    struct Parts {
        Actions* actions;
        Viewport* viewport;
        Docks* docks;
        const StudyPanels* panels;
        SettingWriter* settings;
        SceneEditor* editor;
        SceneSession* session;
        ProblemsPanel* problems;
        VerdictBadge* badge;
        ParameterPanel* parameters;
    };
    StudyController(const Parts& parts, QObject* parent);

    /// Null for a new document.
    void setScene(const std::shared_ptr<const Scene>& scene);
    /// What POV-Ray's time is told for.
    void setExportSize(QSize size);
    VerdictController* verdicts() const { return verdicts_; }
    RestWatch* restWatch() const { return rest_; }
    CostSurveyor* surveyor() const { return surveyor_; }
    /// Another document is shown from now on: what was switched on to look at the old one is switched off.
    void leaveDocument();
    /// Nothing is measured any more: the program ends.
    void stop();

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    void connectPanels();
    void connectOverlays();
    void connectGradient();
    void connectAccuracy();
    void connectCosts();
    void connectRay();
    void connectEffects();
    void connectSection();
    void showPlane();
    void tellPictured();
    void followView();

    Parts parts_;
    GradientPanel* gradient_;
    HistogramPanel* histogram_;
    AccuracyPanel* accuracy_;
    RayPanel* ray_;
    EffectsPanel* effects_;
    SectionPanel* section_;
    VerdictController* verdicts_;
    RestWatch* rest_;
    CostSurveyor* surveyor_;
    QMap<QDockWidget*, bool> shown_;  ///< the docks that need the gradient
};

}  // namespace isoscope
