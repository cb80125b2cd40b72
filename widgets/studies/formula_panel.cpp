// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/formula_panel.h"

#include <algorithm>
#include <cmath>
#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/study/rewrites/function_texts.h"
#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/progress_row.h"
#include "widgets/section/surface_chooser.h"

namespace isoscope {

namespace {

QString gainText(const FormulaRewrite& rewrite) {
    const double share = rewrite.nanoseconds[1] / rewrite.nanoseconds[0];
    switch (rewrite.kind) {
        case RewriteKind::squared: return FormulaPanel::tr("no infinite slope");
        case RewriteKind::overflow: return FormulaPanel::tr("no overflow");
        case RewriteKind::cancellation:
            return rewrite.off[1] > 0
                       ? FormulaPanel::tr("%1 times as exact").arg(rewrite.off[0] / rewrite.off[1], 0, 'g', 2)
                       : FormulaPanel::tr("exact");
        default: break;
    }
    return share < 1 ? FormulaPanel::tr("%1 % less time").arg(std::lround(100 * (1 - share)))
                     : FormulaPanel::tr("no seam");
}

QString proofText(RewriteProof proof) {
    switch (proof) {
        case RewriteProof::same: return FormulaPanel::tr("the same operations");
        case RewriteProof::identity: return FormulaPanel::tr("proven");
        case RewriteProof::measured: break;
    }
    return FormulaPanel::tr("measured");
}

}  // namespace

FormulaPanel::FormulaPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    surfaces_ = new SurfaceChooser(tr("The isosurface whose function is written otherwise."));
    surfaces_->setWhatsThis(surfaces_->toolTip());
    connect(surfaces_, &SurfaceChooser::activated, this, [this] {
        stopWork(true);
        refresh();
        beginIfWanted();
    });
    column->addWidget(surfaces_);
    auto* both = new QSplitter;
    both->setChildrenCollapsible(false);
    both->addWidget(buildRewrites());
    both->addWidget(buildDerivatives());
    both->setStretchFactor(0, 1);
    both->setStretchFactor(1, 1);
    column->addWidget(both, 1);
    row_ = new ProgressRow({tr("What the chosen rewrite does, and how sure that is"),
                            tr("Progress of the search for rewrites"), tr("How much of the search is done"),
                            tr("Search or stop")});
    connect(row_->button(), &QPushButton::clicked, this, [this] {
        declined_ = working_;
        if (!working_) return work();
        stopWork(false);
        refresh();
    });
    row_->add(rewrite_);
    row_->add(copy_);
    row_->add(insert_);
    column->addWidget(row_);
    refresh();
}

FormulaPanel::~FormulaPanel() { stop_.request_stop(); }

QLabel* FormulaPanel::note() const { return row_->note(); }

QWidget* FormulaPanel::buildRewrites() {
    list_ = new QTreeWidget;
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels({tr("Could be written as"), tr("Gain in POV-Ray"), tr("Certainty")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setAccessibleName(tr("Other ways to write the function"));
    list_->setToolTip(tr("Choose one to read what it does; Enter or a double click writes it"));
    QHeaderView* header = list_->header();
    header->setSectionsMovable(false);
    header->setStretchLastSection(false);
    header->setSectionResizeMode(change, QHeaderView::Stretch);
    header->setSectionResizeMode(gain, QHeaderView::ResizeToContents);
    header->setSectionResizeMode(proof, QHeaderView::ResizeToContents);
    rewrite_ = new QPushButton(tr("Rewrite"));
    rewrite_->setToolTip(tr("Changes the text so; Undo takes it back."));
    rewrite_->setAccessibleName(tr("Write the chosen rewrite into the text"));
    connect(list_, &QTreeWidget::itemActivated, rewrite_, &QPushButton::click);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        rewrite_->setEnabled(current());
        if (current()) row_->note()->setText(QString::fromStdString(describe(*current())));
    });
    connect(rewrite_, &QPushButton::clicked, this, [this] {
        if (!current()) return;
        const QuickFix fix = current()->fix;
        emit fixRequested(fix);
    });
    return list_;
}

QWidget* FormulaPanel::buildDerivatives() {
    text_ = new QPlainTextEdit;
    text_->setReadOnly(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text_->setTabChangesFocus(true);
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text_->setAccessibleName(tr("Derivatives as POV-Ray's text"));
    text_->setToolTip(
        tr("The derivatives in x, y and z, the length of the gradient, and a function with the "
           "same surface whose gradient is 1 on it"));
    copy_ = new QPushButton(tr("Copy Derivatives"));
    copy_->setToolTip(tr("Puts the declarations on the clipboard."));
    connect(copy_, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(text_->toPlainText());
        emit said(tr("The derivatives are on the clipboard."));
    });
    insert_ = new QPushButton(tr("Insert Derivatives"));
    insert_->setToolTip(tr("Writes the declarations in front of the isosurface; Undo takes it back."));
    connect(insert_, &QPushButton::clicked, this, &FormulaPanel::insertDerivatives);
    return text_;
}

