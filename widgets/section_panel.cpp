// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section_panel.h"

#include <algorithm>
#include <cmath>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/section_view.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

constexpr int sliderSteps = 1000;
constexpr int liveResolution = 192;
constexpr int fineResolution = 512;
constexpr int positionDecimals = 4;

QString axisName(int axis) { return QString(QLatin1Char("xyz"[axis])); }

}  // namespace

SectionPanel::SectionPanel(QWidget* parent) : QWidget(parent) {
    buildControls();
    refineTimer_.setSingleShot(true);
    refineTimer_.setInterval(timing::settlePause);
    connect(&refineTimer_, &QTimer::timeout, this, [this] { sample(fineResolution); });
    connect(view_, &SectionView::hovered, this, &SectionPanel::describe);
    connect(view_, &SectionView::hoverEnded, this, &SectionPanel::describePlane);
    setAxis(2);
}

SectionPanel::~SectionPanel() = default;

void SectionPanel::buildControls() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    layout->addLayout(row);

    surfaces_ = new QComboBox;
    surfaces_->setToolTip(tr("The isosurface whose function is shown"));
    surfaces_->setAccessibleName(tr("Isosurface"));
    surfaces_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    surfaces_->hide();
    connect(surfaces_, &QComboBox::activated, this, [this] { adoptContainer(); });
    row->addWidget(surfaces_);

    axes_ = new QButtonGroup(this);
    for (int axis = 0; axis < 3; ++axis) {
        auto* button = new QToolButton;
        button->setText(axisName(axis));
        button->setCheckable(true);
        button->setToolTip(
            tr("Cut at a constant %1 (in the function's own coordinates)").arg(axisName(axis)));
        button->setAccessibleName(tr("Plane across the %1 axis").arg(axisName(axis)));
        axes_->addButton(button, axis);
        row->addWidget(button);
    }
    connect(axes_, &QButtonGroup::idClicked, this, &SectionPanel::setAxis);
    connect(axes_, &QButtonGroup::idToggled, this, &SectionPanel::colorAxes);

    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(0, sliderSteps);
    slider_->setToolTip(tr("Where the plane lies; the ends are the container's walls"));
    slider_->setAccessibleName(tr("Position of the plane"));
    row->addWidget(slider_, 1);
    spin_ = new QDoubleSpinBox;
    spin_->setDecimals(positionDecimals);
    spin_->setToolTip(tr("Position of the plane"));
    spin_->setAccessibleName(tr("Position of the plane as a number"));
    row->addWidget(spin_);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { setPosition(low_ + (high_ - low_) * step / sliderSteps); });
    connect(spin_, &QDoubleSpinBox::valueChanged, this, &SectionPanel::setPosition);

    quantity_ = new QComboBox;
    quantity_->addItems({tr("f − threshold"), tr("|∇f|")});
    quantity_->setToolTip(tr("What the colours show: the function, or how steep it is"));
    quantity_->setAccessibleName(tr("Quantity that is shown"));
    connect(quantity_, &QComboBox::currentIndexChanged, this, [this] {
        sample(liveResolution);
        refineTimer_.start();
    });
    row->addWidget(quantity_);
    view_ = new SectionView;
    view_->setToolTip(
        tr("f − threshold on the plane: blue is inside, orange outside, the bold line is the surface.\n"
           "|∇f|: red where it is steeper than max_gradient.\n"
           "Drag to move, wheel to zoom, double-click to see all. Hatched: f is undefined."));
    lines_ = new QToolButton;
    lines_->setText(tr("Lines"));
    lines_->setCheckable(true);
    lines_->setToolTip(tr("Thin lines of equal value"));
    lines_->setAccessibleName(tr("Show lines of equal value"));
    connect(lines_, &QToolButton::toggled, view_, &SectionView::setLinesShown);
    connect(lines_, &QToolButton::toggled, this, &SectionPanel::colorAxes);
    row->addWidget(lines_);
    layout->addWidget(view_, 1);
    readout_ = new QLabel;
    readout_->setTextFormat(Qt::PlainText);
    readout_->setAccessibleName(tr("Value of the function under the mouse"));
    layout->addWidget(readout_);
}

void SectionPanel::colorAxes() {
    // Fusion's pressed look is hardly to be seen on a dark window.
    for (QAbstractButton* button : axes_->buttons() + QList<QAbstractButton*>{lines_}) {
        QPalette colors;
        if (button->isChecked()) {
            colors.setColor(QPalette::Button, palette().color(QPalette::Highlight));
            colors.setColor(QPalette::ButtonText, palette().color(QPalette::HighlightedText));
        }
        button->setPalette(colors);
    }
}

void SectionPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) colorAxes();
    QWidget::changeEvent(event);
}

double SectionPanel::position() const { return spin_->value(); }

std::shared_ptr<const Isosurface> SectionPanel::surface() const {
    const int index = surfaces_->currentIndex();
    if (!scene_ || index < 0 || index >= static_cast<int>(scene_->isosurfaces.size())) return nullptr;
    return scene_->isosurfaces[static_cast<std::size_t>(index)].shape;
}

void SectionPanel::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    fillSurfaces();
    adoptContainer();
}

void SectionPanel::fillSurfaces() {
    const int count = scene_ ? static_cast<int>(scene_->isosurfaces.size()) : 0;
    if (surfaces_->count() != count) {
        const int kept = std::clamp(surfaces_->currentIndex(), 0, std::max(0, count - 1));
        surfaces_->clear();
        for (int i = 0; i < count; ++i) surfaces_->addItem(tr("Isosurface %1").arg(i + 1));
        if (count > 0) surfaces_->setCurrentIndex(kept);
        surfaces_->setVisible(count > 1);
    }
}

void SectionPanel::adoptContainer() {
    if (const auto shape = surface()) {
        const Bounds bounds = containerBounds(shape->settings().container);
        low_ = bounds.low[axis_];
        high_ = bounds.high[axis_];
    }
    const bool usable = surface() && std::isfinite(low_) && std::isfinite(high_) && low_ < high_;
    slider_->setEnabled(usable);
    spin_->setEnabled(usable);
    if (usable) {
        const QSignalBlocker blocked(spin_);
        spin_->setRange(low_, high_);
        spin_->setSingleStep((high_ - low_) / 50);
        setPosition(spin_->value());
    } else {
        ++generation_;
        pending_ = 0;  // what is on its way is of no use any more
        refineTimer_.stop();
        view_->show({});
        describePlane();
    }
}

void SectionPanel::setAxis(int axis) {
    axis_ = std::clamp(axis, 0, 2);
    axes_->button(axis_)->setChecked(true);
    adoptContainer();
}

void SectionPanel::setPosition(double position) {
    const QSignalBlocker blockedSpin(spin_), blockedSlider(slider_);
    spin_->setValue(position);
    slider_->setValue(static_cast<int>(std::lround((spin_->value() - low_) / (high_ - low_) * sliderSteps)));
    sample(liveResolution);
    refineTimer_.start();
}

void SectionPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refineTimer_.start();
}

void SectionPanel::sample(int resolution) {
    const auto shape = surface();
    if (!shape || !isVisible()) return;
    const SectionRequest request{shape,     scene_->parameterTable, axis_, spin_->value(), resolution,
                                 quantity()};
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
    // One that was on its way when the surface went.
    if (!surface() || (field.axis != axis_ && !field.empty())) return;
    const double milliseconds = field.milliseconds;
    view_->show(std::move(field));
    describePlane();
    view_->tellHover();
    emit sampled(milliseconds);
}

void SectionPanel::describePlane() {
    const SectionField& field = view_->field();
    if (field.empty()) {
        readout_->setText(scene_ && !scene_->isosurfaces.empty() ? tr("The container has no finite extent.")
                                                                 : tr("The scene has no isosurface to cut."));
        return;
    }
    const bool gradient = field.quantity() == SectionQuantity::gradient;
    QString text =
        gradient ? tr("|∇f| at %1 = %2; up to %3 here, max_gradient is %4")
                       .arg(axisName(field.axis))
                       .arg(field.position, 0, 'g', 4)
                       .arg(field.steepest, 0, 'g', 4)
                       .arg(field.maxGradient, 0, 'g', 4)
                 : tr("f − threshold at %1 = %2").arg(axisName(field.axis)).arg(field.position, 0, 'g', 4);
    if (field.undefined) text += tr("; hatched where f is undefined");
    readout_->setText(text);
}

void SectionPanel::describe(double horizontal, double vertical, std::size_t index) {
    const SectionField& field = view_->field();
    const SectionAxes axes = sectionAxes(field.axis);
    const auto text = [this](float value) {
        return std::isnan(value) ? tr("undefined") : QString::number(value, 'g', 5);
    };
    QString all = tr("%1 = %2, %3 = %4: f − threshold = %5")
                      .arg(axisName(axes.horizontal))
                      .arg(horizontal, 0, 'g', 4)
                      .arg(axisName(axes.vertical))
                      .arg(vertical, 0, 'g', 4)
                      .arg(text(field.values[index]));
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

}  // namespace isoscope
