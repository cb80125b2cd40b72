// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <functional>
#include <QTest>

#include "core/function/graph_builder.h"
#include "core/render/progressive/progressive_renderer.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/isosurface/isosurface.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

using Formula = std::function<Expression(Expression x, Expression y, Expression z)>;

/// An isosurface built by hand, and the same in words.
struct PictureCase {
    std::string name;
    Formula formula;
    std::string function;
    IsosurfaceSettings settings;
    std::string items;    ///< the settings in words
    glm::dvec3 turn{0};   ///< degrees
    double share = 0.99;  ///< of the pixels that must agree
};

Function functionOf(const Formula& formula) {
    auto graph = std::make_shared<FunctionGraph>();
    const auto variable = [&](int index) { return Expression(*graph, graph->variable(index)); };
    const Expression result = formula(variable(0), variable(1), variable(2));
    Function function;
    function.graph = graph;
    function.argumentCount = 3;
    function.results = {result.node()};
    return function;
}

Expression ball(Expression x, Expression y, Expression z) { return sq(x) + sq(y) + sq(z) - 1; }
Expression gyroid(Expression x, Expression y, Expression z) {
    return sin(x * 4) * cos(y * 4) + sin(y * 4) * cos(z * 4) + sin(z * 4) * cos(x * 4);
}

std::vector<PictureCase> cases() {
    std::vector<PictureCase> all;
    const std::string ballText = "x*x + y*y + z*z - 1";
    const std::string gyroidText = "sin(x*4)*cos(y*4) + sin(y*4)*cos(z*4) + sin(z*4)*cos(x*4)";
    const auto add = [&](const char* name, const Formula& formula, const std::string& text, auto change,
                         const std::string& items) {
        PictureCase item{name, formula, text, {}, items};
        change(item.settings);
        all.push_back(item);
    };
    const auto box = [](IsosurfaceSettings& s) {
        s.maxGradient = 5;
        s.container = ContainerBox{glm::dvec3(-1.2), glm::dvec3(1.2)};
    };
    const std::string boxText = " contained_by { box { -1.2, 1.2 } } max_gradient 5";
    add("ball", ball, ballText, box, boxText);
    add(
        "ball of coarse accuracy", ball, ballText,
        [&](IsosurfaceSettings& s) {
            box(s);
            s.accuracy = 0.1;
        },
        boxText + " accuracy 0.1");
    add(
        "gyroid cut by its box", gyroid, gyroidText,
        [&](IsosurfaceSettings& s) {
            box(s);
            s.maxGradient = 7;
        },
        " contained_by { box { -1.2, 1.2 } } max_gradient 7");
    add(
        "open gyroid in a sphere", gyroid, gyroidText,
        [](IsosurfaceSettings& s) {
            s.maxGradient = 7;
            s.open = true;
            s.container = ContainerSphere{glm::dvec3(0), 1.3};
        },
        " contained_by { sphere { 0, 1.3 } } max_gradient 7 open");
    add(
        "ball with holes", ball, ballText,
        [&](IsosurfaceSettings& s) {
            box(s);
            s.maxGradient = 0.7;
        },
        " contained_by { box { -1.2, 1.2 } } max_gradient 0.7");
    add(
        "ball with evaluate", ball, ballText,
        [&](IsosurfaceSettings& s) {
            box(s);
            s.evaluate = {{1.1, 1.4, 0.99}};
        },
        " contained_by { box { -1.2, 1.2 } } evaluate 1.1, 1.4, 0.99");
    for (PictureCase& item : all) item.turn = {0, 30, 10};
    return all;
}

std::string textOf(const PictureCase& item) {
    return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
           "camera { location <0,1,-4> right x*4/3 look_at 0 }\nbackground { rgb <0.1,0.3,0.6> }\n"
           "light_source { <5,4,-4>, 1 }\nisosurface { function { " +
           item.function + " }" + item.items +
           " pigment { rgb <0.9,0.7,0.3> } finish { phong 0.5 } rotate <0,30,10> }\n";
}

