// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/version_lens.h"

#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"

using namespace isoscope;

class VersionLensTest : public QObject {
    Q_OBJECT

    static QStringList said(const ParseResult& parsed) {
        QStringList all;
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.id == "version")
                all << QString::fromStdString("[" + std::string(parsed.sources->slice(diagnostic.range)) +
                                              "] " + diagnostic.message);
        return all;
    }

  private slots:
    void whatAVersionChangesIsSaid_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char* name, const char* text, const QStringList& expected) {
            QTest::newRow(name) << QString(text) << expected;
        };
        const QString gamma = " without `assumed_gamma` the picture is darker than in 3.7";
        row("no directive", "sphere { 0, 1 }", {});
        row("3.7", "#version 3.7; #for (I, 1, 2) #end", {});
        row("3.6", "#version 3.6; sphere { 0, 1 }", {"[#version] For version 3.6:" + gamma + "."});
        row("3.6 with gamma", "#version 3.6; global_settings { assumed_gamma 2.2 }", {});
        row("3.62", "#version 3.62; sphere { 0, 1 }", {"[#version] For version 3.62:" + gamma + "."});
        row("3.1", "#version 3.1; sphere { 0, 1 }",
            {"[#version] For version 3.1:" + gamma + "; noise looks as with `noise_generator 1`."});
        row("filter",
            "#version 3.6; global_settings { assumed_gamma 1 } sphere { 0, 1 pigment { rgbf <1, 0, 0, 0.5> } "
            "}",
            {"[#version] For version 3.6: objects with `filter` show more of their own colour than in 3.7."});
        row("transmit alone",
            "#version 3.6; global_settings { assumed_gamma 1 } sphere { 0, 1 pigment { rgbt <1, 0, 0, 0.5> } "
            "}",
            {});
        row("newer words",
            "#version 3.5; global_settings { assumed_gamma 1 }\n#for (I, 1, 2) #end #for (I, 1, 2) #end",
            {"[#for] `#for` came with POV-Ray 3.7; the text asks for version 3.5."});
        row("before the directive counts",
            "#version 3.1; global_settings { assumed_gamma 1 noise_generator 2 }",
            {"[noise_generator] `noise_generator` came with POV-Ray 3.5; the text asks for version 3.1."});
        row("3.8", "#version 3.8; sphere { 0, 1 }",
            {"[#version] POV-Ray 3.7 refuses texts for version 3.8; here they are read by the rules of "
             "3.7."});
    }
    void whatAVersionChangesIsSaid() {
        QFETCH(QString, text);
        QFETCH(QStringList, expected);
        QCOMPARE(said(parseScene(text.toStdString())), expected);
    }

    void whatIncludeFilesSayCounts() {
        const QTemporaryDir folder;
        QFile file(folder.filePath("settings.inc"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("global_settings { assumed_gamma 1 }");
        file.close();
        ParseOptions options;
        options.file = folder.filePath("scene.pov").toStdString();
        const ParseResult parsed =
            parseScene("#version 3.6;\n#include \"settings.inc\"\nsphere { 0, 1 }", options);
        QVERIFY(parsed.ok());
        QCOMPARE(said(parsed), QStringList());
    }

    /// As in POV-Ray 3.7's pictures: the version in force at the end of the text decides, and an explicit
    /// generator before it.
    void noiseFollowsTheVersion_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("generator");
        const auto row = [](const char* text, int generator) {
            QTest::newRow(text) << QString(text) << generator;
        };
        row("sphere { 0, 1 }", 2);
        row("#version 3.5;", 2);
        row("#version 3.1;", 1);
        row("#version 3.1; #version 3.7;", 2);
        row("#version 3.7; #version 3.1;", 1);
        row("#version 3.1; global_settings { noise_generator 2 }", 2);
        row("#version 3.1; global_settings { noise_generator 3 }", 3);
        row("#version 3.7; global_settings { noise_generator 1 }", 1);
    }
    void noiseFollowsTheVersion() {
        QFETCH(QString, text);
        QFETCH(int, generator);
        QCOMPARE(parseScene(text.toStdString()).scene->settings.noiseGenerator, generator);
    }

    /// POV-Ray 3.7 draws such a scene like one of 3.62 unless an include file of its own says a version.
    void aSceneWithoutVersionIsTold_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("notes");
        const auto row = [](const char* name, const char* text, int notes) {
            QTest::newRow(name) << QString(text) << notes;
        };
        row("camera", "camera { location -z } sphere { 0, 1 }", 1);
        row("light", "light_source { 5, 1 } sphere { 0, 1 }", 1);
        row("no scene for POV-Ray", "sphere { 0, 1 }", 0);
        row("version", "#version 3.7; camera { location -z } sphere { 0, 1 }", 0);
        row("old version", "#version 3.62; camera { location -z } sphere { 0, 1 }", 0);
        row("include file", "#include \"colors.inc\"\ncamera { location -z } sphere { 0, 1 }", 0);
        row("gamma", "global_settings { assumed_gamma 1 } camera { location -z } sphere { 0, 1 }", 0);
    }
    void aSceneWithoutVersionIsTold() {
        QFETCH(QString, text);
        QFETCH(int, notes);
        int found = 0;
        for (const Diagnostic& diagnostic : parseScene(text.toStdString()).diagnostics) {
            if (diagnostic.id != "no-version") continue;
            ++found;
            QCOMPARE(diagnostic.severity, Severity::note);
            QVERIFY(diagnostic.hint.find("#version 3.7;") != std::string::npos);
        }
        QCOMPARE(found, notes);
    }

    void whatPovray38AddedIsSaidToBeMissing() {
        const auto firstError = [](const char* text) {
            for (const Diagnostic& diagnostic : parseScene(text).diagnostics)
                if (diagnostic.severity == Severity::error) return QString::fromStdString(diagnostic.message);
            return QString();
        };
        QCOMPARE(firstError("#declare D = dictionary { .a: 1 };"),
                 QString("Dictionaries, which came with POV-Ray 3.8, are not read."));
        // Its members are not blamed again.
        const ParseResult used =
            parseScene("#declare D = dictionary { .a: 1, .b: 2 }; sphere { 0, D.b } box { -D.a, D.a.x }");
        int errors = 0;
        for (const Diagnostic& diagnostic : used.diagnostics)
            errors += diagnostic.severity == Severity::error;
        QCOMPARE(errors, 1);
        QCOMPARE(firstError("#declare A = array mixed [2] { 1, \"a\" };"),
                 QString("Mixed arrays, which came with POV-Ray 3.8, are not read."));
        QCOMPARE(firstError("#declare A = array [2] mixed { 1, \"a\" };"),
                 QString("Mixed arrays, which came with POV-Ray 3.8, are not read."));
    }
};

QTEST_APPLESS_MAIN(VersionLensTest)
#include "version_lens_test.moc"
