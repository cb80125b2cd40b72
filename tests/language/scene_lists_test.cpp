// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes that come with POV-Ray, where they are installed: how many are understood.
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "core/language/directives/library_paths.h"
#include "core/language/parse.h"
#include "tests/support/csv_table.h"
#include "tests/support/sanitizer.h"

using namespace isoscope;

namespace {

const QString examples = QStringLiteral("/usr/share/doc/povray/examples/");

QStringList linesOf(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
}

/// Frame 1 of the animation that the .ini file beside the scene asks for: some scenes pick their subject by
/// it.
void applyIni(const QString& scene, ParseOptions& options) {
    const QString text = linesOf(QString(scene).replace(QRegularExpression("\\.pov$"), ".ini")).join('\n');
    static const QRegularExpression final(
        "^\\s*(?:Final_Frame\\s*=|\\+KFF)\\s*(\\d+)",
        QRegularExpression::MultilineOption | QRegularExpression::CaseInsensitiveOption);
    const QRegularExpressionMatch match = final.match(text);
    if (!match.hasMatch()) return;
    options.clockOn = true;
    options.frameNumber = 1;
    options.finalFrame = match.captured(1).toInt();
}

struct Outcome {
    QString firstError;  ///< empty when there is none
    int leftOut = 0;
    std::size_t objects = 0;
};

Outcome parsed(const QString& name) {
    ParseOptions options;
    options.libraryPaths = installedLibraryPaths();
    options.imageWidth = 80;
    options.imageHeight = 60;
    applyIni(examples + name, options);
    const ParseResult result = parseSceneFile((examples + name).toStdString(), options);
    Outcome outcome;
    for (const Diagnostic& diagnostic : result.diagnostics) {
        outcome.leftOut += diagnostic.severity == Severity::leftOut;
        if (diagnostic.severity == Severity::error && outcome.firstError.isEmpty())
            outcome.firstError = QString::fromStdString(toString(diagnostic, *result.sources));
    }
    outcome.objects = result.scene->objects.size();
    return outcome;
}

/// Prints a row a scene; the answer is how many have no error.
int understood(const QStringList& names) {
    int good = 0;
    for (const QString& name : names) {
        const Outcome outcome = parsed(name);
        good += outcome.firstError.isEmpty();
        qInfo("%-52s %7zu objects, %3d left out%s%s", qPrintable(name), outcome.objects, outcome.leftOut,
              outcome.firstError.isEmpty() ? "" : "  ", qPrintable(outcome.firstError));
    }
    qInfo("%d of %lld scenes without an error", good, static_cast<long long>(names.size()));
    return good;
}

}  // namespace

class SceneListsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        if (!QFile::exists(examples)) QSKIP("POV-Ray's examples are not installed");
    }

    void scenesWithIsosurfacesAreUnderstood() {
        const QStringList names = linesOf(test::dataFile("golden/scenes-public.txt"));
        QCOMPARE(names.size(), 23);
        QCOMPARE(understood(names), 23);
    }

    /// Loops over all pixels: at this size it was cut off.
    void theLongestSceneIsUnderstoodAt800x600() {
        ParseOptions options;
        options.libraryPaths = installedLibraryPaths();
        options.progress = std::make_shared<ParseProgress>();
        if (test::checksAddresses) options.secondsBudget *= 10;
        const QString scene = examples + "camera/mesh_camera/meshcam_persp_demo.pov";
        const ParseResult result = parseSceneFile(scene.toStdString(), options);
        QVERIFY(result.ok());
        const std::size_t steps = options.progress->steps;
        qInfo("%zu steps", steps);
        QVERIFY(steps > ParseOptions().stepBudget / 2);
    }

    void otherScenesAreUnderstood() {
        const QStringList names = linesOf(test::dataFile("golden/scenes-other-public.txt"));
        QCOMPARE(names.size(), 213);
        QVERIFY(understood(names) >= 0.95 * 213);
    }
};

QTEST_APPLESS_MAIN(SceneListsTest)
#include "scene_lists_test.moc"
