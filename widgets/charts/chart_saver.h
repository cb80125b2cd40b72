// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QToolButton>

#include "widgets/charts/chart_file.h"

namespace isoscope {

/// The button of a panel that saves its charts as SVG or PNG, and their numbers as CSV.
class ChartSaver : public QToolButton {
    Q_OBJECT
  public:
    /// What is saved, asked for at each saving: `charts` go into one picture, `table` is the text of the CSV
    /// file.
    struct Source {
        std::function<QList<Chart>()> charts;
        std::function<QString()> table;  ///< comma separated values
        QString name;                    ///< suggested for files, without suffix
    };
    ChartSaver(Source source, QWidget* parent = nullptr);

    /// False when that fails; the suffix says what is written.
    bool saveTo(const QString& path) const;

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    void ask(const QString& suffix, const QString& filter);

    Source source_;
};

}  // namespace isoscope
