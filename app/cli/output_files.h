// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/exchange/output_guard.h"

namespace isoscope::cli {

class Command;

/// The files that a command writes: which ones it may replace, and whether it could.
struct OutputFiles {
    bool force = false;

    /// Adds `--force`.
    void addTo(Command& command);
    /// False, with a message on standard error, when `file` is not to be replaced by something of this kind:
    /// what stands there is none of ours and --force was not given, or it is the scene itself. An empty name
    /// is no file. To be asked before the work is done.
    bool mayWrite(const std::string& file, OutputKind kind, const std::string& scene) const;
};

/// Writes a file whole; false, with a message on standard error, when it cannot be, and then the old one
/// stays.
bool writeOutput(const std::string& file, const std::string& content);

/// False, with a message on standard error, when something of the standard output got lost.
bool finishStandardOutput();

}  // namespace isoscope::cli
