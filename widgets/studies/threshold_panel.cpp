// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/threshold_panel.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/study/gradient/function_likeness.h"
#include "widgets/background_priority.h"
#include "core/study/view/point_probe.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/either_stop.h"
#include "widgets/numbers/number_text.h"
#include "widgets/progress_row.h"
#include "widgets/section/surface_chooser.h"
#include "widgets/studies/share_text.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

/// Pixels from a mark within which the threshold sticks to it.
constexpr double magnet = 6;
/// Round values of the chart: a step of so many in all.
constexpr double roundSteps = 400;
/// Digits that critical values are shown and written with.
constexpr int digits = 7;
/// Rows of the list; functions with more critical values are told so.
constexpr std::size_t mostRows = 500;

QString valueText(double value) { return QString::number(value, 'g', 5); }

/// A critical value as it is written: its enclosure is narrower than this in all but odd cases.
double written(double value) { return QString::number(value, 'g', digits).toDouble(); }

bool joins(CriticalKind kind) {
    return kind == CriticalKind::saddle || kind == CriticalKind::saddle1 || kind == CriticalKind::saddle2;
}

/// Whether what is known of isosurface `i` of one scene holds for that of the other, whatever its threshold.
bool sameFunctionThere(const Scene& a, const Scene& b, std::size_t i) {
    if (i >= a.isosurfaces.size() || i >= b.isosurfaces.size()) return false;
    const auto &one = a.isosurfaces[i].shape, &other = b.isosurfaces[i].shape;
    return one && other && sameContainer(one->settings().container, other->settings().container) &&
           sameFunction(*one->tape(), *a.parameterTable, *other->tape(), *b.parameterTable);
}

QString certaintyText(const ThresholdTick& tick) {
    if (tick.proven()) return ThresholdPanel::tr("proven");
    switch (tick.points.front().reason) {
        case SuspicionReason::unfinished: return ThresholdPanel::tr("suspected: the search ended before");
        case SuspicionReason::wall: return ThresholdPanel::tr("suspected: at the container's wall");
        case SuspicionReason::flat: return ThresholdPanel::tr("suspected: the function is constant there");
        case SuspicionReason::degenerate: return ThresholdPanel::tr("suspected: more than a point");
        case SuspicionReason::kink: return ThresholdPanel::tr("suspected: a kink");
        case SuspicionReason::steep: return ThresholdPanel::tr("suspected: no bound of the gradient");
        case SuspicionReason::none: break;
    }
    return {};
}

/// What happens there, each thing once.
QString meaningText(const ThresholdTick& tick, bool positivePolarity) {
    QStringList said;
    for (const CriticalPoint& point : tick.points) {
        const std::string_view words = meaning(point.kind, positivePolarity);
        const QString text = QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
        if (!said.contains(text)) said << text;
    }
    QString all = said.join(ThresholdPanel::tr("; "));
    if (tick.points.size() > 1) all += ThresholdPanel::tr(" (×%1)").arg(tick.points.size());
    return all;
}

/// Share of the samples below `limit`; a bin that it cuts counts in part.
double shareBelow(const ValueHistogram& histogram, double limit) {
    double sum = 0;
    for (std::size_t k = 0; k < histogram.shares.size(); ++k) {
        const double low = histogram.edges[k], high = histogram.edges[k + 1];
        sum += histogram.shares[k] * std::clamp((limit - low) / (high - low), 0.0, 1.0);
    }
    return sum;
}

}  // namespace

