// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <QTest>

#include "core/language/parse.h"
#include "tests/virtualight/example_texts.h"

using namespace isoscope;

namespace {

std::string errorsOf(const std::string& text) {
    return test::messages(test::readText(text), Severity::error);
}

/// Whether the ray along +z through (x, y), begun far in front, meets the only object, and where.
double depthAt(const ParseResult& parsed, double x, double y, double fallback = NAN) {
    TraceContext context(parsed.scene->parameterTable, RootFinder::certified);
    double nearest = fallback;
    for (const SceneObject& object : parsed.scene->objects) {
        HitList hits;
        object.shape->intersect({{x, y, -1000}, {0, 0, 1}}, {0, 1e9}, context, hits);
        if (!hits.empty() && !(hits.front().point.z >= nearest)) nearest = hits.front().point.z;
    }
    return nearest;
}

bool contains(const ParseResult& parsed, const glm::dvec3& point) {
    TraceContext context(parsed.scene->parameterTable, RootFinder::certified);
    for (const SceneObject& object : parsed.scene->objects)
        if (object.shape->contains(point, context)) return true;
    return false;
}

const SceneParameter* sliderAt(const ParseResult& parsed, std::size_t place) {
    for (const SceneParameter& parameter : parsed.scene->parameters)
        if (parameter.range.file == 0 && parameter.range.begin <= place && place < parameter.range.end)
            return &parameter;
    return nullptr;
}

}  // namespace

class DocumentParserTest : public QObject {
    Q_OBJECT

  private slots:
    void notationIsKnownByEndingOrContent_CONF_81() {
        using virtualight::isVirtualight;
        QVERIFY(isVirtualight("a.vl", ""));
        QVERIFY(isVirtualight("dir/statics.VIB", "anything"));
        QVERIFY(!isVirtualight("a.pov", "Shape [ Sphere((0,0,0), 1) ]"));
        QVERIFY(isVirtualight("", "// a comment\nShape [ Sphere((0,0,0), 1) ]"));
        QVERIFY(isVirtualight("text.txt", "Solid [ A + B ]"));
        QVERIFY(isVirtualight("", "Declare A = 3"));
        QVERIFY(isVirtualight("", "static A = 3"));
        QVERIFY(!isVirtualight("", "#declare A = 3;"));
        QVERIFY(!isVirtualight("", "sphere { 0, 1 }"));
        QVERIFY(!isVirtualight("", ""));
    }

    void constantsOfTheArchiveFile_VL_GEN() {
        // Each stands for its number, with and without being declared.
        const char* text =
            "Shape [ Sphere((0,0,0), BEZIER + 10*BSPLINE + 100*CATMULLROM + 1000*HERMITE + 0.1*STRAIGHT + "
            "0.01*POLYNOMIAL + 0.001*CONDITIONAL + OFF + 10000*ON) ]";
        const double radius = 14321 + 0.1 + 0.02 + 0.003;
        const ParseResult parsed = test::readText(text);
        QVERIFY(parsed.ok());
        QVERIFY(contains(parsed, {radius - 1e-6, 0, 0}));
        QVERIFY(!contains(parsed, {radius + 1e-6, 0, 0}));
    }

