// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/statement_scanner.h"

#include <algorithm>
#include <array>

namespace isoscope {

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

enum class WordKind { identifier, directive, open, close, other, end };

/// The next thing in the text that matters for its structure.
struct Word {
    WordKind kind = WordKind::end;
    std::size_t begin = 0, end = 0;
    std::string_view text;
};

/// Reads words, over comments and strings.
class WordReader {
  public:
    explicit WordReader(std::string_view text) : text_(text) {}

    Word next() {
        skipBlank();
        Word word;
        word.begin = at_;
        if (at_ >= text_.size()) {
            word.end = at_;
            return word;
        }
        word.kind = read();
        word.end = at_;
        word.text = text_.substr(word.begin, word.end - word.begin);
        if (word.kind == WordKind::directive) {
            word.text.remove_prefix(1);
            word.text.remove_prefix(std::min(word.text.find_first_not_of(" \t"), word.text.size()));
        }
        return word;
    }
    /// Where the reader stands: behind the last word.
    std::size_t position() const { return at_; }
    void seek(std::size_t position) { at_ = position; }

  private:
    bool ahead(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

    void skipBlank() {
        while (at_ < text_.size()) {
            if (ahead("//")) {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (ahead("/*")) {
                skipBlockComment();
            } else if (static_cast<unsigned char>(text_[at_]) <= ' ') {
                ++at_;
            } else {
                return;
            }
        }
    }

    /// Block comments nest.
    void skipBlockComment() {
        int depth = 0;
        do {
            if (ahead("/*")) {
                ++depth;
                at_ += 2;
            } else if (ahead("*/")) {
                --depth;
                at_ += 2;
            } else {
                ++at_;
            }
        } while (depth > 0 && at_ < text_.size());
        at_ = std::min(at_, text_.size());
    }

    WordKind read() {
        const char c = text_[at_++];
        if (isLetter(c)) {
            readName();
            return WordKind::identifier;
        }
        if (c == '#') {
            while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
            readName();
            return WordKind::directive;
        }
        if (c == '"') readString();
        if (c == '{') return WordKind::open;
        if (c == '}') return WordKind::close;
        return WordKind::other;
    }

    void readName() {
        while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
    }

    void readString() {
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        at_ = std::min(at_ + 1, text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

template <std::size_t count>
bool oneOf(std::string_view word, const std::array<std::string_view, count>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool opensBlock(std::string_view directive) {
    static constexpr std::array<std::string_view, 7> words{"if",     "ifdef", "ifndef", "while",
                                                           "switch", "macro", "for"};
    return oneOf(directive, words);
}

bool declares(std::string_view directive) {
    static constexpr std::array<std::string_view, 3> words{"declare", "local", "macro"};
    return oneOf(directive, words);
}

/// Reads one piece after another.
class PieceReader {
  public:
    explicit PieceReader(std::string_view text) : text_(text), reader_(text) {}

    std::vector<ScenePiece> all() {
        std::vector<ScenePiece> pieces;
        for (Word word = reader_.next(); word.kind != WordKind::end; word = reader_.next()) {
            if (word.kind != WordKind::identifier && word.kind != WordKind::directive) continue;
            pieces.push_back(piece(word));
        }
        return pieces;
    }

  private:
    ScenePiece piece(const Word& first) {
        ScenePiece piece;
        piece.begin = first.begin;
        piece.end = first.end;
        if (first.kind == WordKind::directive) {
            piece.directive = first.text;
            note(first, piece);
            if (opensBlock(first.text))
                readToEnd(piece);
            else if (declares(first.text))
                readDeclaration(piece);
            else
                readLine(piece);
        } else {
            piece.used.emplace(first.text);
            readStatement(piece);
        }
        return piece;
    }

    /// Up to the #end that belongs to it.
    void readToEnd(ScenePiece& piece) {
        int depth = 1;
        for (Word word = reader_.next(); word.kind != WordKind::end && depth > 0; word = reader_.next()) {
            note(word, piece);
            piece.end = word.end;
            if (word.kind != WordKind::directive) continue;
            if (opensBlock(word.text)) ++depth;
            if (word.text == "end") --depth;
            if (depth == 0) return;
        }
    }

    /// `#declare NAME = value`: up to the semicolon, or the end of a block that no sign continues.
    void readDeclaration(ScenePiece& piece) {
        int depth = 0;
        int conditions = 0;
        while (true) {
            const std::size_t before = reader_.position();
            const Word word = reader_.next();
            const bool outermost = depth == 0 && conditions == 0;
            if (word.kind == WordKind::end) return;
            if (outermost && word.kind == WordKind::directive && !opensBlock(word.text)) {
                reader_.seek(before);
                return;
            }
            note(word, piece);
            piece.end = word.end;
            if (word.kind == WordKind::directive) {
                if (opensBlock(word.text)) ++conditions;
                if (word.text == "end" && conditions > 0) --conditions;
            }
            if (word.kind == WordKind::open) ++depth;
            if (word.kind == WordKind::close) --depth;
            if (depth < 0 || (outermost && word.text == ";")) return;
            if (word.kind == WordKind::close && depth == 0 && conditions == 0) {
                acceptSemicolon(piece);
                return;
            }
        }
    }

    void acceptSemicolon(ScenePiece& piece) {
        const std::size_t before = reader_.position();
        const Word word = reader_.next();
        if (word.text == ";")
            piece.end = word.end;
        else
            reader_.seek(before);
    }

    /// Other directives (#include "name", #version 3.7;) end with their line.
    void readLine(ScenePiece& piece) {
        const std::size_t lineEnd = std::min(text_.find('\n', piece.end), text_.size());
        while (true) {
            const std::size_t before = reader_.position();
            const Word word = reader_.next();
            const bool another = word.kind == WordKind::directive || word.kind == WordKind::identifier;
            if (word.kind == WordKind::end || word.begin >= lineEnd || (another && closed_)) {
                reader_.seek(before);
                break;
            }
            piece.end = word.end;
            note(word, piece);
            closed_ = word.text == ";" || word.text.starts_with('"');
        }
        closed_ = false;
    }

    /// `word ... { ... }`, or a macro call: up to the end of its block or the next directive.
    void readStatement(ScenePiece& piece) {
        int depth = 0;
        while (true) {
            const std::size_t before = reader_.position();
            const Word word = reader_.next();
            if (word.kind == WordKind::end) return;
            if (depth == 0 && word.kind == WordKind::directive) {
                reader_.seek(before);
                return;
            }
            note(word, piece);
            piece.end = word.end;
            if (word.kind == WordKind::open) ++depth;
            if (word.kind == WordKind::close && --depth <= 0) return;
        }
    }

    void note(const Word& word, ScenePiece& piece) {
        if (word.kind == WordKind::identifier) {
            if (nameFollows_) piece.declared.emplace(word.text);
            piece.used.emplace(word.text);
        }
        nameFollows_ = word.kind == WordKind::directive && declares(word.text);
    }

    std::string_view text_;
    WordReader reader_;
    bool nameFollows_ = false;
    bool closed_ = false;
};

}  // namespace

std::vector<ScenePiece> scanPieces(std::string_view text) { return PieceReader(text).all(); }

std::set<std::string> identifiersIn(std::string_view text) {
    std::set<std::string> result;
    WordReader reader(text);
    for (Word word = reader.next(); word.kind != WordKind::end; word = reader.next())
        if (word.kind == WordKind::identifier) result.emplace(word.text);
    return result;
}

}  // namespace isoscope
