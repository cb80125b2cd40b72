// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output_files.h"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "app/cli/command_line.h"
#include "core/text/whole_file.h"

namespace isoscope::cli {

void OutputFiles::addTo(Command& command) {
    command.flag("--force", force,
                 "Replace a file that stands where the output goes, even one that Isoscope did not write");
}

bool OutputFiles::mayWrite(const std::string& file, OutputKind kind, const std::string& scene) const {
    if (file.empty()) return true;
    std::error_code failed;
    if (std::filesystem::equivalent(file, scene, failed)) {
        std::cerr << file << ": error: is the scene itself and is not replaced\n";
        return false;
    }
    const std::string reason = force ? std::string() : whyNotReplaced(file, kind);
    if (reason.empty()) return true;
    std::cerr << file << ": error: " << reason << "; --force replaces it\n";
    return false;
}

bool writeOutput(const std::string& file, const std::string& content) {
    const std::string reason = writeWhole(file, content);
    if (reason.empty()) return true;
    std::cerr << file << ": error: the file cannot be written: " << reason << '\n';
    return false;
}

bool finishStandardOutput() {
    const bool written = static_cast<bool>(std::cout.flush());
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && written) return true;
    std::cerr << "error: the standard output cannot be written; a part of it is lost\n";
    return false;
}

}  // namespace isoscope::cli
