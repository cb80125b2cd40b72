// SPDX-License-Identifier: GPL-3.0-or-later
// No text may crash or hang the reader, and none that is wrong may pass silently.
#include <QElapsedTimer>
#include <QTest>
#include <random>

#include "core/exchange/virtualight_export.h"
#include "tests/virtualight/example_texts.h"

using namespace isoscope;

namespace {

const std::vector<std::string>& words() {
    static const std::vector<std::string> list{"Shape",
                                               "Solid",
                                               "Declare",
                                               "static",
                                               "[",
                                               "]",
                                               "(",
                                               ")",
                                               "{",
                                               "}",
                                               ",",
                                               ",",
                                               ",",
                                               "=",
                                               "+",
                                               "-",
                                               "*",
                                               "/",
                                               "^",
                                               "&",
                                               "~",
                                               ":",
                                               ";",
                                               ".",
                                               "1",
                                               "0",
                                               "2.5",
                                               "3",
                                               "4",
                                               "1e300",
                                               "0.001",
                                               "-1",
                                               "x",
                                               "y",
                                               "z",
                                               "u",
                                               "v",
                                               "phi",
                                               "theta",
                                               "A",
                                               "B",
                                               "sin",
                                               "exp",
                                               "sqrt",
                                               "radians",
                                               "CurrentFrame",
                                               "Po",
                                               "UV",
                                               "ON",
                                               "OFF",
                                               "\"hftest.tga\"",
                                               "SmoothNormal",
                                               "Sphere",
                                               "Box",
                                               "Cone",
                                               "Cylinder",
                                               "Disk",
                                               "Ring",
                                               "Torus",
                                               "Plane",
                                               "Paraboloid",
                                               "Superquadric",
                                               "Polygon",
                                               "TriangularPatch",
                                               "Blobby",
                                               "ExtrudedSurface",
                                               "SurfaceOfRevolution",
                                               "BicubicPatch",
                                               "NURBS",
                                               "ImplicitSurface",
                                               "PolynomialSurface",
                                               "ParametricSurface",
                                               "ImplicitPlanarHeightField",
                                               "ImplicitSphericalHeightField",
                                               "PlanarHeightField",
                                               "SphericalHeightField",
                                               "Rotate",
                                               "Translate",
                                               "Scale",
                                               "Bound",
                                               "RenderBound",
                                               "ShapeSubdivision",
                                               "FerrariSolver",
                                               "VietaSolver",
                                               "SturmSolver",
                                               "Chrome",
                                               "Camera",
                                               "(0,0,0)",
                                               "(1,2,3)",
                                               "{0,1}"};
    return list;
}

void check(const std::string& text) {
    QElapsedTimer timer;
    timer.start();
    const ParseResult parsed = test::readText(text);
    QVERIFY(parsed.scene && parsed.sources && parsed.symbols);
    if (parsed.ok()) QVERIFY(!exportVirtualight(parsed, parsed.scene->camera).text.empty());
    if (timer.elapsed() > 20'000) qWarning("%lld ms for %s", timer.elapsed(), text.c_str());
}

std::string fileText(const QString& name) {
    QFile file(test::exampleFolder() + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace

class RandomTextTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        seed_ = std::random_device{}();
        qInfo("seed %u", seed_);
        random_.seed(seed_);
    }

    void randomTokens() {
        for (int k = 0; k < 3000; ++k) {
            std::string text;
            const std::size_t count = 1 + random_() % 60;
            for (std::size_t i = 0; i < count; ++i) text += words()[random_() % words().size()] + " ";
            check(text);
        }
    }

    void randomBytes() {
        for (int k = 0; k < 300; ++k) {
            std::string text(random_() % 2000, ' ');
            for (char& c : text) c = static_cast<char>(random_());
            check(text);
        }
    }

    /// Examples with pieces taken out, doubled, exchanged or replaced.
    void damagedExamples() {
        for (const QString& name : test::exampleNames()) {
            const std::string whole = fileText(name);
            QVERIFY(!whole.empty());
            for (int k = 0; k < 40; ++k) {
                std::string text = whole;
                for (std::size_t step = 0, steps = 1 + random_() % 3; step < steps && !text.empty(); ++step) {
                    const std::size_t at = random_() % text.size(), length = random_() % 12;
                    switch (random_() % 3) {
                        case 0: text.erase(at, length); break;
                        case 1: text.insert(at, words()[random_() % words().size()]); break;
                        default: text.insert(at, text.substr(random_() % text.size(), length)); break;
                    }
                }
                check(text);
            }
        }
    }

    void everyBeginningOfAnExample() {
        for (const QString name :
             {"csg_nested.vl", "nurbs.vl", "extruded_surface.vl", "triangular_patch.vl"}) {
            const std::string text = fileText(name);
            for (std::size_t size = 0; size < text.size(); ++size) check(text.substr(0, size));
        }
    }

    void deepAndLongTexts_data() {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("around");
        QTest::addRow("parentheses") << "("
                                     << "Declare a = %1";
        QTest::addRow("signs") << "-"
                               << "Declare a = %1 1";
        QTest::addRow("powers") << "2^"
                                << "Declare a = %1 1";
        QTest::addRow("sums") << "x+"
                              << "Declare a = %1 1";
        QTest::addRow("calls") << "sin("
                               << "Declare a = %1 x";
        QTest::addRow("solids") << "Solid [ "
                                << "%1";
        QTest::addRow("brackets") << "( "
                                  << "Solid [ %1";
        QTest::addRow("inverses") << "~"
                                  << "Solid [ %1 Shape [ Sphere((0,0,0), 1) ] ]";
        QTest::addRow("closers") << "] ) }"
                                 << "%1";
        QTest::addRow("declarations") << "Declare a = x*x + y\n"
                                      << "%1";
    }
    void deepAndLongTexts() {
        QFETCH(QString, unit);
        QFETCH(QString, around);
        check(around.arg(unit.repeated(20'000)).toStdString());
    }

    /// Each line doubles the one before: the reader says that it is too much.
    void doublingSolidsEnd() {
        std::string text = "Declare A0 = Shape [ Sphere((0,0,0), 1) ]\n";
        for (int k = 1; k < 40; ++k)
            text += "Declare A" + std::to_string(k) + " = Solid [ A" + std::to_string(k - 1) + " + A" +
                    std::to_string(k - 1) + " ]\n";
        const ParseResult parsed = test::readText(text);
        QVERIFY(!parsed.ok());
        QVERIFY(test::messages(parsed, Severity::error).find("more than 200000 parts") != std::string::npos);
    }

    void doublingExpressionsEnd() {
        std::string text = "Declare a0 = x + y*z\n";
        for (int k = 1; k < 3000; ++k)
            text += "Declare a" + std::to_string(k) + " = a" + std::to_string(k - 1) + " * sin(a" +
                    std::to_string(k - 1) + " + x)\n";
        check(text + "Shape [ ImplicitSurface(a2999) Bound((-1,-1,-1), (1,1,1)) ]");
    }

  private:
    unsigned seed_ = 0;
    std::mt19937 random_;
};

QTEST_GUILESS_MAIN(RandomTextTest)
#include "random_text_test.moc"
