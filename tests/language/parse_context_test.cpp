// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/parse_context.h"

#include <QTest>
#include <chrono>
#include <limits>
#include <thread>

using namespace isoscope;

class ParseContextTest : public QObject {
    Q_OBJECT

  private slots:
    /// `--declare NAME=VALUE` of the command line had no effect.
    void declarationsFromOutsideAreInForce() {
        ParseOptions options;
        options.declarations["Size"] = 0.5;
        const ParseContext context(options);
        const Value* value = context.symbols.find("Size");
        QVERIFY(value != nullptr);
        QCOMPARE(std::get<NumberValue>(value->data).value, 0.5);
        QCOMPARE(std::get<NumberValue>(value->data).parameter, -1);
    }

    /// Their characters are kept whole, and these bytes begin none.
    void messagesOfNoCharactersAreShortened() {
        ParseContext context{ParseOptions{}};
        context.error("a", {0, 0, 1}, std::string(3000, '\x80'));
        QCOMPARE(context.diagnostics.at(0).message, std::string(" ... "));
    }

    void theTimeOfATextEndsByItself() {
        const ReadingLimits limits({}, 0, std::numeric_limits<std::size_t>::max());
        for (int k = 0; k < 5000 && !limits.token().stop_requested(); ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        QVERIFY(limits.token().stop_requested());
        QVERIFY(limits.reason() == ReadingLimits::Reason::time);
    }

    void dropsRepeatedMessages() {
        ParseContext context{ParseOptions{}};
        context.error("a", {0, 1, 2}, "text");
        context.error("a", {0, 1, 2}, "text");
        context.error("a", {0, 1, 2}, "other text");
        context.error("a", {0, 3, 4}, "text");
        QCOMPARE(context.diagnostics.size(), std::size_t(3));
    }

    void countsMessagesBeyondTheLimit() {
        ParseOptions options;
        options.diagnosticLimit = 3;
        ParseContext context(options);
        for (std::uint32_t k = 0; k < 10; ++k) context.warning("a", {0, k, k}, "text");
        QCOMPARE(context.diagnostics.size(), std::size_t(4));
        QCOMPARE(context.diagnostics.back().message, std::string("7 further messages are not shown."));
        QVERIFY(context.diagnostics.back().severity == Severity::note);
        QVERIFY(!hasErrors(context.diagnostics));
    }

    void anErrorNeverHidesBehindTheLimit() {
        ParseOptions options;
        options.diagnosticLimit = 2;
        ParseContext context(options);
        for (std::uint32_t k = 0; k < 5; ++k) context.warning("a", {0, k, k}, "text");
        context.error("e", {0, 9, 9}, "first error");
        context.error("e", {0, 10, 10}, "second error");
        QVERIFY(hasErrors(context.diagnostics));
        QCOMPARE(context.diagnostics.size(), std::size_t(4));
        QCOMPARE(context.diagnostics[2].message, std::string("first error"));
        QCOMPARE(context.diagnostics.back().message, std::string("4 further messages are not shown."));
    }

    void anErrorMayBeTheFirstBehindTheLimit() {
        ParseOptions options;
        options.diagnosticLimit = 1;
        ParseContext context(options);
        context.warning("a", {0, 0, 0}, "text");
        context.error("e", {0, 1, 1}, "error");
        QVERIFY(hasErrors(context.diagnostics));
    }

    void saysNothingMoreAfterACut() {
        ParseContext context{ParseOptions{}};
        context.error("a", {0, 0, 1}, "cut");
        context.complete = false;
        context.error("b", {0, 1, 2}, "consequence");
        context.note("c", {0, 1, 2}, "note");
        QCOMPARE(context.diagnostics.size(), std::size_t(2));
        QVERIFY(context.diagnostics[1].severity == Severity::note);
    }

    void shortensLongChainsOfCalls() {
        ParseContext context{ParseOptions{}};
        for (std::uint32_t k = 0; k < 100; ++k) context.enterCall({0, k, k + 1}, {0, 0, 1000});
        context.error("a", {0, 500, 501}, "deep");
        const std::vector<SourceRange>& sites = context.diagnostics.at(0).reachedFrom;
        QCOMPARE(sites.size(), std::size_t(16));
        QCOMPARE(sites.front().begin, 99u);
        QCOMPARE(sites.back().begin, 0u);
    }

    void aPlaceOutsideTheCallIsNotReachedThroughIt() {
        ParseContext context{ParseOptions{}};
        context.enterCall({0, 90, 95}, {0, 10, 20});
        for (const SourceRange& outside : {SourceRange{0, 50, 51}, {0, 5, 6}, {0, 15, 21}, {1, 15, 16}}) {
            context.error("a", outside, "outside");
            QVERIFY(context.diagnostics.back().reachedFrom.empty());
        }
        context.error("a", {0, 15, 16}, "inside");
        QCOMPARE(context.diagnostics.back().reachedFrom.size(), std::size_t(1));
    }

    void namesWhatIsLeftOut() {
        ParseContext context{ParseOptions{}};
        context.leftOut({0, 0, 1}, "radiosity");
        QVERIFY(context.diagnostics.at(0).severity == Severity::leftOut);
        QCOMPARE(context.diagnostics[0].message, std::string("`radiosity` is not simulated."));
    }

    void givesParametersSlots() {
        ParseContext context{ParseOptions{}};
        SceneParameter parameter;
        parameter.value = 5;
        QCOMPARE(context.addParameter(parameter), 0);
        parameter.value = 6;
        QCOMPARE(context.addParameter(parameter), 1);
        context.markStructural(0);
        context.markStructural(-1);
        context.markStructural(2);
        context.markStructural(99);
        QCOMPARE(context.parameters[0].slot, -1);
        QCOMPARE(context.parameters[1].slot, 1);
        QCOMPARE(context.parameterTable, (std::vector<double>{5, 6}));
    }
};

QTEST_APPLESS_MAIN(ParseContextTest)
#include "parse_context_test.moc"
