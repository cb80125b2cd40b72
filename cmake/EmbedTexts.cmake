# SPDX-License-Identifier: GPL-3.0-or-later
# Run as a script: writes OUTPUT, a C++ file with the text of each of FILES under its name.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"isoscope(${text})isoscope\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"// SPDX-License-Identifier: GPL-3.0-or-later
// Made from resources/include by cmake/EmbedTexts.cmake.
#include \"core/language/directives/native_includes.h\"

namespace isoscope {

const std::vector<NativeInclude>& nativeIncludes() {
    static const std::vector<NativeInclude> table{
${entries}    };
    return table;
}

}  // namespace isoscope
")
