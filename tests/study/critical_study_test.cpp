// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/threshold/critical_study.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

CriticalStudy studyOf(const std::string& settings, CriticalStudySettings limits = {}) {
    const auto scene = studyScene("isosurface { " + settings + " }\n").scene;
    const Isosurface& surface = *scene->isosurfaces.at(0).shape;
    return {surface.prepared(*scene->parameterTable), surface.settings().container, limits};
}

CriticalPoints pointsOf(const std::string& settings, CriticalStudySettings limits = {}) {
    return studyOf(settings, limits).run();
}

std::size_t proven(const CriticalPoints& points, CriticalKind kind) {
    std::size_t count = 0;
    for (const CriticalPoint& point : points.points) count += point.proven() && point.kind == kind;
    return count;
}

std::size_t suspected(const CriticalPoints& points) {
    std::size_t count = 0;
    for (const CriticalPoint& point : points.points) count += !point.proven();
    return count;
}

bool holds(const GradientBox& box, const glm::dvec3& p) {
    for (int k = 0; k < 3; ++k)
        if (p[k] < box.low[k] || p[k] > box.high[k]) return false;
    return true;
}

/// What was found, for messages.
QByteArray told(const CriticalPoints& points) {
    QString text = QString("%1 boxes, share %2\n").arg(points.boxes).arg(points.share);
    for (const CriticalPoint& p : points.points)
        text += QString("%1 at <%2, %3, %4> %5 %6\n")
                    .arg(p.value)
                    .arg(p.place.x)
                    .arg(p.place.y)
                    .arg(p.place.z)
                    .arg(QString::fromUtf8(name(p.kind).data()), QString::fromUtf8(name(p.reason).data()));
    return text.toUtf8();
}

}  // namespace

class CriticalStudyTest : public QObject {
    Q_OBJECT

  private slots:
    void aSphereHasOneMinimum() {
        const CriticalPoints points =
            pointsOf("function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } }");
        QVERIFY2(points.points.size() == 1 && points.finished, told(points));
        const CriticalPoint& point = points.points[0];
        QVERIFY(point.proven() && point.kind == CriticalKind::minimum);
        QVERIFY(holds(point.box, {0, 0, 0}) && point.box.width() < 1e-12);
        QVERIFY(point.values.holds(-1) && point.values.width() < 1e-12);
        QVERIFY(!points.jumps);
    }

    void aSphereElsewhereToo() {
        const CriticalPoints points = pointsOf(
            "function { pow(x-0.123,2) + 2*pow(y+0.4,2) + pow(z-1/3,2) } contained_by { box { -1, 1 } }");
        QVERIFY2(points.points.size() == 1 && proven(points, CriticalKind::minimum) == 1, told(points));
        QVERIFY(holds(points.points[0].box, {0.123, -0.4, 1.0 / 3}));
    }

    void cosinesMakeALattice() {
        // cos(pi x) + cos(pi y) + cos(pi z): critical where all coordinates are whole numbers; an odd one is
        // a direction in which it rises.
        const CriticalPoints points =
            pointsOf("function { cos(pi*x) + cos(pi*y) + cos(pi*z) } contained_by { box { -1.4, 2.4 } }");
        // -1, 0, 1, 2: two even and two odd ones.
        QVERIFY2(points.points.size() == 64 && points.finished, told(points));
        QCOMPARE(proven(points, CriticalKind::minimum), std::size_t(8));
        QCOMPARE(proven(points, CriticalKind::saddle1), std::size_t(24));
        QCOMPARE(proven(points, CriticalKind::saddle2), std::size_t(24));
        QCOMPARE(proven(points, CriticalKind::maximum), std::size_t(8));
        for (const CriticalPoint& point : points.points) {
            const glm::dvec3 whole = glm::round(point.place);
            QVERIFY(glm::length(point.place - whole) < 1e-9);
            int odd = 0;
            for (int k = 0; k < 3; ++k) odd += static_cast<int>(std::abs(whole[k])) % 2;
            QVERIFY(std::abs(point.value - (3 - 2 * odd)) < 1e-9);
            QCOMPARE(static_cast<int>(point.kind), 3 - odd);
        }
    }

    void twoBallsJoinAtASaddle() {
        const CriticalPoints points = pointsOf(
            "function { 1 - exp(-(pow(x-0.8,2)+y*y+z*z)*2) - exp(-(pow(x+0.8,2)+y*y+z*z)*2) } "
            "contained_by { box { -2, 2 } }");
        QVERIFY2(proven(points, CriticalKind::minimum) == 2 && proven(points, CriticalKind::saddle1) == 1,
                 told(points));
        QCOMPARE(suspected(points), std::size_t(0));
        const CriticalPoint& saddle = points.points.back();
        QVERIFY(glm::length(saddle.place) < 1e-9);
        QVERIFY(saddle.values.holds(1 - 2 * std::exp(-1.28)) ||
                std::abs(saddle.value - (1 - 2 * std::exp(-1.28))) < 1e-12);
    }

