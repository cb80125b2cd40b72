// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the lessons run as they stand there, and show what the lesson says of them.
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "core/exchange/read_scene.h"
#include "core/render/render_image.h"
#include "core/study/gradient/hole_map.h"
#include "test_folders.h"
#include "tests/support/problems.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr int width = 240, height = 180;

QString pageText(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The pixels in which two pictures differ; of those, `cut` lie at the edge.
struct Difference {
    int pixels = 0;
    int cut = 0;
};

Difference differenceOf(const Image& a, const Image& b) {
    Difference difference;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * width + x;
            if (a.pixels[at] == b.pixels[at]) continue;
            ++difference.pixels;
            difference.cut += x == 0 || y == 0 || x + 1 == width || y + 1 == height;
        }
    return difference;
}

}  // namespace

class LessonsTest : public QObject {
    Q_OBJECT

    QStringList pages_;

  private slots:
    void initTestCase() {
        const QDir folder(QStringLiteral(ISOSCOPE_SOURCE_DIR "/docs/help/lessons"));
        for (const QString& name : folder.entryList({"*.md"}, QDir::Files, QDir::Name))
            pages_ << folder.filePath(name);
    }

    void twelveLessonsAreShort() {
        QCOMPARE(pages_.size(), 12);
        static const QRegularExpression scenes("```.*?```", QRegularExpression::DotMatchesEverythingOption);
        for (const QString& page : pages_) {
            const auto words = pageText(page).remove(scenes).simplified().count(' ') + 1;
            QVERIFY2(words >= 150 && words <= 350, qPrintable(QString("%1: %2").arg(page).arg(words)));
        }
    }

    void everySceneOfALessonRuns_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("word");
        static const QRegularExpression scene(
            "^```pov *([^\n]*)\n(.*?)^```$",
            QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
        for (const QString& page : pages_) {
            int count = 0;
            for (auto found = scene.globalMatch(pageText(page)); found.hasNext();) {
                const auto match = found.next();
                QTest::addRow("%s %d", qPrintable(QFileInfo(page).baseName()), ++count)
                    << match.captured(2) << match.captured(1);
            }
            QVERIFY2(count > 0, qPrintable(page));
        }
    }
    void everySceneOfALessonRuns() {
        QFETCH(QString, text);
        QFETCH(QString, word);
        ParseOptions options;
        options.imageWidth = width;
        options.imageHeight = height;
        const ParseResult parsed = readScene(text.toStdString(), options);
        QVERIFY2(parsed.diagnostics.empty(), problems(parsed).c_str());
        QVERIFY(!parsed.scene->isosurfaces.empty());
        RenderRequest request = requestFor(parsed, width, height);
        request.rootFinder = RootFinder::certified;
        RenderRequest nothing = request;
        auto empty = std::make_shared<Scene>(*request.scene);
        empty->objects.clear();
        nothing.scene = empty;
        const Image exact = renderImage(request);
        const Difference seen = differenceOf(exact, renderImage(nothing));
        request.rootFinder = RootFinder::lipschitz;
        const double changed = 1 - comparePictures(renderImage(request), exact).shareWithin8;
        const auto wrong = static_cast<int>(holeMap(request).mistakes());
        const double share = static_cast<double>(seen.pixels) / (width * height);
        qInfo("%.1f %% of the picture, %d at its edge; POV-Ray changes %.1f %% and gets %d pixels wrong",
              100 * share, seen.cut, 100 * changed, wrong);
        QVERIFY(share > 0.1);
        QCOMPARE(seen.cut, 0);
        // A lesson about what POV-Ray makes of a scene must show it; at jumps it loses parts of faces, and
        // anywhere what is thinner than the accuracy.
        if (word == QLatin1String("as-povray")) {
            QVERIFY(changed > 0.02);
        } else if (word == QLatin1String("jumps")) {
            QVERIFY(wrong > 50);
        } else {
            QVERIFY2(word.isEmpty(), qPrintable(word));
            QVERIFY(wrong <= 30);
        }
    }
};

QTEST_APPLESS_MAIN(LessonsTest)
#include "lessons_test.moc"
