// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/evaluate_panel.h"

#include <algorithm>
#include <cmath>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/numbers/number_text.h"
#include "widgets/section/surface_chooser.h"

namespace isoscope {

namespace {

constexpr int progressSteps = 1000;

/// As it is written into the text.
QString settingText(const BoundTrial& trial) {
    if (!trial.evaluate) return QStringLiteral("max_gradient %1").arg(numberText(trial.maxGradient));
    const auto& p = *trial.evaluate;
    return QStringLiteral("evaluate %1, %2, %3").arg(numberText(p[0]), numberText(p[1]), numberText(p[2]));
}

}  // namespace

EvaluatePanel::EvaluatePanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    surfaces_ = new SurfaceChooser(tr("The isosurface whose settings are tried."));
    surfaces_->setWhatsThis(surfaces_->toolTip());
    connect(surfaces_, &SurfaceChooser::activated, this, [this] {
        stop();
        advice_ = {};
        refresh();
    });
    row->addWidget(surfaces_);
    start_ = new QPushButton;
    start_->setAccessibleName(tr("Try settings of evaluate, or stop"));
    connect(start_, &QPushButton::clicked, this, [this] { measuring_ ? stop() : measure(); });
    row->addWidget(start_);
    progress_ = new QProgressBar;
    progress_->setRange(0, progressSteps);
    progress_->setFixedWidth(80);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the trials"));
    progress_->setToolTip(tr("How many of the settings are tried"));
    row->addWidget(progress_);
    note_ = new QLabel;
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    note_->setAccessibleDescription(tr("Whether evaluate pays"));
    row->addWidget(note_, 1);
    write_ = new QPushButton(tr("Write Into the Text"));
    write_->setToolTip(tr("Gives the isosurface the chosen setting; Undo takes it back."));
    connect(write_, &QPushButton::clicked, this, [this] {
        const BoundTrial* trial = current();
        if (!trial) return;
        if (trial->evaluate)
            emit evaluateRequested(chosen(), *trial->evaluate);
        else
            emit gradientRequested(chosen(), trial->maxGradient);
    });
    row->addWidget(write_);
    column->addLayout(row);
    list_ = new QTreeWidget;
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels({tr("Setting"), tr("Evaluations per pixel"), tr("Pixels lost or wrong")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setAccessibleName(tr("Settings that were tried"));
    list_->setToolTip(tr("Enter or a double click writes the setting into the text"));
    list_->header()->setSectionsMovable(false);
    list_->header()->resizeSection(
        setting, fontMetrics().horizontalAdvance(tr("evaluate 0.0000, 0.00, 0.00 (pays most)__")));
    list_->header()->resizeSection(cost, fontMetrics().horizontalAdvance(tr("Evaluations per pixel__")));
    connect(list_, &QTreeWidget::itemActivated, write_, &QPushButton::click);
    connect(list_, &QTreeWidget::currentItemChanged, this,
            [this] { write_->setEnabled(current() && !old_); });
    column->addWidget(list_, 1);
    refresh();
}

EvaluatePanel::~EvaluatePanel() { stop_.request_stop(); }

std::size_t EvaluatePanel::chosen() const {
    return static_cast<std::size_t>(std::max(0, surfaces_->currentIndex()));
}

bool EvaluatePanel::hasSubject() const {
    return scene_ && chosen() < scene_->isosurfaces.size() && scene_->isosurfaces[chosen()].shape;
}

void EvaluatePanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    if (!scene_) advice_ = {};
    outdate();
}

void EvaluatePanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    outdate();
}

void EvaluatePanel::setActive(bool active) {
    if (!active && measuring_) stop();
}

void EvaluatePanel::outdate() {
    old_ = advice_.pixels > 0;
    if (measuring_) stop();
    refresh();
}

void EvaluatePanel::stop() {
    stop_.request_stop();
    ++generation_;
    measuring_ = false;
    refresh();
}

