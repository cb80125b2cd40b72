// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QSlider>
#include <QToolButton>
#include <utility>

#include "widgets/section/surface_chooser.h"

namespace isoscope {

namespace {

constexpr int sliderSteps = 1000;
constexpr int freePlane = 3;

/// So many that a ten thousandth of the range can be set.
int decimalsFor(double range) {
    return std::clamp(4 - static_cast<int>(std::floor(std::log10(range))), 0, 12);
}

QString axisName(int axis) { return QString(QLatin1Char("xyz"[axis])); }

}  // namespace

SectionControls::SectionControls(QWidget* parent)
    : QWidget(parent), layout_(new QBoxLayout(QBoxLayout::TopToBottom, this)) {
    surfaces_ = new SurfaceChooser(tr("The isosurface whose function is shown"));
    connect(surfaces_, &SurfaceChooser::activated, this, [this] { adoptContainer(); });
    planeRow_ = buildPlaneRow();
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(4);
    layout_->addWidget(surfaces_);
    layout_->addWidget(planeRow_, 1);
    layout_->addWidget(buildAngles());
    shownRow_ = buildShownRow();
    layout_->addWidget(shownRow_);
    setAxis(2);
}

QWidget* SectionControls::buildPlaneRow() {
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    axes_ = new QButtonGroup(this);
    for (int axis = 0; axis < 3; ++axis) {
        QToolButton* button =
            toggle(axisName(axis),
                   tr("Cut at a constant %1 (in the function's own coordinates)").arg(axisName(axis)),
                   tr("Plane across the %1 axis").arg(axisName(axis)));
        axes_->addButton(button, axis);
        row->addWidget(button);
    }
    QToolButton* freely = toggle(
        tr("Free"), tr("Cut by a plane of any direction: turn it by its angles, or drag it in the picture"),
        tr("Free plane"));
    axes_->addButton(freely, freePlane);
    row->addWidget(freely);
    connect(axes_, &QButtonGroup::idClicked, this, &SectionControls::choosePlane);
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(0, sliderSteps);
    slider_->setMinimumWidth(50);
    slider_->setToolTip(tr("Where the plane lies; the ends are the container's walls"));
    slider_->setAccessibleName(tr("Position of the plane"));
    row->addWidget(slider_, 1);
    spin_ = new QDoubleSpinBox;
    spin_->setLocale(QLocale::c());
    spin_->setAccessibleName(tr("Position of the plane as a number"));
    row->addWidget(spin_);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { setPosition(low_ + (high_ - low_) * step / sliderSteps); });
    connect(slider_, &QSlider::sliderReleased, this, &SectionControls::dragFinished);
    connect(spin_, &QDoubleSpinBox::valueChanged, this, &SectionControls::setPosition);
    return whole;
}

QWidget* SectionControls::buildAngles() {
    angles_ = new QWidget;
    auto* angles = new QHBoxLayout(angles_);
    angles->setContentsMargins(0, 0, 0, 0);
    angles->setSpacing(4);
    heading_ =
        angleBox(tr("turn "), tr("Heading: how far the plane is turned about y"), tr("Heading of the plane"));
    heading_->setRange(-180, 180);
    heading_->setWrapping(true);
    tilt_ = angleBox(tr("tilt "), tr("Tilt: how far the plane leans back; at 90° it lies level"),
                     tr("Tilt of the plane"));
    tilt_->setRange(-90, 90);
    for (QDoubleSpinBox* box : {heading_, tilt_}) angles->addWidget(box);
    return angles_;
}

QWidget* SectionControls::buildShownRow() {
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    quantity_ = new QComboBox;
    quantity_->addItems({tr("f − threshold"), tr("|∇f|"), tr("distance")});
    quantity_->setToolTip(
        tr("What the colours show: the function, how steep it is, or how far the surface is: "
           "(f − threshold) ÷ |∇f|, which is right near the surface"));
    quantity_->setAccessibleName(tr("Quantity that is shown"));
    connect(quantity_, &QComboBox::currentIndexChanged, this, &SectionControls::quantityChanged);
    row->addWidget(quantity_);
    row->addWidget(buildBand());
    connect(quantity_, &QComboBox::currentIndexChanged, band_, [this] {
        // A value of the function is none of its slope.
        band_->setPrefix(quantity() == SectionQuantity::gradient ? QString() : QStringLiteral("±"));
        band_->setValue(0);
        // What a distance is told by.
        if (quantity() == SectionQuantity::distance) lines_->setChecked(true);
    });
    lines_ = toggle(tr("Lines"), tr("Thin lines of equal value"), tr("Show lines of equal value"));
    connect(lines_, &QToolButton::toggled, this, &SectionControls::linesToggled);
    row->addWidget(lines_);
    line_ = toggle(tr("Profile"), tr("Chart the function along a line: drag in the section to draw one"),
                   tr("Profile along a line"));
    connect(line_, &QToolButton::toggled, this, &SectionControls::profileToggled);
    row->addWidget(line_);
    row->addStretch(1);
    row->addWidget(buildSave());
    return whole;
}

