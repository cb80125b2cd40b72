// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/text_outline.h"

#include <algorithm>
#include <array>
#include <optional>

#include "widgets/editor/scene_scanner.h"

namespace isoscope {

namespace {

bool isBlank(std::string_view piece) {
    return piece.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos;
}

/// How a directive changes how deep #if, #while, #macro and their like are nested.
int nestingOf(std::string_view directive) {
    static constexpr std::array<std::string_view, 7> openers{"if",    "ifdef", "ifndef", "switch",
                                                             "while", "for",   "macro"};
    const std::string_view word = directive.substr(directive.find_last_of(" \t#") + 1);
    if (word == "end") return -1;
    return std::find(openers.begin(), openers.end(), word) != openers.end() ? 1 : 0;
}

/// Follows a text piece by piece.
class Walk {
  public:
    Walk(std::string_view text, std::size_t caret) : text_(text), caret_(caret) {}

    TextOutline outline() {
        SceneScanner scanner(text_, 0);
        while (!scanner.atEnd()) {
            const std::size_t at = scanner.position();
            const SceneScanner::Piece piece = scanner.next();
            if (text_[at] == '\n')
                endLine(at + 1, scanner.depth() > 0);
            else
                read(at, text_.substr(at, static_cast<std::size_t>(piece.length)), piece.style);
        }
        const bool asked = caret_ > text_.find('\n') && caret_ >= lastInclude_;
        found_.place = asked ? place_.value_or(text_.size()) : text_.size();
        found_.includePlace = versionEnd_.value_or(firstCode_.value_or(text_.size()));
        if (found_.includePlace > found_.place) found_.includePlace = found_.place;
        return found_;
    }

  private:
    void read(std::size_t at, std::string_view piece, SceneStyle style) {
        if (style == SceneStyle::comment || isBlank(piece)) return;
        if (!firstCode_) firstCode_ = text_.rfind('\n', at) + 1;  // npos + 1 is 0
        const bool outside = braces_ == 0 && nesting_ == 0;
        if (style == SceneStyle::directive) {
            nesting_ = std::max(0, nesting_ + nestingOf(piece));
            directive_ = piece;
        } else if (style == SceneStyle::string && directive_.ends_with("include") && outside) {
            lastInclude_ = at;
            found_.includesFunctions |= piece == "\"functions.inc\"";
        } else if (style == SceneStyle::symbol) {
            if (piece == "{") ++braces_;
            if (piece == "}") braces_ = std::max(0, braces_ - 1);
        } else if (style == SceneStyle::keyword) {
            found_.hasCamera |= piece == "camera";
            found_.hasLight |= piece == "light_source";
        }
        // Behind `#declare A =`, or `isosurface` with its brace on a line of its own, more is to come.
        const bool word = style == SceneStyle::keyword || style == SceneStyle::plain;
        finished_ = !word && piece != "=";
    }

    void endLine(std::size_t next, bool inComment) {
        if (directive_.ends_with("version") && !versionEnd_ && finished_) versionEnd_ = next;
        directive_ = {};
        const bool outside = braces_ == 0 && nesting_ == 0 && !inComment && finished_;
        if (!place_ && outside && next > caret_) place_ = next;
    }

    std::string_view text_;
    std::size_t caret_;
    TextOutline found_;
    std::optional<std::size_t> place_, versionEnd_, firstCode_;
    std::size_t lastInclude_ = 0;
    std::string_view directive_;  ///< the last one of the line
    int braces_ = 0;
    int nesting_ = 0;
    bool finished_ = true;
};

}  // namespace

TextOutline outlineOf(std::string_view text, std::size_t caret) { return Walk(text, caret).outline(); }

}  // namespace isoscope
