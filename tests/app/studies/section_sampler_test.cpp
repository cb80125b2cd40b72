// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <QTest>

#include "core/language/parse.h"
#include "widgets/section/section_sampler.h"

using namespace isoscope;

namespace {

/// The section of one isosurface; x + 10 y + 100 z says where each value was taken.
SectionField sectionOf(const std::string& statement, int axis, double position, int resolution = 33) {
    const ParseResult parsed = parseScene("#include \"functions.inc\"\nisosurface { " + statement + " }");
    if (parsed.scene->isosurfaces.empty()) return {};
    return sampleSection({parsed.scene->isosurfaces[0].shape, parsed.scene->parameterTable,
                          SectionPlane::across(axis, position), resolution});
}

}  // namespace

class SectionSamplerTest : public QObject {
    Q_OBJECT

  private slots:
    void samplesAreWhereTheySayTheyAre_data() {
        QTest::addColumn<int>("axis");
        QTest::addColumn<double>("lowerLeft");
        QTest::addColumn<double>("lowerRight");
        QTest::addColumn<double>("upperLeft");
        // Corners of the box <-1,-2,-3> <1,2,3> at position 0.5.
        QTest::newRow("x: z to the right, y up") << 0 << 0.5 - 20 - 300 << 0.5 - 20 + 300 << 0.5 + 20 - 300;
        QTest::newRow("y: x to the right, z up") << 1 << -1 + 5.0 - 300 << 1 + 5.0 - 300 << -1 + 5.0 + 300;
        QTest::newRow("z: x to the right, y up") << 2 << -1 - 20 + 50.0 << 1 - 20 + 50.0 << -1 + 20 + 50.0;
    }
    void samplesAreWhereTheySayTheyAre() {
        QFETCH(int, axis);
        QFETCH(double, lowerLeft);
        QFETCH(double, lowerRight);
        QFETCH(double, upperLeft);
        const SectionField field = sectionOf(
            "function { x + 10*y + 100*z } contained_by { box { <-1,-2,-3>, <1,2,3> } }", axis, 0.5);
        QVERIFY(!field.empty());
        QCOMPARE(field.values.size(), static_cast<std::size_t>(field.columns) * field.rows);
        QCOMPARE(field.values.front(), static_cast<float>(lowerLeft));
        QCOMPARE(field.values[field.columns - 1], static_cast<float>(lowerRight));
        QCOMPARE(field.values[field.values.size() - field.columns], static_cast<float>(upperLeft));
        QVERIFY(std::max(field.columns, field.rows) == 33);
    }

    void thresholdIsSubtracted() {
        const SectionField field =
            sectionOf("function { x } threshold 0.25 contained_by { box { -1, 1 } }", 2, 0);
        QCOMPARE(field.values.front(), -1.25f);
    }

    void sphereContainerIsMarked() {
        const SectionField field = sectionOf("function { x } contained_by { sphere { <1, 0, 0>, 2 } }", 2, 0);
        QCOMPARE(field.left, -1.0);
        QCOMPARE(field.right, 3.0);
        QCOMPARE(int(field.contained[0]), 0);
        QCOMPARE(int(field.contained[16 * 33 + 16]), 1);
    }

    void undefinedValuesAreReported() {
        const SectionField field = sectionOf("function { sqrt(x) } contained_by { box { -1, 1 } }", 2, 0);
        QVERIFY(field.undefined);
        QVERIFY(std::isnan(field.values.front()));
        QCOMPARE(field.values[32], 1.0f);
        const SectionField defined = sectionOf("function { x } contained_by { box { -1, 1 } }", 2, 0);
        QVERIFY(!defined.undefined);
    }

    void extentIsRoundAndIgnoresOutliers() {
        QCOMPARE(sectionOf("function { x } contained_by { box { -1, 1 } }", 2, 0).extent, 1.0);
        const SectionField pole =
            sectionOf("function { 1/(x*x + y*y) } contained_by { box { -1, 1 } }", 2, 0);
        QVERIFY2(pole.extent <= 20, qPrintable(QString::number(pole.extent)));
        QCOMPARE(roundedUp(0.2), 0.2);
        QCOMPARE(roundedUp(0.21), 0.5);
        QCOMPARE(roundedUp(7e5), 1e6);
        QCOMPARE(roundedUp(0), 1.0);
        QCOMPARE(roundedUp(std::nan("")), 1.0);
    }

