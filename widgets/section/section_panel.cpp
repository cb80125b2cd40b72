// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_panel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineF>
#include <QMenu>
#include <QMouseEvent>
#include <QSlider>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/document/save_path.h"
#include "widgets/section/section_profile.h"
#include "widgets/section/section_view.h"
#include "widgets/section/surface_chooser.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

constexpr int sliderSteps = 1000;
constexpr int coarseResolution = 192;
/// Sampling while a slider moves should take no longer than this, in milliseconds.
constexpr double liveBudget = 14;
constexpr int freePlane = 3;

/// So many that a ten thousandth of the range can be set.
int decimalsFor(double range) {
    return std::clamp(4 - static_cast<int>(std::floor(std::log10(range))), 0, 12);
}

QString axisName(int axis) { return QString(QLatin1Char("xyz"[axis])); }

QString shortNumber(double value) { return QString::number(std::abs(value) < 1e-12 ? 0 : value, 'g', 4); }

QString pointText(const glm::dvec3& p) {
    return QStringLiteral("<%1, %2, %3>").arg(shortNumber(p.x), shortNumber(p.y), shortNumber(p.z));
}

/// A label that shows as much of a text as there is room for.
class Readout : public QLabel {
  public:
    /// A wrapped text must not make the panel higher.
    bool hasHeightForWidth() const override { return false; }
};

}  // namespace

SectionPanel::SectionPanel(QWidget* parent) : StudyPanel(parent) {
    buildControls();
    refineTimer_.setSingleShot(true);
    refineTimer_.setInterval(timing::settlePause);
    connect(&refineTimer_, &QTimer::timeout, this, [this] { sample(fineResolution); });
    connect(view_, &SectionView::hovered, this, &SectionPanel::describe);
    connect(view_, &SectionView::hoverEnded, this, &SectionPanel::describePlane);
    view_->installEventFilter(this);
    connect(view_, &SectionView::lineChanged, this, &SectionPanel::updateProfile);
    connect(profile_, &SectionProfile::hovered, this, [this](double share) { view_->markLine(share); });
    connect(profile_, &SectionProfile::hoverEnded, this, [this] { view_->markLine({}); });
    setAxis(2);
}

SectionPanel::~SectionPanel() = default;

void SectionPanel::buildControls() {
    whole_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
    whole_->setContentsMargins(6, 6, 6, 6);
    whole_->setSpacing(4);
    surfaces_ = new SurfaceChooser(tr("The isosurface whose function is shown"));
    connect(surfaces_, &SurfaceChooser::activated, this, [this] { adoptContainer(); });
    QWidget* planeRow = buildPlaneRow();
    view_ = new SectionView;
    view_->setToolTip(
        tr("f − threshold on the plane: blue is inside, orange outside, the bold line is the surface.\n"
           "|∇f|: red where it is steeper than max_gradient.\n"
           "Drag to move, wheel to zoom, double-click to see all. Hatched: f is undefined."));
    controls_ = new QBoxLayout(QBoxLayout::TopToBottom);
    controls_->setSpacing(4);
    controls_->addWidget(surfaces_);
    controls_->addWidget(planeRow, 1);
    controls_->addWidget(buildAngles());
    controls_->addWidget(buildShownRow());
    side_ = new QWidget;
    auto* side = new QVBoxLayout(side_);
    side->setContentsMargins(0, 0, 0, 0);
    side->setSpacing(4);
    side->addLayout(controls_);
    side_->installEventFilter(this);
    whole_->addWidget(side_);
    auto* plots = new QSplitter(Qt::Horizontal);
    plots->setChildrenCollapsible(false);
    plots->addWidget(view_);
    profile_ = new SectionProfile;
    profile_->hide();
    plots->addWidget(profile_);
    plots->setStretchFactor(0, 1);
    plots->setStretchFactor(1, 1);
    constexpr int half = 1000;  // of whatever there is
    plots->setSizes({half, half});
    whole_->addWidget(plots, 1);
    readout_ = new Readout;
    readout_->setTextFormat(Qt::PlainText);
    readout_->setAccessibleDescription(tr("Value of the function under the mouse"));
    side->addWidget(readout_, 1);
    arrange();
}

