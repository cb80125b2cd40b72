// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/ray_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "core/study/view/point_probe.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/look.h"
#include "widgets/section/surface_chooser.h"
#include "widgets/studies/ray_explanation.h"

namespace isoscope {

namespace {

constexpr int curvePoints = 4096;
/// The view can be no smaller than this share of the ray.
constexpr double finestZoom = 1.0 / 2000;
/// Cones of more samples than these would only cover each other.
constexpr std::size_t coneLimit = 600;

/// The first isosurface that the ray meets; the first one whose container it meets when there is none.
std::size_t nearestOf(const std::vector<RayProfile>& profiles) {
    std::size_t best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    bool any = false;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const RayProfile& profile = profiles[i];
        if (profile.meetsContainer && !any) best = i;
        any = any || profile.meetsContainer;
        if (profile.certifiedRoots.empty() || profile.certifiedRoots.front().t >= nearest) continue;
        nearest = profile.certifiedRoots.front().t;
        best = i;
    }
    return best;
}

struct RayColors {
    QColor curve, povray, wrong, certain, pruned, zero;

    explicit RayColors(const QPalette& palette) {
        const Look look = lookOf(palette);
        curve = palette.color(QPalette::Text);
        povray = lookColor(look, 0xc85c0a, 0xe8832a);
        wrong = lookColor(look, 0xd0101c, 0xff4d4d);
        certain = lookColor(look, 0x215eb7, 0x4a94f5);
        pruned = lookColor(look, 0x7a828c, 0x8f98a3);
        zero = curve;
        zero.setAlpha(120);
    }
};

}  // namespace

RayPanel::RayPanel(QWidget* parent) : StudyPanel(parent) {
    buildControls();
    connect(surfaces_, &SurfaceChooser::activated, this, &RayPanel::measure);
    for (QCheckBox* box : {cones_, enclosures_}) connect(box, &QCheckBox::toggled, this, &RayPanel::refresh);
    connect(chart_, &ChartView::rangeRequested, this, &RayPanel::setRange);
    connect(chart_, &ChartView::wholeRangeRequested, this, [this] { setRange(profile_.near, profile_.far); });
    connect(chart_, &ChartView::hovered, this, &RayPanel::describeHover);
    connect(chart_, &ChartView::hoverEnded, this, [this] {
        readout_->clear();
        emit probeEnded();
    });
    refresh();
}

RayPanel::~RayPanel() { stop_.request_stop(); }

void RayPanel::buildControls() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    surfaces_ = new SurfaceChooser(tr("The isosurface that is shown along the ray."), tr("The one in front"));
    row->addWidget(surfaces_);
    cones_ = new QCheckBox(tr("Cones"));
    cones_->setChecked(true);
    cones_->setToolTip(
        tr("What POV-Ray trusts: from each of its samples, how soon a function no steeper than max_gradient "
           "could "
           "reach the threshold. Between two cones that do not meet it, it looks no closer."));
    cones_->setAccessibleName(tr("Show the cones of max_gradient"));
    row->addWidget(cones_);
    enclosures_ = new QCheckBox(tr("Enclosures"));
    enclosures_->setToolTip(
        tr("How the exact picture finds the surface: the pieces in which the certified root finder encloses "
           "the function."));
    enclosures_->setAccessibleName(tr("Show the enclosures of the exact picture"));
    row->addWidget(enclosures_);
    readout_ = new QLabel;
    readout_->setTextFormat(Qt::PlainText);
    readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    readout_->setAccessibleDescription(tr("Value under the mouse"));
    row->addWidget(readout_, 1);
    save_ = new ChartSaver({[this] { return QList<Chart>{chart_->chart()}; },
                            [this] { return chartTable(chart_->chart()); }, tr("ray")});
    connect(save_, &ChartSaver::said, this, &RayPanel::said);
    row->addWidget(save_);
    chart_ = new ChartView;
    chart_->setZoomable(true);
    chart_->setProbing(true);
    chart_->setAccessibleName(tr("The function along the ray"));
    chart_->setToolTip(
        tr("f − threshold along the ray; wheel to zoom, drag to shift, double-click for the "
           "whole ray"));
    column->addWidget(chart_, 1);
    explanation_ = new QLabel;
    explanation_->setTextFormat(Qt::PlainText);
    explanation_->setWordWrap(true);
    explanation_->setAccessibleDescription(tr("What happens along the ray"));
    column->addWidget(explanation_);
}

