// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/exchange/statement_scanner.h"
#include "core/text/source_text.h"

namespace isoscope {

/// A piece of one of the texts of a scene.
struct DeclaringPiece {
    ScenePiece piece;
    std::string text;
};

/// Which pieces of a scene a statement may need.
enum class PieceScope {
    before,      ///< those read before it, in the order of reading
    everywhere,  ///< those of all texts: for a statement in a macro, which is called later
};

/// The outermost pieces of the scene's own texts (file 0, and include files that are neither the program's
/// own nor below one of `libraryPaths`), and those of the conditions, loops and macros that `statement` lies
/// in. An `#include` of an own text is replaced by its pieces.
std::vector<DeclaringPiece> collectPieces(const SourceLibrary& sources, const SourceRange& statement,
                                          PieceScope scope,
                                          const std::vector<std::filesystem::path>& libraryPaths);

/// Those of `pieces` that declare what `wanted` needs, directly or through each other, and every #version and
/// #include. `wanted` grows by the names that they use.
std::vector<DeclaringPiece> neededPieces(const std::vector<DeclaringPiece>& pieces,
                                         std::set<std::string>& wanted);

}  // namespace isoscope
