// SPDX-License-Identifier: GPL-3.0-or-later
// What comes with the program must deserve its own praise.
#include <QDir>
#include <QFile>
#include <QTest>

#include "core/exchange/read_scene.h"
#include "core/render/render_image.h"
#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/gradient/hole_map.h"
#include "core/study/view/fitted_view.h"
#include "test_folders.h"
#include "tests/support/problems.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QDir folder(QStringLiteral(ISOSCOPE_SOURCE_DIR "/examples"));
const QString lessonMark = QStringLiteral(" as-povray");

QStringList contents() {
    QFile file(folder.filePath("contents.txt"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)
                                          : QStringList();
}

ParseResult readExample(const QString& name, int width = 240, int height = 180) {
    QFile file(folder.filePath(name));
    ParseOptions options;
    options.imageWidth = width;
    options.imageHeight = height;
    options.file = file.fileName().toStdString();
    return readScene(file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string(), options);
}

/// The least distance between what a scene shows and the edges of the picture, in pixels.
int marginOf(const ParseResult& parsed, int width, int height) {
    RenderRequest request = requestFor(parsed, width, height);
    request.rootFinder = RootFinder::certified;
    RenderRequest nothing = request;
    auto empty = std::make_shared<Scene>(*parsed.scene);
    empty->objects.clear();
    nothing.scene = empty;
    const Image picture = renderImage(request), ground = renderImage(nothing);
    int margin = width;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            if (picture.pixels[at] != ground.pixels[at])
                margin = std::min({margin, x, y, width - 1 - x, height - 1 - y});
        }
    return margin;
}

}  // namespace

class ExamplesTest : public QObject {
    Q_OBJECT

  private slots:
    void theContentsNameThemAll() {
        QStringList named = contents();
        QCOMPARE(named.first(), QString("tutorial.pov"));
        for (QString& name : named) name.remove(lessonMark);
        named.sort();
        QCOMPARE(named, folder.entryList({"*.pov", "*.vl"}, QDir::Files, QDir::Name));
    }

    /// A bug once: the bottle stood 3 pixels from the upper edge, and wide pictures cut most examples, for
    /// `angle` is that of the width.
    void everyExampleHasAMarginInUsualPictures_data() { everyExampleIsRightAndWhole_data(); }
    void everyExampleHasAMarginInUsualPictures() {
        QFETCH(QString, name);
        for (const QSize size : {QSize(400, 300), QSize(480, 270)}) {
            const int margin =
                marginOf(readExample(name, size.width(), size.height()), size.width(), size.height());
            const double share = 100.0 * margin / size.height();
            qInfo("%-28s %d x %d: %.1f %% of the height", qPrintable(name), size.width(), size.height(),
                  share);
            QVERIFY2(share >= 2, qPrintable(QStringLiteral("%1 at %2").arg(name).arg(size.width())));
        }
    }

    void everyExampleIsRightAndWhole_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("lesson");
        for (QString name : contents()) {
            const bool lesson = name.endsWith(lessonMark);
            name.remove(lessonMark);
            QTest::newRow(qPrintable(name)) << name << lesson;
        }
    }
    void everyExampleIsRightAndWhole() {
        QFETCH(QString, name);
        QFETCH(bool, lesson);
        const ParseResult parsed = readExample(name);
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            QVERIFY2(diagnostic.severity == Severity::note, problems(parsed).c_str());
        RenderRequest request = requestFor(parsed, 240, 180);

        RenderRequest nothing = request;
        auto empty = std::make_shared<Scene>(*parsed.scene);
        empty->objects.clear();
        nothing.scene = empty;
        request.rootFinder = RootFinder::certified;
        const Image picture = renderImage(request), ground = renderImage(nothing);
        int seen = 0, cut = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * picture.width + x;
                if (picture.pixels[at] == ground.pixels[at]) continue;
                ++seen;
                cut += x == 0 || y == 0 || x + 1 == picture.width || y + 1 == picture.height;
            }
        qInfo("%-28s %.1f %% of the picture", qPrintable(name), 100.0 * seen / (240 * 180));
        if (cut > 0) {
            SurfaceBounds surfaces(parsed.scene);
            const auto fitted = fittedView(request.camera, request.camera, surfaces);
            QVERIFY(fitted);
            qInfo("fits at location <%.3g, %.3g, %.3g> look_at <%.3g, %.3g, %.3g>", fitted->location.x,
                  fitted->location.y, fitted->location.z, fitted->lookAt.x, fitted->lookAt.y,
                  fitted->lookAt.z);
        }
        QCOMPARE(cut, 0);
        // VirtuaLight's notation has neither camera nor max_gradient.
        const bool virtualight = parsed.notation == Notation::virtualight;
        QVERIFY(seen > (virtualight ? 0.05 : 0.2) * 240 * 180);
        if (virtualight) return;

        request.rootFinder = RootFinder::lipschitz;
        RenderStatistics statistics;
        renderImage(request, 0, &statistics);
        const auto wrong = static_cast<int>(holeMap(request).mistakes());
        for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
            const Isosurface& surface = *parsed.scene->isosurfaces[i].shape;
            GradientStudy study(surface.tape(), *parsed.scene->parameterTable, surface.settings().container,
                                {0.01, 700'000});
            const GradientBracket& bracket = study.run();
            const double setting = surface.rootSettings().maxGradient;
            const GradientVerdict verdict = judgeGradient(setting, bracket, statistics.gradients[i].steepest);
            qInfo("max_gradient %g, proven [%.4g, %.4g], %d pixels wrong", setting, bracket.lower,
                  bracket.upper, wrong);
            // The lesson is about holes: it must have some, and many.
            QCOMPARE(verdict, lesson ? GradientVerdict::holes : GradientVerdict::right);
        }
        // At edges, what is thinner than the accuracy is missed with any max_gradient.
        QVERIFY2(lesson ? wrong > 5000 : wrong <= 4, qPrintable(QString::number(wrong)));
    }
};

QTEST_APPLESS_MAIN(ExamplesTest)
#include "examples_test.moc"
