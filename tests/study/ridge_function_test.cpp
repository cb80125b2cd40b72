// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/arguments/ridge_function.h"

#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/study/gradient/gradient_study.h"
#include "tests/support/study_case.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(161803);

const Container box = ContainerBox{{-1.5, -1, -0.25}, {1, 2, 1.75}};
const Container ball = ContainerSphere{{1, -0.5, 0.25}, 1.25};

/// Functions of one or two forms, with kinks, noise, constants and parameters of their own.
const std::vector<std::string>& ridges() {
    static const std::vector<std::string> all = {"1/(0.3 + pow(2.4*x - 0.9*y - 0.2*z, 2))",
                                                 "tanh(3*(x + y - z)) + z",
                                                 "pow(sin(3*(x + 2*y - z)), 3) + 0.5*z",
                                                 "1/(1 + exp(-6*(x + y + z))) - 0.3",
                                                 "1/(0.1 + pow(x + y + z, 2)) + 1/(0.1 + pow(x - y, 2))",
                                                 "sin(4*(x + y + z) - 1)*cos(2*(x - y)/3)",
                                                 "exp(-pow(3*x + 2*y, 2)) + z",
                                                 "sin(3*x - 2*z + 0.25)",
                                                 "abs(x - 2*y) - max(z, sin(5*z))",
                                                 "f_noise3d(2*(x - y + 3), 0.3*z, z)",
                                                 "f_crackle(x + y, 2*(x + y), z)",
                                                 "-(x + y)/3 + sqrt(pow(0.5 - (x + y), 2) + 0.01)"};
    return all;
}

glm::dvec3 anyPlaceIn(const GradientDomain& domain, std::mt19937_64& random) {
    while (true) {
        glm::dvec3 p;
        for (int k = 0; k < 3; ++k)
            p[k] = std::uniform_real_distribution<double>(domain.box().low[k], domain.box().high[k])(random);
        if (domain.contains(p)) return p;
    }
}

double lengthOf(const ValueAndGradient& at) {
    return std::hypot(at.gradient[0], at.gradient[1], at.gradient[2]);
}

std::shared_ptr<const PreparedFunction> prepared(const std::string& body) {
    const StudiedFunction f(body);
    return PreparedFunction::of(f.tape, f.parameters);
}

}  // namespace

class RidgeFunctionTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void valuesAndSlopesAreThoseOfTheFunction() {
        std::mt19937_64 random(seed);
        for (const std::string& body : ridges())
            for (const Container& container : {box, ball}) {
                const auto function = prepared(body);
                const auto ridge = RidgeFunction::of(*function, container);
                QVERIFY2(ridge && ridge->slack >= 0 && ridge->slack < 1e-12, body.c_str());
                const GradientDomain domain(container);
                GradientEvaluator gradients(function), fewer(ridge->function);
                for (int k = 0; k < 500; ++k) {
                    const glm::dvec3 p = anyPlaceIn(domain, random);
                    glm::dvec3 w = ridge->origin;
                    for (int i = 0; i < 2; ++i) w[i] += glm::dot(ridge->axes[static_cast<std::size_t>(i)], p);
                    const ValueAndGradient a = gradients.evaluate(p.x, p.y, p.z),
                                           b = fewer.evaluate(w.x, w.y, w.z);
                    QVERIFY2(std::abs(a.value - b.value) <= 1e-12 * (1 + std::abs(a.value)), body.c_str());
                    QVERIFY2(std::abs(lengthOf(a) - lengthOf(b)) <= 1e-9 * (1 + lengthOf(a)), body.c_str());
                    const GradientBox around{w - 1e-12, w + 1e-12};
                    QVERIFY2(!ridge->domain.misses(around), body.c_str());
                    QVERIFY2(glm::distance(ridge->domain.nearest(w), w) < 1e-12, body.c_str());

                    const glm::dvec3 back = ridge->placeOf(w, domain);
                    QVERIFY2(domain.contains(back), body.c_str());
                    const ValueAndGradient c = gradients.evaluate(back.x, back.y, back.z);
                    QVERIFY2(std::abs(c.value - a.value) <= 1e-6 * (1 + lengthOf(a)), body.c_str());
                }
            }
    }

    /// Beside the corner where its one argument ends, which was neared in steps that became ever shorter.
    void placesBesideACornerAreFound() {
        const Container unit = ContainerBox{glm::dvec3(-1), glm::dvec3(1)};
        const auto function = prepared("sin(2.4*x - 0.9*y - 0.2*z)");
        const auto ridge = RidgeFunction::of(*function, unit);
        QVERIFY(ridge.has_value());
        const GradientDomain domain(unit);
        const double end = ridge->domain.box().high.x;
        for (const double before : {1e-1, 1e-3, 1e-6, 1e-9, 0.0}) {
            const glm::dvec3 place = ridge->placeOf({end - before, 0, 0}, domain);
            QVERIFY(domain.contains(place));
            QVERIFY(std::abs(glm::dot(ridge->axes[0], place) + ridge->origin.x - (end - before)) < 1e-12);
        }
    }

    /// An image that were the box around it would hold steeper places than the container does.
    void theImageOfABoxHasItsCorners() {
        const Container unit = ContainerBox{glm::dvec3(-1), glm::dvec3(1)};
        const auto ridge = RidgeFunction::of(*prepared("(x + y)*(x + y) + (x - z)*(x - z)"), unit);
        QVERIFY(ridge.has_value());
        // Across (1, 1, 0) and what is left of (1, 0, -1): a hexagon.
        const double farthest = 2 / std::sqrt(2.0);
        QVERIFY(std::abs(ridge->domain.box().high.x - farthest) < 1e-12);
        const GradientBox corner{ridge->domain.box().high - glm::dvec3(0.01, 0.01, 0),
                                 ridge->domain.box().high};
        QVERIFY(ridge->domain.misses(corner) && !ridge->domain.encloses(corner));
        QVERIFY(!ridge->domain.contains(corner.center()));
        const glm::dvec3 inside = ridge->domain.nearest(corner.center());
        QVERIFY(glm::distance(inside, corner.center()) > 0.1);
        QVERIFY(!ridge->domain.misses({inside - 1e-9, inside + 1e-9}));
        const GradientBox middle{glm::dvec3(-0.1, -0.1, 0), glm::dvec3(0.1, 0.1, 0)};
        QVERIFY(ridge->domain.encloses(middle) && !ridge->domain.misses(middle));
    }

    void whatDependsOnEveryDirectionHasNone() {
        for (const char* body :
             {"x*x + y*y + z*z", "sin(x + y) + y*z", "sin(x*y)", "sin(x) + cos(z)", "x*(y + z) + z",
              "sin(3*x+2*y+z) + sin(x-3*y+2*z) + sin(2*x+y-3*z)", "sum(i, 1, 90, sin(i*(x + y)))",
              // Nearly parallel, and of no direction at all.
              "sin(x + y) + cos(x + 1.00001*y)", "sin((x + y) - (x + y)) + z"})
            QVERIFY2(!RidgeFunction::of(*prepared(body), box), body);
    }

    /// Places where they are steepest fill planes: a million boxes were not enough.
    void functionsOfFewFormsAreProven() {
        const struct {
            const char* body;
            double steepest;
        } rows[] = {{"1/(1 + exp(-6*(x + y + z))) - 0.3", 1.5 * std::sqrt(3.0)},
                    {"tanh(3*(x + y - z)) + z", std::sqrt(22.0)},
                    {"exp(-pow(3*x + 2*y, 2)) + z", std::sqrt(1 + 13 * 2 / std::exp(1.0))},
                    {"sin(4*(x + y + z))*cos(2*(x - y))", std::sqrt(48.0)},
                    // Of 9 t^2 sqrt(1 - t^2), with t the sine, at t^2 = 2/3.
                    {"pow(sin(3*(x + 2*y - z)), 3)", 9 * 2.0 / 3 * std::sqrt(1.0 / 3) * std::sqrt(6.0)}};
        for (const auto& [body, steepest] : rows) {
            const StudiedFunction f(body);
            const GradientBracket b =
                GradientStudy(f.tape, f.parameters, ContainerBox{glm::dvec3(-1.5), glm::dvec3(1.5)}).run();
            QVERIFY2(b.state == GradientState::tight && b.relativeWidth() <= 0.01, body);
            QVERIFY2(b.lower <= steepest * (1 + 1e-12) && b.upper >= steepest * (1 - 1e-12), body);
            QVERIFY2(b.boxes < 5'000, qPrintable(QString("%1: %2").arg(body).arg(b.boxes)));
        }
    }

    void noPlaceIsSteeperThanTheUpperEnd() {
        std::mt19937_64 random(seed + 1);
        for (const std::string& body : ridges())
            for (const Container& container : {box, ball}) {
                const auto function = prepared(body);
                const GradientBracket b = GradientStudy(function, container, {0.01, 100'000}).run();
                QVERIFY2(std::isfinite(b.upper) && b.lower <= b.upper, body.c_str());
                GradientEvaluator gradients(function);
                const GradientDomain domain(container);
                for (int k = 0; k < 5'000; ++k) {
                    const glm::dvec3 p = anyPlaceIn(domain, random);
                    QVERIFY2(lengthOf(gradients.evaluate(p.x, p.y, p.z)) <= b.upper * (1 + 1e-9),
                             body.c_str());
                }
                QVERIFY2(domain.contains(b.place), body.c_str());
            }
    }

    void jumpsAndPolesAreFoundInTheContainer() {
        const struct {
            const char* body;
            double (*form)(const glm::dvec3&);  ///< whole where the function has no slope
        } rows[] = {{"floor(3*x + 2*y - z)", [](const glm::dvec3& p) { return 3 * p.x + 2 * p.y - p.z; }},
                    {"1/(x + y - z) + z", [](const glm::dvec3& p) { return p.x + p.y - p.z; }},
                    {"sqrt(abs(x - 2*y))", [](const glm::dvec3& p) { return p.x - 2 * p.y; }},
                    {"mod(x + 2*y + 9, 1)*sin(x - z)", [](const glm::dvec3& p) { return p.x + 2 * p.y; }}};
        for (const auto& [body, form] : rows)
            for (const Container& container : {box, ball}) {
                const StudiedFunction f(body);
                const GradientBracket b = GradientStudy(f.tape, f.parameters, container).run();
                QVERIFY2(b.state == GradientState::unbounded && b.singularity && b.beside, body);
                QVERIFY2(std::isfinite(b.beside->upper) && b.beside->lower <= b.beside->upper, body);
                const glm::dvec3 place = b.singularity->place;
                QVERIFY2(GradientDomain(container).contains(place), body);
                const double at = form(place);
                QVERIFY2(std::abs(at - std::round(at)) < 1e-6, body);
            }
    }
};

QTEST_APPLESS_MAIN(RidgeFunctionTest)
#include "ridge_function_test.moc"
