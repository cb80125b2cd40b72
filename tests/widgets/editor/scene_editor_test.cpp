// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_editor.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QPaintEvent>
#include <QTest>

#include "tests/widgets/gui_events.h"
#include "widgets/editor/diagnostic_marks.h"
#include "widgets/editor/editor_grounds.h"
#include "widgets/editor/scene_lexer.h"
#include "widgets/editor/text_search.h"
#include "widgets/numbers/number_marks.h"

using namespace isoscope;
using namespace isoscope::test;
using Sci = QsciScintillaBase;

namespace {

const QString wide = QString::fromUtf8(
    "// \xf0\x9f\x98\x80 \xe6\xbc\xa2\xe5\xad\x97 gr\xc3\xbc\xc3\x9f"
    "e\n");

SourceRange rangeOf(const SceneEditor& editor, const std::string& part) {
    const auto begin = static_cast<std::uint32_t>(editor.utf8().find(part));
    return {0, begin, begin + static_cast<std::uint32_t>(part.size())};
}

QPoint pointAt(SceneEditor& editor, long position) {
    return QPoint(static_cast<int>(editor.SendScintilla(Sci::SCI_POINTXFROMPOSITION, 0L, position)) + 2,
                  static_cast<int>(editor.SendScintilla(Sci::SCI_POINTYFROMPOSITION, 0L, position)) + 4);
}

QString longText() {
    QString text;
    for (int i = 0; text.size() < 97 * 1024; ++i)
        text += QString("sphere { <%1, 0.5, -2>, 1.25 } // line %1\n").arg(i);
    return text;
}

/// What of a widget is painted from now on.
class PaintedRegion : public QObject {
  public:
    explicit PaintedRegion(QWidget* widget) { widget->installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) region += static_cast<QPaintEvent*>(event)->region();
        return false;
    }

    QRegion region;
};

}  // namespace

class SceneEditorTest : public QObject {
    Q_OBJECT

    std::unique_ptr<SceneEditor> editor_;

    long caret() const { return editor_->SendScintilla(Sci::SCI_GETCURRENTPOS); }
    void setCaret(long position) const {
        editor_->SendScintilla(Sci::SCI_GOTOPOS, static_cast<unsigned long>(position));
    }
    void load(const QString& text) const { editor_->setSceneText(text); }

  private slots:
    void init() {
        editor_ = std::make_unique<SceneEditor>();
        editor_->resize(600, 400);
        QVERIFY(showActive(editor_.get()));
        editor_->setFocus();
    }
    void cleanup() { editor_.reset(); }

