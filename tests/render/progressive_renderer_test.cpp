// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/progressive_renderer.h"

#include <atomic>
#include <future>
#include <map>
#include <QTest>
#include <random>
#include <thread>

#include "core/render/picture.h"
#include "tests/support/gated_shape.h"
#include "tests/support/lighting_case.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::GatedShape;

namespace {

constexpr int threads = 2;

RenderRequest requestFor(std::shared_ptr<const Scene> scene, int width = 101, int height = 67) {
    return test::requestFor(std::move(scene), width, height);
}

std::shared_ptr<const Scene> litScene(double red = 0.8) {
    test::LightingCase item;
    item.pigment.red = red;
    item.box = true;
    item.lights.emplace_back().location = {3, 5, -4};
    return test::sceneOf(item);
}

std::shared_ptr<const Scene> gatedScene(const std::shared_ptr<GatedShape>& shape) {
    auto scene = std::make_shared<Scene>();
    scene->camera.location = {0, 0, -4};
    SceneObject object;
    object.shape = shape;
    scene->objects.push_back(object);
    return scene;
}

/// Collects tiles as a window does, and how many pixels each job has delivered.
struct Canvas {
    Canvas(int canvasWidth, int canvasHeight) : width(canvasWidth), pixels(canvasWidth * canvasHeight) {}

    void take(ProgressiveRenderer& renderer) {
        for (const FinishedTile& tile : renderer.takeTiles()) {
            delivered[tile.job] += tile.width * tile.height;
            for (int y = 0; y < tile.height; ++y)
                for (int x = 0; x < tile.width; ++x)
                    pixels[(tile.y + y) * width + tile.x + x] = tile.pixels[y * tile.width + x];
        }
    }
    void takeAll(ProgressiveRenderer& renderer) {
        while (!renderer.progress().finished) {
            take(renderer);
            std::this_thread::yield();
        }
        take(renderer);
    }

    int width;
    std::vector<std::uint32_t> pixels;
    std::map<std::uint64_t, int> delivered;
};

std::vector<std::uint32_t> encoded(const Image& image) {
    std::vector<std::uint32_t> result;
    for (const auto& pixel : image.pixels) result.push_back(encodePixel(pixel));
    return result;
}

}  // namespace

class ProgressiveRendererTest : public QObject {
    Q_OBJECT

  private slots:
    void endsWithTheBytesOfRenderImage() {
        for (bool antialias : {false, true}) {
            RenderRequest request = requestFor(litScene());
            request.antialias = antialias;
            ProgressiveRenderer renderer(threads);
            renderer.request(request);
            Canvas canvas(101, 67);
            canvas.takeAll(renderer);
            QCOMPARE(canvas.pixels, encoded(renderImage(request)));
            QCOMPARE(canvas.delivered[1], 3 * 101 * 67);
        }
    }

    void tracesNoPixelTwice() {
        ProgressiveRenderer renderer(threads);
        renderer.request(requestFor(litScene()));
        Canvas canvas(101, 67);
        canvas.takeAll(renderer);
        const RenderProgress progress = renderer.progress();
        QVERIFY(progress.statistics.stages.front().kind == StageKind::primaryRays);
        QCOMPARE(progress.statistics.stages.front().rays, std::uint64_t{101 * 67});
        QCOMPARE(progress.pass, 3);
        QCOMPARE(progress.passCount, 3);
    }

    void endsEarlierWithCoarserBlocks() {
        const std::map<int, int> passes{{1, 3}, {2, 2}, {4, 2}, {8, 1}, {99, 1}, {0, 3}, {-5, 3}};
        for (const auto& [block, count] : passes) {
            ProgressiveRenderer renderer(threads);
            renderer.request(requestFor(litScene()), block);
            Canvas canvas(101, 67);
            canvas.takeAll(renderer);
            QCOMPARE(renderer.progress().passCount, count);
            QCOMPARE(renderer.progress().pass, count);
            QCOMPARE(canvas.delivered[1], count * 101 * 67);
        }
    }

