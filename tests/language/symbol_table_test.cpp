// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/symbol_table.h"

#include <QTest>
#include <map>
#include <set>

using namespace isoscope;

namespace {

Value number(double value) { return {NumberValue{value}}; }

double valueOf(const SymbolTable& symbols, std::string_view name) {
    const Value* value = symbols.find(name);
    return value ? std::get<NumberValue>(value->data).value : -999;
}

}  // namespace

class SymbolTableTest : public QObject {
    Q_OBJECT

  private slots:
    void declareMakesAGlobalName() {
        SymbolTable symbols;
        symbols.pushScope();
        symbols.declare("A", number(1));
        symbols.popScope();
        QCOMPARE(valueOf(symbols, "A"), 1.0);
    }

    void localsHideAndVanish() {
        SymbolTable symbols;
        symbols.declare("A", number(1));
        symbols.pushScope();
        symbols.declareLocal("A", number(2));
        QCOMPARE(valueOf(symbols, "A"), 2.0);
        symbols.popScope();
        QCOMPARE(valueOf(symbols, "A"), 1.0);
    }

    void declareChangesTheInnermostName() {
        SymbolTable symbols;
        symbols.pushScope();
        symbols.declareLocal("A", number(1));
        symbols.pushScope();
        symbols.declare("A", number(2));
        symbols.popScope();
        QCOMPARE(valueOf(symbols, "A"), 2.0);
        symbols.popScope();
        QVERIFY(!symbols.find("A"));
    }

    void aDirectiveBelongsToTheScopeInWhichItBegan() {
        SymbolTable symbols;
        symbols.pushScope();
        const std::size_t begun = symbols.scopeCount();
        symbols.pushScope();
        symbols.declareLocal("A", number(1));
        symbols.declareLocal("A", number(2), begun);
        QCOMPARE(valueOf(symbols, "A"), 1.0);
        symbols.popScope();
        QCOMPARE(valueOf(symbols, "A"), 2.0);
    }

    void referencesWriteThrough() {
        SymbolTable symbols;
        symbols.declare("A", number(1));
        symbols.pushScope();
        QVERIFY(symbols.declareReference("P", "A"));
        symbols.pushScope();
        QVERIFY(symbols.declareReference("P", "P"));
        symbols.declareLocal("P", number(5));
        symbols.popScope();
        symbols.popScope();
        QCOMPARE(valueOf(symbols, "A"), 5.0);
        QVERIFY(!symbols.find("P"));
    }

    void referencesToUnknownNamesAreRefused() {
        SymbolTable symbols;
        symbols.pushScope();
        QVERIFY(!symbols.declareReference("P", "Nothing"));
        QVERIFY(!symbols.find("P"));
    }

    void referencesToElementsWriteThrough() {
        auto array = std::make_shared<ArrayValue>();
        array->dimensions = {2};
        array->elements.resize(2);
        SymbolTable symbols;
        symbols.pushScope();
        symbols.declareReference("P", array, 1);
        QVERIFY(!symbols.find("P"));
        symbols.declare("P", number(3));
        QCOMPARE(std::get<NumberValue>(array->elements[1].data).value, 3.0);
    }

    void undefiningWhatARunningMacroRefersToIsSafe() {
        SymbolTable symbols;
        symbols.declare("A", number(1));
        symbols.pushScope();
        symbols.declareReference("P", "A");
        QVERIFY(symbols.undefine("A"));
        QVERIFY(!symbols.find("A"));
        QVERIFY(!symbols.find("P"));
        symbols.declare("P", number(7));
        symbols.popScope();
        QCOMPARE(valueOf(symbols, "A"), 7.0);
    }

    void undefineTellsWhetherThereWasOne() {
        SymbolTable symbols;
        symbols.declare("A", number(1));
        QVERIFY(symbols.undefine("A"));
        QVERIFY(!symbols.undefine("A"));
    }

