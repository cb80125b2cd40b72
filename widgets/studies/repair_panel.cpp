// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/repair_panel.h"

#include <algorithm>
#include <cmath>
#include <QHeaderView>
#include <QLabel>
#include <QIcon>
#include <QPixmap>
#include <QPushButton>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/exchange/gradient_repairs.h"
#include "widgets/numbers/number_text.h"
#include "widgets/progress_row.h"
#include "widgets/studies/share_text.h"
#include "widgets/verdicts/verdict_symbol.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

/// "line 12", or "part.inc:3" of an include file; how many isosurfaces a statement makes behind it.
QString placeText(const StatementVerdict& statement, const SourceLibrary& sources) {
    const SourceText& source = sources[statement.range.file];
    const int line = source.position(statement.range.begin).line;
    const QString place = statement.range.file == 0 ? RepairPanel::tr("line %1").arg(line)
                                                    : QString::fromStdString(source.name()).section('/', -1) +
                                                          ':' + QString::number(line);
    const auto count = statement.isosurfaces.size();
    return count == 1 ? place : RepairPanel::tr("%1, %2 times").arg(place).arg(count);
}

QString provenText(const StatementVerdict& statement) {
    const QString lower = VerdictText::number(statement.lower);
    if (!std::isfinite(statement.lower)) return lower;
    if (!std::isfinite(statement.upper)) return RepairPanel::tr("at least %1").arg(lower);
    const QString upper = VerdictText::number(statement.upper);
    return lower == upper ? lower : lower + QStringLiteral(" – ") + upper;
}

QString wrongText(const StatementVerdict& statement, std::uint64_t pixels) {
    if (statement.mistakes > 0)
        return QStringLiteral("%1 (%2)").arg(formatCount(statement.mistakes),
                                             formatShare(statement.mistakes, pixels));
    return statement.counted ? RepairPanel::tr("none") : QStringLiteral("…");
}

QString timeText(const StatementVerdict& statement) {
    constexpr double noticeable = 1.05;
    if (statement.waste && *statement.waste >= noticeable)
        return RepairPanel::tr("%1 times as long").arg(QString::number(*statement.waste, 'g', 2));
    return statement.verdict == GradientVerdict::wasteful && !statement.waste ? QStringLiteral("…")
                                                                              : QString();
}

}  // namespace

/// As wide as the box of a row that can be ticked, so that all places stand below each other.
QIcon RepairPanel::noBox() const {
    const int width = list_->style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, list_);
    QPixmap empty(width, width);
    empty.fill(Qt::transparent);
    return empty;
}

RepairPanel::RepairPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    buildList();
    column->addWidget(list_, 1);
    buildRow();
    column->addWidget(row_);
    showState(false, false);
}

void RepairPanel::buildList() {
    list_ = new QTreeWidget;
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels({tr("Isosurface"), QStringLiteral("max_gradient"), tr("Proven"), tr("To write"),
                            tr("Wrong pixels"), tr("POV-Ray takes"), tr("Verdict")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setAllColumnsShowFocus(true);
    list_->setAccessibleName(tr("Isosurfaces of the scene and its include files"));
    list_->setToolTip(
        tr("What is ticked is written by the button below; a double click, or Enter, shows the place"));
    QHeaderView* header = list_->header();
    header->setSectionsMovable(false);
    const auto room = [&](Column which, const QString& text) {
        // The titles differ in length from language to language.
        const QString title = list_->headerItem()->text(which) + QStringLiteral("___");
        header->resizeSection(
            which, std::max(fontMetrics().horizontalAdvance(text), fontMetrics().horizontalAdvance(title)));
    };
    room(place, tr("include_file.inc:1000, 100 times_____"));
    room(setting, QStringLiteral("max_gradient____"));
    room(proven, QStringLiteral("0.00000 – 0.00000___"));
    room(toWrite, tr("To write") + QStringLiteral("______"));
    room(wrong, QStringLiteral("10 000 (99.9 %)___"));
    room(time, tr("%1 times as long").arg(QStringLiteral("100__")));
    header->setSectionResizeMode(verdict, QHeaderView::ResizeToContents);
    header->setStretchLastSection(false);
    connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
        const auto index = static_cast<std::size_t>(list_->indexOfTopLevelItem(row));
        if (index < statements_.size()) emit placeRequested(statements_[index].range);
    });
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row) {
        const auto index = static_cast<std::size_t>(list_->indexOfTopLevelItem(row));
        if (filling_ || index >= statements_.size()) return;
        const Key key{statements_[index].range.file, statements_[index].range.begin};
        row->checkState(place) == Qt::Checked ? void(unticked_.erase(key)) : void(unticked_.insert(key));
        showChoice();
    });
}

