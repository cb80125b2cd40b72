// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace isoscope::test;

/// A scene reads from its own folder, the library paths and the folders that the person allowed, and from
/// nowhere else.
class SafeReadingTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir root_;

    /// The scene lies in ROOT/scene, what it is after in ROOT/private.
    ProgramResult check(const QByteArray& text, const QStringList& options = {}) {
        return runCli(QStringList{"check", writeFile(root_.filePath("scene"), "scene.pov", text)} + options,
                      20);
    }

    QByteArray secret() const { return root_.filePath("private/secret.inc").toUtf8(); }

    static void checkRefused(const ProgramResult& result) {
        QVERIFY2(result.status == 1, result.errors);
        QVERIFY2(result.errors.contains("is not read: it lies outside"), result.errors);
        QVERIFY2(result.errors.contains("--allow-read"), result.errors);
        QVERIFY2(!result.errors.contains("hidden_word"), result.errors);
    }

  private slots:
    void initTestCase() {
        QDir(root_.path()).mkpath("scene/parts");
        QDir(root_.path()).mkpath("private");
        writeFile(root_.filePath("private"), "secret.inc", "\"hidden_word\"\n#declare Size = 1;\n");
        writeFile(root_.filePath("private"), "allowed.inc", "#declare Size = 1;\n");
        writeFile(root_.filePath("scene"), "own.inc", "#declare Size = 1;\n");
        writeFile(root_.filePath("scene/parts"), "part.inc", "#include \"../own.inc\"\n");
        QVERIFY(QFile::link(root_.filePath("private/secret.inc"), root_.filePath("scene/link.inc")));
        QVERIFY(QFile::link(root_.filePath("private"), root_.filePath("scene/folder")));
        for (const char* name : {"image.ppm", "font.ttf", "volume.df3"}) {
            writeFile(root_.filePath("private"), name,
                      name == QByteArray("image.ppm") ? "P6 1 1 255\nabc" : "a");
            QVERIFY(QFile::link(root_.filePath("private/") + name, root_.filePath("scene/link-") + name));
        }
    }

    void filesOutsideAreRefused_data() {
        QTest::addColumn<QByteArray>("text");
        const QByteArray folder = root_.filePath("private").toUtf8();
        QTest::newRow("include, absolute") << "#include \"" + secret() + "\"\n";
        QTest::newRow("include, /etc/passwd") << QByteArray("#include \"/etc/passwd\"\n");
        QTest::newRow("include, ..") << QByteArray("#include \"../private/secret.inc\"\n");
        QTest::newRow("include, .. within") << QByteArray("#include \"parts/../../private/secret.inc\"\n");
        QTest::newRow("include, backslashes") << QByteArray("#include \"..\\\\private\\\\secret.inc\"\n");
        QTest::newRow("include, link") << QByteArray("#include \"link.inc\"\n");
        QTest::newRow("include, linked folder") << QByteArray("#include \"folder/secret.inc\"\n");
        QTest::newRow("include that does not exist") << QByteArray("#include \"../private/none.inc\"\n");
        QTest::newRow("read") << "#fopen F \"" + secret() + "\" read\n#read (F, A)\n#warning A\n";
        QTest::newRow("append and read") << QByteArray(
            "#fopen F \"../private/secret.inc\" append\n#fclose F\n"
            "#fopen F \"../private/secret.inc\" read\n#read (F, A)\n"
            "#warning A\n#include \"/etc/passwd\"\n");
        QTest::newRow("image") << "sphere { 0, 1 pigment { image_map { ppm \"" + folder +
                                      "/image.ppm\" } } }\n";
        QTest::newRow("height field") << "height_field { ppm \"" + folder + "/image.ppm\" }\n";
        QTest::newRow("font") << "text { ttf \"" + folder + "/font.ttf\", \"a\", 1, 0 }\n";
        QTest::newRow("density") << QByteArray(
            "sphere { 0, 1 pigment { density_file df3 \"../private/volume.df3\" } }\n");
        QTest::newRow("image, link") << QByteArray(
            "sphere { 0, 1 pigment { image_map { ppm \"link-image.ppm\" } } }\n");
        QTest::newRow("image, linked folder")
            << QByteArray("sphere { 0, 1 pigment { image_map { ppm \"folder/image.ppm\" } } }\n");
        QTest::newRow("image, ..") << QByteArray(
            "sphere { 0, 1 pigment { image_map { ppm \"../private/image.ppm\" } } }\n");
        QTest::newRow("bump map, link") << QByteArray(
            "sphere { 0, 1 pigment { rgb 1 } normal { bump_map { ppm \"link-image.ppm\" } } }\n");
        QTest::newRow("height field, link") << QByteArray("height_field { ppm \"link-image.ppm\" }\n");
        QTest::newRow("font, link") << QByteArray("text { ttf \"link-font.ttf\", \"a\", 1, 0 }\n");
        QTest::newRow("font, ..") << QByteArray("text { ttf \"../private/font.ttf\", \"a\", 1, 0 }\n");
        QTest::newRow("density, link")
            << QByteArray("sphere { 0, 1 pigment { density_file df3 \"link-volume.df3\" } }\n");
        QTest::newRow("density, absolute")
            << "sphere { 0, 1 pigment { density_file df3 \"" + folder + "/volume.df3\" } }\n";
        QTest::newRow("read, link") << QByteArray("#fopen F \"link.inc\" read\n#read (F, A)\n#warning A\n");
        QTest::newRow("read, ..") << QByteArray(
            "#fopen F \"../private/secret.inc\" read\n#read (F, A)\n#warning A\n");
    }

    void filesOutsideAreRefused() {
        QFETCH(QByteArray, text);
        checkRefused(check("#version 3.7;\n" + text));
    }

    /// A scene that is itself a link lies where the link points to, or beside it: nowhere else.
    void writesStayBesideTheScene_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("absolute") << root_.filePath("private/written.txt").toUtf8();
        QTest::newRow("..") << QByteArray("../private/written.txt");
        QTest::newRow(".. within") << QByteArray("parts/../../private/written.txt");
        QTest::newRow("linked folder") << QByteArray("folder/written.txt");
        QTest::newRow("link to a file") << QByteArray("link.inc");
        QTest::newRow("link to nothing") << QByteArray("dangling.txt");
        QTest::newRow("the scene") << QByteArray("scene.pov");
        QTest::newRow("a neighbour") << QByteArray("own.inc");
    }

    void writesStayBesideTheScene() {
        QFETCH(QByteArray, name);
        const QString dangling = root_.filePath("scene/dangling.txt");
        QFile::link(root_.filePath("private/written.txt"), dangling);
        const auto contentOf = [&](const char* file) {
            QFile input(root_.filePath(file));
            return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
        };
        const QByteArray secretBefore = contentOf("private/secret.inc"), own = contentOf("scene/own.inc");
        for (const char* mode : {"write", "append"}) {
            const QByteArray text = "#version 3.7;\n#fopen F \"" + name + "\" " + mode +
                                    "\n#write (F, \"evil\")\n#fclose F\nsphere { 0, 1 }\n";
            const ProgramResult result =
                runCli({"render", writeFile(root_.filePath("scene"), "scene.pov", text), "-o",
                        root_.filePath("out.png"), "-W", "8", "-H", "6", "--allow-writes"},
                       20);
            QVERIFY2(result.status == 1 && result.errors.contains("error"),
                     QByteArray(mode) + ' ' + QByteArray::number(result.status) + ' ' + result.errors);
            QCOMPARE(contentOf("scene/scene.pov"), text);
            QCOMPARE(contentOf("private/secret.inc"), secretBefore);
            QCOMPARE(contentOf("scene/own.inc"), own);
            QVERIFY(!QFile::exists(root_.filePath("private/written.txt")));
        }
    }

    void ownFilesAreRead() {
        const QByteArray use = "sphere { 0, Size pigment { rgb 1 } }\n";
        for (const char* name : {"own.inc", "parts/part.inc", "parts/../own.inc", "./own.inc"}) {
            const ProgramResult result =
                check("#version 3.7;\n#include \"" + QByteArray(name) + "\"\n" + use);
            QVERIFY2(result.status == 0, name + result.errors);
        }
        const QByteArray own = root_.filePath("scene/own.inc").toUtf8();
        QCOMPARE(check("#version 3.7;\n#include \"" + own + "\"\n" + use).status, 0);
    }

    /// The option that the message names does what it says, for the folder and those below it.
    void allowedFoldersAreRead() {
        const QByteArray text =
            "#version 3.7;\n#include \"../private/allowed.inc\"\nsphere { 0, Size pigment { rgb 1 } }\n";
        checkRefused(check(text));
        checkRefused(check(text, {"--allow-read", root_.filePath("scene")}));
        checkRefused(check(text, {"--allow-read", root_.filePath("priv")}));
        for (const QString& folder : {root_.filePath("private"), root_.filePath("private/"), root_.path()}) {
            const ProgramResult result = check(text, {"--allow-read", folder});
            QVERIFY2(result.status == 0, result.errors);
        }
    }

    /// What a table says in front of its expressions reads nothing from elsewhere either.
    void tablesAreRestricted() {
        const QString table =
            writeFile(root_.filePath("scene"), "table.csv",
                      "expression,prelude,x,y,z\nx*Size,\"#include \"\"" + secret() + "\"\"\",1,2,3\n");
        const ProgramResult result = runCli({"evaluate", "--table", table});
        QVERIFY2(result.output.contains("is not read: it lies outside"), result.output);
    }
};

QTEST_GUILESS_MAIN(SafeReadingTest)
#include "safe_reading_test.moc"
