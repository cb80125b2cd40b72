// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "core/render/progressive/effect_budget.h"
#include "core/render/progressive/progressive_renderer.h"
#include "core/scene/orbit_view.h"
#include "widgets/click_detector.h"
#include "widgets/viewport/picture_buffer.h"
#include "widgets/viewport/place_marks.h"
#include "widgets/viewport/plane_handle.h"
#include "widgets/viewport/probe_mark.h"
#include "widgets/viewport/scene_guides.h"
#include "widgets/viewport/view_overlay.h"

namespace isoscope {

/// The picture of the scene, kept up to date in the background, and the mouse and keys that move the view. A
/// new scene, view or size starts a new picture at once; the last one stays until the first pass of the next
/// is complete.
class Viewport : public QWidget {
    Q_OBJECT
  public:
    /// What a new window begins with.
    static constexpr RootFinder defaultRootFinder = RootFinder::certified;

    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    /// Shows another scene. The view goes to the scene's camera where that differs from the last scene's.
    /// `sameLook` promises that the picture stays the same: it is then replaced in one go when complete, and
    /// one that is in the making is completed first.
    void setScene(std::shared_ptr<const Scene> scene, bool sameLook = false);
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    /// Forgets view and picture; for a new document.
    void clear();

    /// The view, with the proportions of the scene's own camera.
    const Camera& camera() const { return view_.camera(); }
    bool viewMoved() const { return view_.moved(); }
    /// The camera of the text, which resetView() returns to.
    const Camera& home() const { return view_.home(); }
    /// The view as a person has moved it, and back to it.
    OrbitView::State view() const { return view_.state(); }
    void showView(const OrbitView::State& view);
    /// A button is held that moves the view, the plane or the divider.
    bool isDragging() const { return drag_ != Drag::none; }
    /// Which picture follows another camera: the whole one, one of what moves, or that of a scene which comes
    /// at once or soon.
    enum class Drawing { whole, moving, withScene };
    /// The view becomes this camera; resetView() goes back to the scene's.
    void showCamera(const Camera& camera, Drawing drawing = Drawing::whole);
    /// The present view becomes the one that resetView() returns to: it was written into the text.
    void adoptView();

    /// Whether isosurfaces are shown as POV-Ray will draw them, or as they are.
    void setRootFinder(RootFinder finder);
    RootFinder rootFinder() const { return rootFinder_; }
    /// Marks the pixels of the finished picture of which the certified root finder is not certain, with a
    /// legend.
    void setVerdictsShown(bool shown);
    bool verdictsShown() const { return verdictsShown_; }
    /// What is certain about the pixels of the latest picture; null with the other root finder.
    const std::shared_ptr<VerdictMap>& verdicts() const { return verdicts_; }

    /// What is computed beside the picture and laid over it. Arrow keys with Alt move the divider of a split
    /// view.
    ViewOverlay& overlay() { return overlay_; }

    /// The plane of the cross-section, to be dragged.
    PlaneHandle& planeHandle() { return planeHandle_; }
    /// Places of the scene that are marked over the picture.
    PlaceMarks& placeMarks() { return placeMarks_; }
    /// The probed point, on the screen alone: pictures that are taken away do not have it.
    ProbeMark& probeMark() { return probeMark_; }
    /// Containers and axes over the picture.
    SceneGuides& guides() { return guides_; }
    /// Hatches where a container cuts its surface, in the finished pictures of the certified root finder.
    void setCutsShown(bool shown);
    bool cutsShown() const { return cutsShown_; }
    /// Between the scene and the widget's pixels.
    ViewProjection projection() const;

    /// While picking, a click asks for the ray of a pixel; dragging still moves the view.
    void setPicking(bool on);
    bool picking() const { return picking_; }
    /// Marks a place by its shares of width and height; nothing takes the mark away.
    void setPicked(std::optional<QPointF> place);
    const std::optional<QPointF>& pickedPlace() const { return picked_; }

    /// Smooth edges, in a second picture that replaces the one at rest in one go. Left out where the first
    /// one took longer than `mostSeconds`.
    static constexpr double anyTime = 1e9;
    void setAntialias(bool on, double mostSeconds = anyTime);
    bool antialias() const { return antialias_; }
    /// A picture with smooth edges is in the making, or about to be.
    bool softening() const { return softening_ || softenTimer_.isActive(); }
    /// Effects that no picture here shows, whatever the scene calls for.
    void setLeftOut(const StageSet& leftOut);
    const StageSet& leftOut() const { return leftOut_; }
    /// While the view or a number moves, effects are left out, dearest first, until a picture takes no longer
    /// than this; they come back at rest. 0: none is.
    void setMovingSeconds(double seconds);
    double movingSeconds() const { return budget_.seconds(); }

    /// Text in the corner ("the text has errors"), over a slightly dimmed picture if that is an older one;
    /// empty for none.
    enum class Dimmed { no, yes };
    const QString& notice() const { return notice_; }
    void setNotice(const QString& notice, Dimmed dimmed = Dimmed::no);

