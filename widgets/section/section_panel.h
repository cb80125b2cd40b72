// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QTimer>
#include <QWidget>

#include "core/scene/scene.h"
#include "widgets/latest_worker.h"
#include "widgets/section/section_controls.h"
#include "widgets/section/section_sampler.h"
#include "widgets/studies/study_panel.h"

class QLabel;

namespace isoscope {

class SectionProfile;
class SectionView;

/// The cross-section of an isosurface's function, with its controls and a line along which the function is
/// charted. The plane is sampled in a worker thread, as finely as keeps up
/// with a slider and in full when the scene has come to rest; sizes and positions are in the coordinates of
/// the function.
class SectionPanel : public StudyPanel {
    Q_OBJECT
  public:
    /// Samples along the longer side of a plane at rest.
    static constexpr int fineResolution = 512;

    explicit SectionPanel(QWidget* parent = nullptr);
    ~SectionPanel() override;

    void setScene(std::shared_ptr<const Scene> scene) override;
    /// Back to the first plane, without lines and profile.
    void showProbe(const ProbedPoint* point) override;
    void leaveDocument() override;
    bool settled() const override;
    /// 0 x, 1 y, 2 z.
    void setAxis(int axis);
    /// A plane of any direction; where it lies now until it is turned.
    void setFree();
    /// Turns a free plane, or makes it one; degrees, as SectionPlane has them.
    void turn(double heading, double tilt);
    /// Its normal, of any length.
    void turnTowards(const glm::dvec3& normal);
    void setPosition(double position);
    void setQuantity(SectionQuantity quantity);
    SectionQuantity quantity() const;
    /// Charts the quantity along a line; without one drawn before, along the middle of the plane.
    void setProfileShown(bool shown);

    /// The plane that the controls describe; a free one is measured from the middle of the container, or the
    /// origin without a surface.
    SectionPlane plane() const;
    /// Along the plane's normal, as SectionPlane::position().
    double position() const;
    /// Which surface is cut, and where: what a person chooses.
    using State = SectionControls::State;
    /// The present choice; the angles of a plane across an axis are 0 in it.
    State state() const;
    /// Sets the controls as a person would, with planeChanged() for what changes; a surface that the scene
    /// does not have is left out.
    void showState(const State& state);
    /// planeChanged() comes from another scene, not from a person.
    bool isAdopting() const { return adopting_; }
    /// The slider is held.
    bool isDragging() const;
    SectionView* view() const { return view_; }
    SectionProfile* profile() const { return profile_; }
    /// The surface that is cut; nothing without one of finite extent.
    const SceneIsosurface* subject() const;
    /// Its number; far above all when there is none.
    std::size_t subjectNumber() const;
    /// Marks a place, in the coordinates of the function, on the plane; a click on the mark brings the plane
    /// there.
    void markPlace(const glm::dvec3& place, const QString& label, const QColor& color);
    void unmarkPlace();
    /// Nothing is being sampled or waits to be drawn.
    bool upToDate() const;
    /// x, y, z, f - threshold and, where they are shown, slopes and distances of all samples, as comma
    /// separated values.
    QString table() const;

  signals:
    /// A field was sampled and handed to the view.
    void sampled(double milliseconds);
    /// Another plane, or another surface, container or place of it.
    void planeChanged();
    /// The slider was let go.
    void dragFinished();
    /// The user chose a plane of any direction, which wants to be dragged.
    void freed();

  protected:
    void showEvent(QShowEvent* event) override;
    /// A click on the mark of the view, before the view moves or draws a line; controls that come or go.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Where the controls stand.
    struct Arrangement {
        bool beside = false, oneRow = false;
        int column = -1;  ///< their width at the side

        friend bool operator==(const Arrangement&, const Arrangement&) = default;
    };

    void buildPlots();
    void connectControls();
    void arrange();
    void followPlane();
    void showNothing();
    void sample(int resolution);
    int liveResolution() const;
    void receive(SectionField field);
    void updateProfile();
    void goToMark();
    void describe(double horizontal, double vertical, std::size_t index);
    void tellValue(const glm::dvec3& place, double value, std::optional<double> slope);
    void describePlane();
    void probe(const glm::dvec3& place);
    void save(bool picture);

    SectionControls* controls_;
    QBoxLayout* whole_;
    QWidget* side_;
    Arrangement arrangement_;
    SectionView* view_;
    SectionProfile* profile_;
    QLabel* readout_;
    QTimer refineTimer_;
    bool adopting_ = false;
    double millisecondsPerSample_ = 0;  ///< of the latest field
    std::uint64_t generation_ = 0;
    int pending_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the panel
};

}  // namespace isoscope