    void parametersOfTheTableAreUsed() {
        const ParseResult parsed = parseScene("#declare R = 0.5; isosurface { function { x - R } }");
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
        auto table = std::make_shared<std::vector<double>>(*parsed.scene->parameterTable);
        for (const SceneParameter& parameter : parsed.scene->parameters)
            if (parameter.name == "R" && parameter.slot >= 0)
                (*table)[static_cast<std::size_t>(parameter.slot)] = 0.75;
        const SectionField field =
            sampleSection({parsed.scene->isosurfaces[0].shape, table, SectionPlane::across(2, 0), 17});
        QCOMPARE(field.values.front(), -1.75f);
    }

    void stoppedOrWithoutSurfaceIsEmpty() {
        QVERIFY(sampleSection({}).empty());
        const ParseResult parsed = parseScene("isosurface { function { x } }");
        std::stop_source source;
        source.request_stop();
        QVERIFY(
            sampleSection({parsed.scene->isosurfaces[0].shape, nullptr, {}, 64}, source.get_token()).empty());
    }

    void distancesAreRightToFirstOrder() {
        // Of an even slope they are exact.
        const ParseResult parsed = parseScene(
            "isosurface { function { 3*sqrt(x*x + y*y + z*z) } threshold 1.5 }\n"
            "isosurface { function { x*x } threshold 1 }\nisosurface { function { sqrt(x) - 0.5 } }");
        SectionRequest request{parsed.scene->isosurfaces[0].shape, parsed.scene->parameterTable,
                               SectionPlane::across(2, 0), 9};
        QVERIFY(sampleSection(request).distances.empty());
        request.quantity = SectionQuantity::distance;
        const SectionField ball = sampleSection(request);
        QVERIFY(&ball.heights() == &ball.distances && ball.distances.size() == ball.values.size());
        for (int row = 0; row < 9; ++row)
            for (int column = 0; column < 9; ++column) {
                const double radius = std::hypot(column / 4.0 - 1, row / 4.0 - 1);
                const float distance = ball.distances[static_cast<std::size_t>(9 * row + column)];
                if (radius > 0)
                    QVERIFY(std::abs(distance - (radius - 0.5)) < 1e-6);
                else
                    QVERIFY(std::isinf(distance) && distance < 0);  // the tip of a cone counts as flat
            }
        // Nine tenths of the places have radii of up to 1.25.
        QCOMPARE(ball.extent, 5.0);  // 2.25, rounded up
        QCOMPARE(ball.distanceExtent, 1.0);
        request.surface = parsed.scene->isosurfaces[1].shape;
        const SectionField slab = sampleSection(request);
        for (int column = 0; column < 9; ++column) {
            const double x = column / 4.0 - 1;
            if (x != 0) QVERIFY(std::abs(slab.distances[column] - (x * x - 1) / std::abs(2 * x)) < 1e-6);
        }
        QCOMPARE(slab.distances[8], 0.0f);
        request.surface = parsed.scene->isosurfaces[2].shape;
        const SectionField half = sampleSection(request);
        QVERIFY(std::isnan(half.distances[0]) && half.undefined);
        QCOMPARE(half.distances[4], 0.0f);  // infinitely steep
        QVERIFY(sectionTable(half).startsWith(QStringLiteral("x,y,z,value,gradient,distance\n")));
    }

    void slopesAreThoseOfTheFunction() {
        const ParseResult parsed = parseScene(
            "isosurface { function { x*x + 3*y + sqrt(z) } max_gradient 2.5 contained_by { box { -1, 1 } } "
            "}");
        SectionRequest request{parsed.scene->isosurfaces[0].shape, parsed.scene->parameterTable,
                               SectionPlane::across(2, 0.25), 5};
        QVERIFY(sampleSection(request).slopes.empty());
        request.quantity = SectionQuantity::gradient;
        const SectionField field = sampleSection(request);
        QVERIFY(field.quantity == SectionQuantity::gradient);
        QCOMPARE(field.maxGradient, 2.5);
        QCOMPARE(field.slopes.size(), field.values.size());
        // (2 x, 3, 1 / (2 sqrt(z))) with x from -1 to 1 and z = 1/4.
        for (int column = 0; column < 5; ++column) {
            const double x = -1 + 0.5 * column;
            QVERIFY(std::abs(field.slopes[column] - std::hypot(2 * x, 3.0, 1.0)) < 1e-5);
        }
        QVERIFY(std::abs(field.steepest - std::sqrt(14.0)) < 1e-5);
        // Infinite on the seam, undefined behind it.
        request.plane = SectionPlane::across(2, 0);
        QVERIFY(std::isinf(sampleSection(request).slopes.front()));
        request.plane = SectionPlane::across(2, -0.5);
        QVERIFY(std::isnan(sampleSection(request).slopes.front()));
    }
};

QTEST_APPLESS_MAIN(SectionSamplerTest)
#include "section_sampler_test.moc"
