// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/gradient_repairs.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/exchange/setting_change.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::optional<std::string> contentOf(const std::filesystem::path& name) {
    std::error_code ignored;
    // Neither a folder nor a pipe.
    if (!std::filesystem::is_regular_file(name, ignored)) return {};
    std::ifstream stream(name, std::ios::binary);
    if (!stream) return {};
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

bool GradientRepairs::add(std::size_t number, double value) {
    if (!std::isfinite(value)) return false;
    auto change = gradientChangeAnywhere(parsed_, number, shortestNumber(value));
    if (!change) return false;
    auto& file = changes_[change->range.file];
    const auto [known, isNew] = file.try_emplace(change->range.begin, value, *change);
    if (!isNew && known->second.first < value) known->second = {value, std::move(*change)};
    return true;
}

std::vector<std::uint32_t> GradientRepairs::files() const {
    std::vector<std::uint32_t> files;
    for (const auto& [file, changes] : changes_) files.push_back(file);
    return files;
}

std::vector<TextChange> GradientRepairs::changes(std::uint32_t file) const {
    std::vector<TextChange> changes;
    if (const auto found = changes_.find(file); found != changes_.end())
        for (const auto& [place, change] : found->second) changes.push_back(change.second);
    return changes;
}

std::string GradientRepairs::text(std::uint32_t file) const {
    return changedText(std::string((*parsed_.sources)[file].text()), changes(file));
}

std::string GradientRepairs::obstacle(const ParseResult& parsed, std::uint32_t file,
                                      const std::filesystem::path& scene) {
    namespace fs = std::filesystem;
    if (file >= parsed.sources->size()) return "it is not known";
    const SourceText& source = (*parsed.sources)[file];
    const fs::path name = file == 0 ? scene : fs::path(source.name());
    std::error_code ignored;
    const fs::path folder = fs::weakly_canonical(fs::absolute(scene, ignored), ignored).parent_path();
    const fs::path beside = fs::weakly_canonical(name, ignored).lexically_relative(folder);
    if (scene.empty() || beside.empty() || *beside.begin() == "..")
        return "it stands in another folder than the scene";
    if (contentOf(name) != source.text()) return "it is not the text that was read";
    return {};
}

}  // namespace isoscope
