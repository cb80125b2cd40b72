// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "core/language/parse.h"
#include "widgets/timing.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

using namespace isoscope;

namespace {

std::shared_ptr<const Scene> sphere(const char* extra = "") {
    return parseScene(
               std::string("camera { location <0, 0, -4> look_at 0 } light_source { <5, 5, -5> rgb 1 }\n"
                           "background { rgb <0, 0, 1> }\n"
                           "sphere { 0, 1 pigment { rgb <1, 0, 0> } finish { ambient 1 diffuse 0 } }\n") +
               extra)
        .scene;
}

}  // namespace

class ViewportTest : public QObject {
    Q_OBJECT

  private slots:
    void fittedCameraKeepsWhatTheCameraShows() {
        const Camera camera;  // 4:3
        const Camera wide = fittedCamera(camera, 1600, 800), tall = fittedCamera(camera, 300, 600);
        QCOMPARE(glm::length(wide.up), glm::length(camera.up));
        QCOMPARE(glm::length(wide.right) / glm::length(wide.up), 2.0);
        QCOMPARE(glm::length(tall.right), glm::length(camera.right));
        QCOMPARE(glm::length(tall.right) / glm::length(tall.up), 0.5);
        Camera flat;
        flat.up = glm::dvec3(0);
        QCOMPARE(fittedCamera(flat, 100, 100).right, flat.right);
        QCOMPARE(fittedCamera(camera, 100, 0).up, camera.up);
    }

