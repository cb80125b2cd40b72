// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QTest>
#include <map>
#include <set>

#include "core/language/directives/library_paths.h"
#include "core/language/parse.h"
#include "core/text/csv_table.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

const QString demo = QStringLiteral("/usr/share/doc/povray/examples/incdemo/i_internal.pov");

QStringList scenesIn(const QString& folder, const QStringList& patterns) {
    QStringList files;
    QDirIterator iterator(folder, patterns, QDir::Files);
    while (iterator.hasNext()) files << iterator.next();
    files.sort();
    return files;
}

/// Contradictions of the tutorials that these examples settle (docs/povray/coverage.md).
const std::map<QString, QString> settledBy{
    {"iso_plane_x.inc", "CONF-16 CONF-17"}, {"iso_rotate_z.inc", "CONF-19"},
    {"iso_mirror_xy.inc", "CONF-20"},       {"iso_shear_xy.pov", "CONF-21 CONF-24"},
    {"iso_twist_x.inc", "CONF-22"},         {"iso_difference_functions.pov", "CONF-23 CONF-24"},
    {"iso_union_min.pov", "CONF-25"},       {"iso_fn1_x_plus_y.inc", "CONF-85"},
};

/// The name of a test: the file and the rows of the checklist that it holds.
QString tagOf(const QString& file) {
    static const test::CsvTable rows(test::dataFile("spec/example_ids.csv"));
    QString tag = file;
    for (std::size_t row = 0; row < rows.rowCount(); ++row)
        if (rows.field(row, "file") == file.toStdString())
            tag += " " + QString::fromStdString(rows.field(row, "id"));
    const auto settled = settledBy.find(file);
    return settled == settledBy.end() ? tag : tag + " " + settled->second;
}

/// Every slider's range must hold the text of its number.
QString wrongSlider(const ParseResult& parsed) {
    for (const SceneParameter& parameter : parsed.scene->parameters) {
        const std::string text(parsed.sources->slice(parameter.range));
        const QString name =
            QString::fromStdString(parameter.group + ": " + parameter.name + " at `" + text + "`");
        if (text.empty() != parameter.implied) return name + " has no place";
        if (parameter.implied) continue;
        if (parameter.expression) {
            if (text != parameter.text) return name + " shows " + QString::fromStdString(parameter.text);
            continue;
        }
        QString compact = QString::fromStdString(text);
        compact.remove(' ');
        bool number = false;
        if (compact.toDouble(&number) != parameter.value || !number) return name + " has another value";
        if (parameter.minimum > parameter.value || parameter.maximum < parameter.value)
            return name + " is outside its range";
        if (parameter.slot >= 0 &&
            (*parsed.scene->parameterTable).at(std::size_t(parameter.slot)) != parameter.value)
            return name + " has another value in the table";
    }
    return {};
}

ParseResult demoFrame(int frame) {
    ParseOptions options;
    options.clockOn = true;
    options.frameNumber = frame;
    options.initialFrame = 1;
    options.finalFrame = 78;
    options.clock = (frame - 1) / 77.0;
    options.imageWidth = 320;
    options.imageHeight = 240;
    return parseSceneFile(demo.toStdString(), options);
}

}  // namespace

class ExampleScenesTest : public QObject {
    Q_OBJECT

  private slots:
    void scenes_data() {
        QTest::addColumn<QString>("file");
        const QString examples = test::dataFile("spec/examples");
        QStringList files = scenesIn(examples, {"iso_*.pov", "iso_*.inc", "fn_isosurface*.inc"});
        QVERIFY(files.size() >= 28);
        files += scenesIn(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tests/bench"), {"*.pov"});
        for (const QString& file : files)
            QTest::newRow(qPrintable(tagOf(QFileInfo(file).fileName()))) << file;
    }

    void scenes() {
        QFETCH(QString, file);
        const ParseResult parsed = parseSceneFile(file.toStdString());
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY2(!parsed.scene->isosurfaces.empty(), "no isosurface");
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            QVERIFY2(diagnostic.severity == Severity::note, problems(parsed).c_str());
        const QString wrong = wrongSlider(parsed);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        for (const SceneIsosurface& isosurface : parsed.scene->isosurfaces) {
            QVERIFY(parsed.sources->slice(isosurface.range).starts_with("isosurface"));
            QVERIFY(parsed.sources->slice(isosurface.range).ends_with("}"));
            QVERIFY(!isosurface.functionText.empty());
        }
    }

    /// The examples of everything but isosurfaces.
    void examplesOfShapes_data() {
        QTest::addColumn<QString>("file");
        const test::CsvTable rows(test::dataFile("spec/example_ids.csv"));
        for (std::size_t row = 0; row < rows.rowCount(); ++row) {
            const QString name = QString::fromStdString(rows.field(row, "file"));
            if (name.endsWith(".vl") || name.startsWith("iso_")) continue;
            QTest::newRow(qPrintable(tagOf(name))) << test::dataFile("spec/examples/" + name);
        }
    }

    void examplesOfShapes() {
        QFETCH(QString, file);
        ParseOptions options;
        options.libraryPaths = installedLibraryPaths();
        if (options.libraryPaths.empty()) QSKIP("fonts and include files come with POV-Ray");
        const ParseResult parsed = parseSceneFile(file.toStdString(), options);
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            QVERIFY2(diagnostic.severity == Severity::note || diagnostic.severity == Severity::leftOut,
                     problems(parsed).c_str());
        QVERIFY(!parsed.scene->objects.empty());
    }

    void demoOfAllBuiltins_FN_GEN() {
        if (!QFile::exists(demo)) QSKIP("the Debian package povray-examples is not installed");
        double slowest = 0;
        std::set<std::string> called;
        std::size_t sliders = 0;
        for (int frame = 1; frame <= 78; ++frame) {
            const ParseResult parsed = demoFrame(frame);
            const std::string where = "frame " + std::to_string(frame) + "\n" + problems(parsed);
            QVERIFY2(parsed.ok(), where.c_str());
            QVERIFY2(!parsed.scene->isosurfaces.empty(), where.c_str());
            const QString wrong = wrongSlider(parsed);
            QVERIFY2(wrong.isEmpty(), qPrintable(QString::fromStdString(where) + wrong));
            for (const SceneParameter& parameter : parsed.scene->parameters)
                if (parameter.role == ParameterRole::argument) called.insert(parameter.group);
            sliders += parsed.scene->parameters.size();
            slowest = std::max(slowest, parsed.seconds);
        }
        qInfo("78 frames: %zu sliders, parameters of %zu built-ins, slowest parse %.1f ms", sliders,
              called.size(), 1000 * slowest);
        QVERIFY(called.size() >= 70);
    }

    void slidersOfADemoFrame() {
        if (!QFile::exists(demo)) QSKIP("the Debian package povray-examples is not installed");
        const ParseResult parsed = demoFrame(17);
        std::vector<std::string> found;
        for (const SceneParameter& p : parsed.scene->parameters)
            if (p.role == ParameterRole::argument)
                found.push_back(p.name + "=" + std::string(parsed.sources->slice(p.range)));
        QCOMPARE(found, (std::vector<std::string>{"Field Strength=-.05", "Major Radius=0.27",
                                                  "Minor Radius=0.04", "X Displacement=0.55",
                                                  "Y Displacement=0.0", "Inversion Radius=1.0"}));
    }
};

QTEST_APPLESS_MAIN(ExampleScenesTest)
#include "example_scenes_test.moc"
