// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/report_panel.h"

#include <algorithm>
#include <cmath>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/study/gradient/function_likeness.h"
#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/progress_row.h"
#include "widgets/section/surface_chooser.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

/// Of all the work, that the report takes.
constexpr double reportShare = 0.6;

/// Whether both scenes have the same isosurface number `i`.
bool sameSurface(const Scene& a, const Scene& b, std::size_t i) {
    if (i >= a.isosurfaces.size() || i >= b.isosurfaces.size()) return false;
    const auto &one = a.isosurfaces[i].shape, &other = b.isosurfaces[i].shape;
    if (!one || !other) return false;
    const IsosurfaceSettings &s = one->settings(), &t = other->settings();
    return s.threshold == t.threshold && s.positivePolarity == t.positivePolarity &&
           s.accuracy == t.accuracy && sameContainer(s.container, t.container) &&
           sameFunction(*one->tape(), *a.parameterTable, *other->tape(), *b.parameterTable);
}

QString words(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString kindText(const HealthFinding& finding) {
    switch (finding.ailment) {
        case Ailment::undefined: return ReportPanel::tr("no value");
        case Ailment::infinite: return ReportPanel::tr("infinite, or infinitely steep");
        case Ailment::jump:
            return finding.confirmed ? ReportPanel::tr("jumps by %1").arg(finding.size, 0, 'g', 3)
                                     : ReportPanel::tr("jumps");
        case Ailment::cancellation:
            return ReportPanel::tr("digits lost: off by up to %1").arg(finding.size, 0, 'g', 2);
        case Ailment::kink: break;
    }
    return ReportPanel::tr("kink");
}

}  // namespace

ReportPanel::ReportPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    surfaces_ = new SurfaceChooser(tr("The isosurface that is reported on."));
    surfaces_->setWhatsThis(surfaces_->toolTip());
    connect(surfaces_, &SurfaceChooser::activated, this, [this] {
        stopWork(true);
        refresh();
        beginIfWanted();
    });
    column->addWidget(surfaces_);
    auto* both = new QSplitter;
    both->setChildrenCollapsible(false);
    text_ = new QPlainTextEdit;
    text_->setReadOnly(true);
    // Keys move a caret, so that what is read aloud can be walked through.
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text_->setTabChangesFocus(true);
    text_->setAccessibleName(tr("Report on the shape"));
    text_->setToolTip(tr("What the solid is like, each with its proof or its error"));
    both->addWidget(text_);
    both->addWidget(buildHealth());
    both->setStretchFactor(0, 1);
    both->setStretchFactor(1, 1);
    column->addWidget(both, 1);
    row_ = new ProgressRow({tr("What the chosen place does to the pictures"), tr("Progress of the report"),
                            tr("How much of the report is done"), tr("Report or stop")});
    connect(row_->button(), &QPushButton::clicked, this, [this] {
        declined_ = working_;
        if (!working_) return work();
        stopWork(false);
        refresh();
    });
    row_->add(goThere_);
    row_->add(rewrite_);
    column->addWidget(row_);
    refresh();
}

ReportPanel::~ReportPanel() { stop_.request_stop(); }

QWidget* ReportPanel::buildHealth() {
    list_ = new QTreeWidget;
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels(
        {tr("The function has"), tr("From the surface"), tr("Certainty"), tr("Where"), tr("Remedy")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setAccessibleName(tr("Places where the function is not healthy"));
    list_->setToolTip(tr("A click, or Enter, shows the place in the picture; a click on a remedy writes it"));
    QHeaderView* header = list_->header();
    header->setSectionsMovable(false);
    header->setStretchLastSection(true);
    goThere_ = new QPushButton(tr("Go There"));
    goThere_->setToolTip(tr("Shows the place in the picture."));
    goThere_->setAccessibleName(tr("Show the chosen place in the picture"));
    connect(list_, &QTreeWidget::itemActivated, goThere_, &QPushButton::click);
    connect(list_, &QTreeWidget::itemClicked, this, [this](const QTreeWidgetItem*, int column) {
        if (column == remedy && current() && rewriteFor(*current())) return rewriteCurrent();
        goThere_->click();
    });
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        goThere_->setEnabled(current());
        rewrite_->setEnabled(current() && rewriteFor(*current()));
        row_->note()->setText(current() ? words(consequence(current()->ailment)) : QString());
    });
    connect(goThere_, &QPushButton::clicked, this, [this] {
        if (current()) emit placeRequested(current()->place);
    });
    rewrite_ = new QPushButton(tr("Rewrite"));
    rewrite_->setToolTip(tr("Changes the text so; Undo takes it back."));
    rewrite_->setAccessibleName(tr("Write the remedy of the chosen place into the text"));
    connect(rewrite_, &QPushButton::clicked, this, &ReportPanel::rewriteCurrent);
    return list_;
}

