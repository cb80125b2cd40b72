// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_folders.h"
#include "tests/support/program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>

namespace isoscope::test {

ProgramResult runProgram(const QString& program, const QStringList& arguments, int timeoutSeconds,
                         const QString& folder) {
    QProcess process;
    if (!folder.isEmpty()) process.setWorkingDirectory(folder);
    process.start(program, arguments, QIODevice::ReadOnly);
    ProgramResult result;
    if (!process.waitForFinished(timeoutSeconds * 1000)) {
        process.kill();
        process.waitForFinished();
        result.errors = "did not end in " + QByteArray::number(timeoutSeconds) + " seconds";
        return result;
    }
    result.output = process.readAllStandardOutput();
    result.errors = process.readAllStandardError();
    if (process.exitStatus() == QProcess::NormalExit) result.status = process.exitCode();
    return result;
}

ProgramResult runCli(const QStringList& arguments, int timeoutSeconds) {
    return runProgram(QStringLiteral(ISOSCOPE_BINARY_DIR "/isoscope-cli"), arguments, timeoutSeconds);
}

double instructionsOfCli(const QStringList& arguments) {
    // What the loader and the libraries' initialisers do is not ours.
    const QStringList counting{"--tool=callgrind", "--toggle-collect=main", "--callgrind-out-file=/dev/null",
                               ISOSCOPE_BINARY_DIR "/isoscope-cli"};
    const ProgramResult run = runProgram("valgrind", counting + arguments, 250);
    static const QRegularExpression counted("Collected : (\\d+)");
    const QRegularExpressionMatch match = counted.match(QString::fromUtf8(run.errors));
    if (run.status != 0 || !match.hasMatch()) qWarning("%s", run.errors.constData());
    return run.status == 0 && match.hasMatch() ? match.captured(1).toDouble() : -1;
}

QString writeFile(const QString& folder, const QString& name, const QByteArray& text) {
    const QString path = QDir(folder).filePath(name);
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(text);
    return path;
}

isoscope::CsvTable tableOf(const ProgramResult& result) {
    return isoscope::CsvTable::parse(
        std::string_view(result.output.constData(), static_cast<std::size_t>(result.output.size())));
}

}  // namespace isoscope::test
