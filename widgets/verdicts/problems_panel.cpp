// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/problems_panel.h"

#include <algorithm>
#include <array>
#include <map>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QStackedLayout>
#include <QToolButton>
#include <QTreeWidget>

#include "widgets/editor/code_words.h"
#include "widgets/icons.h"
#include "widgets/verdicts/severity_icon.h"
#include "widgets/verdicts/problem_delegate.h"

namespace isoscope {
namespace {

enum Column { messageColumn, placeColumn, columnCount };
enum Role {
    messageRole = ProblemDelegate::messageRole,
    hintRole = ProblemDelegate::hintRole,
    rangeRole,
    severityRole,
    diagnosticRole,  ///< its id, and
    fixesRole,       ///< what could mend it: for the menu
};
constexpr int callIcon = -1;  ///< as a severity: a call that led to the place above

QString severityName(Severity severity) {
    switch (severity) {
        case Severity::error: return ProblemsPanel::tr("Error");
        case Severity::warning: return ProblemsPanel::tr("Warning");
        case Severity::leftOut: return ProblemsPanel::tr("Left out");
        case Severity::note: return ProblemsPanel::tr("Note");
    }
    return {};
}

/// "3:14", with columns as the editor counts them: in characters. Other files with their names.
QString placeText(const SourceRange& range, const SourceLibrary& sources) {
    if (range.file >= sources.size()) return {};
    const SourceText& source = sources[range.file];
    const LineColumn at = source.position(range.begin);
    const auto bytes = static_cast<std::size_t>(at.column - 1);
    const std::size_t begin = range.begin - bytes;
    const std::string_view before = source.text().substr(std::min(begin, source.text().size()), bytes);
    const auto column = std::count_if(before.begin(), before.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xc0) != 0x80;
    });
    const QString place = QString("%1:%2").arg(at.line).arg(column + 1);
    if (range.file == 0) return place;
    return QString::fromStdString(source.name()).section('/', -1) + ':' + place;
}

/// All that rows say of places: of the diagnostics, and of the calls that led there.
QStringList placesOf(const Diagnostics& diagnostics, const SourceLibrary& sources) {
    QStringList places;
    for (const Diagnostic& diagnostic : diagnostics) {
        places << placeText(diagnostic.range, sources);
        for (const SourceRange& site : diagnostic.reachedFrom)
            places << QString::fromStdString(callText(site, sources)) << placeText(site, sources);
    }
    return places;
}

void fillItem(QTreeWidgetItem* item, const Diagnostic& diagnostic, const SourceLibrary& sources) {
    const QString message = withQuotedCode(diagnostic.message);
    const QString hint = withQuotedCode(diagnostic.hint);
    item->setText(messageColumn, message);
    item->setData(messageColumn, messageRole, QString::fromStdString(diagnostic.message));
    item->setData(messageColumn, hintRole, QString::fromStdString(diagnostic.hint));
    item->setData(messageColumn, rangeRole, QVariant::fromValue(diagnostic.range));
    item->setData(messageColumn, severityRole, static_cast<int>(diagnostic.severity));
    item->setData(messageColumn, diagnosticRole, QString::fromStdString(diagnostic.id));
    item->setData(messageColumn, fixesRole, QVariant::fromValue(diagnostic.fixes));
    item->setText(placeColumn, placeText(diagnostic.range, sources));
    item->setTextAlignment(placeColumn, Qt::AlignRight | Qt::AlignTop);
    const QString spoken =
        QString("%1: %2 %3").arg(severityName(diagnostic.severity), message, hint).trimmed();
    item->setData(messageColumn, Qt::AccessibleTextRole, spoken);
    const QString toolTip = "<p>" + severityName(diagnostic.severity) + ": " +
                            withCodeAsHtml(diagnostic.message) + "</p><p>" + withCodeAsHtml(diagnostic.hint) +
                            "</p>";
    for (int column = 0; column < columnCount; ++column) item->setToolTip(column, toolTip);
}

