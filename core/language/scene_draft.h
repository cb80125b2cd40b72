// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/objects/object_description.h"
#include "core/language/tokens/token_stream.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What the statement parsers of one scene share: the scene so far, and what later statements depend on.
struct SceneDraft {
    /// An object of the scene, with the material that #default had set for it.
    struct Entry {
        ObjectPointer object;
        std::size_t defaultMaterial = 0;
    };

    Scene scene;
    /// In the order of the text; shapes are made of them at the end.
    std::vector<Entry> objects;
    std::size_t shapeCount = 0;
    /// Materials of objects without one of their own; each #default adds one, and the last is in force. A
    /// #default within a texture leaves those in place that the texture began with.
    std::deque<Material> defaultMaterials{Material{}};
    bool hasCamera = false;
};

/// Reports something that the language knows and this program does not simulate; `sentence` says what, with a
/// full stop.
void reportLeftOut(ParseContext& context, const SourceRange& range, const std::string& sentence);

/// The sentence about a word that is not simulated: what the picture lacks, where the word does not say it.
std::string notSimulatedSentence(std::string_view word);

/// What a message calls the token: "`foo`", "a string", "the end of the text".
std::string describe(const Token& token);

/// The range from `first` to the token taken last, where both are in one file; else `first` alone.
SourceRange rangeSince(const SourceRange& first, const TokenStream& tokens);

}  // namespace isoscope
