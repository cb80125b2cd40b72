// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace isoscope {

/// The file of the scalable font that the system uses for `family`, or of what it puts in its place; empty
/// when there is none, or when the font is not the first of its file.
QString fontFile(const QString& family);

/// Whether there is any font at all. Qt cannot tell: it has families even then, and draws boxes.
bool hasFonts();

}  // namespace isoscope
