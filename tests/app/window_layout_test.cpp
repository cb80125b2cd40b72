// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/dock_tabs.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/window/overlay_button.h"
#include "app/desktop/window/picture_room.h"
#include "app/desktop/window/window_choices.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// How the window divides its room.
class WindowLayoutTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    /// Until the panels no longer change their sizes.
    void resizeTo(int width, int height) {
        (*driver_)->resize(width, height);
        settle();
        QCOMPARE((*driver_)->size(), QSize(width, height));
    }
    void settle() {
        for (int i = 0; i < 10; ++i) {
            QCoreApplication::sendPostedEvents();
            QTest::qWait(10);
        }
    }

    /// Between tool bars and status line, in the window.
    QRect area() const {
        const MainWindow& window = driver_->window();
        int top = window.menuWidget()->geometry().bottom() + 1;
        for (const QToolBar* bar : window.findChildren<QToolBar*>())
            if (bar->isVisible()) top = std::max(top, bar->geometry().bottom() + 1);
        return {QPoint(0, top), QPoint(window.width() - 1, window.statusBar()->geometry().top() - 1)};
    }
    double pictureShare() const {
        const QSize picture = (*driver_)->viewport()->size();
        const QRect all = area();
        return static_cast<double>(picture.width()) * picture.height() /
               (static_cast<double>(all.width()) * all.height());
    }
    QTabBar* barBelow() const {
        return (*driver_)->docks()->tabs()->barOf((*driver_)->docks()->find("section"));
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void thePictureIsTheLargestThing_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("D13 900x600") << 900 << 600;
        QTest::newRow("1280x800") << 1280 << 800;
        QTest::newRow("D14 1600x1000") << 1600 << 1000;
    }
    void thePictureIsTheLargestThing() {
        QFETCH(int, width);
        QFETCH(int, height);
        resizeTo(width, height);
        WindowDriver& d = *driver_;
        qInfo("%d x %d: the picture has %.1f %%, %d x %d; the text is %d wide, below %s", width, height,
              100 * pictureShare(), d->viewport()->width(), d->viewport()->height(),
              d->docks()->find("editor")->width(), d->room()->folded() ? "folded" : "open");
        QVERIFY2(pictureShare() >= 0.45, qPrintable(QString::number(pictureShare())));
        for (const QDockWidget* dock : d->docks()->all()) {
            const double size = static_cast<double>(dock->width()) * dock->height();
            QVERIFY(size < static_cast<double>(d->viewport()->width()) * d->viewport()->height());
        }
        // Every tool is seen, every tab in full.
        for (const QToolButton* more : d->findChildren<QToolButton*>(QStringLiteral("qt_toolbar_ext_button")))
            QVERIFY(!more->isVisible());
        for (const QTabBar* bar : d->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
            if (!bar->isVisible()) continue;
            int widths = 0;
            for (int i = 0; i < bar->count(); ++i) {
                QVERIFY2(bar->tabRect(i).width() > bar->fontMetrics().horizontalAdvance(bar->tabText(i)),
                         qPrintable(bar->tabText(i)));
                widths += bar->tabRect(i).width();
            }
            QVERIFY2(widths <= bar->width(), qPrintable(bar->tabText(0)));
        }
        // No two panels overlap, nor a panel and the picture. Closed ones have no place.
        QList<QRect> places{d->centralWidget()->geometry()};
        for (const QDockWidget* dock : d->docks()->all())
            if (!dock->isHidden() && dock->geometry().left() >= 0 && dock->height() > 0)
                places << dock->geometry();
        QVERIFY(places.size() > 2);
        for (qsizetype i = 0; i < places.size(); ++i) {
            QVERIFY(area().contains(places[i]));
            for (qsizetype k = i + 1; k < places.size(); ++k) QVERIFY(!places[i].intersects(places[k]));
        }
    }

    /// D39: a title row stands only where no tab says the same.
    /// At a scale of 1.5 the first window was 1920 pixels wide, whatever the screen.
    void theFirstWindowFitsItsScreen() {
        const double scale = 1.5;
        for (const QSize pixels : {QSize(1366, 768), QSize(1920, 1080), QSize(2560, 1440), QSize(3840, 2160)})
            for (const QSize available : {pixels, (QSizeF(pixels) / scale).toSize()}) {
                const QSize first = WindowChoices::firstSize(available);
                QVERIFY2(first.width() <= available.width() && first.height() + 30 <= available.height(),
                         qPrintable(QStringLiteral("%1 x %2 of %3 x %4")
                                        .arg(first.width())
                                        .arg(first.height())
                                        .arg(available.width())
                                        .arg(available.height())));
            }
        QCOMPARE(WindowChoices::firstSize({1920, 1080}), QSize(1632, 918));
        // The window itself can be as small, at half of the scale above.
        resizeTo(900, 470);
        QCOMPARE((*driver_)->size(), QSize(900, 470));
    }

    void noTitleStandsTwice() {
        WindowDriver& d = *driver_;
        for (QDockWidget* dock : d->docks()->all())
            QCOMPARE(d->docks()->tabs()->tabbed(dock), dock->titleBarWidget() != nullptr);
        QVERIFY(!d->docks()->find("editor")->titleBarWidget());
        QVERIFY(d->docks()->find("gradient")->titleBarWidget());
        // Taken out it has its title, with the buttons, again.
        d->docks()->find("gradient")->setFloating(true);
        QTRY_VERIFY(!d->docks()->find("gradient")->titleBarWidget());
        d->docks()->find("gradient")->setFloating(false);
        QTRY_VERIFY(d->docks()->find("gradient")->titleBarWidget());
        for (QDockWidget* dock : {d->docks()->find("functions"), d->docks()->find("problems")}) dock->close();
        QTRY_VERIFY(!d->docks()->find("parameters")->titleBarWidget());
    }

    /// D13: what is below yields first, and comes back as it was.
    void panelsBelowYieldAndComeBack() {
        WindowDriver& d = *driver_;
        resizeTo(1280, 800);
        QVERIFY(!d->room()->folded());
        d->docks()->find("histogram")->raise();
        settle();
        const int height = d->docks()->find("histogram")->height();
        resizeTo(900, 600);
        QVERIFY(d->room()->folded());
        QVERIFY(barBelow()->isVisible());
        resizeTo(1280, 800);
        QVERIFY(!d->room()->folded());
        QVERIFY(std::abs(d->docks()->find("histogram")->height() - height) <= 2);
        QCOMPARE(barBelow()->tabText(barBelow()->currentIndex()),
                 d->docks()->find("histogram")->windowTitle());
    }

    void aPersonsOwnArrangementWins() {
        WindowDriver& d = *driver_;
        resizeTo(900, 600);
        QVERIFY(d->room()->folded());
        // A click on a tab unfolds, and it stays so while the window changes a little.
        QTest::mouseClick(barBelow(), Qt::LeftButton, {}, barBelow()->tabRect(1).center());
        settle();
        QVERIFY(!d->room()->folded());
        QVERIFY(d->docks()->find("gradient")->height() > 60);
        resizeTo(920, 610);
        QVERIFY(!d->room()->folded());
        // Folded by hand it stays folded, however large the window, until a command asks for a panel.
        resizeTo(1280, 800);
        d->room()->fold(true);
        resizeTo(1600, 1000);
        QVERIFY(d->room()->folded());
        d->docks()->bringUp(d->docks()->find("gradient"));
        settle();
        QVERIFY(!d->room()->folded());
    }

    void anArrangementOfAnEarlierVersionIsTakenOver() {
        WindowDriver& d = *driver_;
        resizeTo(1400, 900);
        d->docks()->find("gradient")->close();
        d->docks()->bringUp(d->docks()->find("formula"));
        settle();
        // A version without one of the panels.
        QDockWidget* ray = d->docks()->find("ray");
        const QString name = ray->objectName();
        ray->setObjectName(QStringLiteral("unknown"));
        const QByteArray old = d->saveState(7);
        ray->setObjectName(name);
        d->close();
        QSettings().setValue(QStringLiteral("window/layout"), old);
        d.crash();
        settle();
        QVERIFY(!d->docks()->find("gradient")->isVisible());
        QVERIFY(d->docks()->find("formula")->isVisible());
        QVERIFY(!d->docks()->find("ray")->isFloating());
        // Stored anew it is one of this version.
        d.restart();
        QVERIFY(QSettings().value(QStringLiteral("window/layout")).toByteArray() != old);
        QVERIFY(!d->docks()->find("gradient")->isVisible());
    }

    /// A bug once: a panel that was opened from the menu came up behind the others of its row.
    void aPanelThatIsOpenedComesToTheFront() {
        Docks* docks = (*driver_)->docks();
        docks->bringUp(docks->find("histogram"));
        QDockWidget* formula = docks->find("formula");
        formula->close();
        settle();
        formula->toggleViewAction()->trigger();
        settle();
        QCOMPARE(barBelow()->tabText(barBelow()->currentIndex()), formula->windowTitle());
    }

    /// D14: the text pane takes its share of growth, the one that was chosen if there is one.
    void theTextGrowsWithTheWindow() {
        WindowDriver& d = *driver_;
        resizeTo(1600, 1000);
        const QFontMetrics metrics(d->editor()->font());
        QVERIFY2(d->docks()->find("editor")->width() > 550,
                 qPrintable(QString::number(d->docks()->find("editor")->width())));
        resizeTo(900, 600);
        QVERIFY(d->docks()->find("editor")->width() < 400);
        // The line between text and picture is dragged to the right.
        const int right = d->docks()->find("editor")->geometry().right();
        const QPoint line(right + 3, d->docks()->find("editor")->geometry().center().y());
        QTest::mousePress(&d.window(), Qt::LeftButton, {}, line);
        QTest::mouseMove(&d.window(), line + QPoint(60, 0));
        settle();
        QTest::mouseRelease(&d.window(), Qt::LeftButton, {}, line + QPoint(60, 0));
        settle();
        const int dragged = d->docks()->find("editor")->width();
        QVERIFY2(std::abs(dragged - right - 60) < 6, qPrintable(QString::number(dragged)));
        resizeTo(1600, 1000);
        QVERIFY(std::abs(d->docks()->find("editor")->width() - dragged * 16 / 9) < 8);
        resizeTo(900, 600);
        QVERIFY(std::abs(d->docks()->find("editor")->width() - dragged) < 8);
        driver_->restart();
        settle();
        resizeTo(900, 600);
        QVERIFY(std::abs((*driver_)->docks()->find("editor")->width() - dragged) < 8);
        (*driver_)->actions()->resetLayout->trigger();
        settle();
        QVERIFY(std::abs((*driver_)->docks()->find("editor")->width() - right) < 8);
    }

    /// D14: long lines go on in the next row, unless that is switched off, for good.
    void longLinesAreWrapped() {
        const auto wrapped = [this] {
            return (*driver_)->editor()->wrapMode() == QsciScintilla::WrapWhitespace;
        };
        QVERIFY(wrapped());
        (*driver_)->actions()->wordWrap->trigger();
        QVERIFY(!wrapped());
        driver_->restart();
        QVERIFY(!wrapped());
        QVERIFY(!(*driver_)->actions()->wordWrap->isChecked());
    }

    /// A bug once: in a window of the usual size two panels had to be scrolled.
    void panelsBelowFitTheUsualWindow() {
        WindowDriver& d = *driver_;
        resizeTo(1280, 800);
        for (QDockWidget* dock : d->docks()->at(Docks::Place::below)) {
            d->docks()->bringUp(dock);
            settle();
            QVERIFY(d.rests(60000));
            auto* area = qobject_cast<QScrollArea*>(dock->widget());
            QVERIFY(area && area->isVisible());
            if (dock == d->docks()->find("gradient"))  // with all that it can say
                QTRY_VERIFY_WITH_TIMEOUT(d->study<GradientPanel>()->upToDate(), 60000);
            settle();
            const QByteArray what = dock->objectName().toUtf8() + ' ' +
                                    QByteArray::number(area->verticalScrollBar()->maximum()) + " of " +
                                    QByteArray::number(area->height());
            QVERIFY2(area->verticalScrollBar()->maximum() == 0, what);
            QVERIFY2(area->horizontalScrollBar()->maximum() == 0, what);
        }
        const auto* gradient = d->study<GradientPanel>();
        d->docks()->bringUp(d->docks()->find("gradient"));
        settle();
        for (const QLabel* label : gradient->findChildren<QLabel*>())  // nor is anything clipped
            if (label->isVisible()) {
                QVERIFY(gradient->rect().contains(label->geometry()));
                QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
            }
    }

    /// D38: on a scaled interface two icons of the tool bars were in colours, beside line drawings.
    void iconsLookTheSameAtEveryScale() {
        const auto ink = [](const QIcon& icon, qreal scale) {
            QImage image = icon.pixmap({18, 18}, scale).toImage();
            image.setDevicePixelRatio(1);
            return image;
        };
        const auto shares =
            [](const QImage& image) {  // of strong colours, and of what is neither full nor empty
                double inked = 0, colored = 0, soft = 0;
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x) {
                        const QColor color = image.pixelColor(x, y);
                        inked += color.alphaF();
                        if (color.alpha() > 64 && color.hsvSaturation() > 90) colored += color.alphaF();
                        if (color.alpha() > 24 && color.alpha() < 232) ++soft;
                    }
                return std::array{colored / inked, soft / inked};
            };
        int looked = 0;
        for (const QToolBar* bar : (*driver_)->findChildren<QToolBar*>())
            for (const QToolButton* button : bar->findChildren<QToolButton*>()) {
                if (button->icon().name().isEmpty()) continue;  // of the style
                const auto usual = shares(ink(button->icon(), 1));
                for (const qreal scale : {1.25, 1.5, 2.0}) {
                    const QImage image = ink(button->icon(), scale);
                    const QByteArray what = button->text().toUtf8() + ' ' + QByteArray::number(scale);
                    QCOMPARE(image.width(), qRound(18 * scale));
                    const auto [colored, soft] = shares(image);
                    QVERIFY2(std::abs(colored - usual[0]) < 0.12, what + ' ' + QByteArray::number(colored));
                    // What is scaled up from fewer pixels is soft everywhere.
                    const auto blurred =
                        shares(ink(button->icon(), 1)
                                   .scaled(image.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
                    QVERIFY2(soft < blurred[1], what + ' ' + QByteArray::number(soft));
                }
                ++looked;
            }
        if (!QIcon::hasThemeIcon(QStringLiteral("document-open"))) QSKIP("no icon theme is installed");
        QVERIFY(looked > 15);
    }

    /// A bug once: the arrow stood in the corner of the button, 25 pixels from a short name.
    void overlayButtonsArrowFollowsItsName() {
        WindowDriver& d = *driver_;
        resizeTo(1600, 900);
        auto* button = d->findChild<OverlayButton*>();
        QVERIFY(button && button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon);
        const Actions& actions = *d->actions();
        for (QAction* overlay : {actions.overlayDifference, actions.overlaySplit, actions.overlayNone}) {
            overlay->trigger();
            settle();
            const QImage image = button->grab().toImage();
            const QRgb ground = image.pixel(1, 1);
            QList<int> inked;  // columns
            for (int x = button->iconSize().width() + 6; x < image.width() - 3; ++x)
                for (int y = 4; y < image.height() - 4; ++y)
                    if (image.pixel(x, y) != ground && (inked.isEmpty() || inked.last() != x)) inked << x;
            QVERIFY(!inked.isEmpty());
            // Its last columns are the arrow's, wherever the style draws it.
            const QRect arrow = button->arrow();
            QVERIFY2(arrow.right() < image.width() - 2, qPrintable(button->text()));
            QVERIFY2(inked.last() >= arrow.left() && inked.last() <= arrow.right(),
                     qPrintable(button->text()));
            int widestGap = 0;
            for (qsizetype i = 1; i < inked.size(); ++i)
                widestGap = std::max(widestGap, inked[i] - inked[i - 1]);
            QVERIFY2(widestGap < 12, qPrintable(QString::number(widestGap)));
        }
    }

    /// D38: another overlay does not move the buttons beside it.
    void overlayButtonKeepsItsWidth() {
        WindowDriver& d = *driver_;
        resizeTo(1280, 800);
        const Actions& actions = *d->actions();
        auto* bar = d->findChild<QToolBar*>(QStringLiteral("viewTools"));
        QVERIFY(bar);
        const QWidget* neighbour = bar->widgetForAction(actions.inspectRay);
        const QRect before = neighbour->geometry();
        for (QAction* overlay : {actions.overlayDifference, actions.overlaySplit, actions.overlayNone}) {
            overlay->trigger();
            settle();
            QCOMPARE(neighbour->geometry(), before);
        }
    }
};

QTEST_MAIN(WindowLayoutTest)
#include "window_layout_test.moc"