QString RayPanel::explanation() const { return explanation_->text(); }

void RayPanel::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    measure();
}

void RayPanel::setActive(bool active) {
    if (std::exchange(active_, active) == active) return;
    if (active && std::exchange(missed_, false)) measure();
}

void RayPanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    measure();
}

void RayPanel::setPixel(std::optional<QPointF> place) {
    pixel_ = place;
    pictured_.reset();
    measure();
}

void RayPanel::setPictured(std::optional<HolePixel> kind) {
    if (kind == pictured_) return;
    pictured_ = kind;
    describe();
}

void RayPanel::measure() {
    stop_.request_stop();
    const std::uint64_t generation = ++generation_;
    if (!scene_ || !pixel_ || scene_->isosurfaces.empty()) {
        pending_ = 0;
        missed_ = false;
        profile_ = {};
        refresh();
        return;
    }
    if (!active_) {
        pending_ = 0;
        missed_ = true;
        return;
    }
    pending_ = 1;
    const Ray ray = camera_.ray(pixel_->x() - 0.5, 0.5 - pixel_->y());
    const int chosen = surfaces_->currentIndex() - 1;
    stop_ = std::stop_source();
    worker_.submit(
        [this, scene = scene_, ray, chosen, generation, stop = stop_.get_token()](std::stop_token) {
            std::vector<RayProfile> profiles;
            const std::size_t count = scene->isosurfaces.size();
            const auto only = static_cast<std::size_t>(std::max(0, chosen));
            for (std::size_t i = chosen < 0 ? 0 : only; i < (chosen < 0 ? count : only + 1); ++i) {
                if (stop.stop_requested()) return;
                profiles.push_back(profileOf(*scene, i, ray, curvePoints, stop));
            }
            if (stop.stop_requested()) return;
            Found found;
            found.ray = ray;
            const std::size_t nearest = nearestOf(profiles);
            found.isosurface = chosen < 0 ? nearest : only;
            if (!profiles.empty()) found.profile = std::move(profiles[nearest]);
            QMetaObject::invokeMethod(
                this,
                [this, generation, found = std::move(found)]() mutable {
                    if (generation == generation_) receive(std::move(found));
                },
                Qt::QueuedConnection);
        });
}

void RayPanel::receive(Found found) {
    pending_ = 0;
    const bool sameEnds = found.profile.near == profile_.near && found.profile.far == profile_.far;
    profile_ = std::move(found.profile);
    ray_ = found.ray;
    isosurface_ = found.isosurface;
    // A slider that moves leaves the zoom alone.
    if (!sameEnds) {
        low_ = profile_.near;
        high_ = profile_.far;
    }
    refresh();
}

void RayPanel::setRange(double low, double high) {
    const double length = profile_.far - profile_.near;
    const double wanted = std::clamp(high - low, length * finestZoom, length);
    const double middle = (low + high) / 2;
    low_ = std::clamp(middle - wanted / 2, profile_.near, profile_.far - wanted);
    high_ = low_ + wanted;
    refresh();
}

void RayPanel::refresh() {
    Chart chart;
    chart.empty = !scene_ || scene_->isosurfaces.empty()
                      ? tr("The scene has no isosurface.")
                      : tr("Switch “Ray” on above the picture and click a pixel.");
    if (pixel_ && scene_ && !scene_->isosurfaces.empty() && !profile_.meetsContainer)
        chart.empty = tr("This ray passes the container by.");
    if (profile_.meetsContainer) {
        addCurves(chart);
        if (enclosures_->isChecked()) addEnclosures(chart);
        addPovray(chart);
    }
    chart.title = tr("f − threshold along the ray");
    chart_->setChart(std::move(chart));
    save_->setEnabled(profile_.meetsContainer);
    describe();
}

void RayPanel::addCurves(Chart& chart) const {
    const RayColors colors(palette());
    ChartSeries curve{tr("f − threshold"), colors.curve, ChartSeries::Shape::line, {}, 2, false};
    std::vector<double> visible{0};
    for (const ProfilePoint& point : profile_.curve) {
        curve.points.push_back({point.t, point.value});
        if (point.t >= low_ && point.t <= high_) visible.push_back(point.value);
    }
    chart.x = {tr("distance from the camera"), low_, high_, false, 0};
    chart.y = axisOver({}, visible, false);
    chart.series << ChartSeries{{}, colors.zero, ChartSeries::Shape::line, {{low_, 0}, {high_, 0}}, 1, false};
    chart.series << curve;
    const auto first = [](const RootList& roots) { return roots.empty() ? std::nan("") : roots.front().t; };
    const double certified = first(profile_.certifiedRoots), povray = first(profile_.povray.roots);
    if (std::isfinite(certified))
        chart.marks << ChartMark{certified, tr("surface %1").arg(certified, 0, 'g', 5), colors.certain};
    if (std::isfinite(povray))
        chart.marks << ChartMark{povray, tr("POV-Ray %1").arg(povray, 0, 'g', 5), colors.povray};
}