    void drawsQuickPicturesInOnePass() {
        const RenderRequest request = requestFor(litScene());
        ProgressiveRenderer renderer(threads);
        for (const int passes : {3, 1, 1}) {
            const std::uint64_t job = renderer.request(request, 1, 1000);
            Canvas canvas(101, 67);
            canvas.takeAll(renderer);
            QCOMPARE(renderer.progress().passCount, passes);
            QCOMPARE(renderer.progress().pass, passes);
            QCOMPARE(canvas.delivered[job], passes * 101 * 67);
            QCOMPARE(canvas.pixels, encoded(renderImage(request)));
        }
        renderer.request(request, 2, 1000);
        Canvas(101, 67).takeAll(renderer);
        QCOMPARE(renderer.progress().passCount, 2);
        renderer.request(request, 1, 1e-9);
        Canvas(101, 67).takeAll(renderer);
        QCOMPARE(renderer.progress().passCount, 3);
    }

    void beginsAnewWithCoarseBlocksWhenAQuickPictureIsSlow() {
        ProgressiveRenderer renderer(threads);
        renderer.request(requestFor(litScene(), 300, 200));
        Canvas(300, 200).takeAll(renderer);
        const double atOnce = std::max(0.05, 2 * renderer.progress().seconds);
        const auto slow = std::make_shared<GatedShape>();
        slow->allow(0);
        const RenderRequest request = requestFor(gatedScene(slow), 300, 200);
        const std::uint64_t job = renderer.request(request, 1, atOnce);
        slow->waitForCalls(1);
        QCOMPARE(renderer.progress().passCount, 1);
        std::this_thread::sleep_for(std::chrono::duration<double>(4 * atOnce));
        slow->allow(-1);
        Canvas canvas(300, 200);
        canvas.takeAll(renderer);
        QCOMPARE(renderer.progress().passCount, 3);
        QCOMPARE(renderer.progress().pass, 3);
        QCOMPARE(canvas.delivered[job], 3 * 300 * 200);
        QCOMPARE(renderer.progress().statistics.stages.front().rays, std::uint64_t{300 * 200});
        QCOMPARE(canvas.pixels, encoded(renderImage(request)));
        // And the next one does not try.
        slow->allow(0);
        const int calls = slow->calls;
        renderer.request(request, 1, atOnce);
        slow->waitForCalls(calls + 1);
        QCOMPARE(renderer.progress().passCount, 3);
        slow->allow(-1);
    }

    void tellsOfTheFirstPassAndOfTheEnd() {
        std::vector<int> passes;
        std::vector<bool> finished;
        std::atomic<bool> ended{false};
        ProgressiveRenderer* asked = nullptr;
        ProgressiveRenderer renderer(threads, [&] {
            const RenderProgress progress = asked->progress();
            passes.push_back(progress.pass);
            finished.push_back(progress.finished);
            ended = progress.finished;
        });
        asked = &renderer;
        renderer.request(requestFor(litScene()));
        QTRY_VERIFY(ended);
        QCOMPARE(passes, (std::vector<int>{1, 3}));
        QCOMPARE(finished, (std::vector<bool>{false, true}));
        ended = false;
        renderer.request(requestFor(litScene()), 1, 1000);
        QTRY_VERIFY(ended);
        QCOMPARE(passes, (std::vector<int>{1, 3, 1}));
        QCOMPARE(finished, (std::vector<bool>{false, true, true}));
    }

