// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/bare_formula.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/function/operation.h"

namespace isoscope {

namespace {

constexpr int depthLimit = 60;
constexpr std::size_t lengthLimit = 20'000;  ///< powers double what stands below them

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isVariable(std::string_view word) { return word == "x" || word == "y" || word == "z"; }

/// How tightly a piece of text holds together.
enum Binding { sum, product, sign, operand };

/// A part of the formula in POV-Ray's words.
struct Piece {
    std::string text;
    Binding binding = operand;
    bool isNumeral = false;  ///< digits alone
    bool isEuler = false;    ///< e, whose powers are exp()
};

std::string inside(const Piece& piece, Binding least) {
    return piece.binding < least ? "(" + piece.text + ")" : piece.text;
}

/// Behind an operator: a sign there wants parentheses.
std::string second(const Piece& piece, Binding least) {
    return piece.text.starts_with('-') ? "(" + piece.text + ")" : inside(piece, least);
}

struct Spelling {
    std::string_view written;
    std::string_view meant;
};

/// What is written with other characters than POV-Ray's.
constexpr std::array<Spelling, 10> spellings{{{"**", "^"},
                                              {"·", "*"},
                                              {"×", "*"},
                                              {"⋅", "*"},
                                              {"÷", "/"},
                                              {"−", "-"},
                                              {"≤", "<"},
                                              {"≥", ">"},
                                              {"<=", "<"},
                                              {">=", ">"}}};
constexpr std::array<std::string_view, 10> superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

/// Functions by their names: `#` and `@` stand for the first and second argument.
const std::map<std::string_view, std::string>& functions() {
    static const auto all = [] {
        std::map<std::string_view, std::string> table{{"arcsin", "asin(#)"},
                                                      {"arccos", "acos(#)"},
                                                      {"arctan", "atan(#)"},
                                                      {"log10", "log(#)"},
                                                      {"log2", "(ln(#)/ln(2))"},
                                                      {"sqr", "pow(#, 2)"},
                                                      {"cbrt", "(select(#, -1, 1)*pow(abs(#), 1/3))"},
                                                      {"sec", "(1/cos(#))"},
                                                      {"csc", "(1/sin(#))"},
                                                      {"cot", "(1/tan(#))"},
                                                      {"sgn", "select(#, -1, 0, 1)"},
                                                      {"sign", "select(#, -1, 0, 1)"}};
        for (const OperationFacts& facts : operationTable)
            if (facts.common && !facts.call.empty())
                table[facts.word()] = std::string(facts.word()) + (facts.arity == 2 ? "(#, @)" : "(#)");
        return table;
    }();
    return all;
}

class FormulaReader {
  public:
    FormulaReader(std::string_view text, std::size_t begin,
                  const std::function<bool(std::string_view)>& isNumber)
        : text_(text), begin_(begin), at_(begin), isNumber_(isNumber) {}

    std::optional<BareFormula> read();

  private:
    Piece equation();
    Piece sums();
    Piece products();
    Piece signedFactor();
    Piece powers();
    Piece base();
    Piece number();
    Piece word();
    Piece call(std::string_view name, std::string_view meaning);
    Piece absolute();
    Piece power(const Piece& base, const Piece& exponent);
    std::string superscript();

    /// Whether `symbol` stands next; passes it. At the outermost level a new line goes on with an operator
    /// only.
    bool accept(std::string_view symbol);
    std::string_view peekSymbol(std::size_t& length);
    bool beginsFactor();
    void skipBlank(bool lines);
    std::size_t nextLine() const;
    bool endsHere();
    Piece fail() {
        failed_ = true;
        return {"0"};
    }
    char current() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool startsWith(std::string_view what) const {
        return text_.substr(std::min(at_, text_.size())).starts_with(what);
    }

