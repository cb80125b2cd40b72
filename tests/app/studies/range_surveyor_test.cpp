// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/range_surveyor.h"

#include <QDockWidget>

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/band_slider.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString torus = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0, 2, -4> look_at 0 angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { f_torus(x, y, z, 0.8, 0.2) }\n"
    "  contained_by { box { -1, 1 } }\n  threshold 0 // [-1:3]\n  max_gradient 1.2\n  pigment { rgb 0.9 "
    "}\n}\n");

}  // namespace

/// The shaded parts of sliders, in the real window.
class RangeSurveyorTest : public QObject {
    Q_OBJECT

  private slots:
    void slidersAreShadedWhereThereIsASurface() {
        WindowDriver d;
        d->resize(1280, 800);
        d->docks()->find("parameters")->raise();
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        ParameterSlider* slider = d->parameters()->slider(d.parameter(QStringLiteral("threshold")));
        QVERIFY(slider);
        QTRY_VERIFY_WITH_TIMEOUT(!slider->presence().pieces.empty(), 30000);
        // From the ring to the middles of top and bottom.
        const auto shown = slider->presence().shown();
        QVERIFY(shown);
        QVERIFY(shown->first <= -0.2 && shown->first > -0.25);
        QVERIFY(std::abs(shown->second - (std::hypot(0.8, 1.0) - 0.2)) < 0.05);
        const auto& band = slider->slider()->band();
        QVERIFY(!band.empty());
        QVERIFY(std::abs(band.front().low - 200) < 15 && std::abs(band.back().high - 520) < 15);
        // It is seen: green pixels at the lower edge, and none in front of it.
        const QImage picture = slider->slider()->grab().toImage();
        const auto greenAt = [&](double share) {
            const QColor pixel =
                picture.pixelColor(static_cast<int>(share * (picture.width() - 1)), picture.height() - 2);
            return pixel.green() - std::max(pixel.red(), pixel.blue());
        };
        QVERIFY(greenAt(0.35) > 20);
        QVERIFY(greenAt(0.05) < 5 && greenAt(0.9) < 5);
        QVERIFY(slider->slider()->toolTip().contains(QStringLiteral("There can be a surface from -0.2")));
    }

    /// A drag keeps its own band, for its own value does not matter; all others are pale until they are
    /// known.
    void othersArePaleAfterADrag() {
        WindowDriver d;
        d->resize(1280, 800);
        d->docks()->find("parameters")->raise();
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        ParameterSlider* threshold = d->parameters()->slider(d.parameter(QStringLiteral("threshold")));
        const int minor = d.parameter(QStringLiteral("Minor Radius"));
        ParameterSlider* dragged = d->parameters()->slider(minor);
        RangeSurveyor* ranges = d->studies()->ranges();
        QTRY_VERIFY_WITH_TIMEOUT(!dragged->presence().pieces.empty() && !ranges->surveying(), 30000);
        const double before = threshold->presence().shown()->first;
        bool ownIsOld = true, otherIsOld = false;
        d.drag(minor, 20, [&] {
            // Panels are told once the picture is there, or has taken long.
            otherIsOld = QTest::qWaitFor([&] { return threshold->slider()->isBandOld(); }, 30000);
            ownIsOld = dragged->slider()->isBandOld();
        });
        QVERIFY(!ownIsOld && otherIsOld);
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(!threshold->slider()->isBandOld(), 30000);
        QVERIFY(threshold->presence().shown()->first < before);
    }
};

QTEST_MAIN(RangeSurveyorTest)
#include "range_surveyor_test.moc"
