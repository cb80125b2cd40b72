// SPDX-License-Identifier: GPL-3.0-or-later
// What the editor takes for a word of the language, beside POV-Ray's answers.
#include "widgets/editor/scene_words.h"

#include <QTest>
#include <map>

#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "widgets/editor/scene_scanner.h"

using namespace isoscope;

namespace {

QString colourOf(const std::string& text) {
    switch (SceneScanner(text, 0).next().style) {
        case SceneStyle::directive: return "directive";
        case SceneStyle::keyword: return "keyword";
        case SceneStyle::function: return "function";
        default: return "plain";
    }
}

}  // namespace

class SceneWordsTest : public QObject {
    Q_OBJECT

    const test::CsvTable answers_{QStringLiteral(ISOSCOPE_TEST_DATA "/language/reserved_words.csv")};
    std::map<std::string, QString> explained_;  ///< colours that do not follow from POV-Ray's answer

  private slots:
    void initTestCase() {
        const test::CsvTable table(QStringLiteral(ISOSCOPE_TEST_DATA "/language/editor_words.csv"));
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            QVERIFY(!table.field(row, "reason").empty());
            explained_[table.field(row, "word")] = QString::fromStdString(table.field(row, "colour"));
        }
        QVERIFY(!explained_.empty());
    }

    /// Reserved words are coloured, others are plain.
    void wordsAreColouredAndCompletedAsPovrayReservesThem_data() {
        QTest::addColumn<bool>("reserved");
        for (std::size_t row = 0; row < answers_.rowCount(); ++row)
            QTest::newRow(answers_.field(row, "word").c_str()) << (answers_.field(row, "declared") == "no");
    }
    void wordsAreColouredAndCompletedAsPovrayReservesThem() {
        QFETCH(bool, reserved);
        const std::string word = QTest::currentDataTag();
        const QString colour = colourOf(word);
        const bool completed = sceneWords().contains(QString::fromStdString(word));
        QCOMPARE(completed, colour != "plain");
        if (const auto row = explained_.find(word); row != explained_.end())
            QCOMPARE(colour, row->second);
        else
            QCOMPARE(completed, reserved);
    }

    void directivesAreColouredAndCompletedWithTheirHash() {
        for (const auto& [word, colour] : explained_) {
            if (colour != "plain") continue;
            QCOMPARE(colourOf("#" + word), QString("directive"));
            QVERIFY(sceneWords().contains("#" + QString::fromStdString(word)));
        }
    }

    /// They are directives and stand in statements as well.
    void wordsOfTwoUses() {
        for (const std::string word : {"read", "write", "version"}) {
            QCOMPARE(colourOf("#" + word), QString("directive"));
            QCOMPARE(colourOf(word), QString("keyword"));
        }
    }

    void functionsHaveCallTips() {
        QCOMPARE(callTip("atan2"), QString("atan2(A, B)"));
        QCOMPARE(callTip("min_extent"), QString("min_extent(OBJECT)"));
        QCOMPARE(callTip("sphere"), QString());
        for (const QString& word : sceneWords())
            QCOMPARE(callTip(word).isEmpty(), wordKind(word.toLatin1()) != WordKind::function);
    }
};

QTEST_GUILESS_MAIN(SceneWordsTest)
#include "scene_words_test.moc"
