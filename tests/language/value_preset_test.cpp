// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/value_preset.h"

#include <QTest>

using namespace isoscope;

namespace {

std::string changed(std::string text, const TextEdit& edit) {
    return text.replace(edit.begin, edit.end - edit.begin, edit.text);
}

const ValuePreset thin{"Thin", {{"R", 0.5}, {"f_torus Minor Radius", -1e-7}}};
const std::string thinLine = "// preset \"Thin\": R = 0.5, f_torus Minor Radius = -1e-07";

}  // namespace

class ValuePresetTest : public QObject {
    Q_OBJECT

  private slots:
    void isReadAsItIsWritten() {
        const std::string text = changed("sphere {}", presetAdded("sphere {}", thin));
        QCOMPARE(text, "sphere {}\n" + thinLine + "\n");
        const std::vector<ValuePreset> presets = presetsOf(text);
        QCOMPARE(presets.size(), std::size_t(1));
        QCOMPARE(presets[0].name, thin.name);
        QVERIFY(presets[0].values == thin.values);
    }

    void newOnesStandBehindTheLast() {
        const std::string text = "// head\r\n// preset \"A\":\r\nbox {}\r\n";
        QCOMPARE(changed(text, presetAdded(text, {"B", {{"R", 1}}})),
                 std::string("// head\r\n// preset \"A\":\r\n// preset \"B\": R = 1\r\nbox {}\r\n"));
        QCOMPARE(changed("", presetAdded("", {"B", {}})), std::string("// preset \"B\":\n"));
    }

    void oneIsReplacedOrTakenAway() {
        const std::string text = "  //preset \"A\" : R=1 ,r=2\nbox {}\n// preset \"B\": R = 3";
        QCOMPARE(presetsOf(text).size(), std::size_t(2));
        QVERIFY(presetsOf(text)[0].values == (decltype(ValuePreset::values){{"R", 1}, {"r", 2}}));
        QCOMPARE(changed(text, presetReplaced(text, 1, thin)),
                 "  //preset \"A\" : R=1 ,r=2\nbox {}\n" + thinLine);
        QCOMPARE(changed(text, presetRemoved(text, 0)), std::string("box {}\n// preset \"B\": R = 3"));
        QCOMPARE(changed(text, presetRemoved(text, 1)), std::string("  //preset \"A\" : R=1 ,r=2\nbox {}\n"));
    }

    void otherCommentsAreNone() {
        for (const char* text :
             {"// presets are good", "// preset A: R = 1", "// preset \"A\" R = 1", "// preset \"A\": R",
              "// preset \"A\": R = x", "// preset \"A\": = 1", "// preset \"A\": R = 1,",
              "preset \"A\": R = 1", "x // preset \"A\": R = 1"})
            QVERIFY2(presetsOf(text).empty(), text);
    }

    void namesFitIntoALine() {
        QCOMPARE(presetWord(" a \"b\"\n=c, "), std::string("a  b   c"));
        const ValuePreset odd{"a\nb", {{"x,y", 1}}};
        const std::vector<ValuePreset> read = presetsOf(changed("", presetAdded("", odd)));
        QCOMPARE(read.size(), std::size_t(1));
        QCOMPARE(read[0].name, std::string("a b"));
        QCOMPARE(read[0].values[0].first, std::string("x y"));
    }
};

QTEST_APPLESS_MAIN(ValuePresetTest)
#include "value_preset_test.moc"