    void theFirstPassEndsUnderAStormOfRequests() {
        const auto first = std::make_shared<GatedShape>();
        const auto last = std::make_shared<GatedShape>();
        first->allow(0);
        last->allow(0);
        ProgressiveRenderer renderer(threads);
        renderer.request(requestFor(gatedScene(first), 300, 200));
        first->waitForCalls(1);
        for (int i = 0; i < 50; ++i) renderer.request(requestFor(litScene(), 300, 200));
        const std::uint64_t newest = renderer.request(requestFor(gatedScene(last), 300, 200));
        first->allow(-1);
        last->waitForCalls(1);  // the first job has ended
        Canvas canvas(300, 200);
        canvas.take(renderer);
        const std::map<std::uint64_t, int> onePass{{1, 300 * 200}};
        QCOMPARE(canvas.delivered, onePass);
        last->allow(-1);
        canvas.takeAll(renderer);
        const std::map<std::uint64_t, int> both{{1, 300 * 200}, {newest, 3 * 300 * 200}};
        QCOMPARE(canvas.delivered, both);
    }

    void theLatestRequestWins() {
        ProgressiveRenderer renderer(threads);
        std::mt19937 random(20);
        RenderRequest request;
        std::uint64_t job = 0;
        for (int i = 0; i < 60; ++i) {
            request = requestFor(litScene(i / 60.0));
            job = renderer.request(request);
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
        }
        QCOMPARE(job, std::uint64_t{60});
        Canvas canvas(101, 67);
        canvas.takeAll(renderer);
        QCOMPARE(renderer.progress().job, job);
        QCOMPARE(canvas.pixels, encoded(renderImage(request)));
    }

    void aReplacedJobLetsGoAfterOneBatchPerThread() {
        const auto shape = std::make_shared<GatedShape>();
        const int firstPassCalls = 6;  // 3 x 2 tiles of 128 pixels, a batch each
        shape->allow(firstPassCalls + 3);
        ProgressiveRenderer renderer(threads);
        renderer.request(requestFor(gatedScene(shape), 384, 256));
        shape->waitForCalls(firstPassCalls + 3);
        renderer.request(requestFor(litScene()));
        const int before = shape->calls;
        shape->allow(-1);
        Canvas canvas(384, 256);
        canvas.takeAll(renderer);
        QVERIFY2(shape->calls <= before + threads, std::to_string(shape->calls - before).c_str());
        QCOMPARE(renderer.progress().job, std::uint64_t{2});
        QCOMPARE(renderer.progress().pass, 3);
    }

    void stopNeedsNoMoreThanOneBatchPerThread() {
        const auto shape = std::make_shared<GatedShape>();
        shape->allow(0);
        ProgressiveRenderer renderer(threads);
        renderer.request(requestFor(gatedScene(shape), 1024, 1024));
        shape->waitForCalls(1);
        renderer.stop();
        const int before = shape->calls;
        shape->allow(-1);
        Canvas canvas(1024, 1024);
        canvas.takeAll(renderer);
        QVERIFY(shape->calls <= before + threads);
        QCOMPARE(renderer.progress().pass, 0);
        QVERIFY(renderer.progress().finished);
    }

    void stopForgetsTheWaitingRequest() {
        const auto shape = std::make_shared<GatedShape>();
        const auto other = std::make_shared<GatedShape>();
        shape->allow(0);
        ProgressiveRenderer renderer(threads);
        renderer.request(requestFor(gatedScene(shape)));
        shape->waitForCalls(1);
        renderer.request(requestFor(gatedScene(other)));
        renderer.stop();
        shape->allow(-1);
        Canvas canvas(101, 67);
        canvas.takeAll(renderer);
        QCOMPARE(other->calls.load(), 0);
    }

    void saysWhetherItHasFinished() {
        ProgressiveRenderer renderer(threads);
        QVERIFY(renderer.progress().finished);
        QCOMPARE(renderer.progress().job, std::uint64_t{0});
        const auto shape = std::make_shared<GatedShape>();
        shape->allow(0);
        QCOMPARE(renderer.request(requestFor(gatedScene(shape))), std::uint64_t{1});
        QVERIFY(!renderer.progress().finished);
        shape->waitForCalls(1);
        QVERIFY(!renderer.progress().finished);
        QCOMPARE(renderer.progress().pass, 0);
        QCOMPARE(renderer.progress().passCount, 3);
        shape->allow(-1);
        Canvas canvas(101, 67);
        canvas.takeAll(renderer);
        QCOMPARE(renderer.progress().pass, 3);
        QVERIFY(renderer.progress().seconds > 0);
        renderer.stop();
        QVERIFY(renderer.progress().finished);
    }

