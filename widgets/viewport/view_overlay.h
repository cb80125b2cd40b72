// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <stop_token>

#include "core/exchange/povray_process.h"
#include "core/render/render_request.h"
#include "core/study/gradient/gradient_heat_map.h"
#include "core/study/gradient/hole_map.h"
#include "core/study/view/cost_map.h"
#include "core/study/view/povray_comparison.h"
#include "widgets/latest_worker.h"

class QPainter;

namespace isoscope {

/// What is shown over the picture of the viewport, or in its place.
enum class OverlayKind {
    none,
    holes,             ///< marks what POV-Ray's method gets wrong
    split,             ///< POV-Ray's picture left of a divider, the certified one right of it
    difference,        ///< what POV-Ray's method gets wrong, without the picture
    gradient,          ///< |grad f| on the surface
    cost,              ///< what each pixel takes in evaluations, by cause
    compare,           ///< a kept scene left of a divider, the present one right of it
    besidePovray,      ///< the picture of POV-Ray itself left of a divider, the exact one right of it
    povrayDifference,  ///< what differs between these, in the colour of its cause
};

/// What the installed POV-Ray is to draw for an overlay.
struct PovrayTask {
    PovrayOrder order;
    bool leavesOut = false;  ///< the scene has effects that are not simulated
    QString problem;         ///< why POV-Ray cannot draw it; empty when it can
};

/// Computes an overlay for each finished picture in the background, and paints it. What belongs to an older
/// picture goes at once.
class ViewOverlay : public QObject {
    Q_OBJECT
  public:
    explicit ViewOverlay(QObject* parent = nullptr);
    ~ViewOverlay() override;

    /// Says what POV-Ray is to draw to show the same as a picture; without it the overlays of POV-Ray's own
    /// picture show nothing. Called in the thread of the overlay, the window's.
    void setPovrayTask(std::function<PovrayTask(const RenderRequest&)> task) {
        povrayTask_ = std::move(task);
    }

    /// Which overlay is shown; another kind ends the computing, and starts its own when a picture is at rest.
    void setKind(OverlayKind kind);
    OverlayKind kind() const { return kind_; }

    /// What `compare` shows beside the picture, by the same view; null for nothing. What was kept before
    /// goes.
    void keep(std::shared_ptr<const Scene> scene);
    const std::shared_ptr<const Scene>& kept() const { return kept_; }

    /// The picture of `shown` is on the screen in full resolution.
    void follow(const RenderRequest& shown);
    /// The same picture, of a scene that differs in the places of its text alone: what is known, or being
    /// computed, still holds.
    void replace(const RenderRequest& shown);
    /// Another picture is in the making.
    void drop();
    /// Ends the computing; nothing is shown until there is another picture, or another kind is chosen.
    void stop();

    /// Whether an overlay is being computed.
    bool busy() const { return busy_; }
    /// Busy for so long that one wants to know how far it is.
    bool slow() const;
    double share() const { return share_->load(); }
    /// The overlay of the present kind is complete.
    bool ready() const;

    /// Empty (without pixels) while there is none for the present picture. The cost comes in few pixels
    /// first, while busy(), then in all.
    const HoleMap& holes() const { return holes_; }
    const GradientHeatMap& heat() const { return heat_; }
    const CostMap& cost() const { return cost_; }
    const PovrayComparison& povray() const { return povray_; }
    /// One line about what is shown.
    QString summary() const;

    /// Returns the part of `area` that is free for other legends.
    QRect paint(QPainter& painter, const QRect& area) const;

    /// Place of the divider as a share of the width.
    double divider() const { return divider_; }
    void setDivider(double share);
    /// Whether the present kind has a divider between two pictures.
    bool hasDivider() const {
        return kind_ == OverlayKind::split || kind_ == OverlayKind::besidePovray ||
               kind_ == OverlayKind::compare;
    }
    /// Whether the overlay is two pictures, or what differs between pictures: smooth edges would be in one of
    /// them only.
    bool comparesPictures() const {
        return hasDivider() || kind_ == OverlayKind::difference || kind_ == OverlayKind::povrayDifference;
    }
    /// Whether a mouse at `x` of `width` would take the divider.
    bool dividerAt(double x, int width) const;

  signals:
    /// Something to paint is new, or the state of the computing.
    void changed();

  private:
    struct Result {
        HoleMap holes;
        GradientHeatMap heat;
        CostMap cost;
        QImage other;
        PovrayComparison povray;
        QImage povrayImage, exactImage;
        QString problem;
        bool coarse = false;  ///< a finer one follows
    };
    struct Work;

    bool needsPovray() const {
        return kind_ == OverlayKind::besidePovray || kind_ == OverlayKind::povrayDifference;
    }
    void cease();
    void ensure();
    void receive(Result result);
    void makeImage();
    QString compareSummary() const;
    QString busySummary() const;
    void paintSplit(QPainter& painter, const QRect& area) const;
    void paintDivider(QPainter& painter, const QRect& area, const QString& left, const QString& right) const;

    OverlayKind kind_ = OverlayKind::none;
    RenderRequest shown_;                ///< without a scene: none
    std::shared_ptr<const Scene> kept_;  ///< what `compare` shows
    HoleMap holes_;
    GradientHeatMap heat_;
    CostMap cost_;
    bool costIsCoarse_ = false;
    QImage other_;  ///< the picture of the other root finder, or of the kept scene
    PovrayComparison povray_;
    QImage povrayImage_, exactImage_;
    QString problem_;  ///< why there is no picture of POV-Ray's
    std::function<PovrayTask(const RenderRequest&)> povrayTask_;
    QImage image_;  ///< of the present kind, for those painted over the whole picture
    double divider_ = 0.5;
    bool busy_ = false;
    bool stopped_ = false;  ///< no picture is coming that could be compared
    QElapsedTimer since_;
    QTimer progressTimer_;
    std::shared_ptr<std::atomic<double>> share_ = std::make_shared<std::atomic<double>>(0);
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the overlay
};

}  // namespace isoscope
