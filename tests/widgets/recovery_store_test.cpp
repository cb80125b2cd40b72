// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/recovery_store.h"

#include <signal.h>
#include <unistd.h>

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace isoscope;

namespace {

const QString wideText =
    QString::fromUtf8("sphere { 0, 1 } // \xf0\x9f\x98\x80 \xe6\xbc\xa2 \\ \"") + QChar(0) + "\n";

UnsavedText snapshot(const QString& text, const QString& path = {}) {
    UnsavedText unsaved;
    unsaved.text = text;
    unsaved.filePath = path;
    return unsaved;
}

/// What the killed program does: it keeps a text and dies without a word.
int die(const QString& folder) {
    RecoveryStore store([] { return snapshot(wideText, "/tmp/lost.pov"); }, folder);
    store.textChanged();
    store.flush();
    kill(getpid(), SIGKILL);
    return 0;
}

}  // namespace

class RecoveryStoreTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

    QStringList copies() const { return QDir(folder_->path()).entryList({"*.json"}); }
    RecoveryStore::Snapshot text(const QString& text) const {
        return [text] { return snapshot(text); };
    }
    /// The next start of the program.
    void start() const { RecoveryStore store(text(""), folder_->path()); }
    void age(const QString& name, int days) const {
        QFile file(folder_->filePath(name));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(
            file.setFileTime(QDateTime::currentDateTime().addDays(-days), QFileDevice::FileModificationTime));
    }

  private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void aKilledProgramLeavesItsText() {
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(), {"--die", folder_->path()});
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        RecoveryStore store(text("mine"), folder_->path());
        const auto found = store.abandoned();
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].text, wideText);
        QCOMPARE(found[0].filePath, QString("/tmp/lost.pov"));
        QVERIFY(found[0].saved.isValid());
        // Offered, not forced: looking changes nothing.
        QCOMPARE(store.abandoned().size(), 1u);

        const auto taken = store.take(found[0].id);
        QVERIFY(taken);
        QCOMPARE(taken->text, wideText);
        QCOMPARE(copies().size(), 1);  // still safe on disk, as this instance's own
        QVERIFY(store.abandoned().empty());
        store.markSaved();
        QVERIFY(copies().isEmpty());
    }

    void aLivingInstanceIsLeftAlone() {
        RecoveryStore living(text("living"), folder_->path());
        living.textChanged();
        living.flush();
        RecoveryStore other(text("other"), folder_->path());
        QVERIFY(other.abandoned().empty());
        QVERIFY(!other.take(QFileInfo(copies().first()).completeBaseName()));
        other.discard(QFileInfo(copies().first()).completeBaseName());
        QCOMPARE(copies().size(), 1);
    }

    void writesAtMostOneIntervalLater() {
        int asked = 0;
        RecoveryStore store([&asked] { return ++asked, snapshot("typed"); }, folder_->path());
        // Somebody who types without a pause is kept safe, too.
        QElapsedTimer clock;
        clock.start();
        while (asked == 0 && clock.elapsed() < 10 * RecoveryStore::interval) {
            store.textChanged();
            QTest::qWait(20);
        }
        QCOMPARE(asked, 1);
        QCOMPARE(copies().size(), 1);
    }

    void flushWritesOnlyWhatIsDue() {
        int asked = 0;
        RecoveryStore store([&asked] { return ++asked, snapshot("typed"); }, folder_->path());
        store.flush();
        QCOMPARE(asked, 0);
        store.textChanged();
        store.flush();
        store.flush();
        QCOMPARE(asked, 1);
    }

    void aNormalEndKeepsWhatWasNotSaved() {
        {
            RecoveryStore store(text("kept"), folder_->path());
            store.textChanged();
            store.flush();
        }
        RecoveryStore next(text(""), folder_->path());
        QCOMPARE(next.abandoned().size(), 1u);
        QCOMPARE(next.abandoned()[0].text, QString("kept"));
        next.discard(next.abandoned()[0].id);
        QVERIFY(next.abandoned().empty());
        QVERIFY(copies().isEmpty());
    }

    void newestFirst() {
        for (const char* content : {"first", "second"}) {
            RecoveryStore store(text(content), folder_->path());
            store.textChanged();
            store.flush();
            QTest::qWait(5);
        }
        const auto found = RecoveryStore(text(""), folder_->path()).abandoned();
        QCOMPARE(found.size(), 2u);
        QCOMPARE(found[0].text, QString("second"));
    }

    void staleCopiesAreCleaned() {
        {
            RecoveryStore store(text("old"), folder_->path());
            store.textChanged();
            store.flush();
        }
        // Offered first, and again two days later.
        start();
        age("offered", 2);
        age(copies().first(), RecoveryStore::keptDays + 1);
        start();
        QCOMPARE(copies().size(), 1);
        age("offered", 2);
        age(copies().first(), RecoveryStore::keptDays + 3);
        start();
        QVERIFY(copies().isEmpty());
        start();
        QVERIFY(QDir(folder_->path()).isEmpty());
    }

    /// After a month's absence, or with a clock that went wrong, the text was taken away at the start that
    /// was to offer it.
    void anOldCopyIsOfferedForADay() {
        {
            RecoveryStore store(text("old"), folder_->path());
            store.textChanged();
            store.flush();
        }
        age(copies().first(), 400);
        for (int i = 0; i < 3; ++i) start();
        QCOMPARE(RecoveryStore(text(""), folder_->path()).abandoned().size(), 1u);
        // Started last by a clock that was a year ahead.
        age("offered", -365);
        for (int i = 0; i < 3; ++i) start();
        QCOMPARE(copies().size(), 1);
        // The clock is ahead now: all is old, and was never offered at a time like that.
        age(copies().first(), 4000);
        age("offered", 4000);
        for (int i = 0; i < 3; ++i) start();
        QCOMPARE(copies().size(), 1);
        age("offered", 2);
        start();
        QVERIFY(copies().isEmpty());
    }

    void aDamagedCopyIsNoText() {
        QFile file(folder_->filePath("broken.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"text\": \"half");
        file.close();
        RecoveryStore store(text(""), folder_->path());
        QVERIFY(store.abandoned().empty());
        QVERIFY(!store.take("broken"));
        QVERIFY(file.exists());
    }

    void saysWhenItCannotWrite() {
        QFile blocker(folder_->filePath("blocked"));
        QVERIFY(blocker.open(QIODevice::WriteOnly));
        blocker.close();
        RecoveryStore store(text("x"), blocker.fileName() + "/recovery");
        QSignalSpy failed(&store, &RecoveryStore::failed);
        store.textChanged();
        store.flush();
        QCOMPARE(failed.count(), 1);
        QVERIFY(!store.errorText().isEmpty());
        store.flush();  // still due
        QCOMPARE(failed.count(), 2);
    }
};

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc == 3 && QByteArray(argv[1]) == "--die") return die(argv[2]);
    RecoveryStoreTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "recovery_store_test.moc"
