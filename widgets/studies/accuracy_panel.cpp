// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy_panel.h"

#include <algorithm>
#include <cmath>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/study/accuracy/accuracy_plan.h"
#include "core/study/accuracy/accuracy_table.h"
#include "core/study/accuracy/scene_likeness.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/either_stop.h"
#include "widgets/look.h"
#include "widgets/numbers/number_text.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

constexpr int lowestChart = 90;
constexpr int progressSteps = 1000;
constexpr int valueCount = 9;
constexpr double budgetSeconds = 8;  ///< of processor time, for all values
constexpr double snapDecades = 0.05;
constexpr int alphaWhenOld = 90;

enum Quantity { seconds, evaluations, missed, wrong, worstError, meanError };

double valueOf(const AccuracyPoint& point, int quantity) {
    switch (quantity) {
        case seconds: return point.cpuSeconds;
        case evaluations: return point.evaluationsPerPixel;
        case missed: return static_cast<double>(point.lost);
        case wrong: return static_cast<double>(point.lost + point.gained + point.wrongPlace);
        case worstError: return point.worstError;
        default: return point.meanError;
    }
}

QString settingName(StudiedSetting setting) {
    return setting == StudiedSetting::accuracy ? QStringLiteral("accuracy") : QStringLiteral("max_gradient");
}

double settingOf(const Isosurface& surface, StudiedSetting setting) {
    const RootSettings& settings = surface.rootSettings();
    return setting == StudiedSetting::accuracy ? settings.accuracy : settings.maxGradient;
}

QComboBox* quantityBox(std::initializer_list<std::pair<Quantity, QString>> quantities, const QString& name) {
    auto* box = new QComboBox;
    for (const auto& [quantity, text] : quantities) box->addItem(text, quantity);
    box->setToolTip(name);
    box->setAccessibleName(name);
    return box;
}

}  // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent) : StudyPanel(parent) {
    buildControls();
    connect(start_, &QPushButton::clicked, this, [this] {
        declined_ = measuring_;
        measuring_ ? stop() : measure();
    });
    connect(studied_, &QComboBox::currentIndexChanged, this, [this] {
        // What is looked at comes first.
        if (measuring_ && resting_) stop();
        refresh();
        beginIfWanted();
    });
    for (QComboBox* box : {costQuantity_, lossQuantity_})
        connect(box, &QComboBox::currentIndexChanged, this, &AccuracyPanel::refresh);
    for (ChartView* chart : {cost_, loss_}) {
        connect(chart, &ChartView::clicked, this, [this](QPointF values) { request(values.x()); });
        connect(chart, &ChartView::hovered, this, [this](QPointF values) { describeHover(values.x()); });
        connect(chart, &ChartView::hoverEnded, this, &AccuracyPanel::describe);
    }
    progressTimer_.setInterval(timing::busyMarkDelay);
    connect(&progressTimer_, &QTimer::timeout, this, &AccuracyPanel::showProgress);
    refresh();
}

AccuracyPanel::~AccuracyPanel() { stop_.request_stop(); }

void AccuracyPanel::buildControls() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    studied_ = new QComboBox;
    studied_->addItems({settingName(StudiedSetting::accuracy), settingName(StudiedSetting::maxGradient)});
    studied_->setToolTip(tr("The setting whose values are tried"));
    studied_->setAccessibleName(tr("Setting that is studied"));
    row->addWidget(studied_);
    start_ = new QPushButton;
    start_->setAccessibleName(tr("Measure or stop"));
    row->addWidget(start_);
    progress_ = new QProgressBar;
    progress_->setFixedWidth(80);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the measurement"));
    progress_->setToolTip(tr("How much of the measurement is done"));
    row->addWidget(progress_);
    note_ = new QLabel;
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    note_->setAccessibleDescription(tr("About the measurement"));
    row->addWidget(note_, 1);
    save_ = new ChartSaver({[this] {
                                return QList<Chart>{cost_->chart(), loss_->chart()};
                            },
                            [this] { return table(); }, tr("accuracy study")});
    connect(save_, &ChartSaver::said, this, &AccuracyPanel::said);
    row->addWidget(save_);

    cost_ = new ChartView;
    loss_ = new ChartView;
    costQuantity_ =
        quantityBox({{seconds, tr("CPU seconds of the picture")}, {evaluations, tr("Evaluations per pixel")}},
                    tr("What the left chart shows"));
    lossQuantity_ = quantityBox({{missed, tr("Pixels missed")},
                                 {wrong, tr("Pixels wrong in any way")},
                                 {worstError, tr("Worst error in t")},
                                 {meanError, tr("Mean error in t")}},
                                tr("What the right chart shows"));
    charts_ = new QWidget;
    auto* both = new QHBoxLayout(charts_);
    both->setContentsMargins(0, 0, 0, 0);
    both->addWidget(chartColumn(costQuantity_, cost_));
    both->addWidget(chartColumn(lossQuantity_, loss_));
    column->addWidget(charts_, 1);
}

