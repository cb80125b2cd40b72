// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/interior_parser.h"

#include <algorithm>
#include <array>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/scene_draft.h"
#include "core/language/textures/media_parser.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

constexpr std::array<const char*, 3> InteriorParser::itemWords{
    "ior caustics dispersion dispersion_samples fade_distance fade_power fade_color media"};

std::shared_ptr<const Interior> InteriorParser::parse() {
    if (tokens_.expect("{", "to begin `interior`"))
        while (!tokens_.accept("}")) {
            if (parseItem()) continue;
            const Token token = tokens_.peek();
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close `interior`");
                break;
            }
            passUnknownItem(tokens_, "interior");
        }
    return std::make_shared<const Interior>(interior_);
}

bool InteriorParser::parseItem() {
    using InteriorPointer = std::shared_ptr<const Interior>;
    if (const std::optional<InteriorPointer> declared = takeDeclared<InteriorPointer>(tokens_)) {
        if (*declared) interior_ = **declared;
        return true;
    }
    if (tokens_.accept("fade_color") || tokens_.accept("fade_colour")) {
        interior_.fadeColor = ExpressionParser(tokens_).parseColor();
        return true;
    }
    if (tokens_.accept("dispersion_samples")) {
        const double samples = ExpressionParser(tokens_).parseFloat();
        interior_.dispersionSamples = samples >= 100 ? 100 : samples >= 2 ? static_cast<int>(samples) : 2;
        return true;
    }
    if (tokens_.accept("media")) {
        MediaParser(tokens_).parseInto(interior_.media);
        return true;
    }
    return parseNumberItem();
}

bool InteriorParser::parseNumberItem() {
    struct Entry {
        const char* word;
        double Interior::*member;
    };
    static constexpr std::array<Entry, 5> entries{{{"ior", &Interior::ior},
                                                   {"caustics", &Interior::caustics},
                                                   {"dispersion", &Interior::dispersion},
                                                   {"fade_distance", &Interior::fadeDistance},
                                                   {"fade_power", &Interior::fadePower}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            interior_.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    return false;
}

}  // namespace isoscope