    void anyTextSurvives_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("plain") << "sphere { 0, 1 }\n";
        QTest::newRow("wide") << wide;
        QTest::newRow("nul") << QString::fromLatin1("a\0b\0", 4);
        QTest::newRow("empty") << "";
        QTest::newRow("dos") << "a\r\nb";
        QTest::newRow("97 kB") << longText();
    }
    void anyTextSurvives() {
        QFETCH(QString, text);
        QSignalSpy loaded(editor_.get(), &SceneEditor::textLoaded),
            edited(editor_.get(), &SceneEditor::textEdited);
        load(text);
        QCOMPARE(editor_->sceneText(), text);
        QCOMPARE(QString::fromStdString(editor_->utf8()), text);
        QCOMPARE(loaded.count(), 1);
        QCOMPARE(edited.count(), 0);
        QVERIFY(!editor_->isModified());
        QVERIFY(!editor_->isUndoAvailable());
        QCOMPARE(caret(), 0L);
    }

    void typingIsTheUsers() {
        QSignalSpy edited(editor_.get(), &SceneEditor::textEdited),
            replaced(editor_.get(), &SceneEditor::numberReplaced);
        const quint64 before = editor_->revision();
        type(editor_.get(), QString::fromUtf8("x\xe6\xbc\xa2"));
        QCOMPARE(editor_->sceneText(), QString::fromUtf8("x\xe6\xbc\xa2"));
        QCOMPARE(edited.count(), 2);
        QCOMPARE(replaced.count(), 0);
        QVERIFY(editor_->revision() > before);
        QVERIFY(editor_->isModified());
    }

    void bracesIndent() {
        type(editor_.get(), "isosurface {\nopen\n}\n");
        QCOMPARE(editor_->sceneText(), QString("isosurface {\n  open\n}\n"));
        load("");
        type(editor_.get(), "union {\nbox { 0, 1 }\nsphere { // }\n0, 1\n}\n}\n");
        QCOMPARE(editor_->sceneText(),
                 QString("union {\n  box { 0, 1 }\n  sphere { // }\n    0, 1\n  }\n}\n"));
    }

    void replacesOneNumberBehindWideCharacters() {
        load(wide + "threshold 0.35 // end");
        setCaret(3);
        QVERIFY(editor_->replaceRange(rangeOf(*editor_, "0.35"), "0.4"));
        QCOMPARE(editor_->sceneText(), wide + "threshold 0.4 // end");
        QCOMPARE(caret(), 3L);
        editor_->undo();
        QCOMPARE(editor_->sceneText(), wide + "threshold 0.35 // end");
    }

    void refusesRangesThatAreNone() {
        load(QString::fromUtf8("\xe6\xbc\xa2"));
        QVERIFY(!editor_->replaceRange({0, 1, 3}, "x"));  // cuts the character
        QVERIFY(!editor_->replaceRange({0, 0, 4}, "x"));
        QVERIFY(!editor_->replaceRange({0, 3, 0}, "x"));
        QVERIFY(!editor_->replaceRange({1, 0, 3}, "x"));  // another file
        QCOMPARE(editor_->sceneText(), QString::fromUtf8("\xe6\xbc\xa2"));
    }

    void caretSelectionAndScrollStay() {
        load(longText());
        const std::string text = editor_->utf8();
        const auto number = static_cast<std::uint32_t>(text.find("1.25"));
        const long far = static_cast<long>(text.find("line 1500"));
        editor_->SendScintilla(Sci::SCI_SETSEL, static_cast<unsigned long>(far), far + 4);
        editor_->SendScintilla(Sci::SCI_SETFIRSTVISIBLELINE, 1480UL);
        QVERIFY(editor_->replaceRange({0, number, number + 4}, "17.125"));
        QCOMPARE(editor_->selectedText(), QString("line"));
        QCOMPARE(editor_->SendScintilla(Sci::SCI_GETSELECTIONSTART), far + 2);
        QCOMPARE(editor_->SendScintilla(Sci::SCI_GETFIRSTVISIBLELINE), 1480L);
    }

    void caretInsideTheNumberStays_data() {
        QTest::addColumn<int>("before");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("after");
        QTest::newRow("in the middle") << 2 << "0.4567" << 2;
        QTest::newRow("at its end") << 4 << "0.4567" << 6;
        QTest::newRow("behind what is left") << 3 << "1" << 1;
        QTest::newRow("at its begin") << 0 << "17" << 0;
    }
    void caretInsideTheNumberStays() {
        QFETCH(int, before);
        QFETCH(QString, text);
        load("0.35 x");
        setCaret(before);
        QVERIFY(editor_->replaceRange({0, 0, 4}, text));
        QTEST(static_cast<int>(caret()), "after");
    }

    void aDragIsOneUndoStep() {
        load("R = 1; S = 2;");
        editor_->markNumbers({rangeOf(*editor_, "1"), rangeOf(*editor_, "2")});
        type(editor_.get(), "a");
        QSignalSpy edited(editor_.get(), &SceneEditor::textEdited),
            replaced(editor_.get(), &SceneEditor::numberReplaced);
        editor_->beginDrag();
        for (int i = 0; i < 50; ++i) QVERIFY(editor_->replaceNumber(0, QString::number(10 * i + 0.5)));
        editor_->undo();  // waits for the end of the drag
        editor_->endDrag();
        QCOMPARE(editor_->sceneText(), QString("aR = 490.5; S = 2;"));
        QCOMPARE(edited.count(), 0);
        QCOMPARE(replaced.count(), 50);
        QVERIFY(editor_->replaceNumber(1, "7"));  // its range has followed
        QCOMPARE(editor_->sceneText(), QString("aR = 490.5; S = 7;"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("aR = 490.5; S = 2;"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("aR = 1; S = 2;"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("R = 1; S = 2;"));
        editor_->redo();
        editor_->redo();
        QCOMPARE(editor_->sceneText(), QString("aR = 490.5; S = 2;"));
    }

    void anEmptyDragLeavesNoStep() {
        load("1");
        editor_->beginDrag();
        editor_->endDrag();
        editor_->endDrag();  // one too many
        QVERIFY(!editor_->isUndoAvailable());
        QVERIFY(!editor_->isDragging());
    }

    void changesWithoutADragJoinUntilAPause() {
        load("1");
        editor_->markNumbers({{0, 0, 1}});
        for (const char* text : {"2", "3", "4"}) QVERIFY(editor_->replaceNumber(0, text));
        QTest::qWait(600);
        for (const char* text : {"5", "6"}) QVERIFY(editor_->replaceNumber(0, text));
        editor_->undo();  // closes the group that is still open
        QCOMPARE(editor_->sceneText(), QString("4"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("1"));
    }

    /// Each call looks through all lines: one for each word stopped the window for 20 s in 60 000 lines.
    void aTextIsStyledInOneCall() {
        int calls = 0;
        editor_->SendScintilla(Sci::SCI_SETMODEVENTMASK, static_cast<long>(Sci::SC_MODEVENTMASKALL));
        connect(editor_.get(), &Sci::SCN_MODIFIED, this, [&](int, int kind) {
            if (kind & Sci::SC_MOD_CHANGESTYLE) ++calls;
        });
        editor_->setText(QStringLiteral("#declare A = 1; // [0:2]\n").repeated(1000));
        editor_->SendScintilla(Sci::SCI_COLOURISE, 0UL, -1L);
        QCOMPARE(styleAt(editor_.get(), 5), SceneStyle::directive);
        QCOMPARE(styleAt(editor_.get(), 25 * 999 + 20), SceneStyle::comment);
        QVERIFY2(calls >= 1 && calls <= 5, qPrintable(QString::number(calls)));
    }

    void savingEndsAGroupOfChanges() {
        load("1");
        editor_->markNumbers({{0, 0, 1}});
        QVERIFY(editor_->replaceNumber(0, "2"));
        editor_->setModified(false);
        QVERIFY(editor_->replaceNumber(0, "3"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("2"));
        QVERIFY(!editor_->isModified());
    }

    void typingEndsAGroupOfChanges() {
        load("1");
        editor_->markNumbers({{0, 0, 1}});
        QVERIFY(editor_->replaceNumber(0, "2"));
        QTest::keyClick(editor_.get(), Qt::Key_End, Qt::ControlModifier);
        type(editor_.get(), ";");
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("2"));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("1"));
        editor_->redo();
        editor_->redo();
        QCOMPARE(editor_->sceneText(), QString("2;"));
    }

    void aNumberThatWasTouchedIsNoLongerBound() {
        load("R=1;");
        editor_->markNumbers({{0, 2, 3}});
        QVERIFY(editor_->numberRange(0));
        setCaret(3);
        type(editor_.get(), "2");
        QVERIFY(!editor_->numberRange(0));
        QVERIFY(!editor_->replaceNumber(0, "5"));
        QCOMPARE(editor_->sceneText(), QString("R=12;"));
    }

    void marksAreRefilledAfterARewrite() {
        load("R=1;");
        editor_->markNumbers({{0, 2, 3}});
        QVERIFY(editor_->replaceNumber(0, "0.125"));
        for (const long at : {2L, 6L})
            QVERIFY(editor_->SendScintilla(Sci::SCI_INDICATORVALUEAT, NumberMarks::indicator, at) != 0);
        QCOMPARE(editor_->SendScintilla(Sci::SCI_INDICATORVALUEAT, NumberMarks::indicator, 7L), 0L);
    }

    void altWheelScrubsAsOneStep() {
        load(wide + "threshold 0.49 // 5");
        editor_->markNumbers({rangeOf(*editor_, "0.49")});
        QSignalSpy scrubbed(editor_.get(), &SceneEditor::numberScrubbed),
            finished(editor_.get(), &SceneEditor::scrubFinished);
        const QPoint number = pointAt(*editor_, rangeOf(*editor_, "0.49").begin + 1);
        for (int i = 0; i < 3; ++i) QVERIFY(wheel(editor_->viewport(), number, 1, Qt::AltModifier));
        QCOMPARE(editor_->sceneText(), wide + "threshold 0.52 // 5");  // by hundredths, across 0.50
        QCOMPARE(scrubbed.count(), 3);
        QCOMPARE(scrubbed[0][0].toInt(), 0);
        QCOMPARE(scrubbed[0][1].toDouble(), 0.5);
        QTRY_COMPARE(finished.count(), 1);
        editor_->undo();
        QCOMPARE(editor_->sceneText(), wide + "threshold 0.49 // 5");
        QVERIFY(!editor_->isUndoAvailable());
    }

    void scrubbingLeavesCommentsAlone() {
        load("x // 5");
        wheel(editor_->viewport(), pointAt(*editor_, 5), 1, Qt::AltModifier);
        QCOMPARE(editor_->sceneText(), QString("x // 5"));
    }

    void altDragScrubsAcrossZero() {
        load("f(1,2)");
        QSignalSpy scrubbed(editor_.get(), &SceneEditor::numberScrubbed),
            finished(editor_.get(), &SceneEditor::scrubFinished);
        const QPoint from = pointAt(*editor_, 2);
        QTest::mousePress(editor_->viewport(), Qt::LeftButton, Qt::AltModifier, from);
        QVERIFY(editor_->isDragging());
        for (int x = -2; x >= -20; x -= 2) {
            const QPoint at = from + QPoint(x, 0);
            QMouseEvent move(QEvent::MouseMove, at, editor_->viewport()->mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, Qt::AltModifier);
            QCoreApplication::sendEvent(editor_->viewport(), &move);
        }
        QTest::mouseRelease(editor_->viewport(), Qt::LeftButton, Qt::AltModifier, from);
        QCOMPARE(editor_->sceneText(), QString("f(-4,2)"));
        QCOMPARE(scrubbed.last()[0].toInt(), -1);
        QCOMPARE(finished.count(), 1);
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("f(1,2)"));
    }

    void diagnosticsAreMarkedWhereTheyAre() {
        load(wide + "sphere { bad }");
        SourceLibrary sources;
        sources.add("scene.pov", editor_->utf8());
        const SourceRange bad = rangeOf(*editor_, "bad");
        editor_->setDiagnostics(
            {{Severity::error, "unknown-name", bad, "`bad` is not known", "declare it <first>", {}},
             {Severity::warning, "elsewhere", {1, 0, 1}, "in an include", "", {}}},
            sources);
        const auto valueAt = [this](Severity severity, long at) {
            return editor_->SendScintilla(Sci::SCI_INDICATORVALUEAT, DiagnosticMarks::indicator(severity),
                                          at);
        };
        QVERIFY(valueAt(Severity::error, bad.begin) != 0);
        QVERIFY(valueAt(Severity::error, bad.end - 1) != 0);
        QCOMPARE(valueAt(Severity::error, bad.begin - 1), 0L);
        QCOMPARE(valueAt(Severity::error, bad.end), 0L);
        QCOMPARE(editor_->markersAtLine(1), 1u << DiagnosticMarks::marker(Severity::error));
        QCOMPARE(editor_->markersAtLine(0), 0u);
        editor_->setDiagnostics({}, sources);
        QCOMPARE(valueAt(Severity::error, bad.begin), 0L);
        QCOMPARE(editor_->markersAtLine(1), 0u);
    }

    /// A bug once: the sign of a mistake stayed beside a text that was deleted as a whole.
    void noMarkIsLeftBesideAnEmptyText() {
        load("sphere { bad }");
        SourceLibrary sources;
        sources.add("scene.pov", editor_->utf8());
        const SourceRange bad = rangeOf(*editor_, "bad");
        editor_->setDiagnostics({{Severity::error, "unknown-name", bad, "`bad` is not known", "", {}},
                                 {Severity::leftOut, "left-out", bad, "`bad` is left out", "", {}}},
                                sources);
        QVERIFY(editor_->markersAtLine(0) != 0u);
        editor_->selectAll();
        editor_->removeSelectedText();
        QCOMPARE(editor_->utf8(), std::string());
        editor_->resize(400, 300);
        editor_->show();
        QVERIFY(QTest::qWaitForWindowExposed(editor_.get()));
        QCoreApplication::processEvents();
        PaintedRegion painted(editor_->viewport());
        editor_->setDiagnostics({}, sources);
        QCOMPARE(editor_->markersAtLine(0), 0u);
        QTRY_VERIFY(painted.region.contains(QPoint(0, 0)));
    }

    void missingTextIsMarkedBeforeTheGap_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("begin");
        QTest::addColumn<int>("end");
        QTest::addColumn<int>("marked");
        QTest::newRow("end of text") << QByteArray("sphere {\n") << 9 << 9 << 7;
        QTest::newRow("far behind the end") << QByteArray("sphere {") << 900 << 950 << 7;
        QTest::newRow("end of line") << QByteArray("ab\ncd") << 2 << 2 << 1;
        QTest::newRow("wide character") << QByteArray("\xe6\xbc\xa2") << 1 << 2 << 0;
        QTest::newRow("within a word") << QByteArray("abc") << 1 << 1 << 1;
    }
    void missingTextIsMarkedBeforeTheGap() {
        QFETCH(QByteArray, text);
        QFETCH(int, begin);
        QFETCH(int, end);
        QFETCH(int, marked);
        load(QString::fromUtf8(text));
        SourceLibrary sources;
        const SourceRange range{0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        editor_->setDiagnostics({{Severity::error, "x", range, "m", "", {}}}, sources);
        QVERIFY(editor_->SendScintilla(Sci::SCI_INDICATORVALUEAT, DiagnosticMarks::indicator(Severity::error),
                                       marked));
    }

    void diagnosticsOfAnEmptyTextDoNoHarm() {
        load("");
        editor_->setDiagnostics({{Severity::error, "empty", {0, 0, 0}, "nothing", "", {}}}, {});
        QCOMPARE(editor_->sceneText(), QString());
    }

    void jumpSelectsAndScrolls() {
        load(longText());
        const SourceRange range = rangeOf(*editor_, "line 1500");
        editor_->jumpTo(range);
        QCOMPARE(editor_->selectedText(), QString("line 1500"));
        const long line =
            editor_->SendScintilla(Sci::SCI_LINEFROMPOSITION, static_cast<unsigned long>(range.begin));
        const long top = editor_->SendScintilla(Sci::SCI_GETFIRSTVISIBLELINE);
        QVERIFY(line >= top && line < top + editor_->SendScintilla(Sci::SCI_LINESONSCREEN));
        editor_->jumpTo({0, 4'000'000, 4'000'001});
        editor_->jumpTo({3, 0, 1});
    }

    void commentsToggle() {
        const QString text = "  a\n\n    b\nc\n";
        load(text);
        editor_->SendScintilla(Sci::SCI_SETSEL, 0UL, 11L);
        editor_->toggleComment();
        QCOMPARE(editor_->sceneText(), QString("  // a\n\n  //   b\nc\n"));
        editor_->toggleComment();
        QCOMPARE(editor_->sceneText(), text);
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("  // a\n\n  //   b\nc\n"));
    }

    void replacesManyInOneStep() {
        load("a b a");
        editor_->replaceText({{0, 1, "xyz"}, {4, 5, ""}});
        QCOMPARE(editor_->sceneText(), QString("xyz b "));
        editor_->undo();
        QCOMPARE(editor_->sceneText(), QString("a b a"));
    }

    void offersNamesWhileTyping() {
        editor_->setNames({"MyRadius", "MyRadial"});
        type(editor_.get(), "My");
        QTRY_VERIFY(editor_->isListActive());
        QTest::keyClick(editor_.get(), Qt::Key_Tab);
        QCOMPARE(editor_->sceneText(), QString("MyRadial"));
    }

    void enterIsANewLineUnlessTheListWasWalked() {
        editor_->setNames({"MyRadius", "MyRadial"});
        type(editor_.get(), "My");
        QTRY_VERIFY(editor_->isListActive());
        QTest::keyClick(editor_.get(), Qt::Key_Return);
        QCOMPARE(editor_->sceneText(), QString("My\n"));
        type(editor_.get(), "My");
        QTRY_VERIFY(editor_->isListActive());
        QTest::keyClick(editor_.get(), Qt::Key_Down);
        QTest::keyClick(editor_.get(), Qt::Key_Return);
        QCOMPARE(editor_->sceneText(), QString("My\nMyRadius"));
    }

    void offersNamesInsideACall() {
        editor_->setNames({"MyRadius"});
        type(editor_.get(), "sin(");
        QVERIFY(editor_->isCallTipActive());
        type(editor_.get(), "My");
        QTRY_VERIFY(editor_->isListActive());
    }

    /// A bug once: it stayed over the text when the call was undone, or all was deleted.
    void aCallTipEndsWithItsCall() {
        type(editor_.get(), "x");
        type(editor_.get(), "+floor(");
        QVERIFY(editor_->isCallTipActive());
        editor_->undo();
        QVERIFY(editor_->sceneText().isEmpty());
        QVERIFY(!editor_->isCallTipActive());
        type(editor_.get(), "x+floor(y ");
        QVERIFY(editor_->isCallTipActive());
        editor_->selectAll();
        editor_->removeSelectedText();
        QVERIFY(!editor_->isCallTipActive());
    }

    /// A bug once: the list stayed over the text when all of that was selected, and deleted.
    void selectingEndsTheList() {
        editor_->setNames({"MyRadius", "MyRadial"});
        type(editor_.get(), "My");
        QTRY_VERIFY(editor_->isListActive());
        editor_->selectAll();
        QTRY_VERIFY(!editor_->isListActive());
    }

    void offersNothingInComments() {
        editor_->setNames({"MyRadius"});
        type(editor_.get(), "// My");
        QTest::qWait(50);
        QVERIFY(!editor_->isListActive());
    }

    void coloursLongTextsFast() {
        load(longText());
        QElapsedTimer clock;
        clock.start();
        editor_->jumpTo(rangeOf(*editor_, "line 2000"));
        editor_->repaint();
        qInfo("%lld ms", clock.elapsed());
        QCOMPARE(styleAt(editor_.get(), rangeOf(*editor_, "sphere").begin), SceneStyle::keyword);
    }

    void commentsColourTheLinesBelow() {
        load("a\nsphere\n");
        QCOMPARE(styleAt(editor_.get(), 2), SceneStyle::keyword);
        setCaret(0);
        type(editor_.get(), "/*");
        QCOMPARE(styleAt(editor_.get(), 4), SceneStyle::comment);
    }

    void coloursHaveContrast() {
        const auto luminance = [](const QColor& color) {
            const auto linear = [](double c) {
                return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            };
            return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
                   0.0722 * linear(color.blueF());
        };
        for (const Look look : {Look::light, Look::dark})
            for (int i = 0; i < static_cast<int>(SceneStyle::count); ++i) {
                const double a = luminance(SceneLexer::textColor(static_cast<SceneStyle>(i), look));
                const double b = luminance(SceneLexer::paperColor(look));
                const double contrast = (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
                QVERIFY2(
                    contrast >= 4.5,
                    qPrintable(
                        QString("style %1, look %2: %3").arg(i).arg(static_cast<int>(look)).arg(contrast)));
            }
    }

    void themesRecolour() {
        load("sphere { 0, 1 }\n");
        editor_->applyTheme(Look::dark);
        QCOMPARE(editor_->grab().toImage().pixelColor(500, 300), SceneLexer::paperColor(Look::dark));
        editor_->applyTheme(Look::light);
        QCOMPARE(editor_->grab().toImage().pixelColor(500, 300), SceneLexer::paperColor(Look::light));
    }

    void theBraceAtTheCaretAndItsPartnerAreMarked() {
        const QByteArray text = "union { /* } */ sphere { <0, 0, 0>, (1 + 2) } } }\n";
        load(QString::fromUtf8(text));
        editor_->applyTheme(Look::light);
        // The characters that have this ground.
        const auto marked = [&](const QColor& ground) {
            const QImage image = editor_->grab().toImage();
            QList<int> found;
            for (int i = 0; i < text.size() - 1; ++i) {
                const QPoint at = editor_->viewport()->mapTo(editor_.get(), pointAt(*editor_, i));
                for (int y = 0; y < editor_->textHeight(0) && (found.isEmpty() || found.last() != i); ++y)
                    if (image.pixelColor(at.x(), at.y() - 4 + y) == ground) found << i;
            }
            return found;
        };
        const EditorGrounds& grounds = editorGrounds(Look::light);
        const int outer = static_cast<int>(text.indexOf('{')), inner = static_cast<int>(text.indexOf('(')),
                  last = static_cast<int>(text.lastIndexOf('}'));
        setCaret(outer);
        QTRY_COMPARE(marked(grounds.brace), QList<int>({outer, last - 2}));  // not that of the comment
        setCaret(inner);
        QTRY_COMPARE(marked(grounds.brace), QList<int>({inner, static_cast<int>(text.indexOf(')'))}));
        setCaret(last);
        QTRY_COMPARE(marked(grounds.loneBrace), QList<int>({last}));
        setCaret(2);
        QTRY_VERIFY(marked(grounds.brace).isEmpty() && marked(grounds.loneBrace).isEmpty());
    }

    void wheelZoomsWithControl() {
        load("x");
        const int before = editor_->textHeight(0);
        wheel(editor_->viewport(), {100, 100}, 3, Qt::ControlModifier);
        QVERIFY(editor_->textHeight(0) > before);
        editor_->resetZoom();
        QCOMPARE(editor_->textHeight(0), before);
    }

    void tellsCaretInCharacters() {
        load(QString::fromUtf8("\xf0\x9f\x98\x80x"));
        QSignalSpy moved(editor_.get(), &SceneEditor::caretMoved);
        setCaret(5);
        QTRY_VERIFY(!moved.isEmpty());
        QCOMPARE(moved.last()[0].toInt(), 1);
        QCOMPARE(moved.last()[1].toInt(), 3);
    }
};

QTEST_MAIN(SceneEditorTest)
#include "scene_editor_test.moc"
