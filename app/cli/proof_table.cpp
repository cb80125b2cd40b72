// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/proof_table.h"

#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

// core/exchange/output_guard.cpp knows such a table by its first columns.
ProofTable::ProofTable()
    : text_(
          csvLine({"case_id", "rule", "from", "to", "sign", "start", "length", "center", "slope", "error"})) {
}

void ProofTable::add(const std::string& id, const ScaledDirection& direction,
                     std::span<const ProofStep> steps) {
    const auto place = [&](double t) { return exactNumber(direction.tableT(t)); };
    for (const ProofStep& step : steps) {
        std::vector<std::string> cells{id, name(step.rule), place(step.from), place(step.to),
                                       std::to_string(step.sign)};
        if (step.rule == ProofRule::form)
            cells.insert(cells.end(), {place(step.start), place(step.length), exactNumber(step.center),
                                       exactNumber(step.slope), exactNumber(step.error)});
        else
            cells.resize(cells.size() + 5);
        text_ += csvLine(cells);
    }
}

}  // namespace isoscope::cli
