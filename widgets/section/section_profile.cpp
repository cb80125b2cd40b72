// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_profile.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/charts/chart_view.h"
#include "widgets/look.h"

namespace isoscope {

namespace {

/// Labels of more crossings would cover the curve.
constexpr std::size_t mostMarks = 4;

QString short4(double value) { return QString::number(std::abs(value) < 1e-12 ? 0 : value, 'g', 4); }

}  // namespace

SectionProfile::SectionProfile(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    chart_ = new ChartView;
    chart_->setAccessibleName(tr("The function along the line"));
    chart_->setToolTip(
        tr("The quantity of the colours along the line from A to B; the dashed lines are where it passes the "
           "threshold"));
    chart_->setProbing(true);
    column->addWidget(chart_, 1);
    readout_ = new QLabel;
    readout_->setTextFormat(Qt::PlainText);
    readout_->setAccessibleDescription(tr("Value along the line under the mouse"));
    // A long text must not widen the chart while a line is drawn.
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(readout_);
    connect(chart_, &ChartView::hovered, this, [this](QPointF values) {
        if (samples_.empty()) return;
        const double share = std::clamp(values.x() / samples_.length(), 0.0, 1.0);
        describe(share);
        emit hovered(share);
    });
    connect(chart_, &ChartView::hoverEnded, this, [this] {
        describe({});
        emit hoverEnded();
    });
    refresh();
}

SectionProfile::~SectionProfile() = default;

void SectionProfile::setLine(const LineRequest& request, SectionQuantity quantity) {
    const std::uint64_t generation = ++generation_;
    if (!request.surface || request.from == request.to) {
        pending_ = 0;
        samples_ = {};
        return refresh();
    }
    pending_ = 1;
    worker_.submit([this, request, quantity, generation](std::stop_token stop) {
        LineSamples samples = sampleLine(request, stop);
        if (stop.stop_requested()) return;
        QMetaObject::invokeMethod(
            this,
            [this, generation, quantity, samples = std::move(samples)]() mutable {
                if (generation == generation_) pending_ = 0;
                samples_ = std::move(samples);
                quantity_ = quantity;
                refresh();
            },
            Qt::QueuedConnection);
    });
}

void SectionProfile::refresh() {
    Chart chart;
    chart.empty = tr("Draw a line in the section.");
    chart.legend = false;
    if (!samples_.empty()) {
        const bool gradient = quantity_ == SectionQuantity::gradient;
        const bool distance = quantity_ == SectionQuantity::distance;
        const Look look = lookOf(palette());
        const QColor blue = lookColor(look, 0x215eb7, 0x4a94f5), orange = lookColor(look, 0xc85c0a, 0xe8832a);
        const std::vector<double>& heights = gradient   ? samples_.slopes
                                             : distance ? samples_.distances
                                                        : samples_.values;
        const double length = samples_.length();
        ChartSeries curve{gradient   ? tr("|∇f|")
                          : distance ? tr("distance")
                                     : tr("f − threshold"),
                          palette().color(QPalette::Text),
                          ChartSeries::Shape::line,
                          {},
                          2,
                          false};
        std::vector<double> shown{0};
        for (std::size_t i = 0; i < heights.size(); ++i) {
            curve.points.push_back(
                {length * static_cast<double>(i) / static_cast<double>(heights.size() - 1), heights[i]});
            // Where f is nearly flat the distance means nothing, however large it is.
            shown.push_back(distance ? std::clamp(heights[i], -length, length) : heights[i]);
        }
        // The threshold, or the setting that slopes are measured by.
        const double level = gradient ? samples_.maxGradient : 0;
        shown.push_back(level);
        chart.series << ChartSeries{
            {},      gradient ? orange : blue, ChartSeries::Shape::line, {{0, level}, {length, level}}, 1.2,
            gradient};
        chart.series << curve;
        chart.x = {tr("distance from A"), 0, length, false, 0};
        chart.y = axisOver(curve.name, shown, false);
        for (const double share : samples_.crossings(mostMarks))
            chart.marks << ChartMark{share * length, short4(share * length), blue};
    }
    chart.title = tr("Along the line from A to B");
    chart_->setChart(std::move(chart));
    placeCursor();
    describe({});
}

void SectionProfile::showProbe(const std::optional<glm::dvec3>& place) {
    probe_ = place;
    placeCursor();
}

void SectionProfile::placeCursor() {
    if (!probe_ || samples_.empty()) return chart_->setCursorLine({});
    const double length = samples_.length();
    const glm::dvec3 way = (samples_.to - samples_.from) / length;
    chart_->setCursorLine(std::clamp(glm::dot(*probe_ - samples_.from, way), 0.0, length));
}

void SectionProfile::describe(std::optional<double> share) {
    if (samples_.empty()) return readout_->clear();
    const auto point = [](const glm::dvec3& p) {
        return QStringLiteral("<%1, %2, %3>").arg(short4(p.x), short4(p.y), short4(p.z));
    };
    if (!share) {
        readout_->setText(tr("from %1 to %2").arg(point(samples_.from), point(samples_.to)));
        return;
    }
    const auto index =
        static_cast<std::size_t>(std::lround(*share * static_cast<double>(samples_.values.size() - 1)));
    const auto text = [](double value) {
        return std::isnan(value) ? tr("undefined") : QString::number(value, 'g', 5);
    };
    QString all =
        tr("%1: f − threshold = %2, |∇f| = %3")
            .arg(point(samples_.at(*share)), text(samples_.values[index]), text(samples_.slopes[index]));
    if (quantity_ == SectionQuantity::distance)
        all += tr(", distance = %1").arg(text(samples_.distances[index]));
    readout_->setText(all);
}

void SectionProfile::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace isoscope
