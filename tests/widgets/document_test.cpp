// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/document.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace isoscope;

class DocumentTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString file(const QString& name) const { return folder_.filePath(name); }
    QString write(const QString& name, const QByteArray& bytes) const {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly)) return {};
        file.write(bytes);
        return file.fileName();
    }
    static QByteArray read(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

  private slots:
    void aNewDocumentIsUntitled() {
        Document document;
        QCOMPARE(document.title(), QString("Untitled[*]"));
        QVERIFY(document.filePath().isEmpty());
        QVERIFY(!document.isModified());
    }

    void writesBackTheSameBytes_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("text");
        QTest::newRow("utf-8") << QByteArray("a \xf0\x9f\x98\x80 \xe6\xbc\xa2\n")
                               << QString::fromUtf8("a \xf0\x9f\x98\x80 \xe6\xbc\xa2\n");
        QTest::newRow("utf-8 with mark") << QByteArray(
                                                "\xef\xbb\xbf"
                                                "a\n")
                                         << "a\n";
        QTest::newRow("latin-1") << QByteArray("// gr\xfc\xdf\x65\n")
                                 << QString::fromUtf8(
                                        "// gr\xc3\xbc\xc3\x9f"
                                        "e\n");
        QTest::newRow("dos lines") << QByteArray("a\r\nb\r\n") << "a\nb\n";
        QTest::newRow("old mac lines") << QByteArray("a\rb\r") << "a\nb\n";
        QTest::newRow("mixed lines") << QByteArray("a\r\nb\nc\r") << "a\r\nb\nc\r";
        QTest::newRow("empty") << QByteArray("") << "";
        QTest::newRow("no last line end") << QByteArray("a") << "a";
        QTest::newRow("nul") << QByteArray("a\0b", 3) << QString::fromLatin1("a\0b", 3);
        QTest::newRow("random bytes") << QByteArray("\xff\xfe\x00\x80\xc3\x28", 6)
                                      << QString::fromLatin1("\xff\xfe\x00\x80\xc3\x28", 6);
        QTest::newRow("mark, then not utf-8")
            << QByteArray("\xef\xbb\xbf\xff") << QString::fromLatin1("\xef\xbb\xbf\xff");
    }
    void writesBackTheSameBytes() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, text);
        Document document;
        const auto loaded = document.load(write("in.pov", bytes));
        QVERIFY(loaded);
        QCOMPARE(*loaded, text);
        QVERIFY(document.save(file("out.pov"), *loaded));
        QCOMPARE(read(file("out.pov")), bytes);
    }

    void latin1BecomesUtf8WhenACharacterAsksForIt() {
        Document document;
        QVERIFY(document.load(write("latin.pov", "\xfc")));
        QVERIFY(document.save(file("latin.pov"), QString::fromUtf8("\xc3\xbc\xe6\xbc\xa2")));
        QCOMPARE(read(file("latin.pov")), QByteArray("\xc3\xbc\xe6\xbc\xa2"));
    }

    void aFailedSaveLeavesFileAndState() {
        Document document;
        document.setModified(true);
        QVERIFY(!document.save(file("no/such/folder.pov"), "text"));
        QVERIFY(document.errorText().contains("folder.pov"));
        QVERIFY(document.isModified());
        QVERIFY(document.filePath().isEmpty());
    }

    void aFailedLoadChangesNothing() {
        Document document;
        const QString path = write("good.pov", "a");
        QVERIFY(document.load(path));
        QVERIFY(!document.load(file("missing.pov")));
        QVERIFY(!document.errorText().isEmpty());
        QVERIFY(!document.load(folder_.path()));
        QVERIFY(document.errorText().contains("folder"));
        QCOMPARE(document.filePath(), path);
    }

    void refusesWhatIsNoText() {
        QFile large(file("large.pov"));
        QVERIFY(large.open(QIODevice::WriteOnly));
        QVERIFY(large.resize(Document::sizeLimit + 1));
        large.close();
        Document document;
        QVERIFY(!document.load(large.fileName()));
        QVERIFY(document.errorText().contains("larger"));
    }

    void savesThroughALink() {
        write("target.pov", "old");
        QVERIFY(QFile::link(file("target.pov"), file("link.pov")));
        Document document;
        QVERIFY(document.load(file("link.pov")));
        QVERIFY(document.save(file("link.pov"), "new"));
        QCOMPARE(read(file("target.pov")), QByteArray("new"));
        QVERIFY(QFileInfo(file("link.pov")).isSymLink());
    }

    void tellsOfChanges() {
        Document document;
        QSignalSpy changed(&document, &Document::changed);
        document.setModified(true);
        document.setModified(true);
        QCOMPARE(changed.count(), 1);
        QVERIFY(document.save(file("scene.pov"), "x"));
        QCOMPARE(changed.count(), 2);
        QVERIFY(!document.isModified());
        QCOMPARE(document.title(), QString("scene.pov[*]"));
        document.reset();
        QCOMPARE(document.name(), QString("Untitled"));
    }
};

QTEST_GUILESS_MAIN(DocumentTest)
#include "document_test.moc"
