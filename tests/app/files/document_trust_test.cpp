// SPDX-License-Identifier: GPL-3.0-or-later
// The text and its file: other programs, closing, what comes back at the next start.
#include <QAction>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStatusBar>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/session_memory.h"
#include "app/desktop/window/actions.h"
#include "tests/app/test_folder.h"
#include "tests/app/window_driver.h"
#include "widgets/document/difference_window.h"
#include "widgets/document/kept_texts_window.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

class DocumentTrustTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    std::unique_ptr<TestFolder> folder_;

    static constexpr const char* scene = "sphere { 0, 1 pigment { rgb 1 } }\n// end\n";

    WindowDriver& d() const { return *driver_; }
    NoticeBar* bar() const { return d()->notices(); }
    QString path(const char* name = "scene.pov") const { return folder_->path(QString::fromLatin1(name)); }
    QByteArray onDisk(const char* name = "scene.pov") const {
        return folder_->contents(QString::fromLatin1(name));
    }
    QByteArray inEditor() const { return d()->editor()->sceneText().toUtf8(); }
    void change(const QByteArray& text) const { folder_->write(QStringLiteral("scene.pov"), text); }
    void open() const {
        change(scene);
        QVERIFY(d()->openFile(path()));
        QVERIFY(d().rests());
    }
    void type(const char* typed = "//mine ") const {
        d().typeBehind(QStringLiteral("// end"), QString::fromLatin1(typed));
    }
    static QPushButton* button(QWidget* in, const QString& label) {
        for (QPushButton* button : in->findChildren<QPushButton*>())
            if (button->isVisible() && button->text() == label) return button;
        return nullptr;
    }
    void press(const char* label, QWidget* in = nullptr) const {
        QPushButton* found = button(in ? in : bar(), QString::fromLatin1(label));
        QVERIFY2(found, qPrintable(QStringLiteral("no button %1 beside: %2").arg(label, bar()->text())));
        QTest::mouseClick(found, Qt::LeftButton);
    }
    bool says(const char* words) const {
        return bar()->isVisible() && bar()->text().contains(QString::fromLatin1(words));
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        folder_ = std::make_unique<TestFolder>();
        QVERIFY(d().rests());
    }
    void cleanup() { driver_.reset(); }

    void aChangedFileIsNoticed_P2() {
        open();
        change("cube\n");
        QTRY_VERIFY(says("Another program changed scene.pov"));
        QCOMPARE(inEditor(), QByteArray(scene));
        press("Ignore");
        QVERIFY(!bar()->isVisible());
        // Once is enough, until there is something new.
        d().window().activateWindow();
        QCoreApplication::processEvents();
        QVERIFY(!bar()->isVisible());
        change("box { 0, 1 }\n// end\n");
        QTRY_VERIFY(says("Another program changed scene.pov"));
        press("Reload");
        QCOMPARE(inEditor(), QByteArray("box { 0, 1 }\n// end\n"));
        QVERIFY(!d().window().isWindowModified());
        // What was reloaded is known.
        type("");
        QVERIFY(d()->documents()->save());
    }

    void savingWritesOverNothingUnknown_D3() {
        open();
        type();
        const QByteArray mine = inEditor();
        change("// changed outside\n");
        d()->actions()->save->trigger();
        QVERIFY2(says("Not saved: another program changed scene.pov"), qPrintable(bar()->text()));
        QCOMPARE(onDisk(), QByteArray("// changed outside\n"));
        QCOMPARE(inEditor(), mine);
        press("Not Now");
        d()->actions()->save->trigger();
        QCOMPARE(onDisk(), QByteArray("// changed outside\n"));
        press("Save Mine");
        QCOMPARE(onDisk(), mine);
        QVERIFY(!d().window().isWindowModified());
    }

    void takeTheirsAndKeepMine() {
        open();
        type();
        const QByteArray mine = inEditor();
        change("// theirs\n");
        QTRY_VERIFY(says("and so did you"));
        press("Take Theirs");
        QCOMPARE(inEditor(), QByteArray("// theirs\n"));
        QVERIFY(!d().window().isWindowModified());
        d()->editor()->undo();
        QCOMPARE(inEditor(), mine);
        change("// theirs again\n");
        QTRY_VERIFY(says("and so did you"));
        press("Keep Mine");
        QVERIFY(d().window().isWindowModified());
        QVERIFY(d()->documents()->save());
        QCOMPARE(onDisk(), mine);
    }

    void theDifferenceIsShown() {
        open();
        type();
        change("sphere { 0, 2 pigment { rgb 1 } }\n// end\n");
        QTRY_VERIFY(says("and so did you"));
        press("See the Difference");
        auto* window = d().window().findChild<DifferenceWindow*>();
        QVERIFY(window && window->isVisible() && !window->isModal());
        QVERIFY2(window->shownText().contains(QStringLiteral("- sphere { 0, 2")) &&
                     window->shownText().contains(QStringLiteral("+ // end//mine")),
                 qPrintable(window->shownText()));
        QVERIFY(bar()->isVisible());  // the question stands
        press("Take Theirs", window);
        QVERIFY(inEditor().startsWith("sphere { 0, 2"));
        QVERIFY(!bar()->isVisible());
    }

    void aSecondInstanceNotices_P2() {
        open();
        MainWindow other;
        other.show();
        QVERIFY(other.openFile(path()));
        type("//one ");
        QVERIFY(d()->documents()->save());
        const QByteArray one = inEditor();
        QTRY_VERIFY(other.notices()->isVisible());
        QVERIFY(other.notices()->text().contains(QStringLiteral("Another program changed scene.pov")));
        other.editor()->append(QStringLiteral("//two"));
        QVERIFY(!other.documents()->save());
        QCOMPARE(onDisk(), one);
    }

    void aVanishedFileIsWrittenAgainOnlyKnowingly() {
        open();
        QVERIFY(QFile::remove(path()));
        QTRY_VERIFY(says("is no longer there"));
        QVERIFY(d().window().isWindowModified());
        press("Not Now");
        QVERIFY(!d()->documents()->save());
        QVERIFY(says("Not saved"));
        QVERIFY(!QFile::exists(path()));
        press("Write It Again");
        QCOMPARE(onDisk(), QByteArray(scene));
        QVERIFY(!d().window().isWindowModified());
    }

    /// As where a disk is taken out, and put back.
    void aVanishedFolderLosesNothing() {
        open();
        type();
        const QByteArray mine = inEditor();
        const QString folder = QFileInfo(path()).path();
        QVERIFY(QDir(folder).removeRecursively());
        QTRY_VERIFY(says("is no longer there"));
        press("Write It Again");
        QVERIFY2(says("No such file or directory"), qPrintable(bar()->text()));
        QVERIFY(d().window().isWindowModified());
        QCOMPARE(inEditor(), mine);
        QVERIFY(QDir().mkpath(folder));
        change("// theirs\n");
        QTRY_VERIFY2(says("so did you"), qPrintable(bar()->text()));
        QVERIFY(!d()->documents()->save());
        QCOMPARE(onDisk(), QByteArray("// theirs\n"));
        press("Save Mine");
        QCOMPARE(onDisk(), mine);
        // It is watched again.
        change("// later\n");
        QTRY_VERIFY(says("Another program changed scene.pov"));
    }

    void closingAsksOnce_D4_data() {
        QTest::addColumn<QString>("answer");
        QTest::addColumn<bool>("closes");
        QTest::addColumn<bool>("written");
        QTest::addColumn<bool>("kept");
        QTest::newRow("save") << "Save" << true << true << false;
        QTest::newRow("keep") << "Keep for Next Time" << true << false << true;
        QTest::newRow("discard") << "Discard" << true << false << false;
        QTest::newRow("cancel") << "Cancel" << false << false << false;
        QTest::newRow("Enter") << "<Enter>" << true << true << false;
        QTest::newRow("Escape") << "<Escape>" << false << false << false;
    }
    void closingAsksOnce_D4() {
        QFETCH(QString, answer);
        QFETCH(bool, closes);
        QFETCH(bool, written);
        QFETCH(bool, kept);
        open();
        type();
        const QByteArray mine = inEditor();
        d().window().close();
        QVERIFY(d().window().isVisible());
        QVERIFY2(says("scene.pov has changes that are not saved"), qPrintable(bar()->text()));
        QVERIFY(!QApplication::activeModalWidget());
        QWidget* first = button(bar(), QStringLiteral("Save"));
        QTRY_COMPARE(QApplication::focusWidget(), first);
        if (answer == "<Enter>")
            QTest::keyClick(first, Qt::Key_Return);
        else if (answer == "<Escape>")
            QTest::keyClick(first, Qt::Key_Escape);
        else
            press(answer.toLatin1());
        QCOMPARE(!d().window().isVisible(), closes);
        QCOMPARE(onDisk(), written ? mine : QByteArray(scene));
        if (!closes) {
            QCOMPARE(inEditor(), mine);
            return;
        }
        d().crash();  // it is closed already
        QCOMPARE(d()->start(path()), QString());
        QCOMPARE(inEditor(), written ? mine : QByteArray(scene));
        QCOMPARE(says("An unsaved text was kept: scene.pov"), kept);
        if (!kept) return;
        press("Bring Back");
        QCOMPARE(inEditor(), mine);
        QVERIFY(d().window().isWindowModified());
        d()->editor()->undo();
        QCOMPARE(inEditor(), QByteArray(scene));
    }

    void newAndOpenAskToo_D4() {
        open();
        folder_->write(QStringLiteral("other.pov"), "box { 0, 1 }\n");
        type();
        d()->actions()->newFile->trigger();
        QVERIFY(says("has changes that are not saved"));
        QCOMPARE(d()->documents()->document()->filePath(), path());
        press("Cancel");
        QVERIFY(d()->openFile(path("other.pov")));
        QVERIFY(says("has changes that are not saved"));
        press("Save");
        QCOMPARE(d()->documents()->document()->filePath(), path("other.pov"));
        QVERIFY(onDisk().contains("//mine"));
    }

    /// What was written after the text was kept is not written over unseen.
    void aKeptTextMeetsANewerFile() {
        open();
        type();
        QTest::qWait(RecoveryStore::interval + 300);
        d().crash();
        change("// newer\n");
        QCOMPARE(d()->start({}), QString());
        press("Bring Back");
        QVERIFY(inEditor().contains("//mine"));
        QVERIFY2(says("and so did you"), qPrintable(bar()->text()));
        QVERIFY(!d()->documents()->save());
        QCOMPARE(onDisk(), QByteArray("// newer\n"));
    }

    void keptTextsAreOneList_D9() {
        for (const char* words : {"//first ", "//second "}) {
            d().typeBehind(QStringLiteral("isosurface {"), QString::fromLatin1(words));
            d().restart();
            d()->showTutorial();
        }
        const QSize picture = d()->viewport()->size();
        d()->start({});
        QVERIFY2(says("2 unsaved texts were kept, the last one: A new scene"), qPrintable(bar()->text()));
        QCOMPARE(d()->viewport()->size(), picture);
        press("Later");
        d()->actions()->newFile->trigger();
        QVERIFY(!bar()->isVisible());

        d()->actions()->keptTexts->trigger();
        auto* window = d().window().findChild<KeptTextsWindow*>();
        QVERIFY(window && window->isVisible() && !window->isModal());
        QCOMPARE(window->count(), 2);
        auto* preview = window->findChild<QPlainTextEdit*>();
        QVERIFY(preview->toPlainText().contains(QStringLiteral("//second")));
        window->findChild<QListWidget*>()->setCurrentRow(1);
        QVERIFY(preview->toPlainText().contains(QStringLiteral("//first")));
        press("Bring Back", window);
        QVERIFY(inEditor().contains("//first"));
        QCOMPARE(window->count(), 1);
        press("Discard All", window);
        QCOMPARE(window->count(), 1);  // asked first
        press("Discard All 1 for Good", window);
        QCOMPARE(window->count(), 0);
        d()->documents()->offerRecovery();
        QVERIFY(!bar()->isVisible());
    }

    void aMissingFileIsSaidWhateverElseThereIs_D15() {
        d().typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" // kept"));
        d().restart();
        QVERIFY(d()->start(path("missing.pov")).contains(QStringLiteral("missing.pov")));
        QVERIFY2(says("missing.pov"), qPrintable(bar()->text()));
        press("Close");
        QVERIFY2(says("An unsaved text was kept"), qPrintable(bar()->text()));
    }

    void savingSaysSo_D34() {
        open();
        type();
        d()->actions()->save->trigger();
        QCOMPARE(d()->statusBar()->currentMessage(), QStringLiteral("Saved: ") + path());
        QVERIFY2(d()->windowTitle().contains(QFileInfo(path()).absolutePath()),
                 qPrintable(d()->windowTitle()));
    }

    void anUnnamedTextSaysThatItIsKept() {
        QVERIFY(!d()->windowTitle().contains(QStringLiteral("kept")));
        d().typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" "));
        QTRY_VERIFY(d()->windowTitle().contains(QStringLiteral("[*] (kept)")));
    }

    void theLastFileComesBack_D32_data() {
        QTest::addColumn<bool>("killed");
        QTest::newRow("closed") << false;
        QTest::newRow("killed") << true;
    }
    void theLastFileComesBack_D32() {
        QFETCH(bool, killed);
        folder_->write(QStringLiteral("scene.pov"), scene + QByteArray("// line\n").repeated(200));
        QCOMPARE(d()->start(path()), QString());
        QVERIFY(d().rests());
        d().dragViewport(d()->viewport()->rect().center(), {60, 20});
        const Camera camera = d()->viewport()->camera();
        d()->editor()->setCursorPosition(150, 3);
        d()->editor()->setFirstVisibleLine(140);
        d()->resize(1111, 777);
        QTest::qWait(SessionMemory::pause + 500);
        killed ? d().crash() : d().restart();
        QCOMPARE(d()->start({}), QString());
        QVERIFY(d().rests());
        QCOMPARE(d()->documents()->document()->filePath(), path());
        int line = 0, column = 0;
        d()->editor()->getCursorPosition(&line, &column);
        QCOMPARE(line, 150);
        QCOMPARE(column, 3);
        QCOMPARE(d()->editor()->firstVisibleLine(), 140);
        QTRY_VERIFY(d()->viewport()->camera() == camera);
        QCOMPARE(d()->size(), QSize(1111, 777));
    }

    void withoutALastFileThereIsTheTutorial() {
        open();
        QVERIFY(QFile::remove(path()));
        d().crash();
        QCOMPARE(d()->start({}), QString());
        QVERIFY(inEditor().contains("isosurface"));
    }

    void aThemeOfThisRunIsNotStored_D32() {
        d()->setTheme(Theme::dark);
        d().restart();
        QVERIFY(d()->editor()->look() == Look::light);
        d()->actions()->themeDark->trigger();
        d().crash();
        QVERIFY(d()->editor()->look() == Look::dark);
        d()->actions()->themeSystem->trigger();
    }
};

QTEST_MAIN(DocumentTrustTest)
#include "document_trust_test.moc"
