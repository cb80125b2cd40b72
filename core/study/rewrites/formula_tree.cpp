// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rewrites/formula_tree.h"

#include <array>
#include <cmath>
#include <cstdlib>

#include "core/function/builtins/builtin.h"
#include "core/language/tokens/lexer.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

using Kind = FormulaPart::Kind;
constexpr int mostParts = 2000, deepest = 200;
/// Exponents up to this one POV-Ray multiplies out.
constexpr double largestProduct = 8;

/// By precedence, from the loosest; all group to the left (docs/povray/operators.md).
constexpr std::array<std::string_view, 5> operatorsOf{"|", "&", "= != < <= > >=", "+ -", "* /"};

bool isOneOf(const Token& token, std::string_view list) {
    if (token.kind != TokenKind::symbol) return false;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(' ', at), list.size());
        if (token.text == list.substr(at, end - at)) return true;
        at = end + 1;
    }
    return false;
}

class Reader {
  public:
    Reader(std::string_view text, const SourceRange& range)
        : lexer_(text, range.file, range.begin, range.end) {
        advance();
    }

    FormulaPointer read() {
        FormulaPointer all = level(0);
        return failed_ || lookahead_.kind != TokenKind::end ? nullptr : all;
    }

  private:
    void advance() {
        lastEnd_ = lookahead_.range.end;
        lookahead_ = lexer_.next();
        if (lexer_.takeMistake()) failed_ = true;
    }

    FormulaPointer fail() {
        failed_ = true;
        return nullptr;
    }

    FormulaPointer make(FormulaPart part) {
        if (++count_ > mostParts) return fail();
        return std::make_shared<const FormulaPart>(std::move(part));
    }

    FormulaPointer level(std::size_t rank) {
        if (rank == operatorsOf.size()) return sign();
        FormulaPointer left = level(rank + 1);
        while (!failed_ && isOneOf(lookahead_, operatorsOf[rank])) {
            FormulaPart part{Kind::binary, std::string(lookahead_.text), left->range, {}, {left}};
            advance();
            const FormulaPointer right = level(rank + 1);
            if (failed_) return nullptr;
            part.parts.push_back(right);
            part.range.end = right->range.end;
            part.inner = part.range;
            left = make(std::move(part));
        }
        return left;
    }

    FormulaPointer sign() {
        if (!isOneOf(lookahead_, "+ -")) return primary();
        FormulaPart part{Kind::sign, std::string(lookahead_.text), lookahead_.range, {}, {}};
        advance();
        const FormulaPointer operand = primary();
        if (failed_) return nullptr;
        part.parts.push_back(operand);
        part.range.end = operand->range.end;
        part.inner = part.range;
        return make(std::move(part));
    }

    FormulaPointer primary() {
        const Token token = lookahead_;
        if (failed_ || depth_ > deepest) return fail();
        if (token.kind == TokenKind::number) {
            advance();
            return make({Kind::number, std::string(token.text), token.range, token.range, {}});
        }
        if (token.is("(")) return group();
        if (token.kind != TokenKind::word) return fail();
        advance();
        FormulaPart part{Kind::name, std::string(token.text), token.range, token.range, {}};
        if (lookahead_.is("(")) {
            part.kind = Kind::call;
            if (!arguments(part)) return fail();
        } else if (lookahead_.is(".")) {
            advance();
            if (lookahead_.kind != TokenKind::word) return fail();
            part.head += "." + std::string(lookahead_.text);
            advance();
        } else if (lookahead_.is("[") || lookahead_.is("{")) {
            return fail();
        }
        part.range.end = lastEnd_;
        part.inner = part.range;
        return make(std::move(part));
    }

    bool arguments(FormulaPart& part) {
        ++depth_;
        do {
            advance();
            const FormulaPointer argument = level(0);
            if (failed_) return false;
            part.parts.push_back(argument);
        } while (lookahead_.is(","));
        --depth_;
        if (!lookahead_.is(")")) return false;
        advance();
        return true;
    }

    FormulaPointer group() {
        const std::uint32_t begin = lookahead_.range.begin;
        ++depth_;
        advance();
        const FormulaPointer content = level(0);
        --depth_;
        if (failed_ || !lookahead_.is(")")) return fail();
        advance();
        FormulaPart part = *content;
        part.range = {content->range.file, begin, lastEnd_};
        return make(std::move(part));
    }

    Lexer lexer_;
    Token lookahead_;
    std::uint32_t lastEnd_ = 0;
    int count_ = 0, depth_ = 0;
    bool failed_ = false;
};

double timeOfCall(const FormulaPart& part) {
    if (part.head == "pow" && part.parts.size() == 2) {
        const FormulaPart& exponent = *part.parts[1];
        const double value = std::strtod(exponent.head.c_str(), nullptr);
        const bool multiplied = exponent.kind == Kind::number && value >= 2 && value <= largestProduct &&
                                value == std::floor(value);
        return multiplied ? 28 : 50;
    }
    if (part.head == "atan2" || part.head == "mod") return 28;
    constexpr std::array quick{"abs", "sqrt", "floor", "ceil", "int", "min", "max", "select"};
    for (const std::string_view name : quick)
        if (part.head == name) return 8.3;
    if (findBuiltin(part.head)) return 30;
    return isReservedWord(part.head) ? 12 : 41;
}

}  // namespace

FormulaPointer readFormula(std::string_view text, const SourceRange& range) {
    return Reader(text, range).read();
}

std::string canonicalText(const FormulaPart& part) {
    std::string text;
    switch (part.kind) {
        case Kind::number:
        case Kind::name: return part.head;
        case Kind::sign: return "(" + part.head + canonicalText(*part.parts[0]) + ")";
        case Kind::binary:
            return "(" + canonicalText(*part.parts[0]) + part.head + canonicalText(*part.parts[1]) + ")";
        case Kind::call: break;
    }
    for (const FormulaPointer& argument : part.parts)
        text += (text.empty() ? "" : ",") + canonicalText(*argument);
    return part.head + "(" + text + ")";
}

double interpreterTime(const FormulaPart& part) {
    double time = 0;
    for (const FormulaPointer& one : part.parts) time += interpreterTime(*one);
    if (part.kind == Kind::call) return time + timeOfCall(part);
    if (part.kind == Kind::sign) return time + 1.3;
    if (part.kind != Kind::binary) return time;
    if (part.head == "/") return time + 8.3;
    if (part.head != "*") return time + 1.3;
    const bool compound = part.parts[0]->kind == Kind::binary && part.parts[1]->kind == Kind::binary &&
                          !(part.parts[0]->isBinary("*") && part.parts[0]->range == part.parts[0]->inner);
    return time + (compound ? 105 : 15.7);
}

}  // namespace isoscope
