// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <sys/stat.h>

#include <QElapsedTimer>
#include <QFile>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "test_folders.h"
#include "tests/support/program.h"

using namespace isoscope::test;

namespace {

/// A kilobyte of loop asks for hours, or for many gigabytes.
struct Attack {
    const char* name;
    const char* text;
};

constexpr const char* hardSurface =
    "#declare I = isosurface { function { f_noise3d(x*9,y*9,z*9)-0.5+sin(30*x)*cos(40*y)*sin(20*z) }\n"
    "  contained_by { box { -3, 3 } } max_gradient 5 accuracy 0.0001 }\n";
constexpr const char* manyParts = "#declare U = union { #for (K, 1, 5000) sphere { K, 1 } #end }\n";

/// `head` once, and `body` in a loop that does not end; N counts its rounds.
QByteArray loop(const QByteArray& body, const QByteArray& head = {}) {
    return head + "#for (N, 1, 1e9) " + body + " #end\n";
}

long peakOfChildren() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_maxrss / 1024;
}

}  // namespace

/// Texts that ask for more than there is: each ends with a message that names its place, within 20 s and 1
/// GB, whatever a step of it costs.
class AttackTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

    QString file(const QByteArray& text) { return writeFile(folder_.path(), "attack.pov", text); }

    static void checkMessage(const ProgramResult& result) {
        QVERIFY2(result.status == 1,
                 "status " + QByteArray::number(result.status) + ' ' + result.errors.left(300));
        static const QRegularExpression place(R"(\.(pov|inc|tmp):\d+:\d+: error: .+)");
        QVERIFY2(place.match(QString::fromUtf8(result.errors)).hasMatch(), result.errors.left(500));
        QVERIFY(result.errors.size() < 200000);
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

  private slots:
    void readingEnds_data() {
        QTest::addColumn<QByteArray>("text");
        const auto add = [](const char* name, const QByteArray& text) { QTest::newRow(name) << text; };
        add("F2: undeclared name",
            "#declare i=0; #while(i<1e9) sphere{<undeclared_name,0,0>,1} #declare i=i+1; #end\n");
        add("F2: words that are none", loop("foo bar baz"));
        add("F2: different names",
            loop("Parse_String(concat(\"unknown\", str(N, 0, 0), \" \"))", "#include \"strings.inc\"\n"));
        add("F2: empty loop", loop(""));
        add("names and texts that Parse_String makes",
            loop("Parse_String(concat(\"#declare X\", str(N, 0, 0), \" = 1;\"))",
                 "#include \"strings.inc\"\n"));
        add("files that are opened", loop("#fopen F concat(\"f\", str(N, 0, 0)) write"));
        add("F2: trace of a hard isosurface",
            loop("#declare P = trace(I, <0,0,-5>, <0.001*N,0.1,1>);", hardSurface));
        add("F2: trace of a sphere", loop("#declare P = trace(S, <0,0,-5>, <0.001*N,0.1,1>);",
                                          "#declare S = isosurface { function { x*x+y*y+z*z-1 } }\n"));
        add("F2: copies of 5000 parts", loop("object { U }", manyParts));
        add("F2: declared copies of 5000 parts", loop("#declare V = object { U translate x }", manyParts));
        add("F2: inside of 5000 parts", loop("#declare B = inside(U, <N,0,0>);", manyParts));
        add("F2: extents of 5000 parts", loop("#declare B = max_extent(U);", manyParts));
        add("F2: functions", loop("#declare F = function { sin(x)*cos(y)+z*z-N }"));
        add("F2: includes", loop("#include \"colors.inc\""));
        add("F2: doubling macro", "#macro M(n) #if (n > 0) M(n-1) M(n-1) #end #end M(60)\n");
        add("F2: pigments of images", loop("#declare P = pigment { image_map { ppm \"large.ppm\" } }"));
        add("F2: density files",
            loop("#declare P = pigment { density_file df3 \"large.df3\" interpolate 1 }"));
        add("F2: textures", loop("#declare T = texture { pigment { granite } normal { bumps 1 } }"));
        add("section 2: blob of 1e6 parts",
            "blob { threshold 0.5 #for (N, 1, 1e6) sphere { <sin(N),cos(N*3),sin(N*7)>*3, 0.1, 1 } #end }\n");
        add("section 2: blob of 1e7 parts",
            "blob { threshold 0.5 #for (N, 1, 1e7) sphere { <sin(N),cos(N*3),sin(N*7)>*3, 0.1, 1 } #end }\n");
        add("section 2: mesh of 1e7 triangles",
            "mesh { #for (N, 1, 1e7) triangle { <N,0,0>, <0,N,1>, <1,N,0> } #end }\n");
        add("section 2: 1e6 spheres", loop("sphere { N, 1 }"));
        add("isosurfaces", loop("isosurface { function { x*x+y*y+z*z-N } }"));
        add("section 2: string that doubles", loop("#declare S = concat(S, S);", "#declare S = \"abc\";\n"));
        add("section 2: nested arrays",
            loop("#declare D = C;",
                 "#declare A = array[1000]; #for (K, 0, 999) #declare A[K] = <K,K,K>; #end\n"
                 "#declare C = array[1000]; #for (K, 0, 999) #declare C[K] = A; #end\n"));
        add("nested sums of a declared function",
            "#declare F = function { sum(i,1,1e4,sum(j,1,1e4,sum(k,1,1e4,i*x+j*y+k*z))) }\n"
            "#declare A = F(1,2,3);\n#declare B = A\n}\n");
        add("heights of a function", loop("height_field { function 5000, 5000 { f_noise3d(x*9,y*9,0)+N } }"));
        add("section 2: union of 1e7 parts", "union { #for (N, 1, 1e7) sphere { N, 1 } #end }\n");
        add("section 2: array of 2e9", "#declare A = array[2e9];\n");
        add("section 2: array of arrays of 2e9", "#declare A = array[2000000000][2000000000];\n");
        add("macros that call each other", "#macro A(n) B(n) #end #macro B(n) A(n+1) A(n+1) #end A(0)\n");
        add("function that calls itself", "#declare F = function(x) { F(x)+1 }\n");
        add("functions that call each other",
            "#declare F = function(x) { G(x) }\n#declare G = function(x) { F(x) }\n");
        add("function that doubles 40 times", [] {
            QByteArray text = "#declare F0 = function(x) { sin(x) }\n";
            for (int i = 1; i <= 40; ++i)
                text += QByteArray("#declare F%1 = function(x) { F%2(x+%1)+F%2(x*2) }\n")
                            .replace("%1", QByteArray::number(i))
                            .replace("%2", QByteArray::number(i - 1));
            return text + "isosurface { function { F40(x) } }\n";
        }());
        add("section 2: density of 3e14 cells",
            "sphere { 0, 1 pigment { density_file df3 \"huge.df3\" } }\n");
        add("section 2: heights of 4e18 points", "height_field { function 2e9, 2e9 { x } }\n");
        add("pigments in pigments 1e5 deep", QByteArray("pigment { checker ").repeated(100000));
        add("textures of textures", "#declare T = texture { pigment { rgb 1 } }\n" +
                                        loop("#declare T = texture { checker texture { T } texture { T } }"));
        add("functions in functions 1e5 deep", QByteArray("function { ").repeated(100000));
        add("sums in sums 1e5 deep",
            "#declare F = function { " + QByteArray("sum(i,1,2,").repeated(100000) + "x\n");
        add("powers 1e5 high", "#declare F = function { " + QByteArray("x^").repeated(100000) + "x\n");
        add("bicubic patches",
            loop(
                "bicubic_patch { type 1 u_steps 8 v_steps 8 <0,0,0><1,0,0><2,0,0><3,0,0><0,1,0><1,1,0><2,1,0>"
                "<3,1,0><0,2,0><1,2,0><2,2,0><3,2,0><0,3,0><1,3,0><2,3,0><3,3,1> }"));
    }

    void readingEnds() {
        QFETCH(QByteArray, text);
        constexpr int side = 1000, edge = 100;
        if (!QFile::exists(folder_.filePath("large.df3"))) {
            writeFile(folder_.path(), "large.ppm", "P6 1000 1000 255\n" + QByteArray(3 * side * side, 'a'));
            writeFile(folder_.path(), "huge.df3", QByteArray(6, '\xff') + "abc");
            writeFile(folder_.path(), "large.df3",
                      QByteArray("\0d\0d\0d", 6) + QByteArray(edge * edge * edge, 'a'));
        }
        checkMessage(runCli({"check", "--time-limit", "4", file(text)}, 20));
    }

    /// A text with another noise generator is read twice. The first reading was still there during the
    /// second, which had a budget of its own: 1070 MB.
    void twoReadingsShareOneBudget() {
        const QByteArray text = loop("Parse_String(concat(\"#declare X\", str(N, 0, 0), \" = array[100];\"))",
                                     "#include \"strings.inc\"\nglobal_settings { noise_generator 1 }\n");
        const ProgramResult result = runCli({"check", "--time-limit", "100", file(text)}, 120);
        checkMessage(result);
        QVERIFY2(result.errors.contains("asks for more than 300000000 steps"), result.errors.left(500));
    }

    /// Megabytes of one thing, for each of the two languages.
    void longTextsEnd_data() {
        QTest::addColumn<QByteArray>("text");
        const quint32 seed = 20260101;
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        QByteArray bytes(1 << 20, Qt::Uninitialized);
        for (char& byte : bytes) byte = static_cast<char>(random.bounded(256));
        QTest::newRow("random bytes") << bytes;
        QTest::newRow("zeros") << QByteArray(1 << 20, '\0');
        QTest::newRow("one name") << QByteArray(1 << 20, 'a');
        QTest::newRow("one number") << QByteArray(1 << 20, '7');
        QTest::newRow("one string") << '"' + QByteArray(1 << 20, 'a') + '"';
        for (const char* piece :
             {"(",         ")",           "{",          "}",       "[",           "<",
              "\"",        "#",           "#if(1)",     "#if(0)",  "#else ",      "#end ",
              "#while(1)", "#macro M()",  "/*",         "union{",  "sphere{",     "isosurface{",
              "function{", "#declare A=", "1+",         "-",       "sphere{0,1}", "#include \"none.inc\"",
              "Shape[",    "Solid[",      "Declare A=", "\xc3\xa4"})
            QTest::newRow(piece) << QByteArray(piece).repeated((1 << 20) / qsizetype(qstrlen(piece)));
    }

    void longTextsEnd() {
        QFETCH(QByteArray, text);
        for (const char* name : {"long.pov", "long.vl"}) {
            const ProgramResult result =
                runCli({"check", "--time-limit", "4", writeFile(folder_.path(), name, text)}, 20);
            // `#` without a word is passed over, as in POV-Ray, and leaves an empty scene.
            const bool makesSense = text.startsWith("sphere{0,1}") || text.startsWith("##");
            QVERIFY2(result.status == 1 || (result.status == 0 && makesSense),
                     name + QByteArray(" status ") + QByteArray::number(result.status) + ' ' +
                         result.errors.left(300));
            QVERIFY2(!result.errors.isEmpty(), name);
            QVERIFY2(result.errors.size() < 200000, name + QByteArray::number(result.errors.size()));
            QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
        }
    }

    /// For each word its line was searched, and for each isosurface all settings before it: 20 s, now 0.3 s.
    void noPieceCostsMoreBehindManyOthers_data() {
        QTest::addColumn<QByteArray>("piece");
        for (const char* piece : {"agate ", ";", "x+sphere(x)*", "isosurface{function{x}}\n"})
            QTest::newRow(piece) << QByteArray(piece);
    }

    void noPieceCostsMoreBehindManyOthers() {
        QFETCH(QByteArray, piece);
        const ProgramResult result = runCli(
            {"check", writeFile(folder_.path(), "many.pov", piece.repeated((1 << 20) / piece.size()))}, 30);
        QVERIFY2(!result.errors.contains("the limit of time"), result.errors.left(300));
    }

    /// A pipe kept its reader waiting for ever, and a file of gigabytes was read to its end.
    void filesThatAreNoScenesEnd() {
        const QString pipe = folder_.filePath("pipe.pov"), large = folder_.filePath("large.pov");
        QVERIFY(mkfifo(qPrintable(pipe), 0600) == 0);
        QFile file(large);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64(3) << 30));  // takes no room
        for (const QStringList& command :
             {QStringList{"check"}, {"check", "--clock", "0.5"}, {"frames", "-o", folder_.path()}}) {
            const ProgramResult ofPipe = runCli(command + QStringList{pipe}, 20);
            QVERIFY2(ofPipe.status == 1 && ofPipe.errors.contains("cannot be read"), ofPipe.errors.left(300));
            const ProgramResult ofLarge = runCli(command + QStringList{large}, 20);
            QVERIFY2(ofLarge.status == 1 && ofLarge.errors.contains("is larger than 128 MB"),
                     ofLarge.errors.left(300));
        }
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

    /// What is too much is taken back to a limit, or is found to be the same thing again and again.
    void tamedScenesAreDrawn_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("section 2: octaves 1e9")
            << QByteArray("sphere { 0, 1 pigment { wrinkles turbulence 1 octaves 1e9 } }\n");
        QTest::newRow("section 2: mandel 1e9") << QByteArray("sphere { 0, 1 pigment { mandel 1e9 } }\n");
        QTest::newRow("f(x) = g(x) + g(x), 40 levels") << [] {
            QByteArray text = "#declare F0 = function(x) { sin(x) }\n";
            for (int i = 1; i <= 40; ++i)
                text += QByteArray("#declare F%1 = function(x) { F%2(x)+F%2(x) }\n")
                            .replace("%1", QByteArray::number(i))
                            .replace("%2", QByteArray::number(i - 1));
            return text + "isosurface { function { F40(x) } contained_by { box { -1, 1 } } }\n";
        }();
        QTest::newRow("section 2: picture of 1e12 pixels")
            << QByteArray("sphere { 0, 1 pigment { image_map { ppm \"huge.ppm\" } } }\n");
        QTest::newRow("octaves of a function")
            << QByteArray("isosurface { function { f_ridged_mf(x,y,z,1,2,1e9,1,2,1) } }\n");
    }

    void tamedScenesAreDrawn() {
        QFETCH(QByteArray, text);
        writeFile(folder_.path(), "huge.ppm", "P6 1000000 1000000 255\nabc");
        const QString picture = folder_.filePath("tamed.png");
        const ProgramResult result = runCli(
            {"render", file(text), "-o", picture, "-W", "32", "-H", "24", "--picture-limit", "10"}, 30);
        QVERIFY2(result.status == 0, QByteArray::number(result.status) + ' ' + result.errors.left(300));
        QVERIFY(QFile::exists(picture));
        QVERIFY2(!text.contains("huge.ppm") || result.errors.contains("is not shown: it is damaged"),
                 result.errors.left(500));
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

    /// The limit that is in force unless another is asked for.
    void checkHasALimitOfItsOwn() {
        const ProgramResult help = runCli({"check", "--help"});
        QVERIFY2(QString::fromUtf8(help.output).contains(QRegularExpression(R"(--time-limit \S+=20\s)")),
                 help.output);
        const ProgramResult cut = runCli({"check", "--time-limit", "0.05", file(loop("foo bar baz"))}, 20);
        QVERIFY(cut.errors.contains("it has taken 0.05 seconds"));
        QVERIFY(cut.errors.contains("--time-limit"));
    }

    /// What has been read may be work for hours: 4000 noises, and loops of a million steps.
    void workEnds_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        const auto add = [](const QStringList& arguments, int status) {
            QTest::newRow(qPrintable(arguments.join(' '))) << arguments << status;
        };
        // A note, where what is told is true as far as it goes.
        for (const char* command : {"container", "thresholds"}) add({command, "noises.pov"}, 0);
        // What is suspected at the end of the time was looked at a thousand times each, however long that
        // takes.
        for (const char* scene : {"sum.pov", "crackle.pov"}) add({"thresholds", scene}, 0);
        add({"export", "noises.pov", "--note", "-o", "out.inc"}, 0);
        for (const char* command : {"health", "report", "evaluate-advice", "accuracy"})
            add({command, "noises.pov"}, 1);
        add({"accuracy", "--knee", "noises.pov"}, 1);
        add({"mesh", "noises.pov", "-o", "out.stl"}, 1);
        for (const char* command : {"sweep", "sheet"}) {
            QStringList arguments{command, "noises.pov", "--parameter", "Level", "--from", "1", "--to", "2"};
            if (arguments.front() == "sheet")
                arguments << "-o"
                          << "sheet.png";
            add(arguments, 1);
        }
        add({"predict", "noises.pov", "--solver", "lipschitz"}, 1);
        add({"trace", "noises.pov", "--rays", "rays.csv"}, 1);
        for (const char* solver : {"certified", "lipschitz"})
            add({"roots", "--table", "lines.csv", "--solver", solver}, 1);
        for (const char* evaluator : {"reference", "batch"})
            add({"evaluate", "--table", "points.csv", "--evaluator", evaluator}, 1);
    }

    void workEnds() {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        const QByteArray noises = [] {
            QByteArray sum = "Level*0";
            for (int i = 0; i < 4000; ++i)
                sum += "+f_noise3d(x*" + QByteArray::number(1 + i * 1e-4) + ",y,z*9)";
            return sum;
        }();
        const QByteArray loop = "sum(k,1,1000000,sin(k*x)+cos(k*y)*sin(k*z))";
        writeFile(folder_.path(), "noises.pov",
                  "#version 3.7; #include \"functions.inc\"\n#declare Level = 1;\n"
                  "camera { location -5*z look_at 0 }\n"
                  "isosurface { function { " +
                      noises + "-2000 } max_gradient 9000 accuracy 1e-6 }\n");
        writeFile(folder_.path(), "sum.pov", "isosurface { function { " + loop + "-y } }\n");
        writeFile(
            folder_.path(), "crackle.pov",
            "#declare P = function { pattern { crackle metric 3 turbulence 5 octaves 10 scale 0.01 } }\n"
            "isosurface { function { P(x,y,z)-0.3 } contained_by { box { -2, 2 } } }\n");
        writeFile(folder_.path(), "rays.csv",
                  "ox,oy,oz,dx,dy,dz\n" + QByteArray("0.1,0.2,-5,0,0,1\n").repeated(200000));
        writeFile(folder_.path(), "lines.csv",
                  "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz,lipschitz\n"
                  "a,\"" +
                      loop + "\",1e9,\"box{<-1,-1,-1>,<1,1,1>}\",-5,0.1,0.2,1,0.1,0.1,1e12\n");
        writeFile(folder_.path(), "points.csv",
                  "expression,x,y,z\n" + ("\"" + loop + "\",0.1,0.2,0.3\n").repeated(100));
        QElapsedTimer clock;
        clock.start();
        const ProgramResult result =
            runProgram(ISOSCOPE_BINARY_DIR "/isoscope-cli", arguments + QStringList{"--work-limit", "0.1"},
                       20, folder_.path());
        QVERIFY2(result.errors.contains("the time is over (--work-limit 0.1); "), result.errors.left(300));
        QCOMPARE(result.status, status);
        QVERIFY2(clock.elapsed() < 10000, QByteArray::number(clock.elapsed()));
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

    /// A function with 300 periods across the container has a surface in each box: the mesh of as many boxes
    /// as were looked at took 4.7 GB.
    void meshesKeepTheirMemory_data() {
        QTest::addColumn<QByteArray>("function");
        QTest::addColumn<QString>("file");
        const QByteArray sum = "sin(942*x)+sin(942*y)+sin(942*z)",
                         drops = "0.3-sin(942*x)*sin(942*y)*sin(942*z)",
                         waves = "y-0.01*sin(942*x)*sin(942*z)";
        QTest::newRow("a labyrinth") << sum << "a.stl";
        QTest::newRow("drops") << drops << "a.glb";
        QTest::newRow("drops for a printer") << drops << "a.3mf";
        QTest::newRow("waves") << waves << "a.inc";
    }

    void meshesKeepTheirMemory() {
        QFETCH(QByteArray, function);
        QFETCH(QString, file);
        const ProgramResult result =
            runCli({"mesh",
                    this->file("isosurface { function { " + function +
                               " } contained_by { box { -1, 1 } } max_gradient 2000 pigment { bozo } }\n"),
                    "-o", folder_.filePath(file)},
                   120);
        QVERIFY2(result.status == 0, result.errors.left(300));
        QVERIFY2(result.errors.contains("--cells or --memory ended the search"), result.errors.left(300));
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

    /// Nor do many meshes together take more.
    void manyMeshesKeepTheirMemory() {
        const QByteArray one =
            "isosurface { function { sin(60*x)*sin(60*y)*sin(60*z)-N/100 } contained_by { box { -1, 1 } } "
            "}\n";
        const ProgramResult result = runCli({"mesh", file("#for (N, 1, 80) " + one + "#end\n"), "-o",
                                             folder_.filePath("many.stl"), "--memory", "100"},
                                            120);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.errors.contains("the mesh would take more than 100 MB of memory"),
                 result.errors.left(300));
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

    void drawingEnds_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("solver");
        const QByteArray view =
            "#version 3.7; camera { location -5*z look_at 0 } light_source { <5,5,-5>, 1 }\n";
        QTest::newRow("section 2: accuracy 1e-300, max_gradient 1e300")
            << view +
                   "isosurface { function { x*x+y*y+z*z-1 } contained_by { box { -2, 2 } } accuracy 1e-300\n"
                   "  max_gradient 1e300 pigment { rgb 1 } }\n"
            << QString("lipschitz");
        QTest::newRow("section 2: sums of 1e12 terms")
            << view +
                   "isosurface { function { sum(i,1,1e4,sum(j,1,1e4,sum(k,1,1e4,sin(i*x+j*y+k*z))))-1 }\n"
                   "  contained_by { box { -1, 1 } } pigment { rgb 1 } }\n"
            << QString("certified");
        QTest::newRow("section 2: blur_samples")
            << QByteArray(
                   "#version 3.7; camera { location -5*z look_at 0 aperture 1 blur_samples 100000\n"
                   "  variance 0 focal_point 0 } sphere { 0, 3 pigment { granite } }\n")
            << QString("lipschitz");
    }

    void drawingEnds() {
        QFETCH(QByteArray, text);
        QFETCH(QString, solver);
        const ProgramResult result = runCli({"render", file(text), "-o", folder_.filePath("out.png"), "-W",
                                             "160", "-H", "120", "--solver", solver, "--picture-limit", "2"},
                                            20);
        QVERIFY2(result.status == 1, QByteArray::number(result.status) + ' ' + result.errors.left(300));
        QVERIFY2(result.errors.contains("drawing was cut off after 2 seconds"), result.errors.left(300));
        QVERIFY(QFile::exists(folder_.filePath("out.png")));
    }

    /// What was left of the largest picture was cleared, encoded and written strip by strip for minutes when
    /// its time was over.
    void hugePicturesEnd_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("told");
        QTest::addColumn<bool>("written");
        const QByteArray cut = "drawing was cut off after 1 seconds, ";
        QTest::newRow("PNG") << QStringList{"-o", "huge.png"} << cut + "the rest of the picture is black"
                             << true;
        QTest::newRow("deep PNG") << QStringList{"-o", "deep.png", "--depth", "16", "--transparent"}
                                  << cut + "the rest of the picture is black" << true;
        QTest::newRow("OpenEXR") << QStringList{"-o", "huge.exr"} << cut + "there is no picture" << false;
        for (const char* map : {"--hole-map", "--cost-map"})
            QTest::newRow(map) << QStringList{"-o", "other.png", map, "map.png"}
                               << QByteArray("at most 16777216 pixels") << false;
    }

    void hugePicturesEnd() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, told);
        QFETCH(bool, written);
        file(
            "camera { location -4*z look_at 0 } light_source { <-3,5,-6> 1 }\n"
            "isosurface { function { x*x+y*y+z*z-1 } max_gradient 4 pigment { rgb 1 } }\n");
        QElapsedTimer clock;
        clock.start();
        const ProgramResult result = runProgram(
            ISOSCOPE_BINARY_DIR "/isoscope-cli",
            QStringList{"render", "attack.pov", "-W", "131072", "-H", "131072", "--picture-limit", "1"} +
                arguments,
            60, folder_.path());
        QVERIFY2(result.status > 0 && result.errors.contains(told), result.errors.left(300));
        QCOMPARE(QFile::exists(folder_.filePath(arguments[1])), written);
        QVERIFY2(clock.elapsed() < 20000, QByteArray::number(clock.elapsed()));
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }

    /// The largest picture that has maps.
    void mapsKeepTheirMemory() {
        for (const QString map : {"--hole-map", "--cost-map"}) {
            const ProgramResult result =
                runCli({"render", file("sphere { 0, 1 }\n"), "-o", folder_.filePath("a.png"), map,
                        folder_.filePath("map.png"), "-W", "4096", "-H", "4096"},
                       120);
            QVERIFY2(result.status == 0, result.errors.left(300));
        }
        QVERIFY2(peakOfChildren() < 1000, QByteArray::number(qlonglong(peakOfChildren())) + " MB");
    }
};

QTEST_GUILESS_MAIN(AttackTest)
#include "attack_test.moc"