    void expressions_VL_GEN_CONF_82_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        const auto add = [](const char* text, double value) {
            QTest::newRow(text) << QString(text) << value;
        };
        add("1/1024 + 1", 1 + 1.0 / 1024);
        add("(2/3) + 2^3^0.5", 2.0 / 3 + std::pow(2, std::sqrt(3.0)));
        add("5 - -2^2", 9);
        add("-2^2 + 10", 6);
        add("2 - 3 - 4 + 10", 5);
        add("24/2/3", 4);
        add("sqrt(16)*cos(0) + sin(0) + exp(0)", 5);
        add("1 + radians(180)", 1 + M_PI);
        add("1 + degrees(PI)", 181);
        add("2*PI_TWO", M_PI);
        add("max(2, min(5, 3)) + mod(7, 4)", 6);
        add("1 + CurrentFrame", 8);
        add("2^-1 + 1", 1.5);
        add("(2)^40 / 2^39", 2);
    }
    void expressions_VL_GEN_CONF_82() {
        QFETCH(QString, text);
        QFETCH(double, value);
        ParseOptions options;
        options.frameNumber = 7;
        const ParseResult parsed =
            virtualight::parseVirtualight("Shape [ Sphere((0,0,0), " + text.toStdString() + ") ]", options);
        QVERIFY2(parsed.ok(), test::messages(parsed, Severity::error).c_str());
        QVERIFY(std::abs(depthAt(parsed, 0, 0) + value) < 1e-9 * value);
    }

    void mistakes_VL_POLYGON_VL_SPHERE_CONF_69_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto add = [](const char* text, const char* message) {
            QTest::newRow(text) << QString(text) << QString(message);
        };
        add("Shape [ Sphere((0,0,0), 0) ]", "1:25: error: The radius of `Sphere` must be greater than 0.");
        add("Shape [ Sphere((0,0,0), -1) ]", "1:25: error: The radius of `Sphere` must be greater than 0.");
        add("Shape [ Spere((0,0,0), 1) ]", "did you mean `Sphere`?");
        add("Shape [ Sphere((0,0,0), r1) ]", "1:25: error: `r1` has no value.");
        add("Shape [ Sphere((0,0,0), x) ]", "`x` has no value in this place");
        add("Shape [ Sphere((0,0,0), 1/0) ]", "infinite, undefined or too large");
        add("Shape [ Sphere((0,0,0), 1 ]", "Expected `)` to close the arguments of `Sphere`");
        add("Shape [ Sphere((0,0), 1) ]", "Expected `,` between the numbers of the center");
        add("Shape [ Sphere((0,0,0), 1)", "Expected `]` to close `Shape`");
        add("Shape [ Sphere((0,0,0), 1) Sphere((0,0,0), 2) ]", "One Shape holds one primitive.");
        add("Shape [ ]", "A Shape begins with a primitive.");
        add("Sphere((0,0,0), 1)", "must stand in a Shape");
        add("Shape [ Disk((0,0,0), (0,0,0), 1) ]", "must have a length");
        add("Shape [ Ring((0,0,0), (0,1,0), 1, 2) ]", "leaves nothing of it");
        add("Shape [ Cone((0,0,0), 1, (0,0,0), 1) ]", "The ends of the axis must differ.");
        add("Shape [ Superquadric(0, 1) ]", "must be greater than 0");
        add("Shape [ Polygon(2, (0,0,0), (1,0,0)) ]", "is a whole number from 3 to 32");
        add("Shape [ Polygon(33, (0,0,0), (1,0,0)) ]", "is a whole number from 3 to 32");
        add("Shape [ Polygon(4, (0,0,0), (1,0,0), (0,1,0)) ]", "says 4 vertices, but has 3");
        add("Shape [ Polygon(4, (0,0,0), (1,0,0), (1,1,0), (0,1,1)) ]", "must lie in one plane");
        add("Shape [ Blobby(0.5, Sphere((0,0,0), 1, 1)) ]", "at least two components");
        add("Shape [ Blobby(0.5, Box((0,0,0), (1,1,1))) ]", "components are Sphere, Cylinder and Plane");
        add("Shape [ ExtrudedSurface(STRAIGHT, 3, (0,0,1), {0,0}, {1,0}) ]", "says 3 points, but has 2");
        add("Shape [ ExtrudedSurface(STRAIGHT, 1, (0,0,1), {0,0}) ]", "whole number from 2 to");
        add("Shape [ ExtrudedSurface(4, 2, (0,0,1), {0,0}, {1,0}) ]", "whole number from 1 to 3");
        add("Shape [ BicubicPatch(BEZIER, 0, 4, (0,0,0)) ]", "whole number from 1 to");
        add("Shape [ NURBS(3, 4, [0,0,0,1,1,1,1]) ]", "at least as many control points");
        add("Shape [ NURBS(4, 4, [0,0,0,0,1,1,1]) ]", "need 8 knots, but here are 7");
        add("Shape [ NURBS(4, 4, [0,0,0,0,1,1,2,1]) ]", "must not decrease");
        add("Shape [ NURBS(2, 2, [0,0,1,1], 2, 2, [0,0,1,1], [[(0,0,0),(1,0,0)],[(0,1,0,0),(1,1,0)]]) ]",
            "weight of a control point must be greater than 0");
        add("Shape [ ImplicitSurface(x + y) ]", "needs a Bound");
        add("Shape [ ImplicitSurface(u) Bound((0,0,0), (1,1,1)) ]", "`u` has no value in `ImplicitSurface`");
        add("Shape [ PolynomialSurface(sin(x)) ]", "`sin` makes no polynomial");
        add("Shape [ PolynomialSurface(x^22 + y) ]", "order of a polynomial surface is 21 at most");
        add("Shape [ PolynomialSurface(x/y) ]", "only be divided by a number");
        add("Shape [ PolynomialSurface(3) ]", "the same everywhere");
        add("Shape [ ParametricSurface(u, v, w) ]", "`w` has no value");
        add("Shape [ ParametricSurface(u, v, 0) RenderBound(1, 0, 0, 1) ]", "umin, umax, vmin, vmax");
        add("Shape [ ImplicitPlanarHeightField(1, 0, 0, 1, x, 4, 4) ]", "xmin, xmax, zmin, zmax");
        add("Shape [ ImplicitPlanarHeightField(0, 1, 0, 1, Po, 4, 4) ]", "write `Po.x`, `Po.y` or `Po.z`");
        add("Shape [ PlanarHeightField(\"nothere.tga\") ]", "was not found");
        add("Solid [ A ]", "1:9: error: `A` is not declared");
        add("Declare A = 3\nSolid [ A ]", "`A` is no shape");
        add("Solid [ Shape [ Sphere((0,0,0), 1) ] + ]", "Expected a Shape, a Solid or the name of one");
        add("Shape [ Sphere((0,0,0), 1) Bound((0,0,0), (0,1,1)) ]", "must differ in x, y and z");
        add("Shape [ Sphere((0,0,0), foo(1)) ]", "There is no function `foo`");
        add("Shape [ ImplicitPlanarHeightField(0, 1, 0, 1, x, 2048, 2048) ]", "too many points");
        add("Shape [ ParametricSurface(u, v, u*v) ShapeSubdivision(2000) ]", "too many points");
        add("17", "Expected `Shape`, `Solid`, `Declare` or `static`");
    }
    void mistakes_VL_POLYGON_VL_SPHERE_CONF_69() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const std::string errors = errorsOf(text.toStdString());
        QVERIFY2(QString::fromStdString(errors).contains(message), errors.c_str());
        // One mistake, one message.
        QVERIFY2(std::count(errors.begin(), errors.end(), '\n') == 1, errors.c_str());
    }

    void whatIsLeftOutIsSaid() {
        const ParseResult parsed = test::readText(
            "include \"statics.vib\"\nCamera [ Position(0,0,-5) ]\nDeclare Red = Shader [ Color(1,0,0) ]\n"
            "Shape [ Sphere((0,0,0), 1) Red Phong(0.5) Texture [ Wood ] Scale(2,2,2) "
            "ShapeSubdivisions(5, 5, 4) ]\n");
        QVERIFY2(parsed.ok(), test::messages(parsed, Severity::error).c_str());
        const QString left = QString::fromStdString(test::messages(parsed, Severity::leftOut));
        for (const char* said :
             {"1:1: left out: `include` is not simulated.", "2:1: left out: `Camera` is not simulated.",
              "3:15: left out: `Shader` is not simulated.", "4:28: left out: `Red` is not simulated.",
              "4:32: left out: `Phong` is not simulated.", "4:43: left out: `Texture` is not simulated.",
              "left out: The third number of `ShapeSubdivisions` is not simulated."})
            QVERIFY2(left.contains(said), qPrintable(left));
        QCOMPARE(left.count('\n'), 7);
        // What stands behind the shader still counts.
        QVERIFY(std::abs(depthAt(parsed, 0, 0) + 2) < 1e-12);
    }

    void transformationsActInTheirOrder() {
        const ParseResult parsed =
            test::readText("Shape [ Sphere((1,0,0), 0.5) Rotate(0,0,90) Translate(0,0,3) Scale(2,2,2) ]");
        QVERIFY(parsed.ok());
        QVERIFY(contains(parsed, {0, 2, 6}));
        QVERIFY(!contains(parsed, {2, 0, 6}));
    }

    void primitivesAndPointsCanBeDeclared() {
        const ParseResult parsed = test::readText(
            "Declare C = (0, 0, 5)\nDeclare R = 2\nDeclare P = Sphere(C, R/2)\nDeclare Q = P\n"
            "Shape [ Q Translate(0,0,1) ]");
        QVERIFY2(parsed.ok(), test::messages(parsed, Severity::error).c_str());
        QCOMPARE(depthAt(parsed, 0, 0), 5.0);
    }

    void setOperators_VL_CSG_CONF_71_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("inside");  // of A only, B only, both, none
        const auto add = [](const char* text, const char* inside) {
            QTest::newRow(text) << QString(text) << QString(inside);
        };
        add("A + B", "1110");
        add("A ^ B", "1110");
        add("A * B", "0010");
        add("A - B", "1000");
        add("A * ~B", "1000");
        add("~A", "0101");
        add("~~A", "1010");
        add("A & B", "0010");
        add("A - B - A", "0000");
        add("B - A + A", "1110");
        add("A + B * A", "1010");
        add("(A + B) * A", "1010");
        add("A - (B - A)", "1010");
        add("~(A + B)", "0001");
        add("A + Solid [ B - A ]", "1110");
    }
    void setOperators_VL_CSG_CONF_71() {
        QFETCH(QString, expression);
        QFETCH(QString, inside);
        const ParseResult parsed = test::readText(
            "Declare A = Shape [ Box((-2,-1,-1), (1,1,1)) ]\nDeclare B = Shape [ Box((-1,-1,-1), (2,1,1)) ]\n"
            "Solid [ " +
            expression.toStdString() + " ]");
        QVERIFY2(parsed.ok(), test::messages(parsed, Severity::error).c_str());
        QString found;
        for (const double x : {-1.5, 1.5, 0.1, 5.0}) found += contains(parsed, {x, 0.1, 0.2}) ? '1' : '0';
        QCOMPARE(found, inside);
    }

    /// They reached below zero, and stood at fractions.
    void slidersOfCountsAreWhole() {
        const std::string text =
            "Shape [ ImplicitPlanarHeightField(-4, 4, -4, 4, x * z, 30, 40) ]\n"
            "Shape [ Polygon(3, (0,0,0), (1,0,0), (0,1,0)) ]";
        const ParseResult parsed = test::readText(text);
        QVERIFY2(parsed.ok(), test::messages(parsed, Severity::error).c_str());
        for (const auto& [name, least, most] :
             std::vector<std::tuple<std::string, double, double>>{{"number of steps in x", 1, 150},
                                                                  {"number of steps in z", 1, 200},
                                                                  {"number of vertices", 3, 15}}) {
            const auto found = std::find_if(
                parsed.scene->parameters.begin(), parsed.scene->parameters.end(),
                [&, wanted = name](const SceneParameter& parameter) { return parameter.name == wanted; });
            QVERIFY2(found != parsed.scene->parameters.end(), name.c_str());
            QVERIFY2(found->integral, name.c_str());
            QCOMPARE(found->minimum, least);
            QCOMPARE(found->maximum, most);
        }
    }

    void slidersMoveTheNumbersOfTheText() {
        const std::string text =
            "Declare K = 0.5\nShape [ ImplicitSurface(x^2 + y^2 + z^2 - K) Bound((-1,-1,-1), (1,1,1)) ]\n"
            "Shape [ Torus((1,2,3), (0,1,0), 4, 1) Translate(0,7,0) ]";
        const ParseResult parsed = test::readText(text);
        QVERIFY(parsed.ok());
        const auto find = [&](const std::string& name) -> const SceneParameter* {
            for (const SceneParameter& parameter : parsed.scene->parameters)
                if (parameter.name == name) return &parameter;
            return nullptr;
        };
        const SceneParameter* k = find("K");
        QVERIFY(k && k->slot >= 0 && k->value == 0.5);
        QCOMPARE(text.substr(k->range.begin, k->range.end - k->range.begin), std::string("0.5"));
        // Its slot reaches the picture without a new parse.
        auto table = std::make_shared<std::vector<double>>(*parsed.scene->parameterTable);
        (*table)[static_cast<std::size_t>(k->slot)] = 0.25;
        TraceContext context(table, RootFinder::lipschitz);
        HitList hits;
        parsed.scene->objects[0].shape->intersect({{0, 0, -5}, {0, 0, 1}}, {0, 100}, context, hits);
        QVERIFY(!hits.empty() && std::abs(hits[0].t - 4.5) < 1e-6);
        for (const auto& [name, literal] : std::vector<std::pair<std::string, std::string>>{
                 {"center y", "2"}, {"major radius", "4"}, {"minor radius", "1"}, {"y", "7"}}) {
            const SceneParameter* parameter = find(name);
            QVERIFY2(parameter, name.c_str());
            QCOMPARE(text.substr(parameter->range.begin, parameter->range.end - parameter->range.begin),
                     literal);
        }
    }

    /// Every digit of these texts belongs to a slider, but for those of names.
    void everyNumberIsOnASlider_data() {
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const char* text) { QTest::newRow(name) << text; };
        row("implicit surface",
            "Shape [ ImplicitSurface(x^2 + 0.5*y^2 + cos(2*z)/3 - 1.5) Bound((-1,-1,-1), (1,1,1)) ]");
        row("declared",
            "static a = 3\nDeclare b = 2*0.7 + a\nDeclare f = x^2 + 0.3*y + z^2 - b\n"
            "Shape [ ImplicitSurface(f) Bound((-2,-2,-2), (2,2,2)) ]");
        row("expressions", "Shape [ Sphere((1+0.5, 2, -3), 2*0.25) Scale(1, 1/2, -1) Rotate(0, 45, 0) ]");
        row("polynomial", "Shape [ PolynomialSurface(x^4 + 2*y^2 + z^2 - 0.25) VietaSolver ]");
        row("parametric",
            "Shape [ ParametricSurface(cos(2*u), 0.5*v, sin(u)) RenderBound(0, 6.2, -1, 1) "
            "ShapeSubdivision(8, 9) ]");
        row("planar field", "Shape [ ImplicitPlanarHeightField(-1, 1, -2, 2, 0.3*sin(4*x), 8, 9) ]");
        row("spherical field", "Shape [ ImplicitSphericalHeightField(1.5, 0.3, cos(3*u)/2, 8, 9) ]");
        row("blobby", "Shape [ Blobby(0.6, Sphere((0,0,0), 1, 2), Plane((0,1,0), 0.5, 1.5, -1)) ]");
        row("patch",
            "Shape [ TriangularPatch((0,0,0), (0,0,1), (1,0,0), (0,0,1) UV=1,1/8, (0,1,0), (0,1,1)) ]");
        row("nurbs",
            "Shape [ NURBS(2, 2, [0,0,1,1], 2, 2, [0,0,1,1], [[(0,0,0),(1,0,0,2)],[(0,1,0),(1,1,0)]]) ]");
        row("revolution", "Shape [ SurfaceOfRevolution(STRAIGHT, 3, (1, 0, 0), {0, -2}, {0.6, 1}, {0, 2}) ]");
        row("solid",
            "Solid [ Shape [ Box((-1,-2,-3), (1,2,3)) ] - Shape [ Cone((0,0,0), 1, (0,4,0), 0.5) ] "
            "Translate(4, 5, 6) ]");
    }
    void everyNumberIsOnASlider() {
        QFETCH(QString, text);
        const std::string bytes = text.toStdString();
        const ParseResult parsed = test::readText(bytes);
        QVERIFY2(parsed.ok(), test::messages(parsed, Severity::error).c_str());
        for (std::size_t k = 0; k < bytes.size(); ++k) {
            const bool inName = k > 0 && std::isalpha(static_cast<unsigned char>(bytes[k - 1]));
            if (!std::isdigit(static_cast<unsigned char>(bytes[k])) || inName) continue;
            QVERIFY2(sliderAt(parsed, k), ("nothing moves " + bytes.substr(k)).c_str());
        }
        // Each is moved by one slider alone.
        for (const SceneParameter& a : parsed.scene->parameters)
            for (const SceneParameter& b : parsed.scene->parameters)
                QVERIFY(&a == &b || a.range.end <= b.range.begin || b.range.end <= a.range.begin);
    }

    /// Literals of an ImplicitSurface reach the picture without a new parse; exponents ask for one.
    void literalsOfFormulasHaveSlots() {
        const std::string text =
            "Shape [ ImplicitSurface(x^2 + y^2 + z^2 - 0.25) Bound((-1,-1,-1), (1,1,1)) ]";
        const ParseResult parsed = test::readText(text);
        QVERIFY(parsed.ok());
        const SceneParameter* size = sliderAt(parsed, text.find("0.25"));
        QVERIFY(size && size->slot >= 0);
        QCOMPARE(size->name, std::string("function, number 4"));
        const SceneParameter* exponent = sliderAt(parsed, text.find("^2") + 1);
        QVERIFY(exponent && exponent->slot < 0);
        auto table = std::make_shared<std::vector<double>>(*parsed.scene->parameterTable);
        (*table)[static_cast<std::size_t>(size->slot)] = 0.81;
        TraceContext context(table, RootFinder::certified);
        HitList hits;
        parsed.scene->objects[0].shape->intersect({{0, 0, -5}, {0, 0, 1}}, {0, 100}, context, hits);
        QVERIFY(!hits.empty() && std::abs(hits[0].t - 4.1) < 1e-6);
    }

    void declaredObjectsAreFoundByName() {
        const ParseResult parsed = test::readText(
            "Declare A = Shape [ Sphere((0,0,0), 1) ]\nDeclare B = Shape [ Sphere((9,0,0), 1) ]");
        QVERIFY(declaredShape(parsed, "A") && declaredShape(parsed, "B") && !declaredShape(parsed, "C"));
        // The one declared last is shown.
        QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
        QVERIFY(contains(parsed, {9, 0, 0}));
    }

    /// "Shpae" is a slip of the manual.
    void slipsAreExplained_CONF_68() {
        const ParseResult parsed = test::readText("Shpae [ Sphere((0,0,0), 1) ]");
        QCOMPARE(parsed.diagnostics.empty(), false);
        QCOMPARE(parsed.diagnostics[0].hint, std::string("did you mean `Shape`?"));
    }

    void patchesHaveTextureCoordinates() {
        const auto read = [](const char* text) {
            const virtualight::Document document = virtualight::readDocument(text, {});
            return std::get<virtualight::TrianglePatch>(*document.shown.at(0)->primitive);
        };
        const auto plain =
            read("Shape [ TriangularPatch((0,0,0), (0,0,1), (1,0,0), (0,0,1), (0,1,0), (0,0,1)) ]");
        QVERIFY(plain.uv[0] == glm::dvec2(0, 0) && plain.uv[1] == glm::dvec2(1, 0) &&
                plain.uv[2] == glm::dvec2(0, 1));
        const auto given = read(
            "Shape [ TriangularPatch((0,0,0), (0,0,1) UV=0.5,0.25, (1,0,0), (0,0,1), (0,1,0), (0,1,1) "
            "UV=1,1/8) ]");
        QVERIFY(given.uv[0] == glm::dvec2(0.5, 0.25) && given.uv[1] == glm::dvec2(1, 0) &&
                given.uv[2] == glm::dvec2(1, 0.125));
        QVERIFY(given.normals[2] == glm::dvec3(0, 1, 1));
    }

    void modifiersGoDownToPartsWithoutTheirOwn() {
        const virtualight::Document document = virtualight::readDocument(
            "Solid [ Shape [ NURBS(2, 2, [0,0,1,1], 2, 2, [0,0,1,1], [[(0,0,0),(1,0,0)],[(0,1,0),(1,1,0)]]) "
            "] + "
            "Shape [ Torus((0,0,0), (0,1,0), 2, 1) FerrariSolver ] SturmSolver ShapeSubdivision(7, 9) ]",
            {});
        const virtualight::Node& solid = *document.shown.at(0);
        const virtualight::Node& sum = *solid.parts.at(0);
        const auto first = sum.parts.at(0)->modifiers.within(solid.modifiers);
        const auto second = sum.parts.at(1)->modifiers.within(solid.modifiers);
        QVERIFY(first.solver == virtualight::Solver::sturm && second.solver == virtualight::Solver::ferrari);
        QVERIFY((first.subdivision == std::array{7, 9}));
    }

    void closedFormSolversSayTheirLimit() {
        const ParseResult parsed = test::readText(
            "Shape [ PolynomialSurface(x^6 + y^6 + z^6 - 1) Bound((-2,-2,-2), (2,2,2)) VietaSolver ]");
        QVERIFY(parsed.ok());
        QVERIFY(test::messages(parsed, Severity::note).find("has order 6: `SturmSolver` draws it") !=
                std::string::npos);
    }
};

QTEST_GUILESS_MAIN(DocumentParserTest)
#include "document_parser_test.moc"
