// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/verdict_map.h"

#include <QTest>

#include "core/render/progressive/progressive_renderer.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int width = 64;
constexpr int height = 48;

const std::string view = "camera { location -4*z look_at 0 } light_source { <5, 5, -5> rgb 1 }\n";
const std::string ball =
    "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.5 } } }\n";
/// The search cannot end along the rays through the plateau at 0.
const std::string plateau =
    "isosurface { function { sin(1e5*(x*y + z))*max(0, sqrt(x*x + y*y) - 0.5)*1e-3 } contained_by { sphere { "
    "0, 1.5 } } }\n";

RenderRequest requestFor(const std::string& text, bool antialias = false) {
    RenderRequest request = test::requestFor(parseScene(text), width, height);
    request.rootFinder = RootFinder::certified;
    request.antialias = antialias;
    request.verdicts = std::make_shared<VerdictMap>(width, height);
    return request;
}

std::uint64_t sumOf(const std::map<std::string, std::uint64_t>& verdicts) {
    std::uint64_t sum = 0;
    for (const auto& [name, count] : verdicts) sum += count;
    return sum;
}

}  // namespace

class VerdictMapTest : public QObject {
    Q_OBJECT

  private slots:
    void theWorstStays() {
        VerdictMap map(3, 2);
        QVERIFY(!map.noted(1, 1));
        QVERIFY(map.at(1, 1) == Verdict::certifiedMiss);
        map.note(1, 1, Verdict::certifiedHit);
        map.note(1, 1, Verdict::certifiedMiss);
        QVERIFY(map.at(1, 1) == Verdict::certifiedHit);
        map.note(1, 1, Verdict::budgetExceeded);
        map.note(1, 1, Verdict::gap);
        QVERIFY(map.at(1, 1) == Verdict::budgetExceeded);
        map.note(1, 1, Verdict::notCertified);
        QVERIFY(map.at(1, 1) == Verdict::notCertified);
        QVERIFY(!map.noted(2, 1));
        map.note(3, 0, Verdict::gap);  // outside
        map.note(-1, 0, Verdict::gap);
        QVERIFY(map.at(0, 1) == Verdict::certifiedMiss);
        QCOMPARE(VerdictMap(-5, 3).width(), 0);
    }

    void aBallIsCertain() {
        const RenderRequest request = requestFor(view + ball);
        RenderStatistics statistics;
        renderImage(request, 2, &statistics);
        QCOMPARE(statistics.verdicts.size(), std::size_t{2});
        QVERIFY(statistics.verdicts["certified-hit"] > 300);
        QCOMPARE(sumOf(statistics.verdicts), std::uint64_t{width * height});
        QVERIFY(request.verdicts->at(width / 2, height / 2) == Verdict::certifiedHit);
        QVERIFY(request.verdicts->at(0, 0) == Verdict::certifiedMiss);
        QVERIFY(request.verdicts->noted(0, 0));
    }

    void doubtComesThroughCsgTransformsAndSmoothEdges_data() {
        QTest::addColumn<QString>("object");
        QTest::newRow("alone") << QString::fromStdString(plateau);
        QTest::newRow("placed") << QString::fromStdString("object { " + plateau + " scale 1.1 rotate y*3 }");
        QTest::newRow("intersection")
            << QString::fromStdString("intersection { " + plateau + " box { -1, 1 } rotate z*10 }");
    }
    void doubtComesThroughCsgTransformsAndSmoothEdges() {
        QFETCH(QString, object);
        for (const bool antialias : {false, true}) {
            const RenderRequest request = requestFor(view + object.toStdString(), antialias);
            RenderStatistics statistics;
            renderImage(request, 2, &statistics);
            const std::uint64_t doubtful = sumOf(statistics.verdicts) - statistics.verdicts["certified-hit"] -
                                           statistics.verdicts["certified-miss"];
            QVERIFY(doubtful > 10);
            std::uint64_t marked = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) marked += request.verdicts->at(x, y) >= Verdict::gap;
            QVERIFY(marked > 10);
            if (!antialias) QCOMPARE(marked, doubtful);
        }
    }

    void wallsAreNotedWhereTheyAreSeen_data() {
        QTest::addColumn<QString>("objects");
        const QString cut = "isosurface { function { x*x + y*y + z*z - 1.2 } contained_by { box { -1, 1 } } ";
        QTest::newRow("one, beside the middle") << cut + "scale 0.5 translate <1.3, 0.4, 0> }";
        QTest::newRow("two that are far apart")
            << cut + "scale 0.45 translate <-1.3, 0.6, 0> } sphere { <1.5, -0.8, 0>, 0.3 pigment { rgb 1 } }";
    }
    void wallsAreNotedWhereTheyAreSeen() {
        QFETCH(QString, objects);
        const RenderRequest request = requestFor(view + objects.toStdString());
        renderImage(request, 1);
        const SceneObject& isosurface = request.scene->objects.front();
        TraceContext context(request.scene->parameterTable, RootFinder::certified);
        int walls = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Ray ray = request.camera.ray((x + 0.5) / width - 0.5, 0.5 - (y + 0.5) / height);
                NearestHit seen;
                isosurface.shape->nearest({&ray, 1}, context, {&seen, 1});
                const bool wall = seen.found && seen.hit.kind == HitKind::container;
                walls += wall;
                QVERIFY2(request.verdicts->wall(x, y) == wall, qPrintable(QString("%1, %2").arg(x).arg(y)));
            }
        QVERIFY(walls > 20);
    }

    void theProgressivePictureTellsTheSame() {
        const RenderRequest once = requestFor(view + plateau);
        RenderStatistics statistics;
        renderImage(once, 1, &statistics);
        const RenderRequest slowly = requestFor(view + plateau);
        ProgressiveRenderer renderer(2);
        renderer.request(slowly);
        QTRY_VERIFY_WITH_TIMEOUT(renderer.progress().finished, 60000);
        QVERIFY(renderer.progress().statistics.verdicts == statistics.verdicts);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) QVERIFY(once.verdicts->at(x, y) == slowly.verdicts->at(x, y));
    }

    void povraysRootFinderTellsItsHits() {
        RenderRequest request = requestFor(view + ball);
        request.rootFinder = RootFinder::lipschitz;
        RenderStatistics statistics;
        renderImage(request, 2, &statistics);
        QVERIFY(statistics.verdicts.contains("hit"));
        QVERIFY(!statistics.verdicts.contains("certified-hit"));
        QVERIFY(!request.verdicts->noted(0, 0));
    }
};

QTEST_GUILESS_MAIN(VerdictMapTest)
#include "verdict_map_test.moc"
