// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/function/graph_builder.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"
#include "tests/shapes/golden_rays.h"

using namespace isoscope;
using isoscope::test::Agreement;
using isoscope::test::GoldenRays;

namespace {

template <class Formula>
Function functionOf(Formula formula) {
    FunctionGraph graph;
    const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
    const Expression result = formula(Expression(graph, x), Expression(graph, y), Expression(graph, z));
    return finish(std::move(graph), {result.node()}, 3);
}

template <class Formula>
IsosurfaceSettings fine(Formula formula, Container container, double maxGradient) {
    IsosurfaceSettings settings;
    settings.function = functionOf(formula);
    settings.container = container;
    settings.accuracy = 1e-7;
    settings.maxGradient = maxGradient;
    return settings;
}

ShapePointer isosurface(IsosurfaceSettings settings) {
    return std::make_shared<Isosurface>(std::move(settings));
}

ShapePointer placed(ShapePointer shape, const Transform& transform) {
    return std::make_shared<PlacedShape>(std::move(shape), transform);
}

ContainerBox cube(double half) { return {glm::dvec3(-half), glm::dvec3(half)}; }

const auto unitSphere = [](Expression x, Expression y, Expression z) { return sq(x) + sq(y) + sq(z) - 1; };
const auto coordinateX = [](Expression x, Expression, Expression) { return x; };
const ContainerBox cut{{-0.8, -1.2, -0.7}, {1.2, 0.9, 1.2}};

ShapePointer cutSphere(bool open) {
    IsosurfaceSettings settings = fine(unitSphere, cut, 5.22);
    settings.open = open;
    return isosurface(settings);
}

ShapePointer cosines(int maxTrace) {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return cos(x * 4) + cos(y * 4) + cos(z * 4);
    };
    IsosurfaceSettings settings = fine(formula, cube(1.2), 8.7);
    settings.maxTrace = maxTrace;
    return isosurface(settings);
}

ShapePointer evaluated() {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return x * x + 2 * y * y + 0.5 * z * z * z * z - 1 + 0.2 * sin(6 * x) * sin(6 * z);
    };
    IsosurfaceSettings settings = fine(formula, cube(1.6), 14.6);
    settings.evaluate = {2, 1.2, 0.99};
    return isosurface(settings);
}

ShapePointer thresholded() {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return x * x + y * y * 2 + z * z * 3;
    };
    IsosurfaceSettings settings = fine(formula, cube(1.5), 14.1);
    settings.threshold = 0.9;
    return isosurface(settings);
}

ShapePointer transformed() {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return x * x + y * y * y * y + z * z - 1;
    };
    return placed(isosurface(fine(formula, ContainerSphere{{0, 0, 0}, 1.3}, 11)),
                  Transform::scaling({2, 1, 0.5})
                      .then(Transform::rotation({30, 40, 50}))
                      .then(Transform::translation({1, -1, 2})));
}

ShapePointer openCone() {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return sqrt(pow(x, x.number(2)) + pow(z, x.number(2))) + y;
    };
    IsosurfaceSettings settings = fine(formula, cube(2), 1.5);
    settings.open = true;
    return isosurface(settings);
}

ShapePointer halfBox(bool open) {
    IsosurfaceSettings settings = fine(coordinateX, cube(2), 1.5);
    settings.open = open;
    return isosurface(settings);
}

ShapePointer csgOf(CsgOperation operation) {
    return std::make_shared<Csg>(
        operation, std::vector<ShapePointer>{
                       std::make_shared<Sphere>(glm::dvec3(-0.3, 0, 0), 1),
                       std::make_shared<Box>(glm::dvec3(-0.4, -0.6, -0.7), glm::dvec3(1.2, 0.5, 0.6))});
}

ShapePointer cutWavySphere() {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return x * x + y * y + z * z + 0.4 * sin(4 * x) * sin(4 * y) * sin(4 * z) - 1;
    };
    IsosurfaceSettings settings = fine(formula, cube(1.3), 8);
    settings.maxTrace = 10;
    return std::make_shared<Csg>(
        CsgOperation::difference,
        std::vector<ShapePointer>{isosurface(settings),
                                  std::make_shared<Box>(glm::dvec3(0.1, 0.05, -2), glm::dvec3(2))});
}

