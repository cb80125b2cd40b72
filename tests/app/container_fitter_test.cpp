// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QStatusBar>
#include <QtTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

/// Edit, Fit Container in the real window.
class ContainerFitterTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    QString text() const { return driver_->window().editor()->sceneText(); }
    QString said() const { return driver_->window().statusBar()->currentMessage(); }
    bool fit() const {
        driver_->window().actions()->fitContainer->trigger();
        return driver_->rests();
    }

  private slots:
    void init() { driver_ = std::make_unique<WindowDriver>(); }
    void cleanup() { driver_.reset(); }

    void theIsosurfaceAtTheCaretGetsIt() {
        const QByteArray scene =
            "isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -4, 4 } } pigment { rgb 1 } "
            "}\n"
            "isosurface { function { x*x + y*y + z*z - 0.04 } contained_by { box { -5, 5 } } translate 2*x "
            "}\n"
            "camera { location <0, 0, -8> look_at 0 } light_source { <5, 9, -5> 1 }\n";
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
        driver_->typeBehind(QStringLiteral("0.04 }"), QStringLiteral(" "));
        QVERIFY(driver_->rests());
        const QString before = text();
        const QImage picture = driver_->picture();
        QVERIFY(fit());
        QVERIFY2(text().contains(QStringLiteral("contained_by { box { -4, 4 } }")), qPrintable(text()));
        QVERIFY(!text().contains(QStringLiteral("box { -5, 5 }")));
        QVERIFY2(said().contains(QStringLiteral("POV-Ray takes about")), qPrintable(said()));
        QVERIFY(difference(picture, driver_->picture()) < 0.002);
        driver_->window().actions()->undo->trigger();
        QCOMPARE(text(), before);
    }

    void whatCannotBeFittedIsLeftAlone_data() {
        QTest::addColumn<QByteArray>("scene");
        QTest::addColumn<QString>("words");
        const QByteArray camera =
            "\ncamera { location <0, 0, -8> look_at 0 } light_source { <5, 9, -5> 1 }\n";
        QTest::newRow("no isosurface") << "sphere { 0, 1 pigment { rgb 1 } }" + camera << "no isosurface";
        QTest::newRow("nothing to be seen")
            << "isosurface { function { x*x + 1 } contained_by { box { -1, 1 } } pigment { rgb 1 } }" + camera
            << "Nothing of this isosurface";
        QTest::newRow("nothing smaller")
            << "isosurface { function { -1 } contained_by { box { -1, 1 } } pigment { rgb 1 } }" + camera
            << "less room";
    }
    void whatCannotBeFittedIsLeftAlone() {
        QFETCH(QByteArray, scene);
        QFETCH(QString, words);
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
        QVERIFY(fit());
        QCOMPARE(text().toUtf8(), scene);
        QVERIFY2(said().contains(words), qPrintable(said()));
    }
};

QTEST_MAIN(ContainerFitterTest)
#include "container_fitter_test.moc"
