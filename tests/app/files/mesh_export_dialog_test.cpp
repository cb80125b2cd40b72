// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mesh/mesh_export_dialog.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"

using namespace isoscope;

namespace {

std::shared_ptr<const Scene> sceneOf(const std::string& function) {
    return parseScene("#version 3.7; #include \"functions.inc\"\nisosurface { function { " + function +
                      " } contained_by { box { -2, 2 } } pigment { rgb x } }")
        .scene;
}

}  // namespace

class MeshExportDialogTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

    static QString said(const MeshExportDialog& dialog) {
        QString all;
        for (const QLabel* label : dialog.findChildren<QLabel*>()) all += label->text() + QLatin1Char('\n');
        return all;
    }

  private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void writesAMeshAndTellsItsForm() {
        const QString file = folder_.filePath(QStringLiteral("torus.stl"));
        QPointer<MeshExportDialog> dialog = new MeshExportDialog(sceneOf("f_torus(x, y, z, 1, 0.4)"), file);
        dialog->setTolerance(QStringLiteral("0.05"));
        dialog->show();
        QSignalSpy finished(dialog, &MeshExportDialog::finished);
        dialog->start();
        QVERIFY(dialog->running());
        QVERIFY(finished.wait(60000));
        QCOMPARE(finished[0][1].toString(), QString());
        QVERIFY(QFile(file).size() > 84);
        QVERIFY2(said(*dialog).contains(QStringLiteral("genus 1")), qPrintable(said(*dialog)));
        // A second time it asks first.
        dialog->start();
        QVERIFY(!dialog->running());
        QVERIFY(said(*dialog).contains(QStringLiteral("exists already")));
        dialog->start();
        QVERIFY(finished.wait(60000));
        QCOMPARE(finished[1][1].toString(), QString());
        dialog->close();
    }

    void theEndingFollowsTheFormatAndTheOtherWayRound() {
        QPointer<MeshExportDialog> dialog =
            new MeshExportDialog(sceneOf("x"), folder_.filePath(QStringLiteral("a.stl")));
        dialog->show();
        auto* format = dialog->findChild<QComboBox*>();
        format->setCurrentIndex(4);
        emit format->activated(4);
        bool found = false;
        for (const QLineEdit* edit : dialog->findChildren<QLineEdit*>())
            found = found || edit->text() == folder_.filePath(QStringLiteral("a.glb"));
        QVERIFY(found);
        dialog->setFile(folder_.filePath(QStringLiteral("a.ply")));
        QCOMPARE(format->currentIndex(), 3);
        dialog->close();
    }

    void aStopWritesNothing() {
        const QString file = folder_.filePath(QStringLiteral("stopped.obj"));
        QPointer<MeshExportDialog> dialog =
            new MeshExportDialog(sceneOf("sin(19*x)*sin(19*y)*sin(19*z)"), file);
        dialog->setTolerance(QStringLiteral("0.001"));
        dialog->show();
        QSignalSpy finished(dialog, &MeshExportDialog::finished);
        dialog->start();
        dialog->stop();
        QVERIFY(finished.wait(60000));
        QVERIFY(finished[0][1].toString().contains(QStringLiteral("Stopped")));
        QVERIFY(!QFile::exists(file));
        // One that is closed meanwhile goes.
        dialog->start();
        dialog->close();
        QTRY_VERIFY(dialog.isNull());
        QVERIFY(!QFile::exists(file));
    }

    void whatIsWrongIsSaidInTheDialog() {
        QFile foreign(folder_.filePath(QStringLiteral("foreign.obj")));
        QVERIFY(foreign.open(QIODevice::WriteOnly) && foreign.write("v 0 0 0\n") > 0);
        foreign.close();
        QPointer<MeshExportDialog> dialog = new MeshExportDialog(sceneOf("1"), foreign.fileName());
        dialog->show();
        dialog->start();
        QVERIFY(!dialog->running() && said(*dialog).contains(QStringLiteral("not replaced")));
        dialog->setFile(folder_.filePath(QStringLiteral("new.obj")));
        dialog->setTolerance(QStringLiteral("much"));
        dialog->start();
        QVERIFY(!dialog->running() && said(*dialog).contains(QStringLiteral("positive number")));
        dialog->setTolerance(QString());
        QSignalSpy finished(dialog, &MeshExportDialog::finished);
        dialog->start();
        QVERIFY(finished.wait(60000));
        QVERIFY(finished[0][1].toString().contains(QStringLiteral("no surface")));
        dialog->close();
    }
};

QTEST_MAIN(MeshExportDialogTest)
#include "mesh_export_dialog_test.moc"