ThresholdPanel::ThresholdPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    surfaces_ = new SurfaceChooser(tr("The isosurface whose threshold is looked at."));
    surfaces_->setWhatsThis(surfaces_->toolTip());
    connect(surfaces_, &SurfaceChooser::activated, this, [this] {
        forget();
        refresh();
        beginIfWanted();
    });
    column->addWidget(surfaces_);
    auto* both = new QSplitter;
    both->setChildrenCollapsible(false);
    chart_ = new ChartView;
    chart_->setMinimumWidth(220);
    chart_->setDraggable(true);
    chart_->setAccessibleName(tr("Histogram of the function"));
    chart_->setToolTip(
        tr("How much of the container has which value of the function. Drag to move the threshold; it sticks "
           "to the lines, at which the surface changes its form."));
    connect(chart_, &ChartView::dragged, this,
            [this](QPointF at) { emit thresholdMoved(settledValue(at.x())); });
    connect(chart_, &ChartView::dragEnded, this, [this] { emit thresholdSettled(); });
    connect(chart_, &ChartView::hovered, this, [this](QPointF at) {
        const ThresholdTick* tick = subject() ? tickNear(at.x()) : nullptr;
        tick ? emit probed(chosen(), tick->points.front().place) : emit probeEnded();
    });
    connect(chart_, &ChartView::hoverEnded, this, &ThresholdPanel::probeEnded);
    both->addWidget(chart_);
    both->addWidget(buildList());
    both->setStretchFactor(0, 1);
    both->setStretchFactor(1, 1);
    column->addWidget(both, 1);
    row_ = new ProgressRow({tr("About the threshold"), tr("Progress of the search"),
                            tr("How much of the search for critical values is done"), tr("Search or stop")});
    connect(row_->button(), &QPushButton::clicked, this, [this] {
        declined_ = searching_;
        if (!searching_) return search();
        endSearch();
        refresh();
    });
    row_->add(goThere_);
    row_->add(use_);
    save_ = new ChartSaver({[this] { return QList<Chart>{chart_->chart()}; },
                            [this] { return chartTable(chart_->chart()); }, tr("threshold")});
    connect(save_, &ChartSaver::said, this, &ThresholdPanel::said);
    row_->add(save_);
    column->addWidget(row_);
    refresh();
}

ThresholdPanel::~ThresholdPanel() { stop_.request_stop(); }

QWidget* ThresholdPanel::buildList() {
    list_ = new QTreeWidget;
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels({tr("Threshold"), tr("What happens as it rises"), tr("Certainty"), tr("Where")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setAccessibleName(tr("Thresholds at which the surface changes its form"));
    list_->setToolTip(tr("A double click, or Enter, sets the threshold"));
    list_->headerItem()->setTextAlignment(value, Qt::AlignRight | Qt::AlignVCenter);
    list_->header()->setSectionsMovable(false);
    list_->header()->resizeSection(value, fontMetrics().horizontalAdvance(QStringLiteral("-0.123456_")) + 8);
    list_->header()->resizeSection(
        happens, fontMetrics().horizontalAdvance(tr("two pieces join or a tunnel opens (×88)")));
    list_->header()->resizeSection(certainty, fontMetrics().horizontalAdvance(tr("suspected: a kink_")));
    connect(list_, &QTreeWidget::itemActivated, use_ = new QPushButton(tr("Use")), &QPushButton::click);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        use_->setEnabled(current());
        goThere_->setEnabled(current());
    });
    goThere_ = new QPushButton(tr("Go There"));
    use_->setToolTip(tr("Writes this threshold into the text."));
    use_->setAccessibleName(tr("Use the chosen threshold"));
    goThere_->setToolTip(tr("Shows the place where it happens in the picture."));
    goThere_->setAccessibleName(tr("Show the place of the chosen threshold"));
    connect(use_, &QPushButton::clicked, this, [this] {
        if (!current()) return;
        emit thresholdMoved(written(current()->value));
        emit thresholdSettled();
    });
    connect(goThere_, &QPushButton::clicked, this, [this] {
        if (current()) emit placeRequested(current()->points.front().place);
    });
    return list_;
}

std::size_t ThresholdPanel::chosen() const {
    return static_cast<std::size_t>(std::max(0, surfaces_->currentIndex()));
}

QString ThresholdPanel::text() const { return row_->note()->text(); }

QPushButton* ThresholdPanel::stopButton() const { return row_->button(); }

const SceneIsosurface* ThresholdPanel::subject() const {
    if (!scene_ || chosen() >= scene_->isosurfaces.size()) return nullptr;
    const SceneIsosurface& one = scene_->isosurfaces[chosen()];
    return one.shape ? &one : nullptr;
}

const ThresholdTick* ThresholdPanel::current() const {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    return row >= 0 && static_cast<std::size_t>(row) < ticks_.size() ? &ticks_[static_cast<std::size_t>(row)]
                                                                     : nullptr;
}

void ThresholdPanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    const bool same = scene_ && scene && sameFunctionThere(*scene_, *scene, chosen());
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    if (!same) {
        forget();
        declined_ = false;
    }
    refresh();
    beginIfWanted();
}

void ThresholdPanel::setActive(bool active) {
    active_ = active;
    if (!active) endSearch();
    if (active) refresh();
    beginIfWanted();
}

