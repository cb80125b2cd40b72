// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/written_record.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "core/text/whole_file.h"

namespace isoscope {

namespace {

namespace fs = std::filesystem;

/// FNV-1a; the length is part of it by way of the bytes.
std::uint64_t hashOf(const std::string& content) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : content) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    return hash;
}

std::string nameOf(const fs::path& file) {
    std::error_code failed;
    const fs::path full = fs::weakly_canonical(fs::absolute(file, failed), failed);
    return failed ? file.string() : full.string();
}

/// Lines and tabs separate the entries of the file.
bool canBeRemembered(const std::string& name) { return name.find_first_of("\n\t") == std::string::npos; }

}  // namespace

WrittenRecord::WrittenRecord(fs::path file) : file_(std::move(file)) {}

fs::path WrittenRecord::usualPlace() {
    const auto folder = [](const char* variable) {
        const char* value = std::getenv(variable);
        return fs::path(value && *value == '/' ? value : "");
    };
    fs::path state = folder("XDG_STATE_HOME");
    if (state.empty() && !folder("HOME").empty()) state = folder("HOME") / ".local" / "state";
    return state.empty() ? state : state / "isoscope" / "written-files";
}

void WrittenRecord::read() {
    std::ifstream input(file_, std::ios::binary);
    for (std::string line; std::getline(input, line);) {
        std::istringstream fields(line);
        std::uint64_t hash = 0;
        std::string scene, place;
        if (!(fields >> std::hex >> hash) || !std::getline(fields >> std::ws, scene, '\t') ||
            !std::getline(fields, place) || place.empty())
            continue;
        entries_[{scene, place}] = {hash, order_++};
    }
}

void WrittenRecord::write() const {
    std::vector<std::pair<Entry, const Key*>> inOrder;
    for (const auto& [key, entry] : entries_)
        if (canBeRemembered(key.first) && canBeRemembered(key.second)) inOrder.emplace_back(entry, &key);
    std::sort(inOrder.begin(), inOrder.end(),
              [](const auto& a, const auto& b) { return a.first.order < b.first.order; });
    std::ostringstream text;
    for (std::size_t i = inOrder.size() > limit ? inOrder.size() - limit : 0; i < inOrder.size(); ++i)
        text << std::hex << inOrder[i].first.hash << '\t' << inOrder[i].second->first << '\t'
             << inOrder[i].second->second << '\n';
    std::error_code failed;
    fs::create_directories(file_.parent_path(), failed);
    // Nothing is lost without it but a question the next time.
    [[maybe_unused]] const std::string reason =
        writeWhole(file_, text.str(), {.ownerOnly = true, .durable = false});
}

bool WrittenRecord::holds(const fs::path& scene, const fs::path& place) const {
    // Another program may have written meanwhile.
    WrittenRecord present(*this);
    if (!file_.empty()) present.read();
    const auto found = present.entries_.find({nameOf(scene), nameOf(place)});
    if (found == present.entries_.end()) return false;
    std::ifstream input(place, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(input), {}};
    return input.is_open() && hashOf(content) == found->second.hash;
}

void WrittenRecord::add(const fs::path& scene, const fs::path& place, const std::string& content) {
    if (!file_.empty()) read();
    entries_[{nameOf(scene), nameOf(place)}] = {hashOf(content), order_++};
    if (!file_.empty()) write();
}

}  // namespace isoscope
