// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/problems_panel.h"

#include <array>
#include <map>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStackedLayout>
#include <QTreeWidget>

#include "widgets/icons.h"
#include "widgets/problem_delegate.h"

namespace isoscope {
namespace {

enum Column { messageColumn, placeColumn, columnCount };
enum Role { hintRole = ProblemDelegate::hintRole, rangeRole, severityRole, messageRole };

const char* iconName(Severity severity) {
    switch (severity) {
        case Severity::error: return "dialog-error";
        case Severity::warning: return "dialog-warning";
        case Severity::leftOut: return "list-remove";
        case Severity::note: return "dialog-information";
    }
    return "dialog-information";
}

QString severityName(Severity severity) {
    switch (severity) {
        case Severity::error: return ProblemsPanel::tr("Error");
        case Severity::warning: return ProblemsPanel::tr("Warning");
        case Severity::leftOut: return ProblemsPanel::tr("Left out");
        case Severity::note: return ProblemsPanel::tr("Note");
    }
    return {};
}

QString placeText(const Diagnostic& diagnostic, const SourceLibrary& sources) {
    const SourceRange& range = diagnostic.range;
    if (range.file >= sources.size()) return {};
    const int line = sources[range.file].position(range.begin).line;
    if (range.file == 0) return QString::number(line);
    const QString name = QString::fromStdString(sources[range.file].name()).section('/', -1);
    return QString("%1:%2").arg(name).arg(line);
}

/// The place in the user's own text; the statement that led there for a place in an include file.
SourceRange ownRange(const Diagnostic& diagnostic) {
    SourceRange range = diagnostic.range;
    for (const SourceRange& from : diagnostic.reachedFrom)
        if (range.file != 0) range = from;
    return range;
}

void fillItem(QTreeWidgetItem* item, const Diagnostic& diagnostic, const SourceLibrary& sources) {
    const QString message = QString::fromStdString(diagnostic.message);
    const QString hint = QString::fromStdString(diagnostic.hint);
    const QString place = placeText(diagnostic, sources);
    item->setText(messageColumn, message);
    item->setData(messageColumn, hintRole, hint);
    item->setData(messageColumn, rangeRole, QVariant::fromValue(ownRange(diagnostic)));
    item->setData(messageColumn, severityRole, static_cast<int>(diagnostic.severity));
    item->setData(messageColumn, messageRole, message);
    item->setText(placeColumn, place);
    item->setTextAlignment(placeColumn, Qt::AlignRight | Qt::AlignVCenter);
    const QString spoken =
        QString("%1: %2 %3").arg(severityName(diagnostic.severity), message, hint).trimmed();
    item->setData(messageColumn, Qt::AccessibleTextRole, spoken);
    for (int column = 0; column < columnCount; ++column)
        item->setToolTip(column, "<p>" + spoken.toHtmlEscaped() + "</p>");
}

}  // namespace

ProblemsPanel::ProblemsPanel(QWidget* parent)
    : QWidget(parent),
      list_(new QTreeWidget(this)),
      empty_(new QLabel(this)),
      stack_(new QStackedLayout(this)) {
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels({tr("Message"), tr("Line")});
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(messageColumn, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(placeColumn, QHeaderView::ResizeToContents);
    list_->setItemDelegate(new ProblemDelegate(list_));
    // Messages take more lines in a narrow panel.
    connect(list_->header(), &QHeaderView::sectionResized, list_,
            [this] { emit list_->itemDelegate()->sizeHintChanged({}); });
    list_->setRootIsDecorated(false);
    list_->setAllColumnsShowFocus(true);
    list_->setAlternatingRowColors(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setAccessibleName(tr("Problems"));
    list_->setToolTip(
        tr("What is wrong with the text, and what of it is not shown. Enter goes to the place"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setText(tr("No problems. Everything in the text is shown."));
    empty_->setWordWrap(true);
    stack_->addWidget(empty_);
    stack_->addWidget(list_);
    connect(list_, &QTreeWidget::itemClicked, this, &ProblemsPanel::activate);
    connect(list_, &QTreeWidget::itemActivated, this, &ProblemsPanel::activate);
    setAccessibleName(tr("Problems"));
    setTitle({});
}

void ProblemsPanel::setDiagnostics(const Diagnostics& diagnostics, const SourceLibrary& sources) {
    const QTreeWidgetItem* selected = list_->currentItem();
    const QString before = selected ? selected->data(messageColumn, messageRole).toString() : QString();
    const int scroll = list_->verticalScrollBar()->value();
    list_->clear();
    addRows(diagnostics, sources);
    setIcons();
    if (!before.isEmpty())
        for (int i = 0; i < list_->topLevelItemCount(); ++i)
            if (list_->topLevelItem(i)->data(messageColumn, messageRole).toString() == before) {
                list_->setCurrentItem(list_->topLevelItem(i));
                break;
            }
    list_->verticalScrollBar()->setValue(scroll);
    stack_->setCurrentWidget(diagnostics.empty() ? static_cast<QWidget*>(empty_) : list_);
    setTitle(diagnostics);
}

void ProblemsPanel::addRows(const Diagnostics& diagnostics, const SourceLibrary& sources) {
    struct Row {
        QTreeWidgetItem* item = nullptr;
        const Diagnostic* first = nullptr;
        int count = 0;
    };
    bool unfolding = false;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::leftOut, Severity::note}) {
        std::map<std::string, Row> rows;
        for (const Diagnostic& diagnostic : diagnostics) {
            if (diagnostic.severity != severity) continue;
            Row& row = rows[diagnostic.id + '\n' + diagnostic.message];
            if (++row.count == 1) {
                row.first = &diagnostic;
                row.item = new QTreeWidgetItem(list_);
                fillItem(row.item, diagnostic, sources);
                continue;
            }
            unfolding = true;
            if (row.count == 2) fillItem(new QTreeWidgetItem(row.item), *row.first, sources);
            fillItem(new QTreeWidgetItem(row.item), diagnostic, sources);
            row.item->setText(
                messageColumn,
                tr("%1 (%2 times)").arg(QString::fromStdString(diagnostic.message)).arg(row.count));
        }
    }
    list_->setRootIsDecorated(unfolding);
}

void ProblemsPanel::setIcons() {
    std::array<QIcon, 4> icons;
    for (int i = 0; i < 4; ++i) icons[i] = themeIcon(iconName(static_cast<Severity>(i)));
    for (QTreeWidgetItemIterator it(list_); *it; ++it)
        (*it)->setIcon(messageColumn, icons[(*it)->data(messageColumn, severityRole).toInt()]);
}

void ProblemsPanel::setTitle(const Diagnostics& diagnostics) {
    std::array<int, 4> counts{};
    for (const Diagnostic& diagnostic : diagnostics) ++counts[static_cast<int>(diagnostic.severity)];
    const auto part = [&](Severity severity, const QString& one, const QString& many) {
        const int count = counts[static_cast<int>(severity)];
        return count == 0 ? QString() : QString("%1 %2").arg(count).arg(count == 1 ? one : many);
    };
    QStringList parts{part(Severity::error, tr("error"), tr("errors")),
                      part(Severity::warning, tr("warning"), tr("warnings")),
                      part(Severity::leftOut, tr("left out"), tr("left out")),
                      part(Severity::note, tr("note"), tr("notes"))};
    parts.removeAll(QString());
    const QString title = parts.isEmpty() ? tr("Problems") : tr("Problems: %1").arg(parts.join(", "));
    if (title == title_) return;
    title_ = title;
    emit titleChanged(title_);
}

void ProblemsPanel::activate(QTreeWidgetItem* item) {
    const auto range = item->data(messageColumn, rangeRole).value<SourceRange>();
    if (range.file == 0) emit activated(range);
}

void ProblemsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) setIcons();
}

}  // namespace isoscope
