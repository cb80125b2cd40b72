// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace isoscope {

/// Which files scenes wrote by `#write`, and what was in them: only such a file, as long as no other program
/// has changed it, is replaced unasked. Remembered between runs in a file of its own, without which, or when
/// it cannot be written, it is remembered for this run alone.
class WrittenRecord {
  public:
    /// An empty `file` means this run alone.
    explicit WrittenRecord(std::filesystem::path file = usualPlace());

    /// In the user's folder for program state (XDG_STATE_HOME, else ~/.local/state); empty without a home.
    static std::filesystem::path usualPlace();
    /// More than these are forgotten, oldest first.
    static constexpr std::size_t limit = 1000;

    /// Whether what stands at `place` is what `scene` wrote there last.
    bool holds(const std::filesystem::path& scene, const std::filesystem::path& place) const;
    /// Remembers that `scene` wrote `content` there, in the file of the record too.
    void add(const std::filesystem::path& scene, const std::filesystem::path& place,
             const std::string& content);

  private:
    struct Entry {
        std::uint64_t hash = 0;
        std::uint64_t order = 0;
    };
    using Key = std::pair<std::string, std::string>;  ///< scene, place

    void read();
    void write() const;

    std::filesystem::path file_;
    std::map<Key, Entry> entries_;
    std::uint64_t order_ = 0;
};

}  // namespace isoscope