void ThresholdPanel::setResting(bool resting) {
    resting_ = resting;
    beginIfWanted();
}

void ThresholdPanel::endSearch() {
    stop_.request_stop();
    ++generation_;
    searching_ = false;
}

void ThresholdPanel::forget() {
    endSearch();
    survey_ = {};
    ticks_.clear();
}

void ThresholdPanel::beginIfWanted() {
    if (active_ && resting_ && !searching_ && !declined_ && !survey_.complete && subject()) search();
}

void ThresholdPanel::search() {
    if (!subject()) return;
    endSearch();
    declined_ = false;
    searching_ = true;
    stop_ = std::stop_source();
    worker_.submit([this, scene = scene_, isosurface = chosen(), generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        // It goes on while something moves.
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        surveyThresholds(
            *scene, isosurface, {},
            [this, generation](const ThresholdSurvey& survey) {
                QMetaObject::invokeMethod(
                    this, [this, generation, survey] { receive(survey, generation); }, Qt::QueuedConnection);
            },
            either.token());
    });
    refresh();
}

void ThresholdPanel::receive(const ThresholdSurvey& survey, std::uint64_t generation) {
    if (generation != generation_) return;
    const bool sameChart = !survey_.histogram.empty() && !survey.complete;
    survey_ = survey;
    searching_ = !survey.complete;
    ticks_ = thresholdTicks(survey_.critical);
    if (sameChart) return describe();
    refresh();
}

void ThresholdPanel::refresh() {
    showChart();
    showList();
    describe();
}

void ThresholdPanel::showChart() {
    const ValueHistogram& histogram = survey_.histogram;
    Chart chart;
    chart.empty = subject() ? tr("The values of the function are shown here once nothing moves.")
                            : tr("The scene has no isosurface.");
    chart.title = tr("Distribution of the function");
    save_->setEnabled(!histogram.empty());
    if (histogram.empty() || !subject()) return chart_->setChart(std::move(chart));
    const bool dark = palette().color(QPalette::Base).lightness() < 128;
    const double low = histogram.edges.front(), high = histogram.edges.back();
    ChartSeries bars{
        tr("in the container"), QColor(dark ? 0x4a94f5 : 0x215eb7), ChartSeries::Shape::bars, {}, 1, false};
    double most = 0;
    for (std::size_t k = 0; k < histogram.shares.size(); ++k) {
        bars.points.push_back(
            {0.5 * histogram.edges[k] + 0.5 * histogram.edges[k + 1], 100 * histogram.shares[k]});
        most = std::max(most, histogram.shares[k]);
    }
    // Room for what lies little outside: minima and maxima are rare values.
    const double room = 0.25 * (high - low);
    const auto isNear = [&](double at) { return at >= low - room && at <= high + room; };
    std::vector<double> places{low, high};
    const double top = 105 * most;
    const auto lines = [&](const QString& name, const QColor& color) {
        return ChartSeries{name, color, ChartSeries::Shape::segments, {}, 2, false};
    };
    ChartSeries ends = lines(tr("pieces or hollows appear, go"), QColor(dark ? 0x5fd38d : 0x1a7f45));
    ChartSeries saddles = lines(tr("pieces join, tunnels"), QColor(dark ? 0xe8832a : 0xc85c0a));
    ChartSeries suspected = lines(tr("suspected"), palette().color(QPalette::PlaceholderText));
    for (const ThresholdTick& tick : ticks_) {
        if (!isNear(tick.value)) continue;
        places.push_back(tick.value);
        const bool saddle =
            std::ranges::any_of(tick.points, [](const CriticalPoint& point) { return joins(point.kind); });
        ChartSeries& series = !tick.proven() ? suspected : saddle ? saddles : ends;
        series.points.push_back({tick.value, 0});
        series.points.push_back({tick.value, top});
    }
    chart.series << bars;
    for (const ChartSeries& series : {suspected, ends, saddles})
        if (!series.points.empty()) chart.series << series;
    const double threshold = subject()->shape->settings().threshold;
    if (isNear(threshold)) places.push_back(threshold);
    chart.marks << ChartMark{threshold, tr("threshold %1").arg(valueText(threshold)),
                             palette().color(QPalette::Text)};
    // A slider does not change its range under the mouse.
    chart.x = chart_->isDragged() ? chart_->chart().x : axisOver(tr("f"), places, false);
    chart.y = {tr("%"), 0, std::max(1e-3, top), false, 0};
    chart_->setChart(std::move(chart));
}

