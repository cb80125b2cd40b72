// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>
#include <clocale>

#include "tests/support/program.h"

namespace isoscope::test {

/// A system whose language writes 1,5 for a half more than one: `de_DE.UTF-8`, made for this test, in force
/// for this process and those that it starts, gone at the end. valid() is false where Debian's package
/// `locales` is missing.
class CommaLocale {
  public:
    CommaLocale() {
        const QString made = folder_.filePath(QStringLiteral("de_DE.UTF-8"));
        runProgram(QStringLiteral("localedef"), {"-i", "de_DE", "-f", "UTF-8", made});
        qputenv("LOCPATH", folder_.path().toUtf8());
        qputenv("LC_ALL", "de_DE.UTF-8");
        valid_ = std::setlocale(LC_ALL, "") && std::localeconv()->decimal_point[0] == ',';
    }
    ~CommaLocale() {
        std::setlocale(LC_ALL, "C.UTF-8");
        qputenv("LC_ALL", "C.UTF-8");
        qunsetenv("LOCPATH");
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

    bool valid() const { return valid_; }

  private:
    QTemporaryDir folder_;
    bool valid_ = false;
};

}  // namespace isoscope::test
