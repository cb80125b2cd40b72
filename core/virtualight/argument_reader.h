// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec4.hpp>
#include <string>

#include "core/virtualight/formula_parser.h"

namespace isoscope::virtualight {

/// What the parsers of primitives read with: `Name(argument, argument, ...)`. Numbers are checked and become
/// sliders. A mistake is reported once; what is read after it is neutral, and failed() is true.
class ArgumentReader {
  public:
    /// The name has been read; the bracket is next.
    ArgumentReader(TokenReader& tokens, const Names& names, const Token& name);

    /// A float; `what` is what its slider is called.
    double number(const std::string& what);
    /// A float above 0.
    double positive(const std::string& what);
    /// A whole number from `least` to `most`.
    int count(const std::string& what, int least, int most);
    /// (x, y, z), or the name of a declared point.
    glm::dvec3 point(const std::string& what);
    /// A point that has a length.
    glm::dvec3 direction(const std::string& what);
    /// (x, y, z) or (x, y, z, w); w is 1 where it is missing.
    glm::dvec4 weighted(const std::string& what);
    /// A string.
    std::string text(const std::string& what);
    /// An expression that may use the variables of `allowed` (bits 1 << Variable); an empty function after a
    /// mistake.
    Function formula(unsigned allowed, bool keepSliders);
    /// Whether `, word` comes next; it is taken.
    bool flag(const char* word);
    /// Whether the symbol comes next; it is taken.
    bool accept(const char* symbol) { return !failed_ && tokens_.accept(symbol); }
    /// The symbol must come next; `purpose` completes the message ("to close the list").
    void expect(const char* symbol, const std::string& purpose);
    /// Whether a further argument comes: takes the comma in front of it.
    bool more() { return accept(","); }
    /// The bracket behind the last argument. After a mistake the rest is skipped.
    void close();

    /// Reports an error or a warning, the latter at range(); after a mistake nothing is reported any more.
    void fail(const SourceRange& range, const std::string& message, const std::string& hint = {});
    void warn(const std::string& message, const std::string& hint = {});
    /// Whether any argument so far was wrong: what has been read is not to be used.
    bool failed() const { return failed_; }
    /// Failed for a reason that has been reported elsewhere.
    void giveUp() { failed_ = true; }

    /// No comma is expected in front of the next argument.
    void begin() { first_ = true; }

    /// The word that begins the primitive, for messages and for the group of its sliders.
    const Token& name() const { return name_; }
    /// Range of the argument read last; of the name before any.
    const SourceRange& range() const { return range_; }
    TokenReader& tokens() { return tokens_; }
    const Names& names() const { return names_; }

  private:
    void separate();
    double coordinate(const std::string& what);
    /// A float that has no slider yet when it is a literal; nothing after a mistake.
    std::optional<double> unmoved(const std::string& what);
    glm::dvec4 tuple(const std::string& what, bool mayHaveWeight);

    TokenReader& tokens_;
    const Names& names_;
    Token name_;
    SourceRange range_;
    std::size_t depth_;  ///< of brackets around the whole
    bool first_ = true;
    bool failed_ = false;
};

}  // namespace isoscope::virtualight
