// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/effects_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/roots/verdict.h"
#include "widgets/elided_label.h"
#include "widgets/timing.h"
#include "widgets/studies/share_text.h"
#include "widgets/viewport/viewport_panel.h"

namespace isoscope {

namespace {

constexpr int longestMovingTime = 10000;  ///< milliseconds
constexpr int kindRole = Qt::UserRole;

/// Begins with a capital, unless with a word of the language ("light_source").
QString sentence(const std::string& text) {
    QString sentence = QString::fromStdString(text);
    if (!sentence.isEmpty() && !sentence.section(QLatin1Char(' '), 0, 0).contains(QLatin1Char('_')))
        sentence[0] = sentence[0].toUpper();
    return sentence;
}

QString shortMilliseconds(double seconds) {
    const double milliseconds = 1000 * seconds;
    return QString::number(milliseconds, 'f', milliseconds < 100 ? 1 : 0);
}

QString timeInWords(const RenderStatistics& statistics) {
    const QString time =
        EffectsPanel::tr("%1 ms of processor time").arg(shortMilliseconds(statistics.cpuSeconds));
    return statistics.cutSamples == 0 ? time : EffectsPanel::tr("Some light is cut short; %1").arg(time);
}

/// How many rays of the camera meet something, and nothing.
QString rootsInWords(const RenderStatistics& statistics) {
    std::uint64_t roots = 0, misses = 0, open = 0;
    for (const auto& [verdict, count] : statistics.verdicts) {
        const bool miss = verdict == "miss" || verdict == name(Verdict::certifiedMiss);
        const bool uncertain = verdict == name(Verdict::gap) || verdict == name(Verdict::budgetExceeded) ||
                               verdict == name(Verdict::notCertified);
        (miss ? misses : uncertain ? open : roots) += count;
    }
    const QString known =
        EffectsPanel::tr("%1 roots, %2 misses").arg(formatCount(roots), formatCount(misses));
    return open == 0 ? known : known + EffectsPanel::tr(", %1 not certain").arg(formatCount(open));
}

/// What the summary has no room for.
QString costInWords(const RenderStatistics& statistics) {
    const QString cost = EffectsPanel::tr("%1 rays, %2 evaluations")
                             .arg(shortCount(statistics.rays), shortCount(statistics.evaluations));
    const std::string cut = cutWarning(statistics);
    return cut.empty() ? cost : cost + QStringLiteral("\n") + QString::fromStdString(cut) + QLatin1Char('.');
}

}  // namespace

EffectsPanel::EffectsPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    buildTable();
    column->addWidget(table_, 1);
    auto* line = new QHBoxLayout;
    column->addLayout(line);
    sum_ = new ElidedLabel;
    sum_->setAccessibleDescription(tr("Cost of all stages"));
    line->addWidget(sum_, 1);
    auto* label = new QLabel(tr("While &moving at most"));
    line->addWidget(label);
    movingTime_ = new QSpinBox;
    movingTime_->setRange(0, longestMovingTime);
    movingTime_->setSingleStep(50);
    movingTime_->setSuffix(tr(" ms"));
    movingTime_->setSpecialValueText(tr("no limit"));
    movingTime_->setKeyboardTracking(false);
    movingTime_->setAccessibleName(tr("Time for a moving picture"));
    movingTime_->setToolTip(tr(
        "While the view or a number moves, the dearest effects are left out until a picture takes no longer; "
        "they come back at rest"));
    label->setToolTip(movingTime_->toolTip());
    label->setBuddy(movingTime_);
    line->addWidget(movingTime_);
    connect(movingTime_, &QSpinBox::valueChanged, this,
            [this](int most) { emit movingSecondsChanged(most / 1000.0); });
    outlineMarks();
    connect(table_, &QTreeWidget::itemChanged, this, &EffectsPanel::noteSwitch);
    refresh();
}

void EffectsPanel::buildTable() {
    table_ = new QTreeWidget;
    table_->setColumnCount(columnCount);
    table_->setHeaderLabels(
        {QString(), tr("Effect"), tr("Rays"), tr("Evaluations"), tr("CPU ms"), tr("Why")});
    table_->setRootIsDecorated(false);
    table_->setUniformRowHeights(true);
    table_->setAlternatingRowColors(true);
    table_->setAccessibleName(tr("Effects of the picture"));
    table_->setToolTip(tr("What the picture is made of, and what each part has cost"));
    for (int column = rays; column <= milliseconds; ++column)
        table_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    const std::array<QString, columnCount> help{
        tr("Without its mark an effect is left out of this view, never of an exported picture"),
        tr("Stages of drawing, in their order"),
        tr("Rays that the effect has sent"),
        tr("Evaluations of functions that it has caused"),
        tr("Processor time of all threads, in milliseconds"),
        tr("What in the scene calls for it, or why nothing does")};
    for (int column = 0; column < columnCount; ++column)
        table_->headerItem()->setToolTip(column, help[static_cast<std::size_t>(column)]);
    for (std::size_t i = 0; i < stageKindCount; ++i) {
        auto* row = new QTreeWidgetItem(table_);
        row->setData(mark, kindRole, static_cast<int>(i));
        row->setText(effect, sentence(name(static_cast<StageKind>(i))));
        row->setData(mark, Qt::AccessibleTextRole, row->text(effect));
        row->setToolTip(mark, table_->headerItem()->toolTip(mark));
        for (int column = rays; column <= milliseconds; ++column)
            row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        rows_[i] = row;
    }
    QHeaderView* header = table_->header();
    header->setSectionsMovable(false);
    header->setStretchLastSection(true);
    header->setSectionResizeMode(mark, QHeaderView::ResizeToContents);
    header->setSectionResizeMode(effect, QHeaderView::ResizeToContents);
    for (int column = rays; column <= milliseconds; ++column)
        header->resizeSection(column,
                              table_->fontMetrics().horizontalAdvance(QStringLiteral("Evaluations_")));
}

