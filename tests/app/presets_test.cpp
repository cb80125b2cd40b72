// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QStatusBar>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/preset_controller.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray scene =
    "#declare R = 0.5;\n"
    "isosurface { function { f_torus(x, y, z, R, 0.1) } threshold 0 max_gradient 1 accuracy 0.01\n"
    "  contained_by { sphere { 0, 2 } } pigment { rgb 1 } }\n"
    "camera { location <0, 3, -4> look_at 0 } light_source { <5, 9, -5> 1 }";

}  // namespace

/// Presets in the real window, by their menu.
class PresetsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    PresetController* presets() const { return window().findChild<PresetController*>(); }
    QString text() const { return window().editor()->sceneText(); }
    double value(const char* name) const {
        return window().parameters()->slider(driver_->parameter(name))->value();
    }
    void undo() const { window().actions()->undo->trigger(); }
    static QAction* entry(const QMenu* menu, const QString& text) {
        for (QAction* action : menu->actions())
            if (action->text() == text) return action;
        return nullptr;
    }
    /// Chooses an entry of the menu, or of the submenu of this title.
    bool choose(const QString& text, const QString& submenu = {}) const {
        emit presets()->menu()->aboutToShow();
        const QMenu* menu = presets()->menu();
        if (!submenu.isEmpty()) menu = entry(menu, submenu) ? entry(menu, submenu)->menu() : nullptr;
        QAction* action = menu ? entry(menu, text) : nullptr;
        if (!action || !action->isEnabled()) return false;
        action->trigger();
        return true;
    }
    bool type(const QString& name, Qt::Key key = Qt::Key_Return) const {
        if (!presets()->nameField()->isVisible()) return false;
        QTest::keyClicks(presets()->nameField(), name);
        QTest::keyClick(presets()->nameField(), key);
        return true;
    }
    /// One called Thin, of the opened values.
    bool addThin() const { return choose("New preset…") && type("Thin") && driver_->rests(); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void aPresetIsALineOfTheText() {
        QVERIFY(addThin());
        QVERIFY(!presets()->nameField()->isVisible());
        QCOMPARE(text().toUtf8(),
                 scene +
                     "\n// preset \"Thin\": R = 0.5, f_torus Minor Radius = 0.1, isosurface threshold = 0, "
                     "isosurface max_gradient = 1, isosurface accuracy = 0.01, contained_by center = 0, "
                     "contained_by radius = 2\n");
        undo();
        QCOMPARE(text().toUtf8(), scene);
        QVERIFY(!window().actions()->undo->isEnabled());
    }

    void settingOneIsOneStep() {
        QVERIFY(addThin());
        driver_->drag(driver_->parameter("R"), 40);
        driver_->drag(driver_->parameter("Minor Radius"), 40);
        QVERIFY(driver_->rests());
        const QString moved = text();
        const double r = value("R"), minor = value("Minor Radius");
        QVERIFY(r > 0.5 && minor > 0.1);
        const QImage before = driver_->picture();
        QVERIFY(choose("Thin"));
        QCOMPARE(value("R"), 0.5);
        QVERIFY(driver_->rests());
        QCOMPARE(driver_->numberBehind("#declare R = "), 0.5);
        QCOMPARE(value("Minor Radius"), 0.1);
        QVERIFY(difference(before, driver_->picture()) > 0);
        undo();
        QCOMPARE(text(), moved);
        QVERIFY(driver_->rests());
        QCOMPARE(value("R"), r);
        QCOMPARE(value("Minor Radius"), minor);
    }

    void lockedOnesStayAndMissingOnesAreTold() {
        QVERIFY(addThin());
        driver_->drag(driver_->parameter("R"), 40);
        const double r = value("R");
        auto* row = window().parameters()->slider(driver_->parameter("R"));
        SliderNote note = row->note();
        note.locked = true;
        row->changeNote(note);
        driver_->typeBehind("// preset \"Thin\": ", "Gone = 1, ");
        QVERIFY(driver_->rests());
        QVERIFY(choose("Thin"));
        QCOMPARE(driver_->numberBehind("#declare R = "), r);
        const QString said = window().statusBar()->currentMessage();
        QVERIFY2(said.contains("left as they are: 1") && said.contains("Not in the text: 1"),
                 qPrintable(said));
    }

    void oneIsUpdatedRenamedAndDeleted() {
        QVERIFY(addThin());
        const QString first = text();
        driver_->drag(driver_->parameter("R"), 40);
        const double r = value("R");
        QVERIFY(choose("Thin", "Update"));
        QCOMPARE(driver_->numberBehind("// preset \"Thin\": R = "), r);
        QVERIFY(choose("Thin", "Rename"));
        QVERIFY(type("Fat & round"));
        const QString renamed = text();
        QCOMPARE(driver_->numberBehind("// preset \"Fat & round\": R = "), r);
        QVERIFY(choose("Fat && round", "Delete"));
        QVERIFY(!text().contains("preset"));
        undo();
        QCOMPARE(text(), renamed);
        for (int i = 0; i < 3; ++i) undo();
        QCOMPARE(text(), first);
    }

    void namesAreChecked() {
        QVERIFY(addThin());
        const QString before = text();
        QVERIFY(choose("New preset…"));
        QVERIFY(type("Thin"));
        QVERIFY(presets()->nameField()->isVisible());  // there is one already
        presets()->nameField()->selectAll();
        QVERIFY(type("  "));
        QVERIFY(presets()->nameField()->isVisible());
        QVERIFY(type("x", Qt::Key_Escape));
        QVERIFY(!presets()->nameField()->isVisible());
        QCOMPARE(text(), before);
        QVERIFY(choose("Thin", "Rename"));
        QVERIFY(type("", Qt::Key_Return));  // as it was
        QCOMPARE(text(), before);
    }

    void severalCallsHaveNamesOfTheirOwn() {
        QVERIFY(driver_->openText(
            "isosurface { function { f_torus(x, y, z, 0.8, 0.1) + f_torus(x, y, z, 0.5, 0.2) } }"
            " #declare A = 1; #declare A = 2;\n",
            "two.pov"));
        QVERIFY(driver_->rests());
        const auto values = window().parameters()->presetValues();
        QStringList names;
        for (const auto& [name, value] : values) names << QString::fromStdString(name);
        QVERIFY2(names.contains("f_torus (2) Major Radius") && names.contains("A (2)"),
                 qPrintable(names.join(", ")));
        names.removeDuplicates();
        QCOMPARE(static_cast<std::size_t>(names.size()), values.size());
    }
};

QTEST_MAIN(PresetsTest)
#include "presets_test.moc"
