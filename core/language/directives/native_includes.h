// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace isoscope {

/// One of the program's own include files.
struct NativeInclude {
    std::string_view name;  ///< "colors.inc"
    std::string_view text;
};

/// All files of resources/include, compiled in; the table is made by the build.
const std::vector<NativeInclude>& nativeIncludes();

}  // namespace isoscope
