// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/histogram_panel.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "core/study/view/point_probe.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/look.h"
#include "widgets/studies/share_text.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

/// Share of the samples in bins that lie above `limit`; a bin cut by it counts in part.
double shareAbove(const GradientHistogram& histogram, const std::vector<double>& shares, double limit) {
    double sum = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const double low = std::log(histogram.edges[k]), high = std::log(histogram.edges[k + 1]);
        sum += shares[k] * std::clamp((high - std::log(limit)) / (high - low), 0.0, 1.0);
    }
    return sum;
}

QString shareText(double share) {
    constexpr double unit = 1e9;
    return formatShare(static_cast<std::uint64_t>(std::llround(share * unit)),
                       static_cast<std::uint64_t>(unit));
}

/// A first bar above this share is labelled: it holds all that is flatter, too.
constexpr double worthSaying = 0.001;

}  // namespace

HistogramPanel::HistogramPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    chart_ = new ChartView;
    chart_->setAccessibleName(tr("Histogram of the gradient"));
    chart_->setToolTip(tr(
        "How steep the function is, and how often: how much of the container, and of the surface, has which "
        "gradient |∇f|."));
    column->addWidget(chart_, 1);
    text_ = new QLabel;
    text_->setTextFormat(Qt::PlainText);
    text_->setWordWrap(true);
    text_->setAccessibleDescription(tr("How much is steeper than max_gradient"));
    auto* row = new QHBoxLayout;
    row->addWidget(text_, 1);
    save_ = new ChartSaver({[this] { return QList<Chart>{chart_->chart()}; },
                            [this] { return chartTable(chart_->chart()); }, tr("gradient")});
    connect(save_, &ChartSaver::said, this, &HistogramPanel::said);
    row->addWidget(save_);
    column->addLayout(row);
    refresh();
}

QString HistogramPanel::text() const { return text_->text(); }

void HistogramPanel::show(const GradientSurvey& survey, std::size_t isosurface) {
    survey_ = survey;
    isosurface_ = isosurface;
    refresh();
}

void HistogramPanel::showProbe(const ProbedPoint* point) {
    const bool here = point && point->isosurface == isosurface_ && point->slope > 0;
    chart_->setCursorLine(here ? std::optional(point->slope) : std::nullopt);
}

void HistogramPanel::refresh() {
    const GradientHistogram& histogram = survey_.histogram;
    Chart chart;
    chart.empty = tr("The gradient of the isosurface is shown here once it is measured.");
    if (!histogram.empty()) {
        const Look look = lookOf(palette());
        const QColor blue = lookColor(look, 0x215eb7, 0x4a94f5), orange = lookColor(look, 0xc85c0a, 0xe8832a);
        ChartSeries container{tr("in the container"), blue, ChartSeries::Shape::bars, {}, 1, false};
        ChartSeries surface{tr("on the surface"), orange, ChartSeries::Shape::line, {}, 2, false};
        double most = 0;
        for (std::size_t k = 0; k + 1 < histogram.edges.size(); ++k) {
            const double low = histogram.edges[k], high = histogram.edges[k + 1];
            container.points.push_back({std::sqrt(low * high), 100 * histogram.container[k]});
            // Stairs, for they are no values at points.
            surface.points.push_back({low, 100 * histogram.surface[k]});
            surface.points.push_back({high, 100 * histogram.surface[k]});
            most = std::max({most, histogram.container[k], histogram.surface[k]});
        }
        chart.series << container;
        if (histogram.surfaceSamples > 0) chart.series << surface;
        std::vector<double> places = histogram.edges;
        const auto mark = [&](double at, const QString& text, const QColor& color) {
            if (!(at > 0) || !std::isfinite(at)) return;
            places.push_back(at);
            chart.marks << ChartMark{at, text.arg(VerdictText::number(at)), color};
        };
        mark(survey_.setting, tr("max_gradient %1"), palette().color(QPalette::Text));
        const GradientBracket& bracket = survey_.bracket;
        if (bracket.boxes > 0) {
            const QColor proven = lookColor(look, 0x1a7f45, 0x5fd38d);
            const bool tight = bracket.relativeWidth() < 0.02;
            if (!tight) mark(bracket.lower, tr("attained %1"), proven);
            mark(bracket.upper, tr("proven %1"), proven);
        }
        if (histogram.container.front() > worthSaying)
            chart.notes << ChartNote{{histogram.edges[1], 100 * histogram.container.front()},
                                     tr("0 to %1: %2")
                                         .arg(QString::number(histogram.edges[1], 'g', 2),
                                              shareText(histogram.container.front()))};
        chart.x = axisOver(tr("|∇f|"), places, true);
        const auto [low, high] = std::minmax_element(places.begin(), places.end());
        chart.x.low = *low / 1.1;
        chart.x.high = *high * 1.1;
        chart.y = {tr("%"), 0, std::max(1e-3, 105 * most), false, 0};
    }
    chart.title = tr("Distribution of the gradient");
    chart_->setChart(std::move(chart));
    save_->setEnabled(!histogram.empty());
    describe(histogram);
}

void HistogramPanel::describe(const GradientHistogram& histogram) {
    text_->setVisible(!histogram.empty());
    if (histogram.empty()) return text_->clear();
    const auto percent = [&](const std::vector<double>& shares) {
        return shareText(shareAbove(histogram, shares, survey_.setting));
    };
    QString text = histogram.surfaceSamples > 0
                       ? tr("Steeper than max_gradient: %1 of the container, %2 of the surface.")
                             .arg(percent(histogram.container), percent(histogram.surface))
                       : tr("Steeper than max_gradient: %1 of the container. No surface was met.")
                             .arg(percent(histogram.container));
    if (histogram.infinite > 0) text += tr(" Infinite at %1 samples.").arg(histogram.infinite);
    text_->setText(text);
}

void HistogramPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace isoscope
