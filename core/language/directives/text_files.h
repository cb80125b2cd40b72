// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/language/expressions/value.h"

namespace isoscope {

/// The files that a text opens by `#fopen`, under the names of their handles. Nothing is written to disk:
/// what `#write` says is kept here, where `#read` and `#include` of the same text find it.
class TextFiles {
  public:
    /// Bytes that all written files of one text may hold.
    static constexpr std::size_t sizeLimit = 128u << 20;

    /// What a message says behind the name of a file that a text would write.
    static constexpr std::string_view keptNote =
        "is not written until you allow it; the picture is the same.";

    /// What has been written under this name; null when nothing has.
    const std::string* written(const std::string& file) const;
    /// All that has been written, by the names of the files.
    const std::map<std::string, std::string>& allWritten() const { return written_; }
    /// The same for the end of the reading, when the object has no use any more: copies nothing.
    std::map<std::string, std::string> takeWritten() { return std::move(written_); }

    /// `#fopen` with `write` or, for `append`, behind what has been written under this name before. A handle
    /// that is open already then stands for the new file.
    void openToWrite(const std::string& handle, const std::string& file, bool append);
    /// `#fopen` with `read`; `content` is the whole text of the file, read from its beginning.
    void openToRead(const std::string& handle, const std::string& file, std::string content);
    /// `#fclose`: frees the handle and keeps what was written; nothing happens when it is not open.
    void close(const std::string& handle) { open_.erase(handle); }

    /// False when the handle is not open for writing, or the limit is reached.
    bool write(const std::string& handle, std::string_view text);

    /// What one `#read` of a value finds. As in POV-Ray one token behind a value, mostly a comma, goes with
    /// it, whatever it is: of `1 2 3` the 2 is lost, and a file with a comma at its end has one more reading,
    /// which finds nothing.
    struct Read {
        std::optional<Value> value;  ///< float, vector or string; empty at the end and at anything else
        bool atEnd = false;          ///< nothing is left behind the value, or there was none
        std::string wrong;           ///< what stands where a value must; empty at the end
        std::string lost;            ///< what stands behind the value, where that is the start of another one
        std::string file;            ///< the file's name
    };
    /// The next value. Empty when the handle is not open for reading.
    std::optional<Read> read(const std::string& handle);

  private:
    struct Open {
        bool writing = false;
        std::string file;
        std::string content;  ///< what is read
        std::uint32_t at = 0;
    };

    std::map<std::string, Open> open_;
    std::map<std::string, std::string> written_;
    std::size_t size_ = 0;
};

/// A float or vector as `#write` prints it; strings as they are. Empty for anything else.
std::optional<std::string> writtenForm(const Value& value);

}  // namespace isoscope
