// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/sheet_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_box.h"
#include "widgets/studies/sheet_view.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString torus = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\n#declare Large = 0.8;\n#declare Small = 0.2;\n"
    "camera { location <0, 2, -4> look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\nisosurface {\n"
    "  function { f_torus(x, y, z, Large, Small) }\n  contained_by { box { -1.5, 1.5 } }\n  max_gradient "
    "1.2\n"
    "  pigment { rgb 0.9 }\n}\n");

void choose(QComboBox* numbers, const QString& name) {
    const int index = numbers->findText(name);
    QVERIFY(index >= 0);
    numbers->setCurrentIndex(index);
    emit numbers->activated(index);
}

SheetPanel* open(WindowDriver& d) {
    d->resize(1280, 800);
    d->editor()->setSceneText(torus);
    d->docks()->bringUp(d->docks()->find("sheet"));
    if (!d.rests(60000)) return nullptr;
    auto* panel = d->study<SheetPanel>();
    if (panel->drawing() || panel->drawn() > 0) return nullptr;
    choose(panel->numbers(0), QStringLiteral("Large"));
    choose(panel->numbers(1), QStringLiteral("Small"));
    const double ends[2][2] = {{0.5, 1.1}, {0.1, 0.4}};
    for (const int which : {0, 1}) {
        panel->from(which)->setValue(ends[which][0]);
        panel->to(which)->setValue(ends[which][1]);
    }
    panel->steps(0)->setValue(3);
    panel->steps(1)->setValue(2);
    return panel;
}

}  // namespace

/// Small pictures for values of two numbers, in the real window.
class SheetPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickSetsBothValuesAsOneStep() {
        WindowDriver d;
        SheetPanel* panel = open(d);
        QVERIFY(panel);
        QTest::mouseClick(panel->startButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!panel->drawing() && panel->drawn() == 6, 60000);
        const QPoint first = panel->middleOf(0, 0), last = panel->middleOf(2, 1);
        QVERIFY(panel->image().rect().contains(last));
        // Tori of different size: the rows and columns show different pictures.
        QVERIFY(panel->image().copy(QRect(first - QPoint(40, 30), QSize(80, 60))) !=
                panel->image().copy(QRect(last - QPoint(40, 30), QSize(80, 60))));
        QTest::mouseClick(panel->view(), Qt::LeftButton, {}, panel->view()->placeOf(last));
        QTRY_COMPARE(d.numberBehind(QStringLiteral("Large = ")), 1.1);
        QCOMPARE(d.numberBehind(QStringLiteral("Small = ")), 0.4);
        QVERIFY(d.rests(60000));
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d->editor()->sceneText(), torus);
        // The sheet stays.
        QCOMPARE(panel->drawn(), 6);
    }

    void theSheetIsSavedAsItIsSeen() {
        WindowDriver d;
        SheetPanel* panel = open(d);
        QVERIFY(panel);
        QVERIFY(!panel->saveButton()->isEnabled());
        panel->draw();
        QTRY_VERIFY_WITH_TIMEOUT(!panel->drawing() && panel->drawn() == 6, 60000);
        QVERIFY(panel->saveButton()->isEnabled());
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("sheet.png"));
        QVERIFY(panel->saveTo(path));
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32),
                 panel->image().convertToFormat(QImage::Format_RGB32));
        QVERIFY(!panel->saveTo(folder.filePath(QStringLiteral("no/such/folder.png"))));
    }

    void stopKeepsWhatIsDrawn() {
        WindowDriver d;
        SheetPanel* panel = open(d);
        QVERIFY(panel);
        panel->steps(0)->setValue(20);
        panel->steps(1)->setValue(20);
        panel->draw();
        QTRY_VERIFY_WITH_TIMEOUT(panel->drawn() > 0, 60000);
        QTest::mouseClick(panel->startButton(), Qt::LeftButton);
        QVERIFY(!panel->drawing());
        const int drawn = panel->drawn();
        QVERIFY(drawn < 400);
        QVERIFY(panel->saveButton()->isEnabled());
        // What is not drawn sets nothing.
        emit panel->view()->clicked(panel->middleOf(19, 19));
        QCOMPARE(d->editor()->sceneText(), torus);
        QCOMPARE(panel->drawn(), drawn);
    }
};

QTEST_MAIN(SheetPanelTest)
#include "sheet_panel_test.moc"
