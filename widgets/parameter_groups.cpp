// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameter_groups.h"

#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/function/builtin.h"

namespace isoscope {
namespace {

/// The calls of one name, as far as they have been read.
class CallCounter {
  public:
    explicit CallCounter(const std::string& group)
        : builtin_(findBuiltin(group)), splits_(group != "#declare") {}

    /// `statement` counts the statements of the text as far as they can be told apart.
    int callOf(const std::string& name, int statement) {
        if (!splits_) return 0;
        const bool sameStatement = builtin_ || names_.empty() || statement == statement_;
        statement_ = statement;
        const bool fits = builtin_ ? advance(name) : names_.insert(name).second;
        if (fits && sameStatement) return call_;
        ++call_;
        next_ = 0;
        names_ = {name};
        if (builtin_) advance(name);
        return call_;
    }

  private:
    /// Goes on to the next parameter of that name; false when the list has none any more. Names may repeat in
    /// one list ("Not Used"), so that the place counts and not the name.
    bool advance(const std::string& name) {
        for (std::size_t i = next_; i < builtin_->parameters.size(); ++i) {
            if (builtin_->parameters[i].name != name) continue;
            next_ = i + 1;
            return true;
        }
        return false;
    }

    const Builtin* builtin_;
    bool splits_;
    int call_ = 0;
    int statement_ = 0;
    std::size_t next_ = 0;
    std::set<std::string> names_;
};

}  // namespace

std::vector<ParameterPlace> parameterPlaces(const std::vector<SceneParameter>& parameters) {
    std::map<std::string, CallCounter> counters;
    std::map<QString, int> seen;
    std::vector<ParameterPlace> places;
    places.reserve(parameters.size());
    int statement = 0;
    bool settingsSeen = false;
    for (const SceneParameter& parameter : parameters) {
        auto& counter = counters.try_emplace(parameter.group, parameter.group).first->second;
        ParameterPlace place;
        place.group = QString::fromStdString(parameter.group);
        const bool argument = parameter.role == ParameterRole::argument;
        if (argument && std::exchange(settingsSeen, false)) ++statement;
        settingsSeen = settingsSeen || !argument;
        place.call = counter.callOf(parameter.name, statement);
        const QString name = QString("%1\n%2\n%3")
                                 .arg(place.group)
                                 .arg(place.call)
                                 .arg(QString::fromStdString(parameter.name));
        place.key = QString("%1\n%2").arg(name).arg(seen[name]++);
        places.push_back(std::move(place));
    }
    return places;
}

}  // namespace isoscope
