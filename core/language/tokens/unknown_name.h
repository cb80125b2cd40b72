// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/language/parse_context.h"
#include "core/language/tokens/token.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// Says that a word is not declared, and what was probably meant: a name much like it, or one of an include
/// file that is missing.
void reportUnknownName(ParseContext& context, const Token& word);

/// error(), with what was probably meant by `word` as hint and fix: the nearest of `candidates`, or a name of
/// the program's own include files that is nearer. It is looked for once for each word of a `place`, and only
/// when the message is new and will be kept, for a loop may ask often. `about` is the range of the message;
/// without it that of the word.
void reportUnknownWord(ParseContext& context, const std::string& id, const Token& word, std::string message,
                       std::string_view place, const std::function<std::vector<std::string>()>& candidates,
                       std::optional<SourceRange> about = {});

/// Says that the next token begins no item of `block` ("camera"), with a likely word for a hint, and passes
/// it by, as skipUnknownItem() does. False, and nothing is said or passed, at the end of the block or of the
/// text. Of a comma between items it only warns. `end` is what closes the block.
bool passUnknownItem(TokenStream& tokens, std::string_view block, std::string_view end = "}");
/// Passes the next token by with what seems to belong to it: numbers, names, operators, one block. What
/// follows can be read as if it had not been there. What directives in it say is told.
void skipUnknownItem(TokenStream& tokens, std::string_view block);
/// Where the next token is a word of the language that cannot stand in `block`, in front of which the `}` of
/// the block seems to be missing (TokenStream::supplyBrace): says so, and the next token is that `}`.
bool closeUnclosed(TokenStream& tokens, std::string_view block);

/// The program's own include file that declares `name`, or "".
std::string includeThatDeclares(std::string_view name);

/// Whether `name` is a built-in of functions.inc, which has been included.
bool isCallableBuiltin(const ParseContext& context, std::string_view name);
/// The built-in as if it had been declared. Its name must be callable.
FunctionValue builtinFunction(const ParseContext& context, std::string_view name);

}  // namespace isoscope