std::shared_ptr<const Scene> sceneOf(const PictureCase& item) {
    auto scene = std::make_shared<Scene>();
    scene->camera.location = {0, 1, -4};
    scene->camera.right = {4.0 / 3, 0, 0};
    scene->camera = scene->camera.lookingAt({0, 0, 0});
    scene->background = {0.1, 0.3, 0.6};
    scene->lights.emplace_back().location = {5, 4, -4};
    Material material;
    SolidPigment pigment;
    pigment.color = {0.9, 0.7, 0.3};
    material.pigment = pigment;
    material.finish.phong = 0.5;
    scene->materials.push_back(material);
    IsosurfaceSettings settings = item.settings;
    settings.function = functionOf(item.formula);
    const auto shape = std::make_shared<Isosurface>(settings);
    SceneObject object;
    object.shape = std::make_shared<PlacedShape>(shape, Transform::rotation(item.turn), 0);
    object.material = 0;
    scene->objects.push_back(object);
    SceneIsosurface known;
    known.shape = shape;
    scene->isosurfaces.push_back(known);
    return scene;
}

RenderRequest requestFor(const PictureCase& item, int width, int height) {
    return test::requestFor(sceneOf(item), width, height);
}

}  // namespace

class IsosurfacePictureTest : public QObject {
    Q_OBJECT

    static void addRows() {
        QTest::addColumn<int>("number");
        const auto all = cases();
        for (std::size_t i = 0; i < all.size(); ++i)
            QTest::newRow(all[i].name.c_str()) << static_cast<int>(i);
    }

  private slots:
    void agreesWithPovray_data() { addRows(); }
    void agreesWithPovray() {
        QFETCH(int, number);
        const PictureCase item = cases()[static_cast<std::size_t>(number)];
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        test::PovrayRun run;
        const Image theirs = test::povrayPicture(textOf(item), run);
        const Image ours = renderImage(requestFor(item, run.width, run.height));
        const test::PictureDifference difference = test::comparePictures(ours, theirs);
        std::printf("%s: %.3f %% within 8/255\n", item.name.c_str(), 100 * difference.shareWithin8);
        if (difference.shareWithin8 < item.share)
            test::keepPictures(QString::fromStdString("isosurface " + item.name), ours, theirs);
        QVERIFY(difference.shareWithin8 >= item.share);
    }

    void threadsAndPassesDoNotChangeThePicture_data() { addRows(); }
    void threadsAndPassesDoNotChangeThePicture() {
        QFETCH(int, number);
        const RenderRequest request = requestFor(cases()[static_cast<std::size_t>(number)], 83, 61);
        const Image image = renderImage(request, 1);
        QVERIFY(renderImage(request, 3).pixels == image.pixels);

        ProgressiveRenderer renderer(2);
        renderer.request(request);
        std::vector<std::uint32_t> shown(image.pixels.size());
        while (true) {
            const bool finished = renderer.progress().finished;
            for (const FinishedTile& tile : renderer.takeTiles())
                for (int y = 0; y < tile.height; ++y)
                    for (int x = 0; x < tile.width; ++x)
                        shown[(tile.y + y) * 83 + tile.x + x] = tile.pixels[y * tile.width + x];
            if (finished) break;
        }
        for (std::size_t i = 0; i < shown.size(); ++i) QCOMPARE(shown[i], encodePixel(image.pixels[i]));
    }

    void reportsTheGradient() {
        RenderStatistics statistics;
        renderImage(requestFor(cases()[4], 80, 60), 2, &statistics);
        QCOMPARE(statistics.gradients.size(), std::size_t{1});
        QCOMPARE(statistics.gradients[0].maxGradient, 0.7);
        QVERIFY(statistics.gradients[0].steepest > 1.5);
        QVERIFY(statistics.gradients[0].searches > 1000);
        QVERIFY(gradientWarning(statistics.gradients[0]).find("may have holes") != std::string::npos);
        QVERIFY(statistics.evaluations > 1000);
    }
};

QTEST_GUILESS_MAIN(IsosurfacePictureTest)
#include "isosurface_picture_test.moc"
