// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>
#include <QTest>

#include "core/language/parse.h"
#include "core/scene/orbit_view.h"
#include "widgets/viewport/camera_text.h"

using namespace isoscope;

namespace {

Camera parsed(const std::string& block, int width = 800, int height = 600) {
    ParseOptions options;
    options.imageWidth = width;
    options.imageHeight = height;
    return parseScene("#declare D = 4;\n" + block, options).scene->camera;
}

double apart(const Camera& a, const Camera& b) {
    return glm::length(a.location - b.location) + glm::length(a.direction - b.direction) +
           glm::length(a.right - b.right) + glm::length(a.up - b.up);
}

}  // namespace

class CameraTextTest : public QObject {
    Q_OBJECT

  private slots:
    void showsTheMovedView_data() {
        QTest::addColumn<QByteArray>("block");
        QTest::addColumn<QByteArray>("kept");
        QTest::newRow("plain") << QByteArray("camera { location <0, 1, -4> look_at 0 }") << QByteArray();
        QTest::newRow("angle and aspect")
            << QByteArray(
                   "camera {\n  location <2, 1, -4>\n  right x*image_width/image_height\n"
                   "  look_at <0, 0.5, 0> // the middle\n  angle 40\n}")
            << QByteArray("right x*image_width/image_height|// the middle|angle 40");
        QTest::newRow("expressions") << QByteArray(
                                            "camera { look_at D*0 angle 30 location D*<0.5, 0.5, -1> }")
                                     << QByteArray("angle 30");
        QTest::newRow("sky") << QByteArray("camera { location <4, 1, 1> sky z look_at 0 }")
                             << QByteArray("sky z");
        QTest::newRow("transformed") << QByteArray("camera { location -4*z look_at 0 rotate 30*y }")
                                     << QByteArray();
        QTest::newRow("no look_at") << QByteArray("camera { location <0, 0, -5> }") << QByteArray();
        QTest::newRow("orthographic")
            << QByteArray("camera { orthographic location <0, 1, -4> look_at 0 angle 50 }") << QByteArray();
        QTest::newRow("directive") << QByteArray(
                                          "camera { location #if (1) <0, 1, -4> #else 0 #end look_at 0 }")
                                   << QByteArray();
        QTest::newRow("twice") << QByteArray("camera { location <9, 9, 9> location <0, 1, -4> look_at 0 }")
                               << QByteArray();
    }
    void showsTheMovedView() {
        QFETCH(QByteArray, block);
        QFETCH(QByteArray, kept);
        const Camera written = parsed(block.toStdString());
        OrbitView view(written);
        view.orbit(35, -12);
        view.pan(0.1, -0.05);
        view.zoom(1.4);
        const std::string text = cameraText(block.toStdString(), written, view.camera());
        const double error = apart(parsed(text), view.camera());
        QVERIFY2(error < 1e-3, qPrintable(QString("%1: %2").arg(error).arg(QString::fromStdString(text))));
        if (!kept.isEmpty())
            for (const QByteArray& piece : kept.split('|'))
                QVERIFY2(text.find(piece.toStdString()) != std::string::npos, text.c_str());
    }

    void keptAspectFollowsTheSizeOfThePicture() {
        const std::string block =
            "camera { location <2, 1, -4> right x*image_width/image_height look_at 0 angle 40 }";
        OrbitView view(parsed(block));
        view.orbit(20, 5);
        const std::string text = cameraText(block, parsed(block), view.camera());
        const Camera wide = parsed(text, 1600, 900);
        QVERIFY(std::abs(glm::length(wide.right) - 16.0 / 9) < 1e-9);
    }

    void unmovedViewKeepsTheSameCamera() {
        const std::string block = "camera { location <2, 1, -4> look_at <0, 0.1, 0> }";
        QVERIFY(apart(parsed(cameraText(block, parsed(block), parsed(block))), parsed(block)) < 1e-3);
    }
};

QTEST_APPLESS_MAIN(CameraTextTest)
#include "camera_text_test.moc"
