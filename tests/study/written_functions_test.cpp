// SPDX-License-Identifier: GPL-3.0-or-later
// Steepest slopes of classes of functions as people write them, which once ended without a proof.
#include <cmath>
#include <numbers>
#include <glm/geometric.hpp>
#include <QTest>

#include "core/study/gradient/gradient_study.h"
#include "tests/support/study_case.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

GradientBracket bracketOf(const std::string& body, const Container& container) {
    const StudiedFunction f(body);
    return GradientStudy(f.tape, f.parameters, container).run();
}

const Container unitBox = ContainerBox{glm::dvec3(-1), glm::dvec3(1)};

}  // namespace

class WrittenFunctionsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Each is as steep as a part of it, which bounds over the whole container say at once. All of these
    /// ended at a million boxes, or at their centre.
    void smoothMinimaAndRootsOfWholePowersAreKnownAtOnce() {
        const struct {
            const char* body;
            double steepest;
        } rows[] = {{"-ln(exp(-8*(sqrt(x*x+y*y+z*z)-0.6))+exp(-8*(sqrt(pow(x-0.7,2)+y*y+z*z)-0.5)))/8", 1},
                    {"-log(exp(-8*(sqrt(x*x+y*y+z*z)-0.6))+exp(-8*(2*y+0.5)))/8", 2 / std::log(10.0)},
                    {"pow(pow(x,4)+pow(y,4)+pow(z,4),0.25)-0.8", 1},
                    {"pow(pow(abs(x),3)+pow(abs(y),3)+pow(abs(z),3),1/3)-0.8", 1},
                    {"max(f_superellipsoid(x,y,z,0.4,0.6), -f_torus(x,y,z,0.8,0.3))", 1}};
        for (const auto& [body, steepest] : rows) {
            const GradientBracket b = bracketOf(body, unitBox);
            QVERIFY2(b.state == GradientState::tight && b.boxes <= 100,
                     qPrintable(QString("%1: %2").arg(body).arg(b.boxes)));
            QVERIFY2(std::abs(b.upper - steepest) < 1e-6 && b.lower > 0.99 * steepest, body);
        }
    }

    /// Blends of distances, as those who model by distances write them: the cases of min(a, b) and |a - b|
    /// were taken one by one, which made twice the slope, and the centres of balls had any slope.
    void blendsOfDistancesAreKnownAtOnce() {
        const std::string ball = "(sqrt(x*x+y*y+z*z)-0.6)", other = "(sqrt(pow(x-0.7,2)+y*y+z*z)-0.5)",
                          torus = "(sqrt(pow(sqrt(x*x+z*z)-0.7,2)+y*y)-0.2)", ground = "(y+0.5)";
        const auto quadratic = [](const std::string& a, const std::string& b, const std::string& k) {
            return "min(" + a + "," + b + ") - pow(max(" + k + "-abs(" + a + "-" + b + "),0)/" + k + ",2)*" +
                   k + "/4";
        };
        const auto mixed = [](const std::string& a, const std::string& b, const std::string& k) {
            const std::string h = "max(min(0.5+0.5*(" + b + "-" + a + ")/" + k + ",1),0)";
            return b + "*(1-" + h + ")+" + a + "*" + h + "-" + k + "*" + h + "*(1-" + h + ")";
        };
        for (const std::string& body :
             {quadratic(ball, other, "0.1"), quadratic(ball, other, "1.5"), quadratic(ball, ground, "0.5"),
              quadratic(ball, torus, "0.4"), mixed(ball, other, "0.3"), mixed(ball, torus, "0.4"),
              "-(" + quadratic("-" + ball, other, "0.3") + ")",
              "min(" + ball + "," + other + ") - pow(max(1.5-abs(" + ball + "-" + other +
                  "),0)/1.5,3)*0.25"}) {
            const GradientBracket b = bracketOf(body, unitBox);
            QVERIFY2(b.state == GradientState::tight && b.boxes < 20'000, body.c_str());
            QVERIFY2(b.lower > 0.999 && b.upper < 1.0101, body.c_str());
        }
    }

    /// Around the cut of an angle a spiral and a wound torus are one function or another, of other slopes:
    /// what holds all of them is far steeper, however small the box is.
    void slopesBesideJumpsAreThoseOfOneSide() {
        const GradientBracket spiral = bracketOf("f_spiral(x,y,z,0.2,0.05,0.9,0,0,0.75)",
                                                 ContainerBox{{-0.12, -0.05, -0.02}, {-0.06, 0.05, 0.02}});
        QVERIFY(spiral.state == GradientState::unbounded && spiral.boxes < 20'000);
        QVERIFY(spiral.beside && spiral.beside->state == GradientState::tight);
        // As steep as the angle makes it at the edge next to the axis.
        const double steepest = std::hypot(1, 0.2 / (2 * std::numbers::pi * 0.06));
        QVERIFY(spiral.beside->lower > 0.98 * steepest && spiral.beside->upper < 1.0102 * steepest);
    }

    /// Angles from an axis as users write them: beside the axis boxes seemed to hold the ends of the arc
    /// cosine, and a million of them ended without a bound.
    void anglesFromAnAxisAreBounded() {
        const GradientBracket angle =
            bracketOf("acos(max(-1,min(1,y/sqrt(x*x+y*y+z*z+0.001))))-0.5-0.3*x", unitBox);
        QVERIFY(angle.state == GradientState::tight && angle.boxes < 300'000);
        const GradientBracket harmonic = bracketOf(
            "sqrt(x*x+y*y+z*z)-0.7-0.2*sin(4*atan2(z,x))*pow(sin(acos(y/sqrt(x*x+y*y+z*z))),4)", unitBox);
        QCOMPARE(harmonic.state, GradientState::unbounded);
        QVERIFY(glm::length(harmonic.place) < 1e-6);
        QVERIFY(harmonic.beside && harmonic.beside->state == GradientState::tight);
    }

    /// What is added along an axis changes no slope: boxes were halved along it as well, for nothing, and
    /// never came to the tiny steep place along the middle.
    void axesOfConstantSlopesAreNotDivided() {
        const char* const wave = "y - 0.3*sin(10*sqrt(x*x+z*z))/(10*sqrt(x*x+z*z)+0.0001)";
        const double steepest = std::hypot(1, 0.3 * 10 / 0.0001);
        for (const Container& container : {unitBox, Container(ContainerSphere{{0.2, -0.1, 0}, 1.3})}) {
            const GradientBracket b = bracketOf(wave, container);
            QVERIFY(b.state == GradientState::tight && b.boxes < 20'000);
            QVERIFY(b.lower <= steepest && b.upper >= steepest);
        }
        // Nor where all of it is linear, or one axis alone is not.
        const GradientBracket plane = bracketOf("x/2 - 3*(y + z) + 1", unitBox);
        QVERIFY(plane.boxes <= 20 && std::abs(plane.lower - std::sqrt(18.25)) < 1e-9);
        const GradientBracket ball = bracketOf("2*x*x - z", ContainerSphere{{1, 2, 3}, 0.5});
        QVERIFY(std::abs(ball.lower - std::hypot(6, 1)) < 0.07 && ball.upper >= std::hypot(6, 1));
        // A bound beside a pole is that of the container, not of a plane through it.
        const GradientBracket pole = bracketOf("y - 1/(x - 0.3)", unitBox);
        QVERIFY(pole.beside && pole.beside->state == GradientState::tight);
        QVERIFY(pole.beside->share > 0 && pole.beside->share < 0.2);
    }
};

QTEST_APPLESS_MAIN(WrittenFunctionsTest)
#include "written_functions_test.moc"