QWidget* SectionPanel::buildPlaneRow() {
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
    connect(axes_, &QButtonGroup::idClicked, this, &SectionPanel::choosePlane);
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(0, sliderSteps);
    slider_->setMinimumWidth(50);
    slider_->setToolTip(tr("Where the plane lies; the ends are the container's walls"));
    slider_->setAccessibleName(tr("Position of the plane"));
    row->addWidget(slider_, 1);
    spin_ = new QDoubleSpinBox;
    spin_->setAccessibleName(tr("Position of the plane as a number"));
    row->addWidget(spin_);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { setPosition(low_ + (high_ - low_) * step / sliderSteps); });
    connect(slider_, &QSlider::sliderReleased, this, &SectionPanel::dragFinished);
    connect(spin_, &QDoubleSpinBox::valueChanged, this, &SectionPanel::setPosition);
    return whole;
}

QWidget* SectionPanel::buildAngles() {
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
    angles_->hide();
    return angles_;
}

QWidget* SectionPanel::buildShownRow() {
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    quantity_ = new QComboBox;
    quantity_->addItems({tr("f − threshold"), tr("|∇f|")});
    quantity_->setToolTip(tr("What the colours show: the function, or how steep it is"));
    quantity_->setAccessibleName(tr("Quantity that is shown"));
    connect(quantity_, &QComboBox::currentIndexChanged, this, [this] {
        sample(liveResolution());
        refineTimer_.start();
    });
    row->addWidget(quantity_);
    lines_ = toggle(tr("Lines"), tr("Thin lines of equal value"), tr("Show lines of equal value"));
    connect(lines_, &QToolButton::toggled, view_, &SectionView::setLinesShown);
    row->addWidget(lines_);
    line_ = toggle(tr("Profile"), tr("Chart the function along a line: drag in the section to draw one"),
                   tr("Profile along a line"));
    connect(line_, &QToolButton::toggled, this, &SectionPanel::setProfileShown);
    row->addWidget(line_);
    row->addStretch(1);
    save_ = new QToolButton;
    save_->setText(tr("Save"));
    save_->setToolTip(tr("Write the section, or its numbers, to a file"));
    save_->setAccessibleName(tr("Save the section or its numbers"));
    save_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(save_);
    menu->addAction(tr("&Picture (PNG)…"), this, [this] { save(true); });
    menu->addAction(tr("&Numbers (CSV)…"), this, [this] { save(false); });
    menu->addSeparator();
    QMenu* profile = menu->addMenu(tr("P&rofile"));
    profileSaver_ = new ChartSaver({[this] { return QList<Chart>{profile_->chart()->chart()}; },
                                    [this] { return chartTable(profile_->chart()->chart()); }, tr("profile")},
                                   this);
    profileSaver_->hide();
    profile->addActions(profileSaver_->menu()->actions());
    connect(profileSaver_, &ChartSaver::said, this, &SectionPanel::said);
    connect(menu, &QMenu::aboutToShow, profile,
            [this, profile] { profile->setEnabled(!profile_->isHidden() && !profile_->samples().empty()); });
    save_->setMenu(menu);
    row->addWidget(save_);
    return whole;
}

QToolButton* SectionPanel::toggle(const QString& text, const QString& toolTip, const QString& name) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setCheckable(true);
    button->setToolTip(toolTip);
    button->setAccessibleName(name);
    connect(button, &QToolButton::toggled, this, &SectionPanel::colorToggles);
    return button;
}

QDoubleSpinBox* SectionPanel::angleBox(const QString& prefix, const QString& toolTip, const QString& name) {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(1);
    box->setSingleStep(5);
    box->setPrefix(prefix);
    box->setSuffix(QStringLiteral("°"));
    box->setToolTip(toolTip);
    box->setAccessibleName(name);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] { turn(heading_->value(), tilt_->value()); });
    return box;
}