/// A row for each call that led to the place of `item`, innermost first.
void addCalls(QTreeWidgetItem* item, const Diagnostic& diagnostic, const SourceLibrary& sources) {
    for (const SourceRange& site : diagnostic.reachedFrom) {
        auto* row = new QTreeWidgetItem(item);
        const std::string text = callText(site, sources);
        row->setText(messageColumn, withQuotedCode(text));
        row->setData(messageColumn, messageRole, QString::fromStdString(text));
        row->setData(messageColumn, rangeRole, QVariant::fromValue(site));
        row->setData(messageColumn, severityRole, callIcon);
        row->setText(placeColumn, placeText(site, sources));
        row->setTextAlignment(placeColumn, Qt::AlignRight | Qt::AlignTop);
    }
}

}  // namespace

ProblemsPanel::ProblemsPanel(QWidget* parent)
    : QWidget(parent),
      icons_{severityIcon(Severity::error), severityIcon(Severity::warning), severityIcon(Severity::leftOut),
             severityIcon(Severity::note)},
      list_(new QTreeWidget(this)),
      empty_(new QLabel(this)),
      stack_(new QStackedLayout(this)) {
    list_->setColumnCount(columnCount);
    list_->setHeaderLabels({tr("Message"), tr("Place")});
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
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QWidget::customContextMenuRequested, this, &ProblemsPanel::showMenu);
    setAccessibleName(tr("Problems"));
    setTitle({});
}

void ProblemsPanel::setDiagnostics(const Diagnostics& diagnostics,
                                   std::shared_ptr<const SourceLibrary> sources) {
    diagnostics_ = diagnostics;
    sources_ = sources ? std::move(sources) : std::make_shared<const SourceLibrary>();
    showAll();
}

void ProblemsPanel::setFindings(const Diagnostics& findings) {
    findings_ = findings;
    showAll();
}

void ProblemsPanel::clear() {
    findings_.clear();
    setDiagnostics({}, nullptr);
}

void ProblemsPanel::showAll() {
    Diagnostics all = diagnostics_;
    all.insert(all.end(), findings_.begin(), findings_.end());
    QStringList places = placesOf(all, *sources_);
    if (all == shown_ && places == shownPlaces_) return;
    shown_ = all;
    shownPlaces_ = std::move(places);
    const QTreeWidgetItem* selected = list_->currentItem();
    const QString before = selected ? selected->data(messageColumn, messageRole).toString() : QString();
    const int scroll = list_->verticalScrollBar()->value();
    list_->clear();
    addRows(all);
    setIcons();
    if (!before.isEmpty())
        for (int i = 0; i < list_->topLevelItemCount(); ++i)
            if (list_->topLevelItem(i)->data(messageColumn, messageRole).toString() == before) {
                list_->setCurrentItem(list_->topLevelItem(i));
                break;
            }
    list_->verticalScrollBar()->setValue(scroll);
    stack_->setCurrentWidget(all.empty() ? static_cast<QWidget*>(empty_) : list_);
    setTitle(all);
}

void ProblemsPanel::addRows(const Diagnostics& diagnostics) {
    struct Row {
        QTreeWidgetItem* item = nullptr;
        const Diagnostic* first = nullptr;
        int count = 0;
    };
    for (const Severity severity : {Severity::error, Severity::warning, Severity::leftOut, Severity::note}) {
        std::map<std::string, Row> rows;
        for (const Diagnostic& diagnostic : diagnostics) {
            if (diagnostic.severity != severity) continue;
            Row& row = rows[diagnostic.id + '\n' + diagnostic.message];
            if (++row.count == 1) {
                row.first = &diagnostic;
                row.item = addRow(list_->invisibleRootItem(), diagnostic);
                continue;
            }
            if (row.count == 2) {
                qDeleteAll(row.item->takeChildren());  // the calls: they belong to the first place
                addRow(row.item, *row.first);
                row.item->setExpanded(false);
            }
            addRow(row.item, diagnostic);
            const QString times = tr("%1 (%2 times)").arg(QString::fromStdString(diagnostic.message));
            row.item->setData(messageColumn, messageRole, times.arg(row.count));
            row.item->setText(messageColumn, withQuotedCode(times.arg(row.count)));
        }
    }
    bool unfolding = false;
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        unfolding |= list_->topLevelItem(i)->childCount() > 0;
    list_->setRootIsDecorated(unfolding);
    emit list_->itemDelegate()->sizeHintChanged({});  // buttons have come, with a height
}

