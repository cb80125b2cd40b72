// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pictures/picture_queue.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/language/parse.h"
#include "widgets/pictures/picture_queue_window.h"

using namespace isoscope;

namespace {

/// `repeats` makes the function dear.
RenderRequest request(int width, int height, int repeats = 0) {
    std::string text =
        "#include \"functions.inc\"\ncamera { location <0, 0, -4> look_at 0 } background { rgb <0, 0, 1> }\n"
        "isosurface { function { sqrt(x*x + y*y + z*z) - 1";
    for (int i = 1; i < repeats; ++i) text += " + 0*f_noise3d(x*" + std::to_string(i) + ", y, z)";
    text +=
        " } contained_by { sphere { 0, 1.2 } } pigment { rgb <1, 0, 0> } finish { ambient 1 diffuse 0 } }\n";
    RenderRequest made;
    made.scene = parseScene(text).scene;
    made.camera = made.scene->camera;
    made.width = width;
    made.height = height;
    return made;
}

}  // namespace

class PictureQueueTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

  private slots:
    void picturesComeOneAfterTheOther() {
        PictureQueue queue;
        QSignalSpy ended(&queue, &PictureQueue::ended);
        QList<int> numbers;
        for (const char* name : {"a.png", "b.png", "c.png"})
            numbers << queue.add(path(name), request(120, 80), {});
        QCOMPARE(queue.open(), 3);
        QVERIFY(queue.picture(numbers[0]).state == QueuedPicture::State::drawing);
        QVERIFY(queue.picture(numbers[2]).state == QueuedPicture::State::waiting);
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 3, 20000);
        for (int i = 0; i < 3; ++i) QCOMPARE(ended[i][0].toInt(), numbers[i]);
        for (const char* name : {"a.png", "b.png", "c.png"}) {
            const QImage picture(path(name));
            QCOMPARE(picture.size(), QSize(120, 80));
            QCOMPARE(picture.pixelColor(60, 40), QColor(255, 0, 0));
        }
        QCOMPARE(queue.open(), 0);
        queue.forgetEnded();
        QVERIFY(queue.pictures().isEmpty());
        QCOMPARE(queue.picture(numbers[0]).number, 0);
    }

    void eachIsStoppedByItself() {
        PictureQueue queue;
        const int slow = queue.add(path("slow.png"), request(3000, 2000, 60), {});
        const int waiting = queue.add(path("waiting.png"), request(40, 30), {});
        const int last = queue.add(path("last.png"), request(40, 30), {});
        queue.stop(waiting);
        QVERIFY(queue.picture(waiting).state == QueuedPicture::State::stopped);
        QVERIFY(queue.picture(slow).state == QueuedPicture::State::drawing);
        QTRY_VERIFY_WITH_TIMEOUT(queue.picture(slow).share > 0, 20000);
        queue.stop(slow);
        QVERIFY(queue.picture(slow).state == QueuedPicture::State::stopped);
        QVERIFY(!queue.picture(slow).problem.isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(queue.picture(last).state == QueuedPicture::State::written, 20000);
        QVERIFY(!QFile::exists(path("slow.png")) && !QFile::exists(path("waiting.png")));
        QVERIFY(QFile::exists(path("last.png")));
    }

    void whatCannotBeWrittenIsSaid() {
        PictureQueue queue;
        const int number = queue.add(path("no/such/folder/a.png"), request(40, 30), {});
        QTRY_VERIFY_WITH_TIMEOUT(queue.picture(number).state == QueuedPicture::State::failed, 20000);
        QVERIFY(queue.picture(number).problem.contains(QStringLiteral("No such file or directory")));
    }

    void theEndOfTheQueueStopsItsPictures() {
        {
            PictureQueue queue;
            queue.add(path("left.png"), request(3000, 2000, 60), {});
            queue.add(path("behind.png"), request(40, 30), {});
        }
        QVERIFY(!QFile::exists(path("left.png")) && !QFile::exists(path("behind.png")));
    }

    void theWindowListsAndStopsThem() {
        PictureQueue queue;
        PictureQueueWindow window(&queue);
        window.show();
        const int slow = queue.add(path("listed.png"), request(3000, 2000, 60), {});
        const int waiting = queue.add(path("next.png"), request(40, 30), {});
        QCOMPARE(window.stateText(waiting), QStringLiteral("Waits"));
        QVERIFY(window.button(slow)->isEnabled());
        QVERIFY(window.button(slow)->accessibleName().contains(QStringLiteral("listed.png")));
        window.button(slow)->click();
        QVERIFY(window.stateText(slow).startsWith(QStringLiteral("Stopped")));
        QVERIFY(!window.button(slow)->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(window.stateText(waiting), QStringLiteral("Written"), 20000);
        queue.forgetEnded();
        QVERIFY(window.stateText(slow).isEmpty() && window.button(waiting) == nullptr);
    }
};

QTEST_MAIN(PictureQueueTest)
#include "picture_queue_test.moc"