QDoubleSpinBox* SectionControls::buildBand() {
    band_ = new QDoubleSpinBox;
    band_->setLocale(QLocale::c());
    constexpr double most = 1e6;
    band_->setRange(0, most);
    band_->setDecimals(4);
    band_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    band_->setKeyboardTracking(false);
    band_->setSpecialValueText(tr("auto"));
    band_->setPrefix(QStringLiteral("±"));
    band_->setMaximumWidth(fontMetrics().horizontalAdvance(QStringLiteral("±100.0000")) +
                           3 * fontMetrics().height());
    band_->setToolTip(
        tr("What has the full colour, and by whose parts lines are drawn: the values of the function, "
           "the slope or the distance; auto: most values, or max_gradient"));
    band_->setAccessibleName(tr("Value with the full colour"));
    connect(band_, &QDoubleSpinBox::valueChanged, this, &SectionControls::bandChanged);
    return band_;
}

QToolButton* SectionControls::buildSave() {
    auto* save = new QToolButton;
    save->setText(tr("Save"));
    save->setToolTip(tr("Write the section, or its numbers, to a file"));
    save->setAccessibleName(tr("Save the section or its numbers"));
    save->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(save);
    menu->addAction(tr("&Picture (PNG)…"), this, &SectionControls::pictureRequested);
    menu->addAction(tr("&Numbers (CSV)…"), this, &SectionControls::numbersRequested);
    menu->addSeparator();
    profileMenu_ = menu->addMenu(tr("P&rofile"));
    save->setMenu(menu);
    return save;
}

QToolButton* SectionControls::toggle(const QString& text, const QString& toolTip, const QString& name) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setCheckable(true);
    button->setToolTip(toolTip);
    button->setAccessibleName(name);
    connect(button, &QToolButton::toggled, this, &SectionControls::colorToggles);
    return button;
}

QDoubleSpinBox* SectionControls::angleBox(const QString& prefix, const QString& toolTip,
                                          const QString& name) {
    auto* box = new QDoubleSpinBox;
    box->setLocale(QLocale::c());
    box->setDecimals(1);
    box->setSingleStep(5);
    box->setPrefix(prefix);
    box->setSuffix(QStringLiteral("°"));
    box->setToolTip(toolTip);
    box->setAccessibleName(name);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] { turn(heading_->value(), tilt_->value()); });
    return box;
}

void SectionControls::colorToggles() {
    // Fusion's pressed look is hardly to be seen on a dark window.
    for (auto* button : findChildren<QToolButton*>()) {
        if (!button->isCheckable()) continue;
        QPalette colors;
        if (button->isChecked()) {
            colors.setColor(QPalette::Button, palette().color(QPalette::Highlight));
            colors.setColor(QPalette::ButtonText, palette().color(QPalette::HighlightedText));
        }
        button->setPalette(colors);
    }
}

void SectionControls::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) colorToggles();
    QWidget::changeEvent(event);
}

SectionControls::Extent SectionControls::extent() const {
    Extent extent;
    for (int i = 0; i < layout_->count(); ++i) {
        const QSize size = layout_->itemAt(i)->sizeHint();
        if (size.isEmpty()) continue;  // hidden
        extent.row += size.width() + layout_->spacing();
        extent.rowHeight = std::max(extent.rowHeight, size.height());
        extent.column = std::max(extent.column, size.width());
        extent.columnHeight += size.height() + layout_->spacing();
    }
    return extent;
}

void SectionControls::setDirection(QBoxLayout::Direction direction) { layout_->setDirection(direction); }

void SectionControls::reset() {
    quantity_->setCurrentIndex(0);
    band_->setValue(0);
    lines_->setChecked(false);
    setAxis(2);
    spin_->setValue(0);
}

double SectionControls::position() const { return spin_->value(); }

bool SectionControls::isDragging() const { return slider_->isSliderDown(); }

int SectionControls::surfaceIndex() const { return surfaces_->currentIndex(); }

SectionPlane SectionControls::plane() const {
    if (axis_ != freePlane) return SectionPlane::across(axis_, spin_->value());
    glm::dvec3 center{0};
    if (const auto shape = surface()) {
        const Bounds bounds = containerBounds(shape->settings().container);
        center = 0.5 * bounds.low + 0.5 * bounds.high;
    }
    return SectionPlane::turned(center, heading_->value(), tilt_->value(), spin_->value());
}

std::shared_ptr<const Isosurface> SectionControls::surface() const {
    const int index = surfaces_->currentIndex();
    if (!scene_ || index < 0 || index >= static_cast<int>(scene_->isosurfaces.size())) return nullptr;
    return scene_->isosurfaces[static_cast<std::size_t>(index)].shape;
}

