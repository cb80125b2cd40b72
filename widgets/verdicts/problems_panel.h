// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <QIcon>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/text/diagnostic.h"

class QLabel;
class QStackedLayout;
class QTreeWidget;
class QTreeWidgetItem;

namespace isoscope {

/// The diagnostics of the last parse and what was found out about the text since, worst first. Messages that
/// repeat are one row with a count, unfolding to the places; below a place in a macro or an include file
/// stand the calls that led there. What can be mended at once has a button for it.
class ProblemsPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ProblemsPanel(QWidget* parent = nullptr);

    /// Replaces the diagnostics; selection and scroll stay where the same message is still there, and rows
    /// that would be the same as before stay. The findings stay, too: the caller says next, with
    /// setFindings(), what holds for this text.
    void setDiagnostics(const Diagnostics& diagnostics, std::shared_ptr<const SourceLibrary> sources);
    /// What a study of the same text found: listed with its diagnostics until the next findings. The ranges
    /// are those of the sources that setDiagnostics() had last.
    void setFindings(const Diagnostics& findings);
    /// No text: nothing is listed, and there are no sources.
    void clear();
    /// Those that the places belong to; empty before the first.
    const SourceLibrary& sources() const { return *sources_; }
    /// "Problems" or "Problems: 2 errors, 1 left out", for the dock.
    QString title() const { return title_; }
    /// What stands there while nothing is listed; that there are no problems, until it is called.
    void setEmptyText(const QString& text);

  signals:
    /// A row was clicked or entered: a place in the user's text (file 0), or in an include file of the
    /// sources shown.
    void activated(const SourceRange& range);
    /// A button asks for these changes of the text, as one step.
    void fixRequested(const std::vector<QuickFix>& fixes);
    void titleChanged(const QString& title);

  private:
    /// Makes the rows anew where they are no longer those of the diagnostics and findings.
    void showAll();
    void setTitle(const Diagnostics& diagnostics);
    void addRows(const Diagnostics& diagnostics);
    QTreeWidgetItem* addRow(QTreeWidgetItem* above, const Diagnostic& diagnostic);
    void addButtons(QTreeWidgetItem* item, const Diagnostic& diagnostic);
    void showMenu(const QPoint& place);
    void setIcons();
    void activate(QTreeWidgetItem* item);
    /// The first fixes of all diagnostics with this id.
    std::vector<QuickFix> fixesOf(const std::string& id) const;

    const std::array<QIcon, 4> icons_;  ///< by Severity
    QTreeWidget* list_;
    QLabel* empty_;
    QStackedLayout* stack_;
    QString title_;
    Diagnostics diagnostics_;
    Diagnostics findings_;
    Diagnostics shown_;        ///< those that the rows were made from, and
    QStringList shownPlaces_;  ///< the places that they tell
    std::shared_ptr<const SourceLibrary> sources_ = std::make_shared<const SourceLibrary>();
};

}  // namespace isoscope
