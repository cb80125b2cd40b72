// SPDX-License-Identifier: GPL-3.0-or-later
// Every built-in with its defaults: a bracket, or a named singularity; and what is suggested loses nothing.
#include <QTest>

#include "core/function/builtins/builtin.h"
#include "core/study/accuracy/scene_variant.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/gradient/hole_map.h"
#include "tests/support/builtin_scene.h"
#include "tests/support/study_case.h"
#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

class BuiltinGradientTest : public QObject {
    Q_OBJECT

  private:
    static RenderRequest sceneOf(const Builtin& builtin) {
        RenderRequest request = studyScene(builtinStatement(builtin), 48, 36);
        const Bounds bounds = request.scene->objects.front().shape->bounds();
        const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high), extent = bounds.high - bounds.low;
        const double size = std::max({extent.x, extent.y, extent.z});
        request.camera.location = middle + size * glm::dvec3(0.4, 0.9, -1.9);
        request.camera = request.camera.lookingAt(middle);
        return request;
    }

  private slots:
    void isBracketedOrNamed_data() {
        QTest::addColumn<QString>("name");
        for (const Builtin& builtin : builtins())
            if (!builtin.name.empty() && builtin.pointArguments == 3)
                QTest::newRow(builtin.name.c_str()) << QString::fromStdString(builtin.name);
    }

    void isBracketedOrNamed() {
        QFETCH(QString, name);
        const RenderRequest request = sceneOf(*findBuiltin(name.toStdString()));
        QCOMPARE(request.scene->isosurfaces.size(), std::size_t(1));
        const auto& surface = request.scene->isosurfaces.front().shape;
        GradientStudy study(surface->tape(), *request.scene->parameterTable, surface->settings().container,
                            {0.1, 12'000});
        const GradientBracket& b = study.run();
        QVERIFY(!std::isnan(b.lower) && !std::isnan(b.upper) && b.lower <= b.upper);
        qInfo("%-24s %s%s%s: %.6g to %.6g, suggested %.6g", qPrintable(name),
              std::string(isoscope::name(b.state)).c_str(), b.singularity ? " at a " : "",
              b.singularity ? std::string(isoscope::name(b.singularity->kind)).c_str() : "", b.lower, b.upper,
              suggestedGradient(b));
        if (std::isinf(b.upper)) {
            QVERIFY(b.singularity.has_value());
            // Suspected places, neither proven infinite nor bounded, are these and no others.
            static const QStringList open = {QStringLiteral("f_comma"), QStringLiteral("f_spiral")};
            QVERIFY(b.state == GradientState::unbounded || open.contains(name));
            return;
        }
        const auto tuned = sceneVariant(*request.scene, [&](const Isosurface&, IsosurfaceSettings& settings) {
            settings.maxGradient = suggestedGradient(b);
            // Sheets thinner than the accuracy are lost with any max_gradient.
            settings.accuracy = 1e-7;
        });
        RenderRequest picture = request;
        picture.scene = tuned;
        const HoleMap map = holeMap(picture);
        QVERIFY2(map.count(HolePixel::lost) == 0, qPrintable(QString::number(map.count(HolePixel::lost))));
        QVERIFY2(map.count(HolePixel::wrongPlace) == 0,
                 qPrintable(QString::number(map.count(HolePixel::wrongPlace))));
    }
};

QTEST_APPLESS_MAIN(BuiltinGradientTest)
#include "builtin_gradient_test.moc"
