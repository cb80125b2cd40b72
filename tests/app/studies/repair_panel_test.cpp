// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/repair_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/include_viewer.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray ball = "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } ";
const QByteArray part =
    "// a part\r\n#macro Ball(P)\n  " + ball + "max_gradient 2*0.6 /* low */ translate P }\n#end\n";
const QByteArray text =
    "#version 3.7;\n#include \"part.inc\"\ncamera { location -6*z look_at 0 }\n"
    "Ball(0) Ball(2*x)\n" +
    ball + "}\n" + ball + "max_gradient 2.4 }\n" + ball + "max_gradient 40 }\n";

QByteArray contentOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString writeInto(const QTemporaryDir& folder, const QString& name, const QByteArray& content) {
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("not written");
    return file.fileName();
}

}  // namespace

/// "Repair a scene", in the real window.
class RepairPanelTest : public QObject {
    Q_OBJECT

    static RepairPanel* opened(WindowDriver& d, const QString& scene) {
        d->resize(1280, 800);
        if (!d->documents()->openFile(scene)) qFatal("not opened");
        d->docks()->bringUp(d->docks()->find("repair"));
        return d->study<RepairPanel>();
    }
    static QString cell(const RepairPanel* panel, int row, int column) {
        return panel->list()->topLevelItem(row)->text(column);
    }

