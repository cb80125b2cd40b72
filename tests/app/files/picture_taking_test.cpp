// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QClipboard>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>

#include "app/desktop/files/export_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/main_window.h"
#include "tests/app/window_driver.h"
#include "widgets/pictures/picture_mime.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;

namespace {

const QByteArray sphereText =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -4> look_at 0 }\n"
    "light_source { <5, 5, -5> rgb 1 }\nisosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere "
    "{ 0, "
    "1.2 } } max_gradient 4 pigment { rgb <1, 0.5, 0> } }\n";

}  // namespace

/// The picture leaves the window by the clipboard and by the mouse.
class PictureTakingTest : public QObject {
    Q_OBJECT

  private slots:
    void theClipboardGetsThePictureAsItIsShown() {
        const test::WindowDriver window;
        QVERIFY(window.openText(sphereText));
        QVERIFY(window.rests());
        Viewport* viewport = window->viewport();
        QGuiApplication::clipboard()->clear();
        window->actions()->copyPicture->trigger();
        const QMimeData* data = QGuiApplication::clipboard()->mimeData();
        QVERIFY(data->hasImage() && data->hasFormat(QStringLiteral("image/png")));
        const QImage plain = QGuiApplication::clipboard()->image();
        QCOMPARE(plain.size(), viewport->picture().size());
        QCOMPARE(plain.pixel(plain.rect().center()), viewport->picture().pixel(plain.rect().center()));
        // What lies over it goes along.
        window->actions()->showAxes->trigger();
        window->actions()->copyPicture->trigger();
        QVERIFY(QGuiApplication::clipboard()->image() != plain);
        // And the window's own picture stays what it was.
        QCOMPARE(viewport->picture().pixel(plain.rect().center()), plain.pixel(plain.rect().center()));
    }

    void ctrlAndTheMouseTakeThePicture() {
        const test::WindowDriver window;
        QVERIFY(window.openText(sphereText));
        QVERIFY(window.rests());
        Viewport* viewport = window->viewport();
        // The drag itself belongs to the system.
        disconnect(viewport, &Viewport::pictureTaken, window->exports(), nullptr);
        QSignalSpy taken(viewport, &Viewport::pictureTaken), turned(viewport, &Viewport::viewChanged);
        const QPoint from = viewport->rect().center();
        const auto drag = [&](Qt::KeyboardModifiers keys) {
            QTest::mousePress(viewport, Qt::LeftButton, keys, from);
            for (int step = 1; step <= 6; ++step) {
                QMouseEvent move(QEvent::MouseMove, from + QPoint(8 * step, 0),
                                 viewport->mapToGlobal(from + QPoint(8 * step, 0)), Qt::NoButton,
                                 Qt::LeftButton, keys);
                QCoreApplication::sendEvent(viewport, &move);
            }
            QTest::mouseRelease(viewport, Qt::LeftButton, keys, from + QPoint(48, 0));
        };
        drag(Qt::ControlModifier);
        QCOMPARE(taken.size(), 1);
        QCOMPARE(turned.size(), 0);
        drag(Qt::NoModifier);
        QCOMPARE(taken.size(), 1);
        QVERIFY(turned.size() > 0);
    }

    void whatIsDroppedIsAnImageAndAFile() {
        QImage picture(30, 20, QImage::Format_RGB32);
        picture.fill(QColor(10, 200, 30));
        const auto data = pictureFileMimeData(picture, QStringLiteral("torus"));
        QCOMPARE(data->urls().size(), 1);
        const QString file = data->urls().first().toLocalFile();
        QVERIFY(file.endsWith(QStringLiteral("/torus.png")));
        QCOMPARE(QImage(file).pixelColor(5, 5), QColor(10, 200, 30));
        QCOMPARE(QImage::fromData(data->data(QStringLiteral("image/png"))).size(), picture.size());
        QCOMPARE(qvariant_cast<QImage>(data->imageData()).pixelColor(0, 0), QColor(10, 200, 30));
    }
};

QTEST_MAIN(PictureTakingTest)
#include "picture_taking_test.moc"
