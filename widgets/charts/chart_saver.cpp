// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_saver.h"

#include <QMenu>

#include "widgets/document/save_path.h"

namespace isoscope {

ChartSaver::ChartSaver(Source source, QWidget* parent) : QToolButton(parent), source_(std::move(source)) {
    setText(tr("Save"));
    setToolTip(tr("Write the chart, or its numbers, to a file"));
    setAccessibleName(tr("Save the chart or its numbers"));
    setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(this);
    menu->addAction(tr("Chart as &SVG…"), this,
                    [this] { ask(QStringLiteral("svg"), tr("SVG drawings (*.svg)")); });
    menu->addAction(tr("Chart as &PNG…"), this,
                    [this] { ask(QStringLiteral("png"), tr("PNG pictures (*.png)")); });
    menu->addAction(tr("&Numbers (CSV)…"), this,
                    [this] { ask(QStringLiteral("csv"), tr("CSV tables (*.csv)")); });
    setMenu(menu);
}

bool ChartSaver::saveTo(const QString& path) const {
    if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) return saveText(source_.table(), path);
    ChartSheet sheet;
    sheet.charts = source_.charts();
    sheet.palette = palette();
    sheet.font = font();
    return saveCharts(sheet, path);
}

void ChartSaver::ask(const QString& suffix, const QString& filter) {
    const QString path = chooseSavePath(
        this, tr("Save"), pathInDocuments(source_.name + QLatin1Char('.') + suffix), filter, suffix);
    if (!path.isEmpty())
        emit said(saveTo(path) ? tr("Saved %1.").arg(path) : tr("%1 cannot be written.").arg(path));
}

}  // namespace isoscope
