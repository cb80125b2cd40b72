// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/health/function_health.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

FunctionHealth healthOf(const std::string& settings, const std::string& before = {}) {
    const auto scene =
        studyScene(before + "isosurface { " + settings + " contained_by { box { -1, 1 } } }\n").scene;
    return functionHealth(*scene->isosurfaces.at(0).shape, *scene->parameterTable);
}

/// The first finding of a kind; null without one.
const HealthFinding* of(const FunctionHealth& health, Ailment ailment) {
    for (const HealthFinding& one : health.findings)
        if (one.ailment == ailment) return &one;
    return nullptr;
}

}  // namespace

class FunctionHealthTest : public QObject {
    Q_OBJECT

  private slots:
    void aPolynomialIsHealthy() {
        const FunctionHealth health = healthOf("function { x*x + y*y*z + z - 0.3 }");
        QVERIFY(health.known && health.finished);
        QVERIFY(health.findings.empty());
    }

    void placesWithoutAValue() {
        const FunctionHealth health = healthOf("function { sqrt(x - 0.25) + y }");
        const HealthFinding* one = of(health, Ailment::undefined);
        QVERIFY(one && one->confirmed);
        QVERIFY(one->place.x < 0.25);
        // The surface ends where the root does.
        QVERIFY(one->distance < 3 * health.resolution);
        // All of it is one region.
        QVERIFY(one->region.low.x <= -1 && std::abs(one->region.high.x - 0.25) < 0.1);
    }

    void poles() {
        const FunctionHealth health = healthOf("function { 1/(x - 0.3) - 2 }");
        const HealthFinding* one = of(health, Ailment::infinite);
        QVERIFY(one && one->confirmed);
        QVERIFY(std::abs(one->place.x - 0.3) < 0.04);
        // The surface is the plane x = 0.8.
        QVERIFY(std::abs(one->distance - 0.5) < 3 * health.resolution);
    }

    void edgesOfRoots() {
        const FunctionHealth health = healthOf("function { sqrt(abs(x)) + y }");
        const HealthFinding* one = of(health, Ailment::infinite);
        QVERIFY(one && std::abs(one->place.x) < 0.04);
    }

    void jumps() {
        const FunctionHealth health = healthOf("function { floor(2*x + 0.5) + y - 0.25 }");
        const HealthFinding* one = of(health, Ailment::jump);
        QVERIFY(one && one->confirmed);
        QVERIFY(std::abs(one->size - 1) < 1e-6);
        const double jumpAt = 2 * one->place.x + 0.5;
        QVERIFY(std::abs(jumpAt - std::round(jumpAt)) < 1e-8);
    }

    /// Every entry of a colour map was suspected to be a jump.
    void entriesOfAColorMapAreKinks() {
        const FunctionHealth health =
            healthOf("function { F(2*x, 2*y, 2*z).gray - 0.5 }",
                     "#declare F = function { pigment { bozo scale 0.5 color_map { [0 rgb 0] [0.2 rgb 0.4] "
                     "[1 rgb 1] } } }\n");
        QVERIFY(health.known && of(health, Ailment::jump) == nullptr);
        const HealthFinding* kink = of(health, Ailment::kink);
        QVERIFY(kink && kink->confirmed);
    }

    void kinks() {
        const FunctionHealth health = healthOf("function { max(abs(x) - 0.4, abs(y) - 0.2) }");
        const HealthFinding* one = of(health, Ailment::kink);
        QVERIFY(one && one->confirmed);
        QVERIFY(of(health, Ailment::jump) == nullptr && of(health, Ailment::undefined) == nullptr);
        QVERIFY(one->distance < 3 * health.resolution);
    }

    /// A jump that takes place only in formulas is not called met.
    void whatIsNotMetIsSuspected() {
        const FunctionHealth health = healthOf("function { x + 0*floor(y*3 + 0.1) }");
        const HealthFinding* one = of(health, Ailment::jump);
        QVERIFY(!one || !one->confirmed);
    }

    void lostDigits() {
        const FunctionHealth health =
            healthOf("function { pow(x + 1e6, 2) - 1e12 - 2e6*x + y*y + z*z - 0.5 } accuracy 1e-6");
        const HealthFinding* one = of(health, Ailment::cancellation);
        QVERIFY(one && one->size > 1e-7);
        QVERIFY(of(healthOf("function { x*x + y - 0.2 } accuracy 1e-6"), Ailment::cancellation) == nullptr);
    }

    void stopsAndWordsAreThere() {
        const auto scene = studyScene("isosurface { function { abs(x) } }\n").scene;
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(
            !functionHealth(*scene->isosurfaces[0].shape, *scene->parameterTable, {}, {}, stop.get_token())
                 .known);
        for (int kind = 0; kind < ailmentCount; ++kind) {
            QVERIFY(!name(static_cast<Ailment>(kind)).empty());
            QVERIFY(consequence(static_cast<Ailment>(kind)).ends_with('.'));
        }
    }
};

QTEST_MAIN(FunctionHealthTest)
#include "function_health_test.moc"
