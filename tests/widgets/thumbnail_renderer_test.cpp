// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/thumbnail_renderer.h"

#include <QDir>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "widgets/functions/function_snippet.h"

using namespace isoscope;

namespace {

std::string sceneOf(std::string_view name) { return thumbnailScene(*findBuiltin(name)); }

}  // namespace

class ThumbnailRendererTest : public QObject {
    Q_OBJECT

  private slots:
    void rendersOnceAndKeepsThePicture() {
        const QTemporaryDir folder;
        const std::string torus = sceneOf("f_torus");
        {
            ThumbnailRenderer renderer(48, folder.path());
            QSignalSpy ready(&renderer, &ThumbnailRenderer::ready);
            QVERIFY(renderer.thumbnail(0, torus).isNull());
            QVERIFY(renderer.thumbnail(0, torus).isNull());  // asked for twice, rendered once
            QVERIFY(ready.wait(20000));
            const QImage image = ready[0][1].value<QImage>();
            QCOMPARE(image.size(), QSize(48, 48));
            QSet<QRgb> colors;
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x) colors << image.pixel(x, y);
            QVERIFY2(colors.size() > 50, qPrintable(QString("%1 colours").arg(colors.size())));
            QVERIFY(!ready.wait(300));
        }
        QCOMPARE(QDir(folder.path()).entryList({"*.png"}).size(), 1);
        ThumbnailRenderer again(48, folder.path());
        QCOMPARE(again.thumbnail(0, torus).size(), QSize(48, 48));
        QVERIFY(ThumbnailRenderer(64, folder.path()).thumbnail(0, torus).isNull());  // another size
    }

    void stopsAtOnce() {
        const QTemporaryDir folder;
        {
            ThumbnailRenderer renderer(512, folder.path());
            int index = 0;
            for (const Builtin& builtin : builtins()) renderer.thumbnail(index++, thumbnailScene(builtin));
        }
        // Hardly begun when it was told to stop, it kept few pictures of the many.
        const auto kept = QDir(folder.path()).entryList(QDir::Files).size();
        QVERIFY2(kept * 2 < static_cast<qsizetype>(builtins().size()), qPrintable(QString::number(kept)));
    }

    /// Texts of the gallery were read with leave to read any file.
    void foreignFilesAreNotRead() {
        const QTemporaryDir folder, foreign;
        QFile file(foreign.filePath("ball.inc"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("sphere { 0, 1 pigment { rgb 1 } }\n") > 0);
        file.close();
        ThumbnailRenderer renderer(16, folder.path());
        QSignalSpy ready(&renderer, &ThumbnailRenderer::ready);
        renderer.thumbnail(0,
                           "#include \"" + file.fileName().toStdString() + "\"\ncamera { location -5*z }\n");
        QVERIFY(ready.wait(20000));
        QVERIFY(ready[0][1].value<QImage>().isNull());
    }

    void aFolderThatCannotBeWrittenCostsTimeOnly() {
        ThumbnailRenderer renderer(16, "/proc/no/such/folder");
        QSignalSpy ready(&renderer, &ThumbnailRenderer::ready);
        renderer.thumbnail(0, sceneOf("f_sphere"));
        QVERIFY(ready.wait(20000));
        QCOMPARE(ready[0][1].value<QImage>().size(), QSize(16, 16));
    }
};

QTEST_GUILESS_MAIN(ThumbnailRendererTest)
#include "thumbnail_renderer_test.moc"
