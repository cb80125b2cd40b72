// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/text/csv_table.h"

namespace isoscope::test {

/// What a program left behind. `status` is -1 when it crashed, could not be started or did not end in time.
struct ProgramResult {
    int status = -1;
    QByteArray output;
    QByteArray errors;
};

/// Runs a program to its end; kills it after `timeoutSeconds`.
ProgramResult runProgram(const QString& program, const QStringList& arguments, int timeoutSeconds = 60,
                         const QString& folder = {});

/// Runs isoscope-cli.
ProgramResult runCli(const QStringList& arguments, int timeoutSeconds = 60);

/// Instructions of `main` of isoscope-cli, as callgrind counts them: they do not depend on how busy the
/// machine is. What other threads do is not counted. -1 when it fails.
double instructionsOfCli(const QStringList& arguments);

/// A file with this text in a folder of the running test; returns its path.
QString writeFile(const QString& folder, const QString& name, const QByteArray& text);

/// What the program printed, as the table that it is.
isoscope::CsvTable tableOf(const ProgramResult& result);

}  // namespace isoscope::test