std::size_t ReportPanel::chosen() const {
    return static_cast<std::size_t>(std::max(0, surfaces_->currentIndex()));
}

const SceneIsosurface* ReportPanel::subject() const {
    if (!scene_ || chosen() >= scene_->isosurfaces.size()) return nullptr;
    const SceneIsosurface& one = scene_->isosurfaces[chosen()];
    return one.shape ? &one : nullptr;
}

const HealthFinding* ReportPanel::current() const {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    return row >= 0 && static_cast<std::size_t>(row) < health_.findings.size()
               ? &health_.findings[static_cast<std::size_t>(row)]
               : nullptr;
}

void ReportPanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    const bool same = scene_ && scene && sameSurface(*scene_, *scene, chosen());
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    if (!same) {
        stopWork(true);
        declined_ = false;
        refresh();
    }
    beginIfWanted();
}

void ReportPanel::setActive(bool active) {
    active_ = active;
    if (!active) stopWork(false);
    refresh();
    beginIfWanted();
}

void ReportPanel::setResting(bool resting) {
    resting_ = resting;
    beginIfWanted();
}

void ReportPanel::stopWork(bool forget) {
    stop_.request_stop();
    ++generation_;
    working_ = false;
    if (!forget) return;
    report_ = {};
    health_ = {};
    rewrites_.clear();
    rewritesOf_ = nullptr;
    complete_ = false;
}

void ReportPanel::beginIfWanted() {
    if (!active_ || !resting_ || working_ || declined_ || !subject()) return;
    if (!complete_)
        work();
    else if (wantsRewrites())
        searchRewrites();
}

/// In the window's thread, unless the work has become another one.
template <class Action>
void ReportPanel::tell(std::uint64_t generation, Action action) {
    QMetaObject::invokeMethod(
        this,
        [this, generation, action = std::move(action)] {
            if (generation == generation_) action();
        },
        Qt::QueuedConnection);
}

void ReportPanel::work() {
    if (!subject()) return;
    stopWork(true);
    declined_ = false;
    working_ = true;
    stop_ = std::stop_source();
    worker_.submit([this, shape = subject()->shape, parameters = scene_->parameterTable,
                    generation = generation_, stop = stop_.get_token()](std::stop_token closing) {
        // It goes on while something moves.
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        const auto progress = [&](double from, double share) {
            return [this, generation, from, share](double done) {
                tell(generation, [this, value = from + share * done] { row_->setProgress(value); });
            };
        };
        const ShapeReport report =
            shapeReport(shape, *parameters, 64, progress(0, reportShare), either.token());
        tell(generation, [this, report] {
            report_ = report;
            refresh();
        });
        const FunctionHealth health =
            functionHealth(*shape, *parameters, {}, progress(reportShare, 1 - reportShare), either.token());
        tell(generation, [this, health] {
            health_ = health;
            working_ = false;
            complete_ = true;
            refresh();
            beginIfWanted();
        });
    });
    refresh();
}

bool ReportPanel::wantsRewrites() const {
    const bool mendable = std::ranges::any_of(health_.findings, [](const HealthFinding& finding) {
        for (const RewriteKind rewrite :
             {RewriteKind::squared, RewriteKind::overflow, RewriteKind::cancellation, RewriteKind::angle})
            if (helps(rewrite, finding.ailment)) return true;
        return false;
    });
    const auto parsed = mendable && reader_ ? reader_() : nullptr;
    return parsed && parsed != rewritesOf_ && parsed->scene && chosen() < parsed->scene->isosurfaces.size();
}

void ReportPanel::searchRewrites() {
    stopWork(false);
    working_ = true;
    rewritesOf_ = reader_();  // stopped, it is not begun again
    rewrites_.clear();
    stop_ = std::stop_source();
    worker_.submit([this, parsed = rewritesOf_, isosurface = chosen(), generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        const auto rewrites = formulaRewrites(
            *parsed, isosurface,
            [&](double done) { tell(generation, [this, done] { row_->setProgress(done); }); },
            either.token());
        tell(generation, [this, rewrites] {
            rewrites_ = rewrites;
            working_ = false;
            refresh();
        });
    });
    refresh();
}

