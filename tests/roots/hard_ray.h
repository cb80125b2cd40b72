// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"
#include "core/shapes/rays/line_interval.h"
#include "tests/support/csv_table.h"

namespace isoscope::test {

/// One row of hard/rays.csv and the answer to it; what is right is stated in hard/README.md.
class HardRay {
  public:
    HardRay(const isoscope::test::CsvTable& table, std::size_t row) : table_(table), row_(row) {
        line_.origin = {number("ox"), number("oy"), number("oz")};
        line_.direction = {number("dx"), number("dy"), number("dz")};
        const Ray ray{line_.origin, line_.direction};
        std::vector<double> ends;
        const QString container = text("container");
        static const QRegularExpression numbers("[-+]?[0-9.]+(e[-+]?[0-9]+)?");
        for (auto match = numbers.globalMatch(container); match.hasNext();)
            ends.push_back(match.next().captured().toDouble());
        const LineInterval inside =
            container.startsWith("box")
                ? boxInterval(ray, {ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]})
                : sphereInterval(ray, {ends[0], ends[1], ends[2]}, ends[3]);
        line_.near = std::max(inside.range.near, 0.0);
        line_.far = inside.range.far;
    }

    QString text(const char* column) const { return QString::fromStdString(table_.field(row_, column)); }
    double number(const char* column) const { return table_.number(row_, column); }
    const LineQuery& line() const { return line_; }

    RootSettings settings() const {
        RootSettings settings;
        settings.threshold = number("threshold");
        settings.accuracy = number("accuracy");
        settings.open = true;
        return settings;
    }

    /// Whether `t` (NaN for a miss) is right: the crossing that must be found, a place where a hit is
    /// admissible, a jump, or a miss where nothing must be found.
    bool admits(double t) const {
        if (std::isnan(t)) return text("expect") != "hit";
        const double slack = number("accuracy") / std::hypot(number("dx"), number("dy"), number("dz")) +
                             4 * (std::nextafter(t, INFINITY) - t);
        if (text("expect") == "hit" && number("must_lo") - slack <= t && t <= number("must_hi") + slack)
            return true;
        for (const QString& range : text("may").split(';', Qt::SkipEmptyParts)) {
            const QStringList ends = range.split("..");
            if (ends[0].toDouble() - slack <= t && t <= ends[1].toDouble() + slack) return true;
        }
        for (const QString& event : text("all_roots").split(';', Qt::SkipEmptyParts)) {
            const QStringList fields = event.split(':');
            if (fields[1] == "jump" && fields[3].toDouble() - slack <= t && t <= fields[4].toDouble() + slack)
                return true;
        }
        return false;
    }

    /// Whether t is no farther than `distance` from any event of the ray.
    bool isWithin(double t, double distance) const {
        for (const QString& event : text("all_roots").split(';', Qt::SkipEmptyParts)) {
            const QStringList fields = event.split(':');
            if (fields[3].toDouble() - distance <= t && t <= fields[4].toDouble() + distance) return true;
        }
        return false;
    }

  private:
    const isoscope::test::CsvTable& table_;
    std::size_t row_;
    LineQuery line_;
};

}  // namespace isoscope::test