    std::string_view text_;
    std::size_t begin_;
    std::size_t at_;
    const std::function<bool(std::string_view)>& isNumber_;
    std::vector<std::string> names_;
    int depth_ = 0;
    int parentheses_ = 0;
    int bars_ = 0;  ///< open | |, within the innermost parentheses
    bool hasVariable_ = false;
    int operations_ = 0;
    bool failed_ = false;
};

void FormulaReader::skipBlank(bool lines) {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (c == ' ' || c == '\t' || (lines && (c == '\n' || c == '\r')))
            ++at_;
        else
            return;
    }
}

bool FormulaReader::accept(std::string_view symbol) {
    skipBlank(parentheses_ > 0);
    std::size_t length = 0;
    const std::size_t before = at_;
    if (parentheses_ == 0 && (current() == '\n' || current() == '\r')) {
        skipBlank(true);
        if (std::string_view("+*/^=").find(symbol) == std::string_view::npos || startsWith("//") ||
            startsWith("/*") || peekSymbol(length) != symbol) {
            at_ = before;
            return false;
        }
    }
    if (peekSymbol(length) != symbol || startsWith("//") || startsWith("/*")) {
        at_ = before;
        return false;
    }
    at_ += length;
    return true;
}

std::string_view FormulaReader::peekSymbol(std::size_t& length) {
    for (const Spelling& spelling : spellings)
        if (startsWith(spelling.written)) {
            length = spelling.written.size();
            return spelling.meant;
        }
    length = 1;
    return text_.substr(std::min(at_, text_.size()), 1);
}

std::optional<BareFormula> FormulaReader::read() {
    const Piece whole = equation();
    if (failed_ || !hasVariable_ || operations_ == 0 || whole.text.size() > lengthLimit || !endsHere())
        return std::nullopt;
    return BareFormula{at_, whole.text, names_};
}

bool FormulaReader::endsHere() {
    std::size_t end = at_;
    while (end > begin_ && (text_[end - 1] == ' ' || text_[end - 1] == '\t')) --end;
    skipBlank(false);
    const bool ends = at_ >= text_.size() || current() == '\n' || current() == '\r' || current() == ';' ||
                      startsWith("//") || startsWith("/*");
    if (current() != ';') at_ = end;
    return ends;
}

Piece FormulaReader::equation() {
    Piece left = sums();
    const bool less = accept("<"), greater = !less && accept(">");
    if (!less && !greater && !accept("=")) return left;
    if (startsWith("=")) ++at_;  // `==`
    ++operations_;
    Piece right = sums();
    if (greater) std::swap(left, right);
    if (right.text == "0") return left;
    if (left.text == "0") return right;
    return {left.text + " - " + second(right, product), sum};
}

Piece FormulaReader::sums() {
    if (++depth_ > depthLimit) return fail();
    Piece result = products();
    while (!failed_) {
        const bool plus = accept("+");
        if (!plus && !accept("-")) break;
        ++operations_;
        const Piece right = products();
        result = {result.text + (plus ? " + " : " - ") + second(right, product), sum};
        if (result.text.size() > lengthLimit) return fail();
    }
    --depth_;
    return result;
}

Piece FormulaReader::products() {
    Piece result = signedFactor();
    while (!failed_) {
        const bool times = accept("*");
        const bool over = !times && accept("/");
        if (!times && !over && !beginsFactor()) break;
        ++operations_;
        const Piece right = times || over ? signedFactor() : powers();
        result = {inside(result, product) + (over ? "/" : "*") + second(right, over ? operand : product),
                  product};
        if (result.text.size() > lengthLimit) return fail();
    }
    return result;
}

/// Whether a factor follows without a sign between: `2x`, `(x+1)(x-1)`.
bool FormulaReader::beginsFactor() {
    skipBlank(parentheses_ > 0);
    if (isLetter(current()) || current() == '(' || startsWith("π") || startsWith("√")) return true;
    return current() == '|' && bars_ == 0;
}

Piece FormulaReader::signedFactor() {
    if (++depth_ > depthLimit) return fail();
    skipBlank(true);
    Piece result;
    if (accept("-")) {
        ++operations_;
        const Piece positive = signedFactor();
        result = {"-" + inside(positive, product), sign};
        if (positive.text.starts_with('-') && positive.binding != sum)
            result = {positive.text.substr(1), product};
    } else {
        result = accept("+") ? signedFactor() : powers();
    }
    --depth_;
    return result;
}

Piece FormulaReader::powers() {
    const Piece low = base();
    if (failed_) return low;
    if (const std::string high = superscript(); !high.empty()) {
        ++operations_;
        return power(low, {high, operand, true});
    }
    if (!accept("^")) return low.isEuler ? Piece{"2.718281828459045"} : low;
    ++operations_;
    // A sign may stand in an exponent, and the next power belongs to it.
    return power(low, signedFactor());
}

Piece FormulaReader::power(const Piece& base, const Piece& exponent) {
    if (failed_) return base;
    if (base.isEuler) return {"exp(" + exponent.text + ")"};
    if (exponent.isNumeral && isVariable(base.text) && (exponent.text == "2" || exponent.text == "3"))
        return {base.text + "*" + base.text + (exponent.text == "3" ? "*" + base.text : ""), product};
    if (base.text.size() + exponent.text.size() > lengthLimit) return fail();
    return {"pow(" + base.text + ", " + exponent.text + ")"};
}

std::string FormulaReader::superscript() {
    std::string digits;
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < superscripts.size(); ++i)
            if (startsWith(superscripts[i])) {
                digits += static_cast<char>('0' + i);
                at_ += superscripts[i].size();
                more = true;
            }
    }
    return digits;
}