void SectionPanel::colorToggles() {
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

void SectionPanel::leaveDocument() {
    setProfileShown(false);
    quantity_->setCurrentIndex(0);
    lines_->setChecked(false);
    setAxis(2);
    spin_->setValue(0);
}

/// The section is about as wide as high: the controls stand where they leave the larger square to it, above
/// or at the left. Above, they share one row where it is wide enough.
void SectionPanel::arrange() {
    int row = 0, column = 0, height = 0;
    for (int i = 0; i < controls_->count(); ++i) {
        const QSize size = controls_->itemAt(i)->sizeHint();
        if (size.isEmpty()) continue;  // hidden
        row += size.width() + controls_->spacing();
        column = std::max(column, size.width());
        height += size.height() + controls_->spacing();
    }
    const QRect room = contentsRect().marginsRemoved(whole_->contentsMargins());
    const bool oneRow = row <= room.width();
    const int above =
        readout_->fontMetrics().height() + whole_->spacing() + (oneRow ? save_->sizeHint().height() : height);
    const auto edge = [this](int width, int height) {
        return SectionView::squareIn({profile_->isHidden() ? width : width / 2, height});
    };
    const bool beside =
        edge(room.width() - column, room.height()) > edge(room.width(), room.height() - above);
    const Arrangement wanted{beside, oneRow && !beside, beside ? column : 0};
    if (std::exchange(arrangement_, wanted) == wanted) return;
    whole_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    controls_->setDirection(wanted.oneRow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    readout_->setWordWrap(beside);
    readout_->setAlignment(beside ? Qt::AlignTop : Qt::AlignVCenter);
    // Nor must a long text make it wider.
    readout_->setSizePolicy(QSizePolicy::Ignored, beside ? QSizePolicy::Ignored : QSizePolicy::Preferred);
    side_->setMinimumWidth(wanted.column);
    side_->setMaximumWidth(beside ? column : QWIDGETSIZE_MAX);
}

void SectionPanel::resizeEvent(QResizeEvent* event) {
    arrange();
    QWidget::resizeEvent(event);
}

void SectionPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) colorToggles();
    QWidget::changeEvent(event);
}

double SectionPanel::position() const { return spin_->value(); }

bool SectionPanel::upToDate() const {
    return pending_ == 0 && (profile_->isHidden() || profile_->upToDate());
}

bool SectionPanel::settled() const {
    // Behind another tab a panel is visible all the same, but never painted.
    return visibleRegion().isEmpty() || (upToDate() && view_->settled());
}

SectionPlane SectionPanel::plane() const {
    if (axis_ != freePlane) return SectionPlane::across(axis_, spin_->value());
    glm::dvec3 center{0};
    if (const auto shape = surface()) {
        const Bounds bounds = containerBounds(shape->settings().container);
        center = 0.5 * bounds.low + 0.5 * bounds.high;
    }
    return SectionPlane::turned(center, heading_->value(), tilt_->value(), spin_->value());
}

std::shared_ptr<const Isosurface> SectionPanel::surface() const {
    const int index = surfaces_->currentIndex();
    if (!scene_ || index < 0 || index >= static_cast<int>(scene_->isosurfaces.size())) return nullptr;
    return scene_->isosurfaces[static_cast<std::size_t>(index)].shape;
}

const SceneIsosurface* SectionPanel::subject() const {
    if (!surface() || !slider_->isEnabled()) return nullptr;
    return &scene_->isosurfaces[static_cast<std::size_t>(surfaces_->currentIndex())];
}

std::size_t SectionPanel::subjectNumber() const {
    return subject() ? static_cast<std::size_t>(surfaces_->currentIndex())
                     : std::numeric_limits<std::size_t>::max();
}

void SectionPanel::markPlace(const glm::dvec3& place, const QString& label, const QColor& color) {
    view_->markPlace(SectionView::MarkedPlace{place, label, color});
}

void SectionPanel::unmarkPlace() { view_->markPlace({}); }

bool SectionPanel::eventFilter(QObject* watched, QEvent* event) {
    // A control has come, gone or another size.
    if (watched == side_ && event->type() == QEvent::LayoutRequest) arrange();
    constexpr double clickReach = 9;
    if (watched != view_ || event->type() != QEvent::MouseButtonPress)
        return QWidget::eventFilter(watched, event);
    const auto* press = static_cast<QMouseEvent*>(event);
    const auto at = view_->markPixel();
    const bool onMark = at && press->button() == Qt::LeftButton && press->modifiers() == Qt::NoModifier &&
                        QLineF(*at, press->position()).length() <= clickReach;
    if (onMark) goToMark();
    return onMark;
}

/// The plane moves along its normal until it passes through the marked place.
void SectionPanel::goToMark() {
    const auto& mark = view_->markedPlace();
    if (!mark) return;
    const SectionPlane now = plane();
    const glm::dvec2 foot = now.footOf(mark->place);
    setPosition(position() + glm::dot(mark->place - now.at(foot.x, foot.y), now.normal()));
}

void SectionPanel::setScene(std::shared_ptr<const Scene> scene) {
    adopting_ = true;
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    adoptContainer();
    adopting_ = false;
}

