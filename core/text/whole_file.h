// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isoscope {

/// How writeWhole() makes a file.
struct WholeFileOptions {
    bool ownerOnly = false;  ///< other users may not read it, from its first byte on
    bool durable = true;     ///< waits until the disk has it, so that a loss of power keeps old or new
};

/// Replaces `file` by `content`, or makes it: whole or not at all. The content is written beside the file and
/// renamed; mode, owner and group stay what they were, and a symbolic link stays one. What a rename would
/// lose is written in place, while a copy lies beside it and is put back if that fails: a file with further
/// hard links, with an access list or attributes of its own, of an owner that cannot be given, or in a folder
/// that takes no new file. Devices and pipes are written to. Returns why the file could not be written, as
/// the system puts it ("No space left on device"); empty when it is. A failure leaves what was there.
[[nodiscard]] std::string writeWhole(const std::filesystem::path& file, std::string_view content,
                                     const WholeFileOptions& options = {});

}  // namespace isoscope