std::size_t FormulaPanel::chosen() const {
    return static_cast<std::size_t>(std::max(0, surfaces_->currentIndex()));
}

const SceneIsosurface* FormulaPanel::subject() const {
    if (!scene_ || chosen() >= scene_->isosurfaces.size()) return nullptr;
    const SceneIsosurface& one = scene_->isosurfaces[chosen()];
    return one.shape ? &one : nullptr;
}

const FormulaRewrite* FormulaPanel::current() const {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    return row >= 0 && static_cast<std::size_t>(row) < rewrites_.size()
               ? &rewrites_[static_cast<std::size_t>(row)]
               : nullptr;
}

void FormulaPanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    stopWork(true);
    declined_ = false;
    refresh();
    beginIfWanted();
}

void FormulaPanel::setActive(bool active) {
    active_ = active;
    if (!active) stopWork(false);
    refresh();
    beginIfWanted();
}

void FormulaPanel::setResting(bool resting) {
    resting_ = resting;
    beginIfWanted();
}

void FormulaPanel::stopWork(bool forget) {
    stop_.request_stop();
    ++generation_;
    working_ = false;
    if (!forget) return;
    parsed_ = nullptr;
    rewrites_.clear();
    derivatives_ = {};
    complete_ = false;
}

void FormulaPanel::beginIfWanted() {
    if (active_ && resting_ && !working_ && !declined_ && !complete_ && subject()) work();
}

/// In the window's thread, unless the work has become another one.
template <class Action>
void FormulaPanel::tell(std::uint64_t generation, Action action) {
    QMetaObject::invokeMethod(
        this,
        [this, generation, action = std::move(action)] {
            if (generation == generation_) action();
        },
        Qt::QueuedConnection);
}

void FormulaPanel::work() {
    const auto parsed = reader_ ? reader_() : nullptr;
    if (!subject() || !parsed || !parsed->scene || chosen() >= parsed->scene->isosurfaces.size()) return;
    stopWork(true);
    declined_ = false;
    working_ = true;
    parsed_ = parsed;
    stop_ = std::stop_source();
    worker_.submit([this, parsed, isosurface = chosen(), shape = subject()->shape,
                    parameters = scene_->parameterTable, generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        std::string name = "f";
        const std::string_view text = (*parsed->sources)[0].text();
        for (int i = 2; countWord(text, name + "_dx") > 0; ++i) name = "f" + std::to_string(i);
        if (countWord(text, name) > 0) name += "_surface";
        const DerivativeText derivatives = derivativeText(*shape, *parameters, name);
        tell(generation, [this, derivatives] {
            derivatives_ = derivatives;
            refresh();
        });
        const auto rewrites = formulaRewrites(
            *parsed, isosurface,
            [&](double done) { tell(generation, [this, done] { row_->setProgress(done); }); },
            either.token());
        tell(generation, [this, rewrites] {
            rewrites_ = rewrites;
            working_ = false;
            complete_ = true;
            refresh();
        });
    });
    refresh();
}

void FormulaPanel::refresh() {
    row_->setWorking(working_, working_ ? ProgressRow::Button{tr("Stop"), tr("End the search")}
                                        : ProgressRow::Button{
                                              tr("Search"), tr("Look for other ways to write the function")});
    row_->button()->setVisible(subject() && !complete_);
    const bool known = !derivatives_.declarations.empty();
    QString text;
    if (!subject())
        text = tr("The scene has no isosurface.");
    else if (known)
        text = QString::fromStdString(derivatives_.declarations);
    else if (!derivatives_.problem.empty())
        text = QString::fromStdString(derivatives_.problem);
    else
        text = working_ ? tr("Being found out…") : tr("It is found out once nothing moves.");
    if (text_->toPlainText() != text) text_->setPlainText(text);
    copy_->setEnabled(known);
    insert_->setEnabled(known && parsed_ && subject() && subject()->range.file == 0);
    showRewrites();
}

void FormulaPanel::showRewrites() {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const FormulaRewrite& rewrite : rewrites_) {
        auto* row = new QTreeWidgetItem(list_);
        row->setText(change, QString::fromStdString(rewrite.fix.title));
        row->setText(gain, gainText(rewrite));
        row->setText(proof, proofText(rewrite.proof));
        for (int k = 0; k < columnCount; ++k) row->setToolTip(k, QString::fromStdString(describe(rewrite)));
    }
    rewrite_->setEnabled(false);
    if (!complete_)
        row_->note()->clear();
    else if (rewrites_.empty())
        row_->note()->setText(tr("There is no rewrite that pays."));
    else
        row_->note()->setText(tr("Choose a rewrite to read what it does, and how sure that is."));
}

void FormulaPanel::insertDerivatives() {
    if (!parsed_ || chosen() >= parsed_->scene->isosurfaces.size()) return;
    const SourceRange& statement = parsed_->scene->isosurfaces[chosen()].range;
    if (statement.file != 0) return;
    const QuickFix fix{tr("Insert Derivatives").toStdString(),
                       {0, statement.begin, statement.begin},
                       derivatives_.declarations};
    emit fixRequested(fix);
}

}  // namespace isoscope