    void aSmoothTorusIsToldAsALine() {
        // (x^2+y^2+z^2+R^2-r^2)^2 - 4 R^2 (x^2+z^2): critical at 0, and all along the circle.
        const CriticalPoints points =
            pointsOf("function { pow(x*x+y*y+z*z+0.75,2) - 4*(x*x+z*z) } contained_by { box { -2, 2 } }",
                     {.boxLimit = 60'000});
        // By x^2+z^2 = s, y^2 = u: at 0 the second derivatives are 3-8 < 0 in x and z, 3 > 0 in y.
        QVERIFY2(proven(points, CriticalKind::saddle2) == 1, told(points));
        QVERIFY(suspected(points) >= 1);
        for (const CriticalPoint& point : points.points) {
            if (point.proven()) {
                QVERIFY(glm::length(point.place) < 1e-9 && std::abs(point.value - 0.5625) < 1e-9);
                continue;
            }
            // s = R^2 + r^2 = 1.25.
            QVERIFY(std::abs(std::hypot(point.place.x, point.place.z) - std::sqrt(1.25)) < 0.1);
        }
    }

    void theDistanceToATorusIsSuspectedAtItsCircleAndAxis() {
        const CriticalPoints points =
            pointsOf("function { f_torus(x, y, z, 1, 0.25) } contained_by { box { -1.5, 1.5 } }",
                     {.boxLimit = 60'000});
        QVERIFY2(suspected(points) == points.points.size() && !points.points.empty(), told(points));
        bool circle = false, middle = false;
        for (const CriticalPoint& point : points.points) {
            circle = circle || holds(point.box, {1, 0, 0});
            middle = middle || holds(point.box, {0, 0, 0});
        }
        QVERIFY2(circle && middle, told(points));
    }

    void whereThereIsNoneNoneIsTold() {
        for (const char* function :
             {"x + 2*y - z", "x*x + y*y + z*z - 1", "exp(x) + y*y*y + y", "f_noise3d(x,y,z) + 9*x"}) {
            const CriticalPoints points =
                pointsOf(std::string("function { ") + function + " } contained_by { box { 1, 2 } }");
            QVERIFY2(points.points.empty() && points.finished && points.share == 0, told(points));
        }
    }

    void kinksAreNeverClaimed() {
        for (const char* function : {"abs(x) + abs(y) + abs(z)", "sqrt(x*x + y*y + z*z) - 1",
                                     "max(abs(x), max(abs(y), abs(z)))", "sqrt(abs(x)) + y*y + z*z"}) {
            const CriticalPoints points =
                pointsOf(std::string("function { ") + function + " } contained_by { box { -1.1, 1 } }",
                         {.boxLimit = 20'000});
            QVERIFY2(!points.points.empty(), function);
            bool middle = false;
            for (const CriticalPoint& point : points.points) {
                QVERIFY2(!point.proven(), function);
                middle = middle || holds(point.box, {0, 0, 0});
            }
            QVERIFY2(middle, told(points));
        }
        // On the face between two halves, too.
        const CriticalPoints even =
            pointsOf("function { abs(x) + y*y + z*z } contained_by { sphere { 0, 1 } }");
        QVERIFY2(even.points.size() == 1 && even.points[0].reason == SuspicionReason::kink, told(even));
        const CriticalPoints cone =
            pointsOf("function { sqrt(x*x + y*y + z*z) - 1 } contained_by { box { -1.1, 1 } }");
        QVERIFY2(cone.points.size() == 1 && cone.points[0].kind == CriticalKind::minimum, told(cone));
        QVERIFY(std::abs(cone.points[0].value + 1) < 1e-6);
    }

    void smoothPointsBesideKinksAreProven() {
        const CriticalPoints points = pointsOf(
            "function { min(pow(x-1,2) + y*y + z*z, pow(x+1,2) + y*y + z*z + 0.2) } contained_by { box { -2, "
            "2.1 } }",
            {.boxLimit = 20'000});
        QVERIFY2(proven(points, CriticalKind::minimum) == 2, told(points));
        // Where both are equal, x = -0.05, lies what may join them.
        bool between = false;
        for (const CriticalPoint& point : points.points)
            between = between || (!point.proven() && holds(point.box, {-0.05, 0, 0}) &&
                                  point.kind == CriticalKind::saddle);
        QVERIFY2(between, told(points));
    }

    void aFlatFunctionIsOnePlace() {
        const CriticalPoints points = pointsOf("function { 3 } contained_by { box { -1, 1 } }");
        QVERIFY2(points.points.size() == 1 && points.finished, told(points));
        QVERIFY(points.points[0].reason == SuspicionReason::flat && points.points[0].value == 3);
    }

    void jumpsAreTold() {
        const CriticalPoints points =
            pointsOf("function { floor(3*x) + x + y } contained_by { box { -1, 1 } }");
        QVERIFY2(points.points.empty() && points.jumps, told(points));
    }

    void aPointOnTheWallIsNotClaimed() {
        for (const char* container : {"box { <0,-1,-1>, 1 }", "sphere { <1,0,0>, 1 }"}) {
            const CriticalPoints points =
                pointsOf(std::string("function { x*x + y*y + z*z } contained_by { ") + container + " }");
            QVERIFY2(points.points.size() == 1, told(points));
            QVERIFY2(points.points[0].reason == SuspicionReason::wall, told(points));
        }
        QVERIFY(pointsOf("function { x*x + y*y + z*z } contained_by { box { <0.001,-1,-1>, 1 } }")
                    .points.empty());
    }

    void randomQuadraticsHaveTheirOnePoint() {
        const unsigned seed = 20;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        for (int round = 0; round < 30; ++round) {
            glm::dvec3 p(0.9 * number(random), 0.9 * number(random), 0.9 * number(random));
            const std::array<double, 3> factor{number(random) > 0 ? 1. : -1., number(random) > 0 ? 2. : -2.,
                                               number(random) > 0 ? 0.5 : -0.5};
            const double mixed = 0.3 * number(random);
            const QString text =
                QString(
                    "function { %1*pow(x-%2,2) + %3*pow(y-%4,2) + %5*pow(z-%6,2) + %7*(x-%2)*(y-%4) } "
                    "contained_by { box { -1, 1 } }")
                    .arg(factor[0], 0, 'g', 17)
                    .arg(p.x, 0, 'g', 17)
                    .arg(factor[1], 0, 'g', 17)
                    .arg(p.y, 0, 'g', 17)
                    .arg(factor[2], 0, 'g', 17)
                    .arg(p.z, 0, 'g', 17)
                    .arg(mixed, 0, 'g', 17);
            const CriticalPoints points = pointsOf(text.toStdString());
            QVERIFY2(points.points.size() == 1 && points.points[0].proven(), told(points));
            QVERIFY2(glm::length(points.points[0].place - p) < 1e-9, told(points));
            // |mixed| is too small to change a sign.
            int falling = 0;
            for (const double f : factor) falling += f < 0;
            QCOMPARE(static_cast<int>(points.points[0].kind), falling);
        }
    }

    void theWorkIsBoundedAndCanBeStopped() {
        const std::string hard = "function { f_noise3d(20*x, 20*y, 20*z) } contained_by { box { -1, 1 } }";
        CriticalStudy study = studyOf(hard, {.boxLimit = 5'000});
        double last = 0;
        bool rises = true;
        const CriticalPoints points = study.run([&](double done) {
            rises = rises && done >= last && done <= 1;
            last = done;
        });
        QVERIFY(rises);
        QVERIFY2(points.boxes < 6'000, told(points));
        QVERIFY(!points.finished && suspected(points) > 0);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(studyOf(hard).run({}, stop.get_token()).points.empty());
    }

    void whatIsStoppedGoesOnAsIfItWereNot() {
        const std::string text =
            "function { cos(3*x) + cos(3*y) * sum(i, 1, 3, sin(i*z)) } contained_by { box { -1, 1.1 } }";
        const CriticalPoints whole = pointsOf(text);
        CriticalStudy study = studyOf(text);
        std::stop_source stop;
        stop.request_stop();
        while (study.step(100)) study.step(1, stop.get_token());
        const CriticalPoints pieces = study.points();
        QCOMPARE(pieces.points.size(), whole.points.size());
        for (std::size_t i = 0; i < whole.points.size(); ++i)
            QCOMPARE(pieces.points[i].value, whole.points[i].value);
    }

    /// Values and kinds of what is suspected cost a thousand evaluations each, of a million steps each here.
    void afterAStopSuspectedOnesHaveNoValue() {
        CriticalStudy study =
            studyOf("function { sum(i, 1, 1000000, sin(i*x)/i)-y } contained_by { box { -1, 1.1 } }");
        std::stop_source stop;
        stop.request_stop();
        const CriticalPoints points = study.points(stop.get_token());
        QCOMPARE(points.points.size(), 1u);
        QVERIFY(std::isnan(points.points.front().value));
        QVERIFY(points.points.front().kind == CriticalKind::unknown);
        QVERIFY(points.points.front().reason == SuspicionReason::unfinished);
    }

    void containersWithoutAnEndHaveNone() {
        QVERIFY(pointsOf("function { x*x } contained_by { box { -1e200, 1e200 } }").points.empty());
        // No room at all: a point.
        const CriticalPoints points = pointsOf("function { x*x+y*y+z*z } contained_by { box { 0, 0 } }");
        for (const CriticalPoint& point : points.points) QVERIFY(!point.proven());
    }
};

QTEST_GUILESS_MAIN(CriticalStudyTest)
#include "critical_study_test.moc"
