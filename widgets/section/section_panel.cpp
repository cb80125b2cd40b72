// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_panel.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <QEvent>
#include <QLabel>
#include <QLineF>
#include <QMenu>
#include <QMouseEvent>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "core/study/view/point_probe.h"
#include "core/study/view/surface_distance.h"
#include "widgets/charts/chart_file.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/document/save_path.h"
#include "widgets/section/section_profile.h"
#include "widgets/section/section_view.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

constexpr int coarseResolution = 192;
constexpr int sentenceWidth = 240;
/// Sampling while a slider moves should take no longer than this, in milliseconds.
constexpr double liveBudget = 14;

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

SectionPanel::SectionPanel(QWidget* parent) : StudyPanel(parent), controls_(new SectionControls) {
    buildPlots();
    connectControls();
    refineTimer_.setSingleShot(true);
    refineTimer_.setInterval(timing::settlePause);
    connect(&refineTimer_, &QTimer::timeout, this, [this] { sample(fineResolution); });
    connect(view_, &SectionView::hovered, this, &SectionPanel::describe);
    connect(view_, &SectionView::hoverEnded, this, &SectionPanel::describePlane);
    connect(view_, &SectionView::hoverEnded, this, &SectionPanel::probeEnded);
    view_->installEventFilter(this);
    connect(view_, &SectionView::lineChanged, this, &SectionPanel::updateProfile);
    connect(profile_, &SectionProfile::hovered, this, [this](double share) {
        view_->markLine(share);
        probe(profile_->samples().at(share));
    });
    connect(profile_, &SectionProfile::hoverEnded, this, [this] {
        view_->markLine({});
        emit probeEnded();
    });
    describePlane();
}

SectionPanel::~SectionPanel() = default;

