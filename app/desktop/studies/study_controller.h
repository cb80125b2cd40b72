// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QObject>
#include <QPointF>
#include <QSize>

#include "core/scene/scene.h"

namespace isoscope {

class Actions;
class CostSurveyor;
class Docks;
class LinkedProbe;
class NoticeBar;
class ParameterPanel;
class ProblemsPanel;
class RangeSurveyor;
class RestWatch;
class SceneEditor;
class SceneSession;
class SettingWriter;
class StudyPanels;
class VerdictBadge;
class VerdictController;
class Viewport;

/// Connects the studies with the scene, the view and the text. Which panels there are, and what a single one
/// is connected with, is for StudyPanels.
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
        NoticeBar* notices;
    };
    StudyController(const Parts& parts, QObject* parent);

    /// Null for a new document.
    void setScene(const std::shared_ptr<const Scene>& scene);
    /// What POV-Ray's time is told for.
    void setExportSize(QSize size);
    VerdictController* verdicts() const { return verdicts_; }
    RestWatch* restWatch() const { return rest_; }
    CostSurveyor* surveyor() const { return surveyor_; }
    RangeSurveyor* ranges() const { return ranges_; }
    LinkedProbe* probe() const { return probe_; }
    /// Another document is shown from now on: what was switched on to look at the old one is switched off.
    void leaveDocument();
    /// Nothing is measured any more: the program ends.
    void stop();

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    void connectPanels();
    void copyDifference();
    void connectOverlays();
    void connectProbe();
    /// Probes what is under the mouse in the picture.
    void probePicture();
    void showProbe();
    void followView();

    Parts parts_;
    VerdictController* verdicts_;
    RestWatch* rest_;
    CostSurveyor* surveyor_;
    RangeSurveyor* ranges_;
    LinkedProbe* probe_;
    std::optional<QPointF> hovered_;  ///< the mouse over the picture, in pixels
};

}  // namespace isoscope
