// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "tests/support/povray.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;

namespace {

/// Its max_gradient is too low: POV-Ray sees the far side through the near one.
const QByteArray ball =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <2.2, 1.6, -2.9> look_at 0 angle "
    "45 }\n"
    "light_source { <4, 6, -5> rgb 0.9 }\nisosurface { function { x*x + y*y + z*z - 1 } contained_by { "
    "sphere { 0, "
    "1.2 } } max_gradient 1.1 pigment { rgb <0.85, 0.3, 0.25> } }\n";

}  // namespace

/// POV-Ray's own picture in the window.
class PovrayOverlayTest : public QObject {
    Q_OBJECT

    QByteArray path_;

  private slots:
    void initTestCase() { path_ = qgetenv("PATH"); }
    void cleanup() { qputenv("PATH", path_); }

    void differencesAreMarkedByCause() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const test::WindowDriver window;
        QVERIFY(window.openText(ball));
        QVERIFY(window.rests());
        window->actions()->overlayPovrayDifference->trigger();
        const ViewOverlay& overlay = window->viewport()->overlay();
        QTRY_VERIFY_WITH_TIMEOUT(overlay.ready(), 60000);
        QVERIFY(overlay.povray().count(DifferenceCause::wrongSheet) > 1000);
        QVERIFY2(overlay.summary().contains(QStringLiteral("differs in")), qPrintable(overlay.summary()));
        const QColor sheet = QColor::fromRgba(differenceColor(DifferenceCause::wrongSheet));
        QVERIFY(test::countNear(window->viewport()->grab().toImage(), sheet, 4) > 1000);
        // The divider has POV-Ray's picture at its left, and can be moved.
        window->actions()->overlayPovray->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(overlay.ready(), 60000);
        QVERIFY(window->viewport()->overlay().hasDivider());
        const QImage half = window->viewport()->grab().toImage();
        window->viewport()->overlay().setDivider(0.98);
        const QImage most = window->viewport()->grab().toImage();
        QVERIFY(test::difference(half, most) > 0.01);
        window->actions()->overlayNone->trigger();
    }

    void withoutPovrayItIsSaid() {
        const test::WindowDriver window;
        QVERIFY(window.openText(ball));
        QVERIFY(window.rests());
        qputenv("PATH", "/nowhere");
        window->actions()->overlayPovray->trigger();
        const ViewOverlay& overlay = window->viewport()->overlay();
        QTRY_VERIFY_WITH_TIMEOUT(!overlay.busy(), 20000);
        QVERIFY2(overlay.summary().contains(QStringLiteral("not installed")), qPrintable(overlay.summary()));
        QVERIFY(!overlay.ready());
        window->actions()->overlayNone->trigger();
        QVERIFY(overlay.ready());
    }

    void aLongPictureIsStopped() {
        const QTemporaryDir folder;
        QFile program(folder.filePath("povray"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write("#!/bin/sh\nprintf 'Rendered 1 of 4 pixels (25%%)\\r' >&2\nsleep 60\n");
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        const test::WindowDriver window;
        QVERIFY(window.openText(ball));
        QVERIFY(window.rests());
        qputenv("PATH", folder.path().toLocal8Bit() + ':' + path_);
        window->actions()->overlayPovray->trigger();
        ViewOverlay& overlay = window->viewport()->overlay();
        QVERIFY(overlay.busy());
        QTRY_VERIFY_WITH_TIMEOUT(overlay.share() > 0.1, 20000);
        overlay.stop();
        QVERIFY(!overlay.busy() && !overlay.ready());
        // The picture of the window goes on as ever.
        window->actions()->redraw->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(window->viewport()->finished(), 20000);
        window->actions()->overlayNone->trigger();
        QVERIFY(window.rests());
    }
};

QTEST_MAIN(PovrayOverlayTest)
#include "povray_overlay_test.moc"
