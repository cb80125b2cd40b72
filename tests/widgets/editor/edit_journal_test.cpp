// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/edit_journal.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include "widgets/document/history_store.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;

/// Undo histories as data, and on disk.
class EditJournalTest : public QObject {
    Q_OBJECT

    static SourceRange range(int begin, int end) {
        return {0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    }

    /// All texts that undo leads to from the present one, which is put back.
    static QStringList textsBefore(SceneEditor& editor) {
        QStringList texts{editor.sceneText()};
        int steps = 0;
        for (; editor.isUndoAvailable(); ++steps) {
            editor.undo();
            texts << editor.sceneText();
        }
        while (steps-- > 0) editor.redo();
        return texts;
    }

    /// The text and history of `editor`, as bytes, in a new editor.
    static std::unique_ptr<SceneEditor> again(const SceneEditor& editor) {
        auto copy = std::make_unique<SceneEditor>();
        const auto journal = EditJournal::unpacked(editor.history()->journal().packed());
        if (!journal || !copy->setSceneText(editor.sceneText(), &*journal)) return nullptr;
        return copy;
    }

  private slots:
    void aDragIsOneReplacement() {
        SceneEditor editor;
        editor.setSceneText(QStringLiteral("a = 1;"));
        editor.beginDrag();
        for (int i = 0; i < 100; ++i)
            QVERIFY(editor.replaceRange(range(4, editor.length() - 1), QString::number(i)));
        editor.endDrag();
        const EditJournal journal = editor.history()->journal();
        QCOMPARE(journal.steps().size(), std::size_t(1));
        const std::vector<EditJournal::Replacement> expected{{4, "1", "99"}};
        QVERIFY(journal.steps().front().text == expected);
        QCOMPARE(journal.textAfter(0, "a = 99;").value_or("none"), QByteArray("a = 1;"));
        // Of another text it is not the history.
        QVERIFY(!journal.textAfter(0, "a = 98;"));
    }

    /// A bug once: the first text came back as the saved one where the saved one was no longer to be had.
    void aSavedTextThatIsGoneStaysGone() {
        SceneEditor editor;
        editor.setSceneText(QStringLiteral("a = 1;"));
        editor.replaceRange(range(4, 5), QStringLiteral("2"));
        editor.setModified(false);
        editor.undo();
        editor.replaceRange(range(4, 5), QStringLiteral("3"));
        const auto copy = again(editor);
        QVERIFY(copy);
        QCOMPARE(editor.history()->journal().saved(), -1);
        QCOMPARE(copy->history()->journal().saved(), -1);
    }

    void everyTextComesBack() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        SceneEditor editor;
        editor.setSceneText(QStringLiteral("sphere { 0, 1 }\n// ä€\n"));
        for (int i = 0; i < 120; ++i) {
            const int length = editor.length(), at = random.bounded(length + 1);
            const int end = std::min(length, at + static_cast<int>(random.bounded(4)));
            switch (random.bounded(5)) {
                case 0: editor.undo(); break;
                case 1: editor.redo(); break;
                case 2: editor.setModified(false); break;
                default: editor.replaceRange(range(at, end), QString(random.bounded(4), QLatin1Char('x')));
            }
        }
        const auto copy = again(editor);
        QVERIFY(copy);
        QCOMPARE(copy->sceneText(), editor.sceneText());
        QCOMPARE(copy->isModified(), editor.isModified());
        QCOMPARE(copy->isRedoAvailable(), editor.isRedoAvailable());
        // The same bytes, too, so that nothing is lost from run to run.
        QCOMPARE(copy->history()->journal().packed(), editor.history()->journal().packed());
        QCOMPARE(textsBefore(*copy), textsBefore(editor));
        while (editor.isRedoAvailable()) {
            editor.redo();
            copy->redo();
            QCOMPARE(copy->sceneText(), editor.sceneText());
            QCOMPARE(copy->isModified(), editor.isModified());
        }
    }