QWidget* AccuracyPanel::chartColumn(QComboBox* quantity, ChartView* chart) {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(quantity);
    chart->setToolTip(tr("Click to write a value into the text"));
    chart->setMinimumHeight(lowestChart);
    column->addWidget(chart, 1);
    return whole;
}

StudiedSetting AccuracyPanel::studied() const {
    return studied_->currentIndex() == 1 ? StudiedSetting::maxGradient : StudiedSetting::accuracy;
}

void AccuracyPanel::setStudied(StudiedSetting setting) {
    studied_->setCurrentIndex(setting == StudiedSetting::maxGradient ? 1 : 0);
}

void AccuracyPanel::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    sceneOrViewChanged();
}

void AccuracyPanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    sceneOrViewChanged();
}

bool AccuracyPanel::fresh() const {
    const Study& s = study();
    return s.scene && scene_ && s.camera == camera_ && s.size == size_ &&
           sameButFor(studied(), *s.scene, *scene_);
}

void AccuracyPanel::sceneOrViewChanged() {
    const Study& s = studies_[static_cast<std::size_t>(measuredSetting_)];
    // A value written by a click is no reason to begin again.
    const bool holds = measuring_ && scene_ && s.scene && s.camera == camera_ && s.size == size_ &&
                       sameButFor(measuredSetting_, *s.scene, *scene_);
    if (measuring_ && !holds) stop();
    if (!fresh()) declined_ = false;
    refresh();
}

void AccuracyPanel::setResting(bool resting) {
    resting_ = resting;
    if (!resting && measuring_) stop();
    beginIfWanted();
}

void AccuracyPanel::setActive(bool active) {
    // No show event tells of a tab that is chosen: behind another one a panel counts as shown.
    if (active) QTimer::singleShot(0, this, &AccuracyPanel::beginIfWanted);
}

void AccuracyPanel::beginIfWanted() {
    if (!resting_ || measuring_ || declined_ || visibleRegion().isEmpty()) return;
    const bool whole = study().wanted > 0 && points().size() == study().wanted;
    if (!whole || !fresh()) measure();
}

void AccuracyPanel::measure() {
    stop();
    if (!scene_ || scene_->isosurfaces.empty()) return;
    measuredSetting_ = studied();
    study() = {};
    study().scene = scene_;
    study().camera = camera_;
    study().size = size_;
    measuring_ = true;
    stop_ = std::stop_source();
    const std::uint64_t generation = generation_;
    RenderRequest view;
    view.scene = scene_;
    view.camera = camera_;
    view.width = size_.width();
    view.height = size_.height();
    share_ = std::make_shared<std::atomic<double>>(0);
    progressTimer_.start();
    worker_.submit([this, view, generation, share = share_, setting = measuredSetting_,
                    stop = stop_.get_token()](std::stop_token closing) {
        const EitherStop either(stop, closing);
        const auto tell = [this](auto action) {
            QMetaObject::invokeMethod(this, std::move(action), Qt::QueuedConnection);
        };
        const AccuracyStudyRequest request =
            planAccuracyStudy(view, setting, valueCount, budgetSeconds, either.token());
        tell([this, request, generation] { startPlanned(request, generation); });
        AccuracyStudy running(request);
        const ShareReport report = [&share](double done) { share->store(done); };
        while (const auto point = running.next(either.token(), report))
            tell([this, point = *point, generation] { receive(point, generation); });
        tell([this, generation] { finish(generation); });
    });
    refresh();
}

void AccuracyPanel::stop() {
    stop_.request_stop();
    ++generation_;
    measuring_ = false;
    refresh();
}

void AccuracyPanel::startPlanned(const AccuracyStudyRequest& request, std::uint64_t generation) {
    if (generation != generation_) return;
    Study& s = studies_[static_cast<std::size_t>(measuredSetting_)];
    s.pixels = {request.view.width, request.view.height};
    s.wanted = 2 * request.values.size();
    refresh();
}

void AccuracyPanel::receive(const AccuracyPoint& point, std::uint64_t generation) {
    if (generation != generation_) return;
    studies_[static_cast<std::size_t>(measuredSetting_)].points.push_back(point);
    refresh();
}

void AccuracyPanel::finish(std::uint64_t generation) {
    if (generation != generation_) return;
    measuring_ = false;
    refresh();
    emit measured();
}