  private slots:
    void whatIsTickedIsWrittenWhereItStands() {
        QTemporaryDir folder;
        const QString include = writeInto(folder, QStringLiteral("part.inc"), part);
        WindowDriver d;
        RepairPanel* panel = opened(d, writeInto(folder, QStringLiteral("s.pov"), text));
        QVERIFY(d.rests(60000));
        QTRY_COMPARE(panel->statements().size(), std::size_t(4));
        QTRY_VERIFY(!panel->stopButton()->isVisible());
        // One row for the macro's statement, which makes two.
        QCOMPARE(cell(panel, 0, 0), QStringLiteral("part.inc:3, 2 times"));
        QCOMPARE(cell(panel, 0, 1), QStringLiteral("1.2"));
        QCOMPARE(cell(panel, 0, 3), QStringLiteral("2.4"));
        QTRY_COMPARE(cell(panel, 0, 6), QStringLiteral("holes"));
        QVERIFY(panel->statements()[0].mistakes > 0);
        QCOMPARE(cell(panel, 1, 0), QStringLiteral("line 5"));
        QCOMPARE(cell(panel, 2, 3), QString());  // nothing to mend
        QCOMPARE(cell(panel, 3, 1), QStringLiteral("40"));
        QVERIFY2(cell(panel, 3, 5).endsWith(QStringLiteral("times as long")), qPrintable(cell(panel, 3, 5)));
        QVERIFY(panel->statements()[0].verdict == GradientVerdict::holes);
        QVERIFY(panel->statements()[2].verdict == GradientVerdict::right);
        QVERIFY(panel->statements()[3].verdict == GradientVerdict::wasteful);
        QVERIFY(panel->statements()[3].waste.value_or(0) > 2);
        QCOMPARE(panel->writeButton()->text(), QStringLiteral("Write 3 Values"));
        // All but the one that has no max_gradient.
        panel->list()->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
        QCOMPARE(panel->writeButton()->text(), QStringLiteral("Write 2 Values"));
        QTest::mouseClick(panel->writeButton(), Qt::LeftButton);
        const QByteArray mended = QByteArray(text).replace("max_gradient 40", "max_gradient 2.4");
        QCOMPARE(d->editor()->sceneText(), QString::fromUtf8(mended));
        QCOMPARE(contentOf(include), QByteArray(part).replace("max_gradient 2*0.6", "max_gradient 2.4"));
        QVERIFY(d.rests(60000));
        QTRY_VERIFY(panel->statements()[0].verdict == GradientVerdict::right);
        QTRY_VERIFY(panel->statements()[3].verdict == GradientVerdict::right);
        // What was not ticked is not ticked by itself.
        QTRY_COMPARE(panel->writeButton()->text(), QStringLiteral("Write"));
        QVERIFY(!panel->writeButton()->isEnabled());
        // Both can be taken back.
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d->editor()->sceneText(), QString::fromUtf8(text));
        QVERIFY(WindowDriver::press(d->notices(), QStringLiteral("Put Back")));
        QCOMPARE(contentOf(include), part);
        QVERIFY(d.rests(60000));
        QTRY_VERIFY(panel->statements()[0].verdict == GradientVerdict::holes);
    }

    void filesElsewhereAndChangedOnesStay() {
        QTemporaryDir folder, elsewhere;
        writeInto(folder, QStringLiteral("part.inc"), part);
        const QString far = writeInto(elsewhere, QStringLiteral("far.inc"), ball + "}\n");
        const QByteArray scene =
            QByteArray(text).replace("Ball(0)", "#include \"" + far.toUtf8() + "\" Ball(0)");
        WindowDriver d;
        d->session()->setLibraryPaths({elsewhere.path().toStdString()});
        RepairPanel* panel = opened(d, writeInto(folder, QStringLiteral("s.pov"), scene));
        QVERIFY(d.rests(60000));
        QTRY_COMPARE(panel->statements().size(), std::size_t(5));
        QTRY_VERIFY(!panel->stopButton()->isVisible());
        QTreeWidgetItem* row = panel->list()->topLevelItem(0);
        QCOMPARE(row->text(0), QStringLiteral("far.inc:1"));
        QVERIFY(!(row->flags() & Qt::ItemIsUserCheckable));
        QVERIFY2(row->toolTip(0).contains(QStringLiteral("another folder")), qPrintable(row->toolTip(0)));
        // Changed by another program meanwhile: it stays, and that is said.
        const QByteArray theirs = part + "// theirs\n";
        const QString include = writeInto(folder, QStringLiteral("part.inc"), theirs);
        QTest::mouseClick(panel->writeButton(), Qt::LeftButton);
        QCOMPARE(contentOf(include), theirs);
        QCOMPARE(contentOf(far), ball + "}\n");
        QVERIFY2(d->notices()->text().contains(QStringLiteral("part.inc is not changed")),
                 qPrintable(d->notices()->text()));
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("max_gradient 2.4 }\n")));
    }

    void theProofsAreStoppedAndGoOn() {
        QTemporaryDir folder;
        // Each takes long: octaves of noise whose bound is proven slowly.
        QByteArray many = "#version 3.7;\n";
        for (int i = 0; i < 6; ++i)
            many += "isosurface { function { x*x+y*y+z*z-1+0.3*f_noise3d(" + QByteArray::number(7 + i) +
                    "*x,9*y,8*z) } contained_by { sphere { 0, 1.6 } } max_gradient 9 }\n";
        many.prepend("#include \"functions.inc\"\n");
        WindowDriver d;
        RepairPanel* panel = opened(d, writeInto(folder, QStringLiteral("s.pov"), many));
        VerdictStudy* study = d->studies()->verdicts()->study();
        QTRY_VERIFY_WITH_TIMEOUT(study->busy() && !panel->statements().empty(), 20000);
        QTRY_VERIFY(panel->stopButton()->isVisible());
        QTest::mouseClick(panel->stopButton(), Qt::LeftButton);
        QVERIFY(!study->busy() && study->stopped());
        QCOMPARE(panel->stopButton()->text(), QStringLiteral("Go On"));
        // Turning the view does not begin it again; what is known stays.
        const std::size_t rows = panel->statements().size();
        d.dragViewport(d->viewport()->rect().center(), {40, 0});
        QTest::qWait(300);
        QVERIFY(study->stopped() && !study->busy());
        QCOMPARE(panel->statements().size(), rows);
        QTest::mouseClick(panel->stopButton(), Qt::LeftButton);
        QVERIFY(study->busy() && !study->stopped());
        QCOMPARE(panel->stopButton()->text(), QStringLiteral("Stop"));
        QTRY_VERIFY_WITH_TIMEOUT(!study->busy(), 60000);
    }

    /// A bug once: "may have…", in a window that is not wide.
    void noVerdictIsCut() {
        QTemporaryDir folder;
        writeInto(folder, QStringLiteral("part.inc"), part);
        WindowDriver d;
        const RepairPanel* panel = opened(d, writeInto(folder, QStringLiteral("s.pov"), text));
        d->resize(900, 600);
        QVERIFY(d.rests(60000));
        QTRY_COMPARE(panel->list()->topLevelItemCount(), 4);
        QTRY_VERIFY(!cell(panel, 3, 6).isEmpty());
        constexpr int verdict = 6;
        const QAbstractItemView* list = panel->list();
        QTRY_VERIFY(panel->list()->columnWidth(verdict) >= list->sizeHintForColumn(verdict));
    }

    void aRowLeadsToItsPlace() {
        QTemporaryDir folder;
        writeInto(folder, QStringLiteral("part.inc"), part);
        WindowDriver d;
        RepairPanel* panel = opened(d, writeInto(folder, QStringLiteral("s.pov"), text));
        QVERIFY(d.rests(60000));
        QTRY_COMPARE(panel->statements().size(), std::size_t(4));
        emit panel->list()->itemActivated(panel->list()->topLevelItem(3), 0);
        int line = 0, column = 0;
        d->editor()->getCursorPosition(&line, &column);
        QCOMPARE(line + 1, 7);
        emit panel->list()->itemActivated(panel->list()->topLevelItem(0), 0);
        QVERIFY(d->findChild<IncludeViewer*>()->isVisible());
        // A new document has none of it.
        WindowDriver::trigger(d->actions()->newFile);
        QTRY_COMPARE(panel->list()->topLevelItemCount(), 0);
        QVERIFY(!panel->writeButton()->isEnabled());
    }
};

QTEST_MAIN(RepairPanelTest)
#include "repair_panel_test.moc"
