// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that a pattern displaces, proven, beside POV-Ray's; the colour tells how far away they are.
#include <QTest>

#include "test_folders.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

class PatternSurfacesTest : public QObject {
    Q_OBJECT

  private slots:
    void areProvenAndLookLikePovrays_data() {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<bool>("proven");
        for (const char* pattern : {"agate",
                                    "boxed",
                                    "bozo",
                                    "brick",
                                    "cells",
                                    "checker",
                                    "crackle",
                                    "crackle solid",
                                    "crackle solid metric 1",
                                    "crackle metric 3",
                                    "cylindrical",
                                    "gradient <1, 1, 0>",
                                    "granite",
                                    "hexagon",
                                    "leopard",
                                    "marble",
                                    "onion",
                                    "quilted",
                                    "radial frequency 6",
                                    "ripples",
                                    "spherical",
                                    "spiral1 5",
                                    "spotted",
                                    "waves",
                                    "wood",
                                    "wrinkles",
                                    "wood warp { turbulence 0.3 octaves 3 }",
                                    "cells warp { repeat 0.7*x flip x }"})
            QTest::newRow(pattern) << pattern << true;
        for (const char* interpolation : {"", " interpolate 1", " interpolate 2"})
            QTest::addRow("density%s", interpolation)
                << QStringLiteral("density_file df3 \"density.df3\"%1 scale 5 translate -2.5")
                       .arg(interpolation)
                << true;
        for (const char* settings :
             {"", " interpolate 2", " interpolate 3 map_type 1", " once interpolate 2"})
            QTest::addRow("image%s", settings)
                << QStringLiteral("image_pattern { png \"gray.png\"%1 } scale 1.7").arg(settings) << true;
        // What is not proven is as POV-Ray shows it.
        QTest::newRow("object") << "object { torus { 1.4, 0.6 rotate 40*x } }" << false;
        QTest::newRow("image interpolated by distance")
            << "image_pattern { png \"gray.png\" interpolate 4 } scale 1.7" << false;
    }

    void areProvenAndLookLikePovrays() {
        QFETCH(QString, pattern);
        QFETCH(bool, proven);
        const std::string text =
            "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 0.2 }\n"
            "camera { location <1.6, 1.9, -2.8> look_at 0 angle 40 }\n"
            "#declare P = function { pattern { " +
            pattern.toStdString() +
            " scale 0.4 } }\n"
            "isosurface { function { x*x + y*y + z*z - 0.6 - 0.3*P(x, y, z) } contained_by { box { -1, 1 } } "
            "max_gradient 60 "
            "pigment { gradient z color_map { [0 rgb <1, 0.2, 0>] [1 rgb <0, 0.2, 1>] } scale 3 translate "
            "1.5*z } "
            "finish { ambient 1 diffuse 0 } }\n";
        test::PovrayRun run;
        run.width = 80;
        run.height = 60;
        const QString files = QStringLiteral(ISOSCOPE_TEST_DATA "/texture");
        run.libraryPaths = QStringList{files};
        ParseOptions options;
        options.libraryPaths = {files.toStdString()};
        const ParseResult parsed = parseScene(text, options);
        QVERIFY2(parsed.diagnostics.empty(), test::problems(parsed).c_str());
        RenderRequest request = test::requestFor(parsed, run.width, run.height);
        request.rootFinder = RootFinder::certified;
        RenderStatistics statistics;
        const Image ours = renderImage(request, 2, &statistics);
        const auto certified =
            static_cast<double>(statistics.verdicts["certified-hit"] + statistics.verdicts["certified-miss"]);
        QVERIFY2((certified >= 0.999 * run.width * run.height) == proven,
                 qPrintable(QString::number(certified)));
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const Image theirs = test::povrayPicture(text, run);
        test::keepPictures("pattern " + pattern, ours, theirs);
        const test::PictureDifference difference = test::comparePictures(ours, theirs);
        qInfo("%.2f %% within 8/255, mean %.2f", 100 * difference.shareWithin8, difference.mean);
        QVERIFY(difference.shareWithin8 > 0.99);
    }
};

QTEST_APPLESS_MAIN(PatternSurfacesTest)
#include "pattern_surfaces_test.moc"