    void namesAreSortedAndVisible() {
        SymbolTable symbols;
        symbols.declare("B", number(1));
        symbols.declare("C", number(1));
        symbols.pushScope();
        symbols.declareLocal("A", number(1));
        symbols.declareLocal("B", number(1));
        symbols.undefine("C");
        QCOMPARE(symbols.names(), (std::vector<std::string>{"A", "B"}));
    }

    void visitsEveryNameThatHasAValue() {
        SymbolTable symbols;
        symbols.declare("A", number(1));
        symbols.declare("B", number(1));
        symbols.undefine("B");
        symbols.pushScope();
        symbols.declareLocal("C", number(1));
        symbols.declareReference("R", "A");
        std::multiset<std::string> names;
        symbols.forEach([&](const std::string& name, const Value& value) {
            QVERIFY(std::holds_alternative<NumberValue>(value.data));
            names.insert(name);
        });
        QCOMPARE(names, (std::multiset<std::string>{"A", "C", "R"}));
    }

    void theGlobalScopeStays() {
        SymbolTable symbols;
        symbols.popScope();
        QCOMPARE(symbols.scopeCount(), std::size_t(1));
    }

    void findsCloseNames_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("close");
        QTest::newRow("one letter wrong") << "f_tarus"
                                          << "f_torus";
        QTest::newRow("one letter missing") << "f_trus"
                                            << "f_torus";
        QTest::newRow("neighbours swapped") << "Raduis"
                                            << "Radius";
        QTest::newRow("end missing, not f_r") << "f_tor"
                                              << "f_torus";
        QTest::newRow("other case") << "radius"
                                    << "Radius";
        QTest::newRow("short") << "Rd"
                               << "Red";
        QTest::newRow("too far") << "Elephant"
                                 << "";
        QTest::newRow("one letter") << "q"
                                    << "";
        QTest::newRow("empty") << ""
                               << "";
    }

    void findsCloseNames() {
        QFETCH(QString, name);
        QFETCH(QString, close);
        const std::vector<std::string> candidates{"Red", "Radius", "f_r", "f_torus", "f_sphere"};
        QCOMPARE(QString::fromStdString(closestName(name.toStdString(), candidates)), close);
    }

    void namesOfAnyLengthAreCompared() {
        for (const std::size_t length : {63, 64, 65, 67, 68, 5000}) {
            const std::string name(length, 'a');
            QCOMPARE(closestName("aaaa", {name}), std::string());
            QCOMPARE(closestName(name, {"aaaa"}), std::string());
        }
        const std::string longest(64, 'a');
        QCOMPARE(closestName(longest, {longest + 'b'}), longest + 'b');
    }

    /// Letters that have changed places are one edit, wherever they stand; another case is half of one.
    void theNearestNameIsChosen() {
        const auto closest = [](const std::string& name, const std::vector<std::string>& candidates) {
            return closestName(name, candidates);
        };
        QCOMPARE(closest("Lenght", {"lenghs", "Length"}), std::string("Length"));
        QCOMPARE(closest("eLngth", {"elngts", "Length"}), std::string("Length"));
        QCOMPARE(closest("Legnth", {"legnts", "Length"}), std::string("Length"));
    }

    void distancesAreInHalfEdits() {
        const std::map<std::string, int> distances{{"phere", 2},    {"xsphere", 2}, {"spheer", 2},
                                                   {"Sphere", 1},   {"SPHERE", 1},  {"Shpere", 3},
                                                   {"sphereex", 4}, {"sphere2a", 4}};
        for (const auto& [name, expected] : distances) {
            int distance = 0;
            QCOMPARE(closestName(name, {"sphere"}, &distance), std::string("sphere"));
            QVERIFY2(distance == expected, (name + ' ' + std::to_string(distance)).c_str());
        }
    }
};

QTEST_APPLESS_MAIN(SymbolTableTest)
#include "symbol_table_test.moc"
