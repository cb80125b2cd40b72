// SPDX-License-Identifier: GPL-3.0-or-later
// What `#write` puts into files: nothing before the user has allowed it, and then beside the scene only.
#include <QFile>
#include <QPushButton>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/file_writer.h"
#include "tests/app/test_folder.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

using namespace isoscope;
using namespace isoscope::test;

class FileWriterTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    std::unique_ptr<TestFolder> folder_;

    void open(const QByteArray& statements) const {
        folder_->write(QStringLiteral("scene.pov"), "sphere { 0, 1 pigment { rgb 1 } }\n" + statements);
        QVERIFY((*driver_)->openFile(folder_->path(QStringLiteral("scene.pov"))));
        QVERIFY(driver_->rests());
        QVERIFY((*driver_)->session()->result()->ok());
    }
    NoticeBar* bar() const { return (*driver_)->textNotices(); }
    void press(const QString& label) const {
        QVERIFY2(WindowDriver::press(bar(), label),
                 qPrintable("no button " + label + " beside: " + bar()->text()));
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        folder_ = std::make_unique<TestFolder>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void nothingIsWrittenUntilItIsAllowed() {
        WindowDriver& d = *driver_;
        QVERIFY(!bar()->isVisible());
        open("#fopen F \"points.txt\" write\n#write (F, 1, \",\", 2.5)\n#fclose F\n");
        QTRY_VERIFY(bar()->isVisible());
        QVERIFY2(bar()->text().contains(QStringLiteral("points.txt")), qPrintable(bar()->text()));
        QCOMPARE(folder_->contents(QStringLiteral("points.txt")), QByteArray("(no file)"));
        press(QStringLiteral("Allow"));
        QCOMPARE(folder_->contents(QStringLiteral("points.txt")), QByteArray("1,2.5"));
        QVERIFY(!bar()->isVisible());
        // Once allowed, files follow the text.
        d.typeBehind(QStringLiteral("#write (F, 1"), QStringLiteral("2"));
        QVERIFY(d.rests());
        QTRY_COMPARE(folder_->contents(QStringLiteral("points.txt")), QByteArray("12,2.5"));
        QVERIFY(!bar()->isVisible());
        // Another document has to ask again.
        QVERIFY(d->documents()->save());
        QFile::remove(folder_->path(QStringLiteral("points.txt")));
        open("#fopen F \"points.txt\" write\n#write (F, 3)\n#fclose F\n");
        QTRY_VERIFY(bar()->isVisible());
        QCOMPARE(folder_->contents(QStringLiteral("points.txt")), QByteArray("(no file)"));
    }

    void notNowIsAnAnswer() {
        WindowDriver& d = *driver_;
        open("#fopen F \"points.txt\" write\n#write (F, 1)\n#fclose F\n");
        QTRY_VERIFY(bar()->isVisible());
        QCOMPARE(bar()->findChildren<QPushButton*>().size(), 2);
        press(QStringLiteral("Not Now"));
        d.typeBehind(QStringLiteral("#write (F, 1"), QStringLiteral("2"));
        QVERIFY(d.rests());
        QVERIFY(!bar()->isVisible());
        QCOMPARE(folder_->contents(QStringLiteral("points.txt")), QByteArray("(no file)"));
    }

    void nothingIsWrittenElsewhere() {
        QTemporaryDir elsewhere;
        const QByteArray target = elsewhere.filePath(QStringLiteral("x.txt")).toUtf8();
        open("#fopen F \"../x.txt\" write #write (F, 1) #fclose F\n#fopen G \"" + target +
             "\" write #write (G, 1) #fclose G\n");
        QTRY_VERIFY(bar()->isVisible());
        press(QStringLiteral("Allow"));
        QTRY_VERIFY2(bar()->text().startsWith(QStringLiteral("Not written")), qPrintable(bar()->text()));
        QVERIFY(!QFile::exists(folder_->path(QStringLiteral("../x.txt"))) &&
                !QFile::exists(QString::fromUtf8(target)));
    }

    /// Each reading of the text would add to them.
    void filesThatGrowAreAskedAboutEachTime() {
        WindowDriver& d = *driver_;
        folder_->write(QStringLiteral("log.txt"), "a");
        open("#fopen F \"log.txt\" append\n#write (F, \"b\")\n#fclose F\n");
        QTRY_VERIFY(bar()->isVisible());
        QVERIFY2(bar()->text().contains(QStringLiteral("adds to log.txt")), qPrintable(bar()->text()));
        press(QStringLiteral("Add Once"));
        QCOMPARE(folder_->contents(QStringLiteral("log.txt")), QByteArray("ab"));
        d.typeBehind(QStringLiteral("sphere { 0, 1"), QStringLiteral(" "));
        QVERIFY(d.rests());
        QCOMPARE(folder_->contents(QStringLiteral("log.txt")), QByteArray("ab"));
    }

    /// P1: typing another name over an allowed one wrote a file for each letter, and replaced one that was
    /// there.
    void aNameThatIsBeingTypedIsNoName() {
        WindowDriver& d = *driver_;
        folder_->write(QStringLiteral("da.txt"), "precious data");
        open("#fopen F \"x.txt\" write\n#write (F, \"hello\")\n#fclose F\n");
        QTRY_VERIFY(bar()->isVisible());
        press(QStringLiteral("Allow"));
        QCOMPARE(folder_->contents(QStringLiteral("x.txt")), QByteArray("hello"));
        const QStringList before = folder_->names();

        d.typeBehind(QStringLiteral("#fopen F \"x"), {});
        QTest::keyClick(d->editor()->viewport(), Qt::Key_Backspace);
        for (const char letter : QByteArray("da")) {
            QTest::keyClick(d->editor()->viewport(), letter);
            QVERIFY(d.rests());
        }
        // As long as the caret is in the name nothing is asked, however long that takes.
        QTest::qWait(FileWriter::settlingTime + 500);
        QVERIFY(!bar()->isVisible());
        QCOMPARE(folder_->names(), before);
        d->editor()->setCursorPosition(0, 0);
        QTRY_VERIFY(bar()->isVisible());
        QVERIFY2(bar()->text().contains(QStringLiteral("replace da.txt")), qPrintable(bar()->text()));
        QCOMPARE(folder_->contents(QStringLiteral("da.txt")), QByteArray("precious data"));
        press(QStringLiteral("Replace da.txt"));
        QCOMPARE(folder_->contents(QStringLiteral("da.txt")), QByteArray("hello"));
        // It is the scene's own now, until somebody else changes it.
        d.typeBehind(QStringLiteral("\"hello"), QStringLiteral("!"));
        QVERIFY(d.rests());
        QTRY_COMPARE(folder_->contents(QStringLiteral("da.txt")), QByteArray("hello!"));
        folder_->write(QStringLiteral("da.txt"), "changed by another");
        d.typeBehind(QStringLiteral("\"hello!"), QStringLiteral("?"));
        QVERIFY(d.rests());
        QTRY_VERIFY(bar()->isVisible());
        press(QStringLiteral("Not Now"));
        QCOMPARE(folder_->contents(QStringLiteral("da.txt")), QByteArray("changed by another"));
        QCOMPARE(folder_->names(), before);
    }

    void theSceneItselfIsNeverWritten() {
        open("#fopen F \"scene.pov\" write\n#write (F, 1)\n#fclose F\n");
        QVERIFY(!bar()->isVisible());
        QVERIFY(folder_->contents(QStringLiteral("scene.pov")).startsWith("sphere"));
    }
};

QTEST_MAIN(FileWriterTest)
#include "file_writer_test.moc"
