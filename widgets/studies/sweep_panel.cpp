// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/sweep_panel.h"

#include <algorithm>
#include <cmath>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/study/range/scene_ranges.h"
#include "widgets/background_priority.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/either_stop.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {

namespace {

constexpr int lowestChart = 90;
constexpr int usualSteps = 17, mostSteps = 200;
constexpr int alphaWhenOld = 90;
/// Round values of a click: a step of so many in all.
constexpr double roundSteps = 200;

enum Quantity { gradient, form };

QString nameOf(const SceneParameter& parameter) {
    const QString name = QString::fromStdString(parameter.name);
    return parameter.group == "#declare" ? name : QString::fromStdString(parameter.group) + ' ' + name;
}

bool samePlace(const SceneParameter& a, const SceneParameter& b) {
    return a.name == b.name && a.group == b.group && a.range.begin == b.range.begin;
}

/// The first isosurface that the number has to do with, else the first of all.
std::size_t isosurfaceOf(const Scene& scene, const SceneParameter& number) {
    for (const RangeSubject& subject : rangeSubjects(scene))
        if (samePlace(scene.parameters[subject.parameter], number)) return subject.isosurface;
    return 0;
}

}  // namespace

SweepPanel::SweepPanel(QWidget* parent) : StudyPanel(parent) {
    buildControls();
    connect(start_, &QPushButton::clicked, this, [this] {
        declined_ = measuring_;
        measuring_ ? stop() : measure();
    });
    connect(numbers_, &QComboBox::activated, this, [this] {
        takeEnds();
        measure();
    });
    for (NumberBox* box : {from_, to_})
        connect(box, &QDoubleSpinBox::editingFinished, this, [this] {
            if (measuredName_ != numbers_->currentText() || points_.empty() ||
                points_.front().value != std::min(from_->value(), to_->value()) ||
                points_.back().value != std::max(from_->value(), to_->value()))
                measure();
        });
    connect(steps_, &QSpinBox::editingFinished, this, [this] {
        if (static_cast<std::size_t>(steps_->value()) != wanted_) measure();
    });
    connect(quantity_, &QComboBox::currentIndexChanged, this, &SweepPanel::refresh);
    for (ChartView* chart : {cost_, form_})
        connect(chart, &ChartView::clicked, this, [this](QPointF at) {
            if (!number() || points_.empty()) return;
            const double step = std::abs(points_.back().value - points_.front().value) / roundSteps;
            const double round = number()->integral ? 1 : std::pow(10, std::floor(std::log10(step)));
            emit valueRequested(*number(), roundToResolution(at.x(), round));
        });
    refresh();
}

SweepPanel::~SweepPanel() { stop_.request_stop(); }

void SweepPanel::buildControls() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    numbers_ = new QComboBox;
    // Names are never cut, however large the letters; the note beside them breaks its lines instead.
    numbers_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    numbers_->setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
    numbers_->setToolTip(tr("The number whose values are tried"));
    numbers_->setAccessibleName(tr("Number that is varied"));
    row->addWidget(numbers_, 1);
    const QString widest = QStringLiteral("-0.000");
    from_ = NumberBox::addTo(row, tr("from"), tr("First value"), widest);
    to_ = NumberBox::addTo(row, tr("to"), tr("Last value"), widest);
    steps_ = new QSpinBox;
    steps_->setRange(2, mostSteps);
    steps_->setValue(usualSteps);
    steps_->setSuffix(tr(" values"));
    steps_->setKeyboardTracking(false);
    steps_->setAccessibleName(tr("Number of values"));
    steps_->setToolTip(tr("How many values are tried"));
    row->addWidget(steps_);
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
                                return QList<Chart>{cost_->chart(), form_->chart()};
                            },
                            [this] {
                                std::string table = sweepTableHeader();
                                for (const SweepPoint& point : points_) table += sweepTableLine(point);
                                return QString::fromStdString(table);
                            },
                            tr("sweep")});
    connect(save_, &ChartSaver::said, this, &SweepPanel::said);
    row->addWidget(save_);
    column->addLayout(buildCharts(), 1);
}

QHBoxLayout* SweepPanel::buildCharts() {
    quantity_ = new QComboBox;
    quantity_->addItem(tr("Pieces, tunnels, hollows"), form);
    quantity_->addItem(tr("Largest gradient"), gradient);
    quantity_->setToolTip(tr("What the right chart shows"));
    quantity_->setAccessibleName(quantity_->toolTip());
    auto* left = new QLabel(tr("Evaluations per pixel"));
    left->setMinimumHeight(quantity_->sizeHint().height());
    auto* charts = new QHBoxLayout;
    const auto addChart = [&](QWidget* title) {
        auto* side = new QVBoxLayout;
        side->setSpacing(2);
        side->addWidget(title);
        auto* chart = new ChartView;
        chart->setToolTip(tr("Click to write a value into the text"));
        chart->setMinimumHeight(lowestChart);
        side->addWidget(chart, 1);
        charts->addLayout(side, 1);
        return chart;
    };
    cost_ = addChart(left);
    form_ = addChart(quantity_);
    return charts;
}

