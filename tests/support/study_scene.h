// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scene_picture.h"

namespace isoscope::test {

/// A scene around this text, looked at from the front, as a request of 80 x 60 pixels.
inline RenderRequest studyScene(const std::string& text, int width = 80, int height = 60) {
    const ParseResult parsed = parseScene(
        "#version 3.7; #include \"functions.inc\"\nglobal_settings { assumed_gamma 1 }\n"
        "camera { location <0.3,0.7,-4> look_at 0 angle 40 }\nlight_source { <5,5,-5> 1 }\n" +
        text);
    if (!parsed.ok()) qCritical("%s", parsed.diagnostics.front().message.c_str());
    return requestFor(parsed, width, height);
}

}  // namespace isoscope::test