SectionPanel::State SectionPanel::state() const {
    // The angles of a plane across an axis mean nothing.
    const bool free = axis_ == freePlane;
    return {surfaces_->currentIndex(), axis_, spin_->value(), free ? heading_->value() : 0,
            free ? tilt_->value() : 0};
}

void SectionPanel::showState(const State& state) {
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

bool SectionPanel::isDragging() const { return slider_->isSliderDown(); }

void SectionPanel::adoptContainer() {
    if (const auto shape = surface()) {
        const SectionTravel travel = travelOf(plane(), shape->settings().container);
        low_ = travel.low;
        high_ = travel.high;
    }
    const bool usable = surface() && std::isfinite(low_) && std::isfinite(high_) && low_ < high_;
    for (QWidget* widget : std::initializer_list<QWidget*>{slider_, spin_, angles_, line_, save_})
        widget->setEnabled(usable);
    if (usable) {
        const QSignalBlocker blocked(spin_);
        spin_->setDecimals(decimalsFor(high_ - low_));
        spin_->setRange(low_, high_);
        spin_->setSingleStep((high_ - low_) / 50);
        setPosition(spin_->value());
    } else {
        ++generation_;
        pending_ = 0;  // what is being sampled is of no use any more
        refineTimer_.stop();
        view_->show({});
        updateProfile();
        describePlane();
        emit planeChanged();
    }
}

void SectionPanel::choosePlane(int id) {
    if (id != freePlane) return setAxis(id);
    setFree();
    emit freed();
}

void SectionPanel::setAxis(int axis) {
    const auto shape = surface();
    // From a free plane to one through the same middle.
    const double middle = shape && axis_ == freePlane
                              ? plane().middle(shape->settings().container)[std::clamp(axis, 0, 2)]
                              : spin_->value();
    axis_ = std::clamp(axis, 0, 2);
    axes_->button(axis_)->setChecked(true);
    angles_->hide();
    spin_->setToolTip(tr("The %1 of the plane").arg(axisName(axis_)));
    view_->setLine({});
    const QSignalBlocker blocked(spin_);
    spin_->setRange(std::min(spin_->minimum(), middle), std::max(spin_->maximum(), middle));
    spin_->setValue(middle);
    adoptContainer();
}

void SectionPanel::setFree() {
    if (axis_ == freePlane) return;
    const SectionPlane before = plane();
    // With the same sides to the right and up.
    constexpr PlaneAngles angles[] = {{-90, 0}, {0, -90}, {0, 0}};
    const PlaneAngles start = angles[axis_];
    axis_ = freePlane;
    axes_->button(freePlane)->setChecked(true);
    angles_->show();
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
    view_->setLine({});
    adoptContainer();
}

void SectionPanel::turn(double heading, double tilt) {
    if (!std::isfinite(heading) || !std::isfinite(tilt)) return;
    setFree();
    const QSignalBlocker blockedHeading(heading_), blockedTilt(tilt_);
    heading_->setValue(std::remainder(heading, 360));
    tilt_->setValue(tilt);
    adoptContainer();
}

void SectionPanel::turnTowards(const glm::dvec3& normal) {
    setFree();
    const PlaneAngles angles = anglesOf(normal, heading_->value());
    turn(angles.heading, angles.tilt);
}

void SectionPanel::setPosition(double position) {
    const QSignalBlocker blockedSpin(spin_), blockedSlider(slider_);
    spin_->setValue(position);
    slider_->setValue(static_cast<int>(std::lround((spin_->value() - low_) / (high_ - low_) * sliderSteps)));
    sample(liveResolution());
    refineTimer_.start();
    updateProfile();
    emit planeChanged();
}

void SectionPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refineTimer_.start();
}

/// All samples at once where the function is cheap enough, so that nothing sharpens late.
int SectionPanel::liveResolution() const {
    return millisecondsPerSample_ * fineResolution * fineResolution <= liveBudget ? fineResolution
                                                                                  : coarseResolution;
}

void SectionPanel::sample(int resolution) {
    const auto shape = surface();
    if (!shape || !isVisible()) return;
    const SectionRequest request{shape, scene_->parameterTable, plane(), resolution, quantity()};
    const std::uint64_t generation = ++generation_;
    pending_ = 1;
    worker_.submit([this, request, generation](std::stop_token stop) {
        SectionField field = sampleSection(request, stop);
        if (stop.stop_requested()) return;
        QMetaObject::invokeMethod(
            this,
            [this, generation, field = std::move(field)]() mutable {
                if (generation == generation_) pending_ = 0;
                receive(std::move(field));
            },
            Qt::QueuedConnection);
    });
}

