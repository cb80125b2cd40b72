// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QBoxLayout>
#include <QWidget>

#include "core/scene/scene.h"
#include "widgets/section/section_plane.h"
#include "widgets/section/section_sampler.h"

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QMenu;
class QSlider;
class QToolButton;

namespace isoscope {

class SurfaceChooser;

/// The controls of a cross-section: which surface is cut, by which plane, and what is shown of it. They know
/// where a plane can be, not what it shows. Without a surface of finite extent only the choice of surfaces
/// is seen. Positions are in the coordinates of the function.
class SectionControls : public QWidget {
    Q_OBJECT
  public:
    /// Which surface is cut, and where: what a person chooses.
    struct State {
        int surface = -1;
        int axis = 2;  ///< 3 for a free plane
        double position = 0, heading = 0, tilt = 0;

        friend bool operator==(const State&, const State&) = default;
    };
    /// How much room the controls take: in one row, or below each other.
    struct Extent {
        int row = 0, rowHeight = 0, column = 0, columnHeight = 0;
    };

    explicit SectionControls(QWidget* parent = nullptr);

    /// Null for none.
    void setScene(std::shared_ptr<const Scene> scene);
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    /// The chosen one; null without.
    std::shared_ptr<const Isosurface> surface() const;
    /// The surface that is cut; null without one of finite extent.
    const SceneIsosurface* subject() const;
    /// Of the surface that is cut, whether there is one or not.
    int surfaceIndex() const;

    /// 0 x, 1 y, 2 z.
    void setAxis(int axis);
    /// A plane of any direction; where it lies now until it is turned.
    void setFree();
    /// Turns a free plane, or makes it one; degrees, as SectionPlane has them.
    void turn(double heading, double tilt);
    /// Its normal, of any length.
    void turnTowards(const glm::dvec3& normal);
    void setPosition(double position);
    /// The plane that the controls describe; a free one is measured from the middle of the container, or the
    /// origin without a surface.
    SectionPlane plane() const;
    double position() const;
    /// The slider is held.
    bool isDragging() const;
    /// The angles of a plane across an axis are 0 in it.
    State state() const;
    /// Sets the controls as a person would; a surface that the scene does not have is left out.
    void showState(const State& state);
    /// The plane across z at 0, the function, no lines.
    void reset();

    /// What the colours show, by the box that chooses it.
    void setQuantity(SectionQuantity quantity);
    SectionQuantity quantity() const;
    /// The button that shows the profile, with profileToggled() when that changes.
    void setProfileChosen(bool chosen);
    /// Where the commands that save a profile go; never null.
    QMenu* profileMenu() const { return profileMenu_; }

    /// Of what is seen of them.
    Extent extent() const;
    /// One row, or below each other.
    void setDirection(QBoxLayout::Direction direction);

  signals:
    /// Another plane, or another surface, container or place of it.
    void moved();
    /// There is no plane any more.
    void emptied();
    /// Lines drawn in the plane before lie in another one now.
    void directionChanged();
    void quantityChanged();
    void linesToggled(bool shown);
    /// What is to have the full colour, as SectionView::setBand().
    void bandChanged(double band);
    void profileToggled(bool shown);
    /// The slider was let go.
    void dragFinished();
    /// The user chose a plane of any direction, which wants to be dragged.
    void freed();
    void pictureRequested();
    void numbersRequested();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    QWidget* buildPlaneRow();
    QWidget* buildAngles();
    QWidget* buildShownRow();
    QDoubleSpinBox* buildBand();
    QToolButton* buildSave();
    QToolButton* toggle(const QString& text, const QString& toolTip, const QString& name);
    QDoubleSpinBox* angleBox(const QString& prefix, const QString& toolTip, const QString& name);
    void colorToggles();
    void adoptContainer();
    void choosePlane(int id);

    std::shared_ptr<const Scene> scene_;
    QBoxLayout* layout_;
    SurfaceChooser* surfaces_;
    QWidget *planeRow_, *angles_, *shownRow_;
    QComboBox* quantity_;
    QToolButton *lines_, *line_;
    QMenu* profileMenu_;
    QButtonGroup* axes_;
    QSlider* slider_;
    QDoubleSpinBox *spin_, *heading_, *tilt_, *band_;
    bool usable_ = false;  ///< there is a surface of finite extent
    int axis_ = 2;         ///< or `freePlane`
    double low_ = -1, high_ = 1;
};

}  // namespace isoscope
