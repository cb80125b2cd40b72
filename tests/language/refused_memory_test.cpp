// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTest>

#include "core/language/directives/library_paths.h"
#include "core/language/parse.h"
#include "core/virtualight/scene_reader.h"
#include "test_folders.h"
#include "tests/support/refusing_new.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const char* const everything = R"(#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1 }
#declare Size = 1.5; // [0:2]
#macro Ball(P, R) sphere { P, R pigment { color rgb <1, 0.5, 0> } } #end
#declare F = function(x, y, z) { x*x + y*y + z*z - f_noise3d(x, y, z)*Size }
#declare A = array[3] { 1, <2, 3, 4>, "text" }
#declare S = spline { cubic_spline 0, <0, 0, 0> 1, <1, 1, 1> 2, <2, 0, 1> 3, <3, 1, 0> };
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-3, 5, -6> rgb 1 spotlight }
#for (I, 1, 3) Ball(<I, 0, 0>, I/4) #end
isosurface { function { F(x, y, z) } contained_by { box { -2, 2 } } max_gradient 4
  texture { pigment { granite color_map { [0 rgb 0] [1 rgb 1] } } normal { bumps 0.5 } finish { phong 1 } } }
difference { box { -1, 1 } sphere { S(0.5), Size } pigment { checker rgb 1, rgb 0 } }
blob { threshold 0.5 sphere { 0, 1, 1 } cylinder { 0, x, 1, 1 } }
mesh { triangle { 0, x, y } triangle { x, y, z } }
lathe { linear_spline 3, <0, 0>, <1, 1>, <0, 2> }
text { ttf "timrom.ttf", concat("a", str(Size, 0, 1)), 1, 0 }
#fopen O "a.txt" write #write (O, A[1], strupr("b")) #fclose O
sky_sphere { pigment { gradient y } } fog { distance 9 }
#warning "said"
sphere { unknown_name, 1 }
)";

/// Whether memory was refused, whether reading told of that, and what it gave.
struct Reading {
    bool refused = false;
    bool told = false;
    std::string result;

    void add(const Diagnostics& diagnostics, const SourceLibrary& sources) {
        for (const Diagnostic& said : diagnostics) {
            told = told || said.id == "out-of-resources";
            result += toReport(said, sources);
        }
    }
};

Reading readingOf(const ParseResult& parsed, bool refused) {
    // Whatever happened, there are a scene, sources and names to go on with.
    if (!parsed.scene || !parsed.sources || !parsed.symbols) qFatal("a result without its parts");
    Reading reading{refused, false, std::to_string(parsed.scene->objects.size()) + " objects\n"};
    for (const auto& [name, content] : parsed.writtenFiles) reading.result += name + ": " + content + '\n';
    reading.add(parsed.diagnostics, *parsed.sources);
    return reading;
}

}  // namespace

/// Memory that is refused at any one moment of reading: an answer with a message, never a crash. What is
/// kept from before the refusal is whole.
class RefusedMemoryTest : public QObject {
    Q_OBJECT

    /// Refuses the 1st, 2nd, ... allocation of `read`: the first 2000 one by one, then fewer. What does not
    /// tell of it has to have the result of every day.
    template <class Read>
    static void refuseEach(const Read& read) {
        read(-1);  // what is made once, is made
        asked = 0;
        const Reading usual = read(-1);
        const long all = asked;
        QVERIFY2(!usual.told, usual.result.c_str());
        int told = 0, silent = 0;
        for (long at = 0; at < all; at += at < 2000 ? 1 : 1 + at / 200) {
            const Reading reading = read(at);
            if (!reading.refused) break;  // it took another way, with fewer allocations
            if (!reading.told)
                QVERIFY2(reading.result == usual.result,
                         ("allocation " + std::to_string(at) + ": " + reading.result).c_str());
            ++(reading.told ? told : silent);
        }
        qInfo("%ld allocations; refused: %d told, %d with the usual result", all, told, silent);
        QVERIFY(all > 10 && told > 0);
    }

  private slots:
    void scenes() {
        refuseEach([](long at) {
            ParseOptions options;
            options.file = "scene.pov";
            options.libraryPaths = installedLibraryPaths();
            std::string text = everything;
            bool refused = false;
            const ParseResult parsed =
                refusing(at, refused, [&] { return parseScene(std::move(text), std::move(options)); });
            return readingOf(parsed, refused);
        });
    }

    void functions() {
        const std::string body = "sum(i,1,9,i*x)+F(x,y,z)+f_torus(x,y,z,1,0.2)",
                          prelude = "#declare F = function { sin(x)*y+select(z,1,2) }";
        refuseEach([&](long at) {
            Reading reading;
            const ParsedFunction parsed =
                refusing(at, reading.refused, [&] { return parseFunction(body, prelude); });
            reading.result = parsed.ok() ? "a function\n" : "no function\n";
            reading.add(parsed.diagnostics, *parsed.sources);
            return reading;
        });
    }

    void virtualightScenes() {
        QFile file(QStringLiteral(ISOSCOPE_SOURCE_DIR "/examples/set_operators.vl"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const std::string text = file.readAll().toStdString();
        refuseEach([&](long at) {
            ParseOptions options;
            options.file = "scene.vl";
            std::string copy = text;
            bool refused = false;
            const ParseResult parsed = refusing(at, refused, [&] {
                return virtualight::parseVirtualight(std::move(copy), std::move(options));
            });
            return readingOf(parsed, refused);
        });
    }
};

QTEST_APPLESS_MAIN(RefusedMemoryTest)
#include "refused_memory_test.moc"
