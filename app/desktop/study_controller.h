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
class Docks;
class EffectsPanel;
class GradientPanel;
class HistogramPanel;
class RayPanel;
class SectionPanel;
class SettingWriter;
class Viewport;

/// Connects the study tools: their commands with the viewport and the panels, the panels with the scene, the
/// view and the text.
class StudyController : public QObject {
    Q_OBJECT
  public:
    struct Parts {
        Actions* actions;
        Viewport* viewport;
        Docks* docks;
        GradientPanel* gradient;
        HistogramPanel* histogram;
        AccuracyPanel* accuracy;
        RayPanel* ray;
        EffectsPanel* effects;
        SectionPanel* section;
        SettingWriter* settings;
    };
    StudyController(const Parts& parts, QObject* parent);

    /// Null for a new document.
    void setScene(const std::shared_ptr<const Scene>& scene);

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    void connectOverlays();
    void connectGradient();
    void connectAccuracy();
    void connectRay();
    void connectEffects();
    void connectSection();
    void showPlane();
    void tellPictured();
    void followView();

    Parts parts_;
    QMap<QDockWidget*, bool> shown_;  ///< the docks that need the gradient
};

}  // namespace isoscope
