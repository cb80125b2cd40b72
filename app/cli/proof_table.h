// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "app/cli/table_row.h"
#include "core/roots/certified/proof_recorder.h"

namespace isoscope::cli {

/// What `roots --proof` writes: a row for each step along each ray, for others to check. Behind `case_id` the
/// columns are those of ProofStep, t along the direction of the ray table.
class ProofTable {
  public:
    ProofTable();

    /// Adds the steps of the row `id`.
    void add(const std::string& id, const ScaledDirection& direction, std::span<const ProofStep> steps);
    /// The whole table as CSV, with its header.
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

}  // namespace isoscope::cli
