// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/setting_text.h"

#include <QTest>

using namespace isoscope;

namespace {

/// The text after the change; empty when there is none.
std::string changed(std::string text, std::size_t isosurface, double value,
                    ParameterRole role = ParameterRole::maxGradient) {
    const ParseResult parsed = parseScene(text);
    const auto change = settingChange(parsed, isosurface, role, value);
    if (!change) return {};
    text.replace(change->range.begin, change->range.end - change->range.begin, change->text);
    return text;
}

}  // namespace

class SettingTextTest : public QObject {
    Q_OBJECT

  private slots:
    void evaluateIsWrittenOrReplaced() {
        const auto changed = [](const std::string& statement) {
            const ParseResult parsed = parseScene(statement);
            const auto change = evaluateChange(parsed, 0, {1.5, 1.2, 0.9});
            return change ? changedText(statement, {*change}) : std::string();
        };
        QCOMPARE(changed("isosurface { function { x } accuracy 0.1 }"),
                 std::string("isosurface { function { x }\n  evaluate 1.5, 1.2, 0.9 accuracy 0.1 }"));
        QCOMPARE(changed("isosurface { function { x } evaluate 2, (1 + 3)*2, 0.5 open }"),
                 std::string("isosurface { function { x } evaluate 1.5, 1.2, 0.9 open }"));
        QCOMPARE(changed("isosurface { function { x } evaluate 2*3, -1/2, 0.5 /* why */ }"),
                 std::string("isosurface { function { x } evaluate 1.5, 1.2, 0.9 /* why */ }"));
        QCOMPARE(changed("sphere { 0, 1 }"), std::string());
    }

    void aNumberIsReplaced() {
        QCOMPARE(changed("isosurface { function { x } max_gradient 1.1 accuracy 0.1 }", 0, 2.4),
                 std::string("isosurface { function { x } max_gradient 2.4 accuracy 0.1 }"));
    }

    void aMissingOneIsInsertedBehindTheFunction() {
        const std::string text = changed(
            "isosurface { function { x*x } contained_by { sphere { 0, 1.2 } } pigment { rgb 1 } }", 0, 2.4);
        QCOMPARE(text,
                 std::string(
                     "isosurface { function { x*x }\n  max_gradient 2.4 contained_by { sphere { 0, 1.2 } } "
                     "pigment { rgb 1 } }"));
        const ParseResult again = parseScene(text);
        QVERIFY(again.ok());
        QCOMPARE(again.scene->isosurfaces[0].shape->settings().maxGradient, 2.4);
    }

    void theRightOneOfSeveralIsChanged() {
        const std::string text =
            "isosurface { function { x } max_gradient 1 }\nisosurface { function { y } max_gradient 2 }";
        QCOMPARE(changed(text, 1, 12),
                 std::string("isosurface { function { x } max_gradient 1 }\nisosurface { function { y } "
                             "max_gradient 12 }"));
    }

    void accuracyIsSetTheSameWay() {
        QCOMPARE(changed("isosurface { function { x } max_gradient 2 accuracy 0.1 }", 0, 1e-4,
                         ParameterRole::accuracy),
                 std::string("isosurface { function { x } max_gradient 2 accuracy 0.0001 }"));
        QCOMPARE(changed("isosurface { function { x } }", 0, 0.01, ParameterRole::accuracy),
                 std::string("isosurface { function { x }\n  accuracy 0.01 }"));
        QVERIFY(
            changed("isosurface { function { x } threshold 1 }", 0, 0.01, ParameterRole::threshold).empty());
    }

    void allIsosurfacesAreChangedFromTheLastToTheFirst() {
        std::string text =
            "isosurface { function { x } accuracy 1 }\n#for (I, 1, 3) isosurface { function { y } } #end\n";
        const ParseResult parsed = parseScene(text);
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(4));
        const auto changes = settingChanges(parsed, ParameterRole::accuracy, 0.5);
        QCOMPARE(changes.size(), std::size_t(2));
        text = changedText(text, changes);
        QCOMPARE(text, std::string("isosurface { function { x } accuracy 0.5 }\n#for (I, 1, 3) isosurface { "
                                   "function { y }\n  accuracy 0.5 } #end\n"));
    }

    void nothingIsWrittenWhereThereIsNoStatement() {
        QVERIFY(changed("isosurface { function { x } }", 1, 2).empty());
        QVERIFY(changed("sphere { 0, 1 }", 0, 2).empty());
        QVERIFY(!settingChange(ParseResult{}, 0, ParameterRole::maxGradient, 2));
    }
};

QTEST_APPLESS_MAIN(SettingTextTest)
#include "setting_text_test.moc"
