// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QColor>
#include <QIcon>
#include <QImage>

#include "core/study/gradient/gradient_verdict.h"
#include "widgets/look.h"

namespace isoscope {

/// The sign of a verdict in margin, status line and picture: told apart by what is in it, not by colour
/// alone. Without a verdict: being proven.
QImage verdictSymbol(std::optional<GradientVerdict> verdict, int size, double pixelRatio, Look look);
QIcon verdictIcon(std::optional<GradientVerdict> verdict, Look look);
QColor verdictSymbolColor(std::optional<GradientVerdict> verdict, Look look);

}  // namespace isoscope