    /// In device pixels; null before the first.
    const QImage& picture() const { return buffer_.picture(); }
    /// The same with what lies over it: overlay, marks, outlines and axes, as far as they are on.
    QImage pictureWithMarks();
    RenderProgress progress() const { return finished_ ? told_ : renderer_.progress(); }
    /// The full resolution of the present scene and view is on screen, or the picture was stopped.
    bool finished() const { return finished_ && !resizeTimer_.isActive(); }
    /// A turning mark tells that the picture takes longer than timing::busyMarkDelay.
    bool busyMarkShown() const;

  public slots:
    /// Back to home(), with viewChanged(); nothing for a view that was not moved.
    void resetView();
    /// Ends the picture, and the overlay, that are in the making; what is on screen stays.
    void stop();
    /// Draws again in full resolution.
    void restart();

  signals:
    /// While a picture is in the making, and once when it is finished.
    void progressed(const isoscope::RenderProgress& progress);
    /// Full resolution is on the screen.
    void pictureFinished();
    void viewChanged();
    void movingSecondsChanged(double seconds);
    /// What moved with a button held rests.
    void dragFinished();
    /// The picture was taken with the mouse, Ctrl held, to be dropped elsewhere; the button is still down.
    void pictureTaken();
    /// A pixel was clicked while picking; shares of width and height.
    void picked(QPointF place);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum class Drag { none, orbit, pan, divider, plane, away };

    QSize deviceSize() const;
    void request(int finestBlock, PictureBuffer::Reveal reveal = PictureBuffer::Reveal::firstPass,
                 const StageSet& leftOut = {});
    /// A picture of what moves: followed by the whole one, at rest, if it is not that itself.
    void requestMoving(int finestBlock, const StageSet& leftOut);
    void viewMovedByUser();
    void zoomAt(const QPointF& position, double factor);
    void panByPixels(const QPointF& pixels);
    void forgetMarks();
    /// It is whole, and came quickly enough to be drawn again.
    bool softenable(const RenderProgress& picture) const;
    void soften();
    void drain();
    void drainSoftened(const RenderProgress& progress, bool changed);
    void drainIfBusy();
    /// What lies over the picture and belongs to it. Returns the area above the legends.
    QRect paintMarks(QPainter& painter);
    /// Messages and what is under way; `free` is what the legends leave.
    void paintOverlays(QPainter& painter, const QRect& free);
    void paintCuts(QPainter& painter);
    /// `area` is what other legends leave free; returns what this one does.
    QRect paintVerdicts(QPainter& painter, const QRect& area);
    void paintPicked(QPainter& painter) const;
    /// What a press would drag.
    Drag dragFor(const QMouseEvent& press);
    void endDrag(ClickDetector::Outcome outcome, const QPointF& position);
    void showCursor(const QPointF& position);

    std::shared_ptr<const Scene> scene_;
    OrbitView view_;
    PictureBuffer buffer_;
    QTimer drainTimer_;
    QTimer settleTimer_;
    QTimer resizeTimer_;
    QTimer softenTimer_;
    QElapsedTimer busySince_;
    QElapsedTimer toldSince_;  ///< of the progress of this picture
    QString notice_;
    Dimmed dimmed_ = Dimmed::no;
    QPointF lastPosition_;  ///< of the mouse, as far as the view has followed it
    Drag drag_ = Drag::none;
    ClickDetector clicks_;
    std::uint64_t job_ = 0;
    bool preliminary_ = false;  ///< the running job is coarse or lacks effects, because something moves
    EffectBudget budget_;       ///< also decides how coarse a moving picture must be
    StageSet leftOut_;
    bool finished_ = true;
    bool sameLook_ = false;  ///< the running job draws what is shown already
    bool confirm_ = false;   ///< draw again, from the text that was parsed, when the picture is finished
    RootFinder rootFinder_ = defaultRootFinder;
    std::shared_ptr<VerdictMap> verdicts_;  ///< of the latest request; filled while it is drawn
    QImage verdictImage_;                   ///< made of it when painted first; null before
    bool verdictsShown_ = false;
    QImage cutImage_;         ///< as verdictImage_
    bool cutsKnown_ = false;  ///< cutImage_ was made
    bool cutsShown_ = false;
    RenderRequest shown_;  ///< the latest request, as the overlay needs it
    ViewOverlay overlay_;
    PlaneHandle planeHandle_;
    PlaceMarks placeMarks_;
    ProbeMark probeMark_;
    SceneGuides guides_;
    RenderProgress told_;  ///< of the finished picture
    std::optional<QPointF> picked_;
    bool picking_ = false;
    bool antialias_ = false;
    double softSeconds_ = anyTime;  ///< pictures that take longer keep their edges
    bool softening_ = false;        ///< the running job draws the finished picture again, with smooth edges
    bool soft_ = false;             ///< the picture shown has smooth edges
    bool touched_ = false;  ///< the user knows how to move the view; the tooltip would only be in the way
    ProgressiveRenderer renderer_;  // last, so that it stops first
};

/// `camera` with its picture widened, or heightened, to the proportions of width to height; all that it shows
/// stays visible.
Camera fittedCamera(const Camera& camera, int width, int height);

}  // namespace isoscope