QTreeWidgetItem* ProblemsPanel::addRow(QTreeWidgetItem* above, const Diagnostic& diagnostic) {
    auto* item = new QTreeWidgetItem(above);
    fillItem(item, diagnostic, *sources_);
    addCalls(item, diagnostic, *sources_);
    item->setExpanded(true);
    addButtons(item, diagnostic);
    return item;
}

std::vector<QuickFix> ProblemsPanel::fixesOf(const std::string& id) const {
    std::vector<QuickFix> fixes;
    for (const Diagnostics* list : {&diagnostics_, &findings_})
        for (const Diagnostic& diagnostic : *list)
            if (diagnostic.id == id && !diagnostic.fixes.empty()) fixes.push_back(diagnostic.fixes.front());
    return fixes;
}

void ProblemsPanel::addButtons(QTreeWidgetItem* item, const Diagnostic& diagnostic) {
    if (diagnostic.fixes.empty()) return;
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const QString& title, const QString& toolTip, std::vector<QuickFix> fixes) {
        auto* button = new QToolButton;
        button->setText(title);
        button->setToolTip(toolTip);
        connect(button, &QToolButton::clicked, this,
                [this, fixes = std::move(fixes)] { emit fixRequested(fixes); });
        layout->addWidget(button);
    };
    for (const QuickFix& fix : diagnostic.fixes)
        add(withQuotedCode(fix.title), tr("Change the text so; Undo takes it back"), {fix});
    std::vector<QuickFix> all = fixesOf(diagnostic.id);
    if (all.size() > 1) {
        const QString title = tr("Fix All %1").arg(all.size());
        add(title, tr("Do the same for every problem of this kind, as one step"), std::move(all));
    }
    list_->setItemWidget(item, messageColumn, row);
}

void ProblemsPanel::showMenu(const QPoint& place) {
    const QTreeWidgetItem* item = list_->itemAt(place);
    if (!item) return;
    QMenu menu;
    const auto fixes = item->data(messageColumn, fixesRole).value<std::vector<QuickFix>>();
    for (const QuickFix& fix : fixes)
        menu.addAction(withQuotedCode(fix.title), this, [this, fix] { emit fixRequested({fix}); });
    const std::vector<QuickFix> all =
        fixesOf(item->data(messageColumn, diagnosticRole).toString().toStdString());
    if (!fixes.empty() && all.size() > 1)
        menu.addAction(tr("Fix All %1").arg(all.size()), this, [this, all] { emit fixRequested(all); });
    if (!fixes.empty()) menu.addSeparator();
    const QString message = item->text(messageColumn);
    menu.addAction(tr("Copy Message"), this, [message] { QGuiApplication::clipboard()->setText(message); });
    menu.exec(list_->viewport()->mapToGlobal(place));
}

void ProblemsPanel::setIcons() {
    for (QTreeWidgetItemIterator it(list_); *it; ++it) {
        const int severity = (*it)->data(messageColumn, severityRole).toInt();
        if (severity != callIcon) (*it)->setIcon(messageColumn, icons_[static_cast<std::size_t>(severity)]);
    }
}

void ProblemsPanel::setTitle(const Diagnostics& diagnostics) {
    std::array<int, 4> counts{};
    for (const Diagnostic& diagnostic : diagnostics) ++counts[static_cast<std::size_t>(diagnostic.severity)];
    const auto part = [&](Severity severity, const QString& one, const QString& many) {
        const int count = counts[static_cast<std::size_t>(severity)];
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
    if (range.file < sources_->size()) emit activated(range);
}

void ProblemsPanel::setEmptyText(const QString& text) { empty_->setText(text); }

}  // namespace isoscope
