// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/varied_number.h"

namespace isoscope::cli {

class Command;

/// A number of the scene and the values that a command gives it: `--parameter NAME --from A --to B --steps
/// N`.
struct ValueRange {
    std::string name;
    int line = 0;  ///< of the number, where several are called so
    std::optional<double> from, to;
    int steps = 9;

    /// Adds the options; `prefix` is "" (and the name is required), or "second" for `--second`,
    /// `--second-from`...
    void addTo(Command& command, const std::string& prefix);
    /// The number with its values.
    struct Found {
        std::size_t parameter = 0;
        std::vector<double> values;
    };
    /// Nothing, with a message on standard error, where there is no such number. Without ends those of its
    /// slider are taken.
    std::optional<Found> find(const ParseResult& parsed, const std::string& file) const;
};

}  // namespace isoscope::cli
