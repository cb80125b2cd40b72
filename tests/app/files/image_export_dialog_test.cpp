// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPointer>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"
#include "widgets/pictures/image_export_dialog.h"
#include "widgets/pictures/picture_forecast.h"

using namespace isoscope;

namespace {

std::shared_ptr<const Scene> redSphere(int repeats = 1) {
    std::string text =
        "#include \"functions.inc\"\ncamera { location <0, 0, -4> look_at 0 } light_source { <5, 5, -5> rgb "
        "1 }\n"
        "background { rgb <0, 0, 1> }\n"
        "isosurface { function { sqrt(x*x + y*y + z*z) - 1";
    for (int i = 1; i < repeats; ++i) text += " + 0*f_noise3d(x*" + std::to_string(i) + ", y, z)";
    text +=
        " } contained_by { sphere { 0, 1.2 } } pigment { rgb <1, 0, 0> } finish { ambient 1 diffuse 0 } }\n";
    return parseScene(text).scene;
}

}  // namespace

/// What may be replaced: a picture, by its first bytes.
const QByteArray keptPicture("\x89PNG\r\n\x1a\nkept");

class ImageExportDialogTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

    static QPointer<ImageExportDialog> open(const std::shared_ptr<const Scene>& scene, const QString& file,
                                            QSize size) {
        auto* dialog = new ImageExportDialog(scene, scene->camera, file);
        dialog->setPictureSize(size);
        dialog->show();
        return dialog;
    }

  private slots:
    void theTimeIsToldBeforehand() {
        const auto dialog = open(redSphere(), path("forecast.png"), {1600, 1200});
        const PictureForecast* forecast = dialog->forecast();
        QTRY_VERIFY_WITH_TIMEOUT(forecast->upToDate() && forecast->own().complete, 30000);
        QCOMPARE(forecast->own().squares, std::size_t(50 * 38));
        QVERIFY(forecast->own().cpuSeconds > 0 && forecast->povray() && *forecast->povray() > 0);
        const auto said = [&] {
            for (const QLabel* label : dialog->findChildren<QLabel*>())
                if (label->text().startsWith(QStringLiteral("Here about "))) return label->text();
            return QString();
        };
        QVERIFY2(said().contains(QStringLiteral("POV-Ray without smooth edges about ")), qPrintable(said()));
        // Another size: it is found anew.
        dialog->setPictureSize({320, 240});
        QVERIFY(!forecast->upToDate() && said().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(forecast->upToDate(), 30000);
        QCOMPARE(forecast->own().squares, std::size_t(10 * 8));
        // The picture itself is not waited with.
        dialog->setPictureSize({330, 240});
        dialog->start();
        QVERIFY(forecast->upToDate());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog->running(), 20000);
        dialog->close();
    }

    void writesThePictureAtTheSizeAskedFor() {
        const auto dialog = open(redSphere(), path("sphere.png"), {200, 150});
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        dialog->start();
        QVERIFY(dialog->running());
        QVERIFY(finished.wait(20000));
        QCOMPARE(finished[0][1].toString(), QString());
        QVERIFY(!dialog->running());
        const QImage written(path("sphere.png"));
        QCOMPARE(written.size(), QSize(200, 150));
        QCOMPARE(written.pixelColor(100, 75), QColor(255, 0, 0));
        QCOMPARE(written.pixelColor(3, 3), QColor(0, 0, 255));
        dialog->close();
    }

    void stoppedExportLeavesTheOldFileAlone() {
        QFile old(path("old.png"));
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write(keptPicture);
        old.close();
        const auto dialog = open(redSphere(40), path("old.png"), {2400, 1800});
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        dialog->start();
        dialog->start();  // yes, replace it
        QTest::qWait(30);
        dialog->stop();
        QCOMPARE(finished.size(), 1);
        QVERIFY(!finished[0][1].toString().isEmpty());
        QVERIFY(!dialog->running());
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), keptPicture);
        dialog->close();
    }

    /// D29: Enter replaced an existing file.
    void anExistingFileIsReplacedOnlyAfterAQuestion() {
        QFile old(path("question.png"));
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write(keptPicture);
        old.close();
        const auto dialog = open(redSphere(), path("question.png"), {40, 30});
        QTest::keyClick(dialog, Qt::Key_Return);
        QTest::keyClick(dialog, Qt::Key_Return);
        QVERIFY(!dialog->running());
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), keptPicture);
        // Another name is another question.
        dialog->setFile(path("other.png"));
        dialog->setFile(path("question.png"));
        dialog->start();
        QVERIFY(!dialog->running());
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        dialog->start();
        QVERIFY(finished.wait(20000));
        QCOMPARE(QImage(path("question.png")).size(), QSize(40, 30));
        dialog->close();
    }

    /// D29: width and height follow each other.
    void proportionsAreKept() {
        const auto dialog = open(redSphere(), path("sphere.png"), {400, 300});
        const QList<QSpinBox*> sides = dialog->findChildren<QSpinBox*>();
        QCOMPARE(sides.size(), 2);
        sides[0]->setValue(800);
        QCOMPARE(dialog->pictureSize(), QSize(800, 600));
        sides[1]->setValue(150);
        QCOMPARE(dialog->pictureSize(), QSize(200, 150));
        dialog->findChild<QCheckBox*>()->setChecked(false);
        sides[0]->setValue(777);
        QCOMPARE(dialog->pictureSize(), QSize(777, 150));
        dialog->close();
    }

    void fileThatCannotBeWrittenIsReported() {
        const auto dialog = open(redSphere(), path("no/such/folder/a.png"), {40, 30});
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        dialog->start();
        QVERIFY(finished.wait(20000));
        QVERIFY(finished[0][1].toString().contains(QStringLiteral("a.png")));
        QVERIFY(!QFile::exists(path("no/such/folder/a.png")));
        dialog->close();
    }

    /// It would not fit into memory; it is drawn in strips.
    void hugePicturesBeginAndStop() {
        const auto dialog = open(redSphere(), path("huge.png"), {65536, 65536});
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        dialog->start();
        QVERIFY(dialog->running());
        QTest::qWait(100);
        dialog->stop();
        QVERIFY(!dialog->running());
        QCOMPARE(finished.size(), 1);
        dialog->close();
        QTRY_VERIFY(dialog.isNull());
        QVERIFY(!QFile::exists(path("huge.png")));
    }

    void theEndingChoosesTheFormat() {
        const auto dialog = open(redSphere(), path("sphere.png"), {60, 40});
        auto* depth = dialog->findChild<QComboBox*>();
        QVERIFY(depth->isVisible());
        depth->setCurrentIndex(1);
        QCOMPARE(dialog->options().bits, 16);
        dialog->setFile(path("layers.exr"));
        QVERIFY(!depth->isVisible());
        QVERIFY(dialog->options().format == PictureFormat::openExr);
        QSignalSpy finished(dialog, &ImageExportDialog::finished);
        dialog->start();
        QVERIFY(finished.wait(20000));
        QFile layers(path("layers.exr"));
        QVERIFY(layers.open(QIODevice::ReadOnly));
        QCOMPARE(layers.read(4), QByteArray("\x76\x2f\x31\x01"));
        dialog->setFile(path("deep.png"));
        QVERIFY(depth->isVisible());
        for (QCheckBox* box : dialog->findChildren<QCheckBox*>())
            if (box->text().contains(QStringLiteral("Transparent"))) box->setChecked(true);
        dialog->start();
        QVERIFY(finished.wait(20000));
        const QImage deep(path("deep.png"));
        QCOMPARE(deep.format(), QImage::Format_RGBA64);
        QCOMPARE(deep.pixelColor(1, 1).alpha(), 0);
        QCOMPARE(deep.pixelColor(30, 20), QColor(255, 0, 0));
        dialog->close();
    }

    void queuedPicturesGoOnWhenTheDialogCloses() {
        PictureQueue queue;
        const std::shared_ptr<const Scene> scene = redSphere();
        QPointer<ImageExportDialog> dialog =
            new ImageExportDialog(scene, scene->camera, path("first.png"), nullptr, &queue);
        dialog->setPictureSize({300, 200});
        dialog->show();
        dialog->enqueue();
        dialog->setFile(path("second.png"));
        dialog->setPictureSize({30, 20});
        dialog->enqueue();
        QVERIFY(!dialog->running());
        QCOMPARE(queue.open(), 2);
        dialog->close();
        QTRY_COMPARE_WITH_TIMEOUT(queue.open(), 0, 20000);
        QCOMPARE(QImage(path("first.png")).size(), QSize(300, 200));
        QCOMPARE(QImage(path("second.png")).size(), QSize(30, 20));
    }

    void emptyFileNameIsRefused() {
        const auto dialog = open(redSphere(), QString(), {40, 30});
        dialog->start();
        QVERIFY(!dialog->running());
        dialog->close();
    }

    void closingStopsAndWritesNothing() {
        const auto dialog = open(redSphere(40), path("closed.png"), {2400, 1800});
        dialog->start();
        dialog->close();
        QTRY_VERIFY(dialog.isNull());
        QVERIFY(!QFile::exists(path("closed.png")));
    }
};

QTEST_MAIN(ImageExportDialogTest)
#include "image_export_dialog_test.moc"