void ThresholdPanel::showList() {
    const QSignalBlocker quiet(list_);
    const QString chosenValue = list_->currentItem() ? list_->currentItem()->text(value) : QString();
    const bool positive = subject() && subject()->shape->settings().positivePolarity;
    list_->headerItem()->setText(happens,
                                 positive ? tr("What happens as it falls") : tr("What happens as it rises"));
    const std::size_t count = std::min(ticks_.size(), mostRows);
    // Rows stay as long as they can, so that a scrolled list does not jump.
    while (list_->topLevelItemCount() > static_cast<int>(count))
        delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
    while (list_->topLevelItemCount() < static_cast<int>(count)) new QTreeWidgetItem(list_);
    for (std::size_t i = 0; i < count; ++i) {
        QTreeWidgetItem* row = list_->topLevelItem(static_cast<int>(i));
        const ThresholdTick& tick = ticks_[i];
        row->setText(value, QString::number(tick.value, 'g', digits));
        row->setTextAlignment(value, Qt::AlignRight | Qt::AlignVCenter);
        row->setText(happens, meaningText(tick, positive));
        row->setText(certainty, certaintyText(tick));
        row->setText(place, VerdictText::place(tick.points.front().place));
        for (const int k : {happens, certainty, place}) row->setToolTip(k, row->text(k));
        if (row->text(value) == chosenValue) list_->setCurrentItem(row);
    }
    use_->setEnabled(current());
    goThere_->setEnabled(current());
}

void ThresholdPanel::describe() {
    const bool possible = subject();
    row_->setWorking(
        searching_,
        searching_ ? ProgressRow::Button{tr("Stop"), tr("End the search for critical values")}
                   : ProgressRow::Button{tr("Search"),
                                         tr("Search for the values at which the surface changes its form")});
    row_->setProgress(survey_.progress);
    row_->button()->setVisible(possible && (searching_ || !survey_.complete));
    if (!possible || survey_.histogram.empty()) return row_->note()->clear();
    const IsosurfaceSettings& settings = subject()->shape->settings();
    const double below = shareBelow(survey_.histogram, settings.threshold);
    const double inside = settings.positivePolarity ? 1 - below : below;
    constexpr double unit = 1e9;
    QString text =
        tr("%1 of the container is inside.")
            .arg(formatShare(static_cast<std::uint64_t>(std::llround(std::clamp(inside, 0.0, 1.0) * unit)),
                             static_cast<std::uint64_t>(unit)));
    if (!survey_.complete) return row_->note()->setText(text);
    const auto proven = std::ranges::count_if(ticks_, &ThresholdTick::proven);
    const auto open = static_cast<std::ptrdiff_t>(ticks_.size()) - proven;
    text += ' ' + tr("Values at which its form changes: %1 proven, %2 suspected, no others but at the "
                     "container's wall.")
                      .arg(proven)
                      .arg(open);
    if (ticks_.size() > mostRows) text += ' ' + tr("The first %1 are listed.").arg(mostRows);
    if (survey_.critical.jumps) text += ' ' + tr("Where the function jumps there may be more.");
    row_->note()->setText(text);
}

void ThresholdPanel::showProbe(const ProbedPoint* point) {
    const bool here = point && point->isosurface == chosen() && std::isfinite(point->value);
    chart_->setCursorLine(here ? std::optional(point->value) : std::nullopt);
}

const ThresholdTick* ThresholdPanel::tickNear(double threshold) const {
    const double pixels = chart_->positionOf({threshold, 0}).x();
    const ThresholdTick* nearest = nullptr;
    double least = magnet;
    for (const ThresholdTick& tick : ticks_) {
        const double away = std::abs(chart_->positionOf({tick.value, 0}).x() - pixels);
        if (!(away < least)) continue;
        least = away;
        nearest = &tick;
    }
    return nearest;
}

double ThresholdPanel::settledValue(double threshold) const {
    if (const ThresholdTick* tick = tickNear(threshold)) return written(tick->value);
    const double step = (chart_->chart().x.high - chart_->chart().x.low) / roundSteps;
    return roundToResolution(threshold, std::pow(10, std::floor(std::log10(step))));
}

void ThresholdPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace isoscope
