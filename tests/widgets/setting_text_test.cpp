// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/setting_text.h"

#include <QTest>

using namespace isoscope;

namespace {

/// The text after the change; empty when there is none.
std::string changed(std::string text, std::size_t isosurface, double value) {
    const ParseResult parsed = parseScene(text);
    const auto change = maxGradientChange(parsed, isosurface, value);
    if (!change) return {};
    text.replace(change->range.begin, change->range.end - change->range.begin, change->text.toStdString());
    return text;
}

}  // namespace

class SettingTextTest : public QObject {
    Q_OBJECT

  private slots:
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

    void nothingIsWrittenWhereThereIsNoStatement() {
        QVERIFY(changed("isosurface { function { x } }", 1, 2).empty());
        QVERIFY(changed("sphere { 0, 1 }", 0, 2).empty());
        QVERIFY(!maxGradientChange(ParseResult{}, 0, 2));
    }
};

QTEST_APPLESS_MAIN(SettingTextTest)
#include "setting_text_test.moc"
