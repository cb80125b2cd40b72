// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QWidget;

namespace isoscope::test {

/// The texts of buttons, labels, tabs, lists to choose from and column titles inside `root`, itself included,
/// that are seen and have less room than they ask for, each with its widget and both numbers. What ends in an
/// ellipsis on purpose, ElidedLabel, is left out.
QStringList cutTexts(const QWidget* root);

}  // namespace isoscope::test