void SectionPanel::buildPlots() {
    whole_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
    whole_->setContentsMargins(6, 6, 6, 6);
    whole_->setSpacing(4);
    view_ = new SectionView;
    view_->setToolTip(
        tr("f − threshold on the plane: blue is inside, orange outside, the bold line is the surface.\n"
           "|∇f|: red where it is steeper than max_gradient.\n"
           "distance: (f − threshold) ÷ |∇f|, how far the surface is, to first order.\n"
           "Drag to move, wheel to zoom, double-click to see all. Hatched: f is undefined."));
    side_ = new QWidget;
    auto* side = new QVBoxLayout(side_);
    side->setContentsMargins(0, 0, 0, 0);
    side->setSpacing(4);
    side->addWidget(controls_);
    controls_->installEventFilter(this);
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

void SectionPanel::connectControls() {
    connect(controls_, &SectionControls::moved, this, &SectionPanel::followPlane);
    connect(controls_, &SectionControls::emptied, this, &SectionPanel::showNothing);
    connect(controls_, &SectionControls::directionChanged, this, [this] { view_->setLine({}); });
    connect(controls_, &SectionControls::quantityChanged, this, [this] {
        sample(liveResolution());
        refineTimer_.start();
    });
    connect(controls_, &SectionControls::linesToggled, view_, &SectionView::setLinesShown);
    connect(controls_, &SectionControls::bandChanged, view_, &SectionView::setBand);
    connect(controls_, &SectionControls::profileToggled, this, &SectionPanel::setProfileShown);
    connect(controls_, &SectionControls::dragFinished, this, &SectionPanel::dragFinished);
    connect(controls_, &SectionControls::freed, this, &SectionPanel::freed);
    connect(controls_, &SectionControls::pictureRequested, this, [this] { save(true); });
    connect(controls_, &SectionControls::numbersRequested, this, [this] { save(false); });
    auto* saver = new ChartSaver({[this] { return QList<Chart>{profile_->chart()->chart()}; },
                                  [this] { return chartTable(profile_->chart()->chart()); }, tr("profile")},
                                 this);
    saver->hide();
    connect(saver, &ChartSaver::said, this, &SectionPanel::said);
    QMenu* menu = controls_->profileMenu();
    menu->addActions(saver->menu()->actions());
    connect(qobject_cast<QMenu*>(menu->parentWidget()), &QMenu::aboutToShow, menu,
            [this, menu] { menu->setEnabled(!profile_->isHidden() && !profile_->samples().empty()); });
}

void SectionPanel::leaveDocument() {
    setProfileShown(false);
    controls_->reset();
}

/// The section is about as wide as high: the controls stand where they leave the larger square to it, above
/// or at the left. Above, they share one row where it is wide enough.
void SectionPanel::arrange() {
    const SectionControls::Extent extent = controls_->extent();
    // Without controls there is a sentence.
    const int column = extent.column > 0 ? extent.column : sentenceWidth;
    const QRect room = contentsRect().marginsRemoved(whole_->contentsMargins());
    const bool oneRow = extent.row <= room.width();
    const int above = readout_->fontMetrics().height() + whole_->spacing() +
                      (oneRow ? extent.rowHeight : extent.columnHeight);
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

double SectionPanel::position() const { return controls_->position(); }

bool SectionPanel::upToDate() const {
    return pending_ == 0 && (profile_->isHidden() || profile_->upToDate());
}

bool SectionPanel::settled() const {
    // Behind another tab a panel is visible all the same, but never painted.
    return visibleRegion().isEmpty() || (upToDate() && view_->settled());
}

SectionPlane SectionPanel::plane() const { return controls_->plane(); }

const SceneIsosurface* SectionPanel::subject() const { return controls_->subject(); }

std::size_t SectionPanel::subjectNumber() const {
    return subject() ? static_cast<std::size_t>(controls_->surfaceIndex())
                     : std::numeric_limits<std::size_t>::max();
}

void SectionPanel::markPlace(const glm::dvec3& place, const QString& label, const QColor& color) {
    view_->markPlace(SectionView::MarkedPlace{place, label, color});
}

void SectionPanel::unmarkPlace() { view_->markPlace({}); }

void SectionPanel::probe(const glm::dvec3& place) {
    if (subject()) emit probed(subjectNumber(), place);
}

void SectionPanel::showProbe(const ProbedPoint* point) {
    std::optional<glm::dvec3> place;
    if (point && subject())
        place = point->isosurface == subjectNumber() ? point->place
                                                     : subject()->transform.inversePoint(point->inScene);
    view_->showProbe(place);
    profile_->showProbe(place);
    if (!place || !view_->hovering() || point->isosurface != subjectNumber()) return;
    tellValue(point->place, point->value - point->threshold, point->slope);
}

bool SectionPanel::eventFilter(QObject* watched, QEvent* event) {
    // A control has come, gone or another size.
    if (watched == controls_ && event->type() == QEvent::LayoutRequest) arrange();
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
    controls_->setScene(std::move(scene));
    adopting_ = false;
}

SectionPanel::State SectionPanel::state() const { return controls_->state(); }

void SectionPanel::showState(const State& state) { controls_->showState(state); }

bool SectionPanel::isDragging() const { return controls_->isDragging(); }

void SectionPanel::setAxis(int axis) { controls_->setAxis(axis); }

void SectionPanel::setFree() { controls_->setFree(); }

void SectionPanel::turn(double heading, double tilt) { controls_->turn(heading, tilt); }

void SectionPanel::turnTowards(const glm::dvec3& normal) { controls_->turnTowards(normal); }

void SectionPanel::setPosition(double position) { controls_->setPosition(position); }

void SectionPanel::followPlane() {
    sample(liveResolution());
    refineTimer_.start();
    updateProfile();
    emit planeChanged();
}

void SectionPanel::showNothing() {
    ++generation_;
    pending_ = 0;  // what is being sampled is of no use any more
    refineTimer_.stop();
    view_->show({});
    updateProfile();
    describePlane();
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
    const auto shape = controls_->surface();
    if (!shape || !isVisible()) return;
    const SectionRequest request{shape, controls_->scene()->parameterTable, plane(), resolution, quantity()};
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
    if (!controls_->surface() || (field.plane.axis() != plane().axis() && !field.empty())) return;
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
    controls_->setProfileChosen(shown);
    profile_->setVisible(shown);
    view_->setLineTool(shown);
    updateProfile();
}

void SectionPanel::updateProfile() {
    if (profile_->isHidden()) return;
    if (!subject()) return profile_->setLine({}, quantity());
    const auto& shape = subject()->shape;
    const SectionPlane cut = plane();
    if (!view_->line()) {
        const SectionRectangle r = rectangleOf(cut, shape->settings().container);
        const double height = (r.bottom + r.top) / 2;
        view_->setLine(SectionLine{{r.left, height}, {r.right, height}});
    }
    const SectionLine& line = *view_->line();
    profile_->setLine({shape, controls_->scene()->parameterTable, cut.at(line.from.x(), line.from.y()),
                       cut.at(line.to.x(), line.to.y())},
                      quantity());
}

void SectionPanel::describePlane() {
    const SectionField& field = view_->field();
    if (field.empty()) {
        const auto& scene = controls_->scene();
        readout_->setText(scene && !scene->isosurfaces.empty() ? tr("The container has no finite extent.")
                                                               : tr("The scene has no isosurface to cut."));
        return;
    }
    const SectionPlane& cut = field.plane;
    const QString where =
        cut.isFree()
            ? tr("through %1 across %2").arg(pointText(cut.middle(field.container)), pointText(cut.normal()))
            : tr("at %1 = %2").arg(axisName(cut.axis()), shortNumber(cut.position()));
    QString text = tr("f − threshold %1").arg(where);
    if (field.quantity == SectionQuantity::gradient)
        text = tr("|∇f| %1; up to %2 here, max_gradient is %3")
                   .arg(where, shortNumber(field.steepest), shortNumber(field.maxGradient));
    if (field.quantity == SectionQuantity::distance) text = tr("distance to the surface %1").arg(where);
    if (field.undefined) text += tr("; hatched where f is undefined");
    readout_->setText(text);
}

void SectionPanel::describe(double horizontal, double vertical, std::size_t index) {
    const SectionField& field = view_->field();
    const glm::dvec3 place = field.plane.at(horizontal, vertical);
    // The nearest sample, until the place itself is known.
    tellValue(place, field.values[index],
              field.slopes.empty() ? std::nullopt : std::optional<double>(field.slopes[index]));
    probe(place);
}

void SectionPanel::tellValue(const glm::dvec3& place, double value, std::optional<double> slope) {
    const auto text = [](double number) {
        return std::isnan(number) ? tr("undefined") : QString::number(number, 'g', 5);
    };
    QString all = tr("%1: f − threshold = %2").arg(pointText(place), text(value));
    const SectionQuantity shown = view_->field().quantity;
    if (slope && shown != SectionQuantity::value) all += tr(", |∇f| = %1").arg(text(*slope));
    if (slope && shown == SectionQuantity::distance)
        all += tr(", distance = %1").arg(text(surfaceDistance(value, *slope)));
    readout_->setText(all);
    view_->setAccessibleDescription(all);
}

SectionQuantity SectionPanel::quantity() const { return controls_->quantity(); }

void SectionPanel::setQuantity(SectionQuantity quantity) { controls_->setQuantity(quantity); }

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
        written = savePicture(view_->parentWidget()->grab().toImage(), path);
    else
        written = saveText(table(), path);
    emit said(written ? tr("Saved %1.").arg(path) : tr("%1 cannot be written.").arg(path));
}

}  // namespace isoscope
