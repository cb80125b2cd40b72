// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/function/builtins/builtin.h"
#include "core/language/parse_context.h"

namespace isoscope {

/// Finds the numbers of the user's own text (file 0) that a slider can move, and enters them in
/// ParseContext::parameters. A literal that is read several times, in a loop or a macro, is one slider: all
/// its readings share it, because all of them are that piece of text. Whatever lies in another file is left
/// alone.
class ParameterCollector {
  public:
    explicit ParameterCollector(ParseContext& context) : context_(context) {}

    /// A literal as parameter number `index` of a built-in. The slot that holds its value while sliders move,
    /// or -1 where the value must be a constant of the graph.
    int addArgument(const Builtin& builtin, int index, double value, const SourceRange& range);
    /// Any other expression in that place.
    void addArgumentExpression(const Builtin& builtin, int index, const SourceRange& range);

    /// The number behind `threshold`, `accuracy` or `max_gradient`: a literal where the text of the range is
    /// one, else an expression with its value.
    void addSetting(ParameterRole role, const std::string& name, double value, const SourceRange& range);
    /// A setting that an isosurface leaves out: its default, and the place where it could stand.
    void addImpliedSetting(ParameterRole role, const std::string& name, double value,
                           const SourceRange& place);
    /// The numbers of a vector or float of a container, where they are literals. `name` is what they belong
    /// to: "center", "first corner".
    void addContainerNumbers(const std::string& name, const SourceRange& range);
    /// The same for a number or vector of a shape; `shape` is its keyword.
    void addShapeNumbers(const std::string& shape, const std::string& name, const SourceRange& range);
    /// The same for a whole number from `least` to `most`.
    void addShapeCount(const std::string& shape, const std::string& name, int least, int most,
                       const SourceRange& range);

  private:
    static SceneParameter setting(ParameterRole role, const std::string& name, double value,
                                  const SourceRange& range);
    struct Added {
        SceneParameter& parameter;
        bool isNew;  ///< false: the place has been read before, and this is its parameter
    };
    Added add(SceneParameter parameter);
    /// What the literals of one vector or float have in common.
    struct Label {
        ParameterRole role;
        std::string group;
        std::string name;
    };
    void addLiteral(const Label& label, const std::string& name, const SourceRange& range);
    void addLiterals(const Label& label, const SourceRange& range);
    bool fromUser(const SourceRange& range) const { return range.file == 0 && range.begin < range.end; }

    ParseContext& context_;
};

/// The value of a text that is one number literal with at most one sign, blanks allowed; else nothing.
std::optional<double> literalValue(std::string_view text);

}  // namespace isoscope