void EffectsPanel::setMovingSeconds(double seconds) {
    const QSignalBlocker quiet(movingTime_);
    movingTime_->setValue(qRound(1000 * seconds));
}

void EffectsPanel::show(const RenderProgress& progress) {
    progress_ = progress;
    // Numbers that change sixty times a second cannot be read.
    const bool tooSoon = !progress.finished && shown_.isValid() && shown_.elapsed() < timing::busyMarkDelay;
    if (isVisible() && !tooSoon) refresh();
}

void EffectsPanel::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

QString EffectsPanel::summary() const { return sum_->text(); }

void EffectsPanel::refresh() {
    shown_.start();
    const QSignalBlocker quiet(table_);
    const RenderStatistics& statistics = progress_.statistics;
    const bool nothing = progress_.job == 0;
    for (QTreeWidgetItem* row : rows_) row->setHidden(nothing);
    for (const StageReport& report : statistics.stages) showStage(report);
    for (const PlannedStage& stage : statistics.leftOut) showIdle(stage, true);
    for (const PlannedStage& stage : statistics.notCalledFor) showIdle(stage, false);
    sortRows();
    sum_->setText(nothing ? tr("No picture yet")
                          : rootsInWords(statistics) + QStringLiteral("; ") + timeInWords(statistics));
    sum_->setToolTip(nothing ? QString() : costInWords(statistics));
}

void EffectsPanel::sortRows() {
    QList<QTreeWidgetItem*> order;
    for (const bool struckOut : {false, true})
        for (QTreeWidgetItem* row : rows_)
            if (row->font(effect).strikeOut() == struckOut) order << row;
    for (int i = 0; i < order.size(); ++i) {
        if (table_->topLevelItem(i) == order[i]) continue;
        table_->takeTopLevelItem(table_->indexOfTopLevelItem(order[i]));
        table_->insertTopLevelItem(i, order[i]);
    }
}

/// Fusion outlines marks in a darker shade of the window's colour, which a dark table swallows.
void EffectsPanel::outlineMarks() {
    QPalette colors = palette();
    colors.setColor(QPalette::Window, colors.color(QPalette::PlaceholderText));
    table_->setPalette(colors);
}

void EffectsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        outlineMarks();
        refresh();
    }
    QWidget::changeEvent(event);
}

void EffectsPanel::showStage(const StageReport& report) {
    QTreeWidgetItem* row = this->row(report.kind);
    const auto count = [](std::uint64_t number) { return number > 0 ? shortCount(number) : QString(); };
    row->setText(rays, count(report.rays));
    row->setText(evaluations, count(report.evaluations));
    row->setText(milliseconds, shortMilliseconds(report.cpuSeconds));
    row->setText(reason, sentence(report.reason));
    row->setToolTip(reason, row->text(reason));
    QFont font = table_->font();
    for (int column = 0; column < columnCount; ++column) {
        row->setFont(column, font);
        row->setData(column, Qt::ForegroundRole, {});
    }
    if (canBeLeftOut(report.kind)) row->setCheckState(mark, Qt::Checked);
}

void EffectsPanel::showIdle(const PlannedStage& stage, bool calledFor) {
    QTreeWidgetItem* row = this->row(stage.kind);
    for (int column = rays; column <= milliseconds; ++column) row->setText(column, {});
    const bool switchedOff = calledFor && leftOut_.has(stage.kind);
    row->setText(reason, !calledFor    ? sentence(stage.reason)
                         : switchedOff ? tr("Left out of this view. %1").arg(sentence(stage.reason))
                                       : tr("Left out while moving. %1").arg(sentence(stage.reason)));
    row->setToolTip(reason, row->text(reason));
    QFont font = table_->font();
    font.setStrikeOut(!calledFor);
    row->setFont(effect, font);
    for (int column = 0; column < columnCount; ++column)
        row->setForeground(column, palette().brush(QPalette::PlaceholderText));
    if (!calledFor)
        row->setData(mark, Qt::CheckStateRole, {});
    else
        row->setCheckState(mark, switchedOff ? Qt::Unchecked : Qt::PartiallyChecked);
}

void EffectsPanel::noteSwitch(QTreeWidgetItem* item, int column) {
    if (column != mark) return;
    const auto kind = static_cast<StageKind>(item->data(mark, kindRole).toInt());
    const bool out = item->checkState(mark) == Qt::Unchecked;
    if (leftOut_.has(kind) == out) return;
    leftOut_.set(kind, out);
    emit leftOutChanged(leftOut_);
}

}  // namespace isoscope