    void stepsBesideTheTextKeepTheirPlace() {
        QStringList done;
        const auto step = [&done](const QByteArray& record) {
            const QString name = QString::fromLatin1(record);
            return EditHistory::Step{[&done, name] { done << "undo " + name; },
                                     [&done, name] { done << "redo " + name; }, false, QStringLiteral("mark"),
                                     [record] { return record; }};
        };
        SceneEditor editor;
        editor.setSceneText(QStringLiteral("ab"));
        editor.replaceRange(range(0, 1), QStringLiteral("1"));
        editor.history()->add(step("one"));
        editor.replaceRange(range(1, 2), QStringLiteral("2"));
        SceneEditor copy;
        copy.history()->setReviver(QStringLiteral("mark"), step);
        const auto journal = EditJournal::unpacked(editor.history()->journal().packed());
        QVERIFY(journal && copy.setSceneText(QStringLiteral("12"), &*journal));
        QVERIFY(done.isEmpty());  // nothing acts while the history is made
        copy.undo();
        QCOMPARE(copy.sceneText(), QStringLiteral("1b"));
        copy.undo();
        QCOMPARE(done, QStringList{QStringLiteral("undo one")});
        copy.undo();
        QCOMPARE(copy.sceneText(), QStringLiteral("ab"));
        QVERIFY(!copy.isUndoAvailable());
        copy.redo();
        copy.redo();
        QCOMPARE(done.last(), QStringLiteral("redo one"));
    }

    void damagedOnesAreRefused() {
        SceneEditor editor;
        editor.setSceneText(QStringLiteral("a"));
        editor.replaceRange(range(0, 1), QStringLiteral("b"));
        const QByteArray bytes = editor.history()->journal().packed();
        QVERIFY(EditJournal::unpacked(bytes));
        for (qsizetype length = 0; length < bytes.size(); ++length)
            QVERIFY(!EditJournal::unpacked(bytes.left(length)));
        QVERIFY(!EditJournal::unpacked(bytes + "x"));
        // Any byte may be another one: no crash, and the text stays what it is.
        for (qsizetype at = 0; at < bytes.size(); ++at) {
            QByteArray changed = bytes;
            changed[at] = static_cast<char>(changed[at] ^ 0x5a);
            SceneEditor copy;
            if (const auto journal = EditJournal::unpacked(changed))
                copy.setSceneText(QStringLiteral("b"), &*journal);
            else
                copy.setSceneText(QStringLiteral("b"));
            QCOMPARE(copy.sceneText(), QStringLiteral("b"));
        }
    }

    void longOnesAreCutAtTheirBeginning() {
        SceneEditor editor;
        editor.setSceneText(QStringLiteral("0"));
        for (int i = 1; i <= EditJournal::mostSteps + 20; ++i)
            editor.replaceRange(range(0, editor.length()), QString::number(i));
        const auto copy = again(editor);
        QVERIFY(copy);
        const QStringList texts = textsBefore(*copy);
        QCOMPARE(texts.size(), qsizetype(EditJournal::mostSteps + 1));
        QCOMPARE(texts.last(), QStringLiteral("20"));
    }

    void filesAreFoundByTheirText() {
        QTemporaryDir folder;
        const HistoryStore store(folder.path());
        const QString name = HistoryStore::nameOf(QStringLiteral("/a/scene.pov"));
        QVERIFY(store.write(name, QStringLiteral("one"), "1"));
        QVERIFY(store.write(HistoryStore::nameOf(QStringLiteral("other")), QStringLiteral("one"), "2"));
        QCOMPARE(store.find(name, QStringLiteral("one")).value_or("none"), QByteArray("1"));
        QVERIFY(!store.find(name, QStringLiteral("two")));
        // One for each document, which others cannot read.
        QVERIFY(store.write(name, QStringLiteral("two"), "3"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), qsizetype(2));
        QCOMPARE(store.find(name, QStringLiteral("one")).value_or("none"), QByteArray("2"));
        for (const QFileInfo& file : QDir(folder.path()).entryInfoList(QDir::Files))
            QVERIFY(!file.permission(QFile::ReadOther) && !file.permission(QFile::ReadGroup));
        QVERIFY(store.write(name, {}, {}));
        QVERIFY(!store.find(name, QStringLiteral("two")));
    }

    /// With a clock that was a year ahead, all histories were old.
    void onlyTheOldestOfManyAreRemoved() {
        QTemporaryDir folder;
        const QDateTime now = QDateTime::currentDateTimeUtc();
        for (int i = 0; i < HistoryStore::mostFiles + 3; ++i) {
            QFile file(folder.filePath(QStringLiteral("%1.steps").arg(i)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            QVERIFY(file.setFileTime(now.addDays(-365 - i), QFileDevice::FileModificationTime));
        }
        const HistoryStore store(folder.path());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), qsizetype(HistoryStore::mostFiles));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("%1.steps").arg(HistoryStore::mostFiles))));
    }
};

QTEST_MAIN(EditJournalTest)
#include "edit_journal_test.moc"