    void paintsTheSceneInItsColours() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        QSignalSpy finished(&viewport, &Viewport::pictureFinished);
        viewport.setScene(sphere());
        QTRY_VERIFY(!finished.isEmpty());
        const QImage window = viewport.grab().toImage();
        QCOMPARE(window.pixelColor(160, 120), QColor(255, 0, 0));
        QCOMPARE(window.pixelColor(5, 235), QColor(0, 0, 255));
        QCOMPARE(viewport.picture().size(), QSize(320, 240));
    }

    void pictureStaysWhileTheNextIsMade() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished() && !viewport.picture().isNull());
        viewport.setScene(sphere("background { rgb <0, 1, 0> }"));
        QVERIFY(!viewport.finished());
        QCOMPARE(viewport.grab().toImage().pixelColor(160, 120), QColor(255, 0, 0));
        QTRY_VERIFY(viewport.finished());
        QCOMPARE(viewport.grab().toImage().pixelColor(5, 235), QColor(0, 255, 0));
    }

    void aQuickPictureComesInOnePass() {
        Viewport viewport;
        viewport.resize(160, 120);
        viewport.show();
        // Of the first picture: another may follow, with soft edges or of another size, before anybody looks.
        int firstPasses = 0;
        connect(&viewport, &Viewport::pictureFinished, this, [&] {
            if (firstPasses == 0) firstPasses = viewport.progress().passCount;
        });
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished() && !viewport.picture().isNull());
        QCOMPARE(firstPasses, 3);
        // A busy machine may make it slow for once.
        const auto isQuick = [&] {
            viewport.restart();
            return QTest::qWaitFor([&] { return viewport.finished(); }) && viewport.progress().passCount == 1;
        };
        QTRY_VERIFY(isQuick());
        QCOMPARE(viewport.picture().pixelColor(80, 60), QColor(255, 0, 0));
    }

    void everyFastChangeEndsWithTheLastScene() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        for (int i = 0; i < 40; ++i) {
            viewport.setScene(
                sphere(i % 2 ? "background { rgb <0, 1, 0> }" : "background { rgb <1, 1, 0> }"));
            QTest::qWait(3);
        }
        QTRY_VERIFY(viewport.finished());
        QCOMPARE(viewport.picture().pixelColor(5, 235), QColor(0, 255, 0));
    }

    void aSceneThatLooksTheSameDoesNotInterruptThePicture() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(sphere("background { rgb 0 }"));
        QTRY_VERIFY(viewport.finished());
        QSignalSpy finished(&viewport, &Viewport::pictureFinished);
        viewport.setScene(sphere());
        const std::uint64_t job = viewport.progress().job;
        viewport.setScene(sphere(), true);
        QCOMPARE(viewport.progress().job, job);
        // It is drawn again afterwards, from the text as it is.
        QTRY_COMPARE(finished.size(), 2);
        QCOMPARE(viewport.progress().job, job + 1);
        QVERIFY(viewport.finished());
    }

    void viewIsKeptUntilTheTextsCameraChanges() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished());
        QTest::keyClick(&viewport, Qt::Key_Left);
        const Camera turned = viewport.camera();
        viewport.setScene(sphere("background { rgb 0 }"));
        QVERIFY(viewport.camera() == turned);
        viewport.setScene(sphere("camera { location <0, 0, -9> look_at 0 }"));
        QCOMPARE(viewport.camera().location, glm::dvec3(0, 0, -9));
        QVERIFY(!viewport.viewMoved());
    }

    void noticeDimsAnOlderPicture() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished());
        viewport.setNotice(QStringLiteral("Errors"));
        QCOMPARE(viewport.grab().toImage().pixelColor(160, 120), QColor(255, 0, 0));
        viewport.setNotice(QStringLiteral("Errors"), Viewport::Dimmed::yes);
        const QColor dimmed = viewport.grab().toImage().pixelColor(160, 120);
        QVERIFY(dimmed.red() > 150 && dimmed.red() < 230);
        viewport.setNotice({});
        QCOMPARE(viewport.grab().toImage().pixelColor(160, 120), QColor(255, 0, 0));
    }

    /// The message on mistakes lay over the scale of the gradient.
    void aNoticeStandsAboveTheLegend() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished());
        viewport.setVerdictsShown(true);
        QTRY_VERIFY(viewport.picture().size() == QSize(320, 240));
        const QImage before = viewport.grab().toImage();
        viewport.setNotice(QStringLiteral("Errors"));
        const QImage after = viewport.grab().toImage();
        const QRect legend(0, 205, 320, 35);
        QVERIFY(before != after);
        QCOMPARE(after.copy(legend), before.copy(legend));
    }

    void sceneWithoutObjectsSaysSo() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(parseScene("background { rgb 0 }").scene);
        QTRY_VERIFY(viewport.finished());
        const QImage window = viewport.grab().toImage();
        int lit = 0;
        for (int x = 0; x < 320; ++x)
            for (int y = 90; y < 150; ++y) lit += qGray(window.pixel(x, y)) > 60;
        QVERIFY(lit > 50);
    }

    void pixelRatioGivesDevicePixels() {
        // QT_SCALE_FACTOR is 1 in tests; the panel's own figures must still agree.
        Viewport viewport;
        viewport.resize(321, 243);
        viewport.show();
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished());
        QCOMPARE(viewport.picture().size(),
                 (QSizeF(viewport.size()) * viewport.devicePixelRatioF()).toSize());
    }

    /// A mark that comes and goes with every quick picture would only flicker. Of a new document, whose first
    /// picture takes long, there was none once.
    void theBusyMarkIsThatOfLongWorkAlone() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        const auto painted = [&] {
            const QRgb mark = viewport.palette().color(QPalette::Highlight).rgb();
            const QImage corner = viewport.grab({viewport.width() - 30, 8, 24, 24}).toImage();
            for (int y = 0; y < corner.height(); ++y)
                for (int x = 0; x < corner.width(); ++x)
                    if (corner.pixel(x, y) == mark) return true;
            return false;
        };
        // Begun before the work, so that it is never behind the viewport's own clock.
        QElapsedTimer since;
        for (int i = 0; i < 5; ++i) {
            since.start();
            viewport.setScene(sphere());
            const bool mark = viewport.busyMarkShown() || painted();
            QVERIFY(!mark || since.elapsed() > timing::busyMarkDelay);
            QTRY_VERIFY(viewport.finished());
            QVERIFY(!viewport.busyMarkShown() && !painted());
        }
        viewport.clear();
        // 1600 rays of shadow a pixel.
        const auto slow = sphere(
            "light_source { 9 rgb 1 area_light 4*x, 4*y, 40, 40 } plane { y, -1 pigment { rgb 1 } }\n");
        since.start();
        viewport.setScene(slow);
        const bool mark = viewport.busyMarkShown() || painted();
        QVERIFY(!mark || since.elapsed() > timing::busyMarkDelay);
        QTRY_VERIFY(viewport.busyMarkShown());
        QVERIFY(painted() && !viewport.finished());
        viewport.stop();
        QTRY_VERIFY(viewport.finished());
        QVERIFY(!viewport.busyMarkShown() && !painted());
    }

    void statusLineTellsTheCost() {
        ViewportPanel panel;
        panel.resize(400, 320);
        panel.show();
        panel.viewport()->setScene(sphere());
        QTRY_VERIFY(panel.viewport()->finished());
        QVERIFY2(panel.status().startsWith(QStringLiteral("Finished in")), qPrintable(panel.status()));
        QVERIFY2(panel.status().contains(QStringLiteral("rays")), qPrintable(panel.status()));
        QCOMPARE(shortCount(999), QStringLiteral("999"));
        QCOMPARE(shortCount(1230), QStringLiteral("1.23 k"));
        QCOMPARE(shortCount(12'300'000), QStringLiteral("12.3 M"));
    }

    void clearForgetsEverything() {
        Viewport viewport;
        viewport.resize(320, 240);
        viewport.show();
        viewport.setScene(sphere());
        viewport.clear();
        QTest::qWait(60);
        QVERIFY(viewport.picture().isNull());
        viewport.setScene(sphere());
        QTRY_VERIFY(viewport.finished() && !viewport.picture().isNull());
    }

    void endsInTheMiddleOfAPicture() {
        for (int i = 0; i < 5; ++i) {
            Viewport viewport;
            viewport.resize(640, 480);
            viewport.show();
            viewport.setScene(sphere());
            QTest::qWait(i * 5);
        }
    }
};

QTEST_MAIN(ViewportTest)
#include "viewport_test.moc"
