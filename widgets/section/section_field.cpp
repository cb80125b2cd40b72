// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_field.h"

#include <cmath>
#include <string>

#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope {

QString sectionTable(const SectionField& field) {
    std::vector<std::string> names{"x", "y", "z", "value"};
    if (!field.slopes.empty()) names.emplace_back("gradient");
    if (!field.distances.empty()) names.emplace_back("distance");
    std::string text = csvLine(names);
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (!field.contained[i]) continue;
        const auto column = static_cast<double>(i % static_cast<std::size_t>(field.columns)),
                   row = static_cast<double>(i / static_cast<std::size_t>(field.columns));
        const glm::dvec3 p =
            field.plane.at(field.left + (field.right - field.left) * column / (field.columns - 1),
                           field.bottom + (field.top - field.bottom) * row / (field.rows - 1));
        std::vector<std::string> fields{exactNumber(p.x), exactNumber(p.y), exactNumber(p.z),
                                        exactNumber(static_cast<double>(field.values[i]))};
        for (const std::vector<float>* more : {&field.slopes, &field.distances})
            if (!more->empty()) fields.push_back(exactNumber(static_cast<double>((*more)[i])));
        text += csvLine(fields);
    }
    return QString::fromStdString(text);
}

SectionAxisNames axisNames(const SectionPlane& plane) {
    switch (plane.axis()) {
        case 0: return {QStringLiteral("z"), QStringLiteral("y")};
        case 1: return {QStringLiteral("x"), QStringLiteral("z")};
        case 2: return {QStringLiteral("x"), QStringLiteral("y")};
        default: return {QStringLiteral("u"), QStringLiteral("v")};
    }
}

double roundedUp(double value) {
    if (!(value > 0) || !std::isfinite(value)) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    // Without some slack 0.2 / 0.1 rounds up to 5.
    const double digit = value / power * (1 - 1e-9);
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

}  // namespace isoscope
