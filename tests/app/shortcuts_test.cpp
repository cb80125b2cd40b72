// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <QAbstractSpinBox>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRandomGenerator>
#include <QScrollBar>
#include <QSlider>
#include <QTest>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/command_keys.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/window/shortcut_router.h"
#include "app/desktop/window/shortcut_window.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/editor_keys.h"
#include "widgets/editor/find_bar.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/functions/function_browser.h"
#include "widgets/numbers/number_box.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString precious = QStringLiteral("what was in the clipboard");

quint32 testSeed() {
    const int asked = qEnvironmentVariableIntValue("ISOSCOPE_SOAK_SEED");
    return asked > 0 ? static_cast<quint32>(asked) : QRandomGenerator::global()->generate() & 0x7fffffff;
}

void press(QWidget* widget, QKeyCombination keys) {
    QTest::keyClick(widget, keys.key(), keys.keyboardModifiers());
}

}  // namespace

/// The keys of menus, editor and picture: one table, and each key means the same wherever the focus is.
class ShortcutsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    /// Makes the widget of that name visible and gives it the focus.
    QWidget* focused(const QString& name) const {
        WindowDriver& d = *driver_;
        QWidget* widget = nullptr;
        if (name == QLatin1String("editor")) widget = d->editor();
        if (name == QLatin1String("picture")) widget = d->viewport();
        if (name == QLatin1String("slider"))
            widget = d->parameters()->slider(d.parameter(QStringLiteral("Radius")))->findChild<QSlider*>();
        if (name == QLatin1String("number box"))
            widget = d->parameters()->slider(d.parameter(QStringLiteral("Radius")))->findChild<NumberBox*>();
        if (name == QLatin1String("filter of parameters")) widget = d->parameters()->findChild<QLineEdit*>();
        if (name == QLatin1String("find field")) {
            auto* bar = d->findChild<FindBar*>();
            bar->showFind();
            widget = bar->findChild<QLineEdit*>();
        }
        if (name == QLatin1String("combo box")) {
            raised(d->docks()->find("section"), nullptr);
            for (QComboBox* box : d->study<SectionPanel>()->findChildren<QComboBox*>())
                if (box->isVisible()) widget = box;
        }
        if (name == QLatin1String("functions"))
            widget = raised(d->docks()->find("functions"), d->functions());
        if (name == QLatin1String("section")) {
            raised(d->docks()->find("section"), nullptr);
            widget = d->study<SectionPanel>()->findChild<QAbstractSpinBox*>();
        }
        if (!widget) return nullptr;
        widget->setFocus();
        return QTest::qWaitFor([&] { return QApplication::focusWidget() == widget; }, 2000) ? widget
                                                                                            : nullptr;
    }

    /// The first widget of the panel that takes keys.
    static QWidget* raised(QDockWidget* dock, QWidget* panel) {
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        if (!panel) return nullptr;
        for (QAbstractItemView* view : panel->findChildren<QAbstractItemView*>())
            if (view->isVisible()) return view;
        return nullptr;
    }

    static QStringList places() {
        return {QStringLiteral("editor"),     QStringLiteral("picture"),
                QStringLiteral("slider"),     QStringLiteral("number box"),
                QStringLiteral("find field"), QStringLiteral("filter of parameters"),
                QStringLiteral("combo box"),  QStringLiteral("functions"),
                QStringLiteral("section")};
    }

    QByteArray text() const { return (*driver_)->editor()->sceneText().toUtf8(); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
        QGuiApplication::clipboard()->setText(precious);
    }
    void cleanup() { driver_.reset(); }

    void noTwoCommandsShareAKey_D2() {
        QMap<QString, QString> owners;
        QStringList clashes;
        const auto claim = [&](const QKeySequence& keys, const QString& owner) {
            const QString key = keys.toString();
            if (owners.contains(key)) clashes << key + ": " + owners[key] + ", " + owner;
            owners[key] = owner;
        };
        for (const QAction* action : (*driver_)->actions()->all())
            for (const QKeySequence& keys : action->shortcuts()) {
                QCOMPARE(keys.count(), 1);
                // A letter alone is text, and arrows alone belong to whatever has the focus.
                const bool plain = !(keys[0].keyboardModifiers() & ~Qt::ShiftModifier);
                const bool function = keys[0].key() >= Qt::Key_F1 && keys[0].key() <= Qt::Key_F35;
                const bool known = keys == QKeySequence(Qt::SHIFT | Qt::Key_Escape) ||
                                   keys == QKeySequence(Qt::SHIFT | Qt::Key_Delete) ||
                                   keys == QKeySequence(Qt::SHIFT | Qt::Key_Insert);
                QVERIFY2(!plain || function || known, qPrintable(keys.toString()));
                claim(keys, action->text());
            }
        for (const EditorKey& entry : editorKeys())
            for (const QKeyCombination key : entry.keys) {
                claim(key, entry.name);
                if (entry.selecting != 0)
                    claim(QKeyCombination(key.keyboardModifiers() | Qt::ShiftModifier, key.key()),
                          entry.name + " (selecting)");
            }
        QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join('\n')));
    }

    void noMenuHasTwoEqualMnemonics_D27() {
        QStringList clashes;
        QList<QWidget*> menus{(*driver_)->menuBar()};
        for (QMenu* menu : (*driver_)->menuBar()->findChildren<QMenu*>()) menus << menu;
        for (const QWidget* menu : menus) {
            QMap<QString, QString> owners;
            for (const QAction* action : menu->actions()) {
                const QString key = QKeySequence::mnemonic(action->text()).toString();
                // Lists of files and panels have none; what a person finds in every session has one.
                if (key.isEmpty()) continue;
                if (owners.contains(key)) clashes << key + ": " + owners[key] + ", " + action->text();
                owners[key] = action->text();
            }
        }
        QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join('\n')));
    }

    /// Each command's keys reach the command and nothing else, wherever the focus is. What the commands do
    /// is left out here: all that is connected to them is taken away.
    void everyShortcutReachesItsCommandInEveryFocus_D2_data() {
        QTest::addColumn<QString>("place");
        for (const QString& place : places()) QTest::newRow(qPrintable(place)) << place;
    }
    void everyShortcutReachesItsCommandInEveryFocus_D2() {
        QFETCH(QString, place);
        QStringList triggered;
        for (QAction* action : (*driver_)->actions()->all()) {
            action->setEnabled(true);
            disconnect(action, &QAction::triggered, nullptr, nullptr);
            disconnect(action, &QAction::toggled, nullptr, nullptr);
            connect(action, &QAction::triggered, this, [&triggered, action] { triggered << action->text(); });
        }
        QWidget* widget = focused(place);
        QVERIFY2(widget, qPrintable(place));
        const QByteArray before = text();
        QStringList wrong;
        for (const QAction* action : (*driver_)->actions()->all())
            for (const QKeySequence& keys : action->shortcuts()) {
                triggered.clear();
                const QKeyEvent event(QEvent::KeyPress, keys[0].key(), keys[0].keyboardModifiers());
                const bool field = ShortcutRouter::isFieldCommand(widget, event);
                press(widget, keys[0]);
                const QStringList expected = field ? QStringList() : QStringList(action->text());
                if (triggered != expected)
                    wrong << keys.toString() + " of " + action->text() + " called " + triggered.join(", ");
                if (text() != before) wrong << keys.toString() + " changed the text";
                // Copying is for the clipboard; Select All comes before it in no table.
                if (!field && QGuiApplication::clipboard()->text() != precious)
                    wrong << keys.toString() + " changed the clipboard";
                QGuiApplication::clipboard()->setText(precious);
                if (QApplication::focusWidget() != widget) wrong << keys.toString() + " took the focus";
                widget->setFocus();
            }
        for (const QAction* action : (*driver_)->actions()->all())
            disconnect(action, &QAction::triggered, this, nullptr);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void studiesByKeyLeaveTextAndClipboardAlone_D2() {
        WindowDriver& d = *driver_;
        QWidget* editor = focused(QStringLiteral("editor"));
        const QByteArray before = text();
        press(editor, Qt::CTRL | Qt::Key_L);
        QVERIFY(d->actions()->sectionPlane->isChecked());
        editor = focused(QStringLiteral("editor"));
        press(editor, Qt::CTRL | Qt::Key_D);
        QVERIFY(d->actions()->overlayHoles->isChecked());
        press(editor, Qt::CTRL | Qt::Key_U);
        QVERIFY(d->actions()->verdicts->isChecked());
        press(editor, Qt::CTRL | Qt::Key_T);
        const int size = d->editor()->textHeight(0);
        press(editor, Qt::CTRL | Qt::Key_Plus);
        press(editor, Qt::CTRL | Qt::Key_Equal);
        QVERIFY(d->editor()->textHeight(0) > size);
        press(editor, Qt::CTRL | Qt::Key_0);
        QCOMPARE(d->editor()->textHeight(0), size);
        QCOMPARE(text(), before);
        QCOMPARE(QGuiApplication::clipboard()->text(), precious);
    }

    void keysThatMeanNothingTypeNothing_D2() {
        QWidget* editor = focused(QStringLiteral("editor"));
        const QByteArray before = text();
        QList<QKeySequence> commands;
        for (const QAction* action : (*driver_)->actions()->all()) commands << action->shortcuts();
        for (const Qt::KeyboardModifiers modifiers :
             {Qt::KeyboardModifiers(Qt::ControlModifier), Qt::ControlModifier | Qt::ShiftModifier,
              Qt::KeyboardModifiers(Qt::AltModifier), Qt::AltModifier | Qt::ShiftModifier,
              Qt::ControlModifier | Qt::AltModifier})
            for (int key = Qt::Key_Space; key <= Qt::Key_AsciiTilde; ++key) {
                const QKeyCombination keys(modifiers, static_cast<Qt::Key>(key));
                if (commands.contains(QKeySequence(keys))) continue;
                // Alt opens menus, which are none of the editor's.
                QKeyEvent event(QEvent::KeyPress, key, modifiers, QString(QChar(key)));
                QCoreApplication::sendEvent(editor, &event);
                QVERIFY2(text() == before, qPrintable(QKeySequence(keys).toString()));
            }
        QCOMPARE(QGuiApplication::clipboard()->text(), precious);
    }

    void clipboardCommandsActOnTheFieldWithTheFocus() {
        WindowDriver& d = *driver_;
        auto* field = qobject_cast<QLineEdit*>(focused(QStringLiteral("find field")));
        QVERIFY(field);
        field->setText(QStringLiteral("Radius"));
        const QByteArray before = text();
        press(field, Qt::CTRL | Qt::Key_A);
        press(field, Qt::CTRL | Qt::Key_X);
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("Radius"));
        QVERIFY(field->text().isEmpty());
        QCOMPARE(text(), before);
        // From anywhere else they act on the text.
        QWidget* picture = focused(QStringLiteral("picture"));
        press(picture, Qt::CTRL | Qt::Key_A);
        press(picture, Qt::CTRL | Qt::Key_C);
        QCOMPARE(QGuiApplication::clipboard()->text().toUtf8(), before);
        press(picture, Qt::CTRL | Qt::Key_X);
        QVERIFY(text().isEmpty());
        press(picture, Qt::CTRL | Qt::Key_Z);
        QCOMPARE(text(), before);
        Q_UNUSED(d)
    }

    void undoInANumberBoxIsTheScenes() {
        WindowDriver& d = *driver_;
        const QByteArray before = text();
        QWidget* box = focused(QStringLiteral("number box"));
        QTest::keyClick(box, Qt::Key_Up);
        QVERIFY(text() != before);
        press(box, Qt::CTRL | Qt::Key_Z);
        QCOMPARE(text(), before);
        press(box, Qt::CTRL | Qt::Key_Y);
        QVERIFY(text() != before);
        Q_UNUSED(d)
    }

    /// 1000 random keys of the table in random places: the text changes only by commands that edit it, and
    /// undo brings the first text back.
    void randomShortcutsChangeTheTextOnlyByEditing() {
        WindowDriver& d = *driver_;
        const quint32 seed = testSeed();
        qInfo("seed %u (ISOSCOPE_SOAK_SEED)", seed);
        QRandomGenerator random(seed);
        Actions* actions = d->actions();
        struct Key {
            QString name;
            QKeyCombination keys;
            bool edits = false;
            bool ofEditor = false;
        };
        QList<Key> keys;
        // These ask for a file or another window, or end the session: nothing that a key by itself does.
        const QList<QAction*> asking = {actions->newFile,   actions->open,     actions->save,
                                        actions->saveAs,    actions->quit,     actions->exportImage,
                                        actions->shortcuts, actions->whatsThis};
        const QList<QAction*> editing = {actions->undo,  actions->redo,    actions->cut,
                                         actions->paste, actions->comment, actions->writeView};
        for (QAction* action : actions->all())
            for (const QKeySequence& sequence : action->shortcuts())
                if (!asking.contains(action))
                    keys << Key{action->text(), sequence[0], editing.contains(action), false};
        for (const EditorKey& entry : editorKeys())
            for (const QKeyCombination key : entry.keys) keys << Key{entry.name, key, entry.edits, true};
        const QByteArray first = text();
        const QStringList all = places();
        int edits = 0;
        for (int i = 0; i < 1000; ++i) {
            const Key& key = keys[static_cast<int>(random.bounded(keys.size()))];
            const QString place =
                key.ofEditor ? all.first() : all[static_cast<int>(random.bounded(all.size()))];
            // Sliders come and go with the text.
            if ((place == all[2] || place == all[3]) && d.parameter(QStringLiteral("Radius")) < 0) continue;
            QWidget* widget = focused(place);
            if (!widget) continue;
            const QByteArray before = text();
            press(widget, key.keys);
            const bool changed = text() != before;
            edits += changed;
            QVERIFY2(!changed || key.edits,
                     qPrintable(QStringLiteral("%1: %2 in %3").arg(i).arg(key.name, place)));
            if (i % 50 == 0) QTest::qWait(20);
        }
        qInfo("%d keys changed the text", edits);
        QVERIFY(edits > 50);
        for (int i = 0; i < 10000 && d->editor()->isUndoAvailable(); ++i) d->editor()->undo();
        QCOMPARE(text(), first);
    }

    void shortcutWindowShowsMenuNamesUncut_D28() {
        WindowDriver& d = *driver_;
        d->actions()->shortcuts->trigger();
        auto* window = d->findChild<ShortcutWindow*>();
        QVERIFY(window);
        auto* table = window->findChild<QTreeWidget*>();
        QTRY_VERIFY(table->isVisible());
        QVERIFY(!table->horizontalScrollBar()->isVisible());
        QStringList names;
        for (int i = 0; i < table->topLevelItemCount(); ++i) {
            const QTreeWidgetItem* group = table->topLevelItem(i);
            for (int j = 0; j < group->childCount(); ++j) {
                const QTreeWidgetItem* row = group->child(j);
                names << row->text(0);
                for (const int column : {0, 1}) {
                    const int wanted = table->fontMetrics().horizontalAdvance(row->text(column));
                    const int indented = column == 0 ? table->indentation() : 0;
                    QVERIFY2(wanted + indented <= table->columnWidth(column), qPrintable(row->text(column)));
                }
            }
        }
        for (const QAction* action : d->actions()->all()) {
            if (action->shortcuts().isEmpty()) continue;
            const QString name = QString(action->text()).remove(QLatin1Char('&'));
            QVERIFY2(std::any_of(names.begin(), names.end(),
                                 [&](const QString& shown) { return shown.endsWith(name); }),
                     qPrintable(name));
        }
        for (const EditorKey& entry : editorKeys()) QVERIFY(names.contains(entry.name));

        auto* search = window->findChild<QLineEdit*>();
        search->setText(QStringLiteral("ctrl+shift+"));
        int shown = 0;
        for (int i = 0; i < table->topLevelItemCount(); ++i)
            for (int j = 0; j < table->topLevelItem(i)->childCount(); ++j)
                shown += !table->topLevelItem(i)->isHidden() && !table->topLevelItem(i)->child(j)->isHidden();
        QVERIFY(shown > 0 && shown < names.size() / 2);
        window->close();
    }

    void keysAreChangedToldAndSetBack() {
        WindowDriver& d = *driver_;
        Actions* actions = d->actions();
        actions->shortcuts->trigger();
        auto* window = d->findChild<ShortcutWindow*>();
        QTRY_VERIFY(window->isVisible());
        auto* field = window->findChild<QKeySequenceEdit*>();
        const auto button = [window](const char* text) {
            for (QPushButton* one : window->findChildren<QPushButton*>())
                if (one->text() == QLatin1String(text)) return one;
            return static_cast<QPushButton*>(nullptr);
        };
        const auto says = [window](const QString& words) {
            for (const QLabel* label : window->findChildren<QLabel*>())
                if (label->text().contains(words)) return true;
            return false;
        };
        window->edit(actions->redraw);
        // Keys of another command: told, and taken from it only when they are set.
        field->setKeySequence(Qt::CTRL | Qt::Key_S);
        QVERIFY(says(QStringLiteral("“Save” has these keys")));
        QCOMPARE(actions->save->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_S));
        button("Set")->click();
        QCOMPARE(actions->redraw->shortcuts(), QList<QKeySequence>{Qt::CTRL | Qt::Key_S});
        QVERIFY(actions->save->shortcuts().isEmpty());
        QVERIFY2(!actions->save->toolTip().contains(QStringLiteral("Ctrl")),
                 qPrintable(actions->save->toolTip()));
        // A letter, and what the text needs, are refused.
        for (const QKeySequence& keys :
             {QKeySequence(Qt::Key_A), QKeySequence(Qt::SHIFT | Qt::Key_A),
              QKeySequence(Qt::CTRL | Qt::Key_Home), QKeySequence(Qt::Key_Return)}) {
            field->setKeySequence(keys);
            QVERIFY2(!button("Set")->isEnabled(), qPrintable(keys.toString()));
            QVERIFY(!d->keys()->assign(actions->redraw, keys));
        }
        field->setKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_J);
        QVERIFY(says(QStringLiteral("free")));
        button("Set")->click();
        window->close();

        d.restart();
        actions = d->actions();
        QCOMPARE(actions->redraw->shortcuts(), QList<QKeySequence>{Qt::CTRL | Qt::ALT | Qt::Key_J});
        QVERIFY(actions->save->shortcuts().isEmpty());
        int redrawn = 0;
        connect(actions->redraw, &QAction::triggered, this, [&redrawn] { ++redrawn; });
        d.window().activateWindow();
        QWidget* editor = focused(QStringLiteral("editor"));
        QVERIFY(editor);
        press(editor, Qt::CTRL | Qt::ALT | Qt::Key_J);
        QCOMPARE(redrawn, 1);

        d->keys()->reset(actions->save);
        QCOMPARE(actions->save->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_S));
        d->keys()->assign(actions->findNext, {});
        d->keys()->resetAll();
        for (const QAction* action : actions->all())
            QVERIFY2(d->keys()->isUsual(action), qPrintable(action->text()));
        d.restart();
        QCOMPARE(d->actions()->redraw->shortcuts(),
                 QKeySequence::keyBindings(QKeySequence::Refresh).mid(0, 1));
    }

    void commandsHaveNamesOfTheirOwn() {
        QStringList names;
        for (const QAction* action : (*driver_)->actions()->all()) names << action->objectName();
        QVERIFY2(!names.contains(QString()),
                 "a command is missing in Actions::nameAll(): its keys cannot be kept");
        QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), names.size());
    }
};

QTEST_MAIN(ShortcutsTest)
#include "shortcuts_test.moc"