Piece FormulaReader::base() {
    skipBlank(true);
    if (failed_) return fail();
    if (isDigit(current()) || (current() == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])))
        return number();
    if (isLetter(current())) return word();
    if (startsWith("π")) {
        at_ += std::string_view("π").size();
        return {"pi"};
    }
    if (startsWith("√")) {
        at_ += std::string_view("√").size();
        return {"sqrt(" + powers().text + ")"};
    }
    if (accept("|")) return absolute();
    if (!accept("(")) return fail();
    const int bars = std::exchange(bars_, 0);
    ++parentheses_;
    const Piece inner = sums();
    const bool closed = accept(")");
    --parentheses_;
    bars_ = bars;
    if (!closed) return fail();
    // The parentheses come back where they are needed.
    return inner;
}

Piece FormulaReader::absolute() {
    ++bars_;
    ++operations_;
    const Piece inner = sums();
    const bool closed = accept("|");
    --bars_;
    if (!closed) return fail();
    return {"abs(" + inner.text + ")"};
}

Piece FormulaReader::number() {
    const std::size_t start = at_;
    while (isDigit(current())) ++at_;
    const bool whole = current() != '.';
    if (!whole) ++at_;
    while (isDigit(current())) ++at_;
    // `2e` is twice e, `2e3` is 2000.
    std::size_t exponent = at_ + 1;
    if (current() == 'e' || current() == 'E') {
        if (exponent < text_.size() && (text_[exponent] == '-' || text_[exponent] == '+')) ++exponent;
        if (exponent < text_.size() && isDigit(text_[exponent])) {
            at_ = exponent;
            while (isDigit(current())) ++at_;
        }
    }
    std::string numeral(text_.substr(start, at_ - start));
    if (numeral.ends_with('.')) numeral += '0';
    if (numeral.starts_with('.')) numeral.insert(0, 1, '0');
    return {numeral, operand, whole};
}

Piece FormulaReader::word() {
    const std::size_t start = at_;
    while (isLetter(current()) || isDigit(current())) ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    const auto known = functions().find(name);
    if (known != functions().end()) return call(name, known->second);
    if (isVariable(name)) {
        hasVariable_ = true;
        return {std::string(name)};
    }
    if (name == "pi") return {"pi"};
    if (name == "tau") return {"(2*pi)"};
    if (name == "e" && !isNumber_(name)) return {"e", operand, false, true};
    if (isNumber_(name)) {
        if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.emplace_back(name);
        return {std::string(name)};
    }
    // `xy` is x*y.
    if (name.find_first_not_of("xyz") != std::string_view::npos) return fail();
    at_ = start + 1;
    hasVariable_ = true;
    return {std::string(name.substr(0, 1))};
}

Piece FormulaReader::call(std::string_view name, std::string_view meaning) {
    ++operations_;
    std::array<std::string, 2> arguments;
    const std::size_t wanted = meaning.find('@') == std::string_view::npos ? 1 : 2;
    if (accept("(")) {
        const int bars = std::exchange(bars_, 0);
        ++parentheses_;
        for (std::size_t i = 0; i < wanted && !failed_; ++i) {
            if (i > 0 && !accept(",")) return fail();
            arguments[i] = sums().text;
        }
        const bool closed = accept(")");
        --parentheses_;
        bars_ = bars;
        if (!closed) return fail();
    } else if (wanted == 1 && beginsFactor() && name != "int") {
        arguments[0] = powers().text;  // `sin x`
    } else {
        return fail();
    }
    std::string text;
    for (const char c : meaning) {
        if (c == '#' || c == '@')
            text += arguments[c == '@'];
        else
            text += c;
    }
    if (text.size() > lengthLimit) return fail();
    return {text};
}

}  // namespace

std::optional<BareFormula> readBareFormula(std::string_view text, std::size_t begin,
                                           const std::function<bool(std::string_view)>& isNumber) {
    return FormulaReader(text, begin, isNumber).read();
}

}  // namespace isoscope