ShapePointer boundedCosines() {
    const auto formula = [](Expression x, Expression y, Expression z) {
        return cos(3 * x) + cos(3 * y) + cos(3 * z);
    };
    IsosurfaceSettings settings = fine(formula, cube(1.5), 6);
    settings.maxTrace = 8;
    return std::make_shared<Csg>(
        CsgOperation::intersection,
        std::vector<ShapePointer>{isosurface(settings), std::make_shared<Sphere>(glm::dvec3(0), 1.6)});
}

ShapePointer built(const std::string& name) {
    const std::map<std::string, std::function<ShapePointer()>> builders{
        {"iso_sphere",
         [] {
             return isosurface(fine(unitSphere, ContainerSphere{{0, 0, 0}, 1.2}, 3.01));
         }},
        {"iso_sphere_cut", [] { return cutSphere(false); }},
        {"iso_sphere_cut_open", [] { return cutSphere(true); }},
        {"iso_max_trace", [] { return cosines(6); }},
        {"iso_evaluate", evaluated},
        {"iso_threshold_nonzero", thresholded},
        {"iso_transformed", transformed},
        {"iso_tut7_cone_open", openCone},
        {"iso_x", [] { return halfBox(false); }},
        {"iso_x_open", [] { return halfBox(true); }},
        {"sphere_unit", [] { return std::make_shared<Sphere>(glm::dvec3(0), 1); }},
        {"sphere_offset", [] { return std::make_shared<Sphere>(glm::dvec3(1.5, -2.25, 0.75), 0.6); }},
        {"sphere_ellipsoid_rotated",
         [] {
             return placed(std::make_shared<Sphere>(glm::dvec3(0.2, 0, 0.1), 0.9),
                           Transform::scaling({0.3, 1.5, 1})
                               .then(Transform::rotation({25, 35, 45}))
                               .then(Transform::translation({1, 1, 1})));
         }},
        {"box_mirrored",
         [] {
             return placed(std::make_shared<Box>(glm::dvec3(0), glm::dvec3(1, 2, 3)),
                           Transform::scaling({-1, 1, -2}).then(Transform::rotation({0, 15, 0})));
         }},
        {"box_swapped_corners",
         [] { return std::make_shared<Box>(glm::dvec3(2, -1, 3), glm::dvec3(-0.5, 0.25, 1)); }},
        {"box_thin",
         [] { return std::make_shared<Box>(glm::dvec3(-1, -0.001, -1), glm::dvec3(1, 0.001, 1)); }},
        {"plane_oblique", [] { return std::make_shared<Plane>(glm::dvec3(1, 2, 3), 1.5); }},
        {"plane_negative", [] { return std::make_shared<Plane>(glm::dvec3(-0.5, 0.25, -1), -0.75); }},
        {"plane_transformed",
         [] {
             return placed(std::make_shared<Plane>(glm::dvec3(0, 1, 0), 0.5),
                           Transform::rotation({30, 0, 50})
                               .then(Transform::scaling({1, 2, 3}))
                               .then(Transform::translation({0.3, 0.1, -0.2})));
         }},
        {"csg_union", [] { return csgOf(CsgOperation::union_); }},
        {"csg_merge", [] { return csgOf(CsgOperation::merge); }},
        {"csg_intersection", [] { return csgOf(CsgOperation::intersection); }},
        {"csg_difference", [] { return csgOf(CsgOperation::difference); }},
        {"csg_isosurface", cutWavySphere},
        {"csg_isosurface_max_trace", boundedCosines},
    };
    const auto found = builders.find(name);
    return found == builders.end() ? nullptr : found->second();
}

}  // namespace

/// Shapes of golden/shapes rebuilt by hand, so that this test needs no parser.
class GoldenShapesTest : public QObject {
    Q_OBJECT

  private slots:
    void agreesWithPovray_data() {
        QTest::addColumn<QString>("name");
        for (const std::string& name : golden_.names())
            if (built(name)) QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }

    void agreesWithPovray() {
        QFETCH(QString, name);
        const ShapePointer shape = built(name.toStdString());
        const Agreement rays = golden_.rays(name.toStdString(), *shape, 1e-9);
        const Agreement points = golden_.points(name.toStdString(), *shape);
        QVERIFY(rays.compared > 0);
        for (const QString& text : rays.disagreements + points.disagreements)
            qWarning("%s", qPrintable(text));
        QCOMPARE(rays.disagreements.size() + points.disagreements.size(), 0);
    }

  private:
    GoldenRays golden_;
};

QTEST_APPLESS_MAIN(GoldenShapesTest)
#include "golden_shapes_test.moc"
