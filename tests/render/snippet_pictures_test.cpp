// SPDX-License-Identifier: GPL-3.0-or-later
// The snippets of POV-Ray's insert menu that hold an isosurface or a parametric surface, where its examples
// are installed: each opens and shows something.
#include <algorithm>
#include <QFile>
#include <QTest>

#include "tests/support/csv_table.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

const QString examples = QStringLiteral("/usr/share/doc/povray/examples/");

/// The snippet with a camera, a light and the includes that the insert menu expects.
std::string sceneOf(const QByteArray& snippet) {
    std::string text =
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb <0.02, 0.9, 0.04> }\n";
    for (const char* include : {"colors", "textures", "functions", "math", "rand", "transforms", "metals",
                                "stones", "woods", "golds"})
        text += std::string("#include \"") + include + ".inc\"\n";
    text += "camera { location <0.5, 3, -6> look_at 0 angle 50 }\nlight_source { <5, 9, -9> 1 }\n";
    return text + snippet.toStdString();
}

/// Share of the pixels that do not show the background.
double coveredShare(const ParseResult& parsed) {
    const Image image = renderImage(test::requestFor(parsed, 48, 36));
    if (image.pixels.empty()) return 0;
    const auto background = image.pixels.front();
    const auto differ = std::count_if(image.pixels.begin(), image.pixels.end(),
                                      [&](const auto& pixel) { return !(pixel == background); });
    return static_cast<double>(differ) / static_cast<double>(image.pixels.size());
}

}  // namespace

class SnippetPicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void everySnippetOpensAndShows_data() {
        QTest::addColumn<QString>("name");
        QFile list(test::dataFile("golden/snippets-public.txt"));
        QVERIFY(list.open(QIODevice::ReadOnly));
        const QStringList names = QString::fromUtf8(list.readAll()).split('\n', Qt::SkipEmptyParts);
        QCOMPARE(names.size(), 40);
        for (const QString& name : names) QTest::newRow(qPrintable(name)) << name;
    }

    void everySnippetOpensAndShows() {
        QFETCH(QString, name);
        QFile file(examples + name);
        if (!file.open(QIODevice::ReadOnly)) QSKIP("POV-Ray's examples are not installed");
        ParseOptions options;
        options.libraryPaths = installedLibraryPaths();
        const ParseResult parsed = parseScene(sceneOf(file.readAll()), options);
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            QVERIFY2(diagnostic.severity != Severity::error, toString(diagnostic, *parsed.sources).c_str());
        QVERIFY(!parsed.scene->objects.empty());
        const double share = coveredShare(parsed);
        qInfo("%s: %.1f %% of the picture", qPrintable(name), 100 * share);
        QVERIFY(share > 0.001);
    }
};

QTEST_APPLESS_MAIN(SnippetPicturesTest)
#include "snippet_pictures_test.moc"
