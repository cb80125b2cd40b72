// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QStringList>

#include "widgets/gallery/gallery_entry.h"

namespace isoscope {

/// The functions that have a name, then the patterns, by name, each in the scene of its little picture.
QList<GalleryEntry> functionEntries();

/// The scenes of the lessons in the help, in their order; the lesson's heading is the title, the scene's
/// first comment the sentence.
QList<GalleryEntry> lessonEntries();

/// The sentence of the comment that a scene begins with; empty without one.
QString firstComment(const QString& text);

/// The folders in which packages of POV-Ray keep their snippets, those that are there.
QStringList povrayTemplateFolders();

/// The isosurfaces among the snippets of these folders (`Isosurface*/*.txt`), each completed to a scene. A
/// file is taken once, and only when it is a whole isosurface and small.
QList<GalleryEntry> povrayEntries(const QStringList& templateFolders);

}  // namespace isoscope