void EvaluatePanel::measure() {
    stop();
    if (!hasSubject()) return;
    RenderRequest view;
    view.scene = scene_;
    view.camera = camera_;
    view.width = size_.width();
    view.height = size_.height();
    advice_ = {};
    old_ = false;
    measuring_ = true;
    stop_ = std::stop_source();
    worker_.submit([this, view, isosurface = chosen(), generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        const auto tell = [this, generation](auto action) {
            QMetaObject::invokeMethod(
                this,
                [this, generation, action] {
                    if (generation == generation_) action();
                },
                Qt::QueuedConnection);
        };
        const ShareReport report = [&](double done) {
            tell([this, done] { progress_->setValue(static_cast<int>(std::lround(done * progressSteps))); });
        };
        const EvaluateAdvice advice = adviseEvaluate(view, isosurface, 1, either.token(), report);
        tell([this, advice, generation] { finish(advice, generation); });
    });
    refresh();
}

void EvaluatePanel::finish(const EvaluateAdvice& advice, std::uint64_t generation) {
    if (generation != generation_) return;
    advice_ = advice;
    measuring_ = false;
    refresh();
}

const BoundTrial* EvaluatePanel::current() const {
    const QTreeWidgetItem* item = list_->currentItem();
    if (!item) return nullptr;
    const int index = item->data(setting, Qt::UserRole).toInt();
    if (index < 0) return &advice_.fixed;
    return static_cast<std::size_t>(index) < advice_.trials.size()
               ? &advice_.trials[static_cast<std::size_t>(index)]
               : nullptr;
}

void EvaluatePanel::addRow(const BoundTrial& trial, bool best) {
    auto* row = new QTreeWidgetItem(list_);
    const QString text = settingText(trial);
    row->setText(setting, best ? tr("%1 (pays most)").arg(text) : text);
    row->setText(cost, QString::number(trial.evaluationsPerPixel, 'f', 1));
    row->setText(wrong, tr("%1 of %2").arg(trial.mistakes).arg(advice_.pixels));
    row->setData(setting, Qt::UserRole,
                 &trial == &advice_.fixed ? -1 : static_cast<int>(&trial - advice_.trials.data()));
    if (best) list_->setCurrentItem(row);
}

void EvaluatePanel::refresh() {
    start_->setText(measuring_ ? tr("Stop") : advice_.complete ? tr("Measure Again") : tr("Measure"));
    start_->setToolTip(measuring_ ? tr("End the trials")
                                  : tr("Tries numbers of evaluate in a small picture of this view"));
    start_->setEnabled(hasSubject());
    progress_->setVisible(measuring_);
    if (!measuring_) progress_->setValue(0);
    list_->clear();
    const BoundTrial* best = advice_.best();
    if (advice_.fixed.maxGradient > 0) addRow(advice_.fixed, !best);
    std::vector<const BoundTrial*> order;
    for (const BoundTrial& trial : advice_.trials) order.push_back(&trial);
    std::ranges::stable_sort(
        order, {}, [](const BoundTrial* one) { return std::pair(one->mistakes, one->evaluationsPerPixel); });
    for (const BoundTrial* trial : order) addRow(*trial, trial == best);
    write_->setEnabled(current() && !old_);
    if (!hasSubject())
        note_->setText(tr("The scene has no isosurface."));
    else if (measuring_)
        note_->setText(tr("Each setting is tried in a small picture of this view…"));
    else if (!advice_.complete)
        note_->setText(tr("What evaluate would cost and lose in this view, beside the proven max_gradient."));
    else if (old_)
        note_->setText(tr("Measured before the last change of scene or view."));
    else if (!best)
        note_->setText(tr("evaluate does not pay in this view."));
    else if (advice_.fixed.maxGradient > 0)
        note_->setText(
            tr("evaluate saves %1 % of the evaluations in this view.")
                .arg(std::lround(100 * (1 - best->evaluationsPerPixel / advice_.fixed.evaluationsPerPixel))));
    else
        note_->setText(
            tr("No max_gradient is proven to be enough; this evaluate loses nothing in this view."));
}

}  // namespace isoscope
