// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/isosurface_export.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <utility>

#include "core/evaluate/reference_evaluator.h"
#include "core/exchange/needed_pieces.h"
#include "core/language/parse_context.h"
#include "core/text/number_format.h"
#include "core/text/text_change.h"

namespace isoscope {

namespace {

void appendLine(std::string& text, const std::string& line) {
    text += line;
    if (text.back() != '\n') text += '\n';
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

/// How the language writes the value; nothing for values that have no short form.
std::optional<std::string> literal(const Value& value) {
    if (const auto* number = std::get_if<NumberValue>(&value.data))
        return std::isfinite(number->value) ? std::optional(shortestNumber(number->value)) : std::nullopt;
    if (const auto* text = std::get_if<std::string>(&value.data)) return quoted(*text);
    const auto* vector = std::get_if<VectorValue>(&value.data);
    if (!vector) return std::nullopt;
    std::string result = vector->color ? "rgbft <" : "<";
    for (int k = 0; k < vector->count; ++k) {
        const double component = vector->components[static_cast<std::size_t>(k)];
        if (!std::isfinite(component)) return std::nullopt;
        result += (k ? ", " : "") + shortestNumber(component);
    }
    return result + ">";
}

bool sameContainer(const Container& a, const Container& b) {
    if (a.index() != b.index()) return false;
    if (const auto* box = std::get_if<ContainerBox>(&a))
        return box->low == std::get<ContainerBox>(b).low && box->high == std::get<ContainerBox>(b).high;
    const auto& sphere = std::get<ContainerSphere>(a);
    return sphere.center == std::get<ContainerSphere>(b).center &&
           sphere.radius == std::get<ContainerSphere>(b).radius;
}

bool sameSettings(const IsosurfaceSettings& a, const IsosurfaceSettings& b) {
    return sameContainer(a.container, b.container) && a.threshold == b.threshold &&
           a.accuracy == b.accuracy && a.maxGradient == b.maxGradient && a.open == b.open &&
           a.maxTrace == b.maxTrace && a.positivePolarity == b.positivePolarity && a.evaluate == b.evaluate;
}

/// Whether both functions have the same values at points spread over the container.
bool sameFunction(const Isosurface& a, const std::vector<double>& parametersOfA, const Isosurface& b,
                  const std::vector<double>& parametersOfB) {
    constexpr int pointCount = 60;
    constexpr double tolerance = 1e-9;
    ReferenceEvaluator first(a.settings().function);
    ReferenceEvaluator second(b.settings().function);
    std::mt19937 random(1);
    const Bounds bounds = a.bounds();
    const auto between = [&](double low, double high) {
        const double share = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
        return low + share * (high - low);
    };
    for (int i = 0; i < pointCount; ++i) {
        const std::array<double, 3> point{between(bounds.low.x, bounds.high.x),
                                          between(bounds.low.y, bounds.high.y),
                                          between(bounds.low.z, bounds.high.z)};
        const double u = first.evaluate(point, parametersOfA);
        const double v = second.evaluate(point, parametersOfB);
        const bool same =
            u == v || std::abs(u - v) <= tolerance * std::abs(u) || (std::isnan(u) && std::isnan(v));
        if (!same) return false;
    }
    return true;
}

/// Puts one isosurface together.
class IsosurfaceWriter {
  public:
    IsosurfaceWriter(const ParseResult& parsed, const SceneIsosurface& isosurface)
        : parsed_(parsed),
          options_(parsed.options),
          isosurface_(isosurface),
          statement_(parsed.sources->slice(isosurface.range)) {
        ParseOptions asking = options_;
        asking.namesOfIsosurface = isosurface.number;
        names_ = parseScene(std::string((*parsed.sources)[0].text()), std::move(asking)).namesAtIsosurface;
        // What the block needs it must say itself.
        options_.declarations.clear();
        options_.noiseGenerator = parsed.scene->settings.noiseGenerator;
    }

    /// The block with the pieces of this scope, if that makes the same isosurface.
    std::optional<std::string> write(PieceScope scope) {
        constexpr int rounds = 4;
        const std::vector<DeclaringPiece> all =
            collectPieces(*parsed_.sources, isosurface_.range, scope, options_.libraryPaths);
        early_.clear();
        late_.clear();
        for (int round = 0; round < rounds; ++round) {
            std::set<std::string> wanted = identifiersIn(statement_);
            const std::string text = join(neededPieces(without(all), wanted));
            const ParseResult trial = parseScene(text, options_);
            if (correctValues(trial, wanted)) continue;
            return isSame(trial) ? std::optional(text) : std::nullopt;
        }
        return std::nullopt;
    }

  private:
    /// The pieces without those that do nothing but declare a name whose value is written instead.
    std::vector<DeclaringPiece> without(const std::vector<DeclaringPiece>& pieces) const {
        std::vector<DeclaringPiece> result;
        for (const DeclaringPiece& piece : pieces) {
            const ScenePiece& it = piece.piece;
            const bool plain = it.directive == "declare" || it.directive == "local";
            if (!plain || it.declared.size() != 1 || !early_.contains(*it.declared.begin()))
                result.push_back(piece);
        }
        return result;
    }

    std::string join(const std::vector<DeclaringPiece>& pieces) const {
        std::string text;
        bool headDone = false;
        const auto endHead = [&] {
            if (std::exchange(headDone, true)) return;
            for (const auto& [name, value] : early_) appendLine(text, "#local " + name + " = " + value + ";");
        };
        for (const DeclaringPiece& piece : pieces) {
            if (piece.piece.directive != "version" && piece.piece.directive != "include") endHead();
            appendLine(text, piece.text);
        }
        endHead();
        for (const auto& [name, value] : late_) appendLine(text, "#local " + name + " = " + value + ";");
        appendLine(text, statement_);
        return text;
    }

    /// Notes the names whose values in `trial` are not those of the isosurface; false when there is none.
    bool correctValues(const ParseResult& trial, const std::set<std::string>& wanted) {
        bool changed = false;
        for (const std::string& name : wanted) {
            const auto known = names_.find(name);
            const std::optional<std::string> value =
                known == names_.end() ? std::nullopt : literal(known->second);
            if (!value) continue;
            const Value* there = trial.symbols->find(name);
            if (there && literal(*there) == value) continue;
            // A piece that is needed for other names may set it again.
            changed |= early_.emplace(name, *value).second || late_.emplace(name, *value).second;
        }
        return changed;
    }

    bool isSame(const ParseResult& trial) const {
        if (!trial.ok() || trial.scene->isosurfaces.empty()) return false;
        const Isosurface& wanted = *isosurface_.shape;
        const Isosurface& made = *trial.scene->isosurfaces.back().shape;
        return sameSettings(wanted.settings(), made.settings()) &&
               sameFunction(wanted, *parsed_.scene->parameterTable, made, *trial.scene->parameterTable);
    }

    const ParseResult& parsed_;
    ParseOptions options_;
    const SceneIsosurface& isosurface_;
    std::string statement_;
    std::map<std::string, Value> names_;  ///< in force at the statement
    std::map<std::string, std::string> early_, late_;
};

}  // namespace

IsosurfaceExport exportIsosurface(const ParseResult& parsed, std::size_t index) {
    if (!parsed.scene || !parsed.sources || index >= parsed.scene->isosurfaces.size())
        return {{}, "The scene has no such isosurface."};
    if (parsed.notation != Notation::povray)
        return {{}, "An isosurface of a VirtuaLight text is written with its whole scene only."};
    const SceneIsosurface& isosurface = parsed.scene->isosurfaces[index];
    IsosurfaceWriter writer(parsed, isosurface);
    for (const PieceScope scope : {PieceScope::before, PieceScope::everywhere})
        if (const std::optional<std::string> text = writer.write(scope)) return {*text, {}};
    const SourceText& source = (*parsed.sources)[isosurface.range.file];
    return {{},
            "The isosurface in line " + std::to_string(source.position(isosurface.range.begin).line) +
                " of " + source.name() +
                " cannot be written on its own: what it needs is declared differently each time the text is "
                "read there."};
}

std::string withNote(const std::string& text, const std::string& note, const ParseResult& parsed) {
    if (note.empty()) return text;
    const ParseResult alone = parseScene(text, withoutStop(parsed.options));
    if (alone.scene->isosurfaces.empty()) return text;
    const SourceRange& statement = alone.scene->isosurfaces.front().range;
    if (statement.file != 0) return text;
    return changedText(text, {{{0, statement.begin, statement.begin}, note}});
}

}  // namespace isoscope
