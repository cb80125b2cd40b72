// SPDX-License-Identifier: GPL-3.0-or-later
// The isosurfaces of POV-Ray's insert menu, where its examples are installed: is their max_gradient too low,
// right or too high? Prints the table.
#include <map>
#include <QDir>
#include <QFile>
#include <QTest>

#include "core/language/directives/library_paths.h"
#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/view/traced_view.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString examples = QStringLiteral("/usr/share/doc/povray/examples/");
const QString folder = QStringLiteral("templates/");

QStringList snippets() {
    QStringList names;
    QDir templates(examples + folder);
    for (const QString& sub : templates.entryList({"Isosurfaces*"}, QDir::Dirs, QDir::Name))
        for (const QString& file :
             QDir(templates.filePath(sub)).entryList({"*.txt"}, QDir::Files, QDir::Name))
            names << folder + sub + "/" + file;
    return names;
}

ParseResult parseSnippet(const QString& name) {
    QFile file(examples + name);
    if (!file.open(QIODevice::ReadOnly)) return {};
    std::string text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";
    for (const char* include : {"colors", "textures", "functions", "math", "rand", "transforms", "metals",
                                "stones", "woods", "golds"})
        text += std::string("#include \"") + include + ".inc\"\n";
    text += "camera { location <0,2,-6> look_at 0 angle 40 }\nlight_source { <5,9,-9> 1 }\n";
    ParseOptions options;
    options.libraryPaths = installedLibraryPaths();
    return parseScene(text + file.readAll().toStdString(), options);
}

}  // namespace

class SnippetGradientTest : public QObject {
    Q_OBJECT

  private slots:
    void everySnippetIsJudged() {
        const QStringList names = snippets();
        if (names.isEmpty()) QSKIP("POV-Ray's examples are not installed");
        QVERIFY(names.size() >= 50);
        std::map<GradientVerdict, int> counts;
        int isosurfaces = 0;
        for (const QString& name : names) {
            const ParseResult parsed = parseSnippet(name);
            QVERIFY2(parsed.scene, qPrintable(name));
            RenderRequest view;
            view.scene = parsed.scene;
            view.camera = parsed.scene->camera;
            view.width = 80;
            view.height = 60;
            for (const SceneIsosurface& isosurface : parsed.scene->isosurfaces) {
                ++isosurfaces;
                const double setting = isosurface.shape->rootSettings().maxGradient;
                GradientStudy study(isosurface.shape->tape(), *parsed.scene->parameterTable,
                                    isosurface.shape->settings().container, {0.1, 30'000});
                const GradientBracket& b = study.run();
                const double steepest = traceView(view).steepest;
                const GradientVerdict verdict = judgeGradient(setting, b, steepest);
                ++counts[verdict];
                qInfo("%-44s max_gradient %-6.4g met %-9.4g bracket %-9.5g to %-9.5g %s%s%s",
                      qPrintable(name.section('/', -1)), setting, steepest, b.lower, b.upper,
                      std::string(isoscope::name(verdict)).c_str(), b.singularity ? " " : "",
                      b.singularity ? std::string(isoscope::name(b.singularity->kind)).c_str() : "");
                QVERIFY2(!std::isnan(b.upper) && b.lower <= b.upper, qPrintable(name));
                // Along a ray the slope is never steeper than the gradient's bound.
                QVERIFY2(b.seams || steepest <= b.upper * (1 + 1e-6), qPrintable(name));
                if (verdict == GradientVerdict::holes && b.state != GradientState::unbounded)
                    QVERIFY2(setting < b.lower, qPrintable(name));
                QVERIFY2(std::isfinite(b.upper) || b.singularity.has_value(), qPrintable(name));
            }
        }
        qInfo("%d isosurfaces: %d too low, %d right, %d too high, %d unbounded, %d unproven", isosurfaces,
              counts[GradientVerdict::holes], counts[GradientVerdict::right],
              counts[GradientVerdict::wasteful], counts[GradientVerdict::unbounded],
              counts[GradientVerdict::unproven]);
        QVERIFY2(isosurfaces >= 50, qPrintable(QString::number(isosurfaces)));
        QVERIFY(counts[GradientVerdict::holes] >= 10 && counts[GradientVerdict::wasteful] >= 20);
    }

    void knownSnippets() {
        const QString octahedron = folder + "Isosurfaces_by_basic_functions/04_Isosurface_octahedron.txt";
        if (!QFile::exists(examples + octahedron)) QSKIP("POV-Ray's examples are not installed");
        const ParseResult parsed = parseSnippet(octahedron);
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
        const auto& surface = parsed.scene->isosurfaces.front().shape;
        GradientStudy study(surface->tape(), *parsed.scene->parameterTable, surface->settings().container);
        QVERIFY(std::abs(study.run().upper - std::sqrt(3.0)) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(SnippetGradientTest)
#include "snippet_gradient_test.moc"
