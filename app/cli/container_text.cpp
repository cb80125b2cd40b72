// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/container_text.h"

#include <charconv>
#include <vector>

namespace isoscope::cli {

namespace {

/// The numbers of the text, which otherwise consists of `separators`; nothing when it does not.
std::optional<std::vector<double>> readNumbers(std::string_view text) {
    constexpr std::string_view separators = "<>{}, \t";
    std::vector<double> numbers;
    while (!text.empty()) {
        if (separators.find(text.front()) != std::string_view::npos) {
            text.remove_prefix(1);
            continue;
        }
        if (text.front() == '+') text.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc()) return {};
        numbers.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return numbers;
}

}  // namespace

std::optional<Container> readContainer(const std::string& text) {
    const std::size_t brace = text.find('{');
    if (brace == std::string::npos) return {};
    std::string word = text.substr(0, brace);
    while (!word.empty() && word.back() == ' ') word.pop_back();
    const auto v = readNumbers(std::string_view(text).substr(brace));
    if (!v) return {};
    if (word == "box" && v->size() == 6)
        return ContainerBox{{(*v)[0], (*v)[1], (*v)[2]}, {(*v)[3], (*v)[4], (*v)[5]}};
    if (word == "sphere" && v->size() == 4) return ContainerSphere{{(*v)[0], (*v)[1], (*v)[2]}, (*v)[3]};
    return {};
}

}  // namespace isoscope::cli
