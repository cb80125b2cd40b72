// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/map_position.h"

#include "core/language/expressions/expression_parser.h"
#include "core/language/textures/color_start.h"
#include "core/language/tokens/povray_refusals.h"

namespace isoscope {

double parseMapPosition(TokenStream& tokens, bool isAverage) {
    ExpressionParser expressions(tokens);
    double position = 1;
    const bool isColor = atColor(tokens);
    if (expressions.atExpression() && !isColor)
        position = expressions.parseFloat();
    else if (!isAverage || isColor)
        warnOfRefusal(tokens.context(), tokens.peek().range,
                      "wants a position in front of an entry of a map.", "write a number from 0 to 1");
    tokens.accept(",");
    return position;
}

}  // namespace isoscope
