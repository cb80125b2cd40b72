// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/function/graph_builder.h"
#include "core/virtualight/names.h"
#include "core/virtualight/token_reader.h"

namespace isoscope::virtualight {

/// Operations that uses of declared expressions may copy in one text, and products of terms that polynomials
/// may take (ParseContext::functionCopies).
constexpr std::size_t copyLimit = 20'000'000;

/// Expressions: + - * / ^ (power, binds tightest, to the right), signs, parentheses, numbers, names,
/// functions of one or two arguments. After a mistake, which is reported, the result is empty or 0.
/// Every literal becomes a slider, but for an expression that is one literal and nothing else: what that is
/// called only the caller knows.
class FormulaParser {
  public:
    /// The sliders are those of `what` ("radius") in `group` ("Sphere").
    FormulaParser(TokenReader& tokens, const Names& names, std::string group, std::string what)
        : tokens_(tokens), names_(names), group_(std::move(group)), what_(std::move(what)) {}

    /// An expression without variables.
    std::optional<double> parseNumber();
    /// An expression as a function with variableCount arguments. With `keepSliders`, declared numbers and
    /// literals are read from the parameter table, but for exponents and what they are applied to; otherwise
    /// as they are now, and their sliders ask for a new parse.
    std::optional<Function> parseFormula(bool keepSliders);
    /// What the last expression was: the range of its text, and the slider of the declared number or literal
    /// that it is and nothing else.
    const SourceRange& range() const { return range_; }

    /// A number outside the range of doubles is a mistake too: formulas may give infinity, sizes may not.
    static bool usable(double value);

  private:
    Expression sum();
    Expression product();
    Expression signed_();
    Expression power();
    Expression primary();
    Expression literal(const Token& token);
    /// A slider for the literal; its slot in the parameter table, or -1.
    int addSlider(const Token& token, bool withSlot);
    void addWaitingSliders();
    Expression word(const Token& name);
    Expression call(const Token& name);
    Expression declared(const Token& name, const DeclaredThing& thing);
    Expression pointOfIntersection(const Token& name);
    Expression constant(double value) { return {*graph_, graph_->constant(value)}; }
    Expression variable(unsigned index) { return {*graph_, graph_->variable(static_cast<int>(index))}; }
    Expression fail(const char* id, const SourceRange& range, std::string message, std::string hint = {});

    TokenReader& tokens_;
    const Names& names_;
    FunctionGraph* graph_ = nullptr;
    SourceRange range_;
    std::string group_, what_;
    int literals_ = 0;
    std::vector<Token> waiting_;  ///< literals that get a slider unless the expression is one of them alone
    bool keepSliders_ = false;
    bool fixedLiterals_ = false;  ///< literals at hand get no slot
    bool failed_ = false;
};

/// The variables that a function depends on, as bits 1 << Variable.
unsigned variablesOf(const Function& function);
/// The word for the first of these variables, for messages.
std::string nameOfVariable(unsigned bits);
/// The function with variable `chosen[k]` as its argument k.
Function withArguments(const Function& function, std::initializer_list<unsigned> chosen, int argumentCount);

}  // namespace isoscope::virtualight
