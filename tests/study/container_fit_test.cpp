// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/container_fit.h"

#include <QTest>

#include "core/render/render_image.h"
#include "core/study/accuracy/scene_variant.h"
#include "tests/support/povray.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

class ContainerFitTest : public QObject {
    Q_OBJECT

    static ContainerFit fitOf(const RenderRequest& request) {
        return fitContainer(request.scene->isosurfaces.front().shape, *request.scene->parameterTable);
    }
    static RenderRequest with(RenderRequest request, const Container& container) {
        request.scene = sceneVariant(*request.scene, [&](const Isosurface&, IsosurfaceSettings& settings) {
            settings.container = container;
        });
        return request;
    }

  private slots:
    void aSmallerContainerShowsTheSame_data() {
        QTest::addColumn<QString>("inside");
        QTest::addColumn<double>("share");  // the most of the volume that may be left; 1: nothing smaller
        const auto row = [](const char* name, const char* inside, double share) {
            QTest::newRow(name) << QString(inside) << share;
        };
        row("ball in a box", "function { x*x + y*y + z*z - 1 } contained_by { box { -3, 3 } }", 0.022);
        row("ball in a ball", "function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.5 } }", 0.335);
        row("beside the middle",
            "function { f_sphere(x - 0.5, y - 0.3, z, 0.7) } contained_by { box { -3, 3 } }", 0.008);
        row("flat", "function { f_torus(x, y, z, 0.8, 0.1) } contained_by { box { -2, 2 } }", 0.014);
        row("cut by a box, whose side stays",
            "function { x*x + y*y + z*z - 1 } contained_by { box { <-2, -2, 0>, 2 } }", 0.15);
        row("cut by a ball", "function { f_torus(x, y, z, 1, 0.2) } contained_by { sphere { 0, 1.1 } }", 1);
        row("cut and open", "function { x*x + y*y + z*z - 1 } contained_by { box { <-2, 0.2, -2>, 2 } } open",
            0.15);
        row("as small as can be", "function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.001 } }", 1);
        row("full", "function { -1 } contained_by { box { -1, 1 } }", 1);
        // The ball around the lower one holds parts of the upper one.
        row("another part outside",
            "function { min(f_torus(x, y + 0.5, z, 0.9, 0.1), f_sphere(x, y - 0.35, z, 0.2)) } "
            "contained_by { box { <-2, -2, -2>, <2, -0.3, 2> } }",
            0.06);
        row("inside out", "function { 1 - x*x - y*y - z*z } contained_by { sphere { 0, 2 } }", 1);
    }
    void aSmallerContainerShowsTheSame() {
        QFETCH(QString, inside);
        QFETCH(double, share);
        RenderRequest request =
            studyScene("isosurface { " + inside.toStdString() + " pigment { rgb 1 } }", 120, 90);
        request.rootFinder = RootFinder::certified;
        const Container present = request.scene->isosurfaces.front().shape->settings().container;
        const ContainerFit fit = fitOf(request);
        QVERIFY(!fit.empty);
        const std::optional<Container> best = fit.best();
        QCOMPARE(best.has_value(), share < 1);
        if (!best) return;
        qInfo("%s, %.4f of the volume", containerText(*best).c_str(), volumeOf(*best) / volumeOf(present));
        QVERIFY(volumeOf(*best) <= share * volumeOf(present));
        const Image before = renderImage(request), after = renderImage(with(request, *best));
        QVERIFY(comparePictures(before, after).shareWithin8 >= 0.9999);
        for (const std::optional<Container>& other :
             {fit.box ? std::optional<Container>(*fit.box) : std::nullopt,
              fit.sphere ? std::optional<Container>(*fit.sphere) : std::nullopt})
            if (other)
                QVERIFY(comparePictures(before, renderImage(with(request, *other))).shareWithin8 >= 0.9999);
    }

    void whereNothingIsThereIsNothingToFit() {
        const ContainerFit fit =
            fitOf(studyScene("isosurface { function { x*x + y*y + z*z + 1 } contained_by { box { -3, 3 } } "
                             "pigment { rgb 1 } }"));
        QVERIFY(fit.empty);
        QVERIFY(!fit.best());
    }

    void theTextOfAContainerIsReadBackTheSame() {
        const RenderRequest request = studyScene(
            "isosurface { function { f_sphere(x - 0.123456, y, z, 0.7) } contained_by { box { -3, 3 } } }");
        const Container best = *fitOf(request).best();
        const ParseResult again = parseScene("isosurface { function { x } contained_by { " +
                                             containerText(best) + " } } camera { location -3*z look_at 0 }");
        QVERIFY(again.ok());
        QCOMPARE(containerText(again.scene->isosurfaces.front().shape->settings().container),
                 containerText(best));
    }

    void aChangeKeepsEveryOtherCharacter_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("changed");  // empty: it is left alone
        const QString camera = " camera { location -3*z look_at 0 }";
        const QString fitted = "sphere { <0, 0, 0>, 2 }";
        const auto row = [&](const char* name, const QString& text, const QString& changed) {
            QTest::newRow(name) << text + camera << (changed.isEmpty() ? QString() : changed + camera);
        };
        row("written", "isosurface { function { x } /* a */ contained_by{box{-1, R}} pigment { rgb 1 } }",
            "isosurface { function { x } /* a */ contained_by{ " + fitted + " } pigment { rgb 1 } }");
        row("not written", "isosurface { function { x } accuracy 0.1 }",
            "isosurface { function { x }\n  contained_by { " + fitted + " } accuracy 0.1 }");
        row("twice by a loop",
            "#declare I = 0; #while (I < 2) isosurface { function { x } contained_by { box { -1, 1 } } "
            "translate I*x } #declare I = I + 1; #end",
            "");
    }
    void aChangeKeepsEveryOtherCharacter() {
        QFETCH(QString, text);
        QFETCH(QString, changed);
        const std::string before = text.replace('R', '1').toStdString();
        const ParseResult parsed = parseScene(before);
        QVERIFY2(parsed.ok(), parsed.diagnostics.empty() ? "" : parsed.diagnostics.front().message.c_str());
        const auto change = containerChange(*parsed.scene, *parsed.sources, 0, ContainerSphere{{0, 0, 0}, 2});
        QCOMPARE(change.has_value(), !changed.isEmpty());
        if (!change) return;
        const std::string after = changedText(before, {*change});
        QCOMPARE(QString::fromStdString(after), changed);
        QVERIFY(parseScene(after).ok());
    }
};

QTEST_GUILESS_MAIN(ContainerFitTest)
#include "container_fit_test.moc"
