// SPDX-License-Identifier: GPL-3.0-or-later
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace isoscope::test;

namespace {

/// What the four balls of the scene call for; none of their rays meets another ball.
struct Effects {
    QByteArray mirror, pattern = "rgb 0.8", glass, grain, fog;
};

QByteArray sceneWith(const Effects& effects) {
    return "global_settings { assumed_gamma 1 }\n"
           "camera { orthographic location -10*z look_at 0 right 8*x up 6*y }\n"
           "light_source { <-30, 40, -50>, 1 }\n"
           "sphere { <-2, 1.4, 0>, 1 pigment { rgb 0.8 } finish { " +
           effects.mirror + " } }\nsphere { <2, 1.4, 0>, 1 pigment { " + effects.pattern +
           " } }\nsphere { <-2, -1.4, 0>, 1 pigment { rgb 0.8 " + effects.glass +
           " } }\nsphere { <2, -1.4, 0>, 1 pigment { rgb 0.8 } finish { " + effects.grain + " } }\n" +
           effects.fog;
}

/// The effects as they are seen.
const Effects all{"reflection 0.5", "granite", "transmit 0.7", "crand 0.2", "fog { distance 20 rgb 0.5 }"};

}  // namespace

/// What effects cost, in instructions of the program's main thread, which callgrind counts: they do not
/// depend on how busy the machine is.
class EffectCostTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

    /// -1 when callgrind has failed.
    double instructionsFor(const Effects& effects) {
        const QString file = writeFile(folder_.path(), "scene.pov", sceneWith(effects));
        return instructionsOfCli({"render", file, "-o", folder_.filePath("picture.png"), "-W", "320", "-H",
                                  "240", "--threads", "1"});
    }

  private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable("valgrind").isEmpty()) QSKIP("NOT MEASURED: valgrind is missing");
    }

    void effectsCostWhatTheirStagesCost() {
        const double plain = instructionsFor({});
        QVERIFY(plain > 0);
        double sum = 0;
        const auto add = [&](const char* name, const Effects& effects) {
            const double cost = instructionsFor(effects) - plain;
            qInfo("%-8s %6.2f million instructions", name, cost / 1e6);
            QVERIFY(cost > 1e6);
            sum += cost;
        };
        Effects one;
        one.mirror = all.mirror;
        add("mirror", one);
        one = {};
        one.pattern = all.pattern;
        add("pattern", one);
        one = {};
        one.glass = all.glass;
        add("glass", one);
        one = {};
        one.grain = all.grain;
        add("grain", one);

        Effects four = all;
        four.fog.clear();
        const double together = instructionsFor(four) - plain;
        qInfo("together %6.2f, their sum %.2f, of %.2f without any", together / 1e6, sum / 1e6, plain / 1e6);
        QVERIFY(std::abs(together - sum) < 0.05 * sum);

        // Fog lies over everything that is seen, what mirrors and glass show included.
        one = {};
        one.fog = all.fog;
        add("fog", one);
        const double whole = instructionsFor(all);
        QVERIFY(std::abs(whole - plain - sum) < 0.05 * whole);
    }

    void effectsThatShowNothingCostNothing() {
        const double plain = instructionsFor({});
        const double idle = instructionsFor(
            {"reflection 0", "rgb 0.8", "transmit 0", "crand 0", "fog { distance 0 rgb 0.5 }"});
        QVERIFY(plain > 0);
        // They have to be read.
        QVERIFY2(std::abs(idle - plain) < 0.003 * plain, qPrintable(QString::number(idle / plain, 'f', 5)));
    }
};

QTEST_APPLESS_MAIN(EffectCostTest)
#include "effect_cost_test.moc"
