// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameter_groups.h"

#include <QSet>
#include <QTest>

using namespace isoscope;

namespace {

std::vector<SceneParameter> make(std::initializer_list<std::pair<const char*, const char*>> groupsAndNames) {
    std::vector<SceneParameter> parameters;
    for (const auto& [group, name] : groupsAndNames) {
        SceneParameter parameter;
        parameter.group = group;
        parameter.name = name;
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
    void callsOfOneFunctionAreTold() {
        QCOMPARE(calls(make({{"f_torus", "Major Radius"},
                             {"f_torus", "Minor Radius"},
                             {"f_torus", "Major Radius"},
                             {"f_torus", "Minor Radius"}})),
                 (QList<int>{0, 0, 1, 1}));
    }

    void namesMayRepeatInOneCall() {
        // f_helix2 has two parameters called "Not Used".
        const auto one = make({{"f_helix2", "Not Used"}, {"f_helix2", "Period"}, {"f_helix2", "Not Used"}});
        QCOMPARE(calls(one), (QList<int>{0, 0, 0}));
        auto two = one;
        two.insert(two.end(), one.begin(), one.end());
        QCOMPARE(calls(two), (QList<int>{0, 0, 0, 1, 1, 1}));
    }

    void statementsBeginAnewWithARepeatedName() {
        QCOMPARE(calls(make({{"isosurface", "threshold"},
                             {"isosurface", "max_gradient"},
                             {"contained_by", "radius"},
                             {"isosurface", "threshold"},
                             {"contained_by", "radius"}})),
                 (QList<int>{0, 0, 0, 1, 1}));
    }

    void argumentsBeginAnotherIsosurface() {
        auto parameters = make({{"f_torus", "Major Radius"},
                                {"contained_by", "first corner x"},
                                {"isosurface", "threshold"},
                                {"f_sphere", "Radius"},
                                {"contained_by", "radius"},
                                {"isosurface", "accuracy"}});
        parameters[0].role = parameters[3].role = ParameterRole::argument;
        QCOMPARE(calls(parameters), (QList<int>{0, 0, 0, 0, 1, 1}));
    }

    void declarationsStayTogether() {
        QCOMPARE(calls(make({{"#declare", "R"}, {"#declare", "S"}, {"#declare", "R"}})),
                 (QList<int>{0, 0, 0}));
    }

    void keysAreUnique() {
        const auto places = parameterPlaces(make({{"#declare", "R"},
                                                  {"#declare", "R"},
                                                  {"f_helix2", "Not Used"},
                                                  {"f_helix2", "Not Used"},
                                                  {"", ""},
                                                  {"", ""}}));
        QSet<QString> keys;
        for (const ParameterPlace& place : places) keys << place.key;
        QCOMPARE(keys.size(), 6);
    }
};

QTEST_APPLESS_MAIN(ParameterGroupsTest)
#include "parameter_groups_test.moc"
