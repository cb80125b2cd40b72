// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/command_palette.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// Every command of the menus by words, with the keyboard alone.
class CommandPaletteTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    CommandPalette* palette() const {
        for (auto* one : window().findChildren<CommandPalette*>())
            if (one->isVisible()) return one;
        return nullptr;
    }
    /// Opens it by its keys from `widget`; the field that has the focus then.
    QWidget* openFrom(QWidget* widget) const {
        widget->setFocus();
        if (!QTest::qWaitFor([&] { return widget->hasFocus(); })) return nullptr;
        QTest::keyClick(widget, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        if (!QTest::qWaitFor([&] { return palette() && palette()->findChild<QLineEdit*>()->hasFocus(); }))
            return nullptr;
        return palette()->findChild<QLineEdit*>();
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void wordsAreRanked() {
        const QString path = QStringLiteral("View › Theme › Dark");
        QCOMPARE(paletteRank(path, {}), std::optional(0));
        QCOMPARE(paletteRank(path, QStringLiteral("dark ")), std::optional(0));
        QCOMPARE(paletteRank(QStringLiteral("Edit › Find…"), QStringLiteral("find")), std::optional(0));
        QCOMPARE(paletteRank(path, QStringLiteral("DA")), std::optional(1));
        QCOMPARE(paletteRank(path, QStringLiteral("DA the")), std::optional(2));
        QCOMPARE(paletteRank(path, QStringLiteral("ark")), std::optional(3));
        const QString help = QStringLiteral("Light letters on a Night sky");
        QCOMPARE(paletteRank(path, QStringLiteral("night"), help), std::optional(4));
        QCOMPARE(paletteRank(path, QStringLiteral("dark let"), help), std::optional(4));
        QVERIFY(!paletteRank(path, QStringLiteral("ight"), help));
        QCOMPARE(paletteRank(path, QStringLiteral("vtd"), help), std::optional(5));
        QVERIFY(!paletteRank(path, QStringLiteral("dark light")));
        QVERIFY(!paletteRank(path, QStringLiteral("krad")));
    }

    void everyCommandIsFoundByItsName() {
        QWidget* field = openFrom((*driver_)->editor());
        QVERIFY(field);
        const QStringList all = palette()->shown();
        QStringList missing;
        for (const QAction* action : (*driver_)->actions()->all()) {
            QString name = action->text();
            name.remove(QLatin1Char('&'));
            palette()->findChild<QLineEdit*>()->setText(name);
            const QStringList shown = palette()->shown();
            if (shown.isEmpty() || !shown.first().endsWith(name)) missing << name + ": " + shown.value(0);
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join('\n')));
        QVERIFY(all.size() >= (*driver_)->actions()->all().size());
        for (const QString& path : all) QVERIFY2(!path.contains('&'), qPrintable(path));
    }

    void aCommandIsRunByKeysAndComesFirstNextTime() {
        WindowDriver& d = *driver_;
        const bool before = d->actions()->showAxes->isChecked();
        QWidget* field = openFrom(d->viewport());
        QVERIFY(field);
        QTest::keyClicks(field, QStringLiteral("axes"));
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!palette());
        QCOMPARE(d->actions()->showAxes->isChecked(), !before);
        QTRY_VERIFY(d->viewport()->hasFocus());
        QVERIFY(openFrom(d->editor()));
        QCOMPARE(palette()->shown().first(), QStringLiteral("View › Axes"));
        // Also in the next run.
        d.restart();
        d->showTutorial();
        QVERIFY(d.rests());
        QVERIFY(openFrom(d->editor()));
        QCOMPARE(palette()->shown().first(), QStringLiteral("View › Axes"));
    }

    /// “health” was found in examples alone, by letters here and there.
    void whatAPanelTellsLeadsToIt() {
        QWidget* field = openFrom((*driver_)->editor());
        QVERIFY(field);
        for (const auto& [words, panel] : {std::pair("health", "Report"),
                                           {"volume tunnels", "Report"},
                                           {"derivatives", "Formula"},
                                           {"worth proof", "Repair"}}) {
            palette()->findChild<QLineEdit*>()->setText(words);
            const QStringList shown = palette()->shown();
            QVERIFY2(!shown.isEmpty() && shown.first().endsWith(panel), words);
        }
    }

    void itActsWhereTheFocusWas() {
        WindowDriver& d = *driver_;
        QWidget* field = openFrom(d->editor());
        QVERIFY(field);
        QTest::keyClicks(field, QStringLiteral("select all"));
        QTest::keyClick(field, Qt::Key_Enter);
        QCOMPARE(d->editor()->selectedText().toUtf8(), d->editor()->sceneText().toUtf8());
    }

    void keysAreShownAndArrowsMove() {
        QWidget* field = openFrom((*driver_)->editor());
        QVERIFY(field);
        auto* list = palette()->findChild<QTreeWidget*>();
        QTest::keyClicks(field, QStringLiteral("redraw"));
        QCOMPARE(list->currentItem()->text(1), (*driver_)->actions()->redraw->shortcut().toString());
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(field, Qt::Key_Backspace);
        const int first = list->currentIndex().row();
        QTest::keyClick(field, Qt::Key_Down);
        QVERIFY(list->currentIndex().row() > first);
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(list->currentIndex().row(), first);
        QTest::keyClick(field, Qt::Key_PageDown);
        QVERIFY(list->currentIndex().row() >= first + 10);
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(field->hasFocus());
    }

    void whatIsSwitchedOffCannotBeRun() {
        WindowDriver& d = *driver_;
        d->actions()->redraw->setEnabled(false);
        int runs = 0;
        connect(d->actions()->redraw, &QAction::triggered, this, [&] { ++runs; });
        QWidget* field = openFrom(d->editor());
        QVERIFY(field);
        QTest::keyClicks(field, QStringLiteral("view redraw"));
        QCOMPARE(palette()->shown().first(), QStringLiteral("View › Redraw"));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(runs, 0);
        QVERIFY(palette());
    }

    void itGoesWithEscapeAndWithTheFocus() {
        WindowDriver& d = *driver_;
        const QByteArray before = d->editor()->sceneText().toUtf8();
        QWidget* field = openFrom(d->editor());
        QVERIFY(field);
        QTest::keyClicks(field, QStringLiteral("zz"));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!palette());
        QTRY_VERIFY(d->editor()->hasFocus());
        QVERIFY(openFrom(d->editor()));
        QTest::mouseClick(d->viewport(), Qt::LeftButton, {}, d->viewport()->rect().center());
        QTRY_VERIFY(!palette());
        QTRY_VERIFY(d->viewport()->hasFocus());
        // Its keys again close it, too.
        field = openFrom(d->editor());
        QVERIFY(field);
        QTest::keyClick(field, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!palette());
        QCOMPARE(d->editor()->sceneText().toUtf8(), before);
    }

    void itStaysWithinASmallWindow() {
        WindowDriver& d = *driver_;
        for (const QSize size : {QSize(900, 600), QSize(1600, 1000)}) {
            d.window().resize(size);
            QVERIFY(openFrom(d->editor()));
            QVERIFY(d.window().rect().contains(palette()->geometry()));
            auto* list = palette()->findChild<QTreeWidget*>();
            QVERIFY(list->columnWidth(0) + list->columnWidth(1) <= list->viewport()->width());
            QTest::keyClick(palette()->findChild<QLineEdit*>(), Qt::Key_Escape);
        }
    }
};

QTEST_MAIN(CommandPaletteTest)
#include "command_palette_test.moc"