void SectionPanel::receive(SectionField field) {
    // One that was being sampled when the surface went.
    if (!surface() || (field.plane.axis() != plane().axis() && !field.empty())) return;
    const double milliseconds = field.milliseconds;
    if (!field.empty()) millisecondsPerSample_ = milliseconds / static_cast<double>(field.values.size());
    const bool first = view_->field().empty();
    view_->show(std::move(field));
    if (first) updateProfile();
    describePlane();
    view_->tellHover();
    emit sampled(milliseconds);
}

void SectionPanel::setProfileShown(bool shown) {
    line_->setChecked(shown);
    profile_->setVisible(shown);
    view_->setLineTool(shown);
    updateProfile();
}

void SectionPanel::updateProfile() {
    if (profile_->isHidden()) return;
    const auto shape = surface();
    if (!shape || !slider_->isEnabled()) return profile_->setLine({}, quantity());
    const SectionPlane cut = plane();
    if (!view_->line()) {
        const SectionRectangle r = rectangleOf(cut, shape->settings().container);
        const double height = (r.bottom + r.top) / 2;
        view_->setLine(SectionLine{{r.left, height}, {r.right, height}});
    }
    const SectionLine& line = *view_->line();
    profile_->setLine({shape, scene_->parameterTable, cut.at(line.from.x(), line.from.y()),
                       cut.at(line.to.x(), line.to.y())},
                      quantity());
}

void SectionPanel::describePlane() {
    const SectionField& field = view_->field();
    if (field.empty()) {
        readout_->setText(scene_ && !scene_->isosurfaces.empty() ? tr("The container has no finite extent.")
                                                                 : tr("The scene has no isosurface to cut."));
        return;
    }
    const SectionPlane& cut = field.plane;
    const QString where =
        cut.isFree()
            ? tr("through %1 across %2").arg(pointText(cut.middle(field.container)), pointText(cut.normal()))
            : tr("at %1 = %2").arg(axisName(cut.axis()), shortNumber(cut.position()));
    const bool gradient = field.quantity() == SectionQuantity::gradient;
    QString text = gradient ? tr("|∇f| %1; up to %2 here, max_gradient is %3")
                                  .arg(where, shortNumber(field.steepest), shortNumber(field.maxGradient))
                            : tr("f − threshold %1").arg(where);
    if (field.undefined) text += tr("; hatched where f is undefined");
    readout_->setText(text);
}

void SectionPanel::describe(double horizontal, double vertical, std::size_t index) {
    const SectionField& field = view_->field();
    const auto text = [this](float value) {
        return std::isnan(value) ? tr("undefined") : QString::number(value, 'g', 5);
    };
    QString all = tr("%1: f − threshold = %2")
                      .arg(pointText(field.plane.at(horizontal, vertical)), text(field.values[index]));
    if (field.quantity() == SectionQuantity::gradient)
        all += tr(", |∇f| = %1").arg(text(field.slopes[index]));
    readout_->setText(all);
}

SectionQuantity SectionPanel::quantity() const {
    return quantity_->currentIndex() == 1 ? SectionQuantity::gradient : SectionQuantity::value;
}

void SectionPanel::setQuantity(SectionQuantity quantity) {
    quantity_->setCurrentIndex(quantity == SectionQuantity::gradient ? 1 : 0);
}

QString SectionPanel::table() const { return sectionTable(view_->field()); }

void SectionPanel::save(bool picture) {
    const QString suffix = picture ? QStringLiteral("png") : QStringLiteral("csv");
    const QString path =
        chooseSavePath(this, picture ? tr("Save Section") : tr("Save Numbers"),
                       pathInDocuments(QStringLiteral("section.") + suffix),
                       picture ? tr("PNG pictures (*.png)") : tr("CSV tables (*.csv)"), suffix);
    if (path.isEmpty()) return;
    bool written = false;
    if (picture)
        written = view_->parentWidget()->grab().save(path, "PNG");
    else
        written = saveText(table(), path);
    emit said(written ? tr("Saved %1.").arg(path) : tr("%1 cannot be written.").arg(path));
}

}  // namespace isoscope
