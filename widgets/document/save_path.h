// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace isoscope {

/// Asks where to save; empty when that was cancelled. A name typed without suffix gets `suffix` ("pov"),
/// before the question whether an existing file is to be replaced.
QString chooseSavePath(QWidget* parent, const QString& title, const QString& suggested, const QString& filter,
                       const QString& suffix);

/// A file of this name where the user's documents are, or in the home folder: never in whatever folder the
/// program happens to run.
QString pathInDocuments(const QString& name);

}  // namespace isoscope
