// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/slider_note.h"

#include <QTest>

#include "core/language/parse.h"

using namespace isoscope;

namespace {

/// The text with its change.
std::string changed(std::string text, const std::optional<TextEdit>& edit) {
    if (edit) text.replace(edit->begin, edit->end - edit->begin, edit->text);
    return text;
}

/// Behind the first `0.5`.
std::size_t numberEnd(const std::string& text) { return text.find("0.5") + 3; }

std::string written(const std::string& text, const std::optional<SliderNote>& note) {
    return changed(text, sliderNoteEdit(text, numberEnd(text), note));
}

}  // namespace

class SliderNoteTest : public QObject {
    Q_OBJECT

  private slots:
    void isReadAndWrittenTheSame_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("canonical");
        const auto row = [](const char* text, const char* canonical) {
            QTest::newRow(text) << QString(text) << QString(canonical);
        };
        row("[0:2]", "[0:2]");
        row("[0:2:0.01]", "[0:2:0.01]");
        row("[ -1.5 : +2e3 : 1 ]", "[-1.5:2000:1]");
        row("[0.001:10 log]", "[0.001:10 log]");
        row("[0:1 locked decimals 2]", "[0:1 decimals 2 locked]");
        row("[0:9 decimals 0]", "[0:9 decimals 0]");
        row("[0:9 decimals 15]", "[0:9 decimals 15]");
        row("[1:10:0.5 log decimals 3 locked] and words", "[1:10:0.5 log decimals 3 locked]");
    }
    void isReadAndWrittenTheSame() {
        QFETCH(QString, text);
        QFETCH(QString, canonical);
        const std::optional<SliderNote> note = readSliderNote(text.toStdString());
        QVERIFY(note);
        QCOMPARE(QString::fromStdString(toText(*note)), canonical);
        QVERIFY(readSliderNote(toText(*note)) == note);
    }

    void whatIsNoNoteIsAComment() {
        for (const char* text : {"",
                                 "[",
                                 "[0:2",
                                 "[2:0]",
                                 "[1:1]",
                                 "[0]",
                                 "0:2",
                                 "radius [0:2]",
                                 "[0:2:0]",
                                 "[0:2:-1]",
                                 "[0:2:3]",
                                 "[0:2 log]",
                                 "[-1:2 log]",
                                 "[0:2 lock]",
                                 "[0:2 decimals]",
                                 "[0:2 decimals 16]",
                                 "[0:2 decimals 99]",
                                 "[0:2 logs]",
                                 "[nan:2]",
                                 "[0:inf]",
                                 "[a:b]"})
            QVERIFY2(!readSliderNote(text), text);
    }

    void aNoteThatCannotBeIsTold_data() {
        QTest::addColumn<QString>("comment");
        QTest::addColumn<QString>("said");  // empty: nothing
        const QString options = "A step above 0";
        for (const auto& [comment, said] : std::initializer_list<std::pair<const char*, QString>>{
                 {"[0:1 log]", "A logarithmic slider has a lower end above 0."},
                 {"[2:0]", "Its lower end must be less"},
                 {"[0:inf]", "Its lower end must be less"},
                 {"[0:2", "Its `]` is missing."},
                 {"[0:2:0]", options},
                 {"[0:2:3]", options},
                 {"[0:2 lock]", options},
                 {"[0:2 decimals 99]", options},
                 {"[0:2:0.1 log", "Its `]` is missing."},
                 {"[1:2:0.1 log locked] of the ring", ""},
                 {"[see below]", ""},
                 {"[0]", ""},
                 {"radius [2:0]", ""},
                 {"", ""}})
            QTest::newRow(comment) << comment << said;
    }
    void aNoteThatCannotBeIsTold() {
        QFETCH(QString, comment);
        QFETCH(QString, said);
        const std::string begin = "#declare R = 0.5; // ";
        const isoscope::ParseResult parsed = isoscope::parseScene(begin + comment.toStdString() + "\n");
        QCOMPARE(parsed.diagnostics.size(), std::size_t(said.isEmpty() ? 0 : 1));
        if (said.isEmpty()) return;
        const isoscope::Diagnostic& told = parsed.diagnostics[0];
        QCOMPARE(told.severity, isoscope::Severity::note);
        QCOMPARE(std::size_t(told.range.begin), begin.size());
        QCOMPARE(std::size_t(told.range.end), begin.size() + static_cast<std::size_t>(comment.size()));
        QVERIFY2(told.message.find(said.toStdString()) != std::string::npos, told.message.c_str());
    }

    void belongsToTheLastNumberOfItsLine() {
        const auto behind = [](const std::string& text) { return sliderNoteBehind(text, numberEnd(text)); };
        QVERIFY(behind("#declare R = 0.5; // [0:2:0.01] radius\n") == (SliderNote{0, 2, 0.01}));
        QVERIFY(behind("#declare R = 0.5;//[0:2]") == (SliderNote{0, 2}));
        QVERIFY(behind("f_sphere(x, y, z, 0.5) } // [0:2]\r\n") == (SliderNote{0, 2}));
        QVERIFY(!behind("#declare R = 0.5; #declare S = 1; // [0:2]"));
        QVERIFY(!behind("#declare R = 0.5;\n// [0:2]"));
        QVERIFY(!behind("#declare R = 0.5; /* x */ // [0:2]"));
        QVERIFY(!behind("#declare R = 0.5; // radius [0:2]"));
        QVERIFY(!sliderNoteBehind("0.5", 99));
    }

    void isWrittenWithEveryOtherCharacterKept_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        const auto row = [](const char* name, const char* before, const char* after) {
            QTest::newRow(name) << QString(before) << QString(after);
        };
        row("none yet", "#declare R = 0.5;\nnext", "#declare R = 0.5;  // [0:2:0.1]\nnext");
        row("blanks behind", "#declare R = 0.5 ;\t \r\nnext", "#declare R = 0.5 ;  // [0:2:0.1]\t \r\nnext");
        row("end of the text", "#declare R = 0.5;", "#declare R = 0.5;  // [0:2:0.1]");
        // Words like any other, since a logarithmic range begins above 0.
        row("no usable note", "R = 0.5; // [0:1 log] radius\n", "R = 0.5; // [0:2:0.1] [0:1 log] radius\n");
        row("note", "R = 0.5;   //  [ 0 : 1 decimals 1]the radius\n", "R = 0.5;   //  [0:2:0.1]the radius\n");
        row("words", "R = 0.5; // the radius\n", "R = 0.5; // [0:2:0.1] the radius\n");
        row("words at once", "R = 0.5; //the radius\n", "R = 0.5; // [0:2:0.1] the radius\n");
        row("empty comment", "R = 0.5; //\n", "R = 0.5; // [0:2:0.1]\n");
    }
    void isWrittenWithEveryOtherCharacterKept() {
        QFETCH(QString, before);
        QFETCH(QString, after);
        const std::string result = written(before.toStdString(), SliderNote{0, 2, 0.1});
        QCOMPARE(QString::fromStdString(result), after);
        QVERIFY(sliderNoteBehind(result, numberEnd(result)) == (SliderNote{0, 2, 0.1}));
        // A second note takes the place of the first.
        const std::string again = written(result, SliderNote{1, 3});
        QVERIFY(again.size() == result.size() - 4 && again.find("[1:3]") != again.npos);
    }

    void isTakenAway() {
        QCOMPARE(written("R = 0.5;  // [0:2:0.1]\nx", std::nullopt), std::string("R = 0.5;\nx"));
        QCOMPARE(written("R = 0.5; // [0:2] radius", std::nullopt), std::string("R = 0.5; // radius"));
        QVERIFY(!sliderNoteEdit("R = 0.5; // radius", 7, std::nullopt));
    }

    void hasNoPlaceBeforeOtherCode() {
        const std::string text = "f_torus(x, y, z, 0.5, 0.1)";
        QVERIFY(!sliderNoteEdit(text, numberEnd(text), SliderNote{0, 2}));
    }
};

QTEST_APPLESS_MAIN(SliderNoteTest)
#include "slider_note_test.moc"
