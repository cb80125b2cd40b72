// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace isoscope::test {

/// `text` with one to eight changes of its tokens: dropped, doubled, swapped, numbers at the edges of doubles
/// and integers, words of the language put in, a piece of `other` put in. The same for the same state of
/// `random`.
std::string changedTokens(std::string_view text, std::string_view other, std::mt19937_64& random);

/// `bytes` with one to eight bytes or stretches changed, dropped or doubled.
std::string changedBytes(std::string_view bytes, std::mt19937_64& random);

/// At most `most` bytes of a file: of a text from the beginning of any of its lines on, else its beginning.
std::string partOf(std::string_view whole, std::size_t most, bool isText, std::mt19937_64& random);

}  // namespace isoscope::test
