// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/needed_pieces.h"

#include <algorithm>
#include <optional>

#include "core/language/directives/include_library.h"

namespace isoscope {

namespace {

bool isBlock(const ScenePiece& piece) {
    static const std::set<std::string> words{"if", "ifdef", "ifndef", "while", "for", "switch", "macro"};
    return words.contains(piece.directive);
}

/// The outermost pieces but for those that hold `hole`, of which their own pieces stand here.
std::vector<ScenePiece> piecesAround(std::string_view text, const SourceRange& hole) {
    std::vector<ScenePiece> result;
    std::size_t base = 0;
    std::size_t end = text.size();
    for (bool deeper = true; deeper;) {
        deeper = false;
        std::size_t inside = base;
        std::size_t insideEnd = end;
        for (ScenePiece& piece : scanPieces(text.substr(base, end - base))) {
            piece.begin += base;
            piece.end += base;
            if (piece.end <= hole.begin || piece.begin >= hole.end) {
                result.push_back(std::move(piece));
            } else if (piece.begin < hole.begin && isBlock(piece)) {
                inside = text.find(piece.directive, piece.begin) + piece.directive.size();
                insideEnd = piece.end;
                deeper = true;
            }
        }
        base = inside;
        end = insideEnd;
    }
    std::sort(result.begin(), result.end(),
              [](const ScenePiece& a, const ScenePiece& b) { return a.begin < b.begin; });
    return result;
}

/// Walks through the texts in the order in which they were read.
class PieceCollector {
  public:
    PieceCollector(const SourceLibrary& sources, const SourceRange& statement,
                   const std::vector<std::filesystem::path>& libraryPaths)
        : sources_(sources), statement_(statement), libraryPaths_(libraryPaths) {}

    /// False once the statement was reached and nothing behind it is wanted.
    bool collect(std::uint32_t file, PieceScope scope) {
        if (!visited_.insert(file).second) return true;
        const std::string_view text = sources_[file].text();
        const SourceRange nowhere{file, static_cast<std::uint32_t>(text.size()),
                                  static_cast<std::uint32_t>(text.size())};
        const bool here = statement_.file == file;
        for (ScenePiece& piece : piecesAround(text, here ? statement_ : nowhere)) {
            if (here && scope == PieceScope::before && piece.begin >= statement_.end) continue;
            std::string content(text.substr(piece.begin, piece.end - piece.begin));
            const std::optional<std::uint32_t> included = ownInclude(piece, content);
            if (!included)
                pieces.push_back({std::move(piece), std::move(content)});
            else if (!collect(*included, scope))
                return false;
        }
        return !(here && scope == PieceScope::before);
    }

    std::vector<DeclaringPiece> pieces;

  private:
    /// The text that an #include piece names, if it is the user's own.
    std::optional<std::uint32_t> ownInclude(const ScenePiece& piece, const std::string& content) const {
        if (piece.directive != "include") return std::nullopt;
        const std::size_t open = content.find('"');
        const std::size_t close = content.find('"', open + 1);
        if (open == std::string::npos || close == std::string::npos) return std::nullopt;
        std::string name = content.substr(open + 1, close - open - 1);
        std::replace(name.begin(), name.end(), '\\', '/');
        if (IncludeLibrary::isNative(name)) return std::nullopt;
        for (std::uint32_t file = 1; file < sources_.size(); ++file) {
            const std::string& path = sources_[file].name();
            if ((path == name || path.ends_with("/" + name)) && !isInLibrary(path)) return file;
        }
        return std::nullopt;
    }

    bool isInLibrary(const std::string& path) const {
        return std::any_of(libraryPaths_.begin(), libraryPaths_.end(),
                           [&](const std::filesystem::path& folder) {
                               return !folder.empty() && path.starts_with((folder / "").string());
                           });
    }

    const SourceLibrary& sources_;
    const SourceRange& statement_;
    const std::vector<std::filesystem::path>& libraryPaths_;
    std::set<std::uint32_t> visited_;
};

}  // namespace

std::vector<DeclaringPiece> collectPieces(const SourceLibrary& sources, const SourceRange& statement,
                                          PieceScope scope,
                                          const std::vector<std::filesystem::path>& libraryPaths) {
    PieceCollector collector(sources, statement, libraryPaths);
    if (sources.size() > 0) collector.collect(0, scope);
    return std::move(collector.pieces);
}

std::vector<DeclaringPiece> neededPieces(const std::vector<DeclaringPiece>& pieces,
                                         std::set<std::string>& wanted) {
    std::set<const DeclaringPiece*> needed;
    const auto declaresWanted = [&](const DeclaringPiece& piece) {
        return std::any_of(piece.piece.declared.begin(), piece.piece.declared.end(),
                           [&](const std::string& name) { return wanted.contains(name); });
    };
    for (bool grown = true; grown;) {
        grown = false;
        for (const DeclaringPiece& piece : pieces) {
            if (needed.contains(&piece) || !declaresWanted(piece)) continue;
            needed.insert(&piece);
            wanted.insert(piece.piece.used.begin(), piece.piece.used.end());
            grown = true;
        }
    }
    std::vector<DeclaringPiece> result;
    for (const DeclaringPiece& piece : pieces) {
        const bool always = piece.piece.directive == "version" || piece.piece.directive == "include";
        if (always || needed.contains(&piece)) result.push_back(piece);
    }
    return result;
}

}  // namespace isoscope