void RayPanel::addEnclosures(Chart& chart) const {
    QColor color = RayColors(palette()).certain;
    color.setAlpha(170);
    ChartSeries pieces{tr("enclosure"), color, ChartSeries::Shape::segments, {}, 1, false};
    for (const RayEnclosure& e : profile_.enclosures) {
        const QPointF corners[] = {
            {e.begin, e.lowAtBegin}, {e.end, e.lowAtEnd}, {e.end, e.highAtEnd}, {e.begin, e.highAtBegin}};
        for (int i = 0; i < 4; ++i) {
            pieces.points.push_back(corners[i]);
            pieces.points.push_back(corners[(i + 1) % 4]);
        }
    }
    chart.series << pieces;
}

void RayPanel::addPovray(Chart& chart) const {
    const RayColors colors(palette());
    QColor faint = colors.povray;
    faint.setAlpha(110);
    ChartSeries cones{{}, faint, ChartSeries::Shape::segments, {}, 1, false};
    ChartSeries samples{tr("POV-Ray's samples"), colors.povray, ChartSeries::Shape::points, {}, 5, false};
    for (const ProfilePoint& point : profile_.povray.visited) {
        samples.points.push_back({point.t, point.value});
        const double reach = std::abs(point.value) / profile_.maxGradient;
        if (!std::isfinite(reach) || cones.points.size() >= 4 * coneLimit) continue;
        for (const double side : {-reach, reach}) {
            cones.points.push_back({point.t, point.value});
            cones.points.push_back({point.t + side, 0});
        }
    }
    // Along the threshold; neighbours are told apart by a gap.
    ChartSeries pruned{tr("dismissed"), colors.pruned, ChartSeries::Shape::segments, {}, 5, false};
    ChartSeries wrong{tr("dismissed wrongly"), colors.wrong, ChartSeries::Shape::segments, {}, 7, false};
    const double gap = (high_ - low_) / 600;
    for (const SearchedInterval& interval : profile_.povray.intervals) {
        if (interval.fate != IntervalFate::pruned && interval.fate != IntervalFate::undefined) continue;
        const double inset = std::min(gap, (interval.high - interval.low) / 4);
        ChartSeries& series = profile_.wronglyPruned(interval) ? wrong : pruned;
        series.points.push_back({interval.low + inset, 0});
        series.points.push_back({interval.high - inset, 0});
    }
    if (cones_->isChecked()) chart.series << cones;
    for (const ChartSeries& series : {pruned, wrong, samples})
        if (!series.points.empty()) chart.series << series;
}

void RayPanel::describe() {
    explanation_->setText(profile_.meetsContainer ? rayExplanation(profile_, pictured_) : QString());
    explanation_->setVisible(profile_.meetsContainer);
}

void RayPanel::describeHover(QPointF values) {
    const auto& curve = profile_.curve;
    if (curve.size() < 2) return;
    const double share = (values.x() - profile_.near) / (profile_.far - profile_.near);
    const auto last = static_cast<double>(curve.size() - 1);
    const auto index = static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * last));
    const double value = curve[index].value;
    readout_->setText(tr("at %1: %2")
                          .arg(values.x(), 0, 'g', 5)
                          .arg(std::isnan(value) ? tr("undefined") : QString::number(value, 'g', 4)));
    chart_->setAccessibleDescription(readout_->text());
    if (!scene_ || isosurface_ >= scene_->isosurfaces.size()) return;
    const glm::dvec3 there = ray_.origin + values.x() * ray_.direction;
    emit probed(isosurface_, scene_->isosurfaces[isosurface_].transform.inversePoint(there));
}

void RayPanel::showProbe(const ProbedPoint* point) {
    if (!point || !profile_.meetsContainer) return chart_->setCursorLine({});
    chart_->setCursorLine(std::clamp(nearestOnRay(ray_, point->inScene), profile_.near, profile_.far));
}

void RayPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace isoscope
