// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/help_dialogs.h"

#include <vtkVersion.h>
#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

namespace isoscope {

namespace {

struct Row {
    QString what;
    QString keys;
};

QList<Row> mouseRows() {
    const auto tr = [](const char* text) { return QCoreApplication::translate("ShortcutsDialog", text); };
    return {{tr("Viewport: turn"), tr("Left drag, arrow keys")},
            {tr("Viewport: shift"), tr("Right or middle drag, Shift+drag, Shift+arrow keys")},
            {tr("Viewport: zoom"), tr("Wheel, + and -")},
            {tr("Viewport: reset"), tr("Double click, Home")},
            {tr("Viewport: stop rendering"), tr("Esc")},
            {tr("Text: change the number under the mouse"), tr("Alt+wheel, Alt+drag")},
            {tr("Parameter: back to its first value"), tr("Double click on the name")},
            {tr("Cross-section: shift, zoom, see all"), tr("Drag, wheel, double click")}};
}

void addCloseButton(QDialog* dialog, QVBoxLayout* layout) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    layout->addWidget(buttons);
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keyboard and mouse"));
    QList<Row> rows;
    for (const QAction* action : actions) {
        if (action->shortcut().isEmpty()) continue;
        rows << Row{action->statusTip(), action->shortcut().toString(QKeySequence::NativeText)};
    }
    rows << mouseRows();

    auto* table = new QTableWidget(static_cast<int>(rows.size()), 2);
    table->setHorizontalHeaderLabels({tr("Command"), tr("Keys or mouse")});
    table->setAccessibleName(tr("Commands with their keys"));
    table->setToolTip(tr("All commands that have keys"));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setAlternatingRowColors(true);
    table->setShowGrid(false);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setStretchLastSection(true);
    for (int i = 0; i < rows.size(); ++i) {
        table->setItem(i, 0, new QTableWidgetItem(rows[i].what));
        table->setItem(i, 1, new QTableWidgetItem(rows[i].keys));
    }
    table->resizeColumnToContents(0);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(table);
    addCloseButton(this, layout);
    resize(640, 560);
}

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("About Isoscope"));
    auto* text = new QLabel(
        tr("<h3>Isoscope %1</h3>"
           "<p>An instrument for isosurfaces: type a function of x, y, z in POV-Ray's language and see "
           "its surface at once.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later; without any "
           "warranty.</p>"
           "<p>With Qt %2, VTK %3, QScintilla, oneTBB, Highway, SLEEF and GLM. POV-Ray is a trademark of "
           "its owner; this program contains none of its code.</p>")
            .arg(QCoreApplication::applicationVersion(), QString::fromLatin1(qVersion()),
                 QString::fromLatin1(vtkVersion::GetVTKVersion())));
    text->setWordWrap(true);
    text->setMinimumWidth(420);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    addCloseButton(this, layout);
}

}  // namespace isoscope