    void canBeDestroyedAtAnyMoment() {
        std::mt19937 random(7);
        for (int i = 0; i < 60; ++i) {
            ProgressiveRenderer renderer(threads);
            for (unsigned k = random() % 4; k > 0; --k) renderer.request(requestFor(litScene(), 200, 150));
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 4000));
        }
        const auto shape = std::make_shared<GatedShape>();
        shape->allow(1);
        {
            ProgressiveRenderer renderer(1);
            renderer.request(requestFor(gatedScene(shape), 2000, 2000));
            shape->waitForCalls(2);
            std::jthread opener([&] { shape->allow(-1); });
        }
        QVERIFY(shape->calls < 2000);
    }

    void aSceneThatTakesLongToGoKeepsNoCallerWaiting() {
        // Threads that ask while a scene goes; a renderer that keeps them waiting would never answer.
        std::vector<std::jthread> asking;
        std::atomic<int> gone = 0, answered = 0;
        ProgressiveRenderer renderer(1);
        const auto dearScene = [&] {
            return std::shared_ptr<const Scene>(new Scene(*litScene()), [&](const Scene* scene) {
                const auto asked = std::make_shared<std::promise<void>>();
                asking.emplace_back([&renderer, asked] {
                    renderer.progress();
                    asked->set_value();
                });
                const auto answer = asked->get_future().wait_for(std::chrono::seconds(20));
                answered += answer == std::future_status::ready;
                delete scene;
                ++gone;
            });
        };
        renderer.request(requestFor(dearScene()));
        QTRY_COMPARE(gone.load(), 1);
        const auto shape = std::make_shared<GatedShape>();
        shape->allow(0);
        renderer.request(requestFor(gatedScene(shape)));
        shape->waitForCalls(1);
        renderer.request(requestFor(dearScene()));
        renderer.request(requestFor(dearScene()));
        const int replaced = gone.load();
        renderer.stop();
        const int stopped = gone.load();
        shape->allow(-1);
        QCOMPARE(replaced, 2);
        QCOMPARE(stopped, 3);
        QCOMPARE(answered.load(), 3);
    }

    void oddSizes() {
        for (auto [width, height] : {std::pair{1, 1}, {1, 9}, {8, 8}, {33, 1}, {129, 5}}) {
            const RenderRequest request = requestFor(litScene(), width, height);
            ProgressiveRenderer renderer(threads);
            renderer.request(request);
            Canvas canvas(width, height);
            canvas.takeAll(renderer);
            QCOMPARE(canvas.pixels, encoded(renderImage(request)));
        }
    }

    void refusesWhatCannotBeDrawn() {
        for (auto [width, height] :
             {std::pair{0, 0}, {0, 5}, {5, 0}, {-3, 4}, {200'000, 200'000}, {INT_MAX, INT_MAX}}) {
            ProgressiveRenderer renderer(threads);
            QCOMPARE(renderer.request(requestFor(litScene(), width, height)), std::uint64_t{1});
            Canvas canvas(1, 1);
            canvas.takeAll(renderer);
            QVERIFY(canvas.delivered.empty());
            QCOMPARE(renderer.progress().passCount, 0);
        }
        ProgressiveRenderer renderer(threads);
        RenderRequest request;
        request.width = request.height = 10;
        renderer.request(request);
        Canvas canvas(1, 1);
        canvas.takeAll(renderer);
        QVERIFY(canvas.delivered.empty());
    }
};

QTEST_APPLESS_MAIN(ProgressiveRendererTest)
#include "progressive_renderer_test.moc"