const SceneIsosurface* SectionControls::subject() const {
    if (!usable_ || !surface()) return nullptr;
    return &scene_->isosurfaces[static_cast<std::size_t>(surfaces_->currentIndex())];
}

void SectionControls::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    adoptContainer();
}

SectionControls::State SectionControls::state() const {
    // The angles of a plane across an axis mean nothing.
    const bool free = axis_ == freePlane;
    return {surfaces_->currentIndex(), axis_, spin_->value(), free ? heading_->value() : 0,
            free ? tilt_->value() : 0};
}

void SectionControls::showState(const State& state) {
    if (state.surface != surfaces_->currentIndex() && state.surface < surfaces_->count()) {
        surfaces_->setCurrentIndex(state.surface);
        adoptContainer();
    }
    if (state.axis == freePlane)
        turn(state.heading, state.tilt);
    else if (state.axis != axis_)
        setAxis(state.axis);
    setPosition(state.position);
}

void SectionControls::adoptContainer() {
    if (const auto shape = surface()) {
        const SectionTravel travel = travelOf(plane(), shape->settings().container);
        low_ = travel.low;
        high_ = travel.high;
    }
    usable_ = surface() && std::isfinite(low_) && std::isfinite(high_) && low_ < high_;
    for (QWidget* row : {planeRow_, shownRow_}) row->setVisible(usable_);
    angles_->setVisible(usable_ && axis_ == freePlane);
    if (!usable_) return emit emptied();
    const QSignalBlocker blocked(spin_);
    spin_->setDecimals(decimalsFor(high_ - low_));
    spin_->setRange(low_, high_);
    spin_->setSingleStep((high_ - low_) / 50);
    setPosition(spin_->value());
}

void SectionControls::choosePlane(int id) {
    if (id != freePlane) return setAxis(id);
    setFree();
    emit freed();
}

void SectionControls::setAxis(int axis) {
    const auto shape = surface();
    // From a free plane to one through the same middle.
    const double middle = shape && axis_ == freePlane
                              ? plane().middle(shape->settings().container)[std::clamp(axis, 0, 2)]
                              : spin_->value();
    axis_ = std::clamp(axis, 0, 2);
    axes_->button(axis_)->setChecked(true);
    spin_->setToolTip(tr("The %1 of the plane").arg(axisName(axis_)));
    emit directionChanged();
    const QSignalBlocker blocked(spin_);
    spin_->setRange(std::min(spin_->minimum(), middle), std::max(spin_->maximum(), middle));
    spin_->setValue(middle);
    adoptContainer();
}

void SectionControls::setFree() {
    if (axis_ == freePlane) return;
    const SectionPlane before = plane();
    // With the same sides to the right and up.
    constexpr PlaneAngles angles[] = {{-90, 0}, {0, -90}, {0, 0}};
    const PlaneAngles start = angles[axis_];
    axis_ = freePlane;
    axes_->button(freePlane)->setChecked(true);
    spin_->setToolTip(tr("Distance of the plane from the middle of the container"));
    const QSignalBlocker blockedSpin(spin_), blockedHeading(heading_), blockedTilt(tilt_);
    heading_->setValue(start.heading);
    tilt_->setValue(start.tilt);
    spin_->setRange(-1e9, 1e9);
    spin_->setValue(0);
    if (const auto shape = surface()) {
        const SectionPlane middle = plane();
        const glm::dvec3 way =
            before.middle(shape->settings().container) - middle.middle(shape->settings().container);
        spin_->setValue(glm::dot(way, middle.normal()));
    }
    emit directionChanged();
    adoptContainer();
}

void SectionControls::turn(double heading, double tilt) {
    if (!std::isfinite(heading) || !std::isfinite(tilt)) return;
    setFree();
    const QSignalBlocker blockedHeading(heading_), blockedTilt(tilt_);
    heading_->setValue(std::remainder(heading, 360));
    tilt_->setValue(tilt);
    adoptContainer();
}

void SectionControls::turnTowards(const glm::dvec3& normal) {
    setFree();
    const PlaneAngles angles = anglesOf(normal, heading_->value());
    turn(angles.heading, angles.tilt);
}

void SectionControls::setPosition(double position) {
    const QSignalBlocker blockedSpin(spin_), blockedSlider(slider_);
    spin_->setValue(position);
    slider_->setValue(static_cast<int>(std::lround((spin_->value() - low_) / (high_ - low_) * sliderSteps)));
    emit moved();
}

SectionQuantity SectionControls::quantity() const {
    return static_cast<SectionQuantity>(quantity_->currentIndex());
}

void SectionControls::setQuantity(SectionQuantity quantity) {
    quantity_->setCurrentIndex(static_cast<int>(quantity));
}

void SectionControls::setProfileChosen(bool chosen) { line_->setChecked(chosen); }

}  // namespace isoscope
