// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/container_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <string_view>

namespace isoscope::cli {

namespace {

/// Reads a container from the left; every function says whether it found what it names.
class ContainerReader {
  public:
    explicit ContainerReader(std::string_view text) : rest_(text) {}

    bool symbol(std::string_view text) {
        skipBlanks();
        if (!rest_.starts_with(text)) return false;
        rest_.remove_prefix(text.size());
        return true;
    }
    bool number(double& value) {
        skipBlanks();
        if (rest_.starts_with('+')) rest_.remove_prefix(1);
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return false;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return true;
    }
    bool vector(glm::dvec3& value) {
        return symbol("<") && number(value.x) && symbol(",") && number(value.y) && symbol(",") &&
               number(value.z) && symbol(">");
    }
    bool end() {
        skipBlanks();
        return rest_.empty();
    }

  private:
    void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }

    std::string_view rest_;
};

}  // namespace

std::optional<Container> readContainer(const std::string& text) {
    ContainerReader reader(text);
    ContainerBox box;
    ContainerSphere sphere;
    if (reader.symbol("box")) {
        const bool read = reader.symbol("{") && reader.vector(box.low) && (reader.symbol(","), true) &&
                          reader.vector(box.high) && reader.symbol("}") && reader.end();
        if (!read) return {};
        return ContainerBox{glm::min(box.low, box.high), glm::max(box.low, box.high)};
    }
    const bool read = reader.symbol("sphere") && reader.symbol("{") && reader.vector(sphere.center) &&
                      (reader.symbol(","), true) && reader.number(sphere.radius) && reader.symbol("}") &&
                      reader.end() && sphere.radius > 0;
    return read ? std::optional<Container>(sphere) : std::nullopt;
}

}  // namespace isoscope::cli