QLabel* RepairPanel::note() const { return row_->note(); }

QPushButton* RepairPanel::stopButton() const { return row_->button(); }

void RepairPanel::buildRow() {
    row_ = new ProgressRow({tr("How far the isosurfaces are judged"), tr("Progress of the proofs"),
                            tr("How many isosurfaces are judged"), tr("Stop the proofs or go on")});
    connect(row_->button(), &QPushButton::clicked, this,
            [this] { stopped_ ? emit goOnRequested() : emit stopRequested(); });
    tick_ = new QPushButton;
    tick_->setAccessibleName(tr("Tick all or none"));
    connect(tick_, &QPushButton::clicked, this, &RepairPanel::tickAll);
    row_->add(tick_);
    write_ = new QPushButton;
    write_->setToolTip(
        tr("Writes what is ticked where it stands: into the text, where Undo takes it back, and into the "
           "include files in the folder of the scene; every other character stays"));
    write_->setAccessibleName(tr("Write the ticked values"));
    connect(write_, &QPushButton::clicked, this, [this] {
        const auto values = chosenValues();
        if (!values.empty()) emit repairRequested(values);
    });
    row_->add(write_);
}

void RepairPanel::leaveDocument() {
    unticked_.clear();
    show(nullptr, {}, false, false);
}

void RepairPanel::show(const std::shared_ptr<const ParseResult>& parsed,
                       const std::vector<SurfaceVerdict>& verdicts, bool busy, bool stopped) {
    const bool another = parsed != parsed_;
    parsed_ = parsed;
    if (another) lookAtFiles();
    // While the text is newer the rows stay, pale: they come back a moment later.
    list_->setEnabled(parsed != nullptr);
    if (parsed && parsed->scene) {
        statements_ = statementVerdicts(verdicts, *parsed->scene);
        showRows(verdicts);
    } else if (verdicts.empty()) {
        statements_.clear();
        list_->clear();
    }
    showState(busy, stopped);
}

void RepairPanel::lookAtFiles() {
    obstacles_.clear();
    if (!parsed_ || !parsed_->scene) return;
    for (const SceneIsosurface& one : parsed_->scene->isosurfaces) {
        const std::uint32_t file = one.range.file;
        if (file == 0 || obstacles_.contains(file)) continue;
        obstacles_[file] = QString::fromStdString(
            GradientRepairs::obstacle(*parsed_, file, sceneFile_ ? sceneFile_() : std::filesystem::path()));
    }
}

QString RepairPanel::obstacleOf(const StatementVerdict& statement) const {
    const auto found = obstacles_.find(statement.range.file);
    if (found != obstacles_.end() && !found->second.isEmpty())
        return tr("The file is not changed: %1.").arg(found->second);
    GradientRepairs repairs(*parsed_);
    return repairs.add(statement.isosurfaces.front(), *statement.needed)
               ? QString()
               : tr("The value cannot be written where the statement stands.");
}

bool RepairPanel::isChosen(const StatementVerdict& statement) const {
    return parsed_ && statement.mendable() && obstacleOf(statement).isEmpty() &&
           !unticked_.contains({statement.range.file, statement.range.begin});
}

void RepairPanel::showRows(const std::vector<SurfaceVerdict>& verdicts) {
    std::map<std::size_t, const SurfaceVerdict*> byNumber;
    for (const SurfaceVerdict& one : verdicts) byNumber[one.isosurface] = &one;
    filling_ = true;
    while (list_->topLevelItemCount() > static_cast<int>(statements_.size()))
        delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
    while (list_->topLevelItemCount() < static_cast<int>(statements_.size())) new QTreeWidgetItem(list_);
    for (std::size_t i = 0; i < statements_.size(); ++i) {
        const auto& numbers = statements_[i].isosurfaces;
        const auto worst = std::ranges::max_element(numbers, {}, [&](std::size_t number) {
            const SurfaceVerdict& one = *byNumber[number];
            return std::pair(badness(one.verdict()), one.effects ? one.effects->mistakes : 0);
        });
        fill(list_->topLevelItem(static_cast<int>(i)), statements_[i], *byNumber[*worst]);
    }
    filling_ = false;
}

