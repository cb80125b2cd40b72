// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/language/parse_context.h"
#include "core/language/tokens/token.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// Warns of text that is read here and that POV-Ray 3.7 refuses: `wants` is what it wants instead, behind
/// "POV-Ray", and `hint` what to do. Each was tried with POV-Ray.
void warnOfRefusal(ParseContext& context, const SourceRange& range, const std::string& wants,
                   const std::string& hint, std::vector<QuickFix> fixes = {});

/// The same of text that can be left out, or have `added` put in front of it; a fix does so.
void warnOfSuperfluous(ParseContext& context, const SourceRange& range, const std::string& wants);
void warnOfMissing(ParseContext& context, const SourceRange& range, const std::string& wants,
                   const std::string& added);

/// The same of an item, just read, that must stand before what begins at `first`; a fix exchanges the two.
void warnOfLateItem(TokenStream& tokens, const SourceRange& first, const Token& item,
                    const std::string& wants);

/// Warns of the token taken last, if that is a comma: to be called where POV-Ray takes none.
void warnOfLastComma(TokenStream& tokens);

/// Warns of the name of a declared `kind`, "texture", that stands behind other items.
void warnOfLateName(ParseContext& context, const Token& name, const std::string& kind);

/// The order in which POV-Ray wants the items of a `pigment` or `normal`: `uv_mapping`, a declared one, the
/// colour or pattern with its list, then all others.
class ItemOrder {
  public:
    /// What was read: `uv_mapping`, the name of a declared one, its colour or pattern, an entry of the list
    /// behind it, anything else.
    enum class Item : std::uint8_t { mapping, name, start, list, other };

    explicit ItemOrder(const char* block) : block_(block) {}
    /// An item has been read that began with `word`; warns where another one should stand behind it.
    void note(ParseContext& context, const Token& word, Item item);

  private:
    const char* block_;
    Item last_ = Item::mapping;
};

}  // namespace isoscope