QString SweepPanel::text() const { return note_->text(); }

const SceneParameter* SweepPanel::number() const {
    const int index = numbers_->currentIndex();
    return index >= 0 && static_cast<std::size_t>(index) < listed_.size()
               ? &listed_[static_cast<std::size_t>(index)]
               : nullptr;
}

void SweepPanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    scene_ = std::move(scene);
    if (!scene_) {
        stop();
        points_.clear();
        measuredName_.clear();
    }
    if (active_ || !scene_) listNumbers();
    refresh();
}

void SweepPanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    if (measuring_) stop();
    refresh();
}

/// The same number stays chosen; at first it is one that the function depends on.
void SweepPanel::listNumbers() {
    const QSignalBlocker quiet(numbers_);
    const QString chosen = numbers_->currentText();
    listed_.clear();
    numbers_->clear();
    if (!scene_ || scene_->isosurfaces.empty()) return;
    int first = -1;
    constexpr std::size_t mostNumbers = 200;
    for (const SceneParameter& parameter : scene_->parameters) {
        if (parameter.range.file != 0 || parameter.expression || listed_.size() >= mostNumbers) continue;
        QString name = nameOf(parameter);
        for (int again = 2; numbers_->findText(name) >= 0; ++again)
            name = tr("%1 (%2)").arg(nameOf(parameter)).arg(again);
        if (first < 0 && parameter.role == ParameterRole::argument) first = static_cast<int>(listed_.size());
        listed_.push_back(parameter);
        numbers_->addItem(name);
    }
    const int known = numbers_->findText(chosen);
    numbers_->setCurrentIndex(known >= 0 ? known : std::max(0, first));
    if (known < 0) takeEnds();
}

void SweepPanel::takeEnds() {
    if (!number()) return;
    for (NumberBox* box : {from_, to_}) {
        box->setIntegral(number()->integral);
        box->setResolution(std::max(1e-9, (number()->maximum - number()->minimum) / 100));
    }
    from_->setValue(number()->minimum);
    to_->setValue(number()->maximum);
}

void SweepPanel::setActive(bool active) {
    active_ = active;
    if (active) {
        listNumbers();
        refresh();
    }
    if (!active && measuring_) stop();
    beginIfWanted();
}

void SweepPanel::setResting(bool resting) {
    resting_ = resting;
    if (!resting && measuring_ && !fresh()) stop();
    beginIfWanted();
}

bool SweepPanel::fresh() const {
    if (measuredName_.isEmpty() || !number() || !reader_ || measuredName_ != numbers_->currentText())
        return false;
    return camera_ == measuredCamera_ && reader_(number()->range).identity == identity_;
}

void SweepPanel::beginIfWanted() {
    if (!active_ || !resting_ || measuring_ || declined_ || !number()) return;
    if (points_.size() < wanted_ || points_.empty() || !fresh()) measure();
}

void SweepPanel::measure() {
    stop();
    if (!scene_ || !number() || !reader_) return;
    Source source = reader_(number()->range);
    if (!source.sceneAt) return;
    SweepRequest request;
    request.view.camera = camera_;
    request.view.width = size_.width();
    request.view.height = size_.height();
    request.sceneAt = std::move(source.sceneAt);
    request.isosurface = isosurfaceOf(*scene_, *number());
    request.values = sweepValues(from_->value(), to_->value(), steps_->value(), number()->logarithmic);
    if (number()->integral)
        for (double& value : request.values) value = std::round(value);
    request.values.erase(std::unique(request.values.begin(), request.values.end()), request.values.end());
    points_.clear();
    identity_ = std::move(source.identity);
    measuredCamera_ = camera_;
    measuredName_ = numbers_->currentText();
    measuredByRatio_ = number()->logarithmic;
    wanted_ = request.values.size();
    measuring_ = true;
    declined_ = false;
    stop_ = std::stop_source();
    worker_.submit([this, request = std::move(request), generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        ParameterSweep sweep(request);
        const auto tell = [this](auto action) {
            QMetaObject::invokeMethod(this, std::move(action), Qt::QueuedConnection);
        };
        while (const auto point = sweep.next(either.token(), 1))
            tell([this, point = *point, generation] { receive(point, generation); });
        tell([this, generation] { finish(generation); });
    });
    refresh();
}

