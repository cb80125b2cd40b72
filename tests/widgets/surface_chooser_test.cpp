// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/surface_chooser.h"

#include <QTest>

#include "core/scene/scene.h"

using namespace isoscope;

namespace {

Scene sceneOf(std::size_t isosurfaces) {
    Scene scene;
    scene.isosurfaces.resize(isosurfaces);
    return scene;
}

}  // namespace

class SurfaceChooserTest : public QObject {
    Q_OBJECT

  private slots:
    void hidesWhileThereIsNoChoice() {
        SurfaceChooser chooser("which");
        QVERIFY(chooser.isHidden());
        const Scene one = sceneOf(1), two = sceneOf(2);
        chooser.setScene(&one);
        QVERIFY(chooser.isHidden());
        chooser.setScene(&two);
        QVERIFY(!chooser.isHidden());
        QCOMPARE(chooser.count(), 2);
        chooser.setScene(nullptr);
        QVERIFY(chooser.isHidden());
    }

    void keepsWhatWasChosen() {
        SurfaceChooser chooser("which", "The first");
        const Scene three = sceneOf(3), four = sceneOf(4), two = sceneOf(2);
        chooser.setScene(&three);
        QCOMPARE(chooser.count(), 4);
        QCOMPARE(chooser.currentText(), QString("The first"));
        chooser.setCurrentIndex(3);
        chooser.setScene(&four);
        QCOMPARE(chooser.currentText(), QString("Isosurface 3"));
        chooser.setScene(&two);
        QCOMPARE(chooser.currentText(), QString("Isosurface 2"));
    }
};

QTEST_MAIN(SurfaceChooserTest)
#include "surface_chooser_test.moc"
