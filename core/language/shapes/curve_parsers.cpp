// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes made of plane curves: `lathe`, `prism`, `sor`.
#include <algorithm>
#include <array>

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/shapes/solids/lathe.h"
#include "core/shapes/solids/prism.h"
#include "core/shapes/solids/sphere_sweep.h"
#include "core/shapes/solids/surface_of_revolution.h"

namespace isoscope {

namespace {

constexpr int pointLimit = 100'000;

bool parseSplineKind(ShapeReader& reader, SplineKind& kind) {
    TokenStream& tokens = reader.tokens();
    if (tokens.accept("linear_spline"))
        kind = SplineKind::linear;
    else if (tokens.accept("quadratic_spline"))
        kind = SplineKind::quadratic;
    else if (tokens.accept("cubic_spline"))
        kind = SplineKind::cubic;
    else if (tokens.accept("bezier_spline"))
        kind = SplineKind::bezier;
    else
        return false;
    return true;
}

std::vector<glm::dvec2> parsePoints(ShapeReader& reader, int least) {
    const int count = reader.count("number of points", least, pointLimit);
    std::vector<glm::dvec2> points;
    while (static_cast<int>(points.size()) < count && ExpressionParser(reader.tokens()).atExpression())
        points.push_back(reader.pair("point " + std::to_string(points.size() + 1)));
    if (!reader.failed() && static_cast<int>(points.size()) < count)
        reader.fail(rangeSince(reader.keywordRange(), reader.tokens()),
                    "This `" + reader.keyword() + "` announces " + std::to_string(count) +
                        " points, but has " + std::to_string(points.size()) + ".");
    return points;
}

void requireFours(ShapeReader& reader, SplineKind kind, const std::vector<glm::dvec2>& points) {
    if (kind == SplineKind::bezier && points.size() % 4 != 0)
        reader.fail(rangeSince(reader.keywordRange(), reader.tokens()),
                    "The number of points of a `bezier_spline` must be a multiple of 4.");
}

/// The parts of a prism's outline, one after another.
class SubPrisms {
  public:
    SubPrisms(SplineKind kind, std::span<const glm::dvec2> points) : kind_(kind), points_(points) {
        while (next_ < points_.size()) addNext();
    }

    std::vector<CurvePiece> pieces;
    bool closed = true;  ///< whether all parts end where they begin

  private:
    void addNext() {
        // Control points in front of the start and behind the end.
        const std::size_t before = kind_ == SplineKind::quadratic || kind_ == SplineKind::cubic ? 1 : 0;
        const std::size_t behind = kind_ == SplineKind::cubic ? 1 : 0;
        const std::size_t step = kind_ == SplineKind::bezier ? 4 : 1;
        const std::size_t start = next_ + before;
        std::size_t end = start + (kind_ == SplineKind::bezier ? 3 : 1);
        while (end < points_.size() && points_[end] != points_[start]) end += step;
        const bool found = end < points_.size();
        const std::size_t past = std::min(found ? end + behind + 1 : points_.size(), points_.size());
        std::vector<glm::dvec2> part(points_.begin() + static_cast<std::ptrdiff_t>(next_),
                                     points_.begin() + static_cast<std::ptrdiff_t>(past));
        if (!found) {
            closed = false;
            if (kind_ == SplineKind::linear) part.push_back(part.front());
        }
        // POV-Ray's normals lie on the other side of these.
        if (kind_ == SplineKind::bezier)
            for (std::size_t i = 0; i + 3 < part.size(); i += 4)
                std::reverse(part.begin() + static_cast<std::ptrdiff_t>(i),
                             part.begin() + static_cast<std::ptrdiff_t>(i + 4));
        const std::vector<CurvePiece> own = curveThrough(kind_, part);
        pieces.insert(pieces.end(), own.begin(), own.end());
        next_ = past;
    }

