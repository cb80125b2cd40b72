// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/language/statement_list.h"

namespace isoscope {

struct Material;
struct Scene;
struct SceneDraft;
struct Value;
class TokenStream;

/// All that the language has to know of a statement `WORD { ... }`. It stands in the source of its parser.
struct StatementDescription {
    std::string_view word;
    /// Lists of the words that may begin an item of its block, for "did you mean"; null where there is none.
    std::array<const char*, 3> itemWords;
    /// Reads the block, braces included, behind the word, and adds to the scene what it says.
    void (*parse)(TokenStream& tokens, SceneDraft& draft);
    /// The same behind `#declare NAME = WORD`; null where nothing can be declared so.
    std::optional<Value> (*parseValue)(TokenStream& tokens, SceneDraft& draft) = nullptr;
    /// Appends what it has added of materials that are not among Scene::materials, to be compiled; null where
    /// it has none.
    void (*addMaterials)(Scene& scene, std::vector<Material*>& materials) = nullptr;
};

/// The description of each statement.
namespace statements {
#define ISOSCOPE_ROW(name) extern const StatementDescription name;
ISOSCOPE_STATEMENTS(ISOSCOPE_ROW)
#undef ISOSCOPE_ROW
}  // namespace statements

/// All of them.
constexpr auto statementDescriptions = std::to_array<const StatementDescription*>({
#define ISOSCOPE_ROW(name) &statements::name,
    ISOSCOPE_STATEMENTS(ISOSCOPE_ROW)
#undef ISOSCOPE_ROW
});

/// The statement that begins with a word, or null.
inline const StatementDescription* findStatement(std::string_view word) {
    for (const StatementDescription* statement : statementDescriptions)
        if (statement->word == word) return statement;
    return nullptr;
}

}  // namespace isoscope