void AccuracyPanel::refresh() {
    const bool possible = scene_ && !scene_->isosurfaces.empty();
    start_->setText(measuring_ ? tr("Stop") : tr("Measure Again"));
    start_->setToolTip(measuring_ ? tr("End the measurement; what is measured stays")
                                  : tr("Render the view with nine values, three times each"));
    start_->setEnabled(measuring_ || possible);
    progress_->setVisible(measuring_);
    showProgress();
    save_->setEnabled(!points().empty());
    showChart(cost_, costQuantity_);
    showChart(loss_, lossQuantity_);
    describe();
}

void AccuracyPanel::showProgress() {
    if (!measuring_) progressTimer_.stop();
    const bool planned = studies_[static_cast<std::size_t>(measuredSetting_)].wanted > 0;
    progress_->setMaximum(planned ? progressSteps : 0);  // a busy bar while it is being planned
    progress_->setValue(static_cast<int>(std::lround(share() * progressSteps)));
}

void AccuracyPanel::showChart(ChartView* view, const QComboBox* shown) const {
    const int quantity = shown->currentData().toInt();
    Chart chart;
    chart.title = shown->currentText();
    const bool possible = scene_ && !scene_->isosurfaces.empty();
    chart.empty = possible ? tr("It is measured as soon as nothing moves.")
                           : tr("The scene has no isosurface to measure.");
    std::vector<AccuracyPoint> sorted = points();
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.setting < b.setting; });
    const Look look = lookOf(view->palette());
    const bool old = !fresh();
    std::vector<double> settings, values;
    // POV-Ray's in orange, the certified ones in blue, as outside and inside in the cross-section.
    for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
        const bool povray = finder == RootFinder::lipschitz;
        ChartSeries series;
        series.name = povray ? tr("POV-Ray") : tr("exact");
        series.color = povray ? lookColor(look, 0xc85c0a, 0xe8832a) : lookColor(look, 0x215eb7, 0x4a94f5);
        if (old) series.color.setAlpha(alphaWhenOld);
        series.shape = ChartSeries::Shape::linePoints;
        for (const AccuracyPoint& point : sorted) {
            if (point.finder != finder) continue;
            series.points.push_back({point.setting, valueOf(point, quantity)});
            settings.push_back(point.setting);
            values.push_back(valueOf(point, quantity));
        }
        if (!series.points.empty()) chart.series << series;
    }
    chart.x = axisOver(settingName(studied()), settings, true);
    chart.y = axisOver({}, values, true);
    if (scene_)
        for (const SceneIsosurface& isosurface : scene_->isosurfaces) {
            if (!isosurface.shape) continue;
            const double present = settingOf(*isosurface.shape, studied());
            const bool marked = std::any_of(chart.marks.begin(), chart.marks.end(),
                                            [&](const ChartMark& mark) { return mark.x == present; });
            if (!marked && chart.marks.size() < 3)
                chart.marks << ChartMark{present, tr("now %1").arg(numberText(present)),
                                         view->palette().color(QPalette::Text)};
        }
    view->setAccessibleName(tr("Chart over %1").arg(settingName(studied())));
    view->setChart(std::move(chart));
}

void AccuracyPanel::describe() {
    const Study& s = study();
    if (points().empty()) {
        note_->setText(measuring_ ? tr("Choosing the size of the picture…") : QString());
        return;
    }
    const QString size = tr("%1 × %2 pixels").arg(s.pixels.width()).arg(s.pixels.height());
    if (!fresh())
        note_->setText(tr("Measured before the last change of scene or view."));
    else if (!measuring_ && points().size() < s.wanted)
        note_->setText(tr("%1; stopped early.").arg(size));
    else
        note_->setText(measuring_ ? size : tr("%1, median of 3 runs").arg(size));
}

void AccuracyPanel::describeHover(double value) {
    note_->setText(tr("Click for %1 %2.").arg(settingName(studied()), numberText(settledValue(value))));
}

double AccuracyPanel::settledValue(double value) const {
    for (const AccuracyPoint& point : points())
        if (std::abs(std::log10(point.setting / value)) < snapDecades)
            return QString::number(point.setting, 'g', 3).toDouble();
    const int digits = studied() == StudiedSetting::accuracy ? 1 : 2;
    return QString::number(value, 'g', digits).toDouble();
}

void AccuracyPanel::request(double value) {
    if (!points().empty()) emit settingRequested(studied(), settledValue(value));
}

QString AccuracyPanel::table() const {
    std::string text = accuracyTableHeader(studied());
    for (const AccuracyPoint& point : points()) text += accuracyTableLine(point);
    return QString::fromStdString(text);
}

void AccuracyPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

void AccuracyPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    // Whether it is seen, or behind another tab, is known when it has been laid out.
    QTimer::singleShot(0, this, &AccuracyPanel::beginIfWanted);
}

}  // namespace isoscope
