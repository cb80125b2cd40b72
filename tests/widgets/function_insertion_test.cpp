// SPDX-License-Identifier: GPL-3.0-or-later
// New, then insert: every function of the list is seen whole, without holes, and POV-Ray renders the text.
#include "widgets/functions/function_insertion.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/view/surface_bounds.h"
#include "test_folders.h"
#include "tests/support/scene_picture.h"
#include "widgets/editor/text_outline.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr int width = 124, height = 80;

std::string newText() {
    QFile file(QStringLiteral(ISOSCOPE_SOURCE_DIR "/resources/templates/new.pov"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

std::string changed(std::string text, const FunctionInsertion& insertion) {
    for (auto change = insertion.changes.rbegin(); change != insertion.changes.rend(); ++change)
        text.replace(static_cast<std::size_t>(change->begin),
                     static_cast<std::size_t>(change->end - change->begin),
                     change->replacement.toStdString());
    return text;
}

/// The text with a function in it, as Insert makes it.
std::string inserted(const char* function, const std::string& text, std::size_t caret) {
    return changed(text,
                   insertStatement(*findBuiltin(std::string_view(function)), parseScene(text), text, caret));
}

/// How much of a picture shows something else than `nothing`, and whether that touches the picture's edge.
struct Sight {
    double share = 0;
    bool cut = false;
};

Sight sightOf(const Image& picture, const Image& nothing) {
    Sight sight;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * picture.width + x;
            if (picture.pixels[at] == nothing.pixels[at]) continue;
            sight.share += 1.0 / static_cast<double>(picture.pixels.size());
            sight.cut |= x == 0 || y == 0 || x + 1 == picture.width || y + 1 == picture.height;
        }
    return sight;
}

}  // namespace

class FunctionInsertionTest : public QObject {
    Q_OBJECT

    std::vector<std::string> texts_;  // of New, then insert, by the function's number
    std::vector<Image> theirs_;       // what POV-Ray makes of them

    /// All by one run of POV-Ray, each a frame of an animation.
    void askPovray() {
        const QTemporaryDir folder;
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            QFile file(folder.filePath(QString("%1.inc").arg(i + 1)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(texts_[i].data(), static_cast<qint64>(texts_[i].size()));
        }
        QFile all(folder.filePath("all.pov"));
        QVERIFY(all.open(QIODevice::WriteOnly));
        all.write("#version 3.7;\n#include concat(str(frame_number, 0, 0), \".inc\")\n");
        all.close();
        theirs_ = povrayFrames(all.fileName(), {width, height, {}, {folder.path()}},
                               static_cast<int>(texts_.size()));
    }

  private slots:
    void initTestCase() {
        const std::string start = newText();
        QVERIFY(!start.empty());
        for (const Builtin& builtin : builtins())
            if (!builtin.name.empty()) texts_.push_back(inserted(builtin.name.c_str(), start, start.size()));
        QCOMPARE(texts_.size(), std::size_t(109));
        if (!hasPovray()) return qInfo(povrayIsMissing);
        askPovray();
        QCOMPARE(theirs_.size(), texts_.size());
    }

    void everyFunctionIsSeenWhole_data() {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const Builtin& builtin : builtins())
            if (!builtin.name.empty()) QTest::newRow(builtin.name.c_str()) << number++;
    }
    void everyFunctionIsSeenWhole() {
        QFETCH(int, number);
        const QString name = QTest::currentDataTag();
        ParseOptions options;
        options.imageWidth = width;
        options.imageHeight = height;
        const std::string& text = texts_[static_cast<std::size_t>(number)];
        const ParseResult parsed = parseScene(text, options);
        QVERIFY2(parsed.diagnostics.empty(), problems(parsed).c_str());
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
        const Isosurface& surface = *parsed.scene->isosurfaces.front().shape;
        const double setting = surface.rootSettings().maxGradient;

        // As POV-Ray draws it in this size.
        RenderStatistics statistics;
        const Image drawn = renderImage(requestFor(parsed, width, height), 0, &statistics);
        const double alongRays = statistics.gradients.front().steepest;
        double likeness = 1;
        if (!theirs_.empty()) {
            const Image& theirs = theirs_[static_cast<std::size_t>(number)];
            keepPictures("insert-" + name, drawn, theirs);
            likeness = comparePictures(drawn, theirs).shareWithin8;
        }
        // As the window shows it: what a picture of 4 to 3 holds, and more to the sides.
        RenderRequest request = requestFor(parseScene(text), width, height);
        request.camera.right *= (double(width) / height) / (4.0 / 3);
        request.rootFinder = RootFinder::certified;
        const Image exact = renderImage(request);
        request.scene = parseScene(newText()).scene;
        const Sight sight = sightOf(exact, renderImage(request));

        GradientStudy study(surface.tape(), *parsed.scene->parameterTable, surface.settings().container,
                            {0.02, 100'000});
        const GradientBracket& bracket = study.run();
        const GradientVerdict verdict = judgeGradient(setting, bracket, alongRays);
        qInfo("%-24s %5.1f %% %s  %-9s %8g in [%.4g, %.4g], along rays %.4g; like POV-Ray's %.1f %%",
              qPrintable(name), 100 * sight.share, sight.cut ? "CUT  " : "whole",
              std::string(isoscope::name(verdict)).c_str(), setting, bracket.lower, bracket.upper, alongRays,
              100 * likeness);
        QVERIFY(!sight.cut);
        QVERIFY2(sight.share >= 0.15 && sight.share <= 0.85, qPrintable(QString::number(sight.share)));
        // Places where the slope has no bound, or none is known (marble and wood jump by 2e-5); and jumps
        // that the proof can neither find nor exclude, though POV-Ray's pictures of them have no holes.
        static const QStringList boundless = {"f_comma",  "f_helical_torus", "f_helix1",
                                              "f_spiral", "f_marble",        "f_wood"};
        static const QStringList seams = {"f_waves", "f_hex_x", "f_hex_y", "f_mesh1"};
        const bool unproven = verdict == GradientVerdict::unproven;
        QVERIFY(verdict == GradientVerdict::right || (unproven && seams.contains(name)) ||
                ((unproven || verdict == GradientVerdict::unbounded) && boundless.contains(name)));
        QVERIFY(likeness >= 0.97);
    }

    /// D5: the caret of a new or just opened text stands in line 1, before the includes.
    void statementsComeBehindTheIncludes_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("wanted");  // "@": the statement, "#": the include, "L": lights
        const auto row = [](const char* name, const char* text, const char* wanted) {
            QTest::newRow(name) << QString(text) << QString(wanted);
        };
        row("caret in line 1", "|// A\n#include \"functions.inc\"\nL\n", "// A\n#L\n@");
        row("before an include", "#version 3.7;\nL\n|\n#include \"functions.inc\"\nL\n",
            "#version 3.7;\nL\n\n#L\n@");
        row("between statements", "#include \"functions.inc\"\nL\nL // |\nL\n", "#L\nL // \n@L\n");
        row("in a statement", "#include \"functions.inc\"\nL\nunion {\n sphere { 0, 1| }\n}\n// end\n",
            "#L\nunion {\n sphere { 0, 1 }\n}\n@// end\n");
        row("in a macro", "#include \"functions.inc\"\nL\n#macro M()\n L|\n#end\nM()",
            "#L\n#macro M()\n L\n#end\n@M()");
        row("in a declaration", "#include \"functions.inc\"\nL\n#declare F =|\nfunction { x }\nL",
            "#L\n#declare F =\nfunction { x }\n@L");
        row("before its brace", "#include \"functions.inc\"\nL\nsphere|\n{ 0, 1 }\nL",
            "#L\nsphere\n{ 0, 1 }\n@L");
        row("in a comment", "#include \"functions.inc\"\nL\n/* |\n*/\nL", "#L\n/* \n*/\n@L");
        row("no include", "// A\n#version 3.7;\nL\n|L", "// A\n#version 3.7;\n#L\nL\n@");
        row("no version", "// A\n\nL\n|L\n", "// A\n\n#L\nL\n@");
    }
    void statementsComeBehindTheIncludes() {
        QFETCH(QString, text);
        QFETCH(QString, wanted);
        const QString light = "light_source { 9 rgb 1 } camera { location -3*z look_at 0 }";
        text.replace('L', light);
        const qsizetype caret = text.indexOf('|');
        text.remove('|');
        const std::string before = text.toStdString();
        const Builtin& torus = *findBuiltin(std::string_view("f_torus"));
        const ParseResult parsed = parseScene(before);
        const FunctionInsertion insertion =
            insertStatement(torus, parsed, before, static_cast<std::size_t>(caret));
        const std::string after = changed(before, insertion);
        const std::size_t begin = after.find("isosurface {");
        QVERIFY(begin != std::string::npos);
        const std::size_t end = after.find("\n}\n", begin) + 3;
        QCOMPARE(insertion.caret, static_cast<int>(end));
        std::string got = after.substr(0, begin) + "@" + after.substr(end);
        const auto shorten = [&](const std::string& what, const char* mark) {
            for (std::size_t at; (at = got.find(what)) != std::string::npos;)
                got.replace(at, what.size(), mark);
        };
        shorten("#include \"functions.inc\"\n", "#");
        static const QRegularExpression camera("camera \\{[^}]*\\}");
        got = QString::fromStdString(got).replace(camera, "C").toStdString();
        shorten("light_source { 9 rgb 1 } C", "L");
        QCOMPARE(QString::fromStdString(got), wanted);
        const ParseResult result = parseScene(after);
        for (const Diagnostic& diagnostic : result.diagnostics)
            QVERIFY(diagnostic.severity == Severity::note);
    }

    void aBareTextGetsAllThatIsNeeded() {
        const std::string text = inserted("f_heart", "", 0);
        const ParseResult parsed = parseScene(text);
        for (const char* part : {"#include \"functions.inc\"", "camera {", "light_source {", "isosurface {"})
            QVERIFY2(text.find(part) != std::string::npos, part);
        QVERIFY(parsed.ok() && parsed.scene->cameraRange);
    }

    /// Everything that is inserted stands beside what is there, and is of its size.
    void nothingIsInsertedIntoAnother() {
        std::string text = newText() + "sphere { <0, 0, 0>, 100 pigment { rgb 1 } }\n";
        std::vector<Bounds> boxes;
        for (const char* function : {"f_torus", "f_heart", "f_brick"}) {
            text = inserted(function, text, text.size());
            const ParseResult parsed = parseScene(text);
            QVERIFY2(parsed.diagnostics.empty(), problems(parsed).c_str());
            boxes.clear();
            for (const SceneObject& object : parsed.scene->objects) {
                auto alone = std::make_shared<Scene>(*parsed.scene);
                alone->objects = {object};
                boxes.push_back(SurfaceBounds(alone).box());
            }
        }
        QCOMPARE(boxes.size(), std::size_t(4));
        for (std::size_t i = 1; i < boxes.size(); ++i) {
            QVERIFY(boxes[i].low.x > boxes[i - 1].high.x);
            const double size = boxes[i].high.x - boxes[i].low.x;
            QVERIFY2(size > 40 && size < 800, qPrintable(QString::number(size)));
        }
        // The text's camera is its own matter once something is there.
        QVERIFY(text.find("location <2.4, 1.8, -3.2>") != std::string::npos);
    }

    void callsComeWithTheirInclude() {
        const std::string text = "#version 3.7;\nisosurface { function { } }\n";
        const std::size_t caret = text.find("{ }") + 2;
        const FunctionInsertion insertion =
            insertCall(*findBuiltin(std::string_view("f_sphere")), text, caret, caret);
        const std::string after = changed(text, insertion);
        QCOMPARE(QString::fromStdString(after), QString("#version 3.7;\n#include \"functions.inc\"\n"
                                                        "isosurface { function { f_sphere(x, y, z, 1)} }\n"));
        QCOMPARE(insertion.caret, static_cast<int>(after.find(")}")) + 1);
    }
};

QTEST_GUILESS_MAIN(FunctionInsertionTest)
#include "function_insertion_test.moc"
