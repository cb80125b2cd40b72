// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/text/diagnostic.h"

class QLabel;
class QStackedLayout;
class QTreeWidget;
class QTreeWidgetItem;

namespace isoscope {

/// The diagnostics of the last parse, worst first. Messages that repeat are one row with a count, unfolding
/// to the places.
class ProblemsPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ProblemsPanel(QWidget* parent = nullptr);

    /// Replaces the list; selection and scroll stay where the same message is still there.
    void setDiagnostics(const Diagnostics& diagnostics, const SourceLibrary& sources);
    /// "Problems" or "Problems: 2 errors, 1 left out", for the dock.
    QString title() const { return title_; }

  signals:
    /// A row was clicked or entered. For a place inside an include file it is the `#include` in the user's
    /// text.
    void activated(const SourceRange& range);
    void titleChanged(const QString& title);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void setTitle(const Diagnostics& diagnostics);
    void addRows(const Diagnostics& diagnostics, const SourceLibrary& sources);
    void setIcons();
    void activate(QTreeWidgetItem* item);

    QTreeWidget* list_;
    QLabel* empty_;
    QStackedLayout* stack_;
    QString title_;
};

}  // namespace isoscope

Q_DECLARE_METATYPE(isoscope::SourceRange)
