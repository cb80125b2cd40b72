// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>

#include "app/desktop/files/start_page.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "tests/app/test_folder.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/gallery/gallery_model.h"
#include "widgets/gallery/gallery_panel.h"
#include "widgets/gallery/gallery_sources.h"
#include "widgets/gallery/own_collection.h"
#include "widgets/notice_bar.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

QListView* listOf(GalleryPanel* panel) { return panel->findChild<QListView*>(); }

QString thumbnailFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails");
}

/// 250 spheres of different sizes; only the first few are seen at once.
QList<GalleryEntry> manyEntries() {
    QList<GalleryEntry> entries;
    for (int i = 0; i < 250; ++i)
        entries.append({GalleryEntry::Kind::example,
                        QStringLiteral("Ball %1").arg(i),
                        QStringLiteral("Round."),
                        QStringLiteral("camera { location <0, 0, -5> look_at 0 }\nlight_source { -9 rgb 1 }\n"
                                       "sphere { 0, %1 pigment { rgb 1 } }\n")
                            .arg(1 + i / 250.0),
                        nullptr,
                        {}});
    return entries;
}

}  // namespace

class GalleryWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void isClosedAtFirstAndOpensByItsCommand() {
        WindowDriver d;
        QVERIFY(d.rests());
        QDockWidget* dock = d->docks()->find("gallery");
        QVERIFY(!dock->isVisible());
        QCOMPARE(d->gallery()->model()->rowCount(), 0);
        WindowDriver::trigger(d->actions()->gallery);
        QVERIFY(dock->isVisible());
        const GalleryModel* model = d->gallery()->model();
        int kinds[6] = {};
        for (int row = 0; row < model->rowCount(); ++row) {
            const GalleryEntry& entry = model->entry(row);
            ++kinds[static_cast<int>(entry.kind)];
            QVERIFY2(!entry.title.isEmpty() && !entry.text.isEmpty(), qPrintable(entry.title));
        }
        QVERIFY(kinds[static_cast<int>(GalleryEntry::Kind::function)] > 70);
        QVERIFY(kinds[static_cast<int>(GalleryEntry::Kind::pattern)] > 20);
        QVERIFY(kinds[static_cast<int>(GalleryEntry::Kind::example)] > 10);
        QVERIFY(kinds[static_cast<int>(GalleryEntry::Kind::lesson)] > 10);
        const bool installed = !povrayTemplateFolders().isEmpty();
        QCOMPARE(kinds[static_cast<int>(GalleryEntry::Kind::povray)] > 30, installed);
    }

    void searchLeavesWhatMatchesAndAClickOpensIt() {
        WindowDriver d;
        WindowDriver::trigger(d->actions()->gallery);
        QListView* list = listOf(d->gallery());
        auto* search = d->gallery()->findChild<QLineEdit*>();
        search->setText(QStringLiteral("f_torus function"));
        QVERIFY(list->model()->rowCount() >= 1);
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QString words = list->model()->index(row, 0).data(Qt::AccessibleTextRole).toString();
            QVERIFY2(words.contains(QStringLiteral("f_torus")), qPrintable(words));
            QVERIFY2(words.contains(QStringLiteral("function"), Qt::CaseInsensitive), qPrintable(words));
        }
        const QModelIndex first = list->model()->index(0, 0);
        QCOMPARE(first.data().toString(), QStringLiteral("f_torus"));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(first).center());
        QTRY_VERIFY(d->editor()->text().contains(QStringLiteral("f_torus(")));
        QVERIFY(d.rests());
        search->setText(QStringLiteral("no such scene anywhere"));
        QCOMPARE(list->model()->rowCount(), 0);
        const auto labels = list->viewport()->findChildren<QLabel*>();
        QCOMPARE(labels.size(), 1);
        QVERIFY(labels.first()->isVisible());
    }

    void theStartPageIsShownAtTheFirstStartOnly() {
        WindowDriver d;
        QSettings().remove(QStringLiteral("window/geometry"));
        d->start({});
        const auto page = [&d] { return d->findChild<StartPage*>(); };
        QTRY_VERIFY(page() && page()->isVisible());
        QCOMPARE(page()->size(), page()->parentWidget()->size());
        QTRY_VERIFY(page()->gallery()->model()->rowCount() > 150);
        // Escape goes on with the scene that is open.
        const QString before = d->editor()->text();
        QTest::keyClick(page()->gallery()->findChild<QLineEdit*>(), Qt::Key_Escape);
        QVERIFY(!page()->isVisible());
        QCOMPARE(d->editor()->text(), before);
        d.restart();
        d->start({});
        QTest::qWait(100);
        QVERIFY(!page());
        WindowDriver::trigger(d->actions()->startPage);
        QVERIFY(page()->isVisible());
        auto* search = page()->gallery()->findChild<QLineEdit*>();
        search->setText(QStringLiteral("lesson container gyroid open"));
        QTest::keyClick(search, Qt::Key_Return);
        QVERIFY(!page()->isVisible());
        QTRY_VERIFY(d->editor()->text().contains(QStringLiteral("The same gyroid, open.")));
        QVERIFY(d.rests());
    }

    /// The page used to hide the picture of a text that was typed beside it.
    void typingLeavesTheStartPage() {
        WindowDriver d;
        d->start({});
        WindowDriver::trigger(d->actions()->startPage);
        auto* page = d->findChild<StartPage*>();
        QVERIFY(page->isVisible());
        d->editor()->setFocus();
        QTest::keyClicks(d->editor(), QStringLiteral(" "));
        QVERIFY(!page->isVisible());
        QVERIFY(d->editor()->hasFocus());
        WindowDriver::trigger(d->actions()->startPage);
        QVERIFY(page->isVisible());
        d->editor()->undo();
        QVERIFY(!page->isVisible());
    }

    /// A file that was opened by the menu, or dropped, used to stay behind the page.
    void openingAFileLeavesTheStartPage() {
        WindowDriver d;
        TestFolder folder;
        d->start({});
        WindowDriver::trigger(d->actions()->startPage);
        auto* page = d->findChild<StartPage*>();
        QVERIFY(page->isVisible());
        QVERIFY(d->openFile(folder.write(QStringLiteral("ball.pov"), "sphere { 0, 1 }\n")));
        QVERIFY(!page->isVisible());
    }

    void theOwnCollectionSurvivesARestartAndRemovalIsUndone() {
        WindowDriver d;
        QVERIFY(d.openText("// A ball of mine.\nsphere { 0, 1 }\n", QStringLiteral("mine.pov")));
        WindowDriver::trigger(d->actions()->gallery);
        QVERIFY(WindowDriver::press(d->gallery(), QStringLiteral("Add to My Collection")));
        d.restart();
        WindowDriver::trigger(d->actions()->gallery);
        const GalleryEntry own = d->gallery()->model()->entry(0);
        QVERIFY(own.kind == GalleryEntry::Kind::own);
        QCOMPARE(own.sentence, QStringLiteral("A ball of mine."));
        QVERIFY2(own.text.contains(QStringLiteral("sphere { 0, 1 }")), qPrintable(own.text));
        emit d->gallery()->removeRequested(own);
        QVERIFY(d->gallery()->model()->entry(0).kind != GalleryEntry::Kind::own);
        QVERIFY(OwnCollection().entries().isEmpty());
        QVERIFY(WindowDriver::press(d->notices(), QStringLiteral("Undo")));
        QCOMPARE(d->gallery()->model()->entry(0).title, own.title);
        QCOMPARE(d->gallery()->model()->entry(0).text, own.text);
        QVERIFY(OwnCollection().remove(d->gallery()->model()->entry(0).file));
    }

    void theCacheIsUsedAndADamagedFileRenderedAgain() {
        QDir(thumbnailFolder()).removeRecursively();
        const auto rendered = [](int wanted) {
            GalleryPanel panel;
            panel.setEntries(manyEntries().mid(0, 2));
            panel.resize(500, 400);
            panel.show();
            QTRY_COMPARE_WITH_TIMEOUT(panel.model()->renderedPictures(), wanted, 20000);
            QTest::qWait(200);
            QCOMPARE(panel.model()->renderedPictures(), wanted);
            QVERIFY(!panel.model()->index(1).data(Qt::DecorationRole).value<QImage>().isNull());
        };
        rendered(2);
        rendered(0);
        const QFileInfoList files = QDir(thumbnailFolder()).entryInfoList({"*.png"}, QDir::Files);
        QCOMPARE(files.size(), 2);
        QVERIFY(QFile::resize(files.first().filePath(), 30));
        rendered(1);
    }

    /// Warm: the pictures are in the cache. Scrolled from end to end an entry is painted when it is seen and
    /// no more often than a frame needs.
    void aWarmPageOpensWithoutRenderingAndScrollsByWhatIsSeen() {
        GalleryPanel panel(nullptr, GalleryPanel::Kind::page);
        panel.resize(1000, 700);
        panel.setEntries(manyEntries());
        panel.show();
        panel.model()->startPictures(1);
        for (int row = 0; row < 250; ++row) panel.model()->index(row).data(Qt::DecorationRole);
        QTRY_COMPARE_WITH_TIMEOUT(
            panel.model()->renderedPictures() >= 0 &&
                !panel.model()->index(0).data(Qt::DecorationRole).value<QImage>().isNull() &&
                !panel.model()->index(249).data(Qt::DecorationRole).value<QImage>().isNull(),
            true, 60000);

        GalleryPanel warm(nullptr, GalleryPanel::Kind::page);
        warm.resize(1000, 700);
        QElapsedTimer clock;
        clock.start();
        warm.setEntries(manyEntries());
        warm.show();
        QVERIFY(QTest::qWaitForWindowExposed(&warm));
        warm.grab();
        qInfo("250 entries, warm: %lld ms", static_cast<long long>(clock.elapsed()));
        QScrollBar* bar = listOf(&warm)->verticalScrollBar();
        constexpr int frames = 60;
        const int before = warm.model()->picturesAsked();
        clock.start();
        for (int frame = 0; frame < frames; ++frame) {
            bar->setValue(bar->maximum() * frame / (frames - 1));
            listOf(&warm)->viewport()->repaint();
        }
        const double each = static_cast<double>(clock.nsecsElapsed()) / 1e6 / frames;
        const int asked = warm.model()->picturesAsked() - before;
        qInfo("a frame of scrolling: %.1f ms, %d entries", each, asked / frames);
        QCOMPARE(warm.model()->renderedPictures(), 0);
        // At most five rows of four are seen in part.
        QVERIFY2(asked > 0 && asked <= frames * 24, qPrintable(QString::number(asked)));
    }

    void manyEntriesOpenAtOnceAndAskForWhatIsSeen() {
        GalleryPanel panel;
        panel.resize(500, 400);
        QElapsedTimer clock;
        clock.start();
        panel.setEntries(manyEntries());
        panel.show();
        panel.grab();
        qInfo("250 entries: %lld ms", static_cast<long long>(clock.elapsed()));
        // Waiting for all pictures would take seconds; only those that are seen were asked for.
        QTest::qWait(3000);
        const int seen = panel.model()->renderedPictures();
        QVERIFY2(seen > 0 && seen < 40, qPrintable(QString::number(seen)));
    }
};

QTEST_MAIN(GalleryWindowTest)
#include "gallery_window_test.moc"
