// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/help_dialogs.h"

#include <vtkVersion.h>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace isoscope {

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
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
}

}  // namespace isoscope
