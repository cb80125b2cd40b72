// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/shape/shape_report.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/study/view/isosurface_reach.h"

namespace isoscope {

namespace {

/// Thinner walls than so many times accuracy are worth a warning.
constexpr double thinWalls = 10;

std::string number(double value, int digits = 4) {
    char text[40];
    const auto written =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, digits);
    return std::string(std::begin(text), written.ptr);
}

std::string place(const glm::dvec3& p) {
    return '<' + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + '>';
}

/// What is proven stays so in a few digits of `size`: rounded down for `way` -1, up for 1.
std::string outwards(double value, double size, double way) {
    if (!(size > 0) || !std::isfinite(value) || !std::isfinite(size)) return number(value);
    const double unit = std::pow(10, std::floor(std::log10(size)) - 3);
    const double steps = way < 0 ? std::floor(value / unit) : std::ceil(value / unit);
    // Without the sign that rounding leaves of nothing.
    return number(steps * unit + 0.0, 10);
}

std::string corner(const glm::dvec3& p, const glm::dvec3& size, double way) {
    return '<' + outwards(p.x, size.x, way) + ", " + outwards(p.y, size.y, way) + ", " +
           outwards(p.z, size.z, way) + '>';
}

std::string counted(std::int64_t count, const std::string& one) {
    return (count == 0 ? "no" : std::to_string(count)) + ' ' + one + (count == 1 ? "" : "s");
}

std::string contentOf(const SolidCount& solid) {
    if (solid.pieces == 0) return "nothing";
    return counted(solid.pieces, "piece") + " with " + counted(solid.tunnels, "tunnel") + " and " +
           counted(solid.hollows, "hollow");
}

ReportLine piecesLine(const ShapeReport& report) {
    std::string text = contentOf(report.solid) + ", by the signs at the corners of " +
                       std::to_string(report.cells.x) + " by " + std::to_string(report.cells.y) + " by " +
                       std::to_string(report.cells.z) + " cells. ";
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (report.check.complete())
        return {"Pieces",
                text +
                    "Proven, but for what the container's wall cuts: every cell keeps the criterion of "
                    "Plantinga and Vegter.",
                true};
    text += "Not proven: " + std::to_string(report.check.open) + " of " + std::to_string(report.check.cells) +
            " cells may hold more. ";
    text += report.coarse == report.solid
                ? "Half as many cells along each side tell the same."
                : "Half as many cells along each side tell " + contentOf(report.coarse) + ".";
    return {"Pieces", text, false};
}

ReportLine volumeLine(const ShapeReport& report) {
    const VolumeBracket& v = report.volume;
    std::string text =
        "Between " + outwards(v.low, v.high, -1) + " and " + outwards(v.high, v.high, 1) + ": proven";
    if (v.high > 0 && std::isfinite(v.high))
        text += ", " + number(0.5 * (v.low + v.high)) + " to within " +
                number(100 * (v.high - v.low) / (v.high + v.low), 2) + " percent";
    return {"Volume", text + ".", true};
}

ReportLine wallLine(const ShapeReport& report) {
    const ThinnestWall& wall = report.wall;
    if (wall.measured == 0) return {"Thinnest wall", "There is no surface to measure it from.", false};
    std::string text = "At most " + number(wall.thickness) + ", at " + place(wall.place) + ", " +
                       number(wall.thickness / report.accuracy, 3) +
                       " times accuracy; measured inwards from " + std::to_string(wall.measured) +
                       " points of the surface.";
    if (wall.thickness < thinWalls * report.accuracy)
        text += " That is so thin that rays may step over it: make accuracy smaller.";
    return {"Thinnest wall", text, false};
}

ReportLine symmetryLine(const ShapeReport& report) {
    if (report.symmetries.empty())
        return {"Symmetry", "None of the usual ones about the middle of the container.", false};
    std::string text = "About the middle of the container: ";
    double error = 0;
    for (std::size_t i = 0; i < report.symmetries.size(); ++i) {
        text += (i == 0 ? "" : ", ") + report.symmetries[i].name;
        error = std::max(error, report.symmetries[i].error);
    }
    text += error > 0 ? "; values differ by less than " + number(error, 1) + " of their spread"
                      : "; values do not differ";
    return {"Symmetry", text + " at some thousand points.", false};
}

}  // namespace

ShapeReport shapeReport(const std::shared_ptr<const Isosurface>& surface, std::span<const double> parameters,
                        int cells, const std::function<void(double)>& progress, std::stop_token stop) {
    ShapeReport report;
    const auto tell = [&](double done) {
        if (progress) progress(done);
    };
    const SolidGrid grid(*surface, parameters, cells, stop);
    if (!grid.known()) return report;
    tell(0.1);
    const SolidGrid coarse(*surface, parameters, cells / 2, stop);
    report.cells = grid.cells();
    report.solid = grid.count();
    report.coarse = coarse.count();
    // Halves of the cells' width make a quarter of the error.
    const double area = areaOf(grid), coarseArea = areaOf(coarse);
    report.area = area + (area - coarseArea) / 3;
    report.areaError = std::abs(area - coarseArea);
    tell(0.25);
    report.check = checkCells(*surface, parameters, grid, stop);
    tell(0.5);
    report.volume = volumeOf(*surface, parameters, 3'000'000, stop);
    tell(0.7);
    IsosurfaceReach reach(surface, parameters);
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 axis(0);
        axis[k] = 1;
        report.high[k] = reach.along(axis, stop);
        report.low[k] = -reach.along(-axis, stop);
    }
    report.empty = report.low.x > report.high.x;
    tell(0.8);
    report.wall = thinnestWall(*surface, parameters, stop);
    report.accuracy = surface->rootSettings().accuracy;
    report.symmetries = symmetriesOf(*surface, parameters);
    report.known = !stop.stop_requested();
    tell(1);
    return report;
}

std::vector<ReportLine> linesOf(const ShapeReport& report) {
    if (!report.known)
        return {{"Shape", "Nothing is known: the container has no size, or the work ended early.", false}};
    if (report.empty) return {{"Shape", "There is nothing in the container: proven.", true}};
    std::vector<ReportLine> lines{piecesLine(report)};
    const glm::dvec3 size = report.high - report.low;
    lines.push_back({"Extent",
                     "From " + corner(report.low, size, -1) + " to " + corner(report.high, size, 1) + ", " +
                         number(size.x) + " by " + number(size.y) + " by " + number(size.z) +
                         ": nothing lies outside, proven.",
                     true});
    lines.push_back(volumeLine(report));
    lines.push_back({"Area",
                     report.area > 0
                         ? "About " + number(report.area) + ", give or take " + number(report.areaError, 2) +
                               ", without the container's wall; measured by triangles."
                         : "No surface was met in the cells.",
                     false});
    lines.push_back(wallLine(report));
    lines.push_back(symmetryLine(report));
    return lines;
}

}  // namespace isoscope
