// SPDX-License-Identifier: GPL-3.0-or-later
// High contrast, and the size of the whole interface.
#include "widgets/interface_style.h"

#include <QAction>
#include <QDockWidget>
#include <QPushButton>
#include <QTest>
#include <QToolBar>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/window/shortcut_window.h"
#include "tests/app/cut_texts.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/look.h"

using namespace isoscope;
using namespace isoscope::test;

class InterfaceSizeTest : public QObject {
    Q_OBJECT

    static QAction* sizeAction(const WindowDriver& d, int percent) {
        for (QAction* size : d->actions()->interfaceSizes)
            if (size->data().toInt() == percent) return size;
        return nullptr;
    }
    static int lineHeight(const WindowDriver& d) {
        return static_cast<int>(d->editor()->SendScintilla(QsciScintilla::SCI_TEXTHEIGHT, 0));
    }
    /// The opaque pixels of an icon that differ most from the ground.
    static double bestContrast(const QIcon& icon, const QColor& ground) {
        const QImage image = icon.pixmap(22, 22).toImage();
        double best = 1;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (const QColor color = image.pixelColor(x, y); color.alpha() > 200)
                    best = std::max(best, contrastRatio(color, ground));
        return best;
    }

  private slots:
    void everythingGrowsAndComesBackAtTheNextStart() {
        WindowDriver d;
        QVERIFY(d.rests());
        auto* tools = d->findChild<QToolBar*>(QStringLiteral("tools"));
        const double letters = d->font().pointSizeF();
        const int line = lineHeight(d), icon = tools->iconSize().width();
        QVERIFY(sizeAction(d, 100)->isChecked());
        WindowDriver::trigger(sizeAction(d, 200));
        const auto isDouble = [&] {
            auto* bar = d->findChild<QToolBar*>(QStringLiteral("tools"));
            return std::abs(d->font().pointSizeF() / letters - 2) < 0.05 &&
                   bar->iconSize().width() == 2 * icon && std::abs(lineHeight(d) - 2 * line) <= 2;
        };
        QTRY_VERIFY2(isDouble(), qPrintable(QStringLiteral("lines %1 of %2, letters %3 of %4, icons %5 of %6")
                                                .arg(lineHeight(d))
                                                .arg(line)
                                                .arg(d->font().pointSizeF())
                                                .arg(letters)
                                                .arg(tools->iconSize().width())
                                                .arg(icon)));
        d.restart();
        QVERIFY(isDouble());
        QVERIFY(sizeAction(d, 200)->isChecked());
        WindowDriver::trigger(sizeAction(d, 100));
        QTRY_COMPARE(lineHeight(d), line);
        QTRY_COMPARE(d->font().pointSizeF(), letters);
    }

    void noTextIsCut_data() {
        QTest::addColumn<int>("percent");
        for (const int percent : {100, 150, 200}) QTest::addRow("%d", percent) << percent;
    }
    void noTextIsCut() {
        QFETCH(int, percent);
        WindowDriver d;
        d->resize(1800, 1300);
        QVERIFY(d.rests());
        WindowDriver::trigger(sizeAction(d, percent));
        QVERIFY(d.rests());
        QStringList cut;
        for (QDockWidget* dock : d->docks()->all()) {
            d->docks()->bringUp(dock);
            QTest::qWait(20);
            cut << cutTexts(&d.window());
        }
        d->actions()->shortcuts->trigger();
        auto* keys = d->findChild<ShortcutWindow*>();
        QTRY_VERIFY(keys->isVisible());
        cut << cutTexts(keys);
        keys->close();
        cut.removeDuplicates();
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join('\n')));
    }

    void highContrastReachesEditorIconsAndPanels() {
        WindowDriver d;
        QVERIFY(d.rests());
        WindowDriver::trigger(d->actions()->themeHighContrast);
        QVERIFY(d.rests());
        QCOMPARE(d->editor()->look(), Look::highContrast);
        QCOMPARE(d->palette().color(QPalette::Window), QColor(Qt::black));
        int icons = 0;
        for (const QAction* action : d->actions()->all()) {
            if (action->icon().isNull() || !action->isEnabled()) continue;
            ++icons;
            const double best = bestContrast(action->icon(), Qt::black);
            QVERIFY2(best >= highContrastRatio, qPrintable(action->text() + QString::number(best)));
        }
        QVERIFY(icons > 20);
        // Buttons are told from the window by their outlines.
        d->docks()->bringUp(d->docks()->find("gallery"));
        const auto* add = d->docks()->find("gallery")->findChild<QPushButton*>();
        QTRY_VERIFY(add->isVisible());
        const QImage drawn = const_cast<QPushButton*>(add)->grab().toImage();
        QVERIFY(contrastRatio(drawn.pixelColor(drawn.width() / 2, 0), Qt::black) >= highContrastRatio);
        d.restart();
        QVERIFY(d->actions()->themeHighContrast->isChecked());
        QCOMPARE(d->editor()->look(), Look::highContrast);
        WindowDriver::trigger(d->actions()->themeLight);
    }
};

QTEST_MAIN(InterfaceSizeTest)
#include "interface_size_test.moc"