void RepairPanel::fill(QTreeWidgetItem* row, const StatementVerdict& statement, const SurfaceVerdict& worst) {
    const bool mendable = statement.mendable();
    const QString obstacle = mendable ? obstacleOf(statement) : QString();
    const bool free = mendable && obstacle.isEmpty();
    row->setFlags(free ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable
                       : Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    if (free)
        row->setCheckState(place, isChosen(statement) ? Qt::Checked : Qt::Unchecked);
    else
        row->setData(place, Qt::CheckStateRole, {});
    row->setIcon(place, free ? QIcon() : noBox());
    row->setText(place, placeText(statement, *parsed_->sources));
    row->setText(setting, numberText(statement.setting));
    row->setText(proven, provenText(statement));
    row->setText(toWrite, mendable ? numberText(*statement.needed) : QString());
    row->setText(wrong, wrongText(statement, worst.pixels));
    row->setText(time, timeText(statement));
    row->setText(RepairPanel::verdict, VerdictText::word(worst));
    row->setIcon(RepairPanel::verdict, verdictIcon(worst.verdict(), lookOf(palette())));
    const QString says = VerdictText::plain(worst) + ' ' + VerdictText::exact(worst) +
                         (obstacle.isEmpty() ? QString() : ' ' + obstacle);
    for (int k = 0; k < columnCount; ++k) row->setToolTip(k, says);
}

void RepairPanel::showState(bool busy, bool stopped) {
    stopped_ = stopped;
    const auto judged =
        std::ranges::count_if(statements_, [](const auto& one) { return one.verdict.has_value(); });
    const auto all = static_cast<int>(statements_.size());
    row_->setWorking(busy, stopped
                               ? ProgressRow::Button{tr("Go On"), tr("Go on with the proofs")}
                               : ProgressRow::Button{tr("Stop"), tr("End the proofs; what is known stays")});
    row_->setProgress(static_cast<double>(judged) / std::max(1, all));
    row_->button()->setVisible(busy || stopped);
    if (statements_.empty())
        note()->setText(busy ? tr("The isosurfaces are being judged…")
                             : tr("The scene shows no isosurface that has a max_gradient."));
    else if (busy || stopped)
        note()->setText(tr("%1 of %2 statements are judged.").arg(judged).arg(all));
    else if (std::ranges::none_of(statements_, &StatementVerdict::mendable))
        note()->setText(tr("There is nothing to repair."));
    else
        note()->setText(
            tr("Wrong pixels and time are those of this view; what is written is proven for "
               "every view."));
    showChoice();
}

void RepairPanel::showChoice() {
    int chosen = 0, free = 0;
    for (const StatementVerdict& one : statements_) {
        if (!parsed_ || !one.mendable() || !obstacleOf(one).isEmpty()) continue;
        ++free;
        chosen += isChosen(one) ? 1 : 0;
    }
    tick_->setVisible(free > 1);
    tick_->setText(chosen < free ? tr("Tick All") : tr("Tick None"));
    tick_->setToolTip(tr("Ticks all rows that can be written, or none"));
    write_->setText(chosen == 0   ? tr("Write")
                    : chosen == 1 ? tr("Write 1 Value")
                                  : tr("Write %1 Values").arg(chosen));
    write_->setEnabled(chosen > 0);
}

void RepairPanel::tickAll() {
    const bool all = std::ranges::all_of(statements_, [this](const StatementVerdict& one) {
        return !one.mendable() || !obstacleOf(one).isEmpty() || isChosen(one);
    });
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = list_->topLevelItem(i);
        if (row->flags() & Qt::ItemIsUserCheckable)
            row->setCheckState(place, all ? Qt::Unchecked : Qt::Checked);
    }
}

std::map<std::size_t, double> RepairPanel::chosenValues() const {
    std::map<std::size_t, double> values;
    for (const StatementVerdict& one : statements_)
        if (isChosen(one))
            for (const std::size_t number : one.isosurfaces) values[number] = *one.needed;
    return values;
}

}  // namespace isoscope
