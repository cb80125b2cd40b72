// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_text.h"

#include <array>
#include <cstdio>

namespace isoscope {

namespace {

std::string rounded(double value) {
    std::array<char, 32> text;
    const int length = std::snprintf(text.data(), text.size(), "%.3g", value);
    std::string result(text.data(), static_cast<std::size_t>(length));
    // Whatever the locale.
    if (const std::size_t comma = result.find(','); comma != std::string::npos) result[comma] = '.';
    return result;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string formText(const MeshForm& form) {
    std::string text =
        counted(form.pieces, "piece", "pieces") + ", Euler characteristic " + std::to_string(form.euler());
    if (form.manifold()) {
        text += ", genus " + std::to_string(form.genus());
        if (form.pieces > 1) text += " in all";
    }
    return text + ".\n";
}

std::string closedText(const MeshReport& report) {
    const MeshForm& form = report.form;
    std::string text = form.watertight() ? "Watertight" : "Not watertight";
    text += form.manifold() ? " and manifold" : ", not manifold";
    if (report.wallTriangles > 0 && !report.open)
        text += "; the container cuts the surface, and its wall closes the mesh";
    else if (form.borderEdges > 0)
        text += "; the isosurface is open: the mesh ends at the container, in " +
                counted(form.borders, "line", "lines");
    else
        text += "; the container cuts nothing off";
    return text + ".\n";
}

std::string distanceText(const MeshReport& report) {
    std::string text = "Distance to the surface: at most " + rounded(report.distance) + " at " +
                       counted(report.samples, "sample", "samples") + " (sampled, not proven); asked for " +
                       rounded(report.tolerance) + ".\n";
    return text;
}

}  // namespace

std::string meshText(const MeshReport& report) {
    std::string text = counted(report.form.triangles, "triangle", "triangles") + ", " +
                       counted(report.form.points, "vertex", "vertices") + ".\n" + formText(report.form) +
                       closedText(report) + distanceText(report);
    if (report.doubtfulCells == 0)
        text += "Proven: no surface lies outside of the boxes with triangles.\n";
    else
        text += "Boxes without triangles that no proof shows to be empty: " +
                std::to_string(report.doubtfulCells) + ", the largest " + rounded(report.widestDoubtful) +
                " wide; all others are proven.\n";
    if (report.limited && !report.keepsTolerance())
        text += "The limit of boxes or of memory was reached before the tolerance was kept.\n";
    return text;
}

}  // namespace isoscope
