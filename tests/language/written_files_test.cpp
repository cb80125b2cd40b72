// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/written_files.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

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
        WrittenRecord record{std::filesystem::path()};
        QVERIFY(writeBeside(folder.filePath("scene.pov").toStdString(), parsed.writtenFiles, record).empty());
        QCOMPARE(contentOf(folder.filePath("a.txt")), QByteArray("1 and <1,2,3> "));
    }

    /// What is written over takes no room any more: 256 MB in turn, of 128 that may be kept.
    void filesThatAreWrittenAnewGiveTheirRoomBack() {
        const ParseResult parsed = parseScene(
            "#declare S = \"0123456789abcdef\"; #for (I, 1, 16) #declare S = concat(S, S); #end "
            "#for (I, 1, 256) #fopen F \"a.txt\" write #write (F, S) #fclose F #end sphere { 0, 1 }");
        QCOMPARE(parsed.writtenFiles.at("a.txt").size(), std::size_t(1) << 20);
        QCOMPARE(parsed.diagnostics.front().severity, Severity::note);
    }

    /// What POV-Ray 3.7 reads: one token behind a value goes with it, be it another value, and a comma at the
    /// end of a file has one more reading behind it, which leaves the variable as it was.
    void filesAreReadAsPovrayReadsThem_data() {
        QTest::addColumn<QString>("content");
        QTest::addColumn<QString>("values");
        QTest::addColumn<QString>("id");
        const auto row = [](const char* content, const char* values, const char* id = "") {
            QTest::newRow(content) << content << values << id;
        };
        row("1, 2, 3", "1,1,1;2,2,2;3,3,3;");
        row("1, 2, 3,", "1,1,1;2,2,2;3,3,3;3,3,3;");
        row("1; 2:3", "1,1,1;2,2,2;3,3,3;");
        row("1 2 3", "1,1,1;3,3,3;", "lost-value");
        row("1, - 4, +5", "1,1,1;-4,-4,-4;5,5,5;");
        row("1 - 4", "1,1,1;4,4,4;", "lost-value");
        row("/* a */ 1, // b\\n2", "1,1,1;2,2,2;");
        row("<1 2, 3,>, <-1, - 2, +3>", "1,2,3;-1,-2,3;");
        row("<1, 2, 3> <4, 5>, 6", "1,2,3;4,4,4;5,5,5;5,5,5;", "lost-value");
        row("1, yes", "1,1,1;1,1,1;", "bad-value");
        row("1, --2", "1,1,1;1,1,1;", "bad-value");
        row("1,, 2", "1,1,1;1,1,1;", "bad-value");
        row("1, pi", "1,1,1;1,1,1;", "bad-value");
    }
    void filesAreReadAsPovrayReadsThem() {
        QFETCH(QString, content);
        QFETCH(QString, values);
        QFETCH(QString, id);
        const ParseResult parsed = parseScene(
            "#fopen F \"f\" write #write (F, \"" + content.toStdString() +
            "\") #fclose F #fopen F \"f\" read #declare S = \"\"; #while (defined(F)) #read (F, A) "
            "#declare S = concat(S, vstr(3, A + <0, 0, 0>, \",\", 0, 0), \";\"); #end "
            "#debug S sphere { 0, 1 }");
        QStringList said, ids;
        for (const Diagnostic& diagnostic : parsed.diagnostics) {
            if (diagnostic.id == "debug-directive") said.append(QString::fromStdString(diagnostic.message));
            if (diagnostic.id.ends_with("-value")) ids.append(QString::fromStdString(diagnostic.id));
        }
        QCOMPARE(said, QStringList(values));
        QCOMPARE(ids.value(0), id);
    }

    /// Else such loops go on until the budget of steps is spent.
    void aLoopOverWhatIsNoFileEnds() {
        for (const std::string handle : {"#declare F = 3;", "#fopen F \"f\" write"}) {
            const ParseResult parsed =
                parseScene(handle + " #while (defined(F)) #read (F, A) #end sphere { 0, 1 }");
            QCOMPARE(std::ranges::count(parsed.diagnostics, "not-open", &Diagnostic::id), 1);
            QVERIFY(std::ranges::none_of(parsed.diagnostics, [](const Diagnostic& d) {
                return d.message.find("cut off") != std::string::npos;
            }));
        }
    }

    void elementsOfArraysAreRead() {
        const ParseResult parsed = parseScene(
            "#fopen F \"f\" write #write (F, \"7, 8\") #fclose F #fopen F \"f\" read "
            "#declare A = array[2][2] { { 1, 2 }, { 3, 4 } } #read (F, A[1][0], A[0][1]) "
            "#error str(A[0][0] * 1000 + A[0][1] * 100 + A[1][0] * 10 + A[1][1], 0, 0)");
        QVERIFY(
            std::ranges::any_of(parsed.diagnostics, [](const Diagnostic& d) { return d.message == "1874"; }));
    }

    /// A vector has 2 to 5 components: what a sixth would be written to is not its own.
    void vectorsAreReadFromFiles() {
        const QTemporaryDir folder;
        const auto readBack = [&](const char* content) {
            QFile file(folder.filePath("v.txt"));
            if (file.open(QIODevice::WriteOnly)) file.write(content);
            file.close();
            ParseOptions options;
            options.file = folder.filePath("scene.pov").toStdString();
            return parseScene("#fopen F \"v.txt\" read #read (F, V) #fclose F sphere { V, 1 }", options);
        };
        const ParseResult three = readBack("<1, -2, 3>");
        const Value* value = three.symbols->find("V");
        QVERIFY(value && std::holds_alternative<VectorValue>(value->data));
        QCOMPARE(std::get<VectorValue>(value->data).count, 3);
        QCOMPARE(std::get<VectorValue>(value->data).components[1], -2.0);
        QVERIFY(std::holds_alternative<VectorValue>(readBack("<1, 2, 3, 4, 5>").symbols->find("V")->data));
        for (const char* content : {"<1, 2, 3, 4, 5, 6>", "<1>", "<1, 2", "<1; 2>"}) {
            const ParseResult parsed = readBack(content);
            QVERIFY2(parsed.symbols->find("V") == nullptr && hasErrors(parsed.diagnostics), content);
        }
    }

    void filesMustBeOpenToBeRead() {
        for (const char* text : {"#read (F, A)", "#fopen F \"a.txt\" write #read (F, A) #fclose F"}) {
            const ParseResult parsed = parseScene(std::string(text) + " sphere { 0, 1 }");
            QCOMPARE(std::ranges::count(parsed.diagnostics, Severity::error, &Diagnostic::severity), 1);
        }
    }

    void nothingIsWrittenOutsideOfTheFolder() {
        const QTemporaryDir outer;
        QVERIFY(QDir(outer.path()).mkdir("inner"));
        QVERIFY(QDir(outer.path()).mkdir("inner/sub"));
        QVERIFY(QFile::link(outer.path(), outer.filePath("inner/link")));
        const std::string absolute = outer.filePath("absolute").toStdString();
        WrittenRecord record{std::filesystem::path()};
        const std::vector<RefusedFile> refused = writeBeside(outer.filePath("inner/scene.pov").toStdString(),
                                                             {{"../up", "a"},
                                                              {absolute, "a"},
                                                              {"sub/../../up", "a"},
                                                              {"sub\\..\\..\\up", "a"},
                                                              {"link/up", "a"},
                                                              {"sub", "a"},
                                                              {"", "a"},
                                                              {"none/a", "a"},
                                                              {"sub/a", "b"}},
                                                             record);
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
        WrittenRecord record{std::filesystem::path()};
        QCOMPARE(writeBeside(folder.filePath("scene.pov").toStdString(), files, record).size(),
                 std::size_t(1));
        QCOMPARE(contentOf(folder.filePath("scene.pov")), QByteArray("sphere { 0, 1 }"));
    }

    /// P1: what stands there is replaced only when this scene wrote it and it has not been changed since.
    void whatOthersWroteIsNotReplaced() {
        const QTemporaryDir folder;
        const std::string scene = folder.filePath("scene.pov").toStdString(),
                          other = folder.filePath("other.pov").toStdString();
        const auto put = [&](const char* name, const char* content) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        };
        const std::filesystem::path remembered = folder.filePath("state/written").toStdString();
        {
            WrittenRecord record(remembered);
            put("data.txt", "precious");
            put("empty.txt", "");
            const WrittenFiles files{{"data.txt", "1"}, {"empty.txt", "2"}, {"new.txt", "3"}};
            QCOMPARE(foreignFiles(scene, files, record), std::set<std::string>{"data.txt"});
            const auto refused = writeBeside(scene, files, record);
            QCOMPARE(refused.size(), std::size_t(1));
            QCOMPARE(refused[0].name, std::string("data.txt"));
            QCOMPARE(contentOf(folder.filePath("data.txt")), QByteArray("precious"));
            QCOMPARE(contentOf(folder.filePath("new.txt")), QByteArray("3"));
        }
        WrittenRecord record(remembered);  // of the next run
        QVERIFY(writeBeside(scene, {{"new.txt", "4"}}, record).empty());
        QCOMPARE(contentOf(folder.filePath("new.txt")), QByteArray("4"));
        QCOMPARE(writeBeside(other, {{"new.txt", "5"}}, record).size(), std::size_t(1));
        put("new.txt", "changed by hand");
        QCOMPARE(writeBeside(scene, {{"new.txt", "6"}}, record).size(), std::size_t(1));
        QCOMPARE(contentOf(folder.filePath("new.txt")), QByteArray("changed by hand"));
        QVERIFY(writeBeside(scene, {{"new.txt", "6"}}, record, {"new.txt"}).empty());
        QCOMPARE(contentOf(folder.filePath("new.txt")), QByteArray("6"));
    }
};

QTEST_APPLESS_MAIN(WrittenFilesTest)
#include "written_files_test.moc"
