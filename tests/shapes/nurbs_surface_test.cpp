// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <QTest>
#include <random>

#include "core/shapes/patches/nurbs_surface.h"

using namespace isoscope;

namespace {

/// The definition, term by term (Cox 1972, de Boor 1972): what the fast way is held against.
double basisByDefinition(const KnotVector& knots, int i, int order, double t) {
    const auto knot = [&](int k) { return knots.knots[static_cast<std::size_t>(k)]; };
    if (order == 1) {
        // The upper end of the domain belongs to the interval below it.
        if (t == knots.high()) return knot(i) < t && knot(i + 1) == t ? 1 : 0;
        return knot(i) <= t && t < knot(i + 1) ? 1 : 0;
    }
    const double left = knot(i + order - 1) - knot(i), right = knot(i + order) - knot(i + 1);
    return (left > 0 ? (t - knot(i)) / left * basisByDefinition(knots, i, order - 1, t) : 0) +
           (right > 0 ? (knot(i + order) - t) / right * basisByDefinition(knots, i + 1, order - 1, t) : 0);
}

}  // namespace

class NurbsSurfaceTest : public QObject {
    Q_OBJECT

  private slots:
    void basisFollowsItsDefinition() {
        const unsigned seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        for (int round = 0; round < 300; ++round) {
            KnotVector knots;
            knots.order = 1 + static_cast<int>(random() % 5);
            knots.points = knots.order + static_cast<int>(random() % 5);
            double knot = 0;
            for (int k = 0; k < knots.points + knots.order; ++k)
                knots.knots.push_back(knot += static_cast<double>(random() % 3));
            if (!knots.problem().empty()) continue;
            for (int step = 0; step <= 20; ++step) {
                const double t = knots.low() + step / 20.0 * (knots.high() - knots.low());
                int first = 0;
                const std::vector<double> values = knots.basis(t, first);
                QVERIFY(std::abs(std::accumulate(values.begin(), values.end(), 0.0) - 1) < 1e-12);
                for (int k = 0; k < knots.order; ++k)
                    QVERIFY(std::abs(values[static_cast<std::size_t>(k)] -
                                     basisByDefinition(knots, first + k, knots.order, t)) < 1e-12);
            }
        }
    }

    void slopesAreDerivatives() {
        const KnotVector knots{6, 4, {0, 0, 0, 0, 1.5, 1.5, 3, 3, 3, 3}};
        for (const double t : {0.2, 0.7, 1.4, 1.6, 2.9}) {
            int first = 0;
            const std::vector<double> slopes = knots.slopes(t, first);
            const double h = 1e-6;
            const std::vector<double> above = knots.basis(t + h, first), below = knots.basis(t - h, first);
            for (std::size_t k = 0; k < slopes.size(); ++k)
                QVERIFY(std::abs(slopes[k] - (above[k] - below[k]) / (2 * h)) < 1e-8);
        }
    }

    /// Weights of a quarter circle: only a rational surface is exactly round.
    void rationalSurfaceIsRound_VL_NURBS_CONF_70() {
        NurbsSurface surface;
        surface.u = {3, 3, {0, 0, 0, 1, 1, 1}};
        surface.v = {2, 2, {0, 0, 1, 1}};
        const double w = std::sqrt(0.5);
        for (const glm::dvec4& p : {glm::dvec4(1, 0, 0, 1), glm::dvec4(1, 1, 0, w), glm::dvec4(0, 1, 0, 1)})
            for (const double z : {0.0, 2.0}) surface.points.emplace_back(p.x, p.y, z, p.w);
        for (int k = 0; k <= 10; ++k) {
            const NurbsSurface::Place place = surface.at(k / 10.0, 0.3);
            QVERIFY(std::abs(std::hypot(place.point.x, place.point.y) - 1) < 1e-14);
            QVERIFY(std::abs(place.point.z - 0.6) < 1e-14);
            // The tangent along u is across the radius.
            QVERIFY(std::abs(glm::dot(place.along, glm::dvec3(place.point.x, place.point.y, 0))) < 1e-13);
            QVERIFY(std::abs(place.across.z - 2) < 1e-13);
        }
    }

    void problemsAreTold_data() {
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("order");
        QTest::addColumn<QList<double>>("knots");
        QTest::addColumn<QString>("problem");
        QTest::newRow("order") << 3 << 0 << QList<double>{0, 1, 2} << "order";
        QTest::newRow("few points") << 3 << 4 << QList<double>{0, 1, 2, 3, 4, 5, 6} << "at least as many";
        QTest::newRow("count") << 3 << 2 << QList<double>{0, 0, 1, 1} << "need 5 knots";
        QTest::newRow("falling") << 2 << 2 << QList<double>{0, 1, 0, 1} << "decrease";
        QTest::newRow("empty") << 2 << 2 << QList<double>{1, 1, 1, 1} << "no room";
        QTest::newRow("infinite") << 2 << 2 << QList<double>{0, 0, 1, INFINITY} << "finite";
        QTest::newRow("fine") << 2 << 2 << QList<double>{0, 0, 1, 1} << "";
    }
    void problemsAreTold() {
        QFETCH(int, points);
        QFETCH(int, order);
        QFETCH(QList<double>, knots);
        QFETCH(QString, problem);
        const KnotVector vector{points, order, {knots.begin(), knots.end()}};
        const QString found = QString::fromStdString(vector.problem());
        QVERIFY2(problem.isEmpty() ? found.isEmpty() : found.contains(problem), qPrintable(found));
    }
};

QTEST_APPLESS_MAIN(NurbsSurfaceTest)
#include "nurbs_surface_test.moc"
