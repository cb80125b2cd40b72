// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace isoscope {

/// What a word of the scene language is used for, as bits: some have several uses.
enum class WordUse : std::uint16_t {
    none = 0,
    keyword = 1 << 0,             ///< stands in statements and expressions by itself
    directive = 1 << 1,           ///< stands behind `#`
    constant = 1 << 2,            ///< is a value by itself: `x`, `clock`
    functionConstant = 1 << 3,    ///< is one inside a function body, too
    predeclared = 1 << 4,         ///< has a value until a text declares it: `image_width`
    color = 1 << 5,               ///< begins a colour: `rgb`, `red`
    expressionFunction = 1 << 6,  ///< is called in expressions of the scene
    elementaryFunction = 1 << 7,  ///< is called inside function bodies
    shape = 1 << 8,               ///< begins a shape, be it one that this program leaves out
    notSimulated = 1 << 9,        ///< a statement with a block that this program leaves out
};
constexpr WordUse operator|(WordUse a, WordUse b) {
    return static_cast<WordUse>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// How an editor shows a word.
enum class EditorClass : std::uint8_t { plain, keyword, function };

/// One word of the scene language.
struct Word {
    /// The version of the language whose words these are; those of later ones are marked, for hints.
    static constexpr int ourVersion = 370;

    std::string_view text;
    WordUse uses = WordUse::none;
    std::string_view call = {};  ///< "atan2(A, B)"; empty for what is no function
    int since = 0;               ///< 350: came with version 3.5; 0: the readers need not tell

    /// Whether any of the uses is one of the word's.
    constexpr bool is(WordUse use) const {
        return (static_cast<unsigned>(uses) & static_cast<unsigned>(use)) != 0;
    }
    /// Whether POV-Ray 3.7 knows the word without a declaration.
    constexpr bool known() const { return since <= ourVersion; }
    /// Whether it refuses the word as a name: of a value, a macro, a macro's parameter.
    constexpr bool reserved() const { return known() && !is(WordUse::predeclared); }
    /// How the word is shown where no `#` stands before it.
    constexpr EditorClass editorClass() const {
        if (!known() || !is(WordUse::keyword)) return EditorClass::plain;
        return call.empty() ? EditorClass::keyword : EditorClass::function;
    }
};

/// All words, sorted, each once: the only list of what belongs to the language. Which are reserved is what
/// POV-Ray 3.7 answers (tests/data/language/reserved_words.csv).
std::span<const Word> words();

/// The entry of a word, null for any other text. Takes less time than hashing the text; safe in any thread.
const Word* findWord(std::string_view text);

/// Whether the word belongs to the language of POV-Ray 3.7, so that nothing can be named by it.
inline bool isReservedWord(std::string_view text) {
    const Word* word = findWord(text);
    return word && word->reserved();
}

/// Whether the word has any of the uses.
inline bool isWordFor(WordUse use, std::string_view text) {
    const Word* word = findWord(text);
    return word && word->is(use);
}

}  // namespace isoscope
