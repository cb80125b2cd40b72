// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFile>
#include <QPainter>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "core/render/verdict_map.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/cut_marks.h"
#include "widgets/viewport/scene_guides.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// What is drawn over the picture to tell where one is, and how its edges become smooth.
class GuidesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    /// A ball in a box of the given half side, 1 for the ball.
    void open(double side) {
        QVERIFY(driver_->openText(
            QStringLiteral(
                "camera { location <2, 3, -4> look_at 0 angle 40 }\n"
                "light_source { <5, 5, -5> rgb 1 }\nbackground { rgb <0, 0, 0.4> }\n"
                "isosurface { function { sqrt(x*x + y*y + z*z) - 1 } contained_by { box { -%1, %1 } "
                "} max_gradient 1.1 pigment { rgb <1, 0.2, 0.1> } finish { ambient 1 diffuse 0 } }\n")
                .arg(side)
                .toUtf8(),
            QStringLiteral("ball.pov")));
        QVERIFY(driver_->rests());
    }
    QImage seen() const { return (*driver_)->viewport()->grab().toImage(); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    /// D36: neither axes nor outline of the container.
    void containersAndAxesAreDrawnAndRemembered() {
        open(1.5);
        const Actions& actions = *(*driver_)->actions();
        QVERIFY(!actions.showContainers->isChecked() && !actions.showAxes->isChecked());
        const QImage bare = seen();
        driver_->trigger(actions.showContainers);
        const QImage outlined = seen();
        QVERIFY(difference(bare, outlined) > 0.002);
        driver_->trigger(actions.showAxes);
        QVERIFY(difference(outlined, seen()) > 0.002);
        driver_->trigger(actions.showContainers);
        driver_->trigger(actions.showAxes);
        QCOMPARE(difference(bare, seen()), 0.0);
        driver_->trigger(actions.showAxes);
        driver_->restart();
        QVERIFY((*driver_)->actions()->showAxes->isChecked());
        QVERIFY((*driver_)->viewport()->guides().axesShown());
        QVERIFY(!(*driver_)->viewport()->guides().containersShown());
    }

    /// The edges of a box meet where the projection puts its corners; those behind are fainter.
    void outlineFollowsTheProjection() {
        open(1);
        SceneGuides guides;
        guides.setScene((*driver_)->viewport()->scene().get());
        guides.setContainersShown(true);
        const ViewProjection view((*driver_)->viewport()->projection());
        QImage image((*driver_)->viewport()->size(), QImage::Format_RGB32);
        image.fill(Qt::black);
        {
            QPainter painter(&image);
            guides.paint(painter, view, image.rect());
        }
        const auto brightest = [&](const glm::dvec3& a, const glm::dvec3& b) {
            int most = 0;
            const auto place = view.pixelOf(0.5 * (a + b));
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx)
                    most = std::max(most, qGray(image.pixel(place->toPoint() + QPoint(dx, dy))));
            return most;
        };
        // The camera looks from +x, +y, -z.
        const int near = brightest({1, 1, -1}, {-1, 1, -1}), far = brightest({-1, -1, 1}, {1, -1, 1});
        QVERIFY2(near > 150 && far > 30 && far < near / 2 + 20,
                 qPrintable(QStringLiteral("%1 %2").arg(near).arg(far)));
    }

    /// Line 39 of the features: cut surfaces looked like real ones.
    void cutFacesAreHatched() {
        open(0.8);
        const Actions& actions = *(*driver_)->actions();
        QVERIFY(actions.showCuts->isChecked());
        const VerdictMap& map = *(*driver_)->viewport()->verdicts();
        QVERIFY(map.hasWalls());
        int walls = 0, marked = 0, elsewhere = 0;
        const QImage marks = cutImage(map, 1);
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                walls += map.wall(x, y);
                (map.wall(x, y) ? marked : elsewhere) += qAlpha(marks.pixel(x, y)) > 0;
            }
        QVERIFY2(walls > 500 && marked > walls / 6 && marked < walls / 2, qPrintable(QString::number(walls)));
        QCOMPARE(elsewhere, 0);
        const QImage hatched = seen();
        driver_->trigger(actions.showCuts);
        QVERIFY(difference(hatched, seen()) > 0.002);
    }

    /// D36: single hatched pixels looked like dirt.
    void sliversAreNotHatched() {
        VerdictMap map(60, 60);
        for (int i = 0; i < 60; ++i) map.noteWall(i, 10);
        QVERIFY(map.hasWalls());
        const auto marked = [&] {
            const QImage marks = cutImage(map, 1);
            int count = 0;
            for (int y = 0; y < 60; ++y)
                for (int x = 0; x < 60; ++x) count += qAlpha(marks.pixel(x, y)) > 0;
            return count;
        };
        QCOMPARE(marked(), 0);
        for (int y = 30; y < 50; ++y)
            for (int x = 30; x < 50; ++x) map.noteWall(x, y);
        QVERIFY(marked() > 60);
    }

    /// D36: an axis that leaves the picture had no name.
    void everyAxisIsNamed() {
        open(1);
        Viewport* viewport = (*driver_)->viewport();
        SceneGuides guides;
        guides.setScene(viewport->scene().get());
        guides.setAxesShown(true);
        const auto discs = [&](double zoom) {
            Camera camera = viewport->camera();
            camera.direction *= zoom;
            QImage image(viewport->size(), QImage::Format_RGB32);
            image.fill(Qt::black);
            {
                QPainter painter(&image);
                guides.paint(painter, ViewProjection(camera, image.size()), image.rect());
            }
            int pixels = 0;  // of the ground of a name
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) pixels += image.pixel(x, y) == qRgb(0x22, 0x24, 0x28);
            return pixels;
        };
        const int whole = discs(1), near = discs(4);
        QVERIFY2(whole > 500 && near > 0.8 * whole, qPrintable(QStringLiteral("%1 %2").arg(whole).arg(near)));
    }

    void wholeSurfacesBearNoMarks() {
        open(1.2);
        QVERIFY(!(*driver_)->viewport()->verdicts()->hasWalls());
        QVERIFY(cutImage(*(*driver_)->viewport()->verdicts(), 1).isNull());
    }

    /// D36: edges were jagged. They become smooth in a second picture, behind the first.
    void edgesBecomeSmoothAtRest() {
        open(1.2);
        Viewport* viewport = (*driver_)->viewport();
        const QImage jagged = driver_->picture();
        QVERIFY(distinctColors(jagged) <= 2);
        const RenderProgress told = viewport->progress();
        viewport->setAntialias(true);
        QTRY_VERIFY(!viewport->softening());
        // Nine samples a pixel: up to eight shades between ball and background.
        const int shades = distinctColors(driver_->picture());
        QVERIFY2(shades > 5 && shades <= 10, qPrintable(QString::number(shades)));
        // What was told of the picture, and its verdicts, stay those of the first.
        QCOMPARE(viewport->progress().job, told.job);
        QVERIFY(viewport->verdicts());
        // Another picture begins without, so that it is not held up.
        viewport->setAntialias(true, 0);
        viewport->restart();
        QVERIFY(driver_->rests());
        QVERIFY(distinctColors(driver_->picture()) <= 2);
    }
};

QTEST_MAIN(GuidesTest)
#include "guides_test.moc"
