// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/include_library.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <iterator>

#include "core/language/directives/asset_file.h"
#include "core/language/directives/library_paths.h"
#include "core/language/directives/native_includes.h"
#include "test_folders.h"
#include "tests/language/stream_run.h"

using namespace isoscope;
using namespace isoscope::test;

class IncludeLibraryTest : public QObject {
    Q_OBJECT

    static void write(const QTemporaryDir& folder, const QString& name, const QByteArray& text) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    static ParseOptions beside(const QTemporaryDir& folder) {
        ParseOptions options;
        options.file = folder.filePath("scene.pov").toStdString();
        return options;
    }

  private slots:
    void theTableHoldsResourcesInclude() {
        QVERIFY(!nativeIncludes().empty());
        for (const NativeInclude& include : nativeIncludes()) {
            QFile file(QStringLiteral(ISOSCOPE_SOURCE_DIR "/resources/include/") +
                       QString::fromUtf8(include.name.data(), static_cast<int>(include.name.size())));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), QByteArray(include.text.data(), static_cast<int>(include.text.size())));
        }
    }

    void nativeFilesComeFirst() {
        QTemporaryDir folder;
        write(folder, "colors.inc", "#declare A = 1;");
        const StreamRun done = run("#include \"colors.inc\" #ifdef (A) mine #end", beside(folder));
        QCOMPARE(QString::fromStdString(done.tokens), QString());
        QVERIFY2(done.said().empty(), done.said().c_str());
        QVERIFY(IncludeLibrary::isNative("functions.inc"));
        QVERIFY(!IncludeLibrary::isNative("nowhere.inc"));
    }

    void searchesBesideTheIncluderTheSceneAndInLibraries() {
        QTemporaryDir scene, library;
        QVERIFY(QDir(scene.path()).mkdir("parts"));
        write(scene, "parts/outer.inc",
              "#include \"inner.inc\" #include \"second.inc\" #include \"third.inc\"");
        write(scene, "parts/inner.inc", "one");
        write(scene, "second.inc", "two");
        write(library, "second.inc", "wrong");
        write(library, "third.inc", "three");
        ParseOptions options = beside(scene);
        options.libraryPaths = {library.path().toStdString()};
        const StreamRun done = run("#include \"parts/outer.inc\" four", options);
        QCOMPARE(QString::fromStdString(done.tokens), QString("one two three four"));
        QCOMPARE(QString::fromStdString(run("#include \"parts\\inner.inc\"", options).tokens),
                 QString("one"));
    }

    /// The folder where the program was started counted as that of the text and was refused.
    void filesAreLookedForInTheLibrariesBeforeTheyAreRefused() {
        QTemporaryDir scene, library, outside;
        write(library, "own.inc", "found");
        ParseOptions options = beside(scene);
        options.restrictedReading = true;
        options.libraryPaths = {library.path().toStdString()};
        const StreamRun named = run("#include \"own.inc\"", options);
        QCOMPARE(QString::fromStdString(named.tokens), QString("found"));
        ParseContext context(options);
        const std::uint32_t text = context.sources.add("scene.pov", "");
        const AssetFile missing = findAsset(context, "nowhere", {text, 0, 0});
        QVERIFY(!missing);
        QCOMPARE(QString::fromStdString(missing.problem), QString());
        QVERIFY(findAsset(context, "own.inc", {text, 0, 0}));
        write(outside, "other.inc", "other");
        const AssetFile refused =
            findAsset(context, outside.filePath("other.inc").toStdString(), {text, 0, 0});
        QVERIFY(!refused && !refused.problem.empty());
    }

    void theNameMayBeComposed() {
        QTemporaryDir folder;
        write(folder, "part2.inc", "found");
        const StreamRun done = run("#include concat(\"part\", str(2, 0, 0), \".inc\") b", beside(folder));
        QCOMPARE(QString::fromStdString(done.tokens), QString("found b"));
        const StreamRun named = run("#declare N = \"part2.inc\"; #include N b", beside(folder));
        QCOMPARE(QString::fromStdString(named.tokens), QString("found b"));
    }

    void aFileIsReadOnceHoweverOftenItIsIncluded() {
        QTemporaryDir folder;
        write(folder, "a.inc", "a");
        const StreamRun done = run("#for (I, 1, 5) #include \"a.inc\" #end", beside(folder));
        QCOMPARE(QString::fromStdString(done.tokens), QString("a a a a a"));
        QCOMPARE(done.context->sources.size(), std::size_t(2));
    }

    void localNamesEndWithTheirFile() {
        QTemporaryDir folder;
        write(folder, "a.inc", "#local L = 1; #declare G = 2; #ifdef (L) inside #end");
        const StreamRun done =
            run("#include \"a.inc\" #ifdef (L) outside #end #ifdef (G) global #end", beside(folder));
        QCOMPARE(QString::fromStdString(done.tokens), QString("inside global"));
    }

    void numbersOfIncludedFilesAreNoSliders() {
        QTemporaryDir folder;
        write(folder, "a.inc", "#declare A = 1;");
        QVERIFY(run("#include \"a.inc\"", beside(folder)).context->parameters.empty());
    }

    void mistakesTellTheIncludes() {
        QTemporaryDir folder;
        write(folder, "a.inc", "\n\n#declar");
        const StreamRun done = run("x\n #include \"a.inc\"", beside(folder));
        QCOMPARE(done.messages().size(), std::size_t(1));
        QVERIFY2(done.messages()[0].ends_with("a.inc:3:1: error: `#declar` is not a directive. < 2:2"),
                 done.said().c_str());
    }

    void blocksDoNotReachOutOfAFile() {
        QTemporaryDir folder;
        write(folder, "a.inc", "#if (1) a");
        const StreamRun done = run("#include \"a.inc\" b", beside(folder));
        QCOMPARE(QString::fromStdString(done.tokens), QString("a b"));
        QVERIFY(done.said().find("a.inc:1:1: error: `#if` is never closed; expected `#end`.") !=
                std::string::npos);
    }

    void aFileThatIncludesItselfIsCutOff() {
        QTemporaryDir folder;
        write(folder, "a.inc", "a #include \"a.inc\"");
        const StreamRun done = run("#include \"a.inc\"", beside(folder));
        QCOMPARE(done.context->diagnostics.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(done.context->diagnostics[0].message),
                 QString("Reading stops here: include files include each other more than 32 deep."));
    }

    void hintsAtNativeNames() {
        const StreamRun done = run("#include \"colours.inc\"");
        QCOMPARE(QString::fromStdString(done.context->diagnostics.at(0).hint),
                 QString("did you mean \"colors.inc\"?"));
    }

    void refusesWhatIsNoFile() {
        for (const char* text : {"#include \"\"", "#include \"/\"", "#include \"..\"", "#include chr(0)"})
            QVERIFY2(hasErrors(run(text).context->diagnostics), text);
    }

    void theMostRecentVersionComesFirst() {
        QTemporaryDir first, second;
        const QStringList versions{"povray-3.7", "povray-3.5", "povray-3.8", "povray", "povray-3.6", "other"};
        for (const QTemporaryDir* share : {&first, &second})
            for (const QString& version : versions) QVERIFY(QDir(share->path()).mkpath(version + "/include"));
        QVERIFY(QDir(first.path()).mkdir("povray-3.9"));
        const QByteArray named = qgetenv("POVRAY_LIBRARY_PATH");
        qputenv("POVRAY_LIBRARY_PATH", first.path().toUtf8() + ":/nowhere:" + second.path().toUtf8());
        const std::vector<std::filesystem::path> found =
            installedLibraryPaths({first.path().toStdString(), second.path().toStdString()});
        if (named.isNull())
            qunsetenv("POVRAY_LIBRARY_PATH");
        else
            qputenv("POVRAY_LIBRARY_PATH", named);
        QStringList expected{first.path(), second.path()};
        for (const QTemporaryDir* share : {&first, &second})
            for (const char* version : {"povray-3.8", "povray-3.7", "povray-3.6", "povray-3.5", "povray"})
                expected << share->filePath(version + QStringLiteral("/include"));
        QStringList paths;
        for (const std::filesystem::path& path : found) paths << QString::fromStdString(path.string());
        QCOMPARE(paths, expected);
    }

    /// Where POV-Ray is installed, the directives of its include files run without a mistake.
    void theStandardIncludesRun_data() {
        QTest::addColumn<QString>("path");
        if (installedLibraryPaths().empty()) return;
        const QDir folder(QString::fromStdString(installedLibraryPaths().front().string()));
        for (const QString& name : folder.entryList({"*.inc", "*.map"}, QDir::Files))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }

    void theStandardIncludesRun() {
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

QTEST_APPLESS_MAIN(IncludeLibraryTest)
#include "include_library_test.moc"
