// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
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

/// A file of any size, made piece by piece, that takes its place whole or not at all, by the rules of
/// writeWhole(). Until finish() the pieces lie beside the file; where what stands there must be written in
/// place (a device, a file with further hard links, ...), in memory. What is not finished leaves nothing.
class GrowingFile {
  public:
    explicit GrowingFile(std::filesystem::path file);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    /// Bytes so far.
    std::uint64_t size() const { return size_; }
    /// Puts bytes at `position`, which is at most size(): over what is there, and behind it. False after a
    /// failure, of this call or an earlier one.
    bool write(std::uint64_t position, std::string_view bytes);
    bool append(std::string_view bytes) { return write(size_, bytes); }
    /// Why writing failed, as the system puts it; empty while it has not.
    const std::string& problem() const { return problem_; }
    /// The file is whole. Returns why it could not be written, as writeWhole() does.
    [[nodiscard]] std::string finish();

  private:
    struct Partial;

    std::filesystem::path file_;
    std::unique_ptr<Partial> partial_;  ///< none: in memory
    std::string memory_;
    std::uint64_t size_ = 0;
    std::string problem_;
};

}  // namespace isoscope
