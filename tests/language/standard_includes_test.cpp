// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <fstream>
#include <iterator>

#include "core/language/directives/library_paths.h"
#include "core/language/parse.h"
#include "tests/language/stream_run.h"

using namespace isoscope;
using namespace isoscope::test;

/// Where POV-Ray is installed, the directives of its include files run without a mistake.
class StandardIncludesTest : public QObject {
    Q_OBJECT

  private slots:
    void runTheirDirectives_data() {
        QTest::addColumn<QString>("path");
        if (installedLibraryPaths().empty()) return;
        const QDir folder(QString::fromStdString(installedLibraryPaths().front().string()));
        for (const QString& name : folder.entryList({"*.inc", "*.map"}, QDir::Files))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }

    void runTheirDirectives() {
        if (installedLibraryPaths().empty()) QSKIP("POV-Ray's include files are not installed");
        QFETCH(QString, path);
        std::ifstream input(path.toStdString(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(input), {}};
        ParseOptions options;
        options.file = path.toStdString();
        options.libraryPaths = installedLibraryPaths();
        const StreamRun done = run(text, options);
        for (const Diagnostic& diagnostic : done.context->diagnostics)
            QVERIFY2(diagnostic.severity != Severity::error,
                     toString(diagnostic, done.context->sources).c_str());
    }
};

QTEST_APPLESS_MAIN(StandardIncludesTest)
#include "standard_includes_test.moc"
