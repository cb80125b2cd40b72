// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_groups.h"

#include <QSet>
#include <QTest>

using namespace isoscope;

namespace {

struct Entry {
    const char* group;
    const char* name;
    int statement;
};

std::vector<SceneParameter> make(std::initializer_list<Entry> entries) {
    std::vector<SceneParameter> parameters;
    for (const Entry& entry : entries) {
        SceneParameter parameter;
        parameter.group = entry.group;
        parameter.name = entry.name;
        parameter.statement = entry.statement;
        parameters.push_back(parameter);
    }
    return parameters;
}

QList<int> calls(const std::vector<SceneParameter>& parameters) {
    QList<int> result;
    for (const ParameterPlace& place : parameterPlaces(parameters)) result << place.call;
    return result;
}

}  // namespace

class ParameterGroupsTest : public QObject {
    Q_OBJECT

  private slots:
    void callsAreNumberedByTheirName() {
        QCOMPARE(calls(make({{"f_torus", "Major Radius", 3},
                             {"f_sphere", "Radius", 4},
                             {"f_torus", "Minor Radius", 3},
                             {"f_torus", "Major Radius", 7},
                             {"f_torus", "Minor Radius", 7}})),
                 (QList<int>{0, 0, 0, 1, 1}));
    }

    void declarationsStayTogether() {
        QCOMPARE(calls(make({{"#declare", "R", 0}, {"f_sphere", "Radius", 1}, {"#declare", "S", 0}})),
                 (QList<int>{0, 0, 0}));
    }

    /// D26: three pairs of the same names were one list.
    void namesDeclaredAgainBeginAGroup() {
        QCOMPARE(calls(make({{"#declare", "Ridges", 0},
                             {"#declare", "Depth", 0},
                             {"f_sphere", "Radius", 1},
                             {"#declare", "Ridges", 0},
                             {"#declare", "Depth", 0},
                             {"#declare", "Depth", 0}})),
                 (QList<int>{0, 0, 0, 1, 1, 2}));
    }

    void keysAreUnique() {
        const auto places = parameterPlaces(make({{"#declare", "R", 0},
                                                  {"#declare", "R", 0},
                                                  {"f_helix2", "Not Used", 1},
                                                  {"f_helix2", "Not Used", 1},
                                                  {"", "", 0},
                                                  {"", "", 0}}));
        QSet<QString> keys;
        for (const ParameterPlace& place : places) keys << place.key;
        QCOMPARE(keys.size(), 6);
    }
};

QTEST_APPLESS_MAIN(ParameterGroupsTest)
#include "parameter_groups_test.moc"
