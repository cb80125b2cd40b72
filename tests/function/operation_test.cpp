// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/operation.h"

#include <QTest>
#include <algorithm>
#include <set>

using namespace isoscope;

class OperationTest : public QObject {
    Q_OBJECT

  private slots:
    /// A row in the wrong place would give an operation the name of its neighbour.
    void rowsStandInTheOrderOfTheEnumeration() {
        QCOMPARE(name(Operation::parameter), "parameter");
        QCOMPARE(name(Operation::negate), "negate");
        QCOMPARE(name(Operation::decimalLogarithm), "log");
        QCOMPARE(name(Operation::areaTangent), "atanh");
        QCOMPARE(name(Operation::truncate), "int");
        QCOMPARE(name(Operation::add), "add");
        QCOMPARE(name(Operation::integerDivide), "div");
        QCOMPARE(name(Operation::logicalOr), "or");
        QCOMPARE(name(Operation::select4), "select4");
        QCOMPARE(name(Operation::noiseGradientZ), "noise-z");
        QCOMPARE(name(Operation::product), "prod");
    }

    void namesDiffer() {
        std::set<std::string_view> names;
        for (const OperationFacts& facts : operationTable)
            QVERIFY2(names.insert(facts.name).second, facts.name.data());
    }

    void callsHaveTheArgumentsOfTheirForm() {
        std::set<std::string_view> words;
        for (const OperationFacts& facts : operationTable) {
            if (facts.form == CallForm::none) continue;
            QVERIFY2(words.insert(facts.word()).second, facts.name.data());
            QVERIFY2(facts.call.ends_with(")"), facts.name.data());
            if (facts.form == CallForm::plain || facts.form == CallForm::folded)
                QCOMPARE(std::ranges::count(facts.call, ',') + 1, facts.arity);
            QCOMPARE(facts.form == CallForm::loop, facts.arity < 0);
        }
        QCOMPARE(words.size(), 29U);
    }

    void textsNameTheirOperands() {
        for (const OperationFacts& facts : operationTable) {
            if (facts.text.empty()) continue;
            QVERIFY2(facts.call.empty() && facts.arity <= 2, facts.name.data());
            QVERIFY2(facts.text.find('#') != std::string_view::npos, facts.name.data());
            QCOMPARE(facts.text.find('@') != std::string_view::npos, facts.arity == 2);
        }
    }
};

QTEST_GUILESS_MAIN(OperationTest)
#include "operation_test.moc"
