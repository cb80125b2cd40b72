// SPDX-License-Identifier: GPL-3.0-or-later
// The first minute: New, insert, look; fit the view; open the lesson.
#include <glm/geometric.hpp>
#include <QAction>
#include <QDir>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/example_menu.h"
#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/functions/function_browser.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Colours along the edge of a picture.
int edgeColors(const QImage& picture) {
    QImage edge(2 * (picture.width() + picture.height()), 1, QImage::Format_RGB32);
    int at = 0;
    for (int x = 0; x < picture.width(); ++x) {
        edge.setPixel(at++, 0, picture.pixel(x, 0));
        edge.setPixel(at++, 0, picture.pixel(x, picture.height() - 1));
    }
    for (int y = 0; y < picture.height(); ++y) {
        edge.setPixel(at++, 0, picture.pixel(0, y));
        edge.setPixel(at++, 0, picture.pixel(picture.width() - 1, y));
    }
    return distinctColors(edge);
}

}  // namespace

class StartTest : public QObject {
    Q_OBJECT

    /// By the keys that a user presses.
    static void insert(WindowDriver& d, const QString& name) {
        d->actions()->insertFunction->trigger();
        auto* search = d->functions()->findChild<QLineEdit*>();
        search->clear();
        QTest::keyClicks(search, name);
        QTest::keyClick(search, Qt::Key_Return);
        QVERIFY(d.rests());
    }

  private slots:
    /// D5, D6: it used to land before the includes, and out of sight.
    void newThenInsertIsSeenWhole() {
        WindowDriver d;
        WindowDriver::trigger(d->actions()->newFile);
        QVERIFY(d.rests());
        const QString before = d->editor()->sceneText();
        insert(d, "f_klein_bottle");
        const QString text = d->editor()->sceneText();
        QVERIFY(text.indexOf("isosurface {") > text.indexOf("#include \"functions.inc\""));
        QVERIFY(text.endsWith("}\n"));
        QVERIFY(distinctColors(d.picture()) > 50);
        QCOMPARE(edgeColors(d.picture()), 1);
        QVERIFY(!d->viewport()->viewMoved());

        // The next one stands beside it, and the view goes back to hold both.
        insert(d, "f_heart");
        QVERIFY(d.rests());
        QVERIFY(d->editor()->sceneText().contains("translate <"));
        QTRY_VERIFY(d->viewport()->viewMoved());
        QVERIFY(d.rests());
        QCOMPARE(edgeColors(d.picture()), 1);

        // Each is one step to undo, with the view that it brought.
        const QString both = d->editor()->sceneText();
        const Camera wide = d->viewport()->camera();
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), text);
        QVERIFY(!d->viewport()->viewMoved());
        QVERIFY(d.rests());
        d->editor()->redo();
        QCOMPARE(d->editor()->sceneText(), both);
        QVERIFY(d->viewport()->camera() == wide);
        d->editor()->undo();
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), before);
    }

    void fitShowsAllAndTypesNothing() {
        WindowDriver d;
        WindowDriver::trigger(d->actions()->newFile);
        insert(d, "f_sphere");
        const QString text = d->editor()->sceneText();
        d->viewport()->setFocus();
        for (int i = 0; i < 5; ++i) QTest::keyClick(d->viewport(), Qt::Key_Plus);
        QVERIFY(d.rests());
        QVERIFY(edgeColors(d.picture()) > 1);
        QTest::keyClick(d->viewport(), Qt::Key_F);
        QTRY_VERIFY(d.rests() && edgeColors(d.picture()) == 1);
        const Camera fitted = d->viewport()->camera();
        for (int i = 0; i < 30; ++i) QTest::keyClick(d->viewport(), Qt::Key_Minus);
        d->editor()->setFocus();
        QTest::keyClick(&d.window(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(d.rests());
        const double distance = glm::length(d->viewport()->camera().location - fitted.location);
        QVERIFY2(distance < 1e-6 * glm::length(fitted.location), qPrintable(QString::number(distance)));
        QCOMPARE(d->editor()->sceneText(), text);

        d->actions()->topView->trigger();
        QVERIFY(d.rests());
        QVERIFY(glm::normalize(d->viewport()->camera().direction).y < -0.999);
        QCOMPARE(edgeColors(d.picture()), 1);
        d->actions()->resetView->trigger();
        QVERIFY(!d->viewport()->viewMoved());
    }

    /// D24, D25: the lesson about holes shows them, other texts are shown as the user chose.
    void theLessonShowsHoles() {
        WindowDriver d;
        d->documents()->showExample("sphere.pov");
        QCOMPARE(d->viewport()->rootFinder(), RootFinder::lipschitz);
        QVERIFY(d->windowTitle().startsWith("A lesson: a ball with holes"));
        d->documents()->showExample("heart.pov");
        QCOMPARE(d->viewport()->rootFinder(), RootFinder::certified);
        QVERIFY(d->windowTitle().startsWith("A heart"));
        WindowDriver::trigger(d->actions()->newFile);
        QVERIFY(d->windowTitle().startsWith("Untitled"));
    }

    /// D25: every example has its picture, made in the background.
    void theExamplesHavePictures() {
        QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).removeRecursively();
        for (const bool again : {false, true}) {
            WindowDriver d;
            auto* menu = d.window().findChild<ExampleMenu*>();
            QVERIFY(menu);
            QList<QAction*> entries = menu->actions();
            entries.removeIf([](const QAction* entry) { return entry->isSeparator(); });
            QCOMPARE(entries.size(), 13);
            QCOMPARE(entries.front()->text(), "A ball and a ring that melt into each other");
            menu->popup({0, 0});
            const QSize size = menu->size();
            QVERIFY(size.height() > entries.size() * ExampleMenu::pictureSize);
            for (const QAction* entry : entries) {
                const auto colors = [entry] {
                    const QImage picture = entry->icon().pixmap(ExampleMenu::pictureSize).toImage();
                    return picture.width() == ExampleMenu::pictureSize ? distinctColors(picture) : 0;
                };
                if (again)
                    QVERIFY2(colors() > 50, qPrintable(entry->text()));
                else
                    QTRY_VERIFY2_WITH_TIMEOUT(colors() > 50, qPrintable(entry->text()), 30000);
            }
            QCOMPARE(menu->sizeHint(), size);
            menu->close();
        }
    }
};

QTEST_MAIN(StartTest)
#include "start_test.moc"