    SplineKind kind_;
    std::span<const glm::dvec2> points_;
    std::size_t next_ = 0;
};

ShapePointer parseLathe(ShapeReader& reader) {
    SplineKind kind = SplineKind::linear;
    parseSplineKind(reader, kind);
    const std::vector<glm::dvec2> points = parsePoints(reader, leastPoints(kind));
    requireFours(reader, kind, points);
    bool sturm = false;
    reader.flag("sturm", sturm);
    if (reader.failed() || !reader.finite()) return nullptr;
    return std::make_shared<Lathe>(curveThrough(kind, points));
}

ShapePointer parseSurfaceOfRevolution(ShapeReader& reader) {
    const std::vector<glm::dvec2> points = parsePoints(reader, 4);
    const SourceRange range = rangeSince(reader.keywordRange(), reader.tokens());
    bool open = false, sturm = false;
    while (reader.flag("open", open) || reader.flag("sturm", sturm)) continue;
    if (!reader.failed() && !SurfaceOfRevolution::usable(points))
        reader.fail(range,
                    "The heights of the points of a `sor` must rise from the second to the last but one, and "
                    "the first and last must lie on other heights than their neighbours' neighbours.");
    if (reader.failed() || !reader.finite()) return nullptr;
    return std::make_shared<SurfaceOfRevolution>(points, open);
}

ShapePointer parsePrism(ShapeReader& reader) {
    SplineKind kind = SplineKind::linear;
    bool conic = false;
    for (;;) {
        if (parseSplineKind(reader, kind)) continue;
        if (reader.tokens().accept("conic_sweep"))
            conic = true;
        else if (reader.tokens().accept("linear_sweep"))
            conic = false;
        else
            break;
    }
    const double height1 = reader.number("height 1");
    const double height2 = reader.number("height 2");
    const std::vector<glm::dvec2> points = parsePoints(reader, leastPoints(kind));
    requireFours(reader, kind, points);
    const SourceRange range = rangeSince(reader.keywordRange(), reader.tokens());
    bool open = false, sturm = false;
    while (reader.flag("open", open) || reader.flag("sturm", sturm)) continue;
    if (reader.failed() || !reader.finite()) return nullptr;
    SubPrisms parts(kind, points);
    if (!parts.closed && kind == SplineKind::linear)
        reader.warn(range, "The outline of this prism does not end where it begins; a line closes it.");
    else if (!parts.closed)
        reader.fail(range, "The outline of this prism does not end where it begins.",
                    "repeat the first point of the curve at its end");
    if (reader.failed() || parts.pieces.empty()) return nullptr;
    return std::make_shared<Prism>(std::move(parts.pieces), height1, height2, PrismStyle{conic, open});
}

ShapePointer parseSphereSweep(ShapeReader& reader) {
    TokenStream& tokens = reader.tokens();
    SweepKind kind = SweepKind::linear;
    if (tokens.accept("b_spline"))
        kind = SweepKind::bSpline;
    else if (tokens.accept("cubic_spline"))
        kind = SweepKind::catmullRom;
    else if (!tokens.accept("linear_spline"))
        reader.fail(
            tokens.peek().range,
            "Expected the kind of spline of this `sphere_sweep`, but found " + describe(tokens.peek()) + ".",
            "write `linear_spline`, `b_spline` or `cubic_spline`");
    const int count = reader.count("number of spheres", SphereSweep::leastSpheres(kind), pointLimit);
    std::vector<glm::dvec4> spheres;
    while (static_cast<int>(spheres.size()) < count && ExpressionParser(tokens).atExpression()) {
        const std::string number = std::to_string(spheres.size() + 1);
        const glm::dvec3 center = reader.vector("center " + number);
        spheres.emplace_back(center, reader.number(number + ". radius"));
    }
    if (!reader.failed() && static_cast<int>(spheres.size()) < count)
        reader.fail(rangeSince(reader.keywordRange(), tokens),
                    "This `sphere_sweep` announces " + std::to_string(count) + " spheres, but has " +
                        std::to_string(spheres.size()) + ".");
    if (tokens.accept("tolerance")) reader.number("tolerance");
    if (reader.failed() || !reader.finite()) return nullptr;
    return std::make_shared<SphereSweep>(kind, spheres);
}

}  // namespace

std::span<const ShapeParser> curveParsers() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "lathe",
                    .parse = parseLathe,
                    .words = "linear_spline quadratic_spline cubic_spline bezier_spline"},
        ShapeParser{.keyword = "prism",
                    .parse = parsePrism,
                    .words = "linear_spline quadratic_spline cubic_spline bezier_spline "
                             "linear_sweep conic_sweep open"},
        ShapeParser{.keyword = "sor", .parse = parseSurfaceOfRevolution, .words = "open"},
        ShapeParser{.keyword = "sphere_sweep",
                    .parse = parseSphereSweep,
                    .words = "linear_spline cubic_spline b_spline tolerance"},
    };
    return parsers;
}

}  // namespace isoscope
