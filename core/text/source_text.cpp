// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/source_text.h"

#include <algorithm>

namespace isoscope {

SourceText::SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
    lineStarts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n') lineStarts_.push_back(static_cast<std::uint32_t>(i + 1));
}

LineColumn SourceText::position(std::uint32_t offset) const {
    offset = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text_.size()));
    const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
    const auto line = static_cast<int>(next - lineStarts_.begin());
    return {line, static_cast<int>(offset - *(next - 1)) + 1};
}

std::uint32_t SourceLibrary::add(std::string name, std::string text) {
    texts_.emplace_back(std::move(name), std::move(text));
    return static_cast<std::uint32_t>(texts_.size() - 1);
}

std::string_view SourceLibrary::slice(const SourceRange& range) const {
    if (range.file >= texts_.size()) return {};
    const std::string_view text = texts_[range.file].text();
    if (range.begin > range.end || range.end > text.size()) return {};
    return text.substr(range.begin, range.end - range.begin);
}

}  // namespace isoscope
