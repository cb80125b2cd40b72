// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/written_files.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"

using namespace isoscope;

namespace {

QByteArray contentOf(const QString& file) {
    QFile input(file);
    return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray("(none)");
}

}  // namespace

class WrittenFilesTest : public QObject {
    Q_OBJECT

  private slots:
    void whatATextWritesIsKeptUntilItIsAllowed() {
        const ParseResult parsed = parseScene(
            "#fopen F \"a.txt\" write #write (F, 1, \" and \", <1, 2, 3>) #fclose F sphere { 0, 1 }");
        QCOMPARE(parsed.writtenFiles.size(), std::size_t(1));
        QCOMPARE(parsed.writtenFiles.at("a.txt"), std::string("1 and <1,2,3> "));
        QCOMPARE(parsed.diagnostics.front().severity, Severity::note);
        const QTemporaryDir folder;
        QVERIFY(writeBeside(folder.filePath("scene.pov").toStdString(), parsed.writtenFiles).empty());
        QCOMPARE(contentOf(folder.filePath("a.txt")), QByteArray("1 and <1,2,3> "));
    }

    void nothingIsWrittenOutsideOfTheFolder() {
        const QTemporaryDir outer;
        QVERIFY(QDir(outer.path()).mkdir("inner"));
        QVERIFY(QDir(outer.path()).mkdir("inner/sub"));
        QVERIFY(QFile::link(outer.path(), outer.filePath("inner/link")));
        const std::string absolute = outer.filePath("absolute").toStdString();
        const std::vector<std::string> refused =
            writeBeside(outer.filePath("inner/scene.pov").toStdString(), {{"../up", "a"},
                                                                          {absolute, "a"},
                                                                          {"sub/../../up", "a"},
                                                                          {"sub\\..\\..\\up", "a"},
                                                                          {"link/up", "a"},
                                                                          {"sub", "a"},
                                                                          {"", "a"},
                                                                          {"none/a", "a"},
                                                                          {"sub/a", "b"}});
        QCOMPARE(refused.size(), std::size_t(8));
        QVERIFY(!QFile::exists(outer.filePath("up")));
        QVERIFY(!QFile::exists(outer.filePath("absolute")));
        QCOMPARE(contentOf(outer.filePath("inner/sub/a")), QByteArray("b"));
    }

    void theSceneItselfIsNotWrittenOver() {
        const QTemporaryDir folder;
        QFile scene(folder.filePath("scene.pov"));
        QVERIFY(scene.open(QIODevice::WriteOnly));
        scene.write("sphere { 0, 1 }");
        scene.close();
        const std::map<std::string, std::string> files{{"./scene.pov", "nothing"}};
        QCOMPARE(writeBeside(folder.filePath("scene.pov").toStdString(), files).size(), std::size_t(1));
        QCOMPARE(contentOf(folder.filePath("scene.pov")), QByteArray("sphere { 0, 1 }"));
    }
};

QTEST_APPLESS_MAIN(WrittenFilesTest)
#include "written_files_test.moc"