void SweepPanel::stop() {
    stop_.request_stop();
    ++generation_;
    measuring_ = false;
    refresh();
}

void SweepPanel::receive(const SweepPoint& point, std::uint64_t generation) {
    if (generation != generation_) return;
    const auto place = std::ranges::upper_bound(points_, point.value, {}, &SweepPoint::value);
    points_.insert(place, point);
    refresh();
}

void SweepPanel::finish(std::uint64_t generation) {
    if (generation != generation_) return;
    measuring_ = false;
    refresh();
    emit measured();
}

void SweepPanel::refresh() {
    // Nothing is looked at, nor drawn.
    if (!active_ && scene_) return;
    start_->setText(measuring_ ? tr("Stop") : tr("Measure Again"));
    start_->setToolTip(measuring_ ? tr("End the measurement; what is measured stays")
                                  : tr("Try the values of the number in small pictures"));
    for (QWidget* control : std::initializer_list<QWidget*>{start_, numbers_, from_, to_, steps_})
        control->setEnabled(number());
    progress_->setVisible(measuring_);
    progress_->setMaximum(static_cast<int>(std::max<std::size_t>(1, wanted_)));
    progress_->setValue(static_cast<int>(points_.size()));
    save_->setEnabled(!points_.empty());
    showChart(cost_, true);
    showChart(form_, false);
    describe();
}

void SweepPanel::showChart(ChartView* view, bool cost) {
    Chart chart;
    const int shown = quantity_->currentData().toInt();
    chart.title = cost ? tr("Evaluations per pixel") : quantity_->currentText();
    chart.empty = number() ? tr("It is measured as soon as nothing moves.")
                           : tr("The scene has no isosurface with a number to vary.");
    const bool dark = view->palette().color(QPalette::Base).lightness() < 128;
    const bool old = !points_.empty() && !measuring_ && !fresh();
    const QColor orange(dark ? 0xe8832a : 0xc85c0a), blue(dark ? 0x4a94f5 : 0x215eb7),
        green(dark ? 0x5fd38d : 0x1a7f45);
    std::vector<double> values, heights;
    const auto add = [&](const QString& name, QColor color, auto valueOf) {
        if (old) color.setAlpha(alphaWhenOld);
        ChartSeries series{name, color, ChartSeries::Shape::linePoints, {}, 2, false};
        for (const SweepPoint& point : points_) {
            if (!point.known) continue;
            const double height = valueOf(point);
            series.points.push_back({point.value, height});
            values.push_back(point.value);
            if (std::isfinite(height)) heights.push_back(height);
        }
        if (!series.points.empty()) chart.series << series;
    };
    if (cost) {
        add(tr("POV-Ray"), orange, [](const SweepPoint& p) { return p.evaluationsPerPixel[0]; });
        add(tr("exact"), blue, [](const SweepPoint& p) { return p.evaluationsPerPixel[1]; });
    } else if (shown == gradient) {
        add(tr("attained"), blue, [](const SweepPoint& p) { return p.gradientLow; });
        add(tr("proven"), green, [](const SweepPoint& p) { return p.gradientHigh; });
    } else {
        add(tr("pieces"), blue, [](const SweepPoint& p) { return static_cast<double>(p.solid.pieces); });
        add(tr("tunnels"), orange, [](const SweepPoint& p) { return static_cast<double>(p.solid.tunnels); });
        add(tr("hollows"), green, [](const SweepPoint& p) { return static_cast<double>(p.solid.hollows); });
    }
    heights.push_back(0);
    chart.x = axisOver(measuredName_, values, measuredByRatio_);
    chart.y = axisOver({}, heights, false);
    if (number() && !values.empty())
        chart.marks << ChartMark{number()->value, tr("now %1").arg(numberText(number()->value)),
                                 view->palette().color(QPalette::Text)};
    view->setAccessibleName(tr("Chart of %1 over %2").arg(chart.title, measuredName_));
    view->setChart(std::move(chart));
}

void SweepPanel::describe() {
    if (points_.empty()) return note_->clear();
    const auto missing = std::ranges::count(points_, false, &SweepPoint::known);
    QString text;
    if (!measuring_ && !fresh())
        text = tr("Measured before the last change of scene or view.");
    else if (!measuring_ && points_.size() < wanted_)
        text = tr("Stopped early.");
    else if (!measuring_)
        text =
            tr("Evaluations of the camera's rays; pieces of a grid of %1 cells.").arg(SweepRequest().cells);
    if (missing > 0) text += ' ' + tr("The scene cannot be read for %1 of the values.").arg(missing);
    note_->setText(text.trimmed());
}

void SweepPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace isoscope
