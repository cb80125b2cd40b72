# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler settings shared by all targets, and the one way a folder becomes a target.

add_library(isoscope_options INTERFACE)
# Contracted multiply-adds would make results differ between instruction sets, and from POV-Ray's.
target_compile_options(isoscope_options INTERFACE -Wall -Wextra -ffp-contract=off)
target_include_directories(isoscope_options INTERFACE ${PROJECT_SOURCE_DIR})
# For targets whose sources have none of these warnings with g++ and clang++: `tools/lint --warnings` asks both. Not
# errors: compilers to come know more of them.
add_library(isoscope_warnings INTERFACE)
target_compile_options(isoscope_warnings INTERFACE -Wpedantic -Wconversion -Wshadow)
if(ISOSCOPE_SANITIZE)
  target_compile_options(isoscope_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -g)
  target_link_options(isoscope_options INTERFACE -fsanitize=address,undefined)
endif()
if(ISOSCOPE_SANITIZE_THREADS)
  target_compile_options(isoscope_options INTERFACE -fsanitize=thread -g)
  target_link_options(isoscope_options INTERFACE -fsanitize=thread)
endif()

# isoscope_core_folder(NAME DEPENDS lib...): the sources of core/NAME become the library isoscope_NAME.
# Sources are globbed with CONFIGURE_DEPENDS, so that a new file needs no edit here. A folder without
# sources yet is header-only.
function(isoscope_core_folder name)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*/*.cpp)
  if(sources)
    add_library(isoscope_${name} STATIC ${sources})
    target_link_libraries(isoscope_${name} PUBLIC isoscope_options ${ARG_DEPENDS} PRIVATE isoscope_warnings)
  else()
    add_library(isoscope_${name} INTERFACE)
    target_link_libraries(isoscope_${name} INTERFACE isoscope_options ${ARG_DEPENDS})
  endif()
endfunction()

# isoscope_gather(TARGET NAME TYPE HEADER FILE...): adds a source to TARGET with the function
# `std::vector<TYPE> NAME()`: the rows of all FILEs. Each has a function of its own name that gives them,
# `std::span<const TYPE> heightFieldParser()` in height_field_parser.cpp. TYPE is declared in HEADER.
function(isoscope_gather target name type header)
  set(declarations "")
  set(calls "")
  foreach(file IN LISTS ARGN)
    get_filename_component(stem ${file} NAME_WE)
    string(REPLACE "_" ";" words ${stem})
    list(POP_FRONT words function)
    foreach(word IN LISTS words)
      string(SUBSTRING ${word} 0 1 first)
      string(SUBSTRING ${word} 1 -1 rest)
      string(TOUPPER ${first} first)
      string(APPEND function ${first}${rest})
    endforeach()
    string(APPEND declarations "std::span<const ${type}> ${function}();\n")
    string(APPEND calls "    for (const ${type}& row : ${function}()) rows.push_back(row);\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"// SPDX-License-Identifier: GPL-3.0-or-later
// Made by isoscope_gather of cmake/Isoscope.cmake.
#include \"${header}\"

#include <span>
#include <vector>

namespace isoscope {

${declarations}
std::vector<${type}> ${name}() {
    std::vector<${type}> rows;
${calls}    return rows;
}

}  // namespace isoscope
")
  target_sources(${target} PRIVATE ${source})
endfunction()

# isoscope_unroll(FILE...): kernels with short loops over coordinates or columns, of numbers that stay in vector
# registers only where the loops are unrolled. -O2 leaves them in memory. Not with sanitizers, whose checks
# are unrolled, too.
function(isoscope_unroll)
  if(NOT ISOSCOPE_SANITIZE AND NOT ISOSCOPE_SANITIZE_THREADS)
    set_source_files_properties(${ARGN} PROPERTIES
      COMPILE_OPTIONS "$<$<CONFIG:Release,RelWithDebInfo>:-O3>" SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# isoscope_copy_by_vectors(FILE...): sources that copy objects of some hundred bytes all the time. g++ makes a string
# instruction of each copy, which takes longer to start than vectors take to be done.
function(isoscope_copy_by_vectors)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS
      -mmemcpy-strategy=vector_loop:4096:noalign,libcall:-1:noalign
      -mmemset-strategy=vector_loop:4096:noalign,libcall:-1:noalign)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# isoscope_precompile(TARGET HEADER...): the headers that most sources of the target begin with are read once for
# all of them, which halves the time of a first build. Sources still name every header they use: the preset
# `debug` builds without.
set(isoscope_common_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <optional> <span> <string> <string_view>
  <variant> <vector> <glm/common.hpp> <glm/geometric.hpp> <glm/vec3.hpp>)
function(isoscope_precompile target)
  if(ISOSCOPE_PRECOMPILE AND TARGET ${target})
    target_precompile_headers(${target} PRIVATE ${isoscope_common_headers} ${ARGN})
  endif()
endfunction()

# isoscope_share_precompiled(TARGET FROM): the sources of TARGET take the headers that FROM has precompiled, with the
# same compiler options but for definitions that they do not look at. Each set of headers costs six seconds to read.
function(isoscope_share_precompiled target from)
  if(ISOSCOPE_PRECOMPILE AND TARGET ${target})
    target_precompile_headers(${target} REUSE_FROM ${from})
  endif()
endfunction()
