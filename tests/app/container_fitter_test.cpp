// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>

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
    QPushButton* shownButton(const QString& words) const {
        for (auto* button : driver_->window().findChildren<QPushButton*>())
            if (button->isVisible() && button->text() == words) return button;
        return nullptr;
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

    /// There was no way to end a long one.
    void aSlowOneCanBeStopped() {
        // A ball takes as many boxes as there may be, and each of them four thousand terms; out of sight, for
        // its picture would take as long.
        QByteArray function = "x*x + y*y + z*z - 4";
        for (int i = 0; i < 4000; ++i)
            function += " + 0.00002*sin(" + QByteArray::number(9 + 0.001 * i) + "*x + " +
                        QByteArray::number(2 - 0.003 * i) + "*z)";
        const QByteArray scene = "isosurface { function { " + function +
                                 " } contained_by { box { -3, 3 } } max_gradient 9 pigment { rgb 1 } }\n"
                                 "camera { location <0, 9, -9> look_at <0, 30, -30> }\n"
                                 "light_source { <5, 9, -5> 1 }\n";
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests(60000));
        driver_->window().actions()->fitContainer->trigger();
        QPushButton* stop = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((stop = shownButton(QStringLiteral("&Stop"))), 20000);
        QTest::mouseClick(stop, Qt::LeftButton);
        QVERIFY(driver_->rests());
        QVERIFY2(said().startsWith(QStringLiteral("Stopped")), qPrintable(said()));
        QCOMPARE(text().toUtf8(), scene);
        QVERIFY(!shownButton(QStringLiteral("&Stop")));
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
