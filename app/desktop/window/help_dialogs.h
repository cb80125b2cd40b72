// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace isoscope {

/// Name, version, licence and the libraries in use. Deletes itself when closed.
class AboutDialog : public QDialog {
    Q_OBJECT
  public:
    explicit AboutDialog(QWidget* parent);
};

}  // namespace isoscope