const FormulaRewrite* ReportPanel::rewriteFor(const HealthFinding& finding) const {
    if (!rewritesOf_ || !reader_ || reader_() != rewritesOf_) return nullptr;
    const auto found = std::ranges::find_if(
        rewrites_, [&](const FormulaRewrite& one) { return helps(one.kind, finding.ailment); });
    return found == rewrites_.end() ? nullptr : &*found;
}

void ReportPanel::rewriteCurrent() {
    const FormulaRewrite* rewrite = current() ? rewriteFor(*current()) : nullptr;
    if (!rewrite) return;
    const QuickFix fix = rewrite->fix;  // the list changes with the text
    emit fixRequested(fix);
}

void ReportPanel::refresh() {
    row_->setWorking(
        working_, working_ ? ProgressRow::Button{tr("Stop"), tr("End the work")}
                           : ProgressRow::Button{tr("Report"), tr("Find out what the isosurface is like")});
    row_->button()->setVisible(subject() && (!complete_ || working_));
    QStringList lines;
    if (!subject())
        lines << tr("The scene has no isosurface.");
    else if (report_.known || complete_)
        for (const ReportLine& line : linesOf(report_))
            lines << tr("%1: %2").arg(QString::fromStdString(line.topic), QString::fromStdString(line.text));
    else
        lines << (working_ ? tr("Being found out…") : tr("It is found out once nothing moves."));
    const QString text = lines.join(QLatin1Char('\n'));
    // The caret of one who reads stays where it is.
    if (text_->toPlainText() != text) text_->setPlainText(text);
    showHealth();
}

void ReportPanel::showHealth() {
    const QSignalBlocker quiet(list_);
    const int before = list_->indexOfTopLevelItem(list_->currentItem());
    bool remedies = false;
    list_->clear();
    for (const HealthFinding& finding : health_.findings) {
        auto* row = new QTreeWidgetItem(list_);
        row->setText(kind, kindText(finding));
        row->setText(distance, finding.distance < health_.resolution
                                   ? tr("at the surface")
                                   : tr("%1 away").arg(finding.distance, 0, 'g', 3));
        row->setText(certainty, finding.confirmed ? tr("met") : tr("suspected"));
        row->setText(place, VerdictText::place(finding.place));
        for (int k = 0; k < columnCount; ++k) row->setToolTip(k, words(consequence(finding.ailment)));
        if (const FormulaRewrite* rewrite = rewriteFor(finding)) {
            remedies = true;
            row->setText(remedy, QString::fromStdString(rewrite->fix.title));
            row->setForeground(remedy, palette().link());
            QFont link = list_->font();
            link.setUnderline(true);
            row->setFont(remedy, link);
            row->setToolTip(remedy,
                            tr("A click writes it: %1").arg(QString::fromStdString(describe(*rewrite))));
        }
    }
    for (const int column : {kind, distance, certainty}) list_->resizeColumnToContents(column);
    // Without remedies the places take all the room.
    list_->setColumnHidden(remedy, !remedies);
    list_->header()->resizeSection(
        place, fontMetrics().horizontalAdvance(remedies ? QStringLiteral("<-0.0000, -0.0000, -0.0000>__")
                                                        : QStringLiteral("0")));
    rewrite_->setVisible(remedies);
    rewrite_->setEnabled(false);
    goThere_->setEnabled(false);
    if (!complete_)
        row_->note()->clear();
    else if (health_.findings.empty())
        row_->note()->setText(
            tr("The function has a value and a slope everywhere in the container, and no kink."));
    else
        row_->note()->setText(
            health_.finished ? tr("Choose a place to see it, and what it does to the pictures.")
                             : tr("Choose a place to see it. The search ended early: there may be more."));
    // What was chosen stays so when remedies are found.
    if (before < 0 || before >= list_->topLevelItemCount()) return;
    list_->setCurrentItem(list_->topLevelItem(before));
    goThere_->setEnabled(current());
    rewrite_->setEnabled(current() && rewriteFor(*current()));
    if (current()) row_->note()->setText(words(consequence(current()->ailment)));
}

}  // namespace isoscope
